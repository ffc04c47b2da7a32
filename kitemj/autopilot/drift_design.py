"""Gains that hold a kite which drifts away from the hand that pulls, from its linear system.

Sideways motion about the equilibrium: z = (φ, η, φ̇, η̇, δ, δ̇) less its values there. The hands
answer a wished rate v like δ̈ = κ (v - δ̇), κ = 2 `DAMPING` `ACTUATOR`, which is what
`hands.moved` does below its limits. v = -K (z - z*) minimises ∫ (azimuth/a)² + (δ/δ_max)² +
(v/δ̇_max)² dt: Bryson's rule (Bryson & Ho, Applied Optimal Control, 1975), each in what is much
of it.

What is not measured, the filter of Kalman and Bucy believes: it is told azimuth, heading and how
the lines move, and has two offsets that wander: of the azimuth, which is where the wind comes
from, and of the heading. As many offsets as measurements: no error is left at rest where the
kite is not quite the linear one (Pannocchia & Rawlings, AIChE J. 49 (2003) 426). The air shakes
the kite as a hand would: noise that enters at the stick leaves the loop the margins that it
has without a filter (Doyle & Stein, IEEE Trans. Autom. Control 24 (1979) 607).
"""

from math import radians
from typing import NamedTuple

import numpy as np
from scipy.linalg import expm, solve_continuous_are, solve_discrete_are

from kitemj.dynamics.motion import Motion, air_of
from kitemj.equilibria.linearise import LINEAR, jacobian, linearise, state_units
from kitemj.equilibria.minimal import Minimal
from kitemj.equilibria.trim import trimmed
from kitemj.errors import InputError
from kitemj.flight.live import TICK
from kitemj.physics.compiled import Array
from kitemj.physics.parameters import Parameters
from kitemj.physics.steering import Control
from kitemj.pilots.sight import sight
from kitemj.turning.gains import ACTUATOR, DAMPING
from kitemj.turning.linear_law import in_still_air

SIDEWAYS = [0, 2, 4, 6]
"""Of x = (q, q̇): φ, η and their rates; about a symmetric equilibrium they move alone."""
QUICK = 2 * DAMPING * ACTUATOR
"""1/s; κ, how quickly the hands take up a rate."""
MUCH = radians(3.0)
"""rad; a, an azimuth that is worth full stick."""
SEEN = radians(1.0)
"""rad; noise of angles as a real kite's sensors have it, of each of 50 measurements a second."""
SHAKEN = 0.05
"""rad/√s; the air, as unequal lines would shake the kite."""
WANDERS = radians(0.1), radians(0.1)
"""rad/√s; 1° in 100 s, of the wind's direction, and of the heading."""
LOST = 1e-6
"""Of the largest singular value; below it δ does not move a mode that grows."""


class Sideways(NamedTuple):
    """ẋ = A x + B (δ, δ̇, δ̈), y = C x + D (δ, δ̇, δ̈); y: azimuth, heading [rad], right positive.

    A (4, 4), B (4, 3), C (2, 4), D (2, 3); x = (φ, η, φ̇, η̇) [rad, rad/s] less the equilibrium.
    """

    A: Array
    B: Array
    C: Array
    D: Array


class DriftDesign(NamedTuple):
    """What a hold needs: the gains of hands and filter, and the kite a tick later.

    `K` (6,) [1/s, 1]: wished rate of δ for each of z; `L` (6, 2): of the filter's x and two
    offsets for each measured rad; `later` (6, 6): z a tick later, and `moved` (6,), for each
    rad/s² of δ̈; `azimuth` [1]: where the kite rests for each rad of held δ, `rest` (4,) its x.
    """

    sideways: Sideways
    K: Array
    L: Array
    later: Array
    moved: Array
    azimuth: float
    rest: Array


