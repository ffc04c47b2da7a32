"""`kitemj sweep`: a study, on every core or on a cluster."""

import argparse
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from kitemj.commands.arguments import Parser
from kitemj.console import complain
from kitemj.errors import InputError

if TYPE_CHECKING:
    from kitemj.studies.executors import StudyExecutor
    from kitemj.studies.journal import Journal

HELP = (
    "fly a study, thousands of flights, and write a table with a row for each; "
    "interrupted, the same command goes on where it was"
)
EXAMPLE = "kitemj sweep studies/wind_and_steering.toml --output study.parquet"

LONG = 3600.0
"""s; a study that seems to take longer is asked about."""
MANY = 100_000
"""Flights; so is one of more."""


def add(parser: Parser) -> None:
    """Adds its arguments."""
    says = "a study file (TOML), or the name of one that ships"
    parser.add_argument("study", type=Path, help=says)
    parser.add_argument("--output", type=Path, required=True, metavar="FILE.parquet")
    parser.add_argument("--overwrite", action="store_true", help="start anew, whatever there is")
    parser.add_argument("--processes", type=int, metavar="N", help="default: one for each core")
    parser.add_argument("--scheduler", metavar="tcp://HOST:PORT", help="fly on a Dask cluster")
    parser.add_argument("--yes", action="store_true", help="do not ask, however long it takes")


def run(args: argparse.Namespace) -> int:
    """Returns the exit status."""
    from kitemj.files import check_new, is_stream
    from kitemj.studies.journal import Journal, completed_by
    from kitemj.studies.study import read_study
    from kitemj.studies.sweep import StudyStopped, check

    study = read_study(args.study)
    check(study)
    if is_stream(args.output):
        raise InputError(
            f"{args.output} is a stream; a study needs a file, for the journal beside it"
        )
    if not args.overwrite and args.output.is_file() and completed_by(args.output, study):
        print(f"{args.output} is complete: {study.design.count} flights")
        return 0
    check_new(args.output, args.overwrite)
    journal = Journal(args.output, study, args.overwrite)
    try:
        with journal:
            _tell_of(journal)
            if journal.count < study.design.count:
                _fly(args, journal)
            failures = journal.write_table(args.output, args.overwrite)
    except KeyboardInterrupt:
        complain(f"interrupted; {_kept(journal)}")
        return 130
    except StudyStopped as error:
        complain(f"{error}; {_kept(journal)}")
        return 1
    except OSError as error:
        reason, path = error.strerror or str(error), error.filename or journal.path
        raise OSError(error.errno, f"{reason}; {_kept(journal)}", path) from error
    said = f"; {failures} could not be flown, see their reason" if failures else ""
    print(f"{args.output}: {study.design.count} flights{said}")
    return 0


def _tell_of(journal: "Journal") -> None:
    """Says what an earlier command left."""
    if journal.count:
        print(f"going on after {journal.count} of {len(journal.done)} flights")
    if journal.damaged:
        lines = "1 line" if journal.damaged == 1 else f"{journal.damaged} lines"
        print(f"{journal.path}: {lines} damaged; what they told of is flown again")


def _kept(journal: "Journal") -> str:
    """What is left of a study that broke off, and what to do."""
    if not journal.count:
        return "no flight was finished, nothing is left"
    safe = f"{journal.count} of {len(journal.done)} flights are safe in {journal.path}"
    return f"{safe}: the same command goes on"


def _fly(args: argparse.Namespace, journal: "Journal") -> None:
    from kitemj.progress_bar import progress_bar
    from kitemj.studies.executors import dask_executor, local_executor
    from kitemj.studies.sweep import sweep, tried_together

    on_cluster = args.scheduler is not None
    start = dask_executor(args.scheduler) if on_cluster else local_executor(args.processes)
    with start as executor:
        cost = tried_together(journal, executor)
        left = len(journal.done) - journal.count
        if left:
            _ask(left, cost * left / executor.workers, executor, args.yes)
            with progress_bar("flights", len(journal.done), journal.count) as tell:
                sweep(journal, executor, cost, tell)


def _ask(flights: int, seconds: float, executor: "StudyExecutor", yes: bool) -> None:
    """Raises InputError unless a person agrees to a study that is very long."""
    text = f"{flights} flights: about {_duration(seconds)} on {executor.name}"
    if yes or (seconds < LONG and flights < MANY):
        print(text)
    elif not sys.stdin.isatty():
        raise InputError(f"{text}; --yes if that is meant")
    elif input(f"{text}. Fly them? [y/N] ").strip().lower() not in ("y", "yes"):
        raise InputError("not flown; make the study smaller")


def _duration(seconds: float) -> str:
    for unit, size in (("days", 86400.0), ("h", 3600.0), ("min", 60.0)):
        if seconds >= 2 * size:
            return f"{seconds / size:.0f} {unit}"
    return f"{seconds:.0f} s"
