"""`kitemj fly`: a person, a stick, a kite."""

import argparse
from dataclasses import replace
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING

from kitemj.commands.words import MODELS, Parser, add_picture, add_step, command, size
from kitemj.errors import InputError

if TYPE_CHECKING:
    from kitemj.cockpit.screens import Screen
    from kitemj.flight.course import Course
    from kitemj.flight.live import LiveFlight
    from kitemj.flight.scenario import Scenario
    from kitemj.recording.going_on import Flown
    from kitemj.recording.recorder import Recorder

SHOW_DURATION = 20.0
"""s; of a flight that nobody watches."""


def add(commands: "argparse._SubParsersAction[Parser]") -> None:
    """Adds the subcommand to the others."""
    parser = command(
        commands,
        "fly",
        "fly in real time with a gamepad, the keys or the mouse; with no display, film a show",
        "kitemj fly scenarios/steer_80m.toml",
    )
    parser.epilog = (
        "Left stick, arrow keys or A/D, or the mouse with its button held: the lines.\n"
        "W/S or the right stick: let out and take in. F1 shows all keys, Esc leaves.\n\n"
        f"{parser.epilog}"
    )
    parser.add_argument("scenario", type=Path, nargs="?", help="a scenario file (TOML)")
    parser.add_argument(
        "--kite",
        default="sport",
        metavar="SET",
        help="without a scenario: sport, thesis, laksa, or a TOML file that changes one of them",
    )
    parser.add_argument("--arm", type=float, metavar="M", help="arms of so much, which limits δ")
    parser.add_argument("--stick", type=Path, metavar="FILE.csv", help="a table flies, nobody else")
    parser.add_argument(
        "--from", dest="past", type=Path, metavar="RECORDING", help="go on from its last flight"
    )
    parser.add_argument("--at", type=float, metavar="S", help="from this time of it; its end")
    parser.add_argument("--lessons", action="store_true", help="all lessons, passed or not")
    parser.add_argument("--no-lessons", action="store_true", help="none")
    parser.add_argument("--duration", type=float, metavar="S", help="leave after S seconds")
    parser.add_argument("--headless", action="store_true", help="film a show, open no window")
    parser.add_argument("--film", type=Path, metavar="FILE.mp4", help="name of that film")
    parser.add_argument("--record", type=Path, metavar="FILE", help="name of the recording")
    parser.add_argument("--overwrite", action="store_true", help="replace these if they exist")
    parser.add_argument("--no-record", action="store_true", help="leave no recording")
    parser.add_argument("--model", default="mujoco", help=f"one of {', '.join(MODELS)}")
    add_picture(parser)
    add_step(parser)
    parser.set_defaults(run=run)


def run(words: argparse.Namespace) -> int:
    """Returns the exit status."""
    from kitemj.cockpit.fly import fly
    from kitemj.cockpit.picture import Picture
    from kitemj.cockpit.screens import display_found
    from kitemj.flight.output import check_new

    pixels = size(words.size)
    flight, past = _flight(words)
    if words.duration is not None and not words.duration > 0:
        raise InputError(f"--duration must be > 0 s, got {words.duration} s")
    if words.record:
        check_new(words.record, words.overwrite)
    path, duration = None, words.duration
    if words.headless or not display_found():
        path, duration = _film_path(words), duration or SHOW_DURATION
        why = "as asked, no window" if words.headless else "there is no display"
        print(f"{why}: a programme flies {duration:g} s in real time into {path}")
    with Picture(flight.parameters, *pixels) as picture:
        course, screen = None, _screen(words, flight, path, pixels)
        if not path:
            course = _course(words, flight)
        screen.wishes.view = words.view
        recorder = _recorder(words, flight)
        print(fly(flight, picture, screen, duration, words.called, recorder, past, course))
    if path:
        print(f"film         {path}")
    return 0


def _screen(
    words: argparse.Namespace, flight: "LiveFlight", path: Path | None, pixels: tuple[int, int]
) -> "Screen":
    """A film at `path`, else a window."""
    from kitemj.cockpit.programmed import read_programmed_stick
    from kitemj.cockpit.screens import FilmScreen, Window
    from kitemj.cockpit.settings import settings_or_defaults
    from kitemj.cockpit.shows import show_of
    from kitemj.cockpit.stick import PersonStick

    parameters = flight.parameters
    programme = read_programmed_stick(words.stick, parameters) if words.stick else None
    if path:
        return FilmScreen(path, *pixels, programme or show_of(parameters), words.overwrite)
    settings, complaint = settings_or_defaults()
    person = PersonStick(settings, parameters)
    if complaint:
        person.notices.say(complaint)
    return Window(*pixels, f"kitemj: {flight.scenario.source}", person, programme)


def _recorder(words: argparse.Namespace, flight: "LiveFlight") -> "Recorder | None":
    """What records the flight; where the present folder cannot be written, nothing does."""
    from kitemj.recording.header import header_of
    from kitemj.recording.recorder import Recorder, moment_name

    if words.no_record:
        return None
    try:
        path = words.record or moment_name()
        return Recorder(path, header_of(flight), flight.parameters, words.overwrite)
    except InputError as error:
        if words.record:
            raise
        print(f"this flight is not recorded: {error}")
        return None


def _film_path(words: argparse.Namespace) -> Path:
    """The name asked for, or one of the present moment; InputError where it cannot be."""
    from kitemj.flight.output import check_new

    path: Path = words.film or Path(f"kitemj-{datetime.now():%Y%m%d-%H%M%S}.mp4")
    check_new(path, words.overwrite)
    return path


def _scenario(words: argparse.Namespace) -> "Scenario":
    """The scenario of the file, or the kite in its own wind; with the arms that are asked for."""
    from kitemj.flight.reach import reach
    from kitemj.flight.scenario import read_scenario, scenario_of
    from kitemj.physics.parameter_files import read_toml

    if words.scenario is not None:
        scenario = read_scenario(words.scenario)
    elif words.kite.endswith(".toml"):
        scenario = scenario_of({"duration": 60.0} | read_toml(Path(words.kite)), words.kite)
    else:
        scenario = scenario_of({"set": words.kite, "duration": 60.0}, f"the kite {words.kite}")
    if words.arm is None:
        return scenario
    stick = scenario.parameters.stick
    stick = stick._replace(arm=words.arm, delta=reach(scenario.parameters, words.arm))
    return replace(scenario, parameters=scenario.parameters._replace(stick=stick))


def _flight(words: argparse.Namespace) -> "tuple[LiveFlight, list[Flown]]":
    """The flight, and what of it is past already."""
    from kitemj.flight.live import LiveFlight
    from kitemj.recording.file import read_recording
    from kitemj.recording.going_on import past_of

    if words.past is None:
        if words.at is not None:
            raise InputError("--at needs --from RECORDING, whose time it is")
        return LiveFlight(_scenario(words), words.model, step=words.step), []
    if words.scenario is not None:
        raise InputError("--from goes on with the recording's own scenario: leave the other out")
    return past_of(read_recording(words.past), words.at)


def _course(words: argparse.Namespace, flight: "LiveFlight") -> "Course | None":
    """The lessons that are not passed yet; they are written for the kite `sport`."""
    return None
