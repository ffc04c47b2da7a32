"""`kitemj fly`: a person, a stick, a kite."""

import argparse
from contextlib import nullcontext
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from kitemj.commands.arguments import (
    MODELS,
    SCENARIO,
    Parser,
    add_picture,
    add_pilot,
    add_quality,
    add_step,
    size,
)
from kitemj.errors import NOT_WRITTEN, FlightError, InputError

if TYPE_CHECKING:
    from kitemj.child import Child
    from kitemj.cockpit.fly import Summary
    from kitemj.cockpit.home import Kept
    from kitemj.cockpit.screens import Window
    from kitemj.controls.stick import Stick
    from kitemj.flight.scenario import Scenario
    from kitemj.pilots.course import Course
    from kitemj.realtime.process import FlightProcess
    from kitemj.recording.live import FlightSetup

HELP = "fly in real time with a gamepad, the keys or the mouse; with no display, film a show"
EXAMPLE = "kitemj fly scenarios/steer_80m.toml"
NOTES = """\
Left stick, arrow keys or A/D, or the mouse with its button held: the lines.
W/S or the right stick: let out and take in. F1 shows all keys, Esc leaves."""

LEARNT_ON = "trainer"
"""The kite of the lessons, and of who names none."""
SHOW_DURATION = 20.0
"""s; of a flight that nobody watches."""
LONG = 20.0
"""s; for a sentence that must not be missed."""


def add(parser: Parser) -> None:
    """Adds its arguments."""
    parser.add_argument("scenario", type=Path, nargs="?", help=SCENARIO)
    says = "without a scenario: trainer, sport, thesis, laksa, or a TOML file that changes one"
    parser.add_argument("--kite", default=LEARNT_ON, metavar="SET", help=says)
    parser.add_argument("--arm", type=float, metavar="M", help="arms of so much, which limits δ")
    parser.add_argument("--stick", type=Path, metavar="FILE.csv", help="a table flies, nobody else")
    add_pilot(parser)
    says = "go on from its last flight"
    parser.add_argument("--from", dest="past", type=Path, metavar="RECORDING", help=says)
    parser.add_argument("--at", type=float, metavar="S", help="from this time of it; its end")
    parser.add_argument("--lessons", action="store_true", help="all lessons, passed or not")
    parser.add_argument("--no-lessons", action="store_true", help="none")
    says = "the assist flies what the stick asks for at first, or not; in lessons it does"
    flag = argparse.BooleanOptionalAction
    parser.add_argument("--assist", action=flag, default=None, help=says)
    parser.add_argument("--no-title", action="store_true", help="fly at once, from no title page")
    parser.add_argument("--duration", type=float, metavar="S", help="leave after S seconds")
    says = "open no window: fly a show and film it"
    parser.add_argument("--headless", action="store_true", help=says)
    says = "film the flight when it is over"
    parser.add_argument("--film", type=Path, metavar="FILE.mp4", help=says)
    parser.add_argument("--record", type=Path, metavar="FILE", help="name of the recording")
    parser.add_argument("--overwrite", action="store_true", help="replace these if they exist")
    parser.add_argument("--no-record", action="store_true", help="leave no recording")
    parser.add_argument("--model", default="mujoco", help=f"one of {', '.join(MODELS)}")
    add_picture(parser)
    add_quality(parser)
    add_step(parser)


ASKED = (
    *("scenario", "kite", "arm", "stick", "pilot", "past", "at", "lessons", "no_lessons"),
    *("duration", "headless", "film", "record", "no_title", "model", "step"),
)
"""Who gives one of these wants a certain flight, and sees no title."""


def run(args: argparse.Namespace) -> int:
    """Flies, from the title page on unless a certain flight is asked for; the exit status."""
    from kitemj.realtime.launch import launch

    launched = launch()
    asked = any(getattr(args, name) != args.parser.get_default(name) for name in ASKED)
    import pygame

    from kitemj.cockpit.screens import display_found

    try:
        if asked or not display_found():
            return _fly(args, launched)
        return _from_title(args, launched)
    finally:
        pygame.display.quit()


def _from_title(args: argparse.Namespace, launched: "Child") -> int:
    """Flies, looks and learns as a person chooses, until they leave; the last exit status."""
    from kitemj.cockpit.home import Doors, Home, Kept
    from kitemj.cockpit.screens import Window, fitting
    from kitemj.controls.settings import settings_or_defaults
    from kitemj.pilots.course import LESSONS
    from kitemj.pilots.progress import read_progress

    pixels = fitting(size(args.size))

    def asking(kite: str, lessons: bool) -> argparse.Namespace:
        """The arguments of somebody who asks for this flight."""
        again = lessons and passed()[0] == len(LESSONS)
        return argparse.Namespace(
            **(vars(args) | {"kite": kite, "lessons": again, "no_lessons": not lessons})
        )

    def scenario(kite: str) -> "Scenario":
        return _scenario(asking(kite, lessons=False))

    def window(flown: "Scenario") -> Window:
        return _window(flown, pixels, None)

    def fly(kite: str, lessons: bool, child: "Child", kept: Kept) -> int:
        return _fly(asking(kite, lessons), child, kept)

    def passed() -> tuple[int, int]:
        keys = [lesson.key for lesson in LESSONS]
        return len(read_progress().passed.intersection(keys)), len(keys)

    sound = settings_or_defaults()[0].sound
    return Home(Doors(scenario, window, fly, passed), args.kite, pixels, sound, args.quality).run(
        launched
    )


