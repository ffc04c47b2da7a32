"""What was found of how a kite turns: laws with their uncertainties, tables, sentences."""

from dataclasses import dataclass
from math import nan

from kitemj.flight.live import TICK
from kitemj.physics.parameters import Parameters
from kitemj.tables import Cell, Table, Tabled
from kitemj.turning.linear_law import LinearLaw
from kitemj.turning.probe import EARLY, Probe
from kitemj.turning.turning_fit import SLOWEST, Fit, Numbers

EXPLAINED = 0.8
"""Of the turn rate's variance, in a part of the flight that was not fitted; where a law explains
less, nearly half of the turning (a root mean square) is something else."""
CERTAIN = 2.0
"""Standard uncertainties by which c₁ is to be above 0."""


@dataclass(frozen=True)
class Identification(Tabled):
    """How the kite of `source` turns.

    `probe`: the test flight, by `model`; on `eights` or about rest. `fit`: the law with a lag
    and, where it can be told, n; `plain`: the literature's, n = 1 and a constant delay. None
    where the flight was too short. `swing`: fitted to a small swing about rest, None where that
    does not last; `linear`: what the linear system has for the same swing.
    """

    source: str
    model: str
    parameters: Parameters
    eights: bool
    probe: Probe
    fit: Fit | None
    plain: Fit | None
    swing: Fit | None
    linear: LinearLaw

    @property
    def fault(self) -> str:
        """Why no law of turning holds, in words with numbers; empty where one does."""
        if self.fit is None:
            lasted = EARLY - SLOWEST + len(self.probe.flown.t) * TICK
            why = self.probe.departure or "its coordinates end beyond the zenith"
            return f"the test flight ended after {lasted:.0f} s or sooner ({why})"
        (c1, *_), (error, *_), explained = self.fit.numbers, self.fit.errors, self.fit.explained
        told = f"c₁ = {c1:.3g} ± {error:.2g} 1/(m rad)"
        share = f"{100 * explained:.0f} % of the turn rate's variance"
        if c1 <= CERTAIN * error:
            beta = getattr(self.parameters.aero, "Cn_beta", 0.0)
            why = f"; where it slides, the air turns its nose away (C_nβ = {beta:g} 1/rad)"
            turns = "turns away from" if c1 < -CERTAIN * error else "does not surely turn to"
            told = f"it {turns} the hand that pulls, {told}, with {share} explained"
            return told + (why if beta < 0 else "")
        if explained < EXPLAINED:
            return f"it explains {share}, less than {100 * EXPLAINED:.0f} % ({told})"
        return ""

    @property
    def holds(self) -> bool:
        """Whether a law of turning holds by which the kite can be steered."""
        return not self.fault

    @property
    def in_words(self) -> str:
        """Whether it holds, and how well."""
        if self.fit is None or self.plain is None or self.fault:
            return f"the law of turning does not hold for {self.source}: {self.fault}"
        law, plain = self.fit, self.plain
        return (
            f"the law of turning holds for {self.source}: it explains "
            f"{100 * law.explained:.1f} % of the turn rate's variance (with n = 1 and a constant "
            f"delay {100 * plain.explained:.1f} %); at {law.airspeed:.1f} m/s full stick turns "
            f"on a circle of {self.radius:.2g} m or more"
        )

    @property
    def beside_rest(self) -> str:
        """What the linear system at rest says beside the flying kite, in a sentence."""
        rest, fit = self.linear.law, self.fit
        V = rest.airspeed
        says = (
            f"about rest, in {V:.3g} m/s of air, the linear system turns by {rest.gain(V):.3g} "
            f"rad/s for each rad, {rest.delay(V):.2g} s late"
        )
        if fit is None or not self.eights:
            return says
        gain = fit.law.gain(fit.airspeed)
        return (
            f"{says}; flying at {fit.airspeed:.3g} m/s {gain:.3g} rad/s, {fit.numbers.delay:.2g} s"
        )

    @property
    def radius(self) -> float:
        """Of the tightest circle [m], at full stick and the law's airspeed; inf: not known."""
        if self.fit is None:
            return float("inf")
        gain = self.fit.law.gain(self.fit.airspeed)
        return abs(self.fit.airspeed / (gain * self.parameters.stick.delta))

    def tables(self) -> list[Table]:
        """A row for each law: those of the flying kite, and those about rest."""
        columns = (
            *("law", "c1_per_m", "c1_error_per_m", "c2_m_s2", "c2_error_m_s2"),
            *("exponent", "exponent_error", "airspeed_m_s", "lag_m", "lag_error_m"),
            *("delay_s", "delay_error_s", "share_fitted", "share_explained"),
        )
        flown = self.eights
        fits = {
            "flown, a lag" if flown else "about rest": self.fit,
            "flown, n = 1, a delay": self.plain if flown else None,
            "small swing at rest": self.swing if flown else None,
            "linear system at rest": _as_fit(self.linear),
        }
        return [Table("turning", columns, [_row(name, fit) for name, fit in fits.items() if fit])]


def _as_fit(linear: LinearLaw) -> Fit:
    """The law of a linear system, which is not uncertain by a flight."""
    law, unsure = linear.law, Numbers(nan, nan, nan, nan, nan)
    numbers = Numbers(law.c1, law.c2, law.exponent, law.lag, law.delay(law.airspeed))
    return Fit(numbers, unsure, law.airspeed, True, linear.explained, nan)


def _row(name: str, fit: Fit) -> tuple[Cell, ...]:
    (c1, c2, n, lag, delay), errors, v = fit.numbers, fit.errors, fit.airspeed
    known = (c1, errors.c1, c2, errors.c2, n, errors.exponent, v, lag, errors.lag)
    return (name, *known, delay, errors.delay, fit.fitted, fit.explained)
