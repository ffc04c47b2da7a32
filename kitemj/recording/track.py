"""Motions out of columns, at any moment between two ticks: what pictures are made of."""

from collections.abc import Sequence
from math import floor, isfinite, radians

import numpy as np
from numpy.typing import NDArray

from kitemj.dynamics.motion import Body, LineState, Motion
from kitemj.physics.frames import Angles
from kitemj.physics.loads import Air
from kitemj.physics.parameters import Parameters
from kitemj.physics.rig import rig_of
from kitemj.physics.steering import Control, Segment, control
from kitemj.physics.vectors import Rotation, Vector, cross, norm, plus, times, unrotated
from kitemj.recording.file import Recording
from kitemj.recording.table import ATTITUDE, RATES, REFERENCE, STEERING, VELOCITY, Columns

Array = NDArray[np.float64]
O_E = Vector(0.0, 0.0, 0.0)
POSITION = ("x_E_m", "y_E_m", "z_E_m")


class Track:
    """Motions along `columns` (those of its motions) of a recording or of its replay.

    A place is a row, or a number between two rows: there position is a cubic through both,
    attitude a straight line made a rotation again. `last` is the last place.
    """

    def __init__(self, recording: Recording, columns: Columns | None = None) -> None:
        self.parameters, self.tick = recording.parameters, recording.header.tick
        self.last = len(recording) - 1
        own, theirs = recording.columns, columns or recording.columns
        self._episode, self._ticks = own["leg"], own["tick"]
        self._steering = _matrix(own, STEERING)
        rig = rig_of(recording.parameters)
        self._q = _matrix(theirs, tuple(f"{name}_rad" for name in rig.coordinates))
        self._position = _matrix(theirs, POSITION)
        self._air = _matrix(theirs, ("t_s", "alpha_deg", "beta_deg", "airspeed_m_s"))
        self._tensions = _matrix(theirs, tuple(f"tension_{name}_N" for name in rig.lines))
        self._lengths = _matrix(theirs, tuple(f"length_{name}_m" for name in rig.lines))
        self._attitude, self._rates = _matrix(theirs, ATTITUDE), _matrix(theirs, RATES)
        self._velocity = _matrix(theirs, VELOCITY)
        self._offset = _matrix(own, REFERENCE[:3]) - _matrix(own, POSITION)
        self._reference = _matrix(own, REFERENCE[3:])

    def motion(self, place: float) -> Motion | None:
        """The motion at `place`; None where there is none (a replay that could not fly on)."""
        row, part = self._row(place)
        now = self._at(row)
        if part == 0.0 or not isfinite(now.body.p_G_E.x):
            return now if isfinite(now.body.p_G_E.x) else None
        then = self._at(row + 1)
        if not isfinite(then.body.p_G_E.x):
            return now
        return between(self.parameters, now, then, part, self._control(row + 1, part))

    def reference(self, place: float, beside: Motion) -> Motion | None:
        """The recorded reference, where the recorded flight is at `beside`; None: it is lost."""
        row, part = self._row(place)
        following = row + (part > 0.0)
        if not isfinite(self._offset[row, 0] + self._offset[following, 0]):
            return None
        apart = _line(self._offset[row].tolist(), self._offset[following].tolist(), part)
        body = beside.body._replace(
            p_G_E=plus(beside.body.p_G_E, Vector(*apart)),
            R_BE=_turned(
                _rotation(self._reference[row]), _rotation(self._reference[following]), part
            ),
        )
        return beside._replace(body=body)

    def _row(self, place: float) -> tuple[int, float]:
        """The row before `place` and what part of a tick follows; 0 where an episode ends."""
        place = min(max(place, 0.0), float(self.last))
        row = floor(place)
        goes_on = row < self.last and self._episode[row] == self._episode[row + 1]
        return row, place - row if goes_on else 0.0

    def _control(self, row: int, part: float) -> Control:
        """The steering after `part` of the tick that ends in `row`."""
        start = Control(*self._steering[row].tolist())
        at: Control = control(Segment(0.0, start), part * self.tick)
        return at

    def _at(self, row: int) -> Motion:
        body = Body(
            Vector(*self._position[row].tolist()),
            _rotation(self._attitude[row]),
            Vector(*self._velocity[row].tolist()),
            Vector(*self._rates[row].tolist()),
        )
        ended = self._control(row, 1.0 if self._ticks[row] else 0.0)
        t, alpha, beta, speed = self._air[row].tolist()
        lengths, tensions = self._lengths[row].tolist(), self._tensions[row].tolist()
        lines = _lines(self.parameters, body, lengths, tensions)
        air = Air(radians(alpha), radians(beta), speed)
        q = Angles(*self._q[row].tolist()) if self._q.shape[1] else None
        return Motion(t, q, body, ended, lines, air)


