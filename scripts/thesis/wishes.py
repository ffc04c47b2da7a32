"""Section 7: the wishes and limits that the thesis names: what is done, what is open."""

from pathlib import Path
from typing import NamedTuple

from kitemj.dynamics.motion import Motion
from kitemj.flight.limits import GROUND, Departure
from kitemj.flight.live import TICK, Command, SteeredFlight, TickResult
from kitemj.flight.scenario import scenario_of
from kitemj.physics.aerodynamics import LinearAero
from kitemj.physics.parameter_files import parameter_set
from kitemj.physics.steering import rest_ell
from kitemj.pilots.manoeuvres import Eight, Land, Pilot
from kitemj.tables import Cell, Table
from thesis.section import Answer, NamedTable, Section

ANSWERS: tuple[Answer, ...] = ()
"""The wishes have no figure."""

EIGHTS_DURATION = 40.0  # s
LANDING_DURATION = 30.0
"""s; the landing takes less, or is none."""

REELING_DURATION = 10.0  # s
REEL_STICK = 0.5
"""Of the way that ℓ has: the stick that is held."""


class Outcome(NamedTuple):
    """A live flight: its last moment, its first departure from a limit, how long it took [s]."""

    last: TickResult
    departure: Departure | None
    t: float


class Wish(NamedTuple):
    """`state` is done, in part or open; `where` thesis asks for it; `shown` is flown here."""

    wish: str
    where: str
    state: str
    here: str
    open: str = ""
    shown: str = ""


class ReelOut:
    """A stick that asks for more line."""

    def command(self, motion: Motion) -> Command:
        """The same at every time."""
        return Command(ell=REEL_STICK)


def fly(kite: str, pilot: Pilot, duration: float) -> Outcome:
    """The set `kite` under `pilot` for `duration` [s], or until it touches the ground."""
    flight = SteeredFlight(scenario_of({"set": kite, "duration": duration}, "section 7"))
    result, first = flight.result, None
    for _ in range(round(duration / TICK)):
        result = flight.tick(pilot.command(result.motion))
        first = first or result.departure
        if result.departure and result.departure.limit is GROUND:
            break
    return Outcome(result, first, result.motion.t)


def as_coefficient_table(aero: LinearAero) -> list[list[list[float]]]:
    """The linear law as the general table, indexed [coefficient][term][power of α].

    The table scales rates by the airspeed, the law by V_ref: they agree where these are the
    same, and C_mq is doubled because the law lacks a ½.
    """
    nothing = [0.0, 0.0, 0.0]

    def row(constant: float, alpha: float, *rest: float) -> list[list[float]]:
        terms = [[constant, alpha, 0.0], *([number, 0.0, 0.0] for number in rest)]
        return terms + [nothing] * (8 - len(terms))

    return [
        row(aero.Cx_0, aero.Cx_alpha),
        row(0.0, 0.0, aero.Cy_beta),
        row(aero.Cz_0, aero.Cz_alpha),
        row(0.0, 0.0, aero.Cl_beta, aero.Cl_p),
        row(aero.Cm_0, aero.Cm_alpha, 0.0, 0.0, 2 * aero.Cm_q),
        row(0.0, 0.0, aero.Cn_beta, 0.0, 0.0, aero.Cn_r),
    ]


def section(scratch: Path) -> Section:
    """The wishes, with short flights where one can be shown."""
    wishes = [*_of_section_7(), *_ELSEWHERE, _landing()]
    count = {state: sum(w.state == state for w in wishes) for state in ("done", "in part", "open")}
    rows: list[tuple[Cell, ...]] = [tuple(wish) for wish in wishes]
    table = Table("what the thesis wished for or left out", Wish._fields, rows)
    here = [
        f"Of {len(wishes)} wishes and limits {count['done']} are done, {count['in part']} in part, "
        f"{count['open']} open. What the last column shows was flown for this table."
    ]
    return Section(
        "What the thesis wished for (section 7)",
        ANSWERS,
        _THESIS,
        here,
        tables=[NamedTable("wishes", table)],
    )


