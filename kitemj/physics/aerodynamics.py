"""Force and moment coefficients of the rigid kite; one law for each type of `aero`.

To add a model: a ``NamedTuple`` of its numbers and a function of the contract of
`coefficients`, registered with ``@aero_law.of(MyAero)`` and compiled.
"""

from typing import Annotated, NamedTuple

from kitemj.physics.compiled import compiled, law
from kitemj.physics.kite import Kite
from kitemj.physics.quantity import Quantity
from kitemj.physics.vectors import Vector

PER_RAD = "1/rad"


class Coefficients(NamedTuple):
    """F = ½ρ|v|²S (C_x, C_y, C_z), M = ½ρ|v|²S (b C_l, c C_m, b C_n) about G; both in B."""

    x: float
    y: float
    z: float
    l: float  # noqa: E741  the field's standard name
    m: float
    n: float


class LinearAero(NamedTuple):
    """The linear law of the 2017 paper; rates are scaled by the fixed speed `V_ref`."""

    Cx_0: Annotated[float, Quantity("", "C_x at α = 0")]
    Cx_alpha: Annotated[float, Quantity(PER_RAD, "dC_x/dα")]
    Cy_beta: Annotated[float, Quantity(PER_RAD, "dC_y/dβ")]
    Cz_0: Annotated[float, Quantity("", "C_z at α = 0")]
    Cz_alpha: Annotated[float, Quantity(PER_RAD, "dC_z/dα")]
    Cl_beta: Annotated[float, Quantity(PER_RAD, "dC_l/dβ")]
    Cl_p: Annotated[float, Quantity("", "dC_l/dp̂, p̂ = b p / (2 V_ref)")]
    Cm_0: Annotated[float, Quantity("", "C_m at α = 0")]
    Cm_alpha: Annotated[float, Quantity(PER_RAD, "dC_m/dα")]
    Cm_q: Annotated[float, Quantity("", "dC_m/dq̂, q̂ = c q / V_ref (no ½)")]
    Cn_beta: Annotated[float, Quantity(PER_RAD, "dC_n/dβ")]
    Cn_r: Annotated[float, Quantity("", "dC_n/dr̂, r̂ = b r / (2 V_ref)")]
    V_ref: Annotated[float, Quantity("m/s", "fixed speed that scales the rates", gt=0)]


Powers = tuple[float, float, float]
Row = tuple[Powers, Powers, Powers, Powers, Powers, Powers, Powers, Powers]


class TableAero(NamedTuple):
    """A general table: each coefficient is
    Σ_k α^k (c_0k + c_βk β + c_pk p̂ + c_qk q̂ + c_rk r̂ + c_1k s₁ + c_2k s₂ + c_3k s₃).

    `table` is indexed [coefficient x y z l m n][term 1 β p̂ q̂ r̂ s₁ s₂ s₃][k = 0 1 2];
    s are the deflections [rad] of up to three control surfaces. Rates are scaled by the
    airspeed: p̂ = b p / (2|v|), q̂ = c q / (2|v|), r̂ = b r / (2|v|).
    """

    table: Annotated[tuple[Row, Row, Row, Row, Row, Row], Quantity("", "c_0k and its fellows")]
    surfaces: Annotated[Powers, Quantity("rad", "s, what the surfaces are turned by")] = (
        0.0,
        0.0,
        0.0,
    )


def _coefficients(
    aero: LinearAero | TableAero,
    kite: Kite,
    alpha: float,
    beta: float,
    omega_B: Vector,
    airspeed: float,
) -> Coefficients:
    """Coefficients at `alpha`, `beta` [rad], body rates [rad/s, B] and airspeed > 0 [m/s]."""
    raise NotImplementedError


coefficients, aero_law = law(_coefficients)


@aero_law.of(LinearAero)
@compiled
def linear_coefficients(
    aero: LinearAero, kite: Kite, alpha: float, beta: float, omega_B: Vector, airspeed: float
) -> Coefficients:
    """Sánchez-Arriaga et al. (2017), equations of section 2.3, in LAKSA's convention for q̂."""
    p_hat = kite.span * omega_B.x / (2 * aero.V_ref)
    q_hat = kite.chord * omega_B.y / aero.V_ref
    r_hat = kite.span * omega_B.z / (2 * aero.V_ref)
    return Coefficients(
        aero.Cx_0 + aero.Cx_alpha * alpha,
        aero.Cy_beta * beta,
        aero.Cz_0 + aero.Cz_alpha * alpha,
        aero.Cl_beta * beta + aero.Cl_p * p_hat,
        aero.Cm_0 + aero.Cm_alpha * alpha + aero.Cm_q * q_hat,
        aero.Cn_beta * beta + aero.Cn_r * r_hat,
    )


@aero_law.of(TableAero)
@compiled
def table_coefficients(
    aero: TableAero, kite: Kite, alpha: float, beta: float, omega_B: Vector, airspeed: float
) -> Coefficients:
    """The sum in the docstring of `TableAero`."""
    p_hat = kite.span * omega_B.x / (2 * airspeed)
    q_hat = kite.chord * omega_B.y / (2 * airspeed)
    r_hat = kite.span * omega_B.z / (2 * airspeed)
    terms = (1.0, beta, p_hat, q_hat, r_hat, *aero.surfaces)
    return Coefficients(
        _row(aero.table[0], terms, alpha),
        _row(aero.table[1], terms, alpha),
        _row(aero.table[2], terms, alpha),
        _row(aero.table[3], terms, alpha),
        _row(aero.table[4], terms, alpha),
        _row(aero.table[5], terms, alpha),
    )


@compiled
def _row(row: Row, terms: tuple[float, ...], alpha: float) -> float:
    total = 0.0
    for i in range(len(terms)):
        total += terms[i] * (row[i][0] + alpha * (row[i][1] + alpha * row[i][2]))
    return total
