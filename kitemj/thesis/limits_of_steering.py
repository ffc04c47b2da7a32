"""Section 4.6: how much of the physical limits the four cases of Table 3 take up."""

from functools import cache
from math import degrees, log, sin
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from kitemj.dynamics.motion import Motion
from kitemj.dynamics.survey import BETA, TENSION_MINUS, TENSION_PLUS, Array
from kitemj.physics.parameters import StickLimits
from kitemj.physics.steering import ell_delta, rest_ell
from kitemj.plots.flown import Flown, flown_motions
from kitemj.plots.limits import extremes, limits_figure
from kitemj.stability.trim import equilibria
from kitemj.tables import Cell, Table
from kitemj.thesis.hands import FULL, Hand, flown_live, scenario, squares, surveyed
from kitemj.thesis.panels import panels
from kitemj.thesis.section import Answer, Drawing, Named, Section, Verdict

if TYPE_CHECKING:
    from matplotlib.figure import Figure

LENGTHS = (80.0, 200.0)  # m
HALF_PERIODS = (2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0, 15.0, 20.0, 30.0, 40.0)  # s
NUDGE = 0.1
"""Of a limit; by which it is raised and lowered for its sensitivity."""
RATES = (0.0025, 0.005, 0.0075, 0.01, 0.015, 0.025, 0.05, 0.075, 0.1, 0.2, 0.5, 1.0)  # rad/s
ACCELERATIONS = (0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0)  # rad/s²
ARM, PRINTED_DELTA = 0.25, 0.1
"""m and rad; the reach of an arm, and the δ that the thesis computes from it."""
SHOWN_EVERY = 10
"""Ticks between the points of a drawing."""


class Case(NamedTuple):
    """A column of Table 3: largest |δ| [rad], |δ̇| [rad/s], |δ̈| [rad/s²]."""

    delta: float
    delta_dot: float
    delta_ddot: float

    def stick(self) -> StickLimits:
        """The limits of the set thesis with these in place of its own."""
        return scenario(LENGTHS[0]).parameters.stick._replace(**self._asdict())


CASES = {1: Case(0.1, 0.005, 0.05), 2: Case(0.1, 0.05, 0.05), 3: Case(0.1, 0.01, 0.05)}
CASES[4] = Case(0.1, 0.01, 0.5)

_HAND = "the hand that moved the thesis's knob is not known; this one is programmed"
ANSWERS = (
    Answer("Table 3", Verdict.REPRODUCED, "its limits are those flown here", "limits_cases"),
    Answer("Figure 33", Verdict.REPRODUCED, "the plot itself, of the flight of case 3", "case_3"),
    *(
        Answer(f"Figure {33 + case}", Verdict.DIFFERS, _HAND, f"case_{case}")
        for case in (1, 2, 3, 4)
    ),
)


