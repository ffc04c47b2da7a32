"""Section 4.2: δ, δ̇ and δ̈ as a knob gives them, raw and shaped, and what a solver makes of them."""

from bisect import bisect_right
from functools import partial
from math import inf
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from kitemj.flight.live import TICK
from kitemj.flight.scenario import Scenario, scenario_of
from kitemj.flight.validity import Departure, first_departure
from kitemj.physics.parameters import StickLimits
from kitemj.physics.shaping import StickLaw, asked, shaped
from kitemj.physics.steering import Control, Segment, control, rest_ell
from kitemj.tables import Cell, Table
from kitemj.thesis.ode45 import ATOL, RTOL, Solved, Steering, solved
from kitemj.thesis.panels import panels
from kitemj.thesis.section import Answer, Drawing, Named, Section, Verdict

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_DIAGRAM = "a Simulink block diagram; the same is done by "

ANSWERS = (
    Answer("Figure 16", Verdict.NOT_APPLICABLE, _DIAGRAM + "StickLaw.ANGLE in physics/shaping.py"),
    Answer("Figure 17", Verdict.NOT_APPLICABLE, _DIAGRAM + "StickLaw.RATE in physics/shaping.py"),
    Answer(
        "Figure 18",
        Verdict.NOT_APPLICABLE,
        _DIAGRAM + "StickLaw.ACCELERATION in physics/shaping.py",
    ),
    Answer("Figure 19", Verdict.NOT_APPLICABLE, _DIAGRAM + "LiveFlight in flight/live.py"),
    Answer("Figure 20", Verdict.REPRODUCED, "the peaks of a knob without a filter", "sticks_raw"),
    Answer(
        "Figure 21",
        Verdict.REPRODUCED,
        "the peaks are gone; by a plan within limits, where the thesis cuts slopes",
        "sticks_shaped",
    ),
    Answer("Figure 22", Verdict.NOT_APPLICABLE, _DIAGRAM + "shaped in physics/shaping.py"),
)

MOVES = ((0.0, 0.0), (1.0, 1.0), (13.0, -1.0), (18.0, 0.0))
"""Time [s] and stick from then on; the thesis does not tell its own."""

DURATION = 25.0  # s
TICKS = (0.1, 0.02, TICK)
"""s; how often the knob is read, in flight."""

FINER = (0.1, 0.05, 0.02, TICK, 0.005, 0.002, 0.001)
"""s; the same for the peaks alone."""

SIGNALS = {
    "delta": r"$\delta$ [rad]",
    "delta_dot": r"$\dot\delta$ [rad/s]",
    "delta_ddot": r"$\ddot\delta$ [rad/s²]",
}


class Steered(NamedTuple):
    """The control at the start of each `tick` [s], and how it goes on until the next."""

    kind: str
    law: StickLaw
    tick: float
    controls: list[Control]
    steering: list[Steering]

    def peak(self, signal: str) -> float:
        """The largest |`signal`|."""
        return max(abs(float(getattr(c, signal))) for c in self.controls)


class Flown(NamedTuple):
    """What the solver made of it, and where that first left the limits of validity."""

    steered: Steered
    found: Solved
    departure: Departure | None

    @property
    def pulls(self) -> tuple[float, float]:
        """The least and the largest tension [N] at the end of a tick."""
        tensions = [tension for motion in self.found.motions for tension in motion.tensions]
        return min(tensions), max(tensions)


def stick(t: float) -> float:
    """The stick at time `t` [s]."""
    return MOVES[bisect_right(MOVES, (t + 1e-9, inf)) - 1][1]


def raw(limits: StickLimits, ell: float, law: StickLaw, tick: float) -> Steered:
    """As blocks make it of a knob: differences and sums at each tick, held until the next.

    δ is cut at its limit, where δ̇ and δ̈ become zero; nothing else is limited.
    """
    rule, last = _RULES[law], Control(ell, 0.0, 0.0, 0.0, 0.0, 0.0)
    controls = []
    for k in range(round(DURATION / tick)):
        last = Control(ell, 0.0, 0.0, *rule(limits, stick(k * tick), last, tick))
        controls.append(last)
    return Steered("raw", law, tick, controls, [partial(_held, c) for c in controls])


def smooth(limits: StickLimits, ell: float, law: StickLaw, tick: float) -> Steered:
    """As kitemj flies the same moves."""
    segment = Segment(0.0, Control(ell, 0.0, 0.0, 0.0, 0.0, 0.0))
    segments = []
    for k in range(round(DURATION / tick)):
        now = control(segment, k * tick)
        wish, rate = asked(limits, law, stick(k * tick), now, tick)
        segment = shaped(limits, now, k * tick, tick, wish, ell, ell, rate)
        segments.append(segment)
    controls = [segment.control for segment in segments]
    return Steered("shaped", law, tick, controls, [partial(control, s) for s in segments])


