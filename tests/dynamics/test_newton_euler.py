"""The free rigid body on two lines against mechanics' own laws and the numbers of LAKSA."""

from itertools import pairwise
from math import asin, degrees, log2, nan, radians, sqrt
from typing import NamedTuple

import numpy as np
import pytest

from kitemj.dynamics import newton_euler as ne
from kitemj.dynamics import newton_euler_kite as nek
from kitemj.dynamics.adaptive import carried, room_for
from kitemj.dynamics.motion import (
    Body,
    Motion,
    PerLine,
    State,
    attachment_E,
    attachment_velocity_E,
    energy,
)
from kitemj.dynamics.newton_euler import accelerations, placed
from kitemj.dynamics.newton_euler_kite import NewtonEulerKite
from kitemj.errors import FlightError
from kitemj.physics.frames import Angles
from kitemj.physics.loads import aerodynamic_wrench
from kitemj.physics.parameters import Parameters
from kitemj.physics.steering import Control, Segment, Sines, control, line_motion, rest_ell
from kitemj.physics.vectors import Vector, cross, dot, minus, norm, plus, rotated, times, unrotated
from tests.support import LAKSA, SPORT

REST = Angles(0.0, 0.0, 0.0, 0.0)
HANGING = State(Angles(0.0, 0.399377006123854, 0.0, -0.264178811057397), REST)
STEERING = Sines(rest_ell(200.0, 2.9), delta_amplitude=radians(8.0), delta_frequency=0.1)

ALOFT = State(Angles(0.0, 0.454, 0.0, -0.291), REST)
LOOPS = Sines(rest_ell(20.0, 0.3), delta=0.4)
SWINGS = Sines(rest_ell(20.0, 0.3), 0.0, 0.3, 1.5, 1.0, 0.7)
VACUUM = SPORT._replace(environment=SPORT.environment._replace(gravity=0.0, air_density=0.0))

ROUNDING = 1e-12  # relative to the largest term of a sum
ON_THE_LINES = 1e-12  # m and m/s, after a correction; 20 m to 200 m in double precision


class Row(NamedTuple):
    """t [s], G [m, E], (α, β) [deg], (T₊, T₋) [N]."""

    t: float
    p_G_E: tuple[float, float, float]
    air: tuple[float, float]
    tensions: tuple[float, float]


# LAKSA KiteAcrobat (UC3M) in GNU Octave 7.3, ode45 with rtol 1e-11, from `HANGING` on lines
# that move as `STEERING` says.
LAKSA_ROWS = [
    Row(
        0.0,
        (-78.7734437765645, 0.0, -186.121971923044),
        (7.74628597509442, 21.746585138027),
        (68.6931253959198, 38.518736390923),
    ),
    Row(
        0.1,
        (-78.7728256384161, 0.100760161691723, -186.122225430885),
        (7.73272787335469, 2.06828254092559),
        (43.9953673922068, 43.565310614086),
    ),
    Row(
        20.0,
        (-78.7481326113095, 15.1345164822646, -185.497763820984),
        (7.73059255954673, -1.01859019927839),
        (39.7955863646233, 49.0396561160186),
    ),
    Row(
        40.0,
        (-79.6124340858468, -3.89605843295118, -185.710181185818),
        (7.66466613531355, 0.747680451373201),
        (50.4963948302002, 42.2211077630633),
    ),
    Row(
        60.0,
        (-78.997540318545, -11.6876930612958, -185.657970542392),
        (7.76305293641271, 0.346197741052225),
        (45.2798983307719, 42.5641307671624),
    ),
]


def random_flights(n: int) -> list[tuple[State, Segment]]:
    """States well away from rest and lines that speed up; every run the same."""
    r = np.random.default_rng(7)
    return [
        (
            State(Angles(*r.uniform(-0.8, 0.8, 4)), Angles(*r.uniform(-1.0, 1.0, 4))),
            Segment(0.0, Control(20.0, *r.uniform(-0.5, 0.5, 5))),
        )
        for _ in range(n)
    ]


def line_errors(parameters: Parameters, programme: Sines, t: float, body: Body) -> PerLine:
    """Largest error of the two distances [m] and of their rates [m/s]."""
    far, fast = 0.0, 0.0
    for side in (1.0, -1.0):
        wanted = line_motion(parameters.kite.y_A, control(programme, t), side)
        A = attachment_E(parameters, body, side)
        rate = dot(A, attachment_velocity_E(parameters, body, side)) / norm(A)
        far = max(far, abs(norm(A) - wanted.length))
        fast = max(fast, abs(rate - wanted.rate))
    return PerLine(far, fast)


