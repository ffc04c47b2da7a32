"""`kitemj info`: what a recording holds."""

import argparse
from pathlib import Path

from kitemj.commands.arguments import Parser, command


def add(commands: "argparse._SubParsersAction[Parser]") -> None:
    """Adds the subcommand to the others."""
    parser = command(
        commands,
        "info",
        "print what a recording holds, how it ended and where it left the limits of validity",
        "kitemj info kitemj-20260131-120000.arrows",
    )
    parser.add_argument("recording", type=Path, help="a recording (*.arrows)")
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    """Returns the exit status."""
    from kitemj.recording.file import read_recording
    from kitemj.recording.summary import summary

    print(summary(read_recording(args.recording)))
    return 0
