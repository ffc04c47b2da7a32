"""What may stand where a command is to write: files, links, devices, pipes, and what is planted."""

import os
import socket
import stat
import threading
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from functools import partial
from pathlib import Path

from attacks.victim import Attack, Outside, harm_of, run
from attacks.writers import COMMANDS, prepare

MINE = b"a person's own\n"


def attacks() -> list[Attack]:
    """Every command that writes, and every thing at its output."""
    found = [
        Attack(f"{name}: {check.__name__[1:].replace('_', ' ')}", partial(_attacked, words, check))
        for name, words in COMMANDS.items()
        if name not in ("trim csv", "trim parquet", "gif", "plot")  # as others of theirs
        for check in CHECKS
    ]
    return [
        *found,
        Attack("simulate into /dev/null", partial(_device, "/dev/null")),
        Attack("simulate into /dev/stdout", partial(_device, "/dev/stdout")),
        Attack("simulate into /dev/fd/1", partial(_device, "/dev/fd/1")),
        Attack("simulate into /dev/full", _full_device),
    ]


Check = Callable[[list[str], Path, Path], str]


def _attacked(words: Sequence[str], check: Check, folder: Path) -> str:
    prepare(folder)
    name = next(word for word in words if word.startswith("a.") and word != "a.arrows")
    (folder / "mine").write_bytes(MINE)
    harm = check(list(words), folder, folder / name)
    if not harm and (folder / "mine").read_bytes() != MINE:
        harm = "file lost: mine"
    left = [path.name for path in folder.iterdir() if path.name.startswith(".kitemj")]
    return harm or (f"file left: {', '.join(left)}" if left else "")


def _ends(words: list[str], folder: Path, status: int) -> str:
    ended = run(words, folder)
    return harm_of(ended, (status,))


def _an_existing_file_is_refused(words: list[str], folder: Path, path: Path) -> str:
    path.write_bytes(MINE)
    return _ends(words, folder, 2) or _same(path)


def _an_existing_file_is_replaced(words: list[str], folder: Path, path: Path) -> str:
    path.write_bytes(MINE)
    path.chmod(0o640)
    harm = _ends([*words, "--overwrite"], folder, 0)
    kept = stat.S_IMODE(path.stat().st_mode) == 0o640
    return harm or _written(path) or ("" if kept else "wrong: other permissions")


def _a_second_name_keeps_the_old(words: list[str], folder: Path, path: Path) -> str:
    path.hardlink_to(folder / "mine")
    return _ends([*words, "--overwrite"], folder, 0) or _written(path)


def _a_file_called_part_stays(words: list[str], folder: Path, path: Path) -> str:
    part = path.with_name(f"{path.name}.part")
    part.write_bytes(MINE)
    return _ends(words, folder, 0) or _written(path) or _same(part)


def _a_link_called_part_is_not_followed(words: list[str], folder: Path, path: Path) -> str:
    path.with_name(f"{path.name}.part").symlink_to("mine")
    return _ends(words, folder, 0) or _written(path)


def _a_linked_file_is_refused(words: list[str], folder: Path, path: Path) -> str:
    path.symlink_to("mine")
    return _ends(words, folder, 2)


def _a_link_stays_a_link(words: list[str], folder: Path, path: Path) -> str:
    other = folder / "other"
    other.write_bytes(MINE)
    path.symlink_to("other")
    harm = _ends([*words, "--overwrite"], folder, 0)
    return harm or _written(other) or ("" if path.is_symlink() else "file lost: the link")


def _a_link_to_nothing_is_refused(words: list[str], folder: Path, path: Path) -> str:
    path.symlink_to("nothing")
    harm = _ends(words, folder, 2)
    return harm or ("wrong: through the link" if (folder / "nothing").exists() else "")


def _a_ring_of_links_is_refused(words: list[str], folder: Path, path: Path) -> str:
    path.symlink_to("ring")
    (folder / "ring").symlink_to(path.name)
    harm = _ends([*words, "--overwrite"], folder, 2)
    return harm or ("" if path.is_symlink() else "file lost: the link")


def _a_device_stays_a_device(words: list[str], folder: Path, path: Path) -> str:
    path.symlink_to("/dev/null")
    harm = _ends([*words, "--overwrite"], folder, 2 if words[0] == "sweep" else 0)
    kept = path.is_symlink() and stat.S_ISCHR(Path("/dev/null").stat().st_mode)
    return harm or ("" if kept else "file lost: the device")


