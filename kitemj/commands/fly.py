"""`kitemj fly`: a person, a stick, a kite."""

import argparse
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING

from kitemj.commands.words import MODELS, Parser, add_picture, add_step, command, size
from kitemj.errors import InputError

if TYPE_CHECKING:
    from kitemj.cockpit.stick import Stick
    from kitemj.flight.live import LiveFlight
    from kitemj.flight.scenario import Scenario
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
        "--kite", default="sport", metavar="SET", help="without a scenario: sport, thesis or laksa"
    )
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
    from kitemj.cockpit.screens import FilmScreen, Screen, Window, display_found
    from kitemj.flight.live import LiveFlight
    from kitemj.flight.output import check_new

    pixels, scenario = size(words.size), _scenario(words.scenario, words.kite)
    if words.duration is not None and not words.duration > 0:
        raise InputError(f"--duration must be > 0 s, got {words.duration} s")
    if words.record:
        check_new(words.record, words.overwrite)
    path, duration = None, words.duration
    if words.headless or not display_found():
        path, duration = _film_path(words), duration or SHOW_DURATION
        why = "as asked, no window" if words.headless else "there is no display"
        print(f"{why}: a programme flies {duration:g} s in real time into {path}")
    flight = LiveFlight(scenario, words.model, step=words.step)
    with Picture(scenario.parameters, *pixels) as picture:
        screen: Screen = (
            FilmScreen(path, *pixels, _show(scenario), words.overwrite)
            if path
            else Window(*pixels, f"kitemj: {scenario.source}")
        )
        screen.wishes.view = words.view
        recorder = _recorder(words, flight)
        print(fly(flight, picture, screen, duration, words.called, recorder))
    if path:
        print(f"film         {path}")
    return 0


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


def _scenario(path: Path | None, kite: str) -> "Scenario":
    """The scenario of the file, or the named kite in its own wind."""
    from kitemj.flight.scenario import read_scenario, scenario_of

    if path is not None:
        return read_scenario(path)
    return scenario_of({"set": kite, "duration": 60.0}, f"the kite {kite}")


def _show(scenario: "Scenario") -> "Stick":
    """Who flies where nobody can: eights with a kite that turns, else a table of the stick.

    A kite turns where its nose follows its motion: C_nβ > 0.
    """
    from kitemj.cockpit.stick import SHOW, PilotStick
    from kitemj.flight.pilots import Eight

    turns = getattr(scenario.parameters.aero, "Cn_beta", 0.0) > 0
    return PilotStick(Eight()) if turns else SHOW
