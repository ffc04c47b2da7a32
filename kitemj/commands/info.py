"""`kitemj info`: what a recording holds."""

import argparse
from pathlib import Path

from kitemj.commands.arguments import Parser, add_json, command


def add(commands: "argparse._SubParsersAction[Parser]") -> None:
    """Adds the subcommand to the others."""
    parser = command(
        commands,
        "info",
        "print what a recording holds, how it ended and where it left the limits of validity",
        "kitemj info kitemj-20260131-120000.arrows",
    )
    parser.add_argument("recording", type=Path, help="a recording (*.arrows)")
    add_json(parser)
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    """Returns the exit status."""
    from kitemj.recording.file import read_recording
    from kitemj.recording.summary import facts, summary
    from kitemj.tables import json_text

    recording = read_recording(args.recording)
    print(json_text([], facts(recording)) if args.json else summary(recording))
    return 0
