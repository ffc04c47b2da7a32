"""The loop of `kitemj fly`: takes wishes, updates the flight, paints and shows a frame."""

import time
from dataclasses import dataclass

import pygame

from kitemj.cockpit.replay_window import ReplayWindow
from kitemj.cockpit.screens import FRAME_RATE, Screen, Window
from kitemj.controls.actions import HELP, Wishes
from kitemj.controls.programmed import ProgrammedStick
from kitemj.drawing.history import History
from kitemj.drawing.picture import Picture
from kitemj.drawing.readings import Readings
from kitemj.drawing.wished import Wished
from kitemj.errors import InputError
from kitemj.flight.live import TICK
from kitemj.physics.shaping import StickLaw
from kitemj.pilots.course import Course
from kitemj.realtime.messages import Assisted, Deed, Piloted, Rate, Timekeeping
from kitemj.realtime.process import FlightProcess
from kitemj.recording.file import read_recording
from kitemj.recording.recorder import FLUSH

WATCHED = 20.0
"""s before now at which watching a flight again begins."""


@dataclass(frozen=True)
class Summary:
    """The summary of a flight for the person; `first_frame` [s] counts from the call."""

    flown: float
    times: Timekeeping
    frames: int
    wall: float
    first_frame: float
    recording: str = "none"

    def __str__(self) -> str:
        """A few lines for people."""
        times = self.times
        text = (
            f"flown        {self.flown:.2f} s in {self.wall:.2f} s of wall time\n"
            f"ticks        {times.ticks} of {TICK * 1e3:g} ms, {times.missed} missed, "
            f"worst lateness {times.worst * 1e3:.1f} ms\n"
        )
        if self.frames:
            rate = self.frames / max(self.wall, 1e-9)
            first = f"the first after {self.first_frame:.1f} s"
            text += f"frames       {self.frames}, {rate:.1f} a second, {first}\n"
        text += (
            f"largest gap  {times.largest_gap * 1e6:.3g} µm between the kite and its reference\n"
            f"recording    {self.recording}"
        )
        if times.lost:
            text += f"\nlost         {times.lost:.2f} s that the machine did not run"
        return text


def fly(
    physics: FlightProcess,
    picture: Picture | None,
    screen: Screen,
    duration: float | None = None,
    called: float | None = None,
    course: Course | None = None,
) -> Summary:
    """Flies until the screen is left, a signal, or the time is over; returns what is to be told.

    physics: the flight in real time, not yet started
    picture: paints the frames; None: nothing is painted
    screen: shows them, and has the person's wishes; closed in the end
    duration: s of wall time; None: no end
    called: s by perf_counter, since when the first frame is waited for; None: now
    course: the lessons; it watches what is painted

    Raises what ended the flight, if anything did, once the screen is closed.
    """
    called, history = called or time.perf_counter(), History(physics.parameters)
    faults = {name: offer.fault for name, offer in physics.offers.items()}
    screen.offer(faults, at_once="scenario" in faults)
    ending, frames, first, clock = "left by the pilot", 0, 0.0, pygame.time.Clock()
    begun = time.perf_counter()
    try:
        if picture:
            picture.paint(physics.result.motion, None, Readings(), screen.wishes.view)
        physics.start()
        begun = time.perf_counter()
        while not screen.wishes.leaving:
            painting = time.perf_counter()
            if duration is not None and painting - begun >= duration:
                ending = "as long as was asked"
                break
            screen.poll()
            for news in physics.update():
                history.add(news.done, news.result.motion, news.lateness)
            if isinstance(screen.stick, ProgrammedStick):
                screen.wishes.ask(screen.stick.actions(painting - begun))
            physics.ask(screen.stick.command(physics.result.motion))
            physics.ask(Assisted(screen.assist))
            physics.ask(Piloted(screen.flown))
            if "watch" in _grant(screen.wishes, physics, picture, course) and picture:
                begun += _watch(physics, picture, screen)
            if course and not screen.flown:  # nothing is learnt by looking on
                course.watch(physics.result.motion, assist=screen.assist)
            moving = screen.wishes.pace > 0
            screen.sense(physics.parameters, physics.result.motion, physics.touch, moving)
            if picture:
                if screen.size and screen.size != (picture.width, picture.height):
                    picture.resize(*screen.size)
                result, readings = physics.result, _readings(physics, history, screen, course)
                frame = picture.paint(result.motion, result.reference, readings, screen.wishes.view)
                screen.show(frame, painting - begun)
                frames += 1
                history.add_frame(painting, time.perf_counter() - painting)
                first = first or time.perf_counter() - called
            clock.tick(picture.rate if picture else FRAME_RATE)
    except KeyboardInterrupt:
        ending = "interrupted"  # leaving in a hurry is leaving: film and summary are complete
    finally:
        wall = time.perf_counter() - begun
        try:
            recording = physics.stop(ending)
        finally:
            screen.close()
    times = physics.times
    return Summary(times.ticks * TICK, times, frames, wall, first, recording)


