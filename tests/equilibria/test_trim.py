"""Equilibria of the named sets and of random kites, held against the paper's equation."""

from math import atan2, cos, degrees, hypot, radians, sin, sqrt

import numpy as np
import pytest
from numpy.typing import NDArray

from kitemj.dynamics.formulation import MODELS
from kitemj.equilibria.minimal import Minimal, held
from kitemj.equilibria.trim import RESIDUAL, Trim, equilibria, lines_held, trimmed
from kitemj.equilibria.vary import with_value
from kitemj.errors import InputError
from kitemj.flight.equilibrium import equilibrium
from kitemj.physics.aerodynamics import LinearAero, Powers, Row, TableAero
from kitemj.physics.loads import aerodynamic_wrench
from kitemj.physics.parameter_files import parameter_set
from kitemj.physics.parameters import Parameters
from kitemj.physics.steering import Sines
from kitemj.physics.wind import wind_speed

SETS = {name: parameter_set(name) for name in ("laksa", "thesis")}
LAKSA = SETS["laksa"]
SAME_ANGLE = 1e-8
"""rad; what three formulations may differ by in γ, θ."""
SAME_TENSION = 1e-6
"""Of the tension."""
SAME_ALPHA = 1e-9
"""rad; from the root of the paper's equation."""


def paper_moment(parameters: Parameters, alpha: NDArray[np.float64]) -> NDArray[np.float64]:
    """The paper's equation for α [rad], written here anew; zero at an equilibrium."""
    k, e, V, a = parameters.kite, parameters.environment, parameters.wind.speed, parameters.aero
    assert isinstance(a, LinearAero)
    Lambda = 2 * k.mass * e.gravity / (e.air_density * k.area * V**2)
    return (
        Lambda * (k.x_A * np.cos(alpha) + k.z_A * np.sin(alpha))
        + k.chord * (a.Cm_0 + a.Cm_alpha * alpha)
        - k.z_A * (a.Cx_0 + a.Cx_alpha * alpha)
        + k.x_A * (a.Cz_0 + a.Cz_alpha * alpha)
    )


def paper_lift(parameters: Parameters, alpha: float) -> float:
    """Lift less weight [N]: positive where the lines pull."""
    k, e, V, a = parameters.kite, parameters.environment, parameters.wind.speed, parameters.aero
    assert isinstance(a, LinearAero)
    C_x, C_z = a.Cx_0 + a.Cx_alpha * alpha, a.Cz_0 + a.Cz_alpha * alpha
    qS = 0.5 * e.air_density * V**2 * k.area
    return qS * (C_x * sin(alpha) - C_z * cos(alpha)) - k.mass * e.gravity


def roots(parameters: Parameters) -> list[float]:
    """α [rad] in (0, α_stall) that balance and let the lines pull, to 1e-4 rad, by brute force."""
    alpha = np.linspace(0, parameters.limits.alpha_stall, 20001)[1:-1]
    m = paper_moment(parameters, alpha)
    crossed = alpha[:-1][np.sign(m[:-1]) != np.sign(m[1:])]
    return [float(a) for a in crossed if paper_lift(parameters, float(a)) > 0]


def random_kite(rng: np.random.Generator) -> Parameters:
    """A kite that a person might build: 0.8 to 12 m, in 1 to 20 m/s of wind."""
    span = float(np.exp(rng.uniform(np.log(0.8), np.log(12.0))))
    chord = span / rng.uniform(2, 8)
    area = span * chord * rng.uniform(0.6, 1.0)
    mass = area * rng.uniform(0.1, 0.8)
    I_x, I_y = mass * span**2 * rng.uniform(0.04, 0.12), mass * chord**2 * rng.uniform(0.05, 0.4)
    kite = LAKSA.kite._replace(
        mass=mass,
        inertia_x=I_x,
        inertia_y=I_y,
        inertia_z=rng.uniform(max(I_x, I_y) - min(I_x, I_y), I_x + I_y),
        chord=chord,
        span=span,
        area=area,
        x_A=chord * rng.uniform(0.0, 0.7),
        y_A=span * rng.uniform(0.1, 0.5),
        z_A=chord * rng.uniform(0.3, 2.0),
    )
    aero = LAKSA.aero
    assert isinstance(aero, LinearAero)
    changed = [
        value if name == "V_ref" else value * rng.uniform(0.5, 1.5)
        for name, value in aero._asdict().items()
    ]
    return LAKSA._replace(
        kite=kite,
        aero=LinearAero(*changed),
        lines=LAKSA.lines._replace(length=float(np.exp(rng.uniform(np.log(15), np.log(400))))),
        wind=LAKSA.wind._replace(speed=rng.uniform(1.0, 20.0)),
    )


def found_or_said(parameters: Parameters) -> tuple[list[Trim], str]:
    """What is found, or what is said."""
    try:
        return equilibria(parameters), ""
    except InputError as error:
        return [], str(error)


def only(parameters: Parameters, model: str = "lagrange") -> Trim:
    found = equilibria(parameters, model=model)
    assert len(found) == 1
    return found[0]


