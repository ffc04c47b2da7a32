"""`kitemj thesis`: what the source thesis measured and drew, made again."""

import argparse
import sys
from pathlib import Path

from kitemj.commands.arguments import Parser
from kitemj.errors import InputError

HELP = "compute and draw again what the source thesis did, and write a report beside it"
EXAMPLE = "kitemj thesis --output report"

SCRIPTS = Path(__file__).parents[2] / "scripts"
"""Of the checkout: the report is no part of the installed package."""


def add(parser: Parser) -> None:
    """Adds its arguments."""
    says = "a new folder; see its index.html"
    parser.add_argument("--output", type=Path, required=True, metavar="DIR", help=says)
    says = "replace the report's files in a folder that exists; others are kept"
    parser.add_argument("--overwrite", action="store_true", help=says)


def run(args: argparse.Namespace) -> None:
    """Writes the report."""
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
        says = f"the report needs the package {missing.name}, which is not installed with kitemj"
        raise InputError(f"{says}: pip install {missing.name}") from None
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn

    name = TextColumn("{task.description}")
    columns = (MofNCompleteColumn(), BarColumn(), TimeElapsedColumn(), name)
    with Progress(*columns, console=Console(stderr=True), transient=True) as progress:
        task = progress.add_task("", total=len(report.SECTIONS))

        def tell(name: str, done: int) -> None:
            progress.update(task, description=name, completed=done)

        sections = report.write_report(args.output, args.overwrite, report.SECTIONS, tell)
    print(f"{args.output / 'index.html'}: {len(sections)} sections")
