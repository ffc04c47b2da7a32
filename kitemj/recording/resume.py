"""A recorded flight flown again up to a moment, to be flown on from there by somebody."""

from kitemj.errors import InputError
from kitemj.flight.live import Command
from kitemj.flight.scenario import Scenario, Times
from kitemj.physics.shaping import StickLaw
from kitemj.physics.steering import Control, Segment, Sines
from kitemj.recording.file import Recording
from kitemj.recording.live import FlightSetup, RecordedTick
from kitemj.recording.table import HAND, STEERING, STICK


def resume_point(recording: Recording, at: float | None = None) -> FlightSetup:
    """The last flight of a recording, its past up to `at` [s] of its time, or to its end.

    Raises InputError where it was not flying then.
    """
    way, tick = recording.way_to(recording.episodes[-1]), recording.header.tick
    end = (len(way) - 1) * tick
    if at is not None and not 0.0 <= at <= end:
        raise InputError(
            f"`at` must be in 0 to {end:g} s, the last flight of {recording.path}, got {at:g} s"
        )
    rows = way[: len(way) if at is None else round(at / tick) + 1]
    sticks = [recording.columns[name][rows].tolist() for name in STICK]
    controls = [recording.columns[name][rows].tolist() for name in STEERING]
    commands = (Command(d, ell, StickLaw(int(law))) for d, ell, law in zip(*sticks, strict=True))
    segments = [
        Segment(max(k - 1, 0) * tick, Control(*control))
        for k, control in enumerate(zip(*controls, strict=True))
    ]
    hands = recording.columns[HAND][rows].tolist()
    ticks = tuple(RecordedTick(*each) for each in zip(commands, segments, hands, strict=True))[1:]
    header, first = recording.header, segments[0].control
    held = Sines(ell=first.ell, delta=first.delta)
    times = Times(duration=60.0)  # a live flight has no end
    start = header.states[recording.columns["start"][rows[0]]]
    scenario = Scenario(header.scenario, recording.parameters, held, start, times)
    models = header.model, header.reference or None
    return FlightSetup(scenario, *models, header.step, past=ticks)
