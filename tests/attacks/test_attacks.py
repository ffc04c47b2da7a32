"""A few of the attacks of each kind; all of them are `scripts/attack.py`."""

from pathlib import Path

import pytest

from attack import KINDS, chosen_attacks, harms_of
from attacks.victim import Run, harm_of, left_over

SEED = 13
SHARE = {
    "fields": 0.005,
    "tables": 0.02,
    "arguments": 0.006,
    "recordings": 0.01,
    "files": 0.02,
    "disks": 0.012,
    "journals": 0.05,
    "sticks": 0.005,
    "kills": 0.02,
}
"""Of each kind, what some ten seconds allow."""


@pytest.mark.parametrize("kind", KINDS)
def test_no_attack_does_harm(kind: str) -> None:
    chosen = chosen_attacks(kind, SHARE[kind], SEED)
    harms = {attack.what: harm for attack, harm in harms_of(kind, chosen)}
    assert harms
    assert not {what: harm for what, harm in harms.items() if harm}


@pytest.mark.parametrize(
    ("run", "harm"),
    [
        (Run(0, "all is well: information, Ferdinand", "", False, []), ""),
        (Run(1, "", "Traceback (most recent call last):\nKeyError: 1", False, []), "traceback"),
        (Run(70, "", "kitemj: unforeseen", False, []), "traceback"),
        (Run(0, "", "", True, []), "hang"),
        (Run(0, "pull  nan", "", False, []), "not finite"),
        (Run(0, "pull,-inf", "", False, []), "not finite"),
        (Run(0, "", "", False, [1]), "orphan"),
        (Run(-9, "", "", False, []), "wrong"),
    ],
)
def test_harm_is_seen(run: Run, harm: str) -> None:
    assert harm_of(run).partition(":")[0] == harm


def test_what_is_left_or_lost_is_seen(tmp_path: Path) -> None:
    (tmp_path / "a.csv.part").touch()
    assert left_over(tmp_path, ["a.csv.part"]) == ""
    assert left_over(tmp_path, []).startswith("file left")
    (tmp_path / "a.csv.part").unlink()
    assert left_over(tmp_path, ["a.csv"]).startswith("file lost")
