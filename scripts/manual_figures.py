"""Draws the figures of the manual: frames, lines, equilibrium, laws of the stick, ways home,
the law of turning, paths.

    python scripts/manual_figures.py [FOLDER]       (docs/figures if left out)

Directions and points are computed by the program's own formulas, so that a figure cannot
contradict them; only the lines are drawn much shorter than they are.
"""

import sys
from collections.abc import Callable, Sequence
from math import atan2, cos, degrees, pi, radians, sin
from pathlib import Path

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Arc
from numpy.typing import NDArray

from handling_flights import Place as Start
from handling_flights import left_alone, on_the_sky
from kitemj.dynamics.motion import attachment_E
from kitemj.dynamics.straight import straight_body
from kitemj.flight.equilibrium import equilibrium_state
from kitemj.flight.live import TICK
from kitemj.physics.frames import R_1E, R_2E, Angles
from kitemj.physics.loads import aerodynamic_wrench
from kitemj.physics.parameter_files import parameter_set
from kitemj.physics.shaping import StickLaw, asked, shaped
from kitemj.physics.steering import Control, control, line_motion, rest_ell
from kitemj.physics.vectors import Vector, unrotated
from kitemj.turning.identification_plot import SIZE, draw_identification
from kitemj.turning.identify import identify
from path_figures import flown_eight, shapes, worked_out

ROOT = Path(__file__).parent.parent
Place = NDArray[np.float64]

LEFT, RIGHT, KITE, LINES, AIR, DIM = (
    "#c8201f",
    "#1f5fb4",
    "#333333",
    "#8a6d3b",
    "#2a8f5a",
    "#777777",
)
FRAMES = {"E": "#000000", "1": "#8a6d3b", "2": "#7a3fa0", "B": "#c05a00"}
STILL = Angles(0.0, 0.0, 0.0, 0.0)
ORIGIN = np.zeros(2)

mpl.rcParams |= {"svg.hashsalt": "kitemj", "font.size": 11, "axes.linewidth": 0.8}


def plain(figure: Figure, left: float, right: float, low: float, high: float) -> Axes:
    """Axes of these limits [m of paper], lengths true, no frame around."""
    axes = figure.add_subplot(xlim=(left, right), ylim=(low, high), aspect="equal")
    axes.axis("off")
    return axes


def stroke(
    axes: Axes, places: Sequence[Place], colour: str, style: str = "-", width: float = 1.2
) -> None:
    """A line through `places`."""
    axes.plot(*np.array(places).T, style, color=colour, lw=width, solid_capstyle="round")


def label(axes: Axes, place: Place, right: float, up: float, text: str, colour: str = "k") -> None:
    """Writes beside a place.

    axes: what is drawn in
    place: (x, y) in the units of `axes`, like all that follows
    right: from `place` to the middle of the text
    up: the same
    text: may hold formulas
    colour: as matplotlib names it
    """
    axes.text(place[0] + right, place[1] + up, text, color=colour, ha="center", va="center")


def arrow(axes: Axes, start: Place, way: Place, colour: str, name: str = "") -> None:
    """From `start` along `way`; the name stands behind the tip."""
    look = {"arrowstyle": "-|>", "color": colour, "lw": 1.6, "shrinkA": 0, "shrinkB": 0}
    axes.annotate("", start + way, start, arrowprops=look)
    label(axes, start + way, *(0.33 * way / np.hypot(*way)), name, colour)


def angle(axes: Axes, corner: Place, size: float, a: float, b: float, name: str) -> None:
    """Draws an arc counter-clockwise; its name stands outside.

    axes: what is drawn in
    corner: (x, y) in the units of `axes`, the centre
    size: its radius, in the same units
    a: rad, where it begins
    b: rad, where it ends
    name: may hold formulas
    """
    axes.add_patch(Arc(corner, 2 * size, 2 * size, theta1=degrees(a), theta2=degrees(b), color=DIM))
    middle = (a + b) / 2
    label(axes, corner, (size + 0.3) * cos(middle), (size + 0.3) * sin(middle), name)


def direction(v: Place) -> float:
    """Of a vector on paper [rad]."""
    return atan2(v[1], v[0])


