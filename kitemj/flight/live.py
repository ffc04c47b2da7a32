"""A flight that is steered while it happens: the kite, and a reference that may follow it.

One tick is the grain of it: the stick is read, its wish is shaped into a motion of the
lines with constant δ̈ and ℓ̈, and the model (with its reference, where there is one) flies through
that tick. Nothing here knows of clocks or screens.
"""

from collections.abc import Mapping
from pathlib import Path
from typing import Any, NamedTuple

from kitemj.dynamics.formulation import DEFAULT_STEP, Model, make_model
from kitemj.dynamics.ground import clearance
from kitemj.dynamics.motion import Motion, Snapshot, State
from kitemj.errors import FlightError
from kitemj.flight.compare import position_gap
from kitemj.flight.limits import GROUND, SLACK, VALIDITY, Departure, departure_at
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
    """What is known at the end of a tick.

    `reference` is None where there is none, or once it left its validity; `gap` [m] is the
    distance to it. `wish` [rad] is the δ that the stick asks for.
    """

    motion: Motion
    reference: Motion | None
    wish: float
    gap: float | None
    departure: Departure | None


class Episode(NamedTuple):
    """What is flown between two restarts or resumptions; `number` counts them from 0.

    `parent`: the number of the episode that this one goes on from, its own where it began at
    a start; `start`: which of the flight's starts all of it goes back to.
    """

    number: int
    parent: int
    start: int


class Saved(NamedTuple):
    """A live flight at the end of a tick; resumed, it flies on from here to the same bits."""

    episode: Episode
    ticks: int
    segment: Segment
    following: bool
    result: TickResult
    kite: Snapshot
    reference: Snapshot | None


class SteeredFlight:
    """A model steered tick by tick, with a reference beside it if one is named.

    `result` is what is known now, `segment` how the lines moved in the last of `ticks`.
    """

    def __init__(
        self,
        scenario: Scenario | str | Path | Mapping[str, Any],
        model: str = "mujoco",
        reference: str | None = None,
        step: float = DEFAULT_STEP,
        other_starts: tuple[State, ...] = (),
        start: int = 0,
    ) -> None:
        """Stands at its start; raises InputError for an unknown model.

        scenario      kite, wind, and the state at which to begin; its steering is not flown
        model         the formulation that flies
        reference     the formulation that follows it through the same ticks; None costs nothing
        step          longest step [s] of formulations with fixed steps
        other_starts  states to begin at besides; `starts` has the scenario's first, then these
        start         which of `starts` to begin at
        """
        scenario = as_scenario(scenario)
        parameters = scenario.parameters
        self.starts = (scenario.start, *other_starts)
        self.scenario, self.parameters, self.step = scenario, parameters, step
        self.kite = make_model(model, parameters, step)
        self.reference = make_model(reference, parameters, step) if reference else None
        self.ell_rest = rest_ell(parameters.lines.length, parameters.kite.y_A)
        self.episode = Episode(-1, -1, start)
        self.restart(start)

    def restart(self, start: int = 0) -> TickResult:
        """Back to that of the `starts`, lines still; the first moment of the flight."""
        at_start = control(self.scenario.programme, 0.0)
        still = Control(at_start.ell, 0.0, 0.0, at_start.delta, 0.0, 0.0)
        self.ticks = 0
        self.segment = Segment(0.0, still)
        number = self.episode.number + 1
        self.episode = Episode(number, number, start)
        self.kite.start(self.starts[start], self.segment)
        self._following = self.reference is not None
        if self.reference:
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
        return self.fly(segment, command, wish)

    def save(self) -> Saved:
        """The flight as it is now."""
        reference = self.reference.snapshot() if self.reference else None
        now = self.episode, self.ticks, self.segment, self._following, self.result
        return Saved(*now, self.kite.snapshot(), reference)

    def resume(self, saved: Saved) -> TickResult:
        """Back to a moment of this flight; it was looked at then, so it is not flown again."""
        episode, self.ticks, self.segment, self._following, self.result, kite, reference = saved
        self.episode = Episode(self.episode.number + 1, episode.number, episode.start)
        self.kite.restore(kite)
        if self.reference and reference:
            self.reference.restore(reference)
        return self.result

    def fly(self, segment: Segment, command: Command, wish: float = 0.0) -> TickResult:
        """One tick of `segment`, which `command` asked for; `wish` [rad] is the δ of it."""
        self.segment = segment
        self.ticks += 1
        self._advance(self.kite)
        if self.reference and self._following:
            try:
                self._advance(self.reference)
            except FlightError:
                self._following = False
        self.result = self._result(wish)
        return self.result

    def warm_up(self) -> None:
        """Compiles whatever a flight needs, then starts anew: no first tick may be late."""
        for _ in range(3):
            self.tick(Command(1.0))
        clearance(1.0, 1.0, *self.result.motion.body[:2])  # else first called near the ground
        self.restart()

    def _advance(self, model: Model) -> None:
        model.advance(self.segment, TICK)
        model.t = self.ticks * TICK

    def _result(self, wish: float) -> TickResult:
        motion = self.kite.motion(self.segment)
        departure = departure_at(self.parameters, motion, (GROUND, *VALIDITY))
        # straight, rigid lines are what the reference is made of: beyond, it says nothing
        parting = (GROUND,) if self.parameters.lines.rigid else (GROUND, SLACK)
        if departure and departure.limit in parting:
            self._following = False
        if not self.reference or not self._following:
            return TickResult(motion, None, wish, None, departure)
        try:
            reference = self.reference.motion(self.segment)
        except FlightError:
            self._following = False
            return TickResult(motion, None, wish, None, departure)
        return TickResult(motion, reference, wish, position_gap(motion, reference), departure)
