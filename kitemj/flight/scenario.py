"""A scenario file: a parameter set, a wind, a steering programme, a start, a duration."""

from collections.abc import Mapping
from dataclasses import dataclass
from math import pi
from pathlib import Path
from typing import Annotated, Any, NamedTuple

import numpy as np
from scipy.interpolate import CubicSpline

from kitemj.data_files import SCENARIOS, shipped_or_file
from kitemj.dynamics.motion import State
from kitemj.errors import InputError
from kitemj.flight.equilibrium import equilibrium_state
from kitemj.flight.pilot_settings import PilotSettings
from kitemj.physics.checked import checked, in_radians, unknown_key
from kitemj.physics.frames import Angles
from kitemj.physics.parameter_files import SECTIONS, parameter_set, read_toml, set_names
from kitemj.physics.parameters import Parameters
from kitemj.physics.quantity import Quantity
from kitemj.physics.steering import Programme, Sines, Spline, rest_ell

MOST_ROWS = 500_000
"""Rows of a flight: each takes 4 kB of memory."""
CLOSEST = 1e-6
"""s; between two rows of a steering table. No hand is quicker, and the spline keeps its digits."""
PROGRAMMES = ("rest", "sine", "table")
STARTS = ("equilibrium", "state")


class Times(NamedTuple):
    """How long, and how often a row is written."""

    duration: Annotated[float, Quantity("s", "length of the flight", gt=0, le=1e6)]
    output_interval: Annotated[float, Quantity("s", "time between rows", gt=0)] = 0.1


class Offsets(NamedTuple):
    """q and q̇: added to the equilibrium, or the start outright."""

    phi: Annotated[float, Quantity("rad", "φ")] = 0.0
    gamma: Annotated[float, Quantity("rad", "γ")] = 0.0
    eta: Annotated[float, Quantity("rad", "η")] = 0.0
    theta: Annotated[float, Quantity("rad", "θ")] = 0.0
    phi_dot: Annotated[float, Quantity("rad/s", "φ̇")] = 0.0
    gamma_dot: Annotated[float, Quantity("rad/s", "γ̇")] = 0.0
    eta_dot: Annotated[float, Quantity("rad/s", "η̇")] = 0.0
    theta_dot: Annotated[float, Quantity("rad/s", "θ̇")] = 0.0


class SteeringTable(NamedTuple):
    """Columns of a steering table; a cubic spline goes through the rows."""

    t: Annotated[tuple[float, ...], Quantity("s", "times, ascending, from 0 to the duration")]
    delta: Annotated[tuple[float, ...], Quantity("rad", "δ at each time")]
    ell: Annotated[tuple[float, ...] | None, Quantity("m", "ℓ at each time; ℓ₀ if left out")] = None


@dataclass(frozen=True)
class Scenario:
    """All that a flight needs; `source` is what messages call it.

    `steered`: whether a programme was named; if not, the lines rest. `pilot`: who flies, where
    the scenario has [pilot].
    """

    source: str
    parameters: Parameters
    programme: Programme
    start: State
    times: Times
    steered: bool = True
    pilot: PilotSettings | None = None

    @property
    def output_times(self) -> list[float]:
        """Times [s] of the rows: every interval from 0, and the end."""
        count = int(self.times.duration / self.times.output_interval + 1e-9)
        times = [i * self.times.output_interval for i in range(count + 1)]
        if self.times.duration - times[-1] > 1e-9 * self.times.duration:
            times.append(self.times.duration)
        return times


def read_scenario(path: str | Path) -> Scenario:
    """The scenario in a TOML file, or of those that ship the one of this name.

    Raises InputError with one sentence for what is wrong.
    """
    found = shipped_or_file(path, SCENARIOS)
    return scenario_of(read_toml(found), found.name)


def parameters_named(name: str) -> Parameters:
    """Those of the parameter set `name`, or of the scenario in the file of this name."""
    if name in set_names():
        return parameter_set(name)
    try:
        path = shipped_or_file(name, SCENARIOS)
    except InputError as error:
        raise InputError(f"{error}; sets: {', '.join(set_names())}") from None
    return read_scenario(path).parameters


def as_scenario(given: Scenario | str | Path | Mapping[str, Any]) -> Scenario:
    """A scenario: `given` itself, that of a file, or that of tables as a file has them."""
    if isinstance(given, Scenario):
        return given
    return scenario_of(given, "scenario") if isinstance(given, Mapping) else read_scenario(given)


def scenario_of(tables: Mapping[str, Any], source: str) -> Scenario:
    """The scenario of tables as a TOML file has them; `source` names them in messages."""
    known = ["set", *Times._fields, "aero", *SECTIONS, "steering", "start", "pilot"]
    for key in tables:
        if key not in known:
            raise unknown_key(key, known, "", source)
    overrides = {key: tables[key] for key in ("aero", *SECTIONS) if key in tables}
    if not isinstance(name := tables.get("set", "laksa"), str):
        raise InputError(f"set must be a text, got {name!r} ({source})")
    parameters = parameter_set(name, overrides, source)
    times = checked(Times, {k: tables[k] for k in Times._fields if k in tables}, "", source)
    if times.output_interval > times.duration:
        raise InputError(
            f"output_interval must be <= duration = {times.duration} s, "
            f"got {times.output_interval} s ({source})"
        )
    check_rows(times, f"output_interval = {times.output_interval:g} s", source)
    steering = _section(tables, "steering", source)
    steered = "programme" in steering
    programme = _programme(steering, parameters, times, source)
    start = _start(_section(tables, "start", source), parameters, source)
    pilot = _pilot(tables, steered, source)
    return Scenario(source, parameters, programme, start, times, steered, pilot)


