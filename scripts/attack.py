"""Attacks the program and prints the harm done, by kind.

.venv/bin/python scripts/attack.py                       # all, some 10 minutes
.venv/bin/python scripts/attack.py --only fields --share 0.1
.venv/bin/python scripts/attack.py --markdown docs/tables/attacks.md --overwrite
"""

import argparse
import random
import sys
import tempfile
from collections import Counter
from collections.abc import Iterable
from importlib import import_module
from pathlib import Path

from attacks.victim import HARMS, Attack, warm
from kitemj.files import new_file
from kitemj.progress_bar import with_progress
from kitemj.tables import Table, markdown, print_table

KINDS = (
    *("fields", "tables", "arguments", "recordings"),
    *("files", "disks", "journals", "sticks", "kills"),
)
"""Files of `attacks`, each with `attacks()`."""


def main() -> int:
    """The exit status: 1 where harm was done."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--only", nargs="+", choices=KINDS, default=KINDS, help="these kinds")
    parser.add_argument("--share", type=float, default=1.0, help="of the attacks, by lot")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--markdown", type=Path, help="a file for the table")
    parser.add_argument("--overwrite", action="store_true")
    words = parser.parse_args()
    rows, harmed = [], False
    for kind in words.only:
        chosen = chosen_attacks(kind, words.share, words.seed)
        harms = Counter[str]()
        for attack, harm in harms_of(kind, chosen):
            harms[harm.partition(":")[0]] += bool(harm)
            if harm:
                print(f"{kind}: {attack.what}: {harm}", flush=True)
        rows.append((kind, len(chosen), *(harms[harm] for harm in HARMS)))
        harmed |= harms.total() > 0
    rows.append(("all", *(sum(column) for column in list(zip(*rows, strict=True))[1:])))
    table = Table("Attacks and the harm done", ("kind", "tried", *HARMS), rows)
    print_table(table, most=len(table.columns))
    if words.markdown:
        with new_file(words.markdown, words.overwrite) as part:
            part.write_text(markdown(table), encoding="utf-8")
    return int(harmed)


def chosen_attacks(kind: str, share: float, seed: int) -> list[Attack]:
    """A share of the attacks of a kind, by lot; the same ones for the same seed."""
    every: list[Attack] = import_module(f"attacks.{kind}").attacks()
    return random.Random(seed).sample(every, max(1, round(share * len(every))))


def harms_of(kind: str, attacks: list[Attack]) -> Iterable[tuple[Attack, str]]:
    """Each attack and the harm that it did ("" for none), in an empty folder of its own."""
    warm()
    for attack in with_progress(kind, attacks, len(attacks)):
        with tempfile.TemporaryDirectory(prefix="attack-") as parent:
            folder = Path(parent) / "folder"
            folder.mkdir()
            yield attack, attack.harm(folder)


if __name__ == "__main__":
    sys.exit(main())