def _of_section_7() -> list[Wish]:
    reeled, eight = fly("thesis", ReelOut(), REELING_DURATION), Eight()
    flown = fly("sport", eight, EIGHTS_DURATION)
    ell = reeled.last.motion.control.ell - ell_at_rest("thesis")
    return [
        Wish(
            "a joystick in place of the knob, for ℓ as well as δ",
            "7",
            "done",
            "gamepads, keys and mouse move both (kitemj/controls/stick.py, "
            "kitemj/controls/pads.py)",
            "",
            f"set thesis, {REEL_STICK:.0%} of the way of ℓ asked for: {ell:+.2f} m after "
            f"{reeled.t:g} s; {_departure_text(reeled)}",
        ),
        Wish(
            "a function that looks at the state and flies by itself",
            "1.2, 7",
            "in part",
            "pilots for kites that turn (kitemj/pilots/manoeuvres.py)",
            "pilots for a kite that only drifts, as the thesis's does; paths made for power",
            f"set sport, figures of eight for {flown.t:g} s: {eight.passes} turns back; "
            f"{_departure_text(flown)}",
        ),
        Wish(
            "better aerodynamics",
            "2.2, 3.1, 7",
            "in part",
            "a table of coefficients, quadratic in α, with rates and control surfaces, takes the "
            "linear law's place in any scenario (kitemj/physics/aerodynamics.py)",
            "coefficients measured on a kite; what happens beyond stall",
            f"the linear law written as such a table stands {table_gap():.1g} rad away from it",
        ),
        Wish(
            "a display that takes less time",
            "7",
            "done",
            "MuJoCo's renderer in place of plots (kitemj/drawing/picture.py); what it costs is "
            "measured in the section on real time",
        ),
        Wish(
            "other kites and other models, easily put in",
            "7",
            "done",
            "a kite is a set of numbers in a scenario, a model a class with a few verbs "
            "(kitemj/dynamics/motion.py)",
        ),
    ]


def _landing() -> Wish:
    outcome = fly("sport", Land(), LANDING_DURATION)
    return Wish(
        "take-off and landing",
        "2.2, 3",
        "in part",
        "lines go slack and tighten again, the kite meets the ground, a pilot lands it",
        "take-off",
        f"set sport: {_departure_text(outcome)}",
    )


def _departure_text(outcome: Outcome) -> str:
    """Which limit was left."""
    return str(outcome.departure) if outcome.departure else "no limit of validity was left"


def ell_at_rest(name: str) -> float:
    """ℓ₀ [m] of a set."""
    parameters = parameter_set(name)
    return rest_ell(parameters.lines.length, parameters.kite.y_A)


def table_gap() -> float:
    """How far apart [rad] the thesis kite's equilibria are under both laws, in any angle."""
    aero = parameter_set("thesis").aero
    assert isinstance(aero, LinearAero)
    table = {"law": "table", "table": as_coefficient_table(aero)}
    own, other = (
        scenario_of({"set": "thesis", "duration": 1.0, **more}, "section 7").start.q
        for more in ({}, {"aero": table})
    )
    return max(abs(a - b) for a, b in zip(own, other, strict=True))


_ELSEWHERE = [
    Wish(
        "lines moved by a machine, with other limits than arms have",
        "4.6",
        "done",
        "limits of δ, ℓ and their derivatives are numbers of a scenario ([stick])",
    ),
    Wish(
        "wind as it is: unexpected, turbulent",
        "2.2",
        "in part",
        "a power law of height with gusts as a sine (kitemj/physics/wind.py)",
        "turbulence, a field of wind",
    ),
    Wish(
        "elastic lines",
        "2.1",
        "open",
        "lines are straight, massless and of given length; they may go slack",
        "elasticity, as LAKSA's module Kite Elastic has it",
    ),
    Wish(
        "forces of the air on the lines, their weight",
        "2.1, 2.2",
        "open",
        "lines only pull",
        "drag and weight, which matter on long lines",
    ),
    Wish(
        "the shape of the canopy",
        "2.2",
        "open",
        "a rigid body with two points of attachment; bridles are drawn, no more",
        "a bridle, a canopy that bends",
    ),
    Wish(
        "trajectories made the best possible",
        "2.2",
        "open",
        "cycles that the kite flies by itself are found (kitemj stability --cycle), parameters "
        "are swept (kitemj sweep)",
        "optimal control",
    ),
    Wish("networks of kites", "2.2", "open", "one kite", "more than one"),
]

_THESIS = [
    "Section 7 wishes for a joystick with ℓ and δ (given up for a licence), control by a function "
    "in a person's place, better aerodynamics, and a display that costs less than MATLAB's plot "
    "(also given up for a licence). Sections 2 to 4 name more that was left out.",
]
