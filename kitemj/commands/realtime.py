"""`kitemj realtime`: how well this machine flies in real time."""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from kitemj.commands.arguments import Parser, add_picture, add_quality, add_step, size
from kitemj.controls.actions import DEPTHS
from kitemj.errors import InputError

if TYPE_CHECKING:
    from kitemj.cockpit.fly import Summary
    from kitemj.cockpit.measuring import Step, TimedScreen
    from kitemj.cockpit.screens import Screen
    from kitemj.physics.parameters import Parameters
    from kitemj.tables import Cell, Table

STICK_DURATION = 20.0
"""s; some 35 moves of the stick."""

HELP = "measure missed ticks, frames, memory, and how soon a move of the stick is flown and seen"
EXAMPLE = "kitemj realtime --duration 600"


def add(parser: Parser) -> None:
    """Adds its arguments."""
    parser.add_argument("--kite", default="sport", metavar="SET", help="a set: sport, trainer, ...")
    parser.add_argument("--duration", type=float, default=60.0, metavar="S", help="of the flight")
    parser.add_argument("--headless", action="store_true", help="paint, but open no window")
    parser.add_argument("--markdown", type=Path, metavar="FILE.md", help="also write the tables")
    says = "replace FILE.md if it exists"
    parser.add_argument("--overwrite", action="store_true", help=says)
    says = "how much is shown over the view, default pilot"
    parser.add_argument("--instruments", choices=DEPTHS, default=DEPTHS[0], help=says)
    add_quality(parser)
    add_picture(parser)
    add_step(parser)


def run(args: argparse.Namespace) -> None:
    """Flies, and prints what was measured."""
    from kitemj.realtime.launch import launch

    launched = launch()
    from kitemj.cockpit.fly import fly
    from kitemj.cockpit.measuring import TimedScreen, stick_steps
    from kitemj.cockpit.screens import display_found
    from kitemj.controls.stick import show_of
    from kitemj.drawing.picture import Picture
    from kitemj.files import check_new, new_file
    from kitemj.flight.scenario import scenario_of
    from kitemj.realtime.process import FlightProcess
    from kitemj.recording.live import FlightSetup
    from kitemj.tables import print_table, titled_markdown
    from kitemj.temporary import temporary_folder

    if not args.duration > 0:
        raise InputError(f"--duration must be > 0 s, got {args.duration} s")
    if args.markdown:
        check_new(args.markdown, args.overwrite)
    pixels = size(args.size)
    scenario = scenario_of({"set": args.kite, "duration": 60.0}, f"the kite {args.kite}")
    window = not args.headless and display_found()
    parameters = scenario.parameters
    setup, stick = FlightSetup(scenario, "mujoco", "lagrange", args.step), show_of(parameters)
    with temporary_folder() as folder:
        physics = FlightProcess(setup._replace(record=folder / "flight.arrows"), launched)
        with Picture(parameters, *pixels, args.quality) as picture:
            physics.wait()
            timed = TimedScreen(_screen(args, parameters, window), stick, physics)
            flown = fly(physics, picture, timed, args.duration, args.called)
            quality = picture.quality
            screen = _screen(args, parameters, window and display_found())
            steps = stick_steps(setup, picture, screen, STICK_DURATION)
    where = "in a window" if window else "painted, and shown to nobody"
    how = f"{args.size}, {where}, view and instruments {args.view} and {args.instruments}, recorded"
    tables = [_flight_table(flown, timed, how, quality), _stick_table(steps)]
    for table in tables:
        print_table(table)
    if args.markdown:
        with new_file(args.markdown, args.overwrite) as part:
            part.write_text(titled_markdown(tables), encoding="utf-8")


def _screen(args: argparse.Namespace, parameters: "Parameters", window: bool) -> "Screen":
    from kitemj.cockpit.screens import Screen, Window
    from kitemj.controls.settings import Settings
    from kitemj.controls.stick import PersonStick, PilotStick
    from kitemj.pilots.manoeuvres import Hold

    screen = Screen(PilotStick(Hold()))
    if window:
        person = PersonStick(Settings(), parameters)
        screen = Window(*size(args.size), "kitemj realtime", person)
    screen.wishes.view, screen.wishes.depth = args.view, args.instruments
    return screen


def _flight_table(flown: "Summary", timed: "TimedScreen", how: str, quality: str) -> "Table":
    from statistics import median

    from kitemj.tables import Cell, Table

    times = flown.times
    rows: list[tuple[Cell, ...]] = [
        ("ticks of 10 ms", times.ticks),
        ("missed: done after the next was due", times.missed),
        ("within a frame of 1/30 s [%]", 100.0 * (1 - times.late / max(times.ticks, 1))),
        ("worst lateness [ms]", 1e3 * times.worst),
        ("wall time not flown [s]", times.lost),
        ("frames a second, median", timed.median_rate),
        ("frames a second, in the slowest second", timed.slowest_rate),
        ("a frame took, median [ms]", 1e3 * median(timed.took)),
        ("quality of the picture", quality),
        ("first frame [s]", flown.first_frame),
        ("memory gained after 10 s, both processes [MB]", timed.growth),
        ("largest gap to the reference [µm]", 1e6 * times.largest_gap),
    ]
    return Table(f"{flown.flown:.0f} s of flight at {how}", ("what", "measured"), rows)


def _stick_table(steps: "list[Step]") -> "Table":
    from kitemj.tables import Table

    flown, shown = sum(step.ticks <= 1 for step in steps), sum(step.frames <= 1 for step in steps)
    seen = sorted(1e3 * step.seen_after for step in steps)
    rows: list[tuple[Cell, ...]] = [
        ("flown by the first tick after it was polled", f"{flown} of {len(steps)}"),
        ("seen in the first frame after it was polled", f"{shown} of {len(steps)}"),
        ("polled to seen, median [ms]", seen[len(seen) // 2] if seen else float("nan")),
        ("polled to seen, longest [ms]", seen[-1] if seen else float("nan")),
    ]
    return Table(f"{len(steps)} moves of the stick", ("what", "measured"), rows)
