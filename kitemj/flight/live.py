"""A flight that is steered while it happens: the kite, and the reference that follows it.

One tick is the grain of it: the stick is read, its wish is shaped into a motion of the
lines with constant δ̈ and ℓ̈, and both models fly through the same tick. Nothing here knows
of clocks or screens.
"""

from collections.abc import Mapping
from math import isfinite
from pathlib import Path
from typing import Any, NamedTuple

from kitemj.dynamics.formulation import DEFAULT_STEP, make_model
from kitemj.dynamics.motion import Motion, Snapshot, State
from kitemj.errors import FlightError
from kitemj.flight.compare import position_gap
from kitemj.flight.limits import Departure, Ending, departure_at, touches_ground
from kitemj.flight.scenario import Scenario, as_scenario
from kitemj.physics.shaping import StickLaw, asked, shaped
from kitemj.physics.steering import Control, Segment, control, rest_ell

TICK = 0.01
"""s; a person's hand moves at 5 Hz or less, and an hour of ticks is 360,000 rows."""


class Command(NamedTuple):
    """What the stick asks for, parts of the limits in -1..1.

    `delta` is δ, δ̇ or δ̈, as `law` says (positive: the right hand pulls), `ell` always ℓ.
    """

    delta: float = 0.0
    ell: float = 0.0
    law: StickLaw = StickLaw.ANGLE


class TickResult(NamedTuple):
    """What is known at the end of a tick; `reference` is None once it left its validity.

    `wish` [rad] is the δ that the stick asks for, `gap` [m] the distance to the reference.
    """

    motion: Motion
    reference: Motion | None
    wish: float
    gap: float | None
    departure: Departure | None


class Saved(NamedTuple):
    """A live flight at the end of a tick; resumed, it flies on from here to the same bits."""

    ticks: int
    segment: Segment
    following: bool
    result: TickResult
    kite: Snapshot
    reference: Snapshot


class LiveFlight:
    """The model `model` beside the model `reference`, both started as `scenario` says.

    `other_starts` are more states to begin at; `starts` has them all, the scenario's first.
    """

    def __init__(
        self,
        scenario: Scenario | str | Path | Mapping[str, Any],
        model: str = "mujoco",
        reference: str = "lagrange",
        step: float = DEFAULT_STEP,
        other_starts: tuple[State, ...] = (),
    ) -> None:
        scenario = as_scenario(scenario)
        parameters = scenario.parameters
        self.starts = (scenario.start, *other_starts)
        self.scenario, self.parameters, self.step = scenario, parameters, step
        self.kite = make_model(model, parameters, step)
        self.reference = make_model(reference, parameters, step)
        self.ell_rest = rest_ell(parameters.lines.length, parameters.kite.y_A)
        self.restart()

    def restart(self, start: int = 0) -> TickResult:
        """Back to that of the `starts`, lines still; the first moment of the flight."""
        at_start = control(self.scenario.programme, 0.0)
        still = Control(at_start.ell, 0.0, 0.0, at_start.delta, 0.0, 0.0)
        self.ticks = 0
        self.segment = Segment(0.0, still)
        self._following = True
        self.kite.start(self.starts[start], self.segment)
        self.reference.start(self.starts[start], self.segment)
        self.result = self._result(still.delta)
        return self.result

    def tick(self, command: Command) -> TickResult:
        """Flies one tick with the stick at `command`; raises FlightError where that diverges."""
        limits, start = self.parameters.stick, self.ticks * TICK
        reach = self.ell_rest + command.ell * limits.ell
        now = control(self.segment, start)
        wish, rate = asked(limits, command.law, command.delta, now, TICK)
        segment = shaped(limits, now, start, TICK, wish, reach, self.ell_rest, rate)
        return self.fly(segment, wish)

    def save(self) -> Saved:
        """The flight as it is now."""
        kite, reference = self.kite.snapshot(), self.reference.snapshot()
        return Saved(self.ticks, self.segment, self._following, self.result, kite, reference)

    def resume(self, saved: Saved) -> TickResult:
        """Back to a moment of this flight; it was looked at then, so it is not flown again."""
        self.ticks, self.segment, self._following, self.result, kite, reference = saved
        self.kite.restore(kite)
        self.reference.restore(reference)
        return self.result

    def fly(self, segment: Segment, wish: float = 0.0) -> TickResult:
        """Both models through one tick of `segment`; `wish` [rad] is the δ asked for."""
        self.segment = segment
        self.ticks += 1
        self.kite.advance(segment, TICK)
        self.kite.t = self.ticks * TICK
        if self._following:
            try:
                self.reference.advance(segment, TICK)
                self.reference.t = self.ticks * TICK
            except FlightError:
                self._following = False
        self.result = self._result(wish)
        return self.result

    def warm_up(self) -> None:
        """Compiles whatever a flight needs, then starts anew: no first tick may be late."""
        for _ in range(3):
            self.tick(Command(1.0))
        self.restart()

    def _result(self, wish: float) -> TickResult:
        motion = self.kite.motion(self.segment)
        departure = departure_at(self.parameters, motion)
        if touches_ground(self.parameters, motion):
            departure = Departure(motion.t, Ending.GROUND, f"{motion.air.speed:.0f} m/s of air")
        # straight, rigid lines are what the reference is made of: beyond, it says nothing
        parting = {Ending.GROUND} if self.parameters.lines.rigid else {Ending.GROUND, Ending.SLACK}
        if departure and departure.ending in parting:
            self._following = False
        reference = self.reference.motion(self.segment) if self._following else None
        if reference is None or not isfinite(reference.body.p_G_E.x):
            return TickResult(motion, None, wish, None, departure)
        return TickResult(motion, reference, wish, position_gap(motion, reference), departure)
