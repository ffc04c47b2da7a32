"""The verbs of the front door: each takes a file's name, tables or a thing itself, and flies.

A scenario is given as the path of its file, as a dictionary of its tables, or as a `Scenario`;
a study likewise. Nothing is written unless a path is given for it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from kitemj.dynamics.formulation import DEFAULT_STEP, MODELS
from kitemj.errors import InputError
from kitemj.flight.scenario import Scenario, as_scenario
from kitemj.tables import Results

if TYPE_CHECKING:
    from kitemj.equilibria.cycle import Cycle
    from kitemj.equilibria.modes import Stability
    from kitemj.equilibria.trim import Trim
    from kitemj.flight.compare import Comparison
    from kitemj.pilots.manoeuvres import Pilot
    from kitemj.plots.flight import Flight
    from kitemj.recording.file import Recording
    from kitemj.recording.replay import Replay
    from kitemj.robustness.margins import LoopMargins
    from kitemj.studies.result import StudyResult
    from kitemj.studies.study import Study
    from kitemj.turning.identification import Identification

Given = Scenario | str | Path | Mapping[str, Any]
"""What a scenario can be given as."""


def simulate(
    scenario: Given,
    model: str = "mujoco",
    *,
    step: float = DEFAULT_STEP,
    pilot: Pilot | Callable[[], Pilot] | str | None = None,
) -> Flight:
    """The flight of `scenario`, with a row at each of its output times.

    `model` flies it; `step` [s] is the longest step of models with fixed steps; `pilot` has the
    stick in place of the scenario's programme: an object with `command(motion)`, what makes
    one, a name such as "eight", or FILE.py:NAME. Raises InputError.
    """
    from kitemj.autopilot.guided_flight import simulate_as_said
    from kitemj.pilots.piloted import simulate_pilot
    from kitemj.pilots.registry import as_pilot
    from kitemj.plots.flight import flight_of_simulation

    flown = as_scenario(scenario)
    if pilot is None:
        return flight_of_simulation(simulate_as_said(flown, model, step))
    return flight_of_simulation(simulate_pilot(flown, as_pilot(pilot), model, step))


def compare(
    scenario: Given, models: Sequence[str] = tuple(MODELS.shipped), *, step: float = DEFAULT_STEP
) -> Results[Comparison]:
    """How far each of `models` gets from the last of them, flying `scenario`; `step` [s].

    Each `agrees` if it keeps within the tolerances. Raises InputError.
    """
    from kitemj.autopilot.guided_flight import simulate_as_said
    from kitemj.flight.compare import compare_models
    from kitemj.flight.compare_table import comparison_table

    if len(models) < 2:
        raise InputError(f"models needs two or more, got {', '.join(models) or 'none'}")
    found = compare_models(as_scenario(scenario), models, step, simulate_as_said)
    return Results(found, comparison_table)


def trim(scenario: Given, model: str = "lagrange") -> Results[Trim]:
    """Every equilibrium of the scenario's kite in its steady wind, by ascending α, lines held.

    Raises InputError where there is none.
    """
    from kitemj.equilibria.tables import trim_table
    from kitemj.equilibria.trim import equilibria

    return Results(equilibria(*_held(scenario, model)), trim_table)


def stability(scenario: Given, model: str = "lagrange") -> Stability:
    """The linear system and modes about the equilibrium of least α, lines held.

    Raises InputError where there is no equilibrium.
    """
    from kitemj.equilibria.modes import stability

    return stability(*_held(scenario, model))


def cycle(scenario: Given, model: str = "lagrange") -> Cycle:
    """The cycle that the kite flies by itself beside an unstable equilibrium, lines held.

    Raises InputError where there is none.
    """
    from kitemj.equilibria.cycle import cycle

    return cycle(*_held(scenario, model))


def identify(scenario: Given, model: str = "lagrange") -> Identification:
    """How the scenario's kite turns in its wind: by a test flight of `model`.

    The name of a parameter set will do. Raises InputError where there is no equilibrium to
    begin at; that no law holds is an answer, told by `holds`.
    """
    from kitemj.flight.scenario import parameters_named
    from kitemj.turning.identify import identify

    if isinstance(scenario, str | Path):
        return identify(parameters_named(str(scenario)), model, Path(scenario).name)
    known = as_scenario(scenario)
    return identify(known.parameters, model, known.source)


def margins(scenario: Given, points: int = 16) -> LoopMargins:
    """The margins of the loop of the scenario's pilot, frozen at `points` of a lap and over it.

    Raises InputError for a scenario without [pilot], and a path that is not followed.
    """
    from kitemj.flight.pilot_settings import PilotSettings
    from kitemj.robustness.margins import loop_margins

    known = as_scenario(scenario)
    settings = getattr(known, "pilot", PilotSettings())
    if settings is None:
        raise InputError(f"margins are those of a pilot: add a table [pilot] ({known.source})")
    return loop_margins(known, settings, points)


def replay(
    recording: Recording | str | Path,
    model: str,
    step: float | None = None,
    *,
    closed_loop: bool = False,
) -> Replay:
    """The input of a recording flown again by `model`, in steps of `step` [s] or the recorded.

    In a `closed_loop` its autopilot flies again, by what it sees of `model`.

    Raises InputError.
    """
    from kitemj.recording.file import Recording, read_recording
    from kitemj.recording.replay import replay

    known = recording if isinstance(recording, Recording) else read_recording(recording)
    return replay(known, model, step, closed_loop)


def sweep(
    study: Study | str | Path | Mapping[str, Any], *, processes: int | None = None
) -> StudyResult:
    """The flights of `study`, a row for each; a study of seconds is flown in this process.

    A longer one is flown by `processes` (None: one for each core), which begin by reading the
    script that called: there, keep the call below ``if __name__ == "__main__":``. Raises
    InputError, and StudyStopped where workers cannot work.
    """
    from pyarrow import parquet

    from kitemj.progress_bar import progress_bar
    from kitemj.studies.executors import executor_for
    from kitemj.studies.journal import Journal
    from kitemj.studies.result import StudyResult
    from kitemj.studies.study import as_study
    from kitemj.studies.sweep import check, sweep, tried
    from kitemj.temporary import temporary_folder

    known = as_study(study)
    check(known)
    with temporary_folder() as folder:
        path = folder / "study.parquet"
        with Journal(path, known) as journal:
            cost = tried(journal)
            flights = len(journal.done)
            bar = progress_bar("flights", flights, journal.count)
            with executor_for(cost * (flights - journal.count), processes) as executor, bar as tell:
                sweep(journal, executor, cost, tell)
            journal.write_table(path, overwrite=False)
        return StudyResult(known.base.source, parquet.read_table(path))


def film(
    source: Flight | Recording | Given,
    path: str | Path,
    *,
    model: str | None = None,
    view: str = "pilot",
    size: tuple[int, int] | None = None,
    rate: int | None = None,
    speed: float = 1.0,
    turn: float = 0.0,
    title: str = "",
    instruments: str = "pilot",
    overwrite: bool = False,
) -> Path:
    """Films a flight, a recording or a scenario, and returns the film's path.

    `path`: the film, .mp4, .webp or .gif
    `model`: flies a scenario (mujoco), or the input of a recording again, beside it
    `view`: pilot, chase, side, top or orbit
    `size`: width and height [px]; None: 1280 x 720; of a WebP 640 x 360, of a GIF 480 x 270
    `rate`: frames/s of the film; None: 30; of a WebP 20, of a GIF 12
    `speed`: of the flight on the film, 2: twice as fast as it was
    `turn`: with the view orbit, degrees/s that it goes round the kite, positive to the right
    `title`: over the first 3 s
    `instruments`: how much is shown over the view: pilot, engineer or none
    `overwrite`: whether a file that is there may be replaced

    Raises InputError, and NoGraphics where nothing can draw.
    """
    from kitemj.cockpit.film_sources import film_source
    from kitemj.cockpit.filming import FilmStyle, check_output, film, usual_for

    path = Path(path)
    usual = usual_for(path)
    size, rate = size or usual.size, usual.rate if rate is None else rate
    style = FilmStyle(size, view, instruments, rate, speed, turn, title)
    check_output(path, style, still=False, overwrite=overwrite)
    film([film_source(source, model, None, speed / rate)], path, style, overwrite=overwrite)
    return path


def _held(scenario: Given, model: str) -> tuple[Any, float | None, float, str, str]:
    """A scenario's parameters, ℓ [m] and δ [rad] its lines are held at, `model`, its source."""
    from kitemj.equilibria.trim import lines_held

    known = as_scenario(scenario)
    return known.parameters, *lines_held(known.parameters, known.programme), model, known.source
