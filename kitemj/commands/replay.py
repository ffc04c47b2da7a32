"""`kitemj replay`: a recording, looked at again, flown again, exported."""

import argparse
from pathlib import Path

from kitemj.commands.arguments import MODELS, Parser, add_picture, size
from kitemj.controls.actions import REPLAY_HELP
from kitemj.errors import InputError, NothingFound

HELP = "show a recording in a window, fly its input again, or export it"
EXAMPLE = "kitemj replay kitemj-20260131-120000.arrows --model lagrange"
NOTES = "\n".join(f"{shown:21} {says}" for shown, says in (x.split("\t") for x in REPLAY_HELP))


def add(parser: Parser) -> None:
    """Adds its arguments."""
    says = "a recording (*.arrows); without, the last flight in this folder"
    parser.add_argument("recording", type=Path, nargs="?", help=says)
    parser.add_argument("--model", help=f"fly its input through one of {', '.join(MODELS)}")
    says = "with --model: its autopilot flies again, by what it sees of that model"
    parser.add_argument("--closed-loop", action="store_true", help=says)
    says = "longest step [s] of --model; as recorded"
    parser.add_argument("--step", type=float, metavar="S", help=says)
    parser.add_argument("--export", choices=("csv",), help="write the table instead of showing it")
    parser.add_argument("--output", type=Path, metavar="FILE.csv", help="name of that table")
    parser.add_argument("--overwrite", action="store_true", help="replace FILE.csv if it exists")
    parser.add_argument("--headless", action="store_true", help="print only, open no window")
    add_picture(parser)


def run(args: argparse.Namespace) -> None:
    """Exports the recording, or flies it again where that is asked for, and shows it."""
    from kitemj.recording.export import write_table
    from kitemj.recording.file import read_recording
    from kitemj.recording.replay import replay
    from kitemj.recording.summary import comparison

    pixels = size(args.size)
    recording = read_recording(args.recording or _last())
    if args.export:
        path = args.output or recording.path.with_suffix(".csv")
        write_table(path, recording, args.overwrite)
        print(f"{path}: {len(recording)} rows")
        return
    if args.closed_loop and not args.model:
        raise InputError("--closed-loop needs a model that flies: name it with --model")
    again = replay(recording, args.model, args.step, args.closed_loop) if args.model else None
    if again:
        print(comparison(again))
    if args.headless:
        return
    from kitemj.cockpit.screens import display_found

    if not display_found():
        print(f"there is no display; film it: kitemj film {recording.path} --output FILE.mp4")
        return
    from kitemj.cockpit.replay_window import show

    show(recording, again, pixels, args.view)


def _last() -> Path:
    """The last flight in the present folder; NothingFound where there is none."""
    from kitemj.recording.recorder import latest

    path = latest()
    if path is None:
        raise NothingFound("there is no kitemj-*.arrows in this folder: fly, or name a recording")
    return path
