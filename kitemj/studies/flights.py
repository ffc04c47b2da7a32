"""A flight of a study, and its row in the table of results."""

import json
from collections.abc import Sequence
from time import thread_time
from typing import Any

import numpy as np

from kitemj.dynamics.batch import (
    ALPHA,
    BETA,
    CLEARANCE,
    TENSIONS,
    Array,
    X,
    Z,
)
from kitemj.dynamics.formulation import make_model
from kitemj.flight.limits import TOUCH, Ending
from kitemj.flight.scenario import Scenario, scenario_of
from kitemj.physics.parameters import Parameters
from kitemj.registry import use
from kitemj.studies.design import Point
from kitemj.studies.study import Base, Settings

Row = dict[str, Any]

RESULTS: dict[str, type] = {
    "model": str,
    "ending": str,
    "reason": str,
    "departure": str,
    "departure_t_s": float,
    "flown_s": float,
    **{
        f"{name}_{end}_{unit}": float
        for name, unit in (
            ("tension_plus", "N"),
            ("tension_minus", "N"),
            ("alpha", "deg"),
            ("beta", "deg"),
        )
        for end in ("min", "max")
    },
    "clearance_min_m": float,
    "gap_max_m": float,
    "gap_until_s": float,
    "cost_s": float,
}
"""Columns after `flight` and the inputs. Extremes are over the scenario's output times; cost
is the processor's time, which others who use the machine do not lengthen."""

FAILED = "failed"
"""The ending of what could not be flown; the others are the names of `Ending`."""

_warm: set[tuple[Any, ...]] = set()


def fly_all(base: Base, flights: Sequence[tuple[int, Point]]) -> list[Row]:
    """A row for each flight."""
    for module in base.modules:
        use(module)
    return [fly(base, flight, point) for flight, point in flights]


def fly(base: Base, flight: int, point: Point) -> Row:
    """The row of one flight; what goes wrong in it is its reason, never an exception."""
    row: Row = {"flight": flight, **{name: _plain(value) for name, value in point.items()}}
    source = f"{base.source}, flight {flight}"
    try:
        tables, settings = base.at(point)
        row["model"] = settings.model
        for model in filter(None, (settings.model, settings.reference)):
            _warm_up(tables, model, source)
        started = thread_time()
        scenario = scenario_of(tables, source)
        rows = _batch_rows(scenario, settings.model, settings)
        row["cost_s"] = thread_time() - started
        row |= _summary(scenario, rows)
        if settings.reference:
            row |= _gap(scenario, rows, _batch_rows(scenario, settings.reference, settings))
    except Exception as error:
        said = str(error) if isinstance(error, ValueError | RuntimeError) else repr(error)
        row |= {"ending": FAILED, "reason": said}
    return row


def failed(flight: int, point: Point, reason: str) -> Row:
    """The row of a flight whose process ended in it."""
    return {
        "flight": flight,
        **{name: _plain(value) for name, value in point.items()},
        "ending": FAILED,
        "reason": reason,
    }


def _plain(value: Any) -> Any:
    return json.dumps(value) if isinstance(value, (dict, list)) else value


def _batch_rows(scenario: Scenario, model: str, settings: Settings) -> Array:
    kite = make_model(model, scenario.parameters, settings.step)
    kite.start(scenario.start, scenario.programme)
    times = np.array(scenario.output_times)
    return kite.batch(scenario.programme, times, TOUCH, settings.tolerance)


def _warm_up(tables: dict[str, Any], model: str, source: str) -> None:
    """Loads (or compiles) what the flight needs, so that its cost is that of flying."""
    choices = (("steering", "programme"), ("aero", "law"), ("wind", "law"))
    kind = (model, *(tables.get(section, {}).get(key) for section, key in choices))
    if kind not in _warm:
        scenario = scenario_of(tables, source)
        kite = make_model(model, scenario.parameters)
        kite.start(scenario.start, scenario.programme)
        kite.batch(scenario.programme, np.array([0.0, 1e-3]), TOUCH, 1e-3)
        _warm.add(kind)


def _summary(scenario: Scenario, rows: Array) -> Row:
    times = scenario.output_times
    if not len(rows):
        return {"ending": Ending.DIVERGED.name.lower(), "flown_s": 0.0}
    ending = Ending.FINISHED
    if rows[-1, CLEARANCE] < TOUCH:
        ending = Ending.GROUND
    elif len(rows) < len(times):
        ending = Ending.DIVERGED
    summary: Row = {"ending": ending.name.lower(), "flown_s": times[len(rows) - 1]}
    summary |= _departure(scenario.parameters, rows, times)
    for name, column, scale in (
        ("tension_plus_{}_N", TENSIONS, 1.0),
        ("tension_minus_{}_N", TENSIONS + 1, 1.0),
        ("alpha_{}_deg", ALPHA, 180 / np.pi),
        ("beta_{}_deg", BETA, 180 / np.pi),
    ):
        summary[name.format("min")] = scale * float(rows[:, column].min())
        summary[name.format("max")] = scale * float(rows[:, column].max())
    summary["clearance_min_m"] = float(rows[:, CLEARANCE].min())
    return summary


def _departure(parameters: Parameters, rows: Array, times: list[float]) -> Row:
    """The limit of validity that is left first, and when; as `first_departure` of motions."""
    limits = parameters.limits
    alpha, pull = rows[:, ALPHA], rows[:, TENSIONS:].min(axis=1)
    outside = {
        Ending.SLACK: pull <= 0.0,
        Ending.STALL: ~((alpha > 0.0) & (alpha < limits.alpha_stall)),
        Ending.SIDESLIP: ~(np.abs(rows[:, BETA]) < limits.beta_max),
    }
    first = [(int(out.argmax()), ending) for ending, out in outside.items() if out.any()]
    if not first:
        return {}
    i, ending = min(first, key=lambda each: each[0])
    return {"departure": ending.name.lower(), "departure_t_s": times[i]}


def _gap(scenario: Scenario, rows: Array, reference: Array) -> Row:
    """Largest distance [m] of the two, until a line of either is slack (see `compare`)."""
    n = min(len(rows), len(reference))
    pulls = np.minimum(rows[:n, TENSIONS:], reference[:n, TENSIONS:])
    slack = (pulls <= 0.0).any(axis=1)
    n = int(slack.argmax()) if slack.any() else n
    if n == 0:
        return {}
    gaps = np.linalg.norm(rows[:n, X : Z + 1] - reference[:n, X : Z + 1], axis=1)
    return {"gap_max_m": float(gaps.max()), "gap_until_s": scenario.output_times[n - 1]}
