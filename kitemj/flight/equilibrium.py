"""Where the kite hangs still in a steady wind, from one scalar equation.

With equal lines and the wind from ahead everything happens in the plane of symmetry. The
lines meet at O_E and pass their pull on at the attachments, so only the moment of weight
and air about the attachments decides the angle of attack; the lines then point along the
sum of the forces.

Source: Sánchez-Arriaga et al., Applied Mathematical Modelling 47 (2017), section 4; no
dynamics code is needed, so the models can be held against it.
"""

from math import atan2, cos, degrees, hypot, pi, sin
from typing import NamedTuple

import numpy as np
from scipy.optimize import brentq, minimize_scalar

from kitemj.dynamics.motion import State
from kitemj.errors import InputError
from kitemj.physics.aerodynamics import coefficients
from kitemj.physics.compiled import Array, compiled
from kitemj.physics.frames import Angles
from kitemj.physics.parameters import Parameters
from kitemj.physics.steering import rest_ell
from kitemj.physics.vectors import Vector
from kitemj.physics.wind import Wind, wind_velocity

GRID = np.radians(np.linspace(-90.0, 90.0, 1801))
"""rad; angles of attack between which balances are looked for, 0.1° apart."""

STRONGEST = 50.0
"""m/s; no kite is asked whether it would fly in more."""

PLACE_ITERATIONS = 100
"""Of the wind where the kite is; in shear each takes the error down to a seventh or less."""

PROBES = 17
"""Places, up to a line's length high and far, at which a wind of another law is looked at."""
PROBE_TIME = 1.7
"""s; no gust worth its name is back where it was after it, at all of the places."""
CALM = 1e-9
"""m/s; rounding of a wind's sines and cosines, no more."""


class Equilibrium(NamedTuple):
    """Angle of attack, γ and θ [rad]; the tension [N] of each line."""

    alpha: float
    gamma: float
    theta: float
    tension: float


class Balance(NamedTuple):
    """Moment of weight and air about the attachments [N m] and their sum [N, E]; wind [m/s]."""

    moment: float
    force_x: float
    force_z: float
    wind: float


@compiled
def _balance_in(parameters: Parameters, alpha: float, V: float) -> Balance:
    """The balance at `alpha` [rad] in a wind of `V` [m/s] at the kite."""
    kite = parameters.kite
    C = coefficients(parameters.aero, kite, alpha, 0.0, Vector(0.0, 0.0, 0.0), V)
    qS = 0.5 * parameters.environment.air_density * V * V * kite.area
    X, Z = qS * C.x, qS * C.z
    weight = kite.mass * parameters.environment.gravity
    # the wind is horizontal, so the pitch angle is α; G sits at -(X_A, 0, Z_A) from A±
    X_all, Z_all = X - weight * sin(alpha), Z + weight * cos(alpha)
    moment = qS * kite.chord * C.m - kite.z_A * X_all + kite.x_A * Z_all
    F_x = X * cos(alpha) + Z * sin(alpha)
    F_z = -X * sin(alpha) + Z * cos(alpha) + weight
    return Balance(moment, F_x, F_z, V)


@compiled
def balance(parameters: Parameters, ell: float, alpha: float) -> Balance:
    """The balance at `alpha` [rad] with the attachments' midpoint `ell` [m] from O_E.

    The wind blows along -x_E. Where it is not the same everywhere, the kite's place follows
    from the direction of the lines, and that from the wind.
    """
    kite, wind = parameters.kite, parameters.wind
    found = _balance_in(parameters, alpha, wind.speed)
    for _ in range(PLACE_ITERATIONS):
        gamma = atan2(-found.force_x, -found.force_z)
        theta = alpha - gamma
        ahead = kite.x_A * cos(theta) + kite.z_A * sin(theta)
        above = ell - kite.x_A * sin(theta) + kite.z_A * cos(theta)
        x = -above * sin(gamma) - ahead * cos(gamma)
        height = above * cos(gamma) - ahead * sin(gamma)
        V = -wind_velocity(wind, Vector(x, 0.0, -height), 0.0).x
        change = abs(V - found.wind)
        if change == 0.0:
            break
        found = _balance_in(parameters, alpha, V)
        if change <= 1e-15 * V:
            break
    return found


