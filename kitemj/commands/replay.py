"""`kitemj replay`: a recording, looked at again, flown again, exported."""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from kitemj.commands.arguments import MODELS, Parser, add_picture, command, size

if TYPE_CHECKING:
    from kitemj.recording.file import Recording
    from kitemj.recording.replay import Replay


def add(commands: "argparse._SubParsersAction[Parser]") -> None:
    """Adds the subcommand to the others."""
    parser = command(
        commands,
        "replay",
        "show a recording in a window, fly its input again, or export it",
        "kitemj replay kitemj-20260131-120000.arrows --model lagrange",
    )
    parser.epilog = (
        "Space: play and pause. Left/right: 1 s, with Shift one tick. Up/down: speed. V: view.\n"
        "Home/End: start and end. The slider answers to the mouse. Esc: leave.\n\n"
        f"{parser.epilog}"
    )
    parser.add_argument("recording", type=Path, help="a recording (*.arrows)")
    parser.add_argument("--model", help=f"fly its input through one of {', '.join(MODELS)}")
    parser.add_argument(
        "--step", type=float, metavar="S", help="longest step [s] of --model; as recorded"
    )
    parser.add_argument("--export", choices=("csv",), help="write the table instead of showing it")
    parser.add_argument("--output", type=Path, metavar="FILE.csv", help="name of that table")
    parser.add_argument("--overwrite", action="store_true", help="replace FILE.csv if it exists")
    parser.add_argument("--headless", action="store_true", help="print only, open no window")
    add_picture(parser)
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    """Returns the exit status."""
    from kitemj.recording.file import read_recording

    pixels = size(args.size)
    recording = read_recording(args.recording)
    if args.export:
        return _export(args, recording)
    again = _replay(args, recording) if args.model else None
    if args.headless:
        return 0
    return _show(args, recording, again, pixels)


def _export(args: argparse.Namespace, recording: "Recording") -> int:
    from kitemj.recording.export import write_table

    path = args.output or args.recording.with_suffix(".csv")
    write_table(path, recording, args.overwrite)
    print(f"{path}: {len(recording)} rows")
    return 0


def _replay(args: argparse.Namespace, recording: "Recording") -> "Replay":
    """Flies the recorded input through ``--model`` and prints how far apart both are."""
    from kitemj.recording.replay import replay
    from kitemj.recording.summary import comparison

    again = replay(recording, args.model, args.step)
    print(comparison(again))
    return again


def _show(
    args: argparse.Namespace,
    recording: "Recording",
    again: "Replay | None",
    pixels: tuple[int, int],
) -> int:
    from kitemj.cockpit.screens import display_found

    if not display_found():
        print(f"there is no display; film it: kitemj film {args.recording} --output FILE.mp4")
        return 0
    from kitemj.cockpit.replay_window import show

    show(recording, again, pixels, args.view)
    return 0