def section(scratch: Path) -> Section:
    """Cases by all three models; everything else by Lagrange's equations."""
    flights = {case: flown_live(LENGTHS[0], limits.stick(), FULL) for case, limits in CASES.items()}
    cases, others = case_table(flights), hands_table()
    sensitivities, reach, beyond = sensitivity_table(), reach_table(), map_table()
    return Section(
        "Limits of the model under steering (section 4.6)",
        ANSWERS,
        thesis=[
            "Over time are drawn T₊/T_max, T₋/T_max, α/α_stall and |β|/β_max, for four sets of "
            "limits on the hand (Table 3). β is found to be what the hand influences most; the "
            "larger δ̇_max, the larger β (case 2 above case 3 above case 1); δ̈_max has influence "
            "too, but not as much (case 4 against case 3). The limits chosen are |δ| < 0.1 rad, "
            "|δ̇| < 0.01 rad/s and |δ̈| < 0.05 rad/s². The 0.1 rad are said to be what arms of "
            "±25 cm make of 200 m lines.",
        ],
        here=[*_here(flights, cases, others), *_here_more(sensitivities, reach, beyond)],
        why=[
            "The order of the cases is the thesis's, the sizes need not be: it prints none, and "
            "moved its knob by hand. Here the stick is programmed: rest for 2 s, full right until "
            "30 s, full left until 75 s, then back to the middle. A full stick uses all of a "
            "limit whenever it can, and the waits are long enough for the slowest case to get "
            "from one end to the other.",
            "The thesis kept δ_max the same in all its cases and so could not see that δ itself "
            "matters most: hands that simply hold 0.1 rad leave the kite standing aside with most "
            "of that β. What δ̇_max adds is how far the kite is behind the hands; it answers "
            "within some seconds. δ̈_max only says how long the hands take to reach δ̇_max: at "
            "most 1 s in the four cases, too short for the kite to notice. It matters where that "
            "time is as long as the kite's own, in the lower part of the map.",
            "That δ̈_max has a visible influence in the thesis is not found again.",
        ],
        drawings=[
            *(
                Drawing(
                    f"case_{case}",
                    f"Figure {33 + case} again{', and 33' if case == 3 else ''}: case {case}, "
                    f"|δ̇| < {limits.delta_dot:g} rad/s, |δ̈| < {limits.delta_ddot:g} rad/s², "
                    f"{LENGTHS[0]:g} m lines.",
                    limits_figure(_thinned(case, flights[case]["mujoco"]), f"Case {case}"),
                )
                for case, limits in CASES.items()
            ),
            Drawing(
                "cases_beta",
                "δ and β of the four cases. Case 4 lies on case 3. Dotted: β of the kite that "
                "stands with δ held at ±0.1 rad.",
                _cases_figure(flights),
            ),
            Drawing(
                "hands_beta",
                "Largest |β| under full right and full left in turn, over how long each is held: "
                "cases 3 and 4 are one line.",
                _hands_figure(others),
            ),
            Drawing(
                "beta_map",
                "Largest |β| [°] over the limits of δ̇ and δ̈; the four cases are framed. A star: a "
                "line would have to push. In the first column the hand does not get to 0.1 rad "
                "before it turns back.",
                _map_figure(beyond),
            ),
        ],
        tables=[
            Named("limits_cases", cases),
            Named("limits_ratios", ratio_table(flights)),
            Named("limits_lengths", lengths_table()),
            Named("limits_sensitivities", sensitivities),
            Named("limits_hands", others),
            Named("arm_reach", reach),
            Named("beta_map", beyond, show=False),
        ],
    )


def case_table(flights: dict[int, dict[str, list[Motion]]]) -> Table:
    """A row for each case: its limits, the largest |β|, and how far the models are apart."""
    rows: list[tuple[Cell, ...]] = []
    for case, limits in CASES.items():
        beta = {m: np.degrees([x.air.beta for x in flown]) for m, flown in flights[case].items()}
        largest = {model: float(np.abs(values).max()) for model, values in beta.items()}
        spread = max(float(np.abs(b - beta["lagrange"]).max()) for b in beta.values())
        rows.append((case, *limits, *largest.values(), spread))
    columns = ("case", "δ_max_rad", "δ̇_max_rad_per_s", "δ̈_max_rad_per_s2")
    betas = [f"beta_{model.replace('-', '_')}_deg" for model in flights[1]]
    title = f"Table 3 flown on {LENGTHS[0]:g} m lines: largest |β| by each model"
    return Table(title, (*columns, *betas, "models_apart_deg"), rows)


def ratio_table(flights: dict[int, dict[str, list[Motion]]]) -> Table:
    """A row for each case and limit: how much of it is taken up."""
    rows: list[tuple[Cell, ...]] = [
        (case, e.ratio, e.smallest, e.largest, e.largest - e.smallest, e.largest_at_s, not e.reason)
        for case in CASES
        for e in extremes(_flown(case, flights[case]["mujoco"]))
    ]
    columns = ("case", "ratio", "smallest", "largest", "change", "largest_at_s", "within")
    return Table("How much of each limit is taken up (mujoco)", columns, rows)


