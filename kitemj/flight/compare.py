"""The same scenario through several models: how far apart they fly, and when."""

from collections.abc import Callable, Sequence
from math import asin, sqrt
from typing import NamedTuple

import numpy as np

from kitemj.dynamics.motion import Motion
from kitemj.errors import InputError
from kitemj.flight.limits import SLACK, first_departure
from kitemj.flight.scenario import Scenario
from kitemj.flight.simulate import Simulation, simulate
from kitemj.progress_bar import with_progress

POSITION_TOLERANCE = 1e-6
"""m; what the project promises of MuJoCo at its default step over a minute of calm flight."""
ATTITUDE_TOLERANCE = 1e-6
"""rad; half a kite's span turned by it moves the tips by less than POSITION_TOLERANCE x 3."""
TENSION_TOLERANCE = 0.01
"""N; the engine's force is that of its last settled evaluation: 10⁻⁴ of a line's 50 N."""


class Gap(NamedTuple):
    """The largest difference, and when it happens [s]."""

    value: float
    t: float


class Comparison(NamedTuple):
    """Largest gaps of `model` to `reference`: position [m], attitude [rad], tension [N].

    `until` [s]: where a line of either goes slack or a kite touches the ground, or the end:
    what comes after is not compared, because rigid lines and real ones part there
    (unless `lines.rigid`). `valid`
    [s]: the first departure from any limit of validity, up to which agreement is claimed.
    """

    scenario: str
    model: str
    reference: str
    until: float
    valid: float
    position: Gap
    attitude: Gap
    tension: Gap

    @property
    def agrees(self) -> bool:
        """Whether all three are within their tolerances."""
        return (
            self.position.value <= POSITION_TOLERANCE
            and self.attitude.value <= ATTITUDE_TOLERANCE
            and self.tension.value <= TENSION_TOLERANCE
        )


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

    Raises InputError where a line is slack at once, so that nothing can be compared.
    """
    pairs, parameters = [], flight.scenario.parameters
    rigid = parameters.lines.rigid
    for a, b in zip(flight.motions, reference.motions, strict=False):
        if not rigid and first_departure(parameters, (a, b), (SLACK,)):
            break
        pairs.append((a, b))
    if not pairs:
        raise InputError(
            f"in {flight.scenario.source} a line is slack at the start, so that there is nothing "
            f"to compare; start the lines more gently"
        )
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
        largest(position_gap),
        largest(attitude_gap),
        largest(tension_gap),
    )


def compare_models(scenario: Scenario, models: Sequence[str], step: float) -> list[Comparison]:
    """Each of `models` against the last of them, which is the reference."""
    shown = with_progress(f"flying {scenario.source}", models, len(models))
    flights = [simulate(scenario, model, step) for model in shown]
    return [compare(flight, flights[-1]) for flight in flights[:-1]]
