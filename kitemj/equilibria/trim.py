"""Equilibria of a set in a steady wind with the lines held, by any of the three models.

No guess is asked for. With equal lines the symmetric equilibria come from one scalar
equation (`kitemj.flight.equilibrium`), which finds every one, those with δ ≠ 0 by leading
these there, and those to the side of either by following a curve through them
(`kitemj.equilibria.equilibrium_search`). The model then solves q̈(q, 0) = 0 itself.
"""

from math import degrees, isfinite
from typing import NamedTuple

import numpy as np

from kitemj.dynamics.lagrange_kite import motion_at
from kitemj.dynamics.motion import State, air_of
from kitemj.equilibria.equilibrium_search import beside
from kitemj.equilibria.minimal import Array, Minimal, held, seen, state_of
from kitemj.equilibria.scaled import residual
from kitemj.errors import InputError
from kitemj.flight.equilibrium import check_steady, no_equilibrium, symmetric_equilibria
from kitemj.flight.limits import GROUND, VALIDITY, departure_at
from kitemj.physics.frames import Angles
from kitemj.physics.parameters import Parameters
from kitemj.physics.steering import Control, Programme, Segment, Sines, control, rest_ell

SAME = 1e-6
"""rad; two equilibria closer than this are one."""
RESIDUAL = 1e-10
"""Largest left-over of the scaled equations in what counts as an equilibrium."""
DIFFERENCE = 1e-4
"""rad; of the Jacobian in Newton's iterations."""
STEPS = 20
"""Steps from δ = 0 to the asked δ."""


class Trim(NamedTuple):
    """One equilibrium, by one model.

    `q`, `alpha`, `beta` [rad]; `elevation`, `azimuth` [rad] of G seen from O_E, the azimuth
    positive to the pilot's left; `height` of G [m]; `tensions` [N]; `residual`: what is left
    over of the scaled equations (`kitemj.equilibria.scaled`); `ell` [m], `delta` [rad] as held.
    """

    model: str
    q: Angles
    alpha: float
    beta: float
    elevation: float
    azimuth: float
    height: float
    tensions: tuple[float, ...]
    residual: float
    ell: float
    delta: float

    @property
    def in_words(self) -> str:
        """Where it stands, for people."""
        return f"at elevation {degrees(self.elevation):.1f}°, {self.height:.3g} m high"

    @property
    def state(self) -> State:
        """The equilibrium as a start."""
        return State(self.q, Angles(0.0, 0.0, 0.0, 0.0))

    @property
    def control(self) -> Control:
        """The lines, held."""
        return held(self.ell, self.delta)


def equilibria(
    parameters: Parameters,
    ell: float | None = None,
    delta: float = 0.0,
    model: str = "lagrange",
    source: str = "parameters",
) -> list[Trim]:
    """Every equilibrium within the limits of validity, symmetric ones first, by ascending α.

    `ell` [m] (None: ℓ₀, both lines `lines.length` long) and `delta` [rad] are held. Raises
    InputError, with one sentence that names `source`, where there is none, for a wind with
    gusts or of 0 m/s, and for an unknown model.
    """
    ell = _rest_ell(parameters) if ell is None else ell
    check_steady(parameters, source)
    if abs(delta) >= 1.5:
        raise InputError(f"delta must be within +-1.5 rad, got {delta} rad ({source})")
    kite = Minimal(model, parameters)
    straight, lines = _symmetric(parameters, ell), held(ell, delta)
    if delta != 0.0:
        straight = [q for q in (_steered(parameters, ell, delta, q) for q in straight) if q.size]
    further = [q for known in straight for q in beside(parameters, lines, known)]
    found: list[Trim] = []
    fault = ""
    for q in [*straight, *further]:
        trim = solved(kite, q, lines)
        if trim is None or any(_same(trim, other) for other in found):
            continue
        if reason := unphysical(parameters, trim.state, lines):
            elevation, alpha = degrees(trim.elevation), degrees(trim.alpha)
            where = f"at elevation {elevation:.2f} deg, alpha {alpha:.2f} deg"
            fault = fault or f"{where}, {reason}"
        else:
            found.append(trim)
    if found:
        return found
    if delta == 0.0 and not straight:
        raise no_equilibrium(parameters, ell, source)
    if fault:
        raise InputError(f"there is no physical equilibrium ({source}): {fault}")
    if delta == 0.0:
        raise InputError(
            f"the model {model} does not come to rest at the equilibrium within {RESIDUAL:g} of "
            f"the weight ({source}); ask another model"
        )
    raise InputError(
        f"no equilibrium was found with delta = {delta:g} rad in a wind of "
        f"{parameters.wind.speed:g} m/s ({source}); hold a smaller delta"
    )