def lengths_table() -> Table:
    """A row for each length: the largest |β| [°] of each case, and that of δ held."""
    rows: list[tuple[Cell, ...]] = []
    for length in LENGTHS:
        found = [largest_beta(length, case, FULL) for case in CASES.values()]
        rows.append((length, *found, held_beta(length)))
    columns = ("length_m", *(f"case_{case}_deg" for case in CASES), "held_at_δ_max_deg")
    return Table("Largest |β| by the length of the lines", columns, rows)


def hands_table() -> Table:
    """A row for each half period of full right and full left in turn."""
    rows: list[tuple[Cell, ...]] = [
        (half, *(largest_beta(LENGTHS[0], case, squares(half)) for case in CASES.values()))
        for half in HALF_PERIODS
    ]
    columns = ("held_for_s", *(f"case_{case}_deg" for case in CASES))
    return Table("Largest |β| under full right and full left in turn", columns, rows)


def sensitivity_table() -> Table:
    """Around case 3: by how many percent |β| rises when a limit rises by one."""
    rows: list[tuple[Cell, ...]] = []
    for name in Case._fields:
        value = getattr(CASES[3], name)
        high, low = (
            largest_beta(LENGTHS[0], CASES[3]._replace(**{name: value * factor}), FULL)
            for factor in (1 + NUDGE, 1 - NUDGE)
        )
        percent = log(high / low) / log((1 + NUDGE) / (1 - NUDGE))
        rows.append((_SYMBOLS[name], value, low, high, percent))
    columns = ("limit", "value", "beta_10_percent_less_deg", "beta_10_percent_more_deg")
    title = "Around case 3: percent of |β| for one percent of each limit"
    return Table(title, (*columns, "percent_for_percent"), rows)


_SYMBOLS = {"delta": "δ_max [rad]", "delta_dot": "δ̇_max [rad/s]", "delta_ddot": "δ̈_max [rad/s²]"}


def reach_table() -> Table:
    """δ that arms of ±`ARM` make, by equations 8 and 9, and the way that 0.1 rad take."""
    rows: list[tuple[Cell, ...]] = []
    y_A = scenario(LENGTHS[0]).parameters.kite.y_A
    for length in LENGTHS:
        ell, delta = ell_delta(length + ARM, length - ARM, y_A)
        way = rest_ell(length, y_A) * y_A * sin(PRINTED_DELTA) / length
        rows.append((length, ARM, ell, delta, degrees(delta), PRINTED_DELTA, way))
    columns = ("length_m", "arm_m", "ell_m", "δ_rad", "δ_deg", "printed_δ_rad")
    return Table("The reach of an arm", (*columns, "arm_for_printed_δ_m"), rows)


def map_table() -> Table:
    """Largest |β| and least tension over the limits of δ̇ and δ̈, with δ_max = 0.1 rad."""
    rows: list[tuple[Cell, ...]] = []
    for acceleration in ACCELERATIONS:
        for rate in RATES:
            flown = flight(LENGTHS[0], Case(PRINTED_DELTA, rate, acceleration), FULL)
            least = float(flown[:, TENSION_PLUS : TENSION_MINUS + 1].min())
            rows.append((rate, acceleration, _largest(flown), least))
    columns = ("δ̇_max_rad_per_s", "δ̈_max_rad_per_s2", "beta_max_deg", "tension_min_N")
    return Table("Largest |β| over the limits of δ̇ and δ̈, 80 m lines", columns, rows)


@cache
def flight(length: float, case: Case, hand: Hand) -> Array:
    """Rows of a survey of the hand's flight by Lagrange's equations."""
    return surveyed(length, case.stick(), hand)


def _largest(rows: Array) -> float:
    return degrees(np.abs(rows[:, BETA]).max())


def largest_beta(length: float, case: Case, hand: Hand) -> float:
    """Largest |β| [°] of a flight by Lagrange's equations."""
    return _largest(flight(length, case, hand))