def _fly(args: argparse.Namespace, launched: "Child", kept: "Kept | None" = None) -> int:
    """Flies, and tells of it; returns the exit status, NOT_WRITTEN for a recording cut short.

    `launched`: the flight's process; `kept`: what is there before and after this flight.
    """
    import pygame

    from kitemj.cockpit.filming import FilmStyle, check_output
    from kitemj.cockpit.flight_film import film_of_flight, recorded
    from kitemj.cockpit.screens import display_found
    from kitemj.pilots.progress import write_progress
    from kitemj.realtime.process import FlightProcess
    from kitemj.recording.recorder import timestamped_name

    setup, style = _setup(args), FilmStyle(size(args.size), args.view)
    if args.duration is not None and not args.duration > 0:
        raise InputError(f"--duration must be > 0 s, got {args.duration} s")
    programme, window = _programme(args, setup.scenario), not args.headless and display_found()
    film, stays = args.film, setup.record is not None
    if not window:
        unnamed = timestamped_name() if args.record else setup.record or timestamped_name()
        film = film or unnamed.with_suffix(".mp4")
        style = style._replace(title=_title(setup.scenario))
    if film:
        check_output(film, style, still=False, overwrite=args.overwrite)
    course = _course(args) if window else None
    with recorded(setup) if film else nullcontext(setup) as setup:
        physics = FlightProcess(setup, launched)
        try:
            if window:
                summary = _fly_in_window(args, setup.scenario, physics, programme, course, kept)
            else:
                summary = _fly_unseen(args, setup.scenario, physics, programme, film)
            print(summary if stays else replace(summary, recording="none"))
        except (FlightError, OSError):  # why it ended is told last
            print(f"recording    {physics.recording if stays else 'none'}")
            raise
        finally:
            if course:
                print(write_progress(course.passed) or f"lessons      {len(course.passed)} passed")
            if film and setup.record and physics.started:
                pygame.display.quit()  # nobody would answer in that window
                told = film_of_flight(setup.record, film, style, args.overwrite, stays)
                print(f"film         {told}")
    return NOT_WRITTEN if physics.cut else 0


def _fly_in_window(
    args: argparse.Namespace,
    scenario: "Scenario",
    physics: "FlightProcess",
    programme: "Stick | None",
    course: "Course | None",
    kept: "Kept | None",
) -> "Summary":
    """The flight of a person, or of a programme for a person to see."""
    from kitemj.cockpit.fly import fly
    from kitemj.cockpit.screens import fitting
    from kitemj.drawing.picture import Picture

    pixels = fitting(size(args.size))
    own = nullcontext(kept.picture) if kept else Picture(scenario.parameters, *pixels, args.quality)
    with own as picture:
        physics.wait()
        screen = _window(scenario, pixels, programme, args.assist, course)
        screen.wishes.view = args.view
        if kept:
            screen.wishes.sound = kept.sound
        try:
            called = None if kept else args.called
            return fly(physics, picture, screen, args.duration, called, course)
        finally:
            if kept:
                kept.note(screen)


def _fly_unseen(
    args: argparse.Namespace,
    scenario: "Scenario",
    physics: "FlightProcess",
    programme: "Stick | None",
    film: Path,
) -> "Summary":
    """The flight of a programme, during which nothing is painted, so that nothing is late."""
    from kitemj.cockpit.fly import fly
    from kitemj.cockpit.screens import FRAME_RATE, Screen, Unattended
    from kitemj.controls.stick import show_of
    from kitemj.scene.gl import open_graphics

    open_graphics(16, 16).context.free()  # what cannot be painted is told before it is flown
    stick, duration = programme or show_of(scenario.parameters), args.duration or SHOW_DURATION
    guided = programme is None and scenario.pilot is not None
    who = "the autopilot" if guided else f"a {stick.name}"
    why = "as asked, no window" if args.headless else "there is no display"
    print(
        f"{why}: {who} flies {duration:g} s in real time; "
        f"then some {duration * FRAME_RATE:.0f} frames are painted into {film}"
    )
    physics.wait()
    screen = Unattended(stick) if guided else Screen(stick)
    return fly(physics, None, screen, duration, args.called)


