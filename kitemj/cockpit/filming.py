"""A scenario flown and filmed with no screen, as fast as it goes."""

from dataclasses import replace
from pathlib import Path

from rich.progress import track

from kitemj.cockpit.film import Film
from kitemj.cockpit.picture import Picture, Readings
from kitemj.cockpit.screens import FRAME_RATE
from kitemj.flight.compare import position_gap
from kitemj.flight.scenario import Scenario
from kitemj.flight.simulate import simulate
from kitemj.flight.validity import departure_at


def film_scenario(
    scenario: Scenario,
    model: str,
    step: float,
    path: Path,
    size: tuple[int, int],
    view: str,
    overwrite: bool,
) -> None:
    """Films `model` flying `scenario` with the Lagrangian reference as its ghost.

    `size` in pixels; a progress bar on the terminal. Ctrl-C leaves a complete film of what
    was painted. Raises InputError, FileExistsError or NoGraphics before work is done.
    """
    framed = replace(scenario, times=scenario.times._replace(output_interval=1 / FRAME_RATE))
    with (
        Picture(scenario.parameters, *size) as picture,
        Film(path, *size, FRAME_RATE, overwrite) as film,
    ):
        flight, ghosts = simulate(framed, model, step), simulate(framed, "lagrange", step).motions
        try:
            for i, motion in enumerate(track(flight.motions, description=f"filming {path}")):
                ghost = ghosts[i] if i < len(ghosts) else None
                departure = departure_at(scenario.parameters, motion)
                readings = Readings(
                    model=model,
                    gap=position_gap(motion, ghost) if ghost else None,
                    delta_command=motion.control.delta,
                    stick="programme",
                    message=departure.ending.value if departure else "",
                )
                film.add(picture.paint(motion, ghost, readings, view))
        except KeyboardInterrupt:
            print(f"interrupted: {path} holds the first {film.frames / FRAME_RATE:.1f} s")
            return
    print(f"{path}: {film.frames} frames; {flight.ending.value}")
