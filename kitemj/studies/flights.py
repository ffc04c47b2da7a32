"""A flight of a study, and its row in the table of results."""

import json
from collections.abc import Sequence
from time import thread_time
from typing import Any, NamedTuple

import numpy as np

from kitemj.autopilot.guided_flight import simulate_as_said
from kitemj.dynamics.batch import ALPHA, BETA, CLEARANCE, TENSIONS, X, Z
from kitemj.dynamics.formulation import make_model
from kitemj.dynamics.ground import TOUCH, clearance
from kitemj.flight.limits import GROUND, SLACK, Ending, batch_numbers, departure_in
from kitemj.flight.pilot_settings import Guided
from kitemj.flight.scenario import Scenario, scenario_of
from kitemj.physics.compiled import Array
from kitemj.physics.parameter_files import NAMED_BY
from kitemj.physics.rig import Rig, rig_of
from kitemj.registry import use
from kitemj.studies.design import Point
from kitemj.studies.study import Base, Settings

Row = dict[str, Any]


def _extremes(rig: Rig) -> list[tuple[str, int, float]]:
    """Names of two columns of results, the column of the batch, and its unit in theirs."""
    return [
        *((f"tension_{name}_{{}}_N", TENSIONS + i, 1.0) for i, name in enumerate(rig.lines)),
        ("alpha_{}_deg", ALPHA, 180 / np.pi),
        ("beta_{}_deg", BETA, 180 / np.pi),
    ]


def result_columns(rig: Rig) -> dict[str, type]:
    """Columns after `flight` and the inputs.

    Extremes are over the scenario's output times; cost is the processor's time, which others
    who use the machine do not lengthen.
    """
    extremes = [name.format(end) for name, *_ in _extremes(rig) for end in ("min", "max")]
    return {
        **dict.fromkeys(("model", "ending", "reason", "departure"), str),
        **dict.fromkeys(("departure_t_s", "flown_s", *extremes, "clearance_min_m"), float),
        **dict.fromkeys(("gap_max_m", "gap_until_s", "cost_s"), float),
        "pilot_phase": str,
        **dict.fromkeys(("path_laps", "path_error_rms_deg", "path_error_max_deg"), float),
    }


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
    row = _inputs(flight, point)
    source = f"{base.source}, flight {flight}"
    try:
        tables, settings = base.at(point)
        row["model"] = settings.model
        for model in filter(None, (settings.model, settings.reference)):
            _warm_up(tables, model, source)
        started = thread_time()
        scenario = scenario_of(tables, source)
        flown = _flown(scenario, settings.model, settings)
        row["cost_s"] = thread_time() - started
        row |= _summary(scenario, flown) | _guided_summary(flown.guided)
        if settings.reference:
            row |= _gap(scenario, flown, _flown(scenario, settings.reference, settings))
    except Exception as error:
        said = str(error) if isinstance(error, ValueError | RuntimeError) else repr(error)
        row |= {"ending": FAILED, "reason": said}
    return row


def failed(flight: int, point: Point, reason: str) -> Row:
    """The row of a flight whose process ended in it."""
    return _inputs(flight, point) | {"ending": FAILED, "reason": reason}


def _inputs(flight: int, point: Point) -> Row:
    plain = (int, float, str)
    texts = {k: json.dumps(x, default=str) for k, x in point.items() if not isinstance(x, plain)}
    return {"flight": flight, **point, **texts}


class Flown(NamedTuple):
    """A row of the batch's columns at each of `times` [s], and what an autopilot told there.

    `whole`: whether to the scenario's end.
    """

    times: list[float]
    rows: Array
    whole: bool
    guided: Sequence[Guided | None] = ()


def _flown(scenario: Scenario, model: str, settings: Settings) -> Flown:
    """By the autopilot in ticks, where the scenario has one, else by its programme."""
    if scenario.pilot is not None:
        return _piloted(scenario, model, settings)
    kite = make_model(model, scenario.parameters, settings.step)
    kite.start(scenario.start, scenario.programme)
    times = scenario.output_times
    rows = kite.batch(scenario.programme, np.array(times), TOUCH, settings.tolerance)
    return Flown(times[: len(rows)], rows, len(rows) == len(times))


def _piloted(scenario: Scenario, model: str, settings: Settings) -> Flown:
    found, kite = simulate_as_said(scenario, model, settings.step), scenario.parameters.kite
    rows = [
        [
            *motion.body.p_G_E,
            *motion.air[:2],
            clearance(kite.chord, kite.span, *motion.body[:2]),
            *motion.tensions,
        ]
        for motion in found.motions
    ]
    whole = found.ending is Ending.FINISHED
    return Flown([motion.t for motion in found.motions], np.array(rows), whole, found.guided)


def _guided_summary(guided: Sequence[Guided | None]) -> Row:
    """How the path was followed: laps, deg off it where it was flown, the last phase."""
    told = [each for each in guided if each]
    if not told:
        return {}
    errors = np.degrees([each.error for each in told if each.phase == "path"])
    summary: Row = {"pilot_phase": told[-1].phase, "path_laps": told[-1].lap}
    if len(errors):
        summary["path_error_rms_deg"] = float(np.sqrt(np.mean(errors**2)))
        summary["path_error_max_deg"] = float(np.abs(errors).max())
    return summary


def _warm_up(tables: dict[str, Any], model: str, source: str) -> None:
    """Loads (or compiles) what the flight needs, so that its cost is that of flying."""
    choices = (("steering", "programme"), *NAMED_BY.items())
    kind = (model, *(tables.get(section, {}).get(key) for section, key in choices))
    if kind not in _warm:
        scenario = scenario_of(tables, source)
        kite = make_model(model, scenario.parameters)
        kite.start(scenario.start, scenario.programme)
        kite.batch(scenario.programme, np.array([0.0, 1e-3]), TOUCH, 1e-3)
        _warm.add(kind)


def _summary(scenario: Scenario, flown: Flown) -> Row:
    times, rows, whole, _ = flown
    if not len(rows):
        return {"ending": Ending.DIVERGED.name.lower(), "flown_s": 0.0}
    ending = Ending.FINISHED
    if rows[-1, CLEARANCE] < TOUCH:
        ending = Ending.GROUND
    elif not whole:
        ending = Ending.DIVERGED
    summary: Row = {"ending": ending.name.lower(), "flown_s": times[-1]}
    departure = departure_in(scenario.parameters.limits, times, batch_numbers(rows))
    if departure:
        summary |= {"departure": departure.limit.name, "departure_t_s": departure.t}
    for name, column, scale in _extremes(rig_of(scenario.parameters)):
        summary[name.format("min")] = scale * float(rows[:, column].min())
        summary[name.format("max")] = scale * float(rows[:, column].max())
    summary["clearance_min_m"] = float(rows[:, CLEARANCE].min())
    return summary


def _gap(scenario: Scenario, flown: Flown, reference: Flown) -> Row:
    """Largest distance [m] of the two, before a line is slack or a kite down (see `compare`)."""
    limits, n = scenario.parameters.limits, min(len(flown.rows), len(reference.rows))
    rows, others = flown.rows[:n], reference.rows[:n]
    numbers = [batch_numbers(each) for each in (rows, others)]
    kept = [limit.kept(limits, each) for limit in (SLACK, GROUND) for each in numbers]
    n = int(np.logical_and.accumulate(np.logical_and.reduce(kept)).sum())
    if n == 0:
        return {}
    gaps = np.linalg.norm(rows[:n, X : Z + 1] - others[:n, X : Z + 1], axis=1)
    return {"gap_max_m": float(gaps.max()), "gap_until_s": flown.times[n - 1]}
