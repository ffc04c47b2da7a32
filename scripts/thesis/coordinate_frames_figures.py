"""Section 3: figures of the coordinate frames, in space and in the planes of two of them."""

from math import cos, degrees, pi, radians, sin
from typing import TYPE_CHECKING, Any

import numpy as np

from kitemj.physics.parameter_files import parameter_set
from thesis.coordinate_frames_geometry import Array, FrameGeometry
from thesis.subplots import subplots

if TYPE_CHECKING:
    from matplotlib.figure import Figure

AZIMUTH = radians(-62.0)
"""From where the drawing in space is seen."""

COLOURS = {"E": "0.35", "1": "#0B6FA4", "2": "#B8560A", "B": "#1B7F3B"}
LINES = {"E": "-", "1": (0, (5, 1.5)), "2": (0, (3, 1, 1, 1)), "B": "-"}


def all_figure(found: FrameGeometry) -> "Figure":
    """In the world's axes, z up, as matplotlib wants them: (x, -y, -z) of E."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(7.2, 6.2))
    ax: Any = figure.add_axes((0.0, 0.0, 1.0, 1.0), projection="3d", proj_type="ortho")
    up = {name: _up(point) for name, point in found.points.items()}
    _sheet(ax, [up["O_E"], up["O_E"], up["A₊"], up["A₋"]], "0.5", 0.12)
    for end, colour in (("A₊", "#D0101A"), ("A₋", "#1A3DF2")):
        ax.plot(*np.transpose([up["O_E"], up[end]]), color=colour, lw=1.2)
    for a, b in (("A₊", "A₋"), ("O_E", "O_2"), ("O_2", "G")):
        ax.plot(*np.transpose([up[a], up[b]]), color="0.45", lw=0.9, ls=":")
    for name, right, above in (
        ("O_E", 0.3, 0.45),
        ("O_2", 0.1, -0.6),
        ("G", 0.0, 0.35),
        ("A₊", -0.5, 0.1),
        ("A₋", 0.2, 0.35),
    ):
        ax.scatter(*up[name], color="black", s=12)
        aside = np.array([right * cos(AZIMUTH + pi / 2), right * sin(AZIMUTH + pi / 2), above])
        ax.text(*(up[name] + aside), _tex(name), fontsize=11, ha="center", va="center")
    _surface(ax, found)
    for frame, length in (("E", 2.2), ("1", 2.6), ("2", 1.8), ("B", 1.8)):
        _triad(ax, found, frame, length)
    _wind(ax)
    ax.set_axis_off()
    for letter, middle in zip("xyz", (-2.4, -2.2, 2.9), strict=True):
        ax.set(**{f"{letter}lim": (middle - 4.5, middle + 4.5)})
    ax.set_box_aspect((1, 1, 1), zoom=1.28)
    ax.view_init(elev=20, azim=degrees(AZIMUTH))
    return figure


def _triad(ax: Any, found: FrameGeometry, frame: str, length: float) -> None:
    start = _up(found.points[found.origins[frame]])
    for letter, axis in zip("xyz", found.axes[frame], strict=True):
        way = _up(axis) * length
        ax.quiver(
            *start,
            *way,
            color=COLOURS[frame],
            lw=1.6,
            arrow_length_ratio=0.13,
            linestyle=LINES[frame],
        )
        ax.text(
            *(start + (1 + 0.45 / length) * way),
            _tex(f"{letter}_{frame}"),
            color=COLOURS[frame],
            fontsize=11,
            ha="center",
            va="center",
        )


def _surface(ax: Any, found: FrameGeometry) -> None:
    """The kite itself: a rectangle of chord and span about G."""
    kite = parameter_set("thesis").kite
    forward, starboard, _ = found.axes["B"]
    corners = [
        _up(found.points["G"] + x * kite.chord / 2 * forward + y * kite.span / 2 * starboard)
        for x, y in ((1, 1), (1, -1), (-1, 1), (-1, -1))
    ]
    _sheet(ax, corners, COLOURS["B"], 0.15)


def _sheet(ax: Any, corners: list[Array], colour: str, alpha: float) -> None:
    """A flat piece between four corners, those of either side after one another."""
    x, y, z = np.array(corners).reshape(2, 2, 3).transpose(2, 0, 1)
    ax.plot_surface(x, y, z, color=colour, alpha=alpha, shade=False)


def _wind(ax: Any) -> None:
    ax.quiver(2.4, 0.0, 3.0, -2.0, 0, 0, color="0.2", lw=1.2, arrow_length_ratio=0.15)
    ax.text(1.4, 0.0, 3.35, "wind", fontsize=10, ha="center")


def planes_figure(found: FrameGeometry) -> "Figure":
    """The plane π of the lines, and the kite's plane of symmetry."""
    figure, ((left, right),) = subplots(1, 2, (7.4, 3.9))
    _pi_plane(left, found)
    _symmetry_plane(right, found)
    for ax in (left, right):
        ax.set(aspect="equal")
        ax.set_axis_off()
        ax.margins(0.12)
    return figure