def held_beta(length: float) -> float:
    """|β| [°] of the kite that stands with δ held at what the thesis allows."""
    [found] = equilibria(scenario(length).parameters, delta=PRINTED_DELTA)
    return abs(degrees(found.beta))


def _flown(case: int, motions: list[Motion]) -> Flown:
    return flown_motions(f"case {case}", scenario(LENGTHS[0]).parameters, motions)


def _thinned(case: int, motions: list[Motion]) -> Flown:
    """The same for drawing."""
    return _flown(case, motions[::SHOWN_EVERY])


def _here(flights: dict[int, dict[str, list[Motion]]], cases: Table, others: Table) -> list[str]:
    beta = {int(row[0]): float(row[4]) for row in cases.rows}
    apart, held = max(float(row[-1]) for row in cases.rows), held_beta(LENGTHS[0])
    limit = degrees(scenario(LENGTHS[0]).parameters.limits.beta_max)
    order = all(float(row[2]) > float(row[3]) > float(row[1]) for row in others.rows)
    tie = [100 * (float(row[4]) / float(row[3]) - 1) for row in others.rows]
    said = "the same" if order else "not always the same"
    return [
        f"Largest |β| is {beta[1]:.3f}° in case 1, {beta[3]:.3f}° in case 3 and {beta[2]:.3f}° in "
        f"case 2: it rises with δ̇_max as the thesis found, by {100 * (beta[2] / beta[1] - 1):.0f} "
        f"% for ten times the rate. δ̈_max does next to nothing: case 4 differs from case 3 by "
        f"{beta[4] - beta[3]:+.0e}°, {100 * (beta[4] / beta[3] - 1):+.3f} % for ten times as much. "
        f"The three models agree on β within {apart:.0e}° throughout.",
        f"All this is small: {beta[2]:.2f}° are {100 * beta[2] / limit:.0f} % of β_max, and "
        f"{held:.3f}° of it are there when δ is held at 0.1 rad and nothing moves. β is what "
        "the hand changes most, as the thesis found, if each quantity is taken in parts of its "
        "limit (the column change of the second table).",
        f"That does not hang on this hand: with full right and full left in turn, held from "
        f"{HALF_PERIODS[0]:g} to {HALF_PERIODS[-1]:g} s, the order of cases 1, 3 and 2 is {said}, "
        f"while case 4 differs from case 3 by {min(tie):+.1f} to {max(tie):+.1f} %.",
    ]


def _here_more(sensitivities: Table, reach: Table, beyond: Table) -> list[str]:
    share = dict(zip(Case._fields, (float(row[-1]) for row in sensitivities.rows), strict=True))
    kite = scenario(LENGTHS[0]).parameters.kite
    near, far = (float(row[3]) for row in reach.rows)
    way = float(reach.rows[1][-1])
    pushed = [row for row in beyond.rows if float(row[3]) <= 0]
    worst = max(float(row[2]) for row in beyond.rows)
    hand = [100 * kite.y_A * case.delta_dot for case in CASES.values()]
    return [
        f"Around case 3, one percent more of δ_max gives {share['delta']:.2f} % more β, of δ̇_max "
        f"{share['delta_dot']:.2f} % and of δ̈_max {share['delta_ddot']:.0e} %. δ̇_max does "
        "matter more than δ̈_max; δ_max matters more than both.",
        f"The map goes on to hands {RATES[-1] / CASES[2].delta_dot:.0f} times as fast as case 2: "
        f"|β| reaches {worst:.1f}° at the most. What sudden hands meet first is another limit: in "
        f"{len(pushed)} of {len(beyond.rows)} places a line would have to push. Y_A δ̇ is how fast "
        f"a hand moves: {min(hand):.1f} to {max(hand):.1f} cm/s in the four cases, which is "
        "slow for an arm.",
        f"Arms of ±{100 * ARM:g} cm make δ = {near:.4f} rad of 80 m lines and {far:.4f} rad of "
        f"200 m lines, not 0.1: the length of the lines hardly enters, and 0.1 rad take "
        f"±{100 * way:.1f} cm.",
    ]


