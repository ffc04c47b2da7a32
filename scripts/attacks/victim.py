"""One run of the program under attack, in a process of its own, and the harm that it did."""

import multiprocessing
import os
import re
import resource
import signal
import sys
import tempfile
from collections.abc import Callable, Sequence
from functools import cache
from multiprocessing import forkserver
from pathlib import Path
from typing import NamedTuple

HARMS = ("traceback", "hang", "not finite", "file left", "file lost", "orphan", "wrong")
"""What may go wrong: `wrong` is a damage taken as sound, or a status that says something else."""
MEMORY = 8 << 30
"""Bytes that a run may ask for, so that the system never has to choose whom to kill."""
SECONDS = 60.0
"""How long a run may take before it counts as hung: 100 times what a short flight takes."""
UNFORESEEN = 70
"""The status of the last resort; the program must never need it."""


def _nothing() -> None:
    pass


class Attack(NamedTuple):
    """One hostile act: what, for people; `harm` does it in an empty folder and returns a harm.

    "" is none; otherwise one of `HARMS`, then, after ": ", the detail.
    """

    what: str
    harm: Callable[[Path], str]


class Run(NamedTuple):
    """How a run ended: exit status (negative: the signal), what it wrote, the processes left."""

    status: int
    out: str
    error: str
    hung: bool
    left: list[int]


class Outside(NamedTuple):
    """What surrounds a run: the streams' encoding, whether its reader is gone, the terminal."""

    encoding: str = "utf-8"
    closed: bool = False
    columns: int = 0
    """Of a terminal; 0: there is none."""
    before: Callable[[], object] = _nothing
    """Done in its process, right before the command."""


def run(
    words: Sequence[str], folder: Path, seconds: float = SECONDS, outside: Outside | None = None
) -> Run:
    """The program's command line, with `folder` as the current one and for temporary files."""
    out, error = folder.with_name(f"{folder.name}.out"), folder.with_name(f"{folder.name}.error")
    given = (list(words), folder, out, error, outside or Outside())
    process = _context().Process(target=_victim, args=given)
    process.start()
    process.join(seconds)
    hung = process.exitcode is None
    assert process.pid is not None
    if hung:
        os.kill(process.pid, signal.SIGKILL)
        process.join()
    left = session(process.pid)
    for pid in left:
        os.kill(pid, signal.SIGKILL)
    said, cried = (path.read_text("utf-8", "replace") for path in (out, error))
    out.unlink()
    error.unlink()
    return Run(process.exitcode or 0, said, cried, hung, left)


def warm() -> None:
    """Starts the process that all victims are forked from, which may have to compile formulas."""
    with tempfile.TemporaryDirectory(prefix="attack-") as parent:
        (folder := Path(parent) / "folder").mkdir()
        run(["--version"], folder, seconds=10 * SECONDS)


def harm_of(run: Run, allowed: Sequence[int] = (0, 1, 2)) -> str:
    """The harm that a run shows by itself; numbers are looked at where it ended with 0."""
    if run.hung:
        return "hang"
    if "Traceback" in run.error or "Traceback" in run.out or run.status == UNFORESEEN:
        return f"traceback: {run.error.strip().splitlines()[-1] if run.error.strip() else ''}"
    if run.status not in allowed:
        return f"wrong: status {run.status}, {run.error.strip()[-200:]}"
    if run.status == 0 and (found := re.search(r"(?<!\w)(nan|-?inf)(?!\w)", run.out, re.I)):
        return f"not finite: {found[0]}"
    return "orphan" if run.left else ""


def left_over(folder: Path, expected: Sequence[str]) -> str:
    """A harm where `folder` holds other files than `expected`, by name, and what tells of them."""
    names = {path.name for path in folder.iterdir()}
    told = {f"{name}-metadata.json" for name in expected if name.endswith(".csv")}
    if more := sorted(names - set(expected) - told):
        return f"file left: {', '.join(more)}"
    if fewer := sorted(set(expected) - names):
        return f"file lost: {', '.join(fewer)}"
    return ""


def session(leader: int) -> list[int]:
    """The processes that still live in the session of `leader`."""
    found = []
    for stat in Path("/proc").glob("[0-9]*/stat"):
        try:
            state, _, _, of = stat.read_text().rpartition(")")[2].split()[:4]
        except OSError:  # gone meanwhile
            continue
        if int(of) == leader and state not in "ZX":
            found.append(int(stat.parent.name))
    return found


@cache
def _context() -> multiprocessing.context.ForkServerContext:
    context = multiprocessing.get_context("forkserver")
    context.set_forkserver_preload(["attacks.warm"])
    before = os.environ.get("PYTHONPATH")
    os.environ["PYTHONPATH"] = os.pathsep.join(sys.path)  # it imports before it is told of ours
    forkserver.ensure_running()
    if before is None:
        del os.environ["PYTHONPATH"]
    else:
        os.environ["PYTHONPATH"] = before
    return context


def _victim(words: list[str], folder: Path, out: Path, error: Path, outside: Outside) -> None:
    os.setsid()
    for path, stream in ((out, 1), (error, 2)):
        os.dup2(os.open(path, os.O_WRONLY | os.O_CREAT | os.O_TRUNC), stream)
    if outside.closed:
        reader, writer = os.pipe()
        os.close(reader)
        os.dup2(writer, 1)
    sys.stdout = open(1, "w", encoding=outside.encoding, closefd=False)  # noqa: SIM115
    sys.stderr = open(2, "w", encoding=outside.encoding, closefd=False)  # noqa: SIM115
    if outside.columns:
        os.environ |= {"FORCE_COLOR": "1", "COLUMNS": str(outside.columns)}
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    os.environ["TMPDIR"] = str(folder)
    os.chdir(folder)
    from kitemj.cli import main

    outside.before()
    try:
        status = main(words)
    except SystemExit as ended:  # argparse's
        status = int(ended.code or 0)
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(status)
