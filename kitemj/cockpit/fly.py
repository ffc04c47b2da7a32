"""`kitemj fly`: a stick, a real-time flight, a picture of it."""

import time
from collections.abc import Iterable
from dataclasses import dataclass

import pygame

from kitemj.cockpit.actions import FLIGHT_DEEDS, HELP, Wishes
from kitemj.cockpit.history import History
from kitemj.cockpit.pacing import Pacer, Timekeeping
from kitemj.cockpit.picture import Picture, Readings
from kitemj.cockpit.programmed import ProgrammedStick
from kitemj.cockpit.screens import FRAME_RATE, Frame, Screen
from kitemj.flight.course import Course
from kitemj.flight.live import TICK, Command, LiveFlight
from kitemj.recording.going_on import Flown
from kitemj.recording.recorder import Recorder


@dataclass(frozen=True)
class Summary:
    """What is told after a flight; `first_frame` [s] counts from the call."""

    flown: float
    times: Timekeeping
    frames: int
    wall: float
    first_frame: float
    recording: str = "none"

    def __str__(self) -> str:
        """A few lines for people."""
        times = self.times
        gap = times.largest_gap
        text = (
            f"flown        {self.flown:.2f} s in {self.wall:.2f} s of wall time\n"
            f"ticks        {times.ticks} of {TICK * 1e3:g} ms, {times.missed} missed, "
            f"worst lateness {times.worst * 1e3:.1f} ms\n"
            f"frames       {self.frames}, {self.frames / max(self.wall, 1e-9):.1f} a second, "
            f"the first after {self.first_frame:.1f} s\n"
            f"largest gap  {gap * 1e6:.3g} µm between the kite and its reference\n"
            f"recording    {self.recording}"
        )
        if times.lost:
            text += f"\nlost         {times.lost:.2f} s that the machine did not run"
        return text


def fly(
    flight: LiveFlight,
    picture: Picture,
    screen: Screen,
    duration: float | None = None,
    called: float | None = None,
    recorder: Recorder | None = None,
    past: Iterable[Flown] = (),
    course: Course | None = None,
) -> Summary:
    """Flies until the screen is left, Ctrl-C, or `duration` [s] of wall time have passed.

    `called` [s, perf_counter]: since when the first frame is waited for; now, if left out.
    `recorder` takes every tick, and is closed at the end. `past` is flown before anything is
    shown. `course`: the lessons; it watches what is painted.
    Raises what ended the physics thread, if anything did, once the screen is closed.
    """
    called = called or time.perf_counter()
    flight.warm_up()
    history = History(flight.parameters)
    pacer = Pacer(flight, history, recorder, past)
    ending, recording = "left by the pilot", "none"
    frames, first, clock = 0, 0.0, pygame.time.Clock()
    picture.paint(pacer.moment.motion, None, Readings(), screen.wishes.view)
    pacer.start()
    begun = time.perf_counter()
    try:
        while pacer.is_alive() and not screen.wishes.leaving:
            painting = time.perf_counter()
            if duration is not None and painting - begun >= duration:
                ending = "as long as was asked"
                break
            screen.poll()
            if isinstance(screen.stick, ProgrammedStick):
                screen.wishes.ask(screen.stick.actions(painting - begun))
            command = pacer.command = screen.stick.command(pacer.moment.motion)
            _grant(screen.wishes, pacer, picture, course)
            if course:
                course.watch(pacer.moment.motion)
            frame = _painted(pacer, picture, screen, command, course)
            screen.show(frame, painting - begun)
            frames += 1
            history.add_frame(painting, time.perf_counter() - painting)
            first = first or time.perf_counter() - called
            clock.tick(FRAME_RATE)
    except KeyboardInterrupt:
        pass  # leaving in a hurry is leaving: the film and the summary are complete
    finally:
        pacer.stop()
        if recorder:
            recording = recorder.close(str(pacer.error or ending))
        screen.close()
    if pacer.error:
        raise pacer.error
    wall = time.perf_counter() - begun
    return Summary(pacer.times.ticks * TICK, pacer.times, frames, wall, first, recording)


def _grant(wishes: Wishes, pacer: Pacer, picture: Picture, course: Course | None) -> None:
    """What the person wants of time, picture and lessons."""
    deeds, turn, zoom = wishes.taken()
    pacer.rate = wishes.rate
    for deed in deeds:
        if deed in FLIGHT_DEEDS:
            pacer.ask(deed)
        elif course and deed == "next lesson":
            course.skip()
        elif course and deed == "begin lesson":
            course.begin_again()
            pacer.ask("restart")
    if turn != (0.0, 0.0):
        picture.orbit(*turn)
    if zoom != 1.0:
        picture.zoom(zoom)
    picture.shown = wishes.shown


def _painted(
    pacer: Pacer, picture: Picture, screen: Screen, command: Command, course: Course | None
) -> Frame:
    """The frame of the present moment; the pointer of the knob is where the stick is now."""
    moment, times, wishes = pacer.moment, pacer.times, screen.wishes
    disk = pacer.recorder.problem if pacer.recorder else ""
    readings = Readings(
        model=pacer.flight.kite.name,
        gap=moment.gap,
        delta_command=command.delta * pacer.flight.parameters.stick.delta,
        law=command.law,
        missed_ticks=times.missed,
        lateness=times.lateness,
        stick=screen.stick.name,
        speed=wishes.rate,
        message=screen.message or disk,
        traces=pacer.history.traces(time.perf_counter()),
        help=HELP if wishes.help else (),
        lesson=course.standing if course else None,
        touch=pacer.touch,
    )
    return picture.paint(moment.motion, moment.reference, readings, wishes.view)
