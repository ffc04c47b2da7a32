"""Makes all pictures of README and docs: views, depths of instruments, alarm, lesson, crash, help.

    python scripts/pictures.py [FOLDER]       (docs/ if left out)

Needs no screen. Every picture is of a flight that was flown, painted in its own size; nothing in it
is drawn for the occasion.
"""

import sys
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pygame
from numpy.typing import NDArray

from kitemj.autopilot.autopilot import Autopilot
from kitemj.cockpit.fly import fly
from kitemj.cockpit.screens import FRAME_RATE, Screen
from kitemj.commands.fly import LEARNT_ON
from kitemj.controls.actions import HELP, VIEWS
from kitemj.controls.stick import Stick, show_of
from kitemj.drawing.history import History, Traces
from kitemj.drawing.picture import Picture
from kitemj.drawing.readings import Readings
from kitemj.drawing.wished import Wished
from kitemj.dynamics.formulation import DEFAULT_STEP
from kitemj.dynamics.motion import Motion
from kitemj.flight.live import TICK, Command, SteeredFlight
from kitemj.flight.pilot_settings import PilotSettings
from kitemj.flight.scenario import Scenario, read_scenario, scenario_of
from kitemj.flight.simulate import simulate
from kitemj.physics.parameter_files import read_toml
from kitemj.pilots.course import Course
from kitemj.pilots.crash import FirstTouch
from kitemj.realtime.process import FlightProcess
from kitemj.recording.live import FlightSetup

ROOT = Path(__file__).parent.parent
SIZE, SMALL = (1280, 720), (960, 540)  # px
LOOP, LOOP_AT = ROOT / "scenarios" / "loops_20m.toml", 5.4  # s
SHOW_AT = 6.0  # s
GUIDED_AT = 14.3  # s
LIVE = 20.0  # s
LESSON_AT = 1.2  # s
HARDER = 1.2
"""The loop with so much more δ, in which the outer line goes slack."""

Frame = NDArray[np.uint8]
FRAME = round(1 / FRAME_RATE / TICK)  # ticks from one look of an eye to the next


class Past(NamedTuple):
    """A flight up to a moment: its motions, one a tick, and what was remembered of it."""

    scenario: Scenario
    motions: Sequence[Motion]
    traces: Traces

    def painted(
        self,
        size: tuple[int, int],
        view: str = VIEWS[0],
        depth: str = "pilot",
        wished: Wished | None = None,
    ) -> Frame:
        """The last moment, from a view that has followed the flight."""
        now = self.motions[-1]
        readings = Readings(delta_command=now.control.delta, stick="programme", traces=self.traces)
        readings = readings._replace(wished=wished)
        with Picture(self.scenario.parameters, *size, "film") as picture:
            picture.depth = depth
            look(picture, self.motions, view)
            return picture.paint(now, None, readings, view)


def past(scenario: Scenario, motions: Sequence[Motion]) -> Past:
    """The flight with what instruments remember of it."""
    history = History(scenario.parameters)
    for motion in motions:
        history.add(motion.t, motion)
    return Past(scenario, motions, history.traces(motions[-1].t))


def look(picture: Picture, motions: Sequence[Motion], view: str) -> None:
    """Lets the eye of the picture follow the flight, as it does in a window."""
    for motion in motions[(len(motions) - 1) % FRAME :: FRAME]:
        picture.eye.look(motion, view)


def simulated(scenario: Scenario, until: Callable[[Motion], bool]) -> Past:
    """The flight until something is true, or its end."""
    scenario = replace(scenario, times=scenario.times._replace(output_interval=TICK))
    motions = simulate(scenario, "mujoco").motions
    last = next((i for i, motion in enumerate(motions) if until(motion)), len(motions) - 1)
    return past(scenario, motions[: last + 1])


def save(folder: Path, name: str, frame: Frame) -> None:
    """Writes a frame as a PNG."""
    height, width = frame.shape[:2]
    path = folder / f"{name}.png"
    pygame.image.save(pygame.image.frombuffer(frame.tobytes(), (width, height), "RGB"), path)
    print(path)


