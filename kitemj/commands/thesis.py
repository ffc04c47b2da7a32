"""`kitemj thesis`: what the source thesis measured and drew, made again."""

import argparse
import sys
from pathlib import Path

from kitemj.commands.arguments import Parser, command
from kitemj.errors import InputError

SCRIPTS = Path(__file__).parents[2] / "scripts"
"""Of the checkout: the report is no part of the installed package."""


def add(commands: "argparse._SubParsersAction[Parser]") -> None:
    """Adds the subcommand to the others."""
    parser = command(
        commands,
        "thesis",
        "compute and draw again what the source thesis did, and write a report beside it",
        "kitemj thesis --output report",
    )
    parser.add_argument(
        "--output", type=Path, required=True, metavar="DIR", help="a new folder; see its index.html"
    )
    parser.add_argument(
        "--overwrite",
        action="store_true",
        help="replace the report's files in a folder that exists; others are kept",
    )
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    """Writes the report; returns the exit status."""
    if not (SCRIPTS / "thesis" / "report.py").is_file():
        raise InputError(
            "the report is made in the repository, of which this installation has no copy: "
            "clone it, and run .venv/bin/kitemj thesis there"
        )
    sys.path.insert(0, str(SCRIPTS))
    from thesis.folder import check_folder

    check_folder(args.output, args.overwrite)
    try:
        from thesis import report
    except ModuleNotFoundError as missing:
        raise InputError(
            f"the report needs the package {missing.name}, which is not installed with kitemj: "
            f"pip install {missing.name}"
        ) from None
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn

    columns = (
        MofNCompleteColumn(),
        BarColumn(),
        TimeElapsedColumn(),
        TextColumn("{task.description}"),
    )
    with Progress(*columns, console=Console(stderr=True), transient=True) as progress:
        task = progress.add_task("", total=len(report.SECTIONS))

        def tell(name: str, done: int) -> None:
            progress.update(task, description=name, completed=done)

        sections = report.write_report(args.output, args.overwrite, report.SECTIONS, tell)
    print(f"{args.output / 'index.html'}: {len(sections)} sections")
    return 0
