"""Section 4.6: how much of the model's limits the four cases of Table 3 take up."""

from math import degrees
from pathlib import Path

from kitemj.tables import Table
from thesis.limits_of_steering_figures import (
    case_figure,
    cases_figure,
    map_figure,
    square_wave_figure,
)
from thesis.limits_of_steering_flights import CASES, LENGTHS, Case, Flights, held_beta
from thesis.limits_of_steering_tables import (
    ARM,
    HALF_PERIODS,
    RATES,
    case_table,
    lengths_table,
    map_table,
    ratio_table,
    reach_table,
    sensitivity_table,
    square_wave_table,
)
from thesis.programmed_steering import FULL_DEFLECTION, live_flights, scenario
from thesis.section import Answer, Drawing, NamedTable, Section, Verdict

_KNOB = "the hand that moved the thesis's knob is not known; this one is programmed"
ANSWERS = (
    Answer("Table 3", Verdict.REPRODUCED, "its limits are those flown here", "limits_cases"),
    Answer("Figure 33", Verdict.REPRODUCED, "the plot itself, of the flight of case 3", "case_3"),
    *(
        Answer(f"Figure {33 + case}", Verdict.DIFFERS, _KNOB, f"case_{case}")
        for case in (1, 2, 3, 4)
    ),
)


def section(scratch: Path) -> Section:
    """Cases by all three models; everything else by Lagrange's equations."""
    flights = {
        case: live_flights(LENGTHS[0], limits.stick(), FULL_DEFLECTION)
        for case, limits in CASES.items()
    }
    cases, square_waves = case_table(flights), square_wave_table()
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
        here=[*_here(flights, cases, square_waves), *_here_more(sensitivities, reach, beyond)],
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
                    case_figure(case, flights[case]["mujoco"]),
                )
                for case, limits in CASES.items()
            ),
            Drawing(
                "cases_beta",
                "δ and β of the four cases. Case 4 lies on case 3. Dotted: β of the kite that "
                "stands with δ held at ±0.1 rad.",
                cases_figure(flights),
            ),
            Drawing(
                "hands_beta",
                "Largest |β| under full right and full left in turn, over how long each is held: "
                "cases 3 and 4 are one line.",
                square_wave_figure(square_waves),
            ),
            Drawing(
                "beta_map",
                "Largest |β| [°] over the limits of δ̇ and δ̈; the four cases are framed. A star: a "
                "line would have to push. In the first column the hand does not get to 0.1 rad "
                "before it turns back.",
                map_figure(beyond),
            ),
        ],
        tables=[
            NamedTable("limits_cases", cases),
            NamedTable("limits_ratios", ratio_table(flights)),
            NamedTable("limits_lengths", lengths_table()),
            NamedTable("limits_sensitivities", sensitivities),
            NamedTable("limits_hands", square_waves),
            NamedTable("arm_reach", reach),
            NamedTable("beta_map", beyond, show=False),
        ],
    )


def _here(flights: Flights, cases: Table, square_waves: Table) -> list[str]:
    beta = {int(row[0]): float(row[4]) for row in cases.rows}
    spread, held = max(float(row[-1]) for row in cases.rows), held_beta(LENGTHS[0])
    limit = degrees(scenario(LENGTHS[0]).parameters.limits.beta_max)
    order = all(float(row[2]) > float(row[3]) > float(row[1]) for row in square_waves.rows)
    tie = [100 * (float(row[4]) / float(row[3]) - 1) for row in square_waves.rows]
    said = "the same" if order else "not always the same"
    return [
        f"Largest |β| is {beta[1]:.3f}° in case 1, {beta[3]:.3f}° in case 3 and {beta[2]:.3f}° in "
        f"case 2: it rises with δ̇_max as the thesis found, by {100 * (beta[2] / beta[1] - 1):.0f} "
        f"% for ten times the rate. δ̈_max does next to nothing: case 4 differs from case 3 by "
        f"{beta[4] - beta[3]:+.0e}°, {100 * (beta[4] / beta[3] - 1):+.3f} % for ten times as much. "
        f"The three models agree on β within {spread:.0e}° throughout.",
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
