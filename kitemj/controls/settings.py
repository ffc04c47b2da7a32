"""The settings file: how sticks feel, and layouts of pads that SDL does not know."""

import os
from collections.abc import Mapping
from pathlib import Path
from typing import Annotated, Any, NamedTuple

import tomlkit
from platformdirs import user_config_path

from kitemj.controls.pad_layout import Layout, layout_of, table_of
from kitemj.data_files import read_text
from kitemj.errors import InputError
from kitemj.files import new_file
from kitemj.physics.checked import check_keys, checked
from kitemj.physics.parameter_files import read_toml
from kitemj.physics.quantity import Quantity
from kitemj.physics.shaping import StickLaw

LAWS = {law.name.lower(): law for law in StickLaw}
ASSISTS = ("lessons", "always", "never")
"""When a flight begins with the assist on: while there are lessons, always, never."""


class Feel(NamedTuple):
    """How deflection becomes command; the dead zone is part of a stick's way to one side."""

    dead_zone: Annotated[float, Quantity("", "does nothing about the centre", ge=0, le=0.5)] = 0.08
    expo: Annotated[float, Quantity("", "0: straight; 1: x³, gentle in the middle", ge=0, le=1)] = 0
    two_sticks: Annotated[bool, Quantity("", "true: each stick holds one line")] = False


class Invert(NamedTuple):
    """Which axes of pads are turned around."""

    steer: Annotated[bool, Quantity("", "true: stick left steers right")] = False
    reel: Annotated[bool, Quantity("", "true: stick down lets line out")] = False


class Settings(NamedTuple):
    """`assist`: one of `ASSISTS`; `sound` means rumble too; `pads` by SDL's GUID of the pad."""

    feel: Feel = Feel()
    law: StickLaw = StickLaw.ANGLE
    invert: Invert = Invert()
    assist: str = ASSISTS[0]
    sound: bool = True
    pads: Mapping[str, Layout] = {}


NEW_FILE = """\
# Settings of kitemj; a line that is left out, or begins with #, has the value shown here.
# dead_zone = 0.08     # 0 to 0.5, of a stick's way: does nothing about the centre
# expo = 0             # 0 to 1; more is gentler in the middle
# law = "angle"        # or "rate" or "acceleration": what the stick asks for at the start
# two_sticks = false   # true: each stick holds one line
# assist = "lessons"   # or "always" or "never": when a flight begins with the assist on
# invert = { steer = false, reel = false }
# sound = true         # false: begins without sound and rumble; a key in flight changes it
"""


def settings_path() -> Path:
    """The path of the settings file on this system, whether there is one or not."""
    return user_config_path("kitemj") / "settings.toml"


def read_settings(path: Path | None = None) -> Settings:
    """The settings of the file, the defaults where there is none.

    Raises InputError with one sentence for whatever is wrong in it.
    """
    path = path or settings_path()
    return settings_of(read_toml(path), str(path)) if path.exists() else Settings()


def settings_or_defaults(path: Path | None = None) -> tuple[Settings, str]:
    """The settings, and a sentence where the file is damaged; then they are the defaults."""
    try:
        return read_settings(path), ""
    except InputError as error:
        return Settings(), f"settings left aside: {error}"


def settings_of(tables: Mapping[str, Any], where: str) -> Settings:
    """The settings of a file's tables; `where` names the file in messages."""
    check_keys(tables, [*Feel._fields, "law", "assist", "invert", "sound", "pads"], "", where)
    law = law_of(tables.get("law", "angle"), where)
    assist = tables.get("assist", ASSISTS[0])
    if assist not in ASSISTS:
        raise InputError(f"assist must be one of {', '.join(ASSISTS)}, got {assist!r} ({where})")
    pads = table_of(tables.get("pads", {}), "pads", where)
    return Settings(
        checked(Feel, {key: tables[key] for key in Feel._fields if key in tables}, "", where),
        law,
        checked(Invert, table_of(tables.get("invert", {}), "invert", where), "invert", where),
        assist,
        flag_of(tables.get("sound", True), "sound", where),
        {guid: layout_of(table, f"pads.{guid}", where) for guid, table in pads.items()},
    )


def flag_of(value: Any, key: str, where: str) -> bool:
    """The value, which must be true or false; else InputError, with `key` and `where`."""
    if not isinstance(value, bool):
        raise InputError(f"{key} must be true or false, got {value!r} ({where})")
    return value


def law_of(name: Any, where: str) -> StickLaw:
    """The law of this name; InputError, which says `where` it stands, for any other."""
    if not isinstance(name, str) or name not in LAWS:
        raise InputError(f"law must be one of {', '.join(LAWS)}, got {name!r} ({where})")
    return LAWS[name]


def check_writable(path: Path, overwrite: bool) -> None:
    """Raises InputError where a layout cannot be added: nothing of a damaged file is lost."""
    try:
        if not overwrite:
            read_settings(path)
    except InputError as error:
        raise InputError(f"{error}; mend it, or `overwrite` to begin a new file") from None
    folder = next(parent for parent in path.parents if parent.exists())
    if not folder.is_dir() or not os.access(folder, os.W_OK):
        raise InputError(f"the folder {folder} is not writable")


def write_layout(path: Path, guid: str, layout: Layout, overwrite: bool = False) -> None:
    """Puts a pad's layout into the file; all else in it stays as it is, comments too.

    A damaged file is replaced by a new one where `overwrite` is on.
    """
    check_writable(path, overwrite)
    try:
        read_settings(path)
        text = read_text(path) if path.exists() else NEW_FILE
    except InputError:
        text = NEW_FILE
    document = tomlkit.parse(text)
    if "pads" not in document:
        document["pads"] = tomlkit.table(is_super_table=True)
    document["pads"][guid] = layout.table()
    path.parent.mkdir(parents=True, exist_ok=True)
    with new_file(path, overwrite=True) as part:
        part.write_text(tomlkit.dumps(document), encoding="utf-8")