def flight(parameters: Parameters, state: State, programme: Sines, step: float) -> NewtonEulerKite:
    kite = NewtonEulerKite(parameters, step)
    kite.start(state, programme)
    return kite


@pytest.mark.parametrize(("state", "programme"), random_flights(10))
def test_start_is_on_the_lines_with_the_velocity_of_its_pose(state, programme):
    body = ne.body_of(placed(SPORT, programme, state))
    assert max(line_errors(SPORT, programme, 0.0, body)) < ON_THE_LINES

    def pose(s: float) -> Body:
        q = Angles(*(a + s * b for a, b in zip(state.q, state.q_dot, strict=True)))
        return ne.body_of(placed(SPORT, programme._replace(start=-s), State(q, state.q_dot)))

    h = 1e-5  # s: truncation h² and rounding 1e-15·20 m/h are both below 1e-8
    after, before = pose(h), pose(-h)
    v_E = times(1 / (2 * h), minus(after.p_G_E, before.p_G_E))
    assert v_E == pytest.approx(tuple(body.v_G_E), abs=1e-8)
    # d(R_BE)/dt = -ω x R_BE, so that ω = ½ Σ ė x e with e the axes of B, seen in E.
    spin_E = Vector(0.0, 0.0, 0.0)
    for axis in range(3):
        rate = times(1 / (2 * h), minus(after.R_BE[axis], before.R_BE[axis]))
        spin_E = plus(spin_E, times(0.5, cross(body.R_BE[axis], rate)))
    assert rotated(body.R_BE, spin_E) == pytest.approx(tuple(body.omega_B), abs=1e-8)


@pytest.mark.parametrize(("state", "programme"), random_flights(20))
def test_energy_grows_by_the_power_of_the_air_and_of_the_lines(state, programme):
    body = ne.body_of(placed(SPORT, programme, state))
    now = accelerations(SPORT, programme, 0.0, body)

    def energy_at(s: float) -> float:
        return energy(
            SPORT,
            Body(
                plus(body.p_G_E, times(s, body.v_G_E)),
                body.R_BE,
                plus(body.v_G_E, times(s, now.a_G_E)),
                plus(body.omega_B, times(s, now.omega_dot_B)),
            ),
        )

    air = aerodynamic_wrench(SPORT, body.p_G_E, body.R_BE, body.v_G_E, body.omega_B, 0.0)
    powers = [
        dot(air.force, rotated(body.R_BE, body.v_G_E)),
        dot(air.moment, body.omega_B),
    ]
    for side, T in ((1.0, now.tensions.plus), (-1.0, now.tensions.minus)):
        A = attachment_E(SPORT, body, side)
        powers.append(-T * dot(A, attachment_velocity_E(SPORT, body, side)) / norm(A))
    # The energy is a quadratic function of s: a central difference of any width is its derivative.
    dE_dt = (energy_at(1.0) - energy_at(-1.0)) / 2
    scale = max(map(abs, [*powers, energy_at(1.0), energy_at(-1.0)]))
    assert dE_dt == pytest.approx(sum(powers), abs=ROUNDING * scale)


def test_angular_momentum_about_the_ground_point_is_kept_in_empty_space():
    """Lines pull through O_E, however they move; gyroscopic terms and kinematics all count."""
    kite = flight(VACUUM, State(ALOFT.q, Angles(0.5, -0.3, 0.9, 0.7)), SWINGS, 0.001)

    def momentum(body: Body) -> Vector:
        moving = times(VACUUM.kite.mass, cross(body.p_G_E, body.v_G_E))
        w, k = body.omega_B, VACUUM.kite
        tensor = [
            [k.inertia_x, 0.0, -k.inertia_xz],
            [0.0, k.inertia_y, 0.0],
            [-k.inertia_xz, 0.0, k.inertia_z],
        ]
        return plus(moving, unrotated(body.R_BE, Vector(*(float(x) for x in np.dot(tensor, w)))))

    motions = kite.trajectory(SWINGS, [0.0, 2.0, 4.0, 6.0])
    start = momentum(motions[0].body)
    assert norm(start) > 10.0
    for motion in motions[1:]:
        assert momentum(motion.body) == pytest.approx(tuple(start), abs=1e-10 * norm(start))
    kite.advance(SWINGS, 6.0)
    assert momentum(kite.motion(SWINGS).body) == pytest.approx(tuple(start), abs=1e-8 * norm(start))


