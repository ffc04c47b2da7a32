"""The law of turning that the linear system about rest has, for a given band of frequencies.

χ̇ = g δ(t - T) + (c₂/V) cos β ψ is fitted to how the nose answers δ in the linear system: in
the frequency domain, at the frequencies of a test signal and weighted by its amplitudes. By
Parseval's theorem that is what least squares find in a small and steady swing about rest.
"""

from typing import NamedTuple

import numpy as np
from scipy.optimize import least_squares

from kitemj.dynamics.motion import Motion, air_of
from kitemj.equilibria.linearise import LINEAR, jacobian, linearise, state_units
from kitemj.equilibria.minimal import Minimal, seen
from kitemj.equilibria.trim import trimmed
from kitemj.flight.pilot_settings import TurnRateLaw
from kitemj.physics.compiled import Array
from kitemj.physics.parameters import Parameters
from kitemj.physics.steering import Control
from kitemj.physics.wind import Wind
from kitemj.pilots.sight import sight

NONE = 1e-7
"""s; a delay at its bound, which the search only comes near."""
DELAYS = np.linspace(0.0, 1.5, 31)
"""s; with the best of which a fit begins."""


class LinearLaw(NamedTuple):
    """What the linear system about rest says; `growth` [1/s] of its least stable mode.

    `explained`: the share of the turn rate's variance, for the signal it was fitted to.
    """

    law: TurnRateLaw
    explained: float
    growth: float


def in_still_air(parameters: Parameters) -> Parameters:
    """The same set in a wind of the same speed everywhere and always, from ahead."""
    return parameters._replace(wind=Wind(parameters.wind.speed))


def linear_law(
    parameters: Parameters,
    frequencies: Array,
    amplitudes: Array,
    model: str = "lagrange",
    source: str = "parameters",
) -> LinearLaw:
    """The law at rest of a signal with `amplitudes` (k,) [rad] at `frequencies` (k,) [rad/s].

    Raises InputError, which names `source`, where there is no equilibrium.
    """
    parameters = in_still_air(parameters)
    x0, control = trimmed(parameters, None, 0.0, source)
    kite, V = Minimal(model, parameters), parameters.wind.speed
    elevation, _ = seen(kite.answer(x0, control).body.p_G_E)
    A, turning, heading = answers(kite, x0, control, frequencies)
    slope = np.cos(elevation) / V * heading

    def parts(delay: float) -> tuple[Array, Array]:
        """Both terms for g = c₂ = 1, and what they are to be; real parts, then imaginary."""
        terms = np.column_stack((np.exp(-1j * frequencies * delay), slope))
        columns = np.column_stack((terms, turning)) * amplitudes[:, None]
        both = np.vstack((columns.real, columns.imag))
        return both[:, :2], both[:, 2]

    def left(delay: float) -> Array:
        terms, wish = parts(delay)
        return np.asarray(terms @ np.linalg.lstsq(terms, wish)[0] - wish)

    best = min(DELAYS, key=lambda delay: float(np.sum(left(delay) ** 2)))

    def left_at(z: Array) -> Array:
        return left(float(z[0]))

    found = float(least_squares(left_at, [best], bounds=(0.0, np.inf)).x[0])
    delay = found if found > NONE else 0.0
    terms, wish = parts(delay)
    gain, c2 = map(float, np.linalg.lstsq(terms, wish)[0])
    explained = 1.0 - float(np.sum(left(delay) ** 2) / np.sum(wish**2))
    law = TurnRateLaw(gain / V, c2, 1.0, V, delay * V)
    return LinearLaw(law, explained, float(np.linalg.eigvals(A).real.max()))


def answers(
    kite: Minimal, x0: Array, control: Control, frequencies: Array
) -> tuple[Array, Array, Array]:
    """A (8, 8); how turn rate [1/s] and heading [1] answer δ at each of `frequencies` [rad/s]."""
    linear = linearise(kite, x0, control)
    V, ell = kite.parameters.wind.speed, control.ell

    def looks(z: Array) -> Array:
        now = Control(*map(float, z[8:]))
        body = kite.answer(z[:8], now).body
        look = sight(Motion(0.0, None, body, now, (), air_of(kite.parameters, body, 0.0)))
        return np.array([look.turning, look.heading])

    units = np.array([ell, V, LINEAR, 1.0, V / ell, LINEAR / ell])
    C, _ = jacobian(
        looks,
        np.array([*x0, *control]),
        np.array([*state_units(kite.parameters, ell), *units]),
    )
    found = []
    for omega in frequencies:
        powers = np.array([1.0, 1j * omega, -(omega**2)])  # δ, δ̇ and δ̈ of one swing
        x = np.linalg.solve(1j * omega * np.eye(8) - linear.A, linear.B[:, 3:] @ powers)
        found.append(C[:, :8] @ x + C[:, 11:] @ powers)
    turning, heading = np.array(found).T
    return linear.A, turning, heading
