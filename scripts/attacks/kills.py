"""Every command, ended by a signal at the start, in the middle and near its end.

Afterwards no process and no file is left that was not asked for, what was recorded can be read,
and what could be completed is complete. The moment is told by the processor's time, which
depends little on what else the machine does. Each run is a program of its own, as a person's.
"""

import os
import signal
import subprocess
import sys
import time
from contextlib import suppress
from functools import partial
from pathlib import Path
from typing import NamedTuple

import av

from attacks.victim import SECONDS, Attack, Run, harm_of, left_over, session
from kitemj.errors import InputError
from kitemj.recording.file import read_recording

ROOT = Path(__file__).parents[2]
SCENARIO = str(ROOT / "scenarios" / "loops_20m.toml")
STUDY = f"""\
scenario = {SCENARIO!r}
[grid]
"wind.speed" = {{ from = 5.0, to = 6.0, count = 40 }}
"""
INPUTS = ("study.toml", "flown.arrows")
SMALL = ("--size", "320x180")
FLY = ("fly", "--headless", "--film", "a.mp4", "--record", "a.arrows", "--duration", "3", *SMALL)
TABLE = ("a.csv", "a.csv-metadata.json")
SWEEP = ("sweep", "study.toml", "--output", "a.parquet", "--processes", "2")


class Command(NamedTuple):
    """Words, the processor's time [s] that they take, what may be there after, how they end."""

    words: tuple[str, ...]
    time: float
    files: tuple[str, ...] = ()
    status: int = 0


COMMANDS = (
    Command(("simulate", SCENARIO, "--output", "a.csv"), 1.5, TABLE),
    Command(("compare", SCENARIO, "--markdown", "a.md"), 6.0, ("a.md",)),
    Command(("film", SCENARIO, "--output", "a.mp4", "--speed", "0.25", *SMALL), 6.0, ("a.mp4",)),
    Command(("film", SCENARIO, "--still", "1", "--output", "a.png"), 4.0, ("a.png",)),
    Command(FLY, 5.0, ("a.mp4", "a.arrows")),
    Command(("realtime", "--headless", "--duration", "2", *SMALL), 6.0),
    Command(("replay", "flown.arrows", "--export", "csv", "--output", "a.csv"), 1.2, TABLE),
    Command(("replay", "flown.arrows", "--model", "lagrange", "--headless"), 1.6),
    Command(("info", "flown.arrows"), 1.2),
    Command(("plot", "flown.arrows", "--save", "a.pdf"), 4.5, ("a.pdf",)),
    Command(("limits", "flown.arrows", "--output", "a.csv"), 1.2, TABLE),
    Command(("trim", SCENARIO, "--save", "a.pdf"), 3.0, ("a.pdf",)),
    Command(("stability", SCENARIO, "--save", "a.pdf"), 3.0, ("a.pdf",)),
    Command(SWEEP, 4.0, ("a.parquet", "a.parquet.journal")),
    Command(("reach",), 1.2),
    Command(("pad", "--show"), 1.5, status=2),  # there is none
    Command(("thesis", "--output", "report"), 60.0, ("report",)),
)
SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGKILL)
MOMENTS = (0.15, 0.5, 0.85)
"""Of a command's time."""
GRACE = 15.0
"""s; for children to notice: a process that began to compile notices when that is done."""
SHARED = Path("/dev/shm")


def attacks() -> list[Attack]:
    """Each command by each signal at each moment."""
    return [
        Attack(
            f"{command.words[0]}: {number.name} at {part:g}", partial(_kill, command, number, part)
        )
        for command in COMMANDS
        for number in SIGNALS
        for part in MOMENTS
    ]


def _kill(command: Command, number: signal.Signals, part: float, folder: Path) -> str:
    (folder / "study.toml").write_text(STUDY, encoding="utf-8")
    _record(folder / "flown.arrows")
    shared = _shared()
    run = _run(command, number, part, folder)
    # before it has begun, the signal's own is right
    fine = (command.status, 0, 1, 128 + number, -number)
    if harm := harm_of(run, fine):
        return harm
    until = time.monotonic() + GRACE
    while (harm := _left(command, folder, shared)) and time.monotonic() < until:
        time.sleep(0.1)
    return harm or _unreadable(folder, run, number)


def _run(command: Command, number: signal.Signals, part: float, folder: Path) -> Run:
    out, error = folder.with_name("out"), folder.with_name("error")
    environment = os.environ | {"TMPDIR": str(folder), "PYTHONPATH": str(ROOT)}
    words = [sys.executable, "-m", "kitemj", *command.words]
    with out.open("w") as said, error.open("w") as cried:
        process = subprocess.Popen(
            words,
            stdin=subprocess.DEVNULL,
            stdout=said,
            stderr=cried,
            cwd=folder,
            env=environment,
            start_new_session=True,
        )
    begun, hung = time.monotonic(), False
    while process.poll() is None and _worked(process.pid) < part * command.time:
        time.sleep(0.005)
        if time.monotonic() > begun + SECONDS:
            break
    with suppress(ProcessLookupError):
        process.send_signal(number)
    try:
        process.wait(SECONDS)
    except subprocess.TimeoutExpired:
        hung = True
        process.kill()
        process.wait()
    until = time.monotonic() + GRACE
    while (left := session(process.pid)) and time.monotonic() < until:
        time.sleep(0.05)
    for pid in left:
        os.kill(pid, signal.SIGKILL)
    return Run(process.returncode, out.read_text(), error.read_text(), hung, left)


def _worked(pid: int) -> float:
    """The processor's time [s] that a process has had."""
    try:
        fields = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
    except OSError:  # it has ended
        return float("inf")
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def _left(command: Command, folder: Path, shared: set[str]) -> str:
    """A harm where something is left that nobody asked for."""
    names = {path.name for path in folder.iterdir()}
    if harm := left_over(folder, [*INPUTS, *(name for name in command.files if name in names)]):
        return harm
    more = _shared() - shared
    return f"file left: {', '.join(sorted(more))} in {SHARED}" if more else ""


def _shared() -> set[str]:
    """What stands in shared memory and belongs to no process that lives."""
    names, maps = list(SHARED.iterdir()), ""
    for each in Path("/proc").glob("[0-9]*/maps"):
        with suppress(OSError):
            maps += each.read_text(errors="replace")
    return {path.name for path in names if str(path) not in maps}


def _unreadable(folder: Path, run: Run, number: signal.Signals) -> str:
    """A harm where a recording or a film cannot be read, or is not what it was said to be."""
    recorded, film, ticks = folder / "a.arrows", folder / "a.mp4", 0
    if recorded.exists():
        try:
            ticks = len(read_recording(recorded))
        except InputError as error:
            killed = number == signal.SIGKILL and recorded.stat().st_size == 0
            return "" if killed else f"file lost: {error}"
    if film.exists():
        try:
            with av.open(str(film)) as container:
                frames = sum(1 for _ in container.decode(video=0))
        except av.FFmpegError as error:
            return f"file lost: {film.name}: {error}"
        if f"the first {frames} of" not in run.out and "interrupted" in run.out:
            return f"wrong: {frames} frames, but {run.out.strip()}"
    elif ticks > 100 and number != signal.SIGKILL and "before its first frame" not in run.out:
        return f"file lost: {ticks} ticks were flown, of which there is no film"
    return ""


def _record(path: Path) -> None:
    """A flight of a second."""
    from kitemj.flight.live import Command as Wish
    from kitemj.recording.live import LiveFlight

    with LiveFlight({"set": "sport", "duration": 60.0}, record=path) as flight:
        for _ in range(100):
            flight.tick(Wish(0.2))
