"""What is misprinted in the thesis, each shown by a calculation."""

from math import cos, radians, sin, sqrt
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from kitemj.equilibria.vary import with_value
from kitemj.flight.equilibrium import equilibrium
from kitemj.physics.aerodynamics import coefficients
from kitemj.physics.frames import R_1E, R_B2
from kitemj.physics.parameter_files import parameter_set
from kitemj.physics.parameters import Parameters
from kitemj.physics.steering import ell_delta, rest_ell
from kitemj.physics.vectors import Vector
from kitemj.tables import Table

PHI, GAMMA = radians(25.0), radians(20.0)
"""rad; where the readings of R_1E are compared."""


class Misprint(NamedTuple):
    """`printed` and what it is by calculation, both in `unit`; how that is found."""

    where: str
    what: str
    printed: float
    calculated: float
    unit: str
    how: str


def misprint_table() -> Table:
    """A row for each misprint that a number can show."""
    near = parameter_set("thesis")
    far = with_value(near, "lines.length", 200.0)
    rows = [*_parameters(near, far), *_formulas(near), _arms(far)]
    return Table("Misprints, by calculation", Misprint._fields, [tuple(row) for row in rows])


def _parameters(near: Parameters, far: Parameters) -> list[Misprint]:
    kite, g, L = near.kite, near.environment.gravity, far.lines.length
    density = 440.4 * 2 * kite.mass / (kite.area * L)
    return [
        Misprint("Tables 1, 11", "y_A", 0.0037, kite.y_A / L, "", "Y_A / L₀; x_A was repeated"),
        Misprint(
            "Tables 1, 11",
            "ν_W",
            0.25,
            near.wind.speed / sqrt(g * L),
            "",
            f"V_w / √(g L₀) with 200 m; 80 m give {near.wind.speed / sqrt(g * 80.0):.4f}",
        ),
        Misprint(
            "Tables 1, 11",
            "V_w",
            0.25 * sqrt(g * L),
            near.wind.speed,
            "m/s",
            "the wind that the printed ν_W makes of 200 m",
        ),
        Misprint(
            "Tables 1, 11",
            "μ",
            440.4,
            near.environment.air_density * kite.area * L / (2 * kite.mass),
            "",
            f"ρ S L₀ / (2 m); 440.4 would take ρ = {density:.4f} kg/m³",
        ),
        Misprint(
            "Tables 1, 11",
            "i_y",
            2.92e-5,
            kite.inertia_y / (kite.mass * L**2),
            "",
            "I_y / (m L₀²): rounds to 2.91 · 10⁻⁵",
        ),
        Misprint(
            "Tables 2, 7",
            "unit of I_x",
            1.32e-4,
            kite.inertia_x / (kite.mass * L**2),
            "",
            "I_x / (m L₀²) is a number, and the printed i_x, only if I_x is in kg m², not kg/m²",
        ),
        Misprint(
            "Tables 2, 9, 10",
            "L₀",
            far.lines.length,
            near.lines.length,
            "m",
            "Tables 9 and 10 against Table 2; the equilibrium is the same for both",
        ),
    ]


def _formulas(near: Parameters) -> list[Misprint]:
    kite, stands = near.kite, equilibrium(near)
    weight, L = kite.mass * near.environment.gravity, near.lines.length
    spin = 0.5 * kite.inertia_x
    C = coefficients(near.aero, kite, stands.alpha, 0.0, Vector(0.0, 0.0, 0.0), near.wind.speed)
    air = 0.5 * near.environment.air_density * near.wind.speed**2 * kite.area
    force = air * float(np.hypot(C.x, C.z)) / weight
    nu_squared = near.wind.speed**2 / (near.environment.gravity * L)
    with_nu = sqrt(nu_squared) * nu_squared * float(np.hypot(C.x, C.z))
    R = np.array(R_B2(stands.theta))
    GA = np.array([kite.x_A, 0.0, kite.z_A])
    return [
        Misprint(
            "section 3",
            "G off its place",
            float(np.linalg.norm(R.T @ GA - GA)),
            0.0,
            "m",
            "printed along i_2 and k_2; along i_B and k_B the attachments are where equation 2 "
            "has them. At the equilibrium the two readings put G this far apart",
        ),
        Misprint(
            "section 3",
            "angle of x_2 to π",
            0.0,
            90.0,
            "°",
            "x_B and x_2 “in the plane π”, which two sentences before x_2 is normal to; the "
            "plane meant is that of symmetry",
        ),
        Misprint(
            "equation 15",
            "½ ωᵀ I ω at 1 rad/s about x_B",
            spin / 2,
            spin,
            "J",
            "(v² + ½ ωᵀ i ω)/2 halves the energy of turning; the second + is a product",
        ),
        Misprint(
            "equations 18, 19",
            "force of the air at rest / weight",
            with_nu,
            force,
            "",
            "the factor is μ, not ν (the wind); the last term of 18 lacks its k_B",
        ),
    ]


def _arms(far: Parameters) -> Misprint:
    L, y_A = far.lines.length, far.kite.y_A
    _, delta = ell_delta(L + 0.25, L - 0.25, y_A)
    reach = rest_ell(L, y_A) * y_A * sin(0.1) / L  # L₊² - L₋² = 4 ℓ Y_A sin δ = 4 L₀ reach
    how = f"its equations 8 and 9 for arms of ±0.25 m; 0.1 rad take ±{reach:.4f} m"
    return Misprint("section 4.6", "largest δ", 0.1, delta, "rad", how)


def rotation_table() -> Table:
    """Equation 4 as it can be read where φ is left out: how far from a rotation it is."""
    rows = []
    for reading, sine, cosine in (
        ("φ where it is left out", sin(PHI), cos(PHI)),
        ("s and c of nothing left out", 1.0, 1.0),
        ("s and c of γ, as in the factor before", sin(GAMMA), cos(GAMMA)),
    ):
        R = printed_R_1E(sine, cosine)
        off = float(np.abs(R @ R.T - np.eye(3)).max())
        ours = float(np.abs(R - np.array(R_1E(PHI, GAMMA))).max())
        rows.append((reading, off, float(np.linalg.det(R)), ours))
    columns = ("reading", "largest_of_R_Rᵀ_less_1", "determinant", "largest_gap_to_kitemj")
    return Table("Equation 4, R_1E, at φ = 25°, γ = 20°", columns, list(rows))


def printed_R_1E(sine: float, cosine: float) -> NDArray[np.float64]:
    """Equation 4 at `PHI`, `GAMMA`, with these for the s and c that have no angle."""
    sp, cp, sg, cg = sin(PHI), cos(PHI), sin(GAMMA), cos(GAMMA)
    return np.array([[cg * cp, cg * sine, -sg], [-sp, cp, 0.0], [sg * cosine, sg * sine, cg]])
