"""The same scenario through several models: how far apart they fly, and when."""

from collections.abc import Callable, Sequence
from math import asin, sqrt
from typing import NamedTuple

import numpy as np

from kitemj.dynamics.motion import Motion
from kitemj.errors import InputError
from kitemj.flight.limits import GROUND, SLACK, first_departure
from kitemj.flight.restless import restless
from kitemj.flight.scenario import Scenario
from kitemj.flight.simulate import Simulation, simulate
from kitemj.progress_bar import with_progress

POSITION_TOLERANCE = 1e-6
"""m; what the project promises of MuJoCo at its default step over a minute of calm flight."""
ATTITUDE_TOLERANCE = 1e-6
"""rad; half a kite's span turned by it moves the tips by less than POSITION_TOLERANCE x 3."""
TENSION_TOLERANCE = 0.01
"""N; the engine's force is that of its last settled evaluation: 10⁻⁴ of a line's 50 N."""
GUIDED_TOLERANCE = 1e-3
"""m, rad; with an autopilot in the loop. On an eight MuJoCo's lines are 10 to 50 nm too long, their
rates some 10 µm/s off, and the pull that they tell up to 0.5 mN, as much in steps half as long;
nothing calls a gap along the path back, and laps later it is a tenth of a millimetre."""
STILL = 1e-3
"""m; a kite that never gets further from its start is at rest: rounding moves it by 10⁻¹³."""


class Gap(NamedTuple):
    """The largest difference, and when it happens [s]."""

    value: float
    t: float


class Comparison(NamedTuple):
    """Largest gaps of `model` to `reference`: position [m], attitude [rad], tension [N].

    `until` [s]: the last row before a line of either goes slack (unless `lines.rigid`) or a kite
    touches the ground, or the end: rigid lines and real ones part there. `valid` [s]: the first
    departure from any limit of validity, up to which agreement is claimed. `moved` [m]: how far
    from its start the reference got until then. `phases`: whether the autopilots of both were in
    the same phase at every row; None: none flew.
    """

    scenario: str
    model: str
    reference: str
    until: float
    valid: float
    moved: float
    phases: bool | None
    position: Gap
    attitude: Gap
    tension: Gap

    @property
    def agrees(self) -> bool:
        """Whether something was compared, and all three are within their tolerances."""
        guided = self.phases is not None
        return (
            self.until > 0.0
            and self.position.value <= (GUIDED_TOLERANCE if guided else POSITION_TOLERANCE)
            and self.attitude.value <= (GUIDED_TOLERANCE if guided else ATTITUDE_TOLERANCE)
            and self.tension.value <= TENSION_TOLERANCE
            and self.phases is not False
        )

    @property
    def verdict(self) -> str:
        """`agrees` in words; a kite that never moved shows nothing of how it moves."""
        if self.until == 0.0:
            return "nothing compared"
        if self.phases is False:
            return "NO: other phases"
        if not self.agrees:
            return "NO"
        return "at rest" if self.moved <= STILL else "yes"


def position_gap(a: Motion, b: Motion) -> float:
    """Distance [m] between the two centres of mass."""
    return float(np.linalg.norm(np.subtract(a.body.p_G_E, b.body.p_G_E)))


def attitude_gap(a: Motion, b: Motion) -> float:
    """Angle [rad] of the rotation from one attitude to the other."""
    chord = float(np.linalg.norm(np.subtract(a.body.R_BE, b.body.R_BE)))  # = 2√2 sin(angle/2)
    return 2 * asin(min(1.0, chord / (2 * sqrt(2))))


def tension_gap(a: Motion, b: Motion) -> float:
    """Larger of the two lines' differences in tension [N]."""
    return float(np.max(np.abs(np.subtract(a.tensions, b.tensions))))


def compare(flight: Simulation, reference: Simulation) -> Comparison:
    """Gaps between two flights of one scenario, row by row.

    Raises InputError where a line is slack or the kite on the ground at once, so that nothing
    can be compared.
    """
    pairs, parameters = [], flight.scenario.parameters
    parting = (GROUND,) if parameters.lines.rigid else (GROUND, SLACK)
    for a, b in zip(flight.motions, reference.motions, strict=False):
        if first_departure(parameters, (a, b), parting):
            break  # of a touch, each tells its own moment
        pairs.append((a, b))
    if not pairs:
        parted = "a line is slack or the kite on the ground at the start; start more gently"
        why = flight.note or reference.note or parted
        raise InputError(f"there is nothing to compare in {flight.scenario.source}: {why}")
    end = pairs[-1][0].t
    departures = [f.departure.t for f in (flight, reference) if f.departure]

    def largest(measure: Callable[[Motion, Motion], float]) -> Gap:
        values = [measure(a, b) for a, b in pairs]
        i = int(np.argmax(values))
        return Gap(values[i], pairs[i][0].t)

    return Comparison(
        flight.scenario.source,
        flight.model,
        reference.model,
        end,
        min([end, *departures]),
        max(position_gap(b, pairs[0][1]) for _, b in pairs),
        _same_phases(flight, reference, len(pairs)),
        largest(position_gap),
        largest(attitude_gap),
        largest(tension_gap),
    )


def _same_phases(flight: Simulation, reference: Simulation, rows: int) -> bool | None:
    if not (flight.guided and reference.guided):
        return None
    told = [[each and each.phase for each in one.guided[:rows]] for one in (flight, reference)]
    return told[0] == told[1]


Fly = Callable[[Scenario, str, float], Simulation]
"""Flies a scenario by a model in steps [s]."""


def compare_models(
    scenario: Scenario, models: Sequence[str], step: float, fly: Fly = simulate
) -> list[Comparison]:
    """Each of `models` against the last of them, which is the reference.

    A scenario that names neither a steering programme nor a pilot is flown with restless hands.
    """
    scenario = scenario if scenario.steered or scenario.pilot else restless(scenario)
    shown = with_progress(f"flying {scenario.source}", models, len(models))
    flights = [fly(scenario, model, step) for model in shown]
    return [compare(flight, flights[-1]) for flight in flights[:-1]]
