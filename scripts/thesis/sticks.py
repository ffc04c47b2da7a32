"""Section 4.2: δ, δ̇ and δ̈ from a knob, raw and shaped, and what they cost a solver."""

from pathlib import Path

from kitemj.flight.live import TICK
from kitemj.flight.scenario import scenario_of
from kitemj.physics.parameters import StickLimits
from kitemj.physics.shaping import StickLaw
from kitemj.physics.steering import rest_ell
from kitemj.tables import Cell, Table
from thesis.ode45 import ATOL, RTOL
from thesis.section import Answer, Drawing, NamedTable, Section, Verdict
from thesis.sticks_figures import growth_figure, signals_figure
from thesis.sticks_flights import (
    DURATION,
    FINE_TICKS,
    SIGNALS,
    TICKS,
    AllSignals,
    SolvedFlight,
    StickSignals,
    raw_signals,
    shaped_signals,
    solve_flight,
)

_DIAGRAM = "a Simulink block diagram; the same is done by "

ANSWERS = (
    Answer(
        "Figure 16",
        Verdict.NOT_APPLICABLE,
        _DIAGRAM + "StickLaw.ANGLE in kitemj/physics/shaping.py",
    ),
    Answer(
        "Figure 17", Verdict.NOT_APPLICABLE, _DIAGRAM + "StickLaw.RATE in kitemj/physics/shaping.py"
    ),
    Answer(
        "Figure 18",
        Verdict.NOT_APPLICABLE,
        _DIAGRAM + "StickLaw.ACCELERATION in kitemj/physics/shaping.py",
    ),
    Answer("Figure 19", Verdict.NOT_APPLICABLE, _DIAGRAM + "tick in kitemj/flight/live.py"),
    Answer("Figure 20", Verdict.REPRODUCED, "the peaks of a knob without a filter", "sticks_raw"),
    Answer(
        "Figure 21",
        Verdict.REPRODUCED,
        "the peaks are gone; by a plan within limits, where the thesis cuts slopes",
        "sticks_shaped",
    ),
    Answer("Figure 22", Verdict.NOT_APPLICABLE, _DIAGRAM + "shaped in kitemj/physics/shaping.py"),
)


def section(scratch: Path) -> Section:
    """Sticks: three laws, raw and shaped, at three ticks."""
    scenario = scenario_of({"set": "thesis", "duration": DURATION}, "the sticks of section 4.2")
    parameters, limits = scenario.parameters, scenario.parameters.stick
    ell = rest_ell(parameters.lines.length, parameters.kite.y_A)
    made = [
        make(limits, ell, law, t)
        for law in StickLaw
        for make in (raw_signals, shaped_signals)
        for t in FINE_TICKS
    ]
    at: AllSignals = {(s.kind, s.law, s.tick): s for s in made}
    chosen = [s for s in made if s.tick in TICKS]
    flights = [solve_flight(scenario, signals) for signals in chosen]
    drawings = [
        Drawing(
            "sticks_raw",
            f"The same moves of the stick under the three laws, raw, read every "
            f"{TICK * 1e3:g} ms. In the shaded band is what the thesis allows in the end; where "
            f"no band is seen it is thinner than the line.",
            signals_figure(limits, [at["raw", law, TICK] for law in StickLaw]),
        ),
        Drawing(
            "sticks_shaped",
            "The same moves, shaped: every signal within its band, δ within its limit without "
            "a jump of δ̇.",
            signals_figure(limits, [at["shaped", law, TICK] for law in StickLaw]),
        ),
        Drawing(
            "sticks_growth",
            "Left: largest |δ̈| over the tick at which the knob is read. Right: largest pull "
            "or push of a line when the thesis's solver flies that. Shaped, all three laws lie "
            "on one line.",
            growth_figure(at, flights),
        ),
    ]
    tables = [
        NamedTable("sticks_peaks", _peak_table(limits, [s for s in chosen if s.tick == TICK])),
        NamedTable("sticks_solver", _solver_table(flights)),
    ]
    return Section(
        "The stick: δ, δ̇, δ̈ (section 4.2)",
        ANSWERS,
        _THESIS,
        _here(limits, flights),
        _WHY,
        drawings,
        tables,
    )


