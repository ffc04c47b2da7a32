"""Classical margins of the loop opened at the stick, frozen at a tick of a lap."""

from importlib import import_module
from types import ModuleType
from typing import NamedTuple

import numpy as np

from kitemj.errors import InputError
from kitemj.flight.live import TICK
from kitemj.physics.compiled import Array

FREQUENCIES = 2000
"""From the slowest that is looked at to that of Nyquist, evenly in its logarithm."""
SLOWEST = 0.05
"""rad/s; nothing that a loop of some seconds does is slower."""


class Margins(NamedTuple):
    """Of L = y/u, which is to be closed by u = -y, a factor on the loop in dB, deg and s.

    `gain_up`, `gain_down`: by how much the gain may grow and shrink, the least of all crossings;
    `phase`, the least; `delay`, the least; `crossover` [rad/s], the highest frequency with |L| = 1.
    `disk`: the diameter of the balanced disk (Seiler, Packard & Gahinet, IEEE Control Systems 40
    (2020) 78), with gain and phase changed together. inf: no crossing. `growth` [1/s]: of the
    quickest growing mode of the frozen closed loop; below 0 none grows, and above 0 the
    other numbers do not say that it is stable.
    """

    gain_up: float
    gain_down: float
    phase: float
    delay: float
    crossover: float
    disk: float
    disk_gain: float
    disk_phase: float
    growth: float


def python_control() -> ModuleType:
    """The package `control`. Raises InputError where it is not installed."""
    try:
        return import_module("control")
    except ImportError:
        raise InputError(
            "margins need the package python-control: install it with pip install kitemj[margins]"
        ) from None


def margins_of(
    A: Array, B: Array, C: Array, tick: float = TICK, slowest: float = SLOWEST
) -> Margins:
    """The margins of x' = A x + B u, y = C x, sampled each `tick` [s]; closed by u = -y.

    A (m, m), B (m,), C (m,). Crossings from `slowest` [rad/s] on are looked at.
    """
    control = python_control()
    omega = np.geomspace(slowest, 0.999 * np.pi / tick, FREQUENCIES)
    system = control.ss(A, B[:, None], C[None, :], 0.0, tick)
    loop = control.frd(response(A, B, C, omega, tick), omega)
    gains, phases, _, _, at_one, _ = control.stability_margins(loop, returnall=True)
    gains = gains[np.isfinite(gains) & (gains > 0.0)]
    decibels = 20.0 * np.log10(gains)
    turned = np.radians(np.where(phases < 0.0, phases + 360.0, phases))
    disk, disk_gain, disk_phase = control.disk_margins(system, omega)
    closed = np.linalg.eigvals(A - B[:, None] * C[None, :])
    return Margins(
        _least(decibels[decibels > 0.0]),
        _least(-decibels[decibels < 0.0]),
        _least(abs(phases)),
        _least(turned / at_one),
        float(max(at_one, default=np.nan)),
        float(disk),
        float(disk_gain),
        float(disk_phase),
        float(np.log(max(abs(closed))) / tick),
    )


def response(A: Array, B: Array, C: Array, omega: Array, tick: float = TICK) -> Array:
    """L(e^{jω tick}) at `omega` (n,) [rad/s], complex."""
    eye, z = np.eye(len(A)), np.exp(1j * omega * tick)
    solved = np.linalg.solve(z[:, None, None] * eye - A, np.tile(B[:, None], (len(z), 1, 1)))
    return np.asarray((C @ solved)[:, 0])


def _least(values: Array) -> float:
    return float(min(values, default=np.inf))
