"""Disks that are full, fail, or end at each byte, under every command that writes."""

import contextlib
import errno
import io
import os
import resource
import signal
import subprocess
import sys
from collections.abc import Sequence
from functools import cache, partial
from pathlib import Path
from typing import Any

from attacks.victim import Attack, Outside, Run, harm_of, run
from attacks.writers import COMMANDS, prepare

PARTS = (0.0, 0.01, 0.3, 0.6, 0.9, 0.999)
"""Of what a command writes, where the disk ends."""
REFUSALS = {
    "fsync": (errno.EIO, errno.ENOSPC),
    "link": (errno.ENOSPC,),
    "replace": (errno.EROFS,),
    "open": (errno.EDQUOT, errno.EIO),
}
"""Calls of the system, and how they fail; `open` for writing only."""
ROOM = (0, 1)
"""Blocks of 4 KiB that are free on the small disk."""
SMALL_DISK = 65536
TALK = (
    *(["reach"], ["info", "a.arrows"], ["limits", "s.toml"], ["trim", "s.toml"], ["--version"]),
    *(["stability", "s.toml"], ["stability", "s.toml", "--json"], ["--help"], ["trim", "--help"]),
    *(["compare", "s.toml", "--json"], ["compare", "s.toml"], ["trim", "s.toml", "--json"]),
    ["simulate", "s.toml", "--output", "a.csv"],
    ["replay", "a.arrows", "--headless", "--model", "lagrange"],
)
"""Commands that print."""


def attacks() -> list[Attack]:
    """Byte limits, failing calls, standard output on a full disk; a small disk where root is."""
    found = []
    for name, words in COMMANDS.items():
        for part in PARTS:
            found.append(Attack(f"{name}: {part:.1%} fits", partial(_cut, name, part)))
        for call, numbers in REFUSALS.items():
            for number in numbers:
                what = f"{name}: {call} says {errno.errorcode[number]}"
                found.append(Attack(what, partial(_refused, words, call, number)))
        for blocks in ROOM if _mounts() else ():
            what = f"{name}: a disk with {4 * blocks} KiB of room"
            found.append(Attack(what, partial(_small_disk, words, blocks)))
    for talk in TALK:
        found.append(Attack(f"kitemj {' '.join(talk)} > /dev/full", partial(_deaf, talk)))
    return found


def _cut(name: str, part: float, folder: Path) -> str:
    size = _size(name)
    before = partial(_limited, int(part * size))
    return _judged(COMMANDS[name], folder, before, must_fail=name != "sweep")


def _refused(words: Sequence[str], call: str, number: int, folder: Path) -> str:
    return _judged(words, folder, partial(_failing, call, number), must_fail=call != "link")


def _small_disk(words: Sequence[str], blocks: int, folder: Path) -> str:
    disk = folder / "disk"
    disk.mkdir()
    _mount(disk)
    try:
        prepare(disk)
        with contextlib.suppress(OSError), (disk / "filler").open("wb", buffering=0) as filler:
            while filler.write(bytes(4096)):
                pass
        room = blocks * 4096
        os.truncate(disk / "filler", (disk / "filler").stat().st_size - room)
        return _judged(words, disk, None, must_fail=False)
    finally:
        subprocess.run(["umount", "--lazy", str(disk)], check=True)


def _deaf(words: Sequence[str], folder: Path) -> str:
    prepare(folder)
    ended = run(words, folder, outside=Outside(before=_to_full))
    if harm := harm_of(ended, (74,)):
        return harm
    return _sentence(ended, "standard output")


def _judged(words: Sequence[str], folder: Path, before: Any, must_fail: bool) -> str:
    if before:
        prepare(folder)
    there = {path.name: path.read_bytes() for path in folder.iterdir()}
    ended = run(words, folder, outside=Outside(before=before) if before else None)
    if harm := harm_of(ended, (0, 74)):
        return harm
    more = {path.name for path in folder.iterdir()} - set(there)
    if ended.status == 0:
        return "wrong: done, on a disk that does not take it" if must_fail else ""
    if "safe in" in ended.error:
        more -= {f"{_output(words)}.journal"}
    if more:
        return f"file left: {', '.join(more)}"
    lost = [name for name in there if (folder / name).read_bytes() != there[name]]
    return f"file lost: {', '.join(lost)}" if lost else _sentence(ended, _output(words)[:1])


def _sentence(ended: Run, name: str) -> str:
    lines = ended.error.strip().splitlines()
    said = len(lines) == 1 and lines[0].startswith("kitemj: cannot write ") and name in lines[0]
    return "" if said else f"wrong: {ended.error.strip()[-200:]!r} does not say what was refused"


def _output(words: Sequence[str]) -> str:
    return next(word for word in words if word.startswith("a.") and word != "a.arrows")


@cache
def _size(name: str) -> int:
    """Bytes of the smallest file that the command writes where there is room."""
    import tempfile

    with tempfile.TemporaryDirectory() as parent:
        folder = Path(parent) / "folder"
        folder.mkdir()
        prepare(folder)
        there = set(folder.iterdir())
        ended = run(COMMANDS[name], folder)
        assert ended.status in (0, 1), ended
        return min(path.stat().st_size for path in set(folder.iterdir()) - there)


class _Spoken(io.FileIO):
    """What the victim says, on which its own limit does not count."""

    def write(self, data: Any) -> int:
        soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
        resource.setrlimit(resource.RLIMIT_FSIZE, (hard, hard))
        try:
            return super().write(data) or 0
        finally:
            resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))


def _limited(size: int) -> None:
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    for number, name in ((1, "stdout"), (2, "stderr")):
        raw = _Spoken(number, "w", closefd=False)
        setattr(sys, name, io.TextIOWrapper(io.BufferedWriter(raw), encoding="utf-8"))
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, resource.RLIM_INFINITY))


def _failing(call: str, number: int) -> None:
    real = getattr(os, call)

    def refuse(*args: Any, **options: Any) -> Any:
        if call == "open" and not args[1] & (os.O_WRONLY | os.O_RDWR):
            return real(*args, **options)
        raise OSError(number, os.strerror(number))

    setattr(os, call, refuse)


def _to_full() -> None:
    os.dup2(os.open("/dev/full", os.O_WRONLY), 1)


@cache
def _mounts() -> bool:
    """Whether a disk of our own can be had."""
    import tempfile

    with tempfile.TemporaryDirectory() as folder:
        try:
            _mount(Path(folder))
        except (OSError, subprocess.CalledProcessError):
            return False
        subprocess.run(["umount", "--lazy", folder], check=True)
    return True


def _mount(folder: Path) -> None:
    words = ["mount", "-t", "tmpfs", "-o", f"size={SMALL_DISK}", "kitemj-attack", str(folder)]
    subprocess.run(words, check=True, capture_output=True)