def frames(figure: Figure) -> None:
    """All frames at once, from above the pilot's right shoulder."""
    axes = plain(figure, -4.4, 9.6, -3.2, 10.2)
    ahead = np.array([-0.5, 0.72, 0.42])
    ahead /= np.linalg.norm(ahead)
    right = np.cross(ahead, (0.0, 0.0, -1.0))
    right /= np.linalg.norm(right)
    up = np.cross(right, ahead)

    def seen(p_E: Sequence[float]) -> Place:
        return np.array([right @ p_E, up @ p_E])

    parameters = parameter_set("laksa")
    q = Angles(radians(25.0), radians(48.0), radians(14.0), radians(-20.0))
    body = straight_body(parameters, q, STILL, Control(9.0, 0.0, 0.0, 0.12, 0.0, 0.0))
    G_E = np.array(body.p_G_E)
    G, below = seen(G_E), seen(G_E * (1.0, 1.0, 0.0))
    ends = {side: np.array(attachment_E(parameters, body, side)) for side in (1.0, -1.0)}
    O_2 = seen((ends[1.0] + ends[-1.0]) / 2)

    ground = [(x, y, 0.0) for x, y in ((2.0, -4.0), (2.0, 6.5), (-9.5, 6.5), (-9.5, -4.0))]
    axes.fill(*np.array([seen(p) for p in ground]).T, color="#edf3e8", zorder=-3)
    stroke(axes, [G, below, ORIGIN], DIM, ":", 1.0)
    label(axes, below, 0.75, 0.0, "below G", DIM)
    arrow(axes, seen((1.2, -3.4, 0.0)), seen((-2.8, 0.0, 0.0)), AIR)
    label(axes, seen((-2.6, -3.4, 0.0)), -0.3, 0.0, "wind", AIR)

    x, y = parameters.kite.chord / 2, parameters.kite.span / 2
    outline = [(-x, y), (x, 0.8 * y), (1.4 * x, 0.0), (x, -0.8 * y), (-x, -y)]
    sail = [seen(np.add(G_E, unrotated(body.R_BE, Vector(*p, 0.0)))) for p in outline]
    axes.fill(*np.array(sail).T, color="#d7dfec", ec=KITE, lw=1.2, zorder=-1)
    for side, colour, name in ((1.0, LEFT, "A₊"), (-1.0, RIGHT, "A₋")):
        end = seen(ends[side])
        stroke(axes, [ORIGIN, end], colour, width=1.5)
        stroke(axes, [end, G], KITE, width=0.8)
        label(axes, end, -0.45 * side, -0.3, name, colour)
    stroke(axes, [ORIGIN, O_2], DIM, "--")
    label(axes, 0.5 * O_2, 0.22, 0.0, "ℓ")

    triads = {
        "E": (ORIGIN, 2.3, np.eye(3)),
        "1": (ORIGIN, 1.6, np.array(R_1E(q.phi, q.gamma))),
        "2": (O_2, 1.7, np.array(R_2E(q))),
        "B": (G, 2.1, np.array(body.R_BE)),
    }
    for frame, (origin, size, directions) in triads.items():
        for name, axis in zip("xyz", directions, strict=True):
            arrow(axes, origin, size * seen(axis), FRAMES[frame], f"${name}_{frame}$")
    label(axes, ORIGIN, 0.45, -0.2, "$O_E$")
    label(axes, O_2, 0.42, 0.05, "$O_2$", FRAMES["2"])
    label(axes, G, 0.2, 0.3, "G", FRAMES["B"])