Made = dict[tuple[str, StickLaw, float], Steered]
"""By kind, law and tick [s]."""


def _held(c: Control, t: float) -> Control:
    return c


Signals = tuple[float, float, float]


def _from_angle(limits: StickLimits, knob: float, last: Control, tick: float) -> Signals:
    """The knob is δ: two differences."""
    delta = knob * limits.delta
    rate = (delta - last.delta) / tick
    return delta, rate, (rate - last.delta_dot) / tick


def _from_rate(limits: StickLimits, knob: float, last: Control, tick: float) -> Signals:
    """The knob is δ̇: a sum and a difference."""
    delta = _sum(limits, last, tick)
    rate = _stopped(limits, delta, knob * limits.delta_dot)
    return delta, rate, (rate - last.delta_dot) / tick


def _from_acceleration(limits: StickLimits, knob: float, last: Control, tick: float) -> Signals:
    """The knob is δ̈: two sums."""
    delta = _sum(limits, last, tick)
    rate = _stopped(limits, delta, last.delta_dot + tick * last.delta_ddot)
    return delta, rate, _stopped(limits, delta, knob * limits.delta_ddot)


def _sum(limits: StickLimits, last: Control, tick: float) -> float:
    return max(-limits.delta, min(limits.delta, last.delta + tick * last.delta_dot))


def _stopped(limits: StickLimits, delta: float, push: float) -> float:
    """`push`, or nothing where it is against the end of δ's way."""
    return 0.0 if abs(delta) >= limits.delta and push * delta > 0 else push


_RULES = {
    StickLaw.ANGLE: _from_angle,
    StickLaw.RATE: _from_rate,
    StickLaw.ACCELERATION: _from_acceleration,
}


def flown(scenario: Scenario, steered: Steered) -> Flown:
    """The thesis's solver through it."""
    found = solved(scenario.parameters, scenario.start, steered.steering, steered.tick)
    return Flown(steered, found, first_departure(scenario.parameters, found.motions))


def section(scratch: Path) -> Section:
    """Sticks: three laws, raw and shaped, at three ticks."""
    scenario = scenario_of({"set": "thesis", "duration": DURATION}, "the sticks of section 4.2")
    parameters, limits = scenario.parameters, scenario.parameters.stick
    ell = rest_ell(parameters.lines.length, parameters.kite.y_A)
    made = [make(limits, ell, law, t) for law in StickLaw for make in (raw, smooth) for t in FINER]
    at: Made = {(s.kind, s.law, s.tick): s for s in made}
    chosen = [s for s in made if s.tick in TICKS]
    flights = [flown(scenario, steered) for steered in chosen]
    drawings = [
        Drawing(
            "sticks_raw",
            f"The same moves of the stick under the three laws, raw, read every "
            f"{TICK * 1e3:g} ms. In the shaded band is what the thesis allows in the end; where "
            f"no band is seen it is thinner than the line.",
            _signals_figure(limits, [at["raw", law, TICK] for law in StickLaw]),
        ),
        Drawing(
            "sticks_shaped",
            "The same moves, shaped: every signal within its band, δ within its limit without "
            "a jump of δ̇.",
            _signals_figure(limits, [at["shaped", law, TICK] for law in StickLaw]),
        ),
        Drawing(
            "sticks_growth",
            "Left: largest |δ̈| over the tick at which the knob is read. Right: largest pull "
            "or push of a line when the thesis's solver flies that. Shaped, all three laws lie "
            "on one line.",
            _growth_figure(at, flights),
        ),
    ]
    tables = [
        Named("sticks_peaks", _peak_table(limits, [s for s in chosen if s.tick == TICK])),
        Named("sticks_solver", _solver_table(flights)),
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


def _here(limits: StickLimits, flights: list[Flown]) -> list[str]:
    """What the flights show."""
    of = {(f.steered.kind, f.steered.law, f.steered.tick): f for f in flights}
    raws, smooths = ([f for f in flights if f.steered.kind == kind] for kind in ("raw", "shaped"))
    hardest = max(raws, key=lambda f: f.found.rejected)
    law, tick = hardest.steered.law, hardest.steered.tick
    same = of["shaped", law, tick].found
    largest = [max(f.steered.peak(n) / getattr(limits, n) for f in smooths) for n in SIGNALS]
    pulls = [pull for f in smooths for pull in f.pulls]
    return [
        *(
            _grown(limits, *(of["raw", law, tick] for tick in TICKS[:: len(TICKS) - 1]))
            for law in StickLaw
        ),
        f"The solver has most to do with {law.symbol} raw at a tick of {tick * 1e3:g} ms: "
        f"{hardest.found.evaluations:,} right-hand sides and steps down to "
        f"{hardest.found.smallest:.2g} s, against {same.evaluations:,} and {same.smallest:.2g} s "
        f"for the same moves shaped.",
        f"Shaped, with all three laws at all ticks, |δ|, |δ̇| and |δ̈| reach {largest[0]:.3f}, "
        f"{largest[1]:.3f} and {largest[2]:.3f} of their limits, tensions stay between "
        f"{min(pulls):.1f} N and {max(pulls):.1f} N, at most "
        f"{max(f.found.rejected for f in smooths)} steps are rejected, and "
        f"{sum(f.departure is not None for f in smooths)} of {len(smooths)} flights leave the "
        f"limits of validity.",
    ]


def _grown(limits: StickLimits, coarse: Flown, fine: Flown) -> str:
    """What one law does raw, at the longest and at the shortest tick."""
    rough, fast = coarse.steered, fine.steered
    ddot, (low, high) = fast.peak("delta_ddot"), fine.pulls
    valid = f"{fine.departure}." if fine.departure else "the limits of validity are kept."
    return (
        f"{fast.law.symbol} raw: at ticks of {rough.tick * 1e3:g} ms and {fast.tick * 1e3:g} ms "
        f"|δ̈| reaches {rough.peak('delta_ddot'):,g} and {ddot:,g} rad/s², "
        f"{ddot / limits.delta_ddot:,.0f} times the limit, and |δ̇| "
        f"{fast.peak('delta_dot') / limits.delta_dot:,.0f} times its limit. Flown at "
        f"{fast.tick * 1e3:g} ms, lines carry {low:,.0f} N to {high:,.0f} N; {valid}"
    )


def _peak_table(limits: StickLimits, steered: list[Steered]) -> Table:
    """A row for each law and kind at the tick of a live flight."""
    columns = ["law", "stick"]
    for name, unit in zip(SIGNALS, ("rad", "rad_per_s", "rad_per_s2"), strict=True):
        columns += [f"peak_{name}_{unit}", f"{name}_over_limit"]
    rows = list[tuple[Cell, ...]]()
    for s in steered:
        peaks = [(s.peak(name), s.peak(name) / getattr(limits, name)) for name in SIGNALS]
        rows.append((s.law.symbol, s.kind, *(number for pair in peaks for number in pair)))
    return Table(f"peaks at a tick of {TICK * 1e3:g} ms", tuple(columns), rows)


def _solver_table(flights: list[Flown]) -> Table:
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
            *flight.pulls,
            departure.t if departure else DURATION,
            departure.ending.name.lower() if departure else "the end",
        )
        for flight in flights
        for s, found, departure in [flight]
    ]
    return Table(f"ode45 ({RTOL:g}, {ATOL:g}) through {DURATION:g} s", columns, rows)