def sideways(parameters: Parameters, model: str = "lagrange") -> Sideways:
    """The linear system about rest with even lines, in a steady wind; InputError: none there."""
    steady = in_still_air(parameters)
    x0, control = trimmed(steady)
    kite = Minimal(model, steady)
    linear = linearise(kite, x0, control)
    V, ell = steady.wind.speed, control.ell

    def looks(z: Array) -> Array:
        now = Control(*map(float, z[8:]))
        body = kite.answer(z[:8], now).body
        look = sight(Motion(0.0, None, body, now, (), air_of(steady, body, 0.0)))
        return np.array([look.azimuth, look.heading])

    inputs = np.array([ell, V, LINEAR, 1.0, V / ell, LINEAR / ell])
    units = np.array([*state_units(steady, ell), *inputs])
    J, _ = jacobian(looks, np.array([*x0, *control]), units)
    rows = np.ix_(SIDEWAYS, SIDEWAYS)
    return Sideways(linear.A[rows], linear.B[SIDEWAYS, 3:], J[:, SIDEWAYS], J[:, 11:])


def with_hands(kite: Sideways) -> tuple[Array, Array]:
    """ż = F z + G v of kite and hands, (6, 6) and (6,)."""
    F, G = np.zeros((6, 6)), np.zeros(6)
    F[:4, :4], F[:4, 4], F[:4, 5] = kite.A, kite.B[:, 0], kite.B[:, 1] - QUICK * kite.B[:, 2]
    F[4, 5], F[5, 5] = 1.0, -QUICK
    G[:4], G[5] = QUICK * kite.B[:, 2], QUICK
    return F, G


def drift_design(parameters: Parameters, model: str = "lagrange") -> DriftDesign:
    """The gains for a set in its wind.

    Raises InputError where there is no equilibrium, and where the stick cannot stop what grows.
    """
    kite, limits = sideways(parameters, model), parameters.stick
    F, G = with_hands(kite)
    for growing in np.linalg.eigvals(F):
        reached = np.linalg.svd(np.column_stack([F - growing * np.eye(6), G]))[1]
        if growing.real >= 0.0 and reached[-1] < LOST * reached[0]:
            raise InputError(
                f"the stick cannot hold this kite in {parameters.wind.speed:g} m/s: a motion that "
                f"grows by {growing.real:.3g} 1/s is not moved by it; see kitemj stability"
            )
    seen = np.array([*kite.C[0], kite.D[0, 0], 0.0])
    stick = np.array([0.0, 0.0, 0.0, 0.0, 1.0, 0.0])
    weight = np.outer(seen, seen) / MUCH**2 + np.outer(stick, stick) / limits.delta**2
    rate = np.array([[1.0 / limits.delta_dot**2]])
    K = (limits.delta_dot**2 * G) @ solve_continuous_are(F, G[:, None], weight, rate)
    double = np.zeros((7, 7))  # x, δ, δ̇ and δ̈, which a tick holds
    double[:4, :4], double[:4, 4:], double[4, 5], double[5, 6] = kite.A, kite.B, 1.0, 1.0
    step = expm(TICK * double)
    rest: Array = -np.linalg.solve(kite.A, kite.B[:, 0]).astype(float)
    azimuth = float(kite.C[0] @ rest + kite.D[0, 0])
    L = filter_gains(kite, step[:4, :4])
    return DriftDesign(kite, K, L, step[:6, :6], step[:6, 6], azimuth, rest)


def filter_gains(kite: Sideways, later: Array) -> Array:
    """L (6, 2): how x and both offsets are corrected for what is seen otherwise than believed."""
    A, C = np.eye(6), np.hstack([kite.C, np.eye(2)])
    A[:4, :4] = later
    noise, shaken = np.zeros((6, 6)), SHAKEN * kite.B[:, 0]
    # exact over a tick, since the quickest motion of these kites dies within one or two
    integral = np.zeros((8, 8))
    integral[:4, :4], integral[:4, 4:], integral[4:, 4:] = (
        -kite.A,
        np.outer(shaken, shaken),
        kite.A.T,
    )
    both = expm(TICK * integral)
    noise[:4, :4] = both[4:, 4:].T @ both[:4, 4:]
    noise[4, 4], noise[5, 5] = TICK * np.square(WANDERS)
    # of the mean over a tick: a rate of 50/s has so much in each tick of 1/100 s
    seen = np.eye(2) * SEEN**2 * (1 / 50.0) / TICK
    P = solve_discrete_are(A.T, C.T, (noise + noise.T) / 2, seen)
    return np.asarray(P @ C.T @ np.linalg.inv(C @ P @ C.T + seen))