def _a_pipe_is_written_into(words: list[str], folder: Path, path: Path) -> str:
    os.mkfifo(path)
    with _read(path) as taken:
        harm = _ends([*words, "--overwrite"], folder, 2 if words[0] == "sweep" else 0)
    if not stat.S_ISFIFO(path.stat().st_mode):
        return "file lost: the pipe"
    return harm or ("" if taken or words[0] == "sweep" else "wrong: nothing came through the pipe")


def _a_socket_stays_a_socket(words: list[str], folder: Path, path: Path) -> str:
    with socket.socket(socket.AF_UNIX) as server:
        here = os.open(folder, os.O_RDONLY)  # names of sockets must be short
        server.bind(f"/proc/self/fd/{here}/{path.name}")
        os.close(here)
        harm = _ends([*words, "--overwrite"], folder, 2)
    return harm or ("" if path.is_socket() else "file lost: the socket")


def _a_folder_is_refused(words: list[str], folder: Path, path: Path) -> str:
    path.mkdir()
    return _ends([*words, "--overwrite"], folder, 2) or ("" if path.is_dir() else "file lost")


def _the_umask_counts(words: list[str], folder: Path, path: Path) -> str:
    before = partial(os.umask, 0o027)
    harm = harm_of(run(words, folder, outside=Outside(before=before)), (0,))
    right = not harm and stat.S_IMODE(path.stat().st_mode) == 0o640
    return harm or ("" if right else "wrong: other permissions than the umask's")


def _the_longest_name_is_a_name(words: list[str], folder: Path, path: Path) -> str:
    if words[0] == "sweep":  # whose journal has a longer one
        return ""
    beside = len("-metadata.json") if path.suffix == ".csv" else 0  # the file that tells of it
    long = "a" * (255 - len(path.suffix) - beside) + path.suffix
    harm = _ends([long if word == path.name else word for word in words], folder, 0)
    return harm or _written(folder / long)


def _a_name_too_long_is_refused(words: list[str], folder: Path, path: Path) -> str:
    long = "a" * 256 + path.suffix
    return _ends([long if word == path.name else word for word in words], folder, 2)


CHECKS: tuple[Check, ...] = (
    *(_an_existing_file_is_refused, _an_existing_file_is_replaced, _a_second_name_keeps_the_old),
    *(_a_file_called_part_stays, _a_link_called_part_is_not_followed, _a_linked_file_is_refused),
    *(_a_link_stays_a_link, _a_link_to_nothing_is_refused, _a_ring_of_links_is_refused),
    *(_a_device_stays_a_device, _a_pipe_is_written_into, _a_socket_stays_a_socket),
    *(_a_folder_is_refused, _the_umask_counts, _the_longest_name_is_a_name),
    _a_name_too_long_is_refused,
)


def _device(name: str, folder: Path) -> str:
    prepare(folder)
    ended = run(["simulate", "s.toml", "--output", name], folder)
    if harm := harm_of(ended, (0,)):
        return harm
    if not name.endswith("null") and "t_s,phi_rad" not in ended.out:
        return "file lost: the table"
    return "" if stat.S_ISCHR(Path("/dev/null").stat().st_mode) else "file lost: /dev/null"


def _full_device(folder: Path) -> str:
    prepare(folder)
    return harm_of(run(["simulate", "s.toml", "--output", "/dev/full"], folder), (74,))


def _same(path: Path) -> str:
    kept = path.is_file() and path.read_bytes() == MINE
    return "" if kept else f"file lost: {path.name}"


def _written(path: Path) -> str:
    new = path.is_file() and path.stat().st_size > 0 and path.read_bytes() != MINE
    return "" if new and not path.is_symlink() else f"wrong: nothing was written to {path.name}"


@contextmanager
def _read(path: Path) -> Iterator[list[bytes]]:
    """What comes through the pipe meanwhile."""
    taken: list[bytes] = []
    over = threading.Event()
    pipe = os.open(path, os.O_RDONLY | os.O_NONBLOCK)

    def read() -> None:
        while True:
            ending = over.is_set()
            try:
                data = os.read(pipe, 65536)
            except BlockingIOError:
                data = b""
            if data:
                taken.append(data)
            elif ending:
                return
            else:
                time.sleep(0.005)

    reader = threading.Thread(target=read)
    reader.start()
    try:
        yield taken
    finally:
        over.set()
        reader.join()
        os.close(pipe)
