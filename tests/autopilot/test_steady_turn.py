"""How fast a kite turns, by hand: a steady turn far from the ground's weight, no dynamics code.

Across the lines the pull P sin δ of the tilted kite and the side force F_y carry it round, and
about the lines their moments balance the damping (docs/identification.md derives it):

    P δ + F_y = m v_k r,   a P δ + e F_y = D r   =>   r/δ = (a - e) P / (D - e m v_k)

with P = q S C_R, D = q S b² |C_nr cos²θ + C_lp sin²θ| / (2 V_ref). Weight turns nothing here, so
that slow kites of much weight turn less.
"""

from math import atan2, cos, hypot, radians, sin, sqrt

import pytest
from scipy.optimize import brentq

from kitemj.physics.parameters import Parameters
from kitemj.turning.identify import identified_law
from tests.autopilot.test_identify import in_wind, of_size

NEAR = 0.05
"""Of r/δ; for kites whose side force acts at G, which the circle's inertia does not turn."""
FAR = 0.1
"""Of r/δ; for `trainer`, with its side force far ahead of G, which weight keeps from turning."""


def by_hand(parameters: Parameters, airspeed: float) -> float:
    """r/δ [1/s] at an airspeed [m/s]."""
    kite, aero, V = parameters.kite, parameters.aero, parameters.wind.speed

    def forces(alpha: float) -> tuple[float, float]:
        return aero.Cx_0 + aero.Cx_alpha * alpha, aero.Cz_0 + aero.Cz_alpha * alpha

    def about_the_tow_points(alpha: float) -> float:
        x, z = forces(alpha)
        return kite.chord * (aero.Cm_0 + aero.Cm_alpha * alpha) - kite.z_A * x + kite.x_A * z

    x, z = forces(brentq(about_the_tow_points, 0.0, radians(25.0)))
    theta = atan2(x, -z)  # the lines go on where the air pulls
    s, c = sin(theta), cos(theta)
    ahead = kite.x_A * c + kite.z_A * s
    e = kite.span * (aero.Cn_beta * c - aero.Cl_beta * s) / aero.Cy_beta
    damping = -(kite.span**2) * (aero.Cn_r * c * c + aero.Cl_p * s * s) / (2 * aero.V_ref)
    qS = 0.5 * parameters.environment.air_density * airspeed**2 * kite.area
    over_ground = sqrt(airspeed**2 - V**2)  # across the wind
    return (ahead - e) * hypot(x, z) / (damping - e * kite.mass * over_ground / qS)


@pytest.mark.parametrize(
    ("parameters", "within"),
    [
        (in_wind("sport", 5.0), NEAR),
        (in_wind("sport", 6.5), NEAR),
        (in_wind("sport", 8.0), NEAR),
        (of_size(1.2, 25.0, 6.5), NEAR),
        (of_size(3.0, 40.0, 6.5), NEAR),
        (of_size(3.0, 60.0, 8.0), NEAR),
        (in_wind("trainer", 6.5), FAR),
        (in_wind("trainer", 8.0), FAR),
    ],
)
def test_the_law_turns_as_by_hand(parameters, within):
    law = identified_law(parameters)
    assert law.gain(law.airspeed) == pytest.approx(by_hand(parameters, law.airspeed), rel=within)