def side(figure: Figure) -> None:
    """The equilibrium of `laksa` in the plane of symmetry, from the pilot's right; its forces."""
    axes = plain(figure, -3.2, 7.0, -2.0, 12.6)
    parameters = parameter_set("laksa")
    q, q_dot = equilibrium_state(parameters)
    body = straight_body(parameters, q, q_dot, Control(7.5, 0.0, 0.0, 0.0, 0.0, 0.0))

    def seen(p_E: Sequence[float]) -> Place:
        return np.array([-p_E[0], -p_E[2]])

    G, O_2 = seen(body.p_G_E), seen(attachment_E(parameters, body, 1.0))
    x_B, z_B = seen(body.R_BE.x), seen(body.R_BE.z)
    stroke(axes, [np.array((-2.8, 0.0)), np.array((6.6, 0.0))], "#9bb28a", width=2.0)
    stroke(axes, [ORIGIN, O_2], LINES, width=1.8)
    stroke(axes, [ORIGIN, np.array((0.0, 5.0))], DIM, ":")
    stroke(axes, [G - 0.75 * x_B, O_2, G, O_2, G + 0.75 * x_B], KITE, width=0.9)
    stroke(axes, [G - 0.75 * x_B, G + 0.75 * x_B], KITE, width=4.0)
    arrow(axes, ORIGIN, np.array([-1.8, 0.0]), FRAMES["E"], "$x_E$")
    arrow(axes, ORIGIN, np.array([0.0, -1.3]), FRAMES["E"], "$z_E$")
    angle(axes, ORIGIN, 3.4, pi / 2 - q.gamma, pi / 2, "γ")
    label(axes, ORIGIN, 0.5, -0.4, "$O_E$")
    arrow(axes, np.array([-2.6, 5.6]), np.array([1.9, 0.0]), AIR)
    label(axes, np.array([-1.7, 5.6]), 0.0, 0.35, "wind", AIR)

    none = Vector(0.0, 0.0, 0.0)
    wrench = aerodynamic_wrench(parameters, body.p_G_E, body.R_BE, none, none, 0.0)
    scale = 0.025  # m of paper for each N
    air = scale * seen(unrotated(body.R_BE, wrench.force))
    weight = scale * parameters.kite.mass * parameters.environment.gravity * np.array([0.0, -1.0])
    arrow(axes, G, air, AIR)
    label(axes, G + air, 0.55, 0.1, "air", AIR)
    arrow(axes, G, weight, KITE)
    label(axes, G + weight, 0.45, 0.0, "m g", KITE)
    arrow(axes, O_2, -air - weight, LINES)
    label(axes, O_2 - air - weight, 1.15, -0.25, "both lines", LINES)
    arrow(axes, G, 2.6 * x_B, FRAMES["B"], "$x_B$")
    arrow(axes, G, 3.4 * z_B, FRAMES["B"])
    label(axes, G + 3.4 * z_B, 0.3, -0.15, "$z_B$", FRAMES["B"])
    stroke(axes, [G, G - np.array((3.4, 0.0))], DIM, ":")
    angle(axes, G, 3.1, direction(x_B), pi, "α")
    label(axes, G, 0.35, 0.3, "G", FRAMES["B"])
    label(axes, O_2, -0.4, 0.15, "$O_2$", FRAMES["2"])


def lines(figure: Figure) -> None:
    """The plane of the lines as the pilot sees it: ℓ, δ, η and both lengths."""
    axes = plain(figure, -6.2, 3.8, -2.2, 9.2)
    ell, delta, eta, y_A = 8.0, 0.5, -0.2, 1.7

    def seen(v_1: Sequence[float]) -> Place:
        return np.array([-v_1[1], -v_1[2]])  # y_1 to the left, z_1 down

    y_2, z_2 = seen((0.0, cos(eta), sin(eta))), seen((0.0, -sin(eta), cos(eta)))
    O_2 = ell * seen((0.0, sin(eta + delta), -cos(eta + delta)))
    for hand, sign, colour in ((1.0, "₊", LEFT), (-1.0, "₋", RIGHT)):
        end = O_2 + hand * y_A * y_2
        length = line_motion(y_A, Control(ell, 0.0, 0.0, delta, 0.0, 0.0), hand).length
        assert abs(np.hypot(*end) - length) < 1e-12, "figure and formula are one"
        stroke(axes, [ORIGIN, end], colour, width=1.8)
        label(axes, 0.62 * end, -0.35, -0.1, f"L{sign}", colour)
        label(axes, end, -0.3 * hand, -0.35, f"A{sign}", colour)
    stroke(axes, [O_2 - y_A * y_2, O_2 + y_A * y_2], KITE, width=3.0)
    stroke(axes, [ORIGIN, O_2], DIM, "--")
    label(axes, 0.72 * O_2, 0.2, 0.1, "ℓ")
    label(axes, O_2 - 0.55 * y_A * y_2, 0.1, 0.38, "$Y_A$")
    arrow(axes, ORIGIN, np.array([-1.8, 0.0]), FRAMES["1"], "$y_1$")
    arrow(axes, ORIGIN, np.array([0.0, -1.3]), FRAMES["1"], "$z_1$")
    arrow(axes, O_2, (y_A + 1.0) * y_2, FRAMES["2"], "$y_2$")
    arrow(axes, O_2, 1.2 * z_2, FRAMES["2"], "$z_2$")
    stroke(axes, [ORIGIN, np.array((0.0, 5.6))], DIM, ":")
    stroke(axes, [ORIGIN, -5.6 * z_2], FRAMES["2"], ":")
    angle(axes, ORIGIN, 3.0, direction(-z_2), direction(O_2), "δ")
    angle(axes, ORIGIN, 4.7, direction(-z_2), pi / 2, "−η")
    label(axes, ORIGIN, 0.5, -0.3, "$O_E$")
    label(axes, O_2, 0.15, 0.4, "$O_2$", FRAMES["2"])
    label(axes, ORIGIN, -2.4, -1.4, "left hand", LEFT)
    label(axes, ORIGIN, 2.3, -1.4, "right hand pulls: δ > 0", RIGHT)


