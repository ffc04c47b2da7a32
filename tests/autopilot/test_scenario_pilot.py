"""A pilot in a scenario: read, flown, compared, recorded, replayed with the loop closed, swept."""

import re
from pathlib import Path
from typing import Any, get_args, get_type_hints

import numpy as np
import pytest

import kitemj
from kitemj.autopilot.autopilot import Autopilot
from kitemj.errors import InputError
from kitemj.flight.guided_table import NOBODY, NUMBERS, PHASE
from kitemj.flight.pilot_settings import (
    PHASES,
    PathSettings,
    PilotSettings,
    SensorSettings,
    TurnRateLaw,
)
from kitemj.flight.scenario import scenario_of
from kitemj.physics.quantity import Quantity
from kitemj.plots.flight import Flight
from kitemj.recording.file import Recording, read_recording
from kitemj.recording.live import LiveFlight
from kitemj.recording.summary import summary

SECONDS = 6.0
"""Of a flight: enough to join the path from the top and turn on it."""
TABLES: dict[str, Any] = {
    "set": "sport",
    "duration": SECONDS,
    "output_interval": 0.1,
    "pilot": {
        "seed": 3,
        "path": {"elevation_deg": 39.0, "width_deg": 80.0, "height_deg": 27.0},
        "sensors": {"rate": 50.0, "delay": 0.05, "noise_deg": 0.5},
    },
}
WIDE = 55.0
"""deg of azimuth; a path 80 deg wide around 39 deg of elevation reaches 51 deg."""
LOOP_GAP = 1e-5
"""m; between formulations with an autopilot in the loop, as is claimed for a minute."""


def with_pilot(**changes: object) -> dict[str, Any]:
    """The tables with other entries under [pilot]."""
    return {**TABLES, "pilot": {**TABLES["pilot"], **changes}}


@pytest.fixture(scope="module")
def flight() -> Flight:
    return kitemj.simulate(TABLES, "lagrange")


@pytest.fixture(scope="module")
def recording(tmp_path_factory: pytest.TempPathFactory) -> Recording:
    """A flight of which a hand takes one second in the middle, and gives it back."""
    path = tmp_path_factory.mktemp("recording") / "guided.arrows"
    scenario = scenario_of(TABLES, "guided.toml")
    assert scenario.pilot
    pilot = Autopilot(scenario.parameters, scenario.pilot)
    with LiveFlight(scenario, "lagrange", record=path) as live:
        for k in range(300):
            if 100 <= k < 200:
                live.guided = None
                live.tick(kitemj.Command(0.1))
                continue
            if k == 200:
                pilot.restart(live.result.motion.t)
            command = pilot.command(live.result.motion)
            live.guided = pilot.guided
            live.tick(command)
    return read_recording(path)


def test_the_table_tells_phase_and_error(flight: Flight) -> None:
    phases = [PHASES[code] for code in flight[PHASE]]
    assert phases[0] == "climb"
    assert phases[-1] == "path"
    on_path = np.array(phases) == "path"
    assert np.isfinite(flight["path_error_deg"][on_path]).all()
    assert abs(flight["attractor_azimuth_deg"][on_path]).max() < WIDE
    assert flight["path_laps"][-1] > flight["path_laps"][on_path][0]


def test_models_agree_with_the_loop_closed() -> None:
    (compared,) = kitemj.compare(TABLES, ("newton-euler", "lagrange"))
    assert compared.phases is True
    assert 0.0 < compared.position.value < LOOP_GAP


def test_noise_is_that_of_the_seed(flight: Flight) -> None:
    again = kitemj.simulate(TABLES, "lagrange")
    other = kitemj.simulate(with_pilot(seed=4), "lagrange")
    assert np.array_equal(again["x_E_m"], flight["x_E_m"])
    assert not np.array_equal(other["x_E_m"], flight["x_E_m"])


def test_a_recording_carries_what_the_autopilot_told(recording: Recording) -> None:
    assert recording.pilot == scenario_of(TABLES, "guided.toml").pilot
    phases = recording.columns[PHASE]
    assert (phases[1:101] == PHASES.index("climb")).all()
    assert (phases[101:201] == NOBODY).all()
    assert all(np.isnan(recording.columns[name][101:201]).all() for name in NUMBERS)


def test_the_same_model_replays_to_the_same_bits(recording: Recording) -> None:
    assert kitemj.replay(recording, "lagrange").identical
    assert kitemj.replay(recording, "lagrange", closed_loop=True).identical


