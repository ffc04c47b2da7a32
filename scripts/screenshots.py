"""Makes the pictures of README and docs: views, instruments, alarms, a lesson, a crash, help.

    python scripts/screenshots.py [FOLDER]       (docs/ if left out)

Every picture is of a flight that was flown; nothing in it is drawn for the occasion.
"""

import sys
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pygame
from numpy.typing import NDArray

from kitemj.cockpit.fly import fly
from kitemj.cockpit.screens import Screen
from kitemj.controls.actions import HELP, PANELS, VIEWS
from kitemj.controls.stick import Stick, show_of
from kitemj.drawing.history import History, Traces
from kitemj.drawing.instruments import Instruments
from kitemj.drawing.picture import Picture
from kitemj.drawing.readings import Readings
from kitemj.dynamics.formulation import DEFAULT_STEP
from kitemj.dynamics.motion import Motion
from kitemj.flight.compare import position_gap
from kitemj.flight.live import TICK, Command, SteeredFlight
from kitemj.flight.scenario import Scenario, read_scenario, scenario_of
from kitemj.flight.simulate import simulate
from kitemj.physics.parameter_files import read_toml
from kitemj.pilots.course import Course
from kitemj.pilots.crash import FirstTouch
from kitemj.realtime.process import FlightProcess
from kitemj.recording.live import FlightSetup

ROOT = Path(__file__).parent.parent
SIZE = (1280, 720)
SMALL = (960, 540)
LOOP = ROOT / "scenarios" / "loops_20m.toml"
LOOP_AT = 5.4  # s
LIVE = 20.0  # s
LESSON_AT = 1.2  # s
HARDER, SLACK_AT = 1.2, 2.6
"""The loop with so much more δ, in which the outer line goes slack, and when [s]."""

NOSE_UP: Mapping[str, Any] = {"set": "thesis", "duration": 3.0, "start": {"theta_deg": 25.0}}
"""Let go with the nose 25° too high: beyond stall until the lines pitch it down."""


class FlightUntil(NamedTuple):
    """A flight up to a moment, the reference there (while it is valid), what was remembered."""

    scenario: Scenario
    motion: Motion
    reference: Motion | None
    traces: Traces

    @property
    def shown(self) -> tuple[Motion, Motion | None, Readings]:
        """What a picture is told."""
        readings = Readings(
            gap=position_gap(self.motion, self.reference) if self.reference else None,
            delta_command=self.motion.control.delta,
            stick="programme",
            traces=self.traces,
        )
        return self.motion, self.reference, readings


def flight_until(scenario: Scenario, until: float) -> FlightUntil:
    """Flies until that time [s]."""
    times = scenario.times._replace(output_interval=TICK, duration=max(until, TICK))
    scenario = replace(scenario, times=times)
    row = round(until / TICK)
    motions = simulate(scenario, "mujoco").motions[: row + 1]
    taut = all(min(motion.tensions) > 0.0 for motion in motions)
    reference = simulate(scenario, "lagrange").motions[row] if taut else None
    history = History(scenario.parameters)
    for motion in motions:
        history.add(motion.t, motion)
    return FlightUntil(scenario, motions[-1], reference, history.traces(motions[-1].t))


def save(folder: Path, name: str, frame: NDArray[np.uint8], size: tuple[int, int]) -> None:
    """Writes `frame`, scaled to `size`."""
    height, width = frame.shape[:2]
    picture = pygame.image.frombuffer(frame.tobytes(), (width, height), "RGB")
    if size != (width, height):
        picture = pygame.transform.smoothscale(picture, size)
    pygame.image.save(picture, folder / f"{name}.png")
    print(folder / f"{name}.png")


class Camera(Screen):
    """Keeps the last frame."""

    def __init__(self, stick: Stick) -> None:
        super().__init__(stick)
        self.frame = np.empty((*SIZE[::-1], 3), np.uint8)

    def show(self, frame: NDArray[np.uint8], wall: float) -> None:
        """Takes it."""
        self.frame = frame


def live(folder: Path) -> None:
    """20 s of the real loop in real time: everything that the cockpit shows, and its help."""
    scenario = scenario_of({"set": "sport", "duration": LIVE + 1.0}, "live")
    parameters = scenario.parameters
    physics = FlightProcess(FlightSetup(scenario, "mujoco", "lagrange", DEFAULT_STEP))
    with Picture(parameters, *SIZE) as picture:
        physics.wait()
        camera = Camera(show_of(parameters))
        fly(physics, picture, camera, LIVE)
        helped = picture.paint(physics.result.motion, None, Readings(help=HELP))
    save(folder, "cockpit", camera.frame, SIZE)
    save(folder, "help", helped, SMALL)
    box = Instruments(parameters, *SIZE).box("chart")
    part = camera.frame[box.top : box.bottom, box.left : box.right]
    save(folder, "instrument_chart", part, box.size)


def views_and_instruments(folder: Path) -> None:
    """A loop from everywhere, and each panel alone."""
    loop = flight_until(read_scenario(LOOP), LOOP_AT)
    with Picture(loop.scenario.parameters, *SIZE) as picture:
        for view in VIEWS:
            save(folder, f"view_{view}", picture.paint(*loop.shown, view), SMALL)
        frame = picture.paint(*loop.shown)
    instruments = Instruments(loop.scenario.parameters, *SIZE)
    for name in PANELS:
        if name != "chart":
            box = instruments.box(name)
            part = frame[box.top : box.bottom, box.left : box.right]
            save(folder, f"instrument_{name}", part, box.size)


def first_flight(folder: Path) -> None:
    """The first lesson, and what comes of a stick that is held to the left."""
    scenario = scenario_of({"set": "sport", "duration": 60.0}, "first flight")
    flight = SteeredFlight(scenario, reference="lagrange")
    course, ground = Course(flight.parameters), FirstTouch(flight.parameters)
    history, left, result = History(flight.parameters), Command(-1.0), flight.result
    wish = -flight.parameters.stick.delta
    with Picture(flight.parameters, *SIZE) as picture:

        def paint(name: str) -> None:
            traces = history.traces(result.motion.t)
            readings = Readings(
                gap=result.gap,
                delta_command=wish,
                stick="keys",
                traces=traces,
                lesson=course.status,
                touch=ground.touch,
            )
            frame = picture.paint(result.motion, result.reference, readings)
            save(folder, name, frame, SMALL)

        while not ground.watch(result.motion):
            result = flight.tick(left)
            history.add(result.motion.t, result.motion)
            course.watch(result.motion)
            if flight.ticks == round(LESSON_AT / TICK):
                paint("lesson")
        paint("crash")


def alarms(folder: Path) -> None:
    """Beyond a limit."""
    harder = dict(read_toml(LOOP))
    steering = harder["steering"]
    harder["steering"] = {**steering, "delta": [HARDER * d for d in steering["delta"]]}
    for name, tables, until, view in (
        ("alarm_slack", harder, SLACK_AT, "chase"),
        ("alarm_stall", NOSE_UP, 0.0, "pilot"),
    ):
        seen = flight_until(scenario_of(tables, name), until)
        with Picture(seen.scenario.parameters, *SIZE) as picture:
            save(folder, name, picture.paint(*seen.shown, view), SMALL)


if __name__ == "__main__":
    target = Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "docs"
    views_and_instruments(target)
    alarms(target)
    first_flight(target)
    live(target)
