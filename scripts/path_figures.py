"""Figures of the manual on paths: shapes of eights, and what is worked out beside what is flown."""

from math import cos, degrees, pi, radians

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from kitemj.autopilot.autopilot import Autopilot
from kitemj.autopilot.guided_flight import pilot_of
from kitemj.autopilot.rehearse import on_path
from kitemj.flight.equilibrium import equilibrium
from kitemj.flight.pilot_settings import PathSettings, PilotSettings, TurnRateLaw
from kitemj.flight.scenario import scenario_of
from kitemj.paths.check_path import usual_path
from kitemj.paths.feasibility import turning_on
from kitemj.paths.glide import glide_ratio, with_weight
from kitemj.paths.lemniscate import flat, half_height, sharpest_bend, widest
from kitemj.paths.path import Path, path_of
from kitemj.physics.parameter_files import parameter_set
from kitemj.physics.parameters import Parameters
from kitemj.physics.vectors import norm
from kitemj.pilots.piloted import simulate_pilot
from kitemj.pilots.sight import sight

LAW = TurnRateLaw(0.29, -3.0, 0.4, 16.0, 2.8)
"""About that of `sport`."""
WIDTH = radians(80.0)
RATIOS = (0.25, 0.33, 0.45)
"""Heights in widths."""
WIND = 5.0
"""m/s; the lighter, the more weight counts."""
LAPS = 6.0
DIM, MARK, DARK = "#999999", "#c8201f", "#333333"

Values = NDArray[np.float64]


def shapes(figure: Figure) -> None:
    """Eights of one width and three heights: Gerono's, Bernoulli's, and the one that is flown."""
    t = np.linspace(0.0, 2 * pi, 400)
    for axes, ratio in zip(figure.subplots(3, 1), RATIOS, strict=True):
        height = ratio * WIDTH
        best, _ = widest(WIDTH, height)
        for m, colour, style, name in (
            (0.0, DIM, ":", "Gerono"),
            (1.0, DIM, "--", "Bernoulli"),
            (best, MARK, "-", f"m = {best:.2f}"),
        ):
            (x, *_), (y, *_) = flat(t, np.tan(WIDTH / 4), half_height(WIDTH, height, m), m)
            bend = 1 / sharpest_bend(WIDTH, height, m)
            told = f"{name}: {degrees(bend):.1f} deg"
            right, up = (np.degrees(np.arcsin(2 * part / (1 + x * x + y * y))) for part in (x, y))
            axes.plot(right, up, style, color=colour, label=told)
        axes.set(aspect="equal", ylabel="up [deg]", xlim=(-42, 92), ylim=(-19, 19))
        axes.set_title(f"height {ratio:g} of the width", fontsize=11)
        axes.legend(frameon=False, fontsize=9, loc="right", title="least radius")
    axes.set_xlabel("right [deg]")


def worked_out(figure: Figure) -> None:
    """The usual eight of `sport`: place in the window, speed and stick, worked out and flown."""
    known = parameter_set("sport")
    parameters = known._replace(wind=known.wind._replace(speed=WIND))
    settings = usual_path(parameters, LAW)
    light = path_of(settings, glide_ratio(parameters))
    heavy = with_weight(light, parameters)
    lap, speed, delta, seen = flown(parameters, settings)
    sky, fast, stick = figure.subplots(3, 1)
    on_the_sky(sky, light, seen, parameters)
    part = np.arange(len(light.points)) / len(light.points)
    order = np.argsort(lap)
    fast.plot(part, light.speed, ":", color=DIM, label="by glide alone")
    fast.plot(part, heavy.speed, "--", color=DARK, label="with weight and mass")
    fast.plot(lap[order], speed[order], color=MARK, label="flown")
    fast.set(ylabel="speed [winds]", xlim=(0, 1), ylim=(0, None))
    fast.legend(frameon=False, fontsize=9, ncols=3, loc="lower center")
    turning, gain, by_weight = turning_on(heavy, parameters, LAW)
    stick.plot(part, np.degrees((turning - by_weight) / gain), "--", color=DARK)
    stick.plot(lap[order], np.degrees(delta[order]), color=MARK)
    full = degrees(parameters.stick.delta)
    for limit in (-full, full):
        stick.axhline(limit, color=DIM, lw=0.8)
    stick.set(xlabel="part of the lap", ylabel="δ [deg]", xlim=(0, 1))


def on_the_sky(axes: Axes, path: Path, seen: Values, parameters: Parameters) -> None:
    """The path, where the kite was, and the edge of the window."""
    x, y, z = path.points.T
    axes.plot(np.degrees(np.arctan2(y, x)), np.degrees(np.arcsin(z)), "--", color=DARK)
    axes.plot(*np.degrees(seen.T), color=MARK)
    rest = pi / 2 - equilibrium(parameters).gamma
    around = np.linspace(-rest, rest, 201)
    edge = np.degrees(np.arccos(np.minimum(cos(rest) / np.cos(around), 1.0)))
    axes.plot(np.degrees(around), edge, color=DIM, lw=1.0)
    axes.axhspan(-5.0, 0.0, color="#9bb28a", lw=0)
    axes.set(xlabel="azimuth [deg], right positive", ylabel="elevation [deg]", aspect="equal")
    axes.set(xlim=(-80, 80), ylim=(-5, 75))


def flown(parameters: Parameters, settings: PathSettings) -> tuple[Values, Values, Values, Values]:
    """Of the last lap of `LAPS`: its part, speed [winds], δ [rad], azimuth and elevation [rad]."""
    pilot = Autopilot(parameters, PilotSettings(("path",), settings), LAW)
    flight, rows = on_path(parameters, pilot.path), []
    while pilot.guided.lap < LAPS or not rows:
        motion = flight.result.motion
        flight.tick(pilot.command(motion))
        if pilot.guided.lap >= LAPS - 1.0:
            p, v = motion.body.p_G_E, norm(motion.body.v_G_E)
            place = np.arctan2(-p.y, -p.x), np.arcsin(-p.z / norm(p))
            rows.append((pilot.guided.lap % 1.0, v / WIND, motion.control.delta, *place))
    table = np.array(rows)
    return table[:, 0], table[:, 1], table[:, 2], table[:, 3:]


def flown_eight(figure: Figure) -> None:
    """A minute of `pilot_eight` over its path: exact sensors, and those of a real kite."""
    real = {"rate": 50.0, "delay": 0.05, "noise_deg": 1.0}
    rows = {"exact sensors": {}, "1° of noise, 50 a second, 50 ms late": real}
    for axes, (what, sensors) in zip(figure.subplots(2, 1), rows.items(), strict=True):
        tables = {"set": "sport", "duration": 60.0, "output_interval": 0.05}
        scenario = scenario_of({**tables, "pilot": {"sensors": sensors}}, what)
        pilot = pilot_of(scenario)
        assert isinstance(pilot, Autopilot)
        motions = simulate_pilot(scenario, pilot, "lagrange").motions
        seen = np.degrees([sight(motion)[:2] for motion in motions])
        x, y, z = pilot.path.points.T
        wished = np.degrees([np.arctan2(y, x), np.arcsin(z)])
        axes.plot(*np.column_stack((wished, wished[:, :1])), color=DIM, lw=5, alpha=0.6)
        axes.plot(*seen.T, color=MARK, lw=0.7)
        axes.plot(*seen[0], "o", color=DARK, ms=4)
        axes.set(title=what, xlabel="azimuth [deg]", ylabel="elevation [deg]", aspect="equal")
