"""Every option of every command with odd values; closed pipes, encodings, widths."""

import argparse
import os
import re
from collections.abc import Iterator, Sequence
from functools import partial
from pathlib import Path

from attacks.fields import not_finite
from attacks.victim import Attack, Outside, harm_of, left_over, run
from kitemj.cli import _parser

SCENARIO = "duration = 0.2\nset = 'sport'\n"
NUMBERS = (
    *("0", "-1", "nan", "inf", "-inf", "1e308", "1e-308", "5e-324", "1e-12", "1e12", "1e300"),
    *("", "x", "²", "٣", "1,5", "0x10", "1_0", "9" * 400, "20000"),
)
NAMES = (
    *("", "x", ",", "mujoco,", "mujoco,mujoco", " ", "MUJOCO", "é", "\udcff", "n" * 300, "../x"),
    *("a\nb", "0", "-", "a.b.c", "kite.mass", "\x1b[31m", "sport", "lagrange", "=", "*"),
)
FILES = (
    *("", ".", "/", "..", "none/x.csv", "scenario.toml/x.csv", "n" * 300 + ".csv", "\udcff.csv"),
    *("a\nb.csv", "scenario.toml", "/dev/full", "/dev/null", "/proc/self/mem", "fifo", "loop"),
    *("locked", "~", "x", "x.CSV", "x.toml"),
)
REFUSED_FOLDERS = ("", "scenario.toml", "scenario.toml/x", "none/x", "n" * 300, "loop", "fifo")
"""Names under which no report is written, which would take half an hour."""
SIZES = ("²x²", "20000x20000", "0x0", "1x1", "x", "1280x", "-1x-1", "1280X720", "٣x٣", "1e3x1e3")
BASES = {
    "simulate": ["simulate", "scenario.toml", "--output", "out.csv"],
    "compare": ["compare", "scenario.toml"],
    "film": ["film", "scenario.toml", "--output", "out.png", "--still", "0.1", "--size", "320x180"],
    "replay": ["replay", "recording.arrows", "--headless"],
    "info": ["info", "recording.arrows"],
    "plot": ["plot", "scenario.toml", "--what", "path", "--save", "out.svg"],
    "limits": ["limits", "scenario.toml"],
    "trim": ["trim", "scenario.toml", "--models", "lagrange"],
    "stability": ["stability", "scenario.toml"],
    "identify": ["identify", "scenario.toml"],
    "margins": ["margins", "scenario.toml"],
    "sweep": ["sweep", "study.toml", "--output", "out.parquet", "--processes", "1"],
    "pad": ["pad", "--list"],
    "reach": ["reach", "scenario.toml"],
}
"""What does something quickly; `fly`, `realtime` and `thesis` are attacked with bad words only."""
SLOW = {
    "fly": ["fly", "scenario.toml", "--headless", "--duration", "none"],
    "realtime": ["realtime", "--headless", "--duration", "none"],
    "thesis": ["thesis", "--output", "scenario.toml"],
}
WIDTHS = (1, 20, 30, 40, 60, 80, 120, 200)
USUAL = Outside()
ENCODINGS = ("ascii", "cp1252", "latin-1", "cp437", "koi8-r", "shift_jis")
SHOWN = ("simulate", "compare", "limits", "trim", "stability", "reach", "pad", "sweep")


def attacks() -> list[Attack]:
    """All that can be done to a command line."""
    found = [_attack(words) for words in _lines()]
    shown = [*(BASES[name] for name in SHOWN), ["--help"], ["--version"], ["trim", "--help"]]
    for words in shown:
        outsides = [Outside(closed=True), *(Outside(columns=width) for width in WIDTHS)]
        outsides += [Outside(encoding=each) for each in ENCODINGS]
        outsides += [Outside(encoding="ascii", columns=width) for width in WIDTHS[1:4]]
        found += [_attack(words, outside) for outside in outsides]
    return found


def _lines() -> Iterator[list[str]]:
    for name, command in _commands().items():
        base = (BASES | SLOW)[name]
        if name not in SLOW:  # which need no word to begin
            yield [name]
        yield [*base, "more"]
        for action in command._actions:
            if isinstance(action, argparse._HelpAction):
                continue
            word = [*action.option_strings[-1:]]
            if not word:
                yield from ([name, each, *base[2:]] for each in FILES if base[1] != "--list")
                continue
            yield [*base, *word]  # a switch, or its value is missing
            if action.nargs == 0 or isinstance(action, argparse.BooleanOptionalAction):
                yield [*base, *word, *word]
                yield [*base, f"{word[0]}=x"]
                continue
            for value in _values(action) if name != "thesis" else REFUSED_FOLDERS:
                count = action.nargs if isinstance(action.nargs, int) else 1
                given = [f"{word[0]}={value}"] if count == 1 else [*word, *[value] * count]
                yield [*base, *given]


def _values(action: argparse.Action) -> Sequence[str]:
    if action.dest == "size":
        return SIZES
    if action.dest == "use":
        return ("x", "", ".", "..", "os.path", "a b", "1", "é")
    if action.type in (int, float):
        return NUMBERS
    return FILES if action.type is Path else NAMES


def _commands() -> dict[str, argparse.ArgumentParser]:
    [choices] = [a.choices for a in _parser()._actions if isinstance(a, argparse._SubParsersAction)]
    return dict(choices)


def _attack(words: list[str], outside: Outside = USUAL) -> Attack:
    told = "" if outside == USUAL else f" ({outside})"
    return Attack(f"{' '.join(map(_short, words))!a}{told}", partial(_harm, words, outside))


def _short(word: str) -> str:
    return word if len(word) < 50 else f"{word[:20]}...{len(word)}"


def _harm(words: list[str], outside: Outside, folder: Path) -> str:
    _furnish(folder)
    before = {path.name for path in folder.iterdir()}
    done = run(words, folder, outside=outside)
    if harm := harm_of(done, (0, 1, 2, 74) if "/dev/full" in str(words) else (0, 1, 2)):
        return harm
    if outside.closed and done.status not in (0, 2):  # 2: what was asked for cannot be
        return f"wrong: status {done.status} with nobody to read, {done.error}"
    if done.status == 2 and len(done.error.splitlines()) != 1:
        return f"wrong: {len(done.error.splitlines())} lines of error, {done.error[:200]}"
    if "…" in done.out:
        return f"wrong: a cut number, {re.findall('.{9}…', done.out)[:1]}"
    if words[0] == "simulate" and (folder / "out.csv").is_file():
        return not_finite(folder / "out.csv")
    if done.status:
        return left_over(folder, sorted(before))
    return ""


def _furnish(folder: Path) -> None:
    """Files of a person's, good and bad."""
    (folder / "scenario.toml").write_text(SCENARIO, encoding="utf-8")
    (folder / "base.toml").write_text(SCENARIO, encoding="utf-8")
    study = "scenario = 'base.toml'\nmodel = 'lagrange'\n[grid]\nwind.speed = [6.0, 6.5]\n"
    (folder / "study.toml").write_text(study, encoding="utf-8")
    (folder / "recording.arrows").write_bytes(b"ARROW1" * 100)
    (folder / "locked").mkdir(mode=0o555)
    (folder / "loop").symlink_to("loop")
    os.mkfifo(folder / "fifo")
