"""Every field of a scenario file, with values that no kite has."""

import json
from functools import partial
from pathlib import Path

from attacks.victim import Attack, harm_of, run

VALUES = (
    *("0", "-1", "1e308", "-1e308", "5e-324", "1e-12", "1e12", "inf", "nan"),
    *('""', '"x"', "[]", "{}", "true", "9223372036854775807", "1979-05-27"),
)
"""As TOML spells them."""
FIELDS = ("duration", "output_interval", "set", "kite.mass")


def attacks() -> list[Attack]:
    """A flight of 0.2 s for every field and value."""
    return [
        Attack(f"{field} = {value}", partial(_fly, field, value))
        for field in FIELDS
        for value in VALUES
    ]


def _fly(field: str, value: str, folder: Path) -> str:
    lines = {"set": json.dumps("sport"), "duration": "0.2", field: value}
    text = "".join(f"{name} = {each}\n" for name, each in lines.items())
    (folder / "attack.toml").write_text(text, encoding="utf-8")
    return harm_of(run(["simulate", "attack.toml", "--output", "flight.csv"], folder))