def _pi_plane(ax: Any, found: FrameGeometry) -> None:
    """Components (-y_1, -z_1): the ground below, A₊ on the left, as from behind the pilot."""
    flat = {name: -(found.axes["1"] @ point)[1:] for name, point in found.points.items()}
    for end, colour in (("A₊", "#D0101A"), ("A₋", "#1A3DF2")):
        ax.plot(*np.transpose([flat["O_E"], flat[end]]), color=colour, lw=1.2)
    for a, b in (("A₊", "A₋"), ("O_E", "O_2")):
        ax.plot(*np.transpose([flat[a], flat[b]]), color="0.45", lw=0.9, ls=":")
    for name, shift in (
        ("O_E", (0.3, -0.4)),
        ("O_2", (0.3, -0.2)),
        ("A₊", (-0.5, 0.3)),
        ("A₋", (0.2, 0.3)),
    ):
        ax.plot(*flat[name], "ko", ms=3.5)
        ax.annotate(_tex(name), flat[name] + shift, fontsize=10, ha="center", va="center")
    for frame, length in (("1", 2.2), ("2", 2.0)):
        start = flat[found.origins[frame]]
        for letter, axis in zip("yz", found.axes[frame][1:], strict=True):
            way = -(found.axes["1"] @ axis)[1:] * length
            _arrow(ax, start, way, frame, letter)
    z_2 = -(found.axes["1"] @ found.axes["2"][2])[1:]
    median = flat["O_E"] - flat["O_2"]
    _arc(ax, flat["O_2"], z_2, median, 1.5, r"$\delta$")
    y_1, y_2 = np.array([-1.0, 0.0]), -(found.axes["1"] @ found.axes["2"][1])[1:]
    ax.plot(
        *np.transpose([flat["O_2"], flat["O_2"] + 1.9 * y_1]), color=COLOURS["1"], lw=0.9, ls=":"
    )
    _arc(ax, flat["O_2"], y_1, y_2, 1.6, r"$\eta$")


def _symmetry_plane(ax: Any, found: FrameGeometry) -> None:
    """Components (-x_2, -z_2) about O_2: nose to the left, ground below."""
    R_2, R_B = found.axes["2"], found.axes["B"]
    G = -(R_2 @ (found.points["G"] - found.points["O_2"]))[[0, 2]]
    kite = parameter_set("thesis").kite
    nose, down = (-(R_2 @ R_B[i])[[0, 2]] for i in (0, 2))
    half = kite.chord / 2
    ax.plot(*np.transpose([G - half * nose, G + half * nose]), color="#1B7F3B", lw=5, alpha=0.3)
    elbow = kite.x_A * nose
    ax.plot(*np.transpose([G, G + elbow]), color="0.45", lw=0.9, ls=":")
    ax.plot(*np.transpose([G + elbow, (0.0, 0.0)]), color="0.45", lw=0.9, ls=":")
    ax.annotate(_tex("X_A"), G + elbow / 2 + 0.2 * -down, fontsize=10, ha="center", va="center")
    ax.annotate(_tex("Z_A"), elbow / 2 + G / 2 + 0.3 * nose, fontsize=10, ha="center", va="center")
    for point, label, shift in ((np.zeros(2), "O_2", (0.32, 0.05)), (G, "G", (0.2, 0.2))):
        ax.plot(*point, "ko", ms=3.5)
        ax.annotate(_tex(label), point + np.array(shift), fontsize=10, ha="center", va="center")
    x_2, z_2 = np.array([-1.0, 0.0]), np.array([0.0, -1.0])
    for start, frame, ways in (
        (np.zeros(2), "2", (x_2, z_2)),
        (G, "B", (nose, down)),
    ):
        for letter, way in zip("xz", ways, strict=True):
            _arrow(ax, start, 1.5 * way, frame, letter)
    ax.plot(*np.transpose([G, G + 1.4 * x_2]), color=COLOURS["2"], lw=0.9, ls=":")
    _arc(ax, G, x_2, nose, 1.1, r"$\theta$")


def _arrow(ax: Any, start: Array, way: Array, frame: str, letter: str) -> None:
    end = start + way
    look = {
        "color": COLOURS[frame],
        "lw": 1.6,
        "linestyle": LINES[frame],
        "shrinkA": 0,
        "shrinkB": 0,
    }
    ax.annotate("", end, start, arrowprops={"arrowstyle": "-|>", **look})
    label = start + way * (1 + 0.28 / float(np.hypot(*way)))
    ax.annotate(
        _tex(f"{letter}_{frame}"),
        label,
        fontsize=11,
        color=COLOURS[frame],
        ha="center",
        va="center",
    )
    ax.plot(*end, alpha=0)  # so that the axes make room


def _arc(ax: Any, centre: Array, a: Array, b: Array, radius: float, label: str) -> None:
    """Draws an arc from one direction to another, the short way.

    ax: the axes
    centre: (2,) m, its middle
    a: (2,) direction where it begins
    b: (2,) direction where it ends
    radius: m
    label: what is written beside it
    """
    start = float(np.arctan2(a[1], a[0]))
    turn = (float(np.arctan2(b[1], b[0])) - start + np.pi) % (2 * np.pi) - np.pi
    bow = [
        centre + radius * np.array([cos(start + s * turn), sin(start + s * turn)])
        for s in np.linspace(0.0, 1.0, 25)
    ]
    ax.plot(*np.transpose(bow), color="0.2", lw=1.0)
    middle = start + turn / 2
    where = centre + (radius + 0.25) * np.array([cos(middle), sin(middle)])
    ax.annotate(label, where, fontsize=11, ha="center", va="center")


def _up(v_E: Array) -> Array:
    """Components with z up."""
    return np.asarray(v_E) * (1.0, -1.0, -1.0)


def _tex(name: str) -> str:
    """`O_2` with its index lowered."""
    letter, _, index = name.partition("_")
    return f"${letter}_{{{index}}}$" if index else name