@compiled
def _moments(parameters: Parameters, ell: float, angles: Array) -> Array:
    """The moment [N m] at each of `angles` [rad]."""
    moments = np.empty(len(angles))
    for i in range(len(angles)):
        moments[i] = balance(parameters, ell, angles[i]).moment
    return moments


def balanced_angles(parameters: Parameters, ell: float) -> list[float]:
    """Every α [rad] in (-90°, 90°), ascending, at which the moments balance.

    Sign changes on a grid, and pairs of roots between two grid points, which show as an
    extremum that comes close to zero.
    """

    def moment(alpha: float) -> float:
        return float(balance(parameters, ell, alpha).moment)

    m = _moments(parameters, ell, GRID)
    brackets = [(GRID[i], GRID[i + 1]) for i in np.flatnonzero(m[:-1] * m[1:] < 0)]
    size, slope = np.abs(m), np.diff(m)
    dips = np.flatnonzero(
        (slope[:-1] * slope[1:] < 0)
        & (size[1:-1] < np.minimum(size[:-2], size[2:]))
        & (m[:-2] * m[1:-1] > 0)
        & (m[1:-1] * m[2:] > 0)
    )
    for i in dips:
        low, high, side = float(GRID[i]), float(GRID[i + 2]), float(np.sign(m[i + 1]))
        bottom = minimize_scalar(
            lambda alpha, side=side: side * moment(alpha), bounds=(low, high), method="bounded"
        )
        if bottom.fun < 0:
            brackets += [(low, float(bottom.x)), (float(bottom.x), high)]
    roots = [float(brentq(moment, low, high, xtol=1e-15)) for low, high in brackets]
    return sorted(roots + [float(alpha) for alpha in GRID[m == 0.0]])


def hanging(parameters: Parameters, ell: float, alpha: float) -> Equilibrium:
    """γ, θ and tension at a balanced `alpha` [rad]: lines point along the sum of all forces.

    The tension is negative, and |γ| < 90°, where that sum points down: the lines would push.
    """
    found = balance(parameters, ell, alpha)
    side = -1.0 if found.force_z > 0 else 1.0
    gamma = atan2(-side * found.force_x, -side * found.force_z)
    share = ell / hypot(ell, parameters.kite.y_A)  # cosine between a line and their middle
    pull = side * hypot(found.force_x, found.force_z) / (2 * share)
    return Equilibrium(alpha, gamma, alpha - gamma, pull)


def symmetric_equilibria(parameters: Parameters, ell: float) -> list[Equilibrium]:
    """All with 0 < α < α_stall and pulling lines, by ascending α; `ell` in m, δ = 0."""
    parameters = _from_ahead(parameters)
    found = [hanging(parameters, ell, alpha) for alpha in balanced_angles(parameters, ell)]
    stall = parameters.limits.alpha_stall
    return [e for e in found if 0 < e.alpha < stall and e.tension > 0 and abs(e.gamma) < pi / 2]


def _from_ahead(parameters: Parameters) -> Parameters:
    """The same with the wind not turned."""
    return parameters._replace(wind=parameters.wind._replace(azimuth=0.0))


def check_steady(parameters: Parameters, source: str) -> None:
    """Raises InputError for a wind in which nothing can stand still, or not facing it."""
    wind = parameters.wind
    if not isinstance(wind, Wind):
        _check_probes(parameters, source)
    elif wind.gust_amplitude != 0.0:
        raise InputError(
            f"wind.gust_amplitude must be 0 for an equilibrium, got {wind.gust_amplitude:g} "
            f"({source}, [wind]); leave the gusts out"
        )
    if wind.speed <= 0.0 or parameters.environment.air_density <= 0.0:
        raise InputError(
            f"an equilibrium needs wind.speed > 0 m/s and environment.air_density > 0 kg/m3, "
            f"got {wind.speed:g} m/s and {parameters.environment.air_density:g} kg/m3 ({source})"
        )


