"""Flights that the tests of this room record; run as a program: one that somebody will kill."""

import sys
from pathlib import Path
from random import Random

from kitemj.flight.live import Command
from kitemj.flight.scenario import scenario_of
from kitemj.realtime.pacer import Pacer
from kitemj.recording.live import LiveFlight

TABLES = {"set": "thesis", "duration": 60.0}
SPORT = {"set": "sport", "duration": 60.0}
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


def live_flight(tables=TABLES, model="mujoco", reference="lagrange", **options):
    return LiveFlight(scenario_of(tables, "test"), model, reference, **options)


def restless(seed, ell=0.1, hold=70):
    """A stick that never rests: a new wish every `hold` ticks."""
    random = Random(seed)
    while True:
        command = Command(random.uniform(-1, 1), random.uniform(-ell, ell))
        yield from [command] * hold


def recorded(path, ticks, tables=TABLES, stick=None, episodes=1):
    """A recording of some flights of `ticks` each, not in real time; returns its path."""
    flight, stick = live_flight(tables, record=path), stick or restless(4)
    for episode in range(episodes):
        if episode:
            flight.restart()
        for _ in range(ticks):
            flight.tick(next(stick))
    flight.close("as long as was asked")
    return path


if __name__ == "__main__":
    live_flight().warm_up()
    flight = live_flight(record=Path(sys.argv[1]))
    print("flying", flush=True)
    Pacer(flight, lambda: (), lambda news: None).run()
