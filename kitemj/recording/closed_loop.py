"""A recording flown once more with its autopilot in the loop."""

from collections.abc import Iterator
from math import isfinite, nan

import numpy as np

from kitemj.autopilot.guided_flight import pilot_of
from kitemj.errors import InputError
from kitemj.flight.live import Command, SteeredFlight
from kitemj.flight.scenario import Scenario, Times
from kitemj.physics.steering import Control, Segment
from kitemj.recording.file import Recording
from kitemj.recording.table import STEERING, motion_row

SINCE = "pilot_since_s"


def check_closed_loop(recording: Recording) -> None:
    """Raises InputError for a recording in which no autopilot of its scenario flew."""
    if recording.pilot is None or not np.isfinite(recording.columns[SINCE]).any():
        raise InputError(
            f"no autopilot of a scenario flew {recording.path.name}: there is no loop to close; "
            f"replay it without"
        )


def closed_flown(
    recording: Recording, episode: slice, model: str, step: float
) -> Iterator[tuple[int, list[float]]]:
    """Each row of an episode with its motion; where the scenario's autopilot flew, it flies again.

    It begins anew whenever it was handed the kite anew. An episode that goes
    on from another is flown from that one's start.
    """
    assert recording.pilot
    tick, way = recording.header.tick, recording.way_to(episode)
    steering = zip(*(recording.columns[name][way].tolist() for name in STEERING), strict=True)
    numbers, handed = (recording.columns[name][way].tolist() for name in ("tick", SINCE))
    flight, began = _standing(recording, int(way[0]), model, step), nan
    pilot = pilot_of(flight.scenario)
    for row, k, since, control in zip(way.tolist(), numbers, handed, steering, strict=True):
        if k > 0 and isfinite(since):
            if since != began:
                pilot.restart(since)
            began = since
            flight.tick(pilot.command(flight.result.motion))
        elif k > 0:
            flight.fly(Segment((k - 1) * tick, Control(*control)), Command())
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