def _grant(
    wishes: Wishes, physics: FlightProcess, picture: Picture | None, course: Course | None
) -> list[str]:
    """Does what the person asks for of time, picture and lessons; returns what else is wished."""
    deeds, turn, zoom = wishes.taken()
    others: list[str] = []
    physics.ask(Rate(wishes.pace))
    for deed in deeds:
        if deed == "watch":
            others.append(deed)
        elif deed not in ("next lesson", "begin lesson"):
            physics.ask(Deed(deed))
        elif course and deed == "next lesson":
            course.skip()
        elif course:
            course.begin_again()
            physics.ask(Deed.RESTART)
    if picture:
        if turn != (0.0, 0.0):
            picture.eye.turn(*turn)
        if zoom != 1.0:
            picture.eye.zoom(zoom)
        picture.depth, picture.shown = wishes.depth, wishes.shown
    return others


def _watch(physics: FlightProcess, picture: Picture, screen: Screen) -> float:
    """Shows what was flown so far to the person, if there is one; returns for how long [s].

    The flight waits meanwhile.
    """
    begun = time.perf_counter()
    if not isinstance(screen, Window):
        return 0.0
    if physics.record is None:
        screen.say("this flight is not recorded: there is nothing to watch again")
        return 0.0
    physics.ask(Rate(0.0))
    screen.sense(physics.parameters, physics.result.motion, physics.touch, moving=False)
    time.sleep(FLUSH + 0.1)  # until what was flown is on the disk
    try:
        replay = ReplayWindow(read_recording(physics.record), None, picture, screen)
    except InputError as error:
        screen.say(str(error))
        return 0.0
    replay.player.seek(replay.player.duration - WATCHED)
    replay.run(meanwhile=physics.update)
    return time.perf_counter() - begun


def _readings(
    physics: FlightProcess, history: History, screen: Screen, course: Course | None
) -> Readings:
    """The readings of the present moment.

    The pointer of the knob is where the stick is now, or where the assist or the autopilot has it.
    """
    times, wishes, status = physics.times, screen.wishes, course.status if course else None
    lesson_shown = status and (status.number or status.praised)  # until all are passed and praised
    own = physics.command.delta * physics.parameters.stick.delta
    wish = physics.result.wish if screen.assist else own
    guided, stick = physics.guided if screen.flown else None, screen.stick.name
    return Readings(
        model=physics.model,
        gap=physics.result.gap,
        delta_command=physics.result.motion.control.delta if screen.flown else wish,
        law=StickLaw.ANGLE if screen.assist or screen.flown else physics.command.law,
        missed_ticks=times.missed,
        lateness=times.lateness,
        stick="autopilot" if screen.flown else f"{stick} + assist" if screen.assist else stick,
        assist=screen.assist,
        speed=wishes.pace,
        message=screen.message or physics.problem,
        traces=history.traces(time.perf_counter()),
        help=HELP if wishes.help else (),
        lesson=status if lesson_shown else None,
        touch=physics.touch,
        wished=Wished(physics.offers[screen.flown].path, guided) if screen.flown else None,
    )
