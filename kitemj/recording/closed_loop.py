"""A recording flown once more with its autopilot in the loop."""

from collections.abc import Iterator

from kitemj.autopilot.guided_flight import pilot_of
from kitemj.errors import InputError
from kitemj.flight.guided_table import NOBODY, PHASE
from kitemj.flight.live import Command, SteeredFlight
from kitemj.flight.scenario import Scenario, Times
from kitemj.physics.steering import Control, Segment
from kitemj.recording.file import Recording
from kitemj.recording.table import STEERING, motion_row


def check_closed_loop(recording: Recording) -> None:
    """Raises InputError for a recording in which no autopilot of its scenario flew."""
    if recording.pilot is None or not (recording.columns[PHASE] > NOBODY).any():
        raise InputError(
            f"no autopilot of a scenario flew {recording.path.name}: there is no loop to close; "
            f"replay it without"
        )


def closed_flown(
    recording: Recording, episode: slice, model: str, step: float
) -> Iterator[tuple[int, list[float]]]:
    """Each row of an episode with its motion; where the autopilot flew, it flies again.

    An episode that goes on from another is flown from that one's start.
    """
    assert recording.pilot
    tick, way = recording.header.tick, recording.way_to(episode)
    steering = zip(*(recording.columns[name][way].tolist() for name in STEERING), strict=True)
    numbers, phases = (recording.columns[name][way].tolist() for name in ("tick", PHASE))
    flight, guided = _standing(recording, int(way[0]), model, step), False
    pilot = pilot_of(flight.scenario)
    for row, k, phase, control in zip(way.tolist(), numbers, phases, steering, strict=True):
        if k > 0 and phase > NOBODY:
            if not guided:
                pilot.restart(flight.result.motion.t)
            flight.tick(pilot.command(flight.result.motion))
        elif k > 0:
            flight.fly(Segment((k - 1) * tick, Control(*control)), Command())
        guided = phase > NOBODY
        motion = motion_row(flight.result.motion)
        if row >= episode.start:
            yield row, motion


def _standing(recording: Recording, row: int, model: str, step: float) -> SteeredFlight:
    """The flight at the start that `row` goes back to, the lines still."""
    header, columns = recording.header, recording.columns
    control = Control(*(float(columns[name][row]) for name in STEERING))
    start = header.states[int(columns["start"][row])]
    still = Segment(0.0, control)
    scenario = Scenario(
        header.scenario, recording.parameters, still, start, Times(1.0), False, recording.pilot
    )
    return SteeredFlight(scenario, model, step=step)
