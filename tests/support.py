"""Kites, steering and random states that several test rooms share; every run the same."""

from math import radians
from typing import NamedTuple

import numpy as np

from kitemj.dynamics.motion import Motion, State
from kitemj.flight.equilibrium import equilibrium_state
from kitemj.physics.frames import Angles
from kitemj.physics.parameter_files import parameter_set
from kitemj.physics.parameters import Parameters
from kitemj.physics.steering import Control, Segment, Sines, rest_ell
from kitemj.physics.wind import Wind

STILL = Angles(0.0, 0.0, 0.0, 0.0)

LAKSA = parameter_set("laksa")
THESIS = parameter_set("thesis")

# A small sport kite, its inertia made up: light, quick, and with I_xz.
SPORT = LAKSA._replace(
    kite=LAKSA.kite._replace(
        mass=0.22,
        inertia_x=0.05,
        inertia_y=0.01,
        inertia_z=0.05,
        inertia_xz=0.004,
        chord=0.353,
        span=1.7,
        area=0.6,
        x_A=0.1,
        y_A=0.3,
        z_A=0.3,
    ),
    aero=LAKSA.aero._replace(Cn_beta=0.5, Cy_beta=-3.0),
    lines=LAKSA.lines._replace(length=20.0),
    wind=Wind(6.0),
)

# Shear, gusts and a wind from aside: every term of the shared formulas is at work.
WEATHER = Wind(6.0, exponent=0.14, gust_amplitude=0.1, gust_frequency=0.6, azimuth=0.3)
KITES = {
    "laksa": LAKSA._replace(wind=WEATHER, kite=LAKSA.kite._replace(inertia_xz=1.0)),
    "thesis": THESIS._replace(wind=WEATHER),
    "sport": SPORT._replace(wind=WEATHER),
}


class Case(NamedTuple):
    """A kite somewhere, moving, its lines moving and speeding up."""

    parameters: Parameters
    state: State
    segment: Segment


def rest(parameters: Parameters) -> float:
    """ℓ₀ [m]."""
    return rest_ell(parameters.lines.length, parameters.kite.y_A)


def aloft(parameters: Parameters, phi: float = 0.0) -> State:
    """At the equilibrium, turned aside by `phi` [rad]."""
    q = equilibrium_state(parameters).q
    return State(q._replace(phi=q.phi + phi), STILL)


def pulling(motion: Motion, *tensions: float) -> Motion:
    """The motion with other pulls [N] in its lines."""
    pairs = zip(motion.lines, tensions, strict=True)
    lines = [line._replace(tension_ground=pull, tension_kite=pull) for line, pull in pairs]
    return motion._replace(lines=tuple(lines))


def random_cases(n: int, seed: int = 7) -> list[Case]:
    """`n` cases, the kites in turn; none of ℓ̇, ℓ̈, δ̇, δ̈ is zero; γ keeps 15° off ±90°."""
    r = np.random.default_rng(seed)
    kites = list(KITES.values())
    cases = []
    for i in range(n):
        parameters = kites[i % len(kites)]
        q = Angles(*map(float, r.uniform((-3.1, -0.5, -1.0, -1.5), (3.1, 1.3, 1.0, 1.5))))
        q_dot = Angles(*map(float, r.uniform((-0.3, -0.3, -1.0, -1.0), (0.3, 0.3, 1.0, 1.0))))
        ell, *rates = map(
            float, r.uniform((0.8, -2.0, -3.0, -0.5, -0.5, -2.0), (1.2, 2.0, 3.0, 0.5, 0.5, 2.0))
        )
        segment = Segment(0.0, Control(ell * rest(parameters), *rates))
        cases.append(Case(parameters, State(q, q_dot), segment))
    return cases


# The case of LAKSA's table: 8° at 0.1 rad/s, from rest, on lines that move at once.
LAKSA_STEERING = Sines(rest(LAKSA), delta_amplitude=radians(8.0), delta_frequency=0.1)