@pytest.mark.parametrize("name", SETS)
def test_the_angle_of_attack_solves_the_papers_equation(name: str) -> None:
    trim = only(SETS[name])
    h = SAME_ALPHA
    m = paper_moment(SETS[name], np.array([trim.alpha - h, trim.alpha + h]))
    assert m[0] * m[1] < 0


def test_the_equilibrium_of_laksa_is_the_published_one() -> None:
    trim = only(LAKSA)
    assert degrees(trim.alpha) == pytest.approx(7.746286, abs=1e-6)
    assert degrees(trim.q.gamma) == pytest.approx(22.882617, abs=1e-6)
    assert degrees(trim.q.theta) == pytest.approx(-15.136331, abs=1e-6)
    assert trim.tensions == pytest.approx((43.7845, 43.7845), abs=1e-4)


@pytest.mark.parametrize("name", SETS)
@pytest.mark.parametrize("delta", [0.0, 0.08])
def test_the_three_models_agree(name: str, delta: float) -> None:
    first, *others = [equilibria(SETS[name], delta=delta, model=model)[0] for model in MODELS]
    assert first.residual <= RESIDUAL
    for other in others:
        assert other.residual <= RESIDUAL
        assert np.abs(np.subtract(other.q, first.q)).max() < SAME_ANGLE
        assert other.tensions == pytest.approx(first.tensions, rel=SAME_TENSION)


def test_forces_and_moments_balance_without_any_model() -> None:
    trim = equilibria(LAKSA, delta=0.08)[0]
    kite = Minimal("lagrange", LAKSA)
    body = kite.answer(np.array([*trim.q, 0, 0, 0, 0]), trim.control).body
    air = aerodynamic_wrench(LAKSA, body.p_G_E, body.R_BE, body.v_G_E, body.omega_B, 0.0)
    R, p = np.array(body.R_BE), np.array(body.p_G_E)
    arms = [np.array((LAKSA.kite.x_A, side * LAKSA.kite.y_A, LAKSA.kite.z_A)) for side in (1, -1)]
    force, moment = R.T @ np.array(air.force) + (0, 0, LAKSA.kite.mass * 9.81), np.array(air.moment)
    for arm, tension in zip(arms, trim.tensions, strict=True):
        A = p + R.T @ arm
        pull = -tension * A / np.linalg.norm(A)
        force, moment = force + pull, moment + np.cross(arm, R @ pull)
    assert np.abs(force).max() < 1e-9
    assert np.abs(moment).max() < 1e-9


def test_the_start_of_scenarios_is_the_same_equilibrium() -> None:
    found, trim = equilibrium(LAKSA), only(LAKSA)
    assert found[:3] == pytest.approx((trim.alpha, trim.q.gamma, trim.q.theta), abs=1e-12)
    assert found.tension == pytest.approx(trim.tensions[0], rel=1e-12)
    assert trimmed(LAKSA)[0][:4] == pytest.approx(trim.q, abs=1e-12)


def test_a_thousand_random_kites_stand_or_are_told_why_not() -> None:
    rng, standing_kites, refused = np.random.default_rng(2017), 0, 0
    for _ in range(1000):
        parameters = random_kite(rng)
        expected = roots(parameters)
        found, sentence = found_or_said(parameters)
        if sentence:
            refused += 1
            assert "no equilibrium" in sentence or "no physical equilibrium" in sentence
            assert not expected or "ground" in sentence, sentence
            continue
        standing_kites += 1
        symmetric = [trim for trim in found if abs(trim.q.phi) + abs(trim.q.eta) < 1e-9]
        assert [t.alpha for t in symmetric] == pytest.approx(expected, abs=1e-4)
        assert all(trim.residual <= RESIDUAL for trim in found)
        assert all(min(trim.tensions) > 0 for trim in found)
    assert standing_kites > 300  # the sample is of kites that mostly fly, and of some that do not
    assert refused > 50


def test_random_kites_stand_alike_in_all_models() -> None:
    rng, compared = np.random.default_rng(3), 0
    while compared < 10:
        parameters = random_kite(rng)
        if not roots(parameters):
            continue
        compared += 1
        trims = [equilibria(parameters, model=model)[0] for model in MODELS]
        for other in trims[1:]:
            assert np.abs(np.subtract(other.q, trims[0].q)).max() < SAME_ANGLE
            assert other.tensions == pytest.approx(trims[0].tensions, rel=SAME_TENSION)


def test_two_equilibria_are_both_found() -> None:
    # a moment that rises and falls: C_m quadratic in α by the general law
    zero = (0.0, 0.0, 0.0)

    def row(powers: Powers, by_beta: float = 0.0) -> Row:
        return (powers, (by_beta, 0.0, 0.0), zero, zero, zero, zero, zero, zero)

    X, Z, M = (-0.065, 0.18, 0.0), (0.116, -2.97, 0.0), (0.13, -1.87, 8.2)
    Y, L, N = row(zero, -1.57), row(zero, -0.1), row(zero, -0.027)
    aero = TableAero((row(X), Y, row(Z), L, row(M), N))
    parameters = LAKSA._replace(aero=aero)
    alphas = [e.alpha for e in equilibria_in_plane(parameters)]
    assert len(alphas) == 2
    assert alphas[0] < alphas[1]


