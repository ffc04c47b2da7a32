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
    add_step,
    size,
)
from kitemj.errors import NOT_WRITTEN, FlightError, InputError

if TYPE_CHECKING:
    from kitemj.cockpit.fly import Summary
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

SHOW_DURATION = 20.0
"""s; of a flight that nobody watches."""
LONG = 20.0
"""s; for a sentence that must not be missed."""


def add(parser: Parser) -> None:
    """Adds its arguments."""
    parser.add_argument("scenario", type=Path, nargs="?", help=SCENARIO)
    says = "without a scenario: sport, thesis, laksa, or a TOML file that changes one of them"
    parser.add_argument("--kite", default="sport", metavar="SET", help=says)
    parser.add_argument("--arm", type=float, metavar="M", help="arms of so much, which limits δ")
    parser.add_argument("--stick", type=Path, metavar="FILE.csv", help="a table flies, nobody else")
    add_pilot(parser)
    says = "go on from its last flight"
    parser.add_argument("--from", dest="past", type=Path, metavar="RECORDING", help=says)
    parser.add_argument("--at", type=float, metavar="S", help="from this time of it; its end")
    parser.add_argument("--lessons", action="store_true", help="all lessons, passed or not")
    parser.add_argument("--no-lessons", action="store_true", help="none")
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
    add_step(parser)


def run(args: argparse.Namespace) -> int:
    """Flies, and tells of it; returns the exit status, NOT_WRITTEN for a recording cut short."""
    from kitemj.realtime.launch import launch

    launched = launch()
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
    film, kept = args.film, setup.record is not None
    if not window:
        film = film or (setup.record or timestamped_name()).with_suffix(".mp4")
    if film:
        check_output(film, style, still=False, overwrite=args.overwrite)
    course = _course(args) if window else None
    if course:  # its own start is the second one
        setup = setup._replace(other_starts=course.starts, start=int(course.start is not None))
    with recorded(setup) if film else nullcontext(setup) as setup:
        physics = FlightProcess(setup, launched)
        try:
            if window:
                summary = _fly(args, setup.scenario, physics, programme, course)
            else:
                summary = _show(args, setup.scenario, physics, programme, film)
            print(summary if kept else replace(summary, recording="none"))
        except (FlightError, OSError):  # why it ended is told last
            print(f"recording    {physics.recording if kept else 'none'}")
            raise
        finally:
            if course:
                print(write_progress(course.passed) or f"lessons      {len(course.passed)} passed")
            if film and setup.record and physics.started:
                told = film_of_flight(setup.record, film, style, args.overwrite, kept)
                print(f"film         {told}")
    return NOT_WRITTEN if physics.cut else 0


def _fly(
    args: argparse.Namespace,
    scenario: "Scenario",
    physics: "FlightProcess",
    programme: "Stick | None",
    course: "Course | None",
) -> "Summary":
    """The flight of a person in a window, or of a programme for a person to see."""
    from kitemj.cockpit.fly import fly
    from kitemj.cockpit.screens import fitting
    from kitemj.drawing.picture import Picture

    pixels = fitting(size(args.size))
    with Picture(scenario.parameters, *pixels) as picture:
        physics.wait()
        screen = _window(scenario, pixels, programme)
        screen.wishes.view = args.view
        return fly(physics, picture, screen, args.duration, args.called, course)


def _show(
    args: argparse.Namespace,
    scenario: "Scenario",
    physics: "FlightProcess",
    programme: "Stick | None",
    film: Path,
) -> "Summary":
    """The flight of a programme that nobody sees: nothing is painted, so that nothing is late."""
    from kitemj.cockpit.fly import fly
    from kitemj.cockpit.screens import FRAME_RATE, Screen
    from kitemj.controls.stick import show_of
    from kitemj.scene.gl import open_graphics

    open_graphics(16, 16).context.free()  # what cannot be painted is told before it is flown
    stick, duration = programme or show_of(scenario.parameters), args.duration or SHOW_DURATION
    why = "as asked, no window" if args.headless else "there is no display"
    print(
        f"{why}: a {stick.name} flies {duration:g} s in real time; "
        f"then some {duration * FRAME_RATE:.0f} frames are painted into {film}"
    )
    physics.wait()
    return fly(physics, None, Screen(stick), duration, args.called)


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
    from kitemj.pilots.registry import as_pilot

    if args.pilot and args.stick:
        raise InputError("--pilot and --stick both want the stick: give one of them")
    if args.pilot:
        return PilotStick(as_pilot(args.pilot))
    return read_programmed_stick(args.stick, scenario.parameters) if args.stick else None


def _window(scenario: "Scenario", pixels: tuple[int, int], stick: "Stick | None") -> "Window":
    """A window for a person, with what they have set; `stick` flies in their place."""
    from kitemj.cockpit.screens import Window
    from kitemj.controls.settings import settings_or_defaults
    from kitemj.controls.stick import PersonStick

    settings, complaint = settings_or_defaults()
    person = PersonStick(settings, scenario.parameters)
    if complaint:
        person.notices.say(complaint, LONG)
    return Window(*pixels, f"kitemj: {scenario.source}", person, stick)


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

    if args.no_lessons or args.scenario or args.past or args.kite != "sport":
        return None
    course = Course(parameter_set("sport"), () if args.lessons else read_progress().passed)
    return course if course.lesson else None