def _cases_figure(flights: dict[int, dict[str, list[Motion]]]) -> "Figure":
    figure, ((top,), (bottom,)) = panels(2, 1, (7.0, 4.6), sharex=True)
    for (case, models), (style, width) in zip(flights.items(), _STYLES, strict=True):
        motions = models["mujoco"][::SHOWN_EVERY]
        t = [motion.t for motion in motions]
        look = {"label": f"case {case}", "color": _COLOURS[case], "ls": style, "lw": width}
        top.plot(t, [motion.control.delta for motion in motions], **look)
        bottom.plot(t, [degrees(motion.air.beta) for motion in motions], **look)
    held = held_beta(LENGTHS[0])
    for side in (held, -held):
        bottom.axhline(side, color="0.4", lw=0.9, ls=":")
    top.set(ylabel="δ [rad]")
    bottom.set(ylabel="β [°]", xlabel="time [s]", xlim=(0.0, FULL[-1][0]))
    for ax in (top, bottom):
        ax.grid(color="0.92")
    figure.legend(*top.get_legend_handles_labels(), loc="outside upper center", ncols=4, fontsize=8)
    return figure


_STYLES = (("-", 1.2), ("-.", 1.2), ("-", 2.4), ("--", 1.0))
_COLOURS = {1: "#0B6FA4", 2: "#B8560A", 3: "0.7", 4: "black"}


def _hands_figure(table: Table) -> "Figure":
    figure, ((ax,),) = panels(1, 1, (7.0, 3.3))
    held = [float(row[0]) for row in table.rows]
    for (case, colour), (style, width), mark in zip(
        _COLOURS.items(), _STYLES, ("o", "^", "", "x"), strict=True
    ):
        beta = [float(row[case]) for row in table.rows]
        ax.plot(
            held, beta, marker=mark, ls=style, lw=width, color=colour, label=f"case {case}", ms=4
        )
    ax.set(xlabel="held for [s]", ylabel="largest |β| [°]", xlim=(0.0, None), ylim=(0.0, None))
    ax.grid(color="0.92")
    ax.legend(fontsize=8, frameon=False)
    return figure


def _map_figure(table: Table) -> "Figure":
    figure, ((ax,),) = panels(1, 1, (7.4, 5.0))
    beta = np.array([float(row[2]) for row in table.rows])
    cells = beta.reshape(len(ACCELERATIONS), len(RATES))
    mesh = ax.pcolormesh(cells, cmap="YlGnBu", vmin=0.4, vmax=2.6, edgecolor="white", lw=0.5)
    for row in table.rows:
        x, y = RATES.index(float(row[0])), ACCELERATIONS.index(float(row[1]))
        value, slack = float(row[2]), float(row[3]) <= 0
        dark = "white" if value > DARK else "black"
        look = {"ha": "center", "va": "center", "fontsize": 8, "color": dark}
        ax.text(x + 0.5, y + 0.5, f"{value:.2f}{'*' if slack else ''}", **look)
    for case, limits in CASES.items():
        x, y = RATES.index(limits.delta_dot), ACCELERATIONS.index(limits.delta_ddot)
        ax.plot([x, x + 1, x + 1, x, x], [y, y, y + 1, y + 1, y], color="#D0101A", lw=1.8)
        ax.text(x + 0.06, y + 0.95, str(case), color="#D0101A", va="top", fontsize=8, weight="bold")
    ax.set_xticks(np.arange(len(RATES)) + 0.5, [f"{rate:g}" for rate in RATES], fontsize=8)
    heights = np.arange(len(ACCELERATIONS)) + 0.5
    ax.set_yticks(heights, [f"{each:g}" for each in ACCELERATIONS], fontsize=8)
    ax.set(xlabel=r"largest $|\dot\delta|$ [rad/s]", ylabel=r"largest $|\ddot\delta|$ [rad/s²]")
    figure.colorbar(mesh, ax=ax, label="largest |β| [°]")
    return figure


DARK = 1.6
"""°; cells beyond are so dark that their numbers are white."""
