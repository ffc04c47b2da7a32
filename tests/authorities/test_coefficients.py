"""Coefficients of the air: an airplane's published derivatives, LAKSA's forces, sums by hand."""

import csv
from pathlib import Path

import numpy as np
import pytest

from kitemj.physics.aerodynamics import TableAero, coefficients
from kitemj.physics.loads import aerodynamic_wrench, air
from kitemj.physics.parameters import Environment
from kitemj.physics.vectors import Rotation, Vector, rotated, unrotated
from kitemj.physics.wind import Wind
from tests.support import LAKSA

LEVEL = Rotation(Vector(1.0, 0.0, 0.0), Vector(0.0, 1.0, 0.0), Vector(0.0, 0.0, 1.0))
ORIGIN = NONE = Vector(0.0, 0.0, 0.0)

# The North American Navion at sea level, in feet, slugs and pounds, which are as coherent as SI.
# Coefficients and sizes: Nelson, Flight Stability and Automatic Control, appendix B.
U = 176.0
MASS, I_X, I_Y, I_Z = 2750 / 32.2, 1048.0, 3000.0, 3530.0
NAVION = LAKSA._replace(
    kite=LAKSA.kite._replace(span=33.4, chord=5.7, area=184.0),
    environment=Environment(32.2, 0.002378),
    wind=Wind(0.0),
)
TERMS = {  # of [1 β p̂ q̂ r̂ s₁ s₂ s₃], and of α
    "y": {"beta": -0.564},
    "z": {"alpha": -(4.44 + 0.05)},
    "l": {"beta": -0.074, "p": -0.410, "r": 0.107},
    "m": {"alpha": -0.683, "q": -9.96},
    "n": {"beta": 0.071, "p": -0.0575, "r": -0.125},
}
DIMENSIONAL = {
    ("y", "beta"): -0.2543 * U * MASS,
    ("z", "alpha"): -2.0244 * U * MASS,
    ("l", "beta"): -15.982 * I_X,
    ("l", "p"): -8.402 * I_X,
    ("l", "r"): 2.193 * I_X,
    ("m", "alpha"): -0.05 * U * I_Y,
    ("m", "q"): -2.0767 * I_Y,
    ("n", "beta"): 4.495 * I_Z,
    ("n", "p"): -0.3498 * I_Z,
    ("n", "r"): -0.7605 * I_Z,
}
"""Forces [lb] and moments [ft lb] per rad or rad/s: LaRCsim (NASA), navion_aero.c."""
PRINTED = 0.015
"""Relative: the coefficients are printed with two digits or three."""
AXES = "xyzlmn"


def table_of(terms: dict[str, dict[str, float]]) -> TableAero:
    table = np.zeros((6, 8, 3))
    for axis, values in terms.items():
        for name, value in values.items():
            place = (0, 1) if name == "alpha" else (["", "beta", "p", "q", "r"].index(name), 0)
            table[(AXES.index(axis), *place)] = value
    return TableAero(tuple(tuple(tuple(row) for row in rows) for rows in table.tolist()))


def test_a_table_has_the_dimensional_derivatives_of_a_published_airplane():
    """Every rate by the airspeed's double, roll and yaw by the span, pitch by the chord."""
    navion = NAVION._replace(aero=table_of(TERMS))
    small = 1e-3  # rad, rad/s
    moves = {
        "beta": (Vector(U * np.cos(small), U * np.sin(small), 0.0), NONE),
        "alpha": (Vector(U * np.cos(small), 0.0, U * np.sin(small)), NONE),
        "p": (Vector(U, 0.0, 0.0), Vector(small, 0.0, 0.0)),
        "q": (Vector(U, 0.0, 0.0), Vector(0.0, small, 0.0)),
        "r": (Vector(U, 0.0, 0.0), Vector(0.0, 0.0, small)),
    }
    for (axis, name), expected in DIMENSIONAL.items():
        v, omega = moves[name]
        wrench = aerodynamic_wrench(navion, ORIGIN, LEVEL, v, omega, 0.0)
        found = (*wrench.force, *wrench.moment)[AXES.index(axis)] / small
        assert found == pytest.approx(expected, rel=PRINTED), (axis, name)


def test_every_number_of_a_table_is_at_its_place():
    """Span 4 m, chord 1 m, 5 m/s, rates of 1, 2, 3 rad/s: p̂ = 0.4, q̂ = 0.2, r̂ = 1.2."""
    table = np.arange(1.0, 145.0).reshape(6, 8, 3)  # each number is there once
    rows = tuple(tuple(tuple(row) for row in rows) for rows in table.tolist())
    size = LAKSA.kite._replace(span=4.0, chord=1.0)
    aero = TableAero(rows, (0.1, 0.3, -0.2))
    found = coefficients(aero, size, 0.5, -0.25, Vector(1.0, 2.0, 3.0), 5.0)
    terms, powers = (1.0, -0.25, 0.4, 0.2, 1.2, 0.1, 0.3, -0.2), (1.0, 0.5, 0.25)
    assert found == pytest.approx(np.einsum("ijk,j,k->i", table, terms, powers), rel=1e-14)


FORCE = 1e-6
"""N and N m, of hundreds: LAKSA's ten digits of the pose."""


def test_forces_and_moments_of_laksa_s_four_line_kite():
    """Whose lines differ, and whose air is the linear law, with other numbers for it."""
    aero = LAKSA.aero._replace(Cz_0=0.12, Cl_beta=1.24, Cn_beta=0.78)
    parameters = LAKSA._replace(
        kite=LAKSA.kite._replace(chord=1.4, span=4.3, area=10.0),
        aero=aero,
        environment=Environment(9.8, 1.15),
    )
    path = Path(__file__).with_name("laksa_kitesurf_points.csv")
    with path.open(encoding="utf-8") as file:
        points = [{k: float(v) for k, v in row.items()} for row in csv.DictReader(file)]
    assert len(points) >= 3
    for point in points:
        place, v, spin, force, moment = (
            Vector(*(point[f"{name}{axis}_E"] for axis in "xyz"))
            for name in ("", "v", "om", "FA", "MA")
        )
        R = Rotation(*(Vector(*(point[f"R{i}{j}"] for j in (1, 2, 3))) for i in (1, 2, 3)))
        met = air(parameters, place, R, v, 0.0)
        assert np.degrees(met[:2]) == pytest.approx((point["alpha_deg"], point["beta_deg"]))
        wrench = aerodynamic_wrench(parameters, place, R, v, rotated(R, spin), 0.0)
        assert unrotated(R, wrench.force) == pytest.approx(force, abs=FORCE)
        assert unrotated(R, wrench.moment) == pytest.approx(moment, abs=FORCE)
