"""Flights that the tests of this room record; run as a program: one that somebody will kill."""

import sys
from pathlib import Path
from random import Random

from kitemj.drawing.history import History
from kitemj.flight.live import Command, LiveFlight
from kitemj.flight.scenario import scenario_of
from kitemj.realtime.pacer import Pacer
from kitemj.recording.header import header_of
from kitemj.recording.recorder import Recorder
from kitemj.recording.table import Tick

TABLES = {"set": "thesis", "duration": 60.0}
LOOPS = {
    "set": "laksa",
    "duration": 1.0,
    "kite": {"mass": 0.22, "inertia_x": 0.03, "inertia_y": 0.006, "inertia_z": 0.035}
    | {"chord": 0.45, "span": 1.7, "area": 0.6, "x_A": 0.05, "y_A": 0.3, "z_A": 0.3},
    "aero": {"Cn_beta": 0.5, "Cy_beta": -3.0},
    "lines": {"length": 20.0},
    "wind": {"speed": 6.0},
    "stick": {"delta": 0.55, "delta_dot": 1.0, "delta_ddot": 4.0},
}


def live_flight(tables=TABLES, model="mujoco"):
    return LiveFlight(scenario_of(tables, "test"), model)


def recorder_of(flight, path, **options):
    return Recorder(path, header_of(flight), flight.parameters, **options)


def tick_of(flight, command, result, lateness=0.0):
    return Tick(flight.ticks, flight.segment.control, command, result, lateness)


def restless(seed, ell=0.1, hold=70):
    """A stick that never rests: a new wish every `hold` ticks."""
    random = Random(seed)
    while True:
        command = Command(random.uniform(-1, 1), random.uniform(-ell, ell))
        yield from [command] * hold


def recorded(path, ticks, flight=None, stick=None, episodes=1):
    """A recording of `episodes` flights of `ticks` each, not in real time; returns its path."""
    flight, stick = flight or live_flight(), stick or restless(4)
    recorder = recorder_of(flight, path)
    for _ in range(episodes):
        recorder.add(tick_of(flight, Command(), flight.restart()))
        for _ in range(ticks):
            command = next(stick)
            recorder.add(tick_of(flight, command, flight.tick(command)))
    recorder.close("as long as was asked")
    return path


if __name__ == "__main__":
    flight = live_flight()
    flight.warm_up()
    pacer = Pacer(flight, History(flight.parameters), recorder_of(flight, Path(sys.argv[1])))
    pacer.start()
    print("flying", flush=True)
    pacer.join()