@pytest.mark.parametrize(("state", "programme"), random_flights(5))
def test_mirrored_flight_has_mirrored_accelerations(state, programme):
    c = programme.control
    mirrored = State(*(Angles(-a.phi, a.gamma, -a.eta, a.theta) for a in state))
    other = programme._replace(
        control=c._replace(delta=-c.delta, delta_dot=-c.delta_dot, delta_ddot=-c.delta_ddot)
    )
    one = accelerations(SPORT, programme, 0.0, ne.body_of(placed(SPORT, programme, state)))
    two = accelerations(SPORT, other, 0.0, ne.body_of(placed(SPORT, other, mirrored)))
    a, w = two.a_G_E, two.omega_dot_B
    assert one.a_G_E == pytest.approx((a.x, -a.y, a.z), rel=1e-11, abs=1e-11)
    assert one.omega_dot_B == pytest.approx((-w.x, w.y, -w.z), rel=1e-11, abs=1e-11)
    assert one.tensions == pytest.approx((two.tensions.minus, two.tensions.plus), rel=1e-11)


def test_equilibrium_of_the_paper_stays():
    """The paper's scalar equation for α, that no dynamics code is needed for."""
    body = ne.body_of(placed(LAKSA, Sines(STEERING.ell), HANGING))
    now = accelerations(LAKSA, Sines(STEERING.ell), 0.0, body)
    assert norm(now.a_G_E) < 1e-12
    assert norm(now.omega_dot_B) < 1e-12
    assert now.tensions == pytest.approx((43.7845, 43.7845), abs=5e-5)


def assert_like_laksa(motion: Motion, row: Row, scale: float) -> None:
    """Within `scale` [m]; angles [deg] and forces [N] within a hundred times that number."""
    assert motion.t == pytest.approx(row.t)
    assert motion.body.p_G_E == pytest.approx(row.p_G_E, abs=scale)
    met = (degrees(motion.air.alpha), degrees(motion.air.beta))
    assert met == pytest.approx(row.air, abs=100 * scale)
    assert motion.tensions == pytest.approx(row.tensions, abs=100 * scale)


def test_adaptive_flight_follows_laksa():
    kite = flight(LAKSA, HANGING, STEERING, 0.002)
    motions = kite.trajectory(STEERING, [row.t for row in LAKSA_ROWS])
    for motion, row in zip(motions, LAKSA_ROWS, strict=True):
        assert_like_laksa(motion, row, 1e-11)  # m; measured: 2.6e-12 with outputs 20 s apart
    assert kite.t == LAKSA_ROWS[-1].t


def test_stepped_flight_follows_laksa():
    kite = flight(LAKSA, HANGING, STEERING, 0.002)
    for row in LAKSA_ROWS:
        kite.advance(STEERING, row.t - kite.t)
        assert_like_laksa(kite.motion(STEERING), row, 1e-8)  # m; measured at 2 ms: 4.5e-9


def test_steps_are_of_fourth_order_in_loops():
    exact = flight(SPORT, ALOFT, LOOPS, 0.002).trajectory(LOOPS, [4.0])[0].body.p_G_E
    errors = []
    for step in (0.008, 0.004, 0.002):
        kite = flight(SPORT, ALOFT, LOOPS, step)
        kite.advance(LOOPS, 4.0)
        errors.append(norm(minus(kite.motion(LOOPS).body.p_G_E, exact)))
    orders = [log2(a / b) for a, b in pairwise(errors)]
    assert min(orders) > 3.7
    assert max(orders) < 4.3


@pytest.mark.parametrize("programme", [LOOPS, SWINGS])
def test_flight_stays_on_the_lines(programme):
    kite = flight(SPORT, ALOFT, programme, 0.002)
    for motion in kite.trajectory(programme, [2.5, 5.0, 7.5]):
        assert max(line_errors(SPORT, programme, motion.t, motion.body)) < ON_THE_LINES
    for _ in range(60):
        kite.advance(programme, 1.0)
        assert max(line_errors(SPORT, programme, kite.t, kite.motion(programme).body)) < (
            ON_THE_LINES
        )