def _title(scenario: "Scenario") -> str:
    """What a film is of, for those who did not see the flight."""
    parameters = scenario.parameters
    span, length = parameters.kite.span, parameters.lines.length
    return f"A {span:g} m kite on {length:g} m lines, {parameters.wind.speed:g} m/s of wind"


def _setup(args: argparse.Namespace) -> "FlightSetup":
    """What is to be flown, and recorded where."""
    from kitemj.dynamics.formulation import check_model
    from kitemj.recording.file import read_recording
    from kitemj.recording.live import FlightSetup
    from kitemj.recording.resume import resume_point

    if args.past is None and args.at is not None:
        raise InputError("--at needs --from RECORDING, whose time it is")
    if args.past is not None and args.scenario is not None:
        raise InputError("--from goes on with the recording's own scenario: leave the other out")
    check_model(args.model, args.step)
    record = _record(args)
    if args.past is not None:
        setup = resume_point(read_recording(args.past), args.at)
    else:
        setup = FlightSetup(_scenario(args), args.model, step=args.step)
    reference = setup.reference or "lagrange"
    return setup._replace(reference=reference, record=record, overwrite=args.overwrite)


def _record(args: argparse.Namespace) -> Path | None:
    """Where the recording goes; where the present folder cannot be written, there is none."""
    from kitemj.files import check_new
    from kitemj.recording.recorder import timestamped_name

    if args.no_record:
        return None
    path: Path = args.record or timestamped_name()
    try:
        check_new(path, args.overwrite)
    except InputError as error:
        if args.record:
            raise
        print(f"this flight is not recorded: {error}")
        return None
    return path


def _programme(args: argparse.Namespace, scenario: "Scenario") -> "Stick | None":
    """The table or the pilot that flies, if there is one."""
    from kitemj.controls.programmed import read_programmed_stick
    from kitemj.controls.stick import PilotStick
    from kitemj.pilots.manoeuvres import turns
    from kitemj.pilots.registry import as_pilot

    if args.assist and (args.pilot or args.stick):
        raise InputError("--assist helps a person: leave out --pilot or --stick")
    if args.assist and not turns(scenario.parameters):
        raise InputError("--assist is for kites that turn, and this one drifts: leave it out")
    if args.pilot and args.stick:
        raise InputError("--pilot and --stick both want the stick: give one of them")
    if args.pilot:
        return PilotStick(as_pilot(args.pilot))
    return read_programmed_stick(args.stick, scenario.parameters) if args.stick else None


def _window(
    scenario: "Scenario",
    pixels: tuple[int, int],
    stick: "Stick | None",
    assist: bool | None = None,
    course: "Course | None" = None,
) -> "Window":
    """A window for a person, with what they have set; `stick` flies in their place."""
    from kitemj.cockpit.screens import Window
    from kitemj.controls.settings import settings_or_defaults
    from kitemj.controls.stick import PersonStick

    settings, complaint = settings_or_defaults()
    person = PersonStick(settings, scenario.parameters)
    if assist is not None:
        person.assist = assist
    elif course and settings.assist == "lessons":
        person.assist = True
    if complaint:
        person.notices.say(complaint, LONG)
    window = Window(*pixels, f"kitemj: {scenario.source}", person, stick)
    window.wishes.sound = settings.sound
    return window


def _scenario(args: argparse.Namespace) -> "Scenario":
    """The scenario of the file, or the kite in its own wind; with the arms that are asked for."""
    from kitemj.data_files import SCENARIOS, shipped_or_file
    from kitemj.flight.reach import reach
    from kitemj.flight.scenario import read_scenario, scenario_of
    from kitemj.physics.parameter_files import read_toml

    if args.scenario is not None:
        scenario = read_scenario(args.scenario)
    elif args.kite.endswith(".toml"):
        path = shipped_or_file(args.kite, SCENARIOS)
        scenario = scenario_of({"duration": 60.0} | read_toml(path), args.kite)
    else:
        scenario = scenario_of({"set": args.kite, "duration": 60.0}, f"the kite {args.kite}")
    if args.arm is None:
        return scenario
    stick = scenario.parameters.stick
    stick = stick._replace(arm=args.arm, delta=reach(scenario.parameters, args.arm))
    return replace(scenario, parameters=scenario.parameters._replace(stick=stick))


def _course(args: argparse.Namespace) -> "Course | None":
    """The lessons that are not passed yet, on the kite for which they are written."""
    from kitemj.physics.parameter_files import parameter_set
    from kitemj.pilots.course import Course
    from kitemj.pilots.progress import read_progress

    if args.no_lessons or args.scenario or args.past or args.kite != LEARNT_ON:
        return None
    course = Course(parameter_set(LEARNT_ON), () if args.lessons else read_progress().passed)
    return course if course.lesson else None
