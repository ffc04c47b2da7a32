"""`kitemj info`: what a recording holds."""

import argparse
from pathlib import Path

from kitemj.commands.arguments import Parser, add_json

HELP = "print what a recording holds, how it ended and where it left the limits of validity"
EXAMPLE = "kitemj info kitemj-20260131-120000.arrows"


def add(parser: Parser) -> None:
    """Adds its arguments."""
    parser.add_argument("recording", type=Path, help="a recording (*.arrows)")
    add_json(parser)


def run(args: argparse.Namespace) -> None:
    """Prints it."""
    from kitemj.recording.file import read_recording
    from kitemj.recording.summary import facts, summary
    from kitemj.tables import json_text

    recording = read_recording(args.recording)
    print(json_text([], facts(recording)) if args.json else summary(recording))