def _signals_figure(limits: StickLimits, steered: list[Steered]) -> "Figure":
    """A column for each law, a row for each signal."""
    figure, axes = panels(len(SIGNALS), len(steered), (10.5, 6.5), sharex=True)
    for column, s in zip(axes.T, steered, strict=True):
        t = [k * s.tick for k in range(len(s.controls))]
        column[0].set_title(f"the stick is {s.law.symbol}, {s.kind}", fontsize=10)
        for ax, (name, label) in zip(column, SIGNALS.items(), strict=True):
            limit = getattr(limits, name)
            ax.axhspan(-limit, limit, color="tab:green", alpha=0.15, lw=0)
            values = [getattr(c, name) for c in s.controls]
            ax.step(t, values, where="post", lw=1.1)
            ax.margins(y=0.12)
            ax.set_ylabel(label)
            ax.grid(alpha=0.3)
        column[-1].set_xlabel("time [s]")
    return figure


def _growth_figure(at: Made, flights: list[Flown]) -> "Figure":
    """Peaks over the tick, on logarithms."""
    figure, axes = panels(1, 2, (10.5, 4.2))
    left, right = axes[0]
    ticks = [1e3 * tick for tick in FINER]
    for law in StickLaw:
        for kind, style in (("raw", "o-"), ("shaped", "s--")):
            label, colour = f"{law.symbol} {kind}", f"C{law.value}"
            peaks = [at[kind, law, tick].peak("delta_ddot") for tick in FINER]
            left.loglog(ticks, peaks, style, ms=4, color=colour, label=label)
            own = [f for f in flights if f.steered.law is law and f.steered.kind == kind]
            forces = [max(map(abs, f.pulls)) for f in own]
            right.loglog(
                [1e3 * f.steered.tick for f in own], forces, style, ms=4, color=colour, label=label
            )
    left.set(xlabel="tick [ms]", ylabel=r"largest $|\ddot\delta|$ [rad/s²]")
    right.set(xlabel="tick [ms]", ylabel="largest |tension| [N]")
    for ax in (left, right):
        ax.grid(alpha=0.3, which="both")
    figure.legend(
        *left.get_legend_handles_labels(), loc="outside lower center", ncols=6, fontsize=8
    )
    return figure


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