def _here(limits: StickLimits, flights: list[SolvedFlight]) -> list[str]:
    """What the flights show."""
    of = {(f.signals.kind, f.signals.law, f.signals.tick): f for f in flights}
    raws, smooths = ([f for f in flights if f.signals.kind == kind] for kind in ("raw", "shaped"))
    hardest = max(raws, key=lambda f: f.found.rejected)
    law, tick = hardest.signals.law, hardest.signals.tick
    same = of["shaped", law, tick].found
    largest = [max(f.signals.peak(n) / getattr(limits, n) for f in smooths) for n in SIGNALS]
    tension_range = [pull for f in smooths for pull in f.tension_range]
    return [
        *(
            _growth_text(limits, *(of["raw", law, tick] for tick in TICKS[:: len(TICKS) - 1]))
            for law in StickLaw
        ),
        f"The solver has most to do with {law.symbol} raw at a tick of {tick * 1e3:g} ms: "
        f"{hardest.found.evaluations:,} right-hand sides and steps down to "
        f"{hardest.found.smallest:.2g} s, against {same.evaluations:,} and {same.smallest:.2g} s "
        f"for the same moves shaped.",
        f"Shaped, with all three laws at all ticks, |δ|, |δ̇| and |δ̈| reach {largest[0]:.3f}, "
        f"{largest[1]:.3f} and {largest[2]:.3f} of their limits, tensions stay between "
        f"{min(tension_range):.1f} N and {max(tension_range):.1f} N, at most "
        f"{max(f.found.rejected for f in smooths)} steps are rejected, and "
        f"{sum(f.departure is not None for f in smooths)} of {len(smooths)} flights leave the "
        f"limits of validity.",
    ]


def _growth_text(limits: StickLimits, coarse: SolvedFlight, fine: SolvedFlight) -> str:
    """What one law does raw, at the longest and at the shortest tick."""
    rough, fast = coarse.signals, fine.signals
    ddot, (low, high) = fast.peak("delta_ddot"), fine.tension_range
    valid = f"{fine.departure}." if fine.departure else "the limits of validity are kept."
    return (
        f"{fast.law.symbol} raw: at ticks of {rough.tick * 1e3:g} ms and {fast.tick * 1e3:g} ms "
        f"|δ̈| reaches {rough.peak('delta_ddot'):,g} and {ddot:,g} rad/s², "
        f"{ddot / limits.delta_ddot:,.0f} times the limit, and |δ̇| "
        f"{fast.peak('delta_dot') / limits.delta_dot:,.0f} times its limit. Flown at "
        f"{fast.tick * 1e3:g} ms, lines carry {low:,.0f} N to {high:,.0f} N; {valid}"
    )


def _peak_table(limits: StickLimits, signals: list[StickSignals]) -> Table:
    """A row for each law and kind at the tick of a live flight."""
    columns = ["law", "stick"]
    for name, unit in zip(SIGNALS, ("rad", "rad_per_s", "rad_per_s2"), strict=True):
        columns += [f"peak_{name}_{unit}", f"{name}_over_limit"]
    rows = list[tuple[Cell, ...]]()
    for s in signals:
        peaks = [(s.peak(name), s.peak(name) / getattr(limits, name)) for name in SIGNALS]
        rows.append((s.law.symbol, s.kind, *(number for pair in peaks for number in pair)))
    return Table(f"peaks at a tick of {TICK * 1e3:g} ms", tuple(columns), rows)


def _solver_table(flights: list[SolvedFlight]) -> Table:
    """A row for each flight."""
    columns = (
        "law",
        "stick",
        "tick_ms",
        "peak_delta_ddot_rad_per_s2",
        "right_hand_sides",
        "rejected_steps",
        "smallest_step_s",
        "tension_low_N",
        "tension_high_N",
        "valid_until_s",
        "then",
    )
    rows: list[tuple[Cell, ...]] = [
        (
            s.law.symbol,
            s.kind,
            1e3 * s.tick,
            s.peak("delta_ddot"),
            found.evaluations,
            found.rejected,
            found.smallest,
            *flight.tension_range,
            departure.t if departure else DURATION,
            departure.limit.name if departure else "the end",
        )
        for flight in flights
        for s, found, departure in [flight]
    ]
    return Table(f"ode45 ({RTOL:g}, {ATOL:g}) through {DURATION:g} s", columns, rows)


_THESIS = [
    "A knob set δ, δ̇ or δ̈ (Figures 16-18), and blocks differentiated or integrated the other "
    "two. δ was cut at its limit, and δ̇ and δ̈ were to become zero there. ℓ stayed as it was.",
    "A knob that jumps gave high peaks of δ̇ and δ̈ (Figure 20), which ended the solver with "
    "errors. Limiting the rates of change of δ and of δ̇ took the peaks away (Figures 21 and 22).",
]

_WHY = [
    "A jump of δ by Δ, differentiated over a tick T, gives Δ/T and Δ/T², a jump of δ̇ gives its "
    "size over T, and neither has a limit as T becomes small: an error control that shortens "
    "its steps meets a problem that becomes harder as it does. Rigid lines hand δ̈ to the kite at "
    "once, which is where the tensions come from.",
    "Raw signals also contradict one another: δ stands still within a tick in which δ̇ is not "
    "zero, and the end of the way stops δ̇ without a δ̈ that would have done so. The equations "
    "take all three as given, and the kite's velocity jumps with δ̇. kitemj takes the quickest "
    "way within the limits of δ̇ and δ̈ (planned anew at each tick by the library ruckig), "
    "brakes before the end, and δ and δ̇ are exact integrals of δ̈.",
    "Whether δ̇ raw is too much depends on the solver: one that ends its steps at the ticks, as "
    "in the table, meets pulses of δ̈ of known size, where a derivative taken over the solver's "
    "own steps grows while these become shorter.",
]