def default_view(folder: Path) -> None:
    """A show seen from beside the kite and by its pilot, and the page of keys over that."""
    scenario = scenario_of({"set": LEARNT_ON, "duration": SHOW_AT + 1.0}, "a show")
    flight, stick = SteeredFlight(scenario), show_of(scenario.parameters)
    motions = [flight.result.motion]
    while motions[-1].t < SHOW_AT - TICK / 2:
        motions.append(flight.tick(stick.command(motions[-1])).motion)
    seen = past(scenario, motions)
    save(folder, "flight", seen.painted(SIZE, "orbit"))
    save(folder, "cockpit", seen.painted(SMALL))
    with Picture(scenario.parameters, *SMALL) as picture:
        look(picture, motions, VIEWS[0])
        save(folder, "help", picture.paint(motions[-1], None, Readings(help=HELP), VIEWS[0]))


def views(folder: Path) -> None:
    """A loop from everywhere."""
    loop = simulated(read_scenario(LOOP), lambda motion: motion.t > LOOP_AT - TICK / 2)
    for view in VIEWS:
        save(folder, f"view_{view}", loop.painted(SMALL, view))


def autopilot(folder: Path) -> None:
    """The usual eight of the kite `sport`, followed."""
    scenario = scenario_of({"set": "sport", "duration": GUIDED_AT + 1.0}, "guided")
    flight, pilot = SteeredFlight(scenario), Autopilot(scenario.parameters, PilotSettings())
    motions = [flight.result.motion]
    while motions[-1].t < GUIDED_AT - TICK / 2:
        motions.append(flight.tick(pilot.command(motions[-1])).motion)
    seen = past(scenario, motions)
    wished = Wished(pilot.path.points, pilot.guided)
    save(folder, "autopilot", seen.painted(SMALL, wished=wished))


def alarm(folder: Path) -> None:
    """A line that goes slack."""
    harder = dict(read_toml(LOOP))
    steering = harder["steering"]
    harder["steering"] = {**steering, "delta": [HARDER * d for d in steering["delta"]]}
    slack = simulated(scenario_of(harder, "harder"), lambda motion: min(motion.tensions) <= 0.0)
    save(folder, "alarm_slack", slack.painted(SMALL))


def first_flight(folder: Path) -> None:
    """The first lesson, and what comes of a stick that is held to the left."""
    scenario = scenario_of({"set": LEARNT_ON, "duration": 60.0}, "first flight")
    flight, left = SteeredFlight(scenario), Command(-1.0)
    course, ground = Course(flight.parameters), FirstTouch(flight.parameters)
    history, motions = History(flight.parameters), [flight.result.motion]
    with Picture(flight.parameters, *SMALL) as picture:

        def paint(name: str) -> None:
            readings = Readings(
                stick="keys",
                traces=history.traces(motions[-1].t),
                lesson=course.status,
                touch=ground.touch,
            )
            look(picture, motions, VIEWS[0])
            save(folder, name, picture.paint(motions[-1], None, readings, VIEWS[0]))

        while not ground.watch(motions[-1]) and motions[-1].t < scenario.times.duration:
            motions.append(flight.tick(left).motion)
            history.add(motions[-1].t, motions[-1])
            course.watch(motions[-1])
            if flight.ticks == round(LESSON_AT / TICK):
                paint("lesson")
        paint("crash")


class Camera(Screen):
    """Keeps the last frame."""

    def __init__(self, stick: Stick) -> None:
        super().__init__(stick)
        self.frame = np.empty((*SIZE[::-1], 3), np.uint8)

    def show(self, frame: Frame, wall: float) -> None:
        """Takes it."""
        self.frame = frame


def engineer(folder: Path) -> None:
    """20 s of the real loop in real time: all numbers, punctuality too."""
    scenario = scenario_of({"set": "sport", "duration": LIVE + 1.0}, "live")
    physics = FlightProcess(FlightSetup(scenario, "mujoco", "lagrange", DEFAULT_STEP))
    with Picture(scenario.parameters, *SIZE) as picture:
        physics.wait()
        camera = Camera(show_of(scenario.parameters))
        camera.wishes.depth, camera.wishes.view = "engineer", "chase"
        fly(physics, picture, camera, LIVE)
    save(folder, "engineer", camera.frame)


if __name__ == "__main__":
    target = Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "docs"
    for make in (default_view, views, autopilot, alarm, first_flight, engineer):
        make(target)