def stick(figure: Figure) -> None:
    """δ after 4 s of full stick under the three laws: the kite of the thesis, shaped as flown."""
    limits = parameter_set("thesis").stick
    rest = rest_ell(80.0, 2.9)
    rows = figure.subplots(3, 1, sharex=True)
    for law, style in zip(StickLaw, ("-", "--", ":"), strict=True):
        now, flown = Control(rest, 0.0, 0.0, 0.0, 0.0, 0.0), []
        for k in range(1200):
            wish, rate = asked(limits, law, 1.0 if k < 400 else 0.0, now, TICK)
            segment = shaped(limits, now, k * TICK, TICK, wish, rest, rest, rate)
            flown.append((k * TICK, now.delta, now.delta_dot, segment.control.delta_ddot))
            now = control(segment, (k + 1) * TICK)
        t, *columns = np.array(flown).T
        for axes, column in zip(rows, columns, strict=True):
            axes.plot(t, column, style, color="k", lw=1.4, label=f"stick asks for {law.symbol}")
    names = ("δ [rad]", "δ̇ [rad/s]", "δ̈ [rad/s²]")
    for axes, name, limit in zip(rows, names, limits[:3], strict=True):
        axes.set(ylabel=name, ylim=(-1.25 * limit, 1.25 * limit), xlim=(0.0, 12.0))
        axes.axvspan(0.0, 4.0, color="#f1ead9", lw=0, zorder=-1)
        axes.axhline(limit, color=LEFT, lw=0.8, ls="-.")
        axes.axhline(-limit, color=LEFT, lw=0.8, ls="-.")
    rows[0].legend(loc="lower right", fontsize=9)
    rows[-1].set_xlabel("time [s] (shaded: full stick to one side; red: limits of the set thesis)")
    figure.align_ylabels(rows)


STARTS = ((30, 40, 80), (-45, 30, -30), (-20, 30, 90), (50, 25, -60), (0, 45, -90), (20, 50, 30))
"""deg: azimuth, elevation and where the nose points, right positive."""


def home(figure: Figure) -> None:
    """Where two kites fly from the same starts with the hands level, in 6.5 m/s."""
    for axes, name in zip(figure.subplots(2, 1, sharex=True), ("trainer", "sport"), strict=True):
        parameters = parameter_set(name)
        for start in STARTS:
            azimuth, elevation = on_the_sky(left_alone(parameters, Start(*map(float, start))))
            [line] = axes.plot(azimuth, elevation, lw=1.3)
            axes.plot(azimuth[0], elevation[0], "o", color=line.get_color(), ms=5)
            axes.plot(azimuth[10::10], elevation[10::10], ".", color=line.get_color(), ms=4)
        rest = pi / 2 - equilibrium_state(parameters).q.gamma
        around = np.linspace(-rest, rest, 201)
        edge = np.degrees(np.arccos(np.minimum(cos(rest) / np.cos(around), 1.0)))
        axes.plot(np.degrees(around), edge, "--", color=DIM, lw=1.0)
        axes.axhspan(-5.0, 0.0, color="#9bb28a", lw=0)
        axes.set(ylabel="elevation [deg]", xlim=(-90, 90), ylim=(-5, 85), aspect="equal")
        axes.set_title(name, fontsize=11)
    axes.set_xlabel("azimuth [deg], right positive (a small dot each second)")


def turning(figure: Figure) -> None:
    """How `sport` turns, as `kitemj identify` draws it."""
    draw_identification(figure, identify(parameter_set("sport"), source="sport"))


FIGURES: dict[str, tuple[Callable[[Figure], None], tuple[float, float]]] = {
    "frames": (frames, (7.0, 6.7)),
    "side": (side, (4.9, 7.0)),
    "lines": (lines, (5.3, 6.4)),
    "stick": (stick, (7.0, 5.6)),
    "home": (home, (7.0, 7.6)),
    "turning": (turning, SIZE),
    "shapes": (shapes, (7.0, 6.4)),
    "worked_out": (worked_out, (7.0, 8.2)),
    "flown": (flown_eight, (7.0, 7.2)),
}


def main(folder: Path) -> None:
    """Writes every figure as SVG; the same bytes each time."""
    folder.mkdir(exist_ok=True)
    for name, (draw, size) in FIGURES.items():
        figure = Figure(figsize=size, layout="constrained")
        draw(figure)
        figure.savefig(folder / f"{name}.svg", metadata={"Date": None})
        print(folder / f"{name}.svg")


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "docs" / "figures")
