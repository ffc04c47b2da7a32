"""What `kitemj fly` does with its words: a window if there is a display, else a film."""

import argparse
from datetime import datetime
from pathlib import Path

from kitemj.cockpit.fly import fly
from kitemj.cockpit.picture import Picture
from kitemj.cockpit.screens import FilmScreen, Screen, Window, display_found
from kitemj.flight.live import LiveFlight
from kitemj.flight.output import check_new
from kitemj.flight.scenario import Scenario, read_scenario, scenario_of

SHOW_DURATION = 20.0
"""s; of a flight that nobody watches."""


def fly_session(words: argparse.Namespace, size: tuple[int, int]) -> int:
    """Flies, prints the summary, returns the exit status; see `kitemj fly --help`."""
    scenario = _scenario(words.scenario)
    windowed = not words.headless and display_found()
    if not windowed:
        path = words.film or Path(f"kitemj-{datetime.now():%Y%m%d-%H%M%S}.mp4")
        check_new(path, overwrite=False)
        duration = words.duration or SHOW_DURATION
        why = "as asked" if words.headless else "there is no display"
        print(f"{why}: a programmed stick flies {duration:g} s in real time into {path}")
    flight = LiveFlight(scenario, words.model, step=words.step)
    with Picture(scenario.parameters, *size) as picture:
        screen: Screen = (
            Window(*size, f"kitemj: {scenario.source}") if windowed else FilmScreen(path, *size)
        )
        screen.view = words.view
        limit = words.duration if windowed else duration
        print(fly(flight, picture, screen, limit, words.called))
    if not windowed:
        print(f"film         {path}")
    return 0


def _scenario(path: Path | None) -> Scenario:
    """The scenario of the file, or the kite of the thesis in its wind."""
    if path is not None:
        return read_scenario(path)
    return scenario_of({"set": "thesis", "duration": 60.0}, "the thesis kite on 80 m lines")