def test_another_model_flies_the_loop_again(recording: Recording) -> None:
    again = kitemj.replay(recording, "newton-euler", closed_loop=True)
    found = again.largest_gap(again.comparable)
    assert found
    assert 0.0 < found[0] < LOOP_GAP


def test_no_loop_is_closed_where_none_was(tmp_path: Path) -> None:
    path = tmp_path / "by_hand.arrows"
    with LiveFlight({"set": "sport", "duration": 1.0}, "lagrange", record=path) as live:
        live.tick(kitemj.Command())
    with pytest.raises(InputError, match="no autopilot of a scenario flew"):
        kitemj.replay(path, "newton-euler", closed_loop=True)


def test_a_table_of_a_guided_scenario_is_of_its_autopilot(flight: Flight, tmp_path: Path) -> None:
    path = tmp_path / "guided.toml"
    path.write_text(
        f'set = "sport"\nduration = {SECONDS}\n[pilot]\nseed = 3\n[pilot.path]\n'
        "elevation_deg = 39.0\nwidth_deg = 80.0\nheight_deg = 27.0\n[pilot.sensors]\nrate = 50.0\n"
        "delay = 0.05\nnoise_deg = 0.5\n"
    )
    read = kitemj.read_flight(path)
    assert read["x_E_m"][-1] == flight["x_E_m"][-1]
    assert read.plot("guidance").axes


def test_a_recording_says_who_flew_and_what_was_random(recording: Recording) -> None:
    assert recording.header.seeds == {"pilot": 3}
    told = summary(recording)
    assert "climb, path: lemniscate; 50 measurements/s, 50 ms late, 0.5° of noise" in told
    assert "flew 200 ticks of 301" in told


@pytest.mark.parametrize("interval", [0.001, 0.025])
def test_rows_of_a_sweep_are_at_ticks(interval: float) -> None:
    """Between ticks no guided flight is known; its length and ending are, whatever is asked."""
    grid = {"duration": [2.0], "output_interval": [interval]}
    study = {"scenario": "pilot_eight", "model": "lagrange", "grid": grid}
    (row,) = kitemj.sweep(study).table().to_pylist()
    assert (row["ending"], row["flown_s"]) == ("finished", 2.0)


def test_a_sweep_tells_how_the_path_was_followed() -> None:
    grid = {"pilot.crossover": [0.35, 0.4], "duration": [8.0]}
    study = {"scenario": "pilot_eight", "model": "lagrange", "grid": grid}
    rows = kitemj.sweep(study).table().to_pylist()
    assert [row["pilot_phase"] for row in rows] == ["path", "path"]
    assert rows[0]["path_error_rms_deg"] != rows[1]["path_error_rms_deg"]


@pytest.mark.parametrize(
    ("pilot", "sentence"),
    [
        ({"phases": ["climb", "fly"]}, "phases"),
        ({"sensors": {"rate": 200.0}}, "200"),
        ({"path": {"radius_deg": 22.0, "kind": "ring"}}, "kind"),
        ({"crossover": 3.0}, "crossover"),
        ({"path": {"elevation_deg": 80.0}}, "pilot.path"),
        ({"path": {"width_deg": 20.0, "height_deg": 7.0}}, "would do"),
        ({"paths": {}}, "paths"),
    ],
)
def test_what_cannot_be_flown_is_refused_in_a_sentence(
    pilot: dict[str, Any], sentence: str
) -> None:
    with pytest.raises(InputError, match=sentence) as error:
        kitemj.simulate({**TABLES, "pilot": pilot}, "lagrange")
    assert "\n" not in str(error.value)


def test_one_of_pilot_and_programme_steers() -> None:
    with pytest.raises(InputError, match="leave one of them out"):
        scenario_of({**TABLES, "steering": {"programme": "sine"}}, "both.toml")


def test_the_manual_names_every_key() -> None:
    """In the block of the page that is a scenario, as it is written in files."""
    page = (Path(__file__).parents[2] / "docs" / "autopilot.md").read_text(encoding="utf-8")
    block = page[page.index("[pilot]\n") : page.index("From Python:")]
    named = set(re.findall(r"\b\w+\b", block))
    for settings in (PilotSettings, PathSettings, SensorSettings, TurnRateLaw):
        hints = get_type_hints(settings, include_extras=True)
        for name, hint in hints.items():
            told = [each for each in get_args(hint) if isinstance(each, Quantity)]
            in_degrees = any(each.unit == "rad" for each in told)
            assert (f"{name}_deg" if in_degrees else name) in named, f"{settings}: {name}"