def flat(y):
    """The 13 numbers in a row."""
    x = np.empty(13)
    nek.put(y, x)
    return x


def test_correction_is_never_more_than_the_integrator_s_own_error():
    """Left alone for 10 s of loops the adaptive integrator leaves the lines by less than 1e-10 m,

    and a correction of that size is the least one: doing it twice changes nothing more.
    """
    y = placed(SPORT, LOOPS, ALOFT)
    room = room_for(flat(y))
    assert carried(nek.NewtonEulerSystem(SPORT, LOOPS), room, 0.0, 10.0, nek.TOLERANCE) == 10.0
    loose = nek.free(room.x)
    held = ne.corrected(SPORT, LOOPS, 10.0, loose)
    again = ne.corrected(SPORT, LOOPS, 10.0, held)
    drift = line_errors(SPORT, LOOPS, 10.0, ne.body_of(loose))
    assert 0 < drift.plus < 1e-10
    assert flat(held) == pytest.approx(flat(loose), abs=1e-10)
    assert flat(again) == pytest.approx(flat(held), abs=1e-13)


def test_correction_puts_a_displaced_kite_back_without_turning_momentum():
    """The impulse of a correction pulls along the lines: no angular momentum about O_E."""
    y = placed(SPORT, SWINGS, ALOFT)
    w = y.omega_B
    y = y._replace(v_G_E=plus(y.v_G_E, Vector(0.02, -0.03, 0.05)), omega_B=w._replace(y=w.y + 0.1))
    held = ne.body_of(ne.corrected(SPORT, SWINGS, 0.0, y))
    loose = ne.body_of(y)
    assert line_errors(SPORT, SWINGS, 0.0, loose).minus > 1e-2
    assert max(line_errors(SPORT, SWINGS, 0.0, held)) < ON_THE_LINES
    moved = times(SPORT.kite.mass, cross(held.p_G_E, minus(held.v_G_E, loose.v_G_E)))
    turned = ne.spin(SPORT.kite, minus(held.omega_B, loose.omega_B))
    assert plus(moved, unrotated(held.R_BE, turned)) == pytest.approx((0.0, 0.0, 0.0), abs=1e-13)


def test_advance_in_pieces_is_advance_at_once():
    whole, pieces = (flight(SPORT, ALOFT, LOOPS, 0.002) for _ in range(2))
    whole.advance(LOOPS, 1.0)
    for _ in range(50):
        pieces.advance(LOOPS, 0.02)
    assert pieces.t == pytest.approx(1.0)
    assert pieces.motion(LOOPS).body.p_G_E == pytest.approx(tuple(whole.motion(LOOPS).body.p_G_E))


def test_formula_runs_in_plain_python_too():
    state, programme = random_flights(1)[0]
    body = ne.body_of(placed(SPORT, programme, state))
    compiled = accelerations(SPORT, programme, 0.0, body)
    plain = accelerations.py_func(SPORT, programme, 0.0, body)
    assert plain.a_G_E == pytest.approx(tuple(compiled.a_G_E))
    assert plain.tensions == pytest.approx(tuple(compiled.tensions))


def test_motion_tells_lengths_control_and_angles():
    kite = flight(LAKSA, HANGING, STEERING, 0.01)
    kite.advance(STEERING, 3.0)
    motion = kite.motion(STEERING)
    left, right = motion.lengths
    assert motion.control == control(STEERING, 3.0)
    assert asin((left**2 - right**2) / (4 * STEERING.ell * 2.9)) == pytest.approx(
        motion.control.delta
    )
    assert sqrt((left**2 + right**2) / 2 - 2.9**2) == pytest.approx(STEERING.ell)
    again = ne.body_of(
        placed(LAKSA, Sines(STEERING.ell, motion.control.delta), State(motion.q, REST))
    )
    assert again.p_G_E == pytest.approx(tuple(motion.body.p_G_E), abs=1e-10)


def test_a_start_that_is_no_number_ends_in_a_sentence():
    lost = State(Angles(nan, 0.0, 0.0, 0.0), REST)
    kite = flight(SPORT, lost, LOOPS, 0.002)
    with pytest.raises(FlightError, match=r"newton-euler cannot fly on after t = 0\.000 s"):
        kite.trajectory(LOOPS, [0.0, 1.0])