def _check_probes(parameters: Parameters, source: str) -> None:
    """Asks a wind of another law, before the pilot, whether it keeps its time and direction."""
    wind = _from_ahead(parameters).wind
    for part in np.linspace(0.0, 1.0, PROBES):
        p_E = Vector(-part * parameters.lines.length, 0.0, -part * parameters.lines.length)
        v, later = (wind_velocity(wind, p_E, t) for t in (0.0, PROBE_TIME))
        if max(abs(v.y), abs(v.z), *(abs(a - b) for a, b in zip(v, later, strict=True))) > CALM:
            raise InputError(
                f"an equilibrium needs a wind that is steady and blows along its azimuth, this "
                f"{type(wind).__name__} does not {-p_E.z:g} m above ground ({source}, [wind])"
            )


def no_equilibrium(parameters: Parameters, ell: float, source: str) -> InputError:
    """The error that says why `symmetric_equilibria` is empty."""
    parameters = _from_ahead(parameters)
    wind, weight = parameters.wind, parameters.kite.mass * parameters.environment.gravity
    stall = degrees(parameters.limits.alpha_stall)
    found = [hanging(parameters, ell, alpha) for alpha in balanced_angles(parameters, ell)]
    inside = [e for e in found if 0 < degrees(e.alpha) < stall]
    if inside:
        alpha = inside[0].alpha
        lift = weight - balance(parameters, ell, alpha).force_z
        why = (
            f"at alpha = {degrees(alpha):.2f} deg, where the moments balance, the air lifts "
            f"{lift:.1f} N and the kite weighs {weight:.1f} N, so that the lines would have to push"
        )
    elif found:
        others = ", ".join(f"{degrees(e.alpha):.1f}" for e in found)
        why = f"the moments about the attachments balance only at alpha = {others} deg"
    else:
        why = "the moments about the attachments balance at no alpha within +-90 deg"
    least = least_wind(parameters, ell)
    cure = (
        f"it takes a wind of {least:.3g} m/s or more"
        if least
        else f"no stronger wind up to {STRONGEST:g} m/s helps: change the bridle (kite.x_A, z_A) "
        f"or the aerodynamics"
    )
    return InputError(
        f"there is no equilibrium with 0 < alpha < alpha_stall = {stall:g} deg in a wind of "
        f"{wind.speed:g} m/s ({source}): {why}; {cure}"
    )


def least_wind(parameters: Parameters, ell: float) -> float | None:
    """The least wind.speed [m/s], above the present one, with an equilibrium; None: none.

    Of the steps of 2 % that are tried up to STRONGEST, refined to 0.1 %, rounded up.
    """

    def stands(speed: float) -> bool:
        wind = parameters.wind._replace(speed=speed)
        return bool(symmetric_equilibria(parameters._replace(wind=wind), ell))

    low = max(parameters.wind.speed, 0.1)
    while low < STRONGEST and not stands(1.02 * low):
        low *= 1.02
    if low >= STRONGEST:
        return None
    high = 1.02 * low
    while high > 1.001 * low:
        middle = 0.5 * (low + high)
        low, high = (low, middle) if stands(middle) else (middle, high)
    return 1.004 * high


def equilibrium(parameters: Parameters, source: str = "parameters") -> Equilibrium:
    """The equilibrium of least α with 0 < α < α_stall and both lines pulling, at ℓ₀, δ = 0.

    The wind is `parameters.wind.speed` everywhere: gusts, shear and azimuth are left out.
    Raises InputError where there is none.
    """
    still, ell = _still(parameters)
    found = symmetric_equilibria(still, ell)
    if not found:
        raise no_equilibrium(still, ell, source)
    return found[0]


def pull_at_rest(parameters: Parameters) -> float | None:
    """The tension [N] of each line in `equilibrium`; None where there is none, at once."""
    found = symmetric_equilibria(*_still(parameters))
    return found[0].tension if found else None


def _still(parameters: Parameters) -> tuple[Parameters, float]:
    """The set in a wind that is the same everywhere, and ℓ₀ [m]."""
    still = parameters._replace(wind=Wind(parameters.wind.speed))
    return still, rest_ell(parameters.lines.length, parameters.kite.y_A)


def equilibrium_state(parameters: Parameters, source: str = "parameters") -> State:
    """The equilibrium as a start: facing the wind, at rest."""
    found = equilibrium(parameters, source)
    q = Angles(parameters.wind.azimuth, found.gamma, 0.0, found.theta)
    return State(q, Angles(0.0, 0.0, 0.0, 0.0))
