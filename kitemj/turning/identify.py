"""How a kite turns, identified: a test flight, and the law of turning fitted to it."""

from functools import lru_cache

import numpy as np

from kitemj.errors import InputError
from kitemj.flight.pilot_settings import TurnRateLaw
from kitemj.physics.compiled import Array
from kitemj.physics.parameters import Parameters
from kitemj.turning.identification import Identification
from kitemj.turning.linear_law import LinearLaw, in_still_air, linear_law
from kitemj.turning.probe import AT_REST, Probe, eights, signal_for, standing
from kitemj.turning.turning_fit import SLOWEST, Fit, Flown, fit_law, looked_at

SHORTEST = 10.0
"""s; of a test flight that ended early, so much is needed."""
DIGITS = 4
"""Significant ones of a law that is flown by: more are not known, and the last bits would depend
on the machine."""


def identify(
    parameters: Parameters, model: str = "lagrange", source: str = "parameters"
) -> Identification:
    """How a kite turns in its wind, by a test flight of `model`.

    A kite that the linear system says does not turn to the hand that pulls is not sent on
    eights: the signal is then flown about rest. Raises InputError, which names `source`, where
    there is no equilibrium to begin at.
    """
    rough, signal = rough_law(parameters, source), signal_for(parameters, AT_REST)
    still = in_still_air(parameters)
    small = standing(still, model)
    swing, linear = None, rough
    if small.clean:
        amplitudes = amplitudes_of(small.flown, signal.frequencies)
        linear = linear_law(parameters, signal.frequencies, amplitudes, model, source)
        swing = fit_law(small.flown, exponent=1.0, part=1.0)
    again = turns(rough) or still != parameters
    flown = flight_for(parameters, rough, model) if again else small
    fit = fitted(flown, rough)
    plain = fit
    if fit and turns(rough):
        plain = fit_law(flown.flown, by_way=False, exponent=1.0)
    known = source, model, parameters, turns(rough)
    return Identification(*known, flown, fit, plain, swing, linear)


def identified_law(parameters: Parameters) -> TurnRateLaw:
    """The law of turning of a kite in its wind, by the Lagrangian model, to `DIGITS` digits.

    The same whichever model is then flown. Remembered. Raises InputError, which says why, where
    no law holds.
    """
    try:
        hash(parameters)
    except TypeError:  # a wind of somebody else's, with arrays
        return _identified_law(parameters)
    return _remembered(parameters)


def _identified_law(parameters: Parameters) -> TurnRateLaw:
    rough = rough_law(parameters, "identification")
    flown = flight_for(parameters, rough, "lagrange")
    fit = fitted(flown, rough)
    known = "this kite", "lagrange", parameters, turns(rough)
    found = Identification(*known, flown, fit, fit, None, rough)
    if fit is None or not found.holds:
        raise InputError(f"{found.in_words}; say its law under [pilot.law], or steer it yourself")
    return TurnRateLaw(*(float(f"{number:.{DIGITS}g}") for number in fit.law))


_remembered = lru_cache(maxsize=64)(_identified_law)


def rough_law(parameters: Parameters, source: str = "parameters") -> LinearLaw:
    """What the linear system about rest says for a signal of equal sines: enough to steer by.

    Raises InputError, which names `source`, where there is no equilibrium.
    """
    signal = signal_for(parameters, AT_REST)
    return linear_law(parameters, signal.frequencies, signal.amplitudes, source=source)


def turns(rough: LinearLaw) -> bool:
    """Whether the kite turns to the hand that pulls, so that it may be steered."""
    return rough.law.c1 > 0.0


def flight_for(parameters: Parameters, rough: LinearLaw, model: str) -> Probe:
    """On eights, steered by a rough law, or about rest where that says nothing to steer by."""
    return eights(parameters, rough.law, model) if turns(rough) else standing(parameters, model)


def fitted(flown: Probe, rough: LinearLaw) -> Fit | None:
    """The law that fits a test flight; None where it was too short.

    A swing about rest comes again and again, so that nothing of it is left to try the law on:
    all of it is fitted, and what is explained is its own share.
    """
    t = flown.flown.t
    if len(t) == 0 or t[-1] - t[0] < SHORTEST + SLOWEST:
        return None
    if turns(rough):
        return fit_law(flown.flown)
    fit = fit_law(flown.flown, part=1.0)
    return fit._replace(explained=fit.fitted)


def amplitudes_of(flown: Flown, frequencies: Array) -> Array:
    """Amplitudes [rad] of δ at `frequencies` (k,) [rad/s], in a flight of whole waves of them."""
    rows = looked_at(flown)
    t, delta = flown.t[rows], flown.delta[rows]
    return np.asarray(2.0 / len(t) * np.abs(np.exp(-1j * np.outer(frequencies, t)) @ delta))
