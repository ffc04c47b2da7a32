"""Flights read from files: a recording, a scenario (which is simulated), a table."""

from dataclasses import replace
from math import ceil
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow as pa

from kitemj.autopilot.guided_flight import simulate_as_said
from kitemj.data_files import SCENARIOS, shipped_or_file
from kitemj.errors import InputError
from kitemj.flight.limits import Ending
from kitemj.flight.scenario import Scenario, read_scenario
from kitemj.metadata import about_columns, about_csv
from kitemj.physics.parameter_files import parameter_set, told_parameters
from kitemj.plots.flight import Flight, flight_of_recording, flight_of_simulation
from kitemj.plots.identify_kite import DEFAULT, kite_of_table
from kitemj.recording.file import read_recording
from kitemj.recording.recorder import SUFFIX
from kitemj.recording.table import Columns

SCENARIO, TABLES = ".toml", (".csv", ".parquet")
KINDS = f"a recording (*{SUFFIX}), a scenario (*{SCENARIO}) or a table (*.csv, *.parquet)"
ROWS = 1000
"""Of a scenario, at least: so many that the straight lines between them do not show."""


def read_flight(path: str | Path, model: str = "", episode: int = 0, kite: str = "") -> Flight:
    """The flight in the file `path`; its notes say what was chosen in it.

    `model` flies a scenario (lagrange unless given); `episode` (from 1; 0: the longest) is one of
    a recording or its table; `kite`, a set or a scenario's file, that of a table. Raises
    InputError for a file that holds no flight and for a choice that means nothing with it.
    """
    path = Path(path)
    if path.suffix.lower() in ("", SCENARIO):
        path = shipped_or_file(path, SCENARIOS)
    if not path.is_file():
        what = "is a folder" if path.is_dir() else "does not exist"
        raise InputError(f"{path} {what}; give {KINDS}")
    kind = path.suffix.lower()
    if model and kind != SCENARIO:
        raise InputError(f"`model` is for a scenario; what {path.name} holds is flown already")
    if episode and kind == SCENARIO:
        what = f"{path.name} is a scenario, which is one flight"
        raise InputError(f"`episode` is for a recording; {what}")
    if kite and kind not in TABLES:
        raise InputError(f"`kite` is for a table; {path.name} says itself which kite flew")
    if kind == SCENARIO:
        return _simulated(read_scenario(path), model or "lagrange")
    return _tabled(path, episode, kite) if kind in TABLES else _recorded(path, episode)


def _simulated(scenario: Scenario, model: str) -> Flight:
    """The flight of a scenario, a row every interval of the scenario or a whole part of it."""
    interval, duration = scenario.times.output_interval, scenario.times.duration
    parts = max(1, ceil(ROWS * interval / duration))
    finer = replace(scenario, times=scenario.times._replace(output_interval=interval / parts))
    flight = flight_of_simulation(simulate_as_said(finer, model))
    if flight.notes or flight.ending is Ending.FINISHED or flight.ending is None:
        return flight
    return replace(flight, notes=(f"the flight ended early: {flight.ending.value}",))


def _recorded(path: Path, episode: int) -> Flight:
    recording = read_recording(path)
    chosen, notes = _chosen(path, recording.episodes, episode)
    if not recording.ending:
        notes.append(f"{path.name} breaks off: the program was stopped, or the disk was full")
    return replace(flight_of_recording(recording, chosen), notes=tuple(notes))


def _tabled(path: Path, episode: int, kite: str) -> Flight:
    columns, about = _columns(path)
    episodes = _episodes_in(columns)
    chosen, notes = _chosen(path, episodes, episode)
    rows = {name: column[episodes[chosen]] for name, column in columns.items()}
    table = Flight(path.name, parameter_set(DEFAULT), rows)
    if np.any(np.diff(table.t) <= 0.0):
        raise InputError(f"{path} holds no flight: its column t_s must rise from row to row")
    told = about.get("parameters")
    if kite or not isinstance(told, dict):
        name, parameters, note = kite_of_table(table, kite)
        notes += note
    else:
        name, parameters = str(about.get("model", "")), told_parameters(told, path.name)
    name = ", ".join(filter(None, (path.name, Path(name).name)))
    number = f", flight {chosen + 1} of {len(episodes)}" if len(episodes) > 1 else ""
    return Flight(f"{name}{number}", parameters, rows, tuple(notes))


def _columns(path: Path) -> tuple[Columns, dict[str, Any]]:
    """Every column by its name, shape (rows,), and what is told of the table.

    InputError where the file holds no table.
    """
    from pyarrow import csv, parquet

    read = csv.read_csv if path.suffix.lower() == ".csv" else parquet.read_table
    try:
        table = read(path)
    except (pa.ArrowException, OSError) as error:
        reason = str(error).splitlines()[0]
        raise InputError(f"{path} is not a table that can be read: {reason}") from None
    if not table.num_rows:
        raise InputError(f"{path} holds no row")
    names = table.column_names
    if twice := [name for name in names if names.count(name) > 1]:
        raise InputError(f"{path} has the column {twice[0]} twice: keep one")
    about = about_csv(path) if read is csv.read_csv else about_columns(table.schema.metadata)
    return {name: table[name].to_numpy() for name in names}, about


def _episodes_in(columns: Columns) -> list[slice]:
    """The rows of each flight: one, unless a column `leg` tells several apart."""
    rows = len(next(iter(columns.values())))
    if "leg" not in columns:
        return [slice(0, rows)]
    cuts = (np.flatnonzero(np.diff(columns["leg"])) + 1).tolist()
    return [slice(a, b) for a, b in zip([0, *cuts], [*cuts, rows], strict=True)]


def _chosen(path: Path, episodes: list[slice], asked: int) -> tuple[int, list[str]]:
    """The number of the flight (from 0), and what is to be said of the choice."""
    if not 0 <= asked <= len(episodes):
        raise InputError(f"`episode` must be 1 to {len(episodes)} for {path.name}, got {asked}")
    if asked or len(episodes) == 1:
        return max(0, asked - 1), []
    longest = max(range(len(episodes)), key=lambda i: episodes[i].stop - episodes[i].start)
    drawn = f"drawn is the longest, flight {longest + 1}"
    return longest, [f"{path.name} holds {len(episodes)} flights; {drawn}"]