def between(parameters: Parameters, a: Motion, b: Motion, part: float, steering: Control) -> Motion:
    """The motion after `part` (0 to 1) of the tick from `a` to `b`, with that steering."""
    h = b.t - a.t
    body = Body(
        Vector(*_cubic(a.body.p_G_E, b.body.p_G_E, a.body.v_G_E, b.body.v_G_E, h, part)),
        _turned(a.body.R_BE, b.body.R_BE, part),
        Vector(*_line(a.body.v_G_E, b.body.v_G_E, part)),
        Vector(*_line(a.body.omega_B, b.body.omega_B, part)),
    )
    lengths, tensions = _line(a.lengths, b.lengths, part), _line(a.tensions, b.tensions, part)
    if min(*a.tensions, *b.tensions) > 0.0:  # taut lines are as long as they look
        lengths = [norm(knot) for knot in _knots(parameters, body)]
    air = Air(*_line(a.air, b.air, part))
    lines = _lines(parameters, body, lengths, tensions)
    return Motion(a.t + part * h, a.q, body, steering, lines, air)


def _lines(
    parameters: Parameters, body: Body, lengths: Sequence[float], tensions: Sequence[float]
) -> tuple[LineState, ...]:
    """The lines that lead straight from O_E to the kite."""
    return tuple(
        LineState(length, tension, tension, (O_E, knot))
        for knot, length, tension in zip(_knots(parameters, body), lengths, tensions, strict=True)
    )


def _knots(parameters: Parameters, body: Body) -> list[Vector]:
    """Where each line ends on the kite [m, E]."""
    places = rig_of(parameters).attachments(parameters.kite)
    return [plus(body.p_G_E, unrotated(body.R_BE, place)) for place in places]


def _matrix(columns: Columns, names: tuple[str, ...]) -> Array:
    """A row for each tick, shape (rows, names)."""
    return np.column_stack([columns[name] for name in names])


def _rotation(numbers: Array) -> Rotation:
    R = numbers.tolist()
    return Rotation(Vector(*R[0:3]), Vector(*R[3:6]), Vector(*R[6:9]))


def _line(a: Sequence[float], b: Sequence[float], part: float) -> list[float]:
    return [x + part * (y - x) for x, y in zip(a, b, strict=True)]


def _cubic(a: Vector, b: Vector, v_a: Vector, v_b: Vector, h: float, s: float) -> list[float]:
    """Hermite's cubic through two points with their velocities, `h` [s] apart."""
    p, q = s * s * (3 - 2 * s), s * (1 - s) * h
    ends = zip(a, b, v_a, v_b, strict=True)
    return [x + p * (y - x) + q * ((1 - s) * v - s * w) for x, y, v, w in ends]


def _turned(a: Rotation, b: Rotation, part: float) -> Rotation:
    """Between two attitudes a tick apart: the axes on straight lines, made orthogonal again."""
    rows = [Vector(*_line(r, s, part)) for r, s in zip(a, b, strict=True)]
    x = times(1.0 / norm(rows[0]), rows[0])
    z = cross(x, rows[1])
    z = times(1.0 / norm(z), z)
    return Rotation(x, cross(z, x), z)