def _pilot(tables: Mapping[str, Any], steered: bool, source: str) -> PilotSettings | None:
    if "pilot" not in tables:
        return None
    if steered:
        raise InputError(
            f"[pilot] and [steering] both want the stick: leave one of them out ({source})"
        )
    return checked(PilotSettings, _section(tables, "pilot", source), "pilot", source)


def check_rows(times: Times, asked: str, source: str) -> None:
    """Raises InputError for more rows than `MOST_ROWS`; `asked` is what makes them so many."""
    if times.duration / MOST_ROWS > times.output_interval:
        raise InputError(
            f"{asked} makes too many rows of {times.duration:g} s ({source}): at most {MOST_ROWS}, "
            f"one every {times.duration / MOST_ROWS:g} s"
        )


def _section(tables: Mapping[str, Any], name: str, source: str) -> dict[str, Any]:
    table = tables.get(name, {})
    if not isinstance(table, Mapping):
        raise InputError(f"{name} must be a table of named values, got {table!r} ({source})")
    return in_radians(table, name, source)


def _choice(table: dict[str, Any], key: str, choices: tuple[str, ...], source: str) -> str:
    """Takes `key` out of the table; its first choice is the default."""
    value = table.pop(key, choices[0])
    if value not in choices:
        raise InputError(f"{key} must be one of {', '.join(choices)}, got {value!r} ({source})")
    return str(value)


def _programme(
    table: dict[str, Any], parameters: Parameters, times: Times, source: str
) -> Programme:
    rest = rest_ell(parameters.lines.length, parameters.kite.y_A)
    kind = _choice(table, "programme", PROGRAMMES, f"{source}, [steering]")
    if kind == "table":
        rows = checked(SteeringTable, table, "steering", source)
        return _spline(rows, rest, parameters, times, source)
    odd = set(table) - {"ell", "delta"}
    if kind == "rest" and odd:
        raise InputError(
            f"steering.{odd.pop()} means nothing at rest: "
            f'add programme = "sine" ({source}, [steering])'
        )
    sines = checked(Sines, {"ell": rest, **table}, "steering", source)
    _check_reach(sines.ell - abs(sines.ell_amplitude), parameters, source)
    _check_tilt(abs(sines.delta) + abs(sines.delta_amplitude), source)
    return sines


def _spline(
    table: SteeringTable, rest: float, parameters: Parameters, times: Times, source: str
) -> Programme:
    t = np.array(table.t)
    ell = np.full(len(t), rest) if table.ell is None else np.array(table.ell)
    for name, column in (("ell", ell), ("delta", np.array(table.delta))):
        if len(column) != len(t):
            raise InputError(
                f"steering.{name} has {len(column)} values where steering.t has {len(t)}: "
                f"give one for each time ({source}, [steering])"
            )
    if len(t) < 2 or np.any(np.diff(t) < CLOSEST):
        known = f"2 or more ascending times, {CLOSEST:g} s apart or more"
        raise InputError(f"steering.t must hold {known} ({source}, [steering])")
    if t[0] > 0 or t[-1] < times.duration:
        raise InputError(
            f"steering.t must reach from 0 s to the duration {times.duration} s, "
            f"got {t[0]} s to {t[-1]} s ({source}, [steering])"
        )
    _check_reach(float(ell.min()), parameters, source)
    _check_tilt(float(np.abs(table.delta).max()), source)
    columns = (CubicSpline(t, column).c for column in (ell, np.array(table.delta)))
    return Spline(t, *map(np.ascontiguousarray, columns))


def _check_reach(ell: float, parameters: Parameters, source: str) -> None:
    if ell <= parameters.kite.y_A:
        raise InputError(
            f"steering.ell must stay > kite.y_A = {parameters.kite.y_A} m, "
            f"got {ell} m ({source}, [steering])"
        )


def _check_tilt(delta: float, source: str) -> None:
    if delta >= pi / 2:
        raise InputError(
            f"steering.delta must stay below π/2 rad, got {delta} rad ({source}, [steering]); "
            f"for degrees write delta_deg or delta_amplitude_deg"
        )


def _start(table: dict[str, Any], parameters: Parameters, source: str) -> State:
    at = _choice(table, "at", STARTS, f"{source}, [start]")
    given = checked(Offsets, table, "start", source)
    q, q_dot = Angles(*given[:4]), Angles(*given[4:])
    if at == "equilibrium":
        base = equilibrium_state(parameters, source).q
        q = Angles(*(a + b for a, b in zip(base, q, strict=True)))
    return State(q, q_dot)