def lines_held(parameters: Parameters, programme: Programme) -> tuple[float | None, float]:
    """(ℓ [m], δ [rad]) about which `programme` swings; of other programmes, those at t = 0.

    ℓ is None where it is ℓ₀, so that it follows `lines.length` when that is varied.
    """
    c = control(programme, 0.0)
    ell, delta = (programme[:2]) if isinstance(programme, Sines) else (c.ell, c.delta)
    return (None if ell == _rest_ell(parameters) else float(ell)), float(delta)


def trimmed(
    parameters: Parameters, ell: float | None = None, delta: float = 0.0, source: str = "parameters"
) -> tuple[Array, Control]:
    """x (8,) = (q, 0) of the equilibrium of least α, which stability is asked about; the lines.

    Fast: with δ = 0 from the scalar equation alone, else led from there to δ. Raises
    InputError where there is none.
    """
    ell = _rest_ell(parameters) if ell is None else ell
    check_steady(parameters, source)
    found, lines = _symmetric(parameters, ell), held(ell, delta)
    if not found:
        raise no_equilibrium(parameters, ell, source)
    q = found[0]
    if delta != 0.0:
        q = _steered(parameters, ell, delta, q)
        if not q.size:
            raise InputError(
                f"the equilibrium is lost before delta = {delta:g} rad is reached ({source}); "
                f"hold a smaller delta"
            )
    x = np.concatenate((q, np.zeros(4)))
    reason = unphysical(parameters, state_of(x), lines)
    if reason:
        raise InputError(f"there is no physical equilibrium ({source}): {reason}")
    return x, lines


def solved(kite: Minimal, start: Array, control: Control) -> Trim | None:
    """The model's own equilibrium next to `start` (4,) [rad], by Newton's method.

    None where it does not reach `RESIDUAL`, or is not finite.
    """

    def q_ddot(q: Array) -> Array:
        return kite.answer(np.concatenate((q, np.zeros(4))), control).x_dot[4:]

    q = best = start
    least = np.inf
    for _ in range(8):
        f = q_ddot(q)
        size = float(np.abs(f).max())
        if not size < least:
            break
        best, least = q, size
        steps = DIFFERENCE * np.eye(4)
        J = np.column_stack([(q_ddot(q + e) - q_ddot(q - e)) / (2 * DIFFERENCE) for e in steps])
        if not np.isfinite(J).all() or np.linalg.matrix_rank(J) < 4:
            break
        q = q - np.linalg.solve(J, f)
    trim = trim_at(kite, best, control)
    known = np.isfinite([*trim.q, *trim[2:7], *trim.tensions]).all()
    return trim if known and trim.residual <= RESIDUAL else None


def trim_at(kite: Minimal, q: Array, control: Control) -> Trim:
    """The angles, tensions and limits of the equilibrium at `q` (4,) [rad]."""
    x = np.concatenate((q, np.zeros(4)))
    answer = kite.answer(x, control)
    p, air = answer.body.p_G_E, air_of(kite.parameters, answer.body, 0.0)
    angles = (Angles(*map(float, q)), air.alpha, air.beta, *seen(p))
    left_over = residual(kite.parameters, x, answer.x_dot, control)
    return Trim(kite.name, *angles, -p.z, answer.tensions, left_over, control.ell, control.delta)


def unphysical(parameters: Parameters, state: State, control: Control) -> str:
    """The reason why no kite can be at rest at `state` with the lines held; empty: it can."""
    motion = motion_at(parameters, Segment(0.0, control), 0.0, state)
    departure = departure_at(parameters, motion, (*VALIDITY, GROUND))
    return f"{departure.limit.sentence} ({departure.reading})" if departure else ""


def _rest_ell(parameters: Parameters) -> float:
    return rest_ell(parameters.lines.length, parameters.kite.y_A)


def _symmetric(parameters: Parameters, ell: float) -> list[Array]:
    """q (4,) [rad] of the symmetric equilibria, by ascending α."""
    azimuth, found = parameters.wind.azimuth, symmetric_equilibria(parameters, ell)
    return [np.array([azimuth, each.gamma, 0.0, each.theta]) for each in found]


def _steered(parameters: Parameters, ell: float, delta: float, q: Array) -> Array:
    """The equilibrium `q` (4,) at δ = 0 led to `delta` [rad]; empty where it is lost."""
    kite = Minimal("lagrange", parameters)
    for part in np.linspace(0.0, 1.0, STEPS + 1)[1:]:
        trim = solved(kite, q, held(ell, float(part) * delta))
        if trim is None or not all(map(isfinite, trim.q)):
            return np.empty(0)
        q = np.array(trim.q)
    return q


def _same(a: Trim, b: Trim) -> bool:
    turn = (np.subtract(a.q, b.q) + np.pi) % (2 * np.pi) - np.pi
    return bool(np.abs(turn).max() < SAME)