def equilibria_in_plane(parameters: Parameters) -> list[Trim]:
    return [t for t in equilibria(parameters) if abs(t.q.eta) < 1e-9]


def test_equilibria_beside_the_plane_of_symmetry_are_found() -> None:
    # a pitchfork: past C_lβ = +0.0994 the kite can also stand tilted, to either side
    found = equilibria(with_value(LAKSA, "aero.Cl_beta", 0.1014198566))
    assert len(found) == 3
    tilted = sorted(found, key=lambda trim: trim.q.phi)
    assert np.degrees(tilted[2].q) == pytest.approx([10, 20.26, 31.205, -14.847], abs=1e-2)
    assert tilted[0].q == pytest.approx(np.array([-1, 1, -1, 1]) * tilted[2].q, abs=1e-8)
    assert len(equilibria(with_value(LAKSA, "aero.Cl_beta", 0.09))) == 1


def test_the_wind_from_aside_turns_the_equilibrium() -> None:
    turned = only(LAKSA._replace(wind=LAKSA.wind._replace(azimuth=0.4)))
    straight = only(LAKSA)
    assert turned.q.phi == pytest.approx(0.4, abs=1e-12)
    assert turned.q[1:] == pytest.approx(straight.q[1:], abs=1e-10)


def test_a_wind_that_grows_with_height_is_that_of_the_kites_height() -> None:
    wind = LAKSA.wind._replace(speed=5.0, exponent=0.14)
    sheared = only(LAKSA._replace(wind=wind))
    V = wind_speed(wind, sheared.height, 0.0)
    plain = only(LAKSA._replace(wind=LAKSA.wind._replace(speed=V)))
    assert sheared.q == pytest.approx(plain.q, abs=1e-10)
    assert sheared.tensions == pytest.approx(plain.tensions, rel=1e-9)


def test_mirrored_steering_gives_the_mirrored_equilibrium() -> None:
    left, right = (equilibria(LAKSA, delta=delta)[0] for delta in (0.05, -0.05))
    mirror = np.array([-1, 1, -1, 1])
    assert mirror * np.array(left.q) == pytest.approx(np.array(right.q), abs=1e-10)
    assert left.azimuth > 0  # the thesis kite drifts to the pilot's left when the right pulls


def test_lines_are_held_where_their_programme_swings_about() -> None:
    rest = sqrt(200.0**2 - 2.9**2)
    assert lines_held(LAKSA, Sines(rest, 0.03, 0.1, 0.5)) == (None, 0.03)
    assert lines_held(LAKSA, Sines(150.0)) == (150.0, 0.0)


def test_position_is_told_as_seen_from_the_ground() -> None:
    trim = only(LAKSA)
    kite = Minimal("lagrange", LAKSA)
    p = kite.answer(np.array([*trim.q, 0, 0, 0, 0]), held(trim.ell)).body.p_G_E
    assert trim.height == -p.z
    assert trim.elevation == atan2(-p.z, hypot(p.x, p.y))
    assert trim.ell == pytest.approx(sqrt(200.0**2 - 2.9**2))
    assert degrees(trim.elevation) == pytest.approx(67.06, abs=0.01)


@pytest.mark.parametrize(
    ("change", "says"),
    [
        ({"wind": {"speed": 2.0}}, "takes a wind of"),
        ({"wind": {"speed": 0.0}}, "wind.speed > 0 m/s"),
        ({"wind": {"gust_amplitude": 0.1}}, "wind.gust_amplitude must be 0"),
        ({"kite": {"z_A": -2.0}}, "moments"),
        ({"aero": {"Cz_alpha": 0.3, "Cm_alpha": -3.0}}, "have to push"),
    ],
)
def test_no_equilibrium_is_one_sentence(change: dict[str, dict[str, float]], says: str) -> None:
    with pytest.raises(InputError, match=says) as caught:
        equilibria(parameter_set("laksa", change))
    assert "\n" not in str(caught.value)


def test_the_least_wind_that_is_told_is_enough_and_hardly_more() -> None:
    weak = LAKSA._replace(wind=LAKSA.wind._replace(speed=2.0))
    with pytest.raises(InputError) as caught:
        equilibria(weak)
    least = float(str(caught.value).split("takes a wind of ")[1].split(" ")[0])
    assert only(LAKSA._replace(wind=LAKSA.wind._replace(speed=least))).alpha < radians(25)
    with pytest.raises(InputError):
        equilibria(LAKSA._replace(wind=LAKSA.wind._replace(speed=0.99 * least)))


def test_an_unknown_model_is_told_with_those_there_are() -> None:
    with pytest.raises(InputError, match="there are: mujoco, newton-euler, lagrange"):
        equilibria(LAKSA, model="runge")
