"""Three formulations that share no kinematics, no inertia terms and no integrator agree."""

import pytest

from tests.agreement import rungs
from tests.agreement.formulations import MODULES, Formulation, shipped
from tests.support import random_cases

CASES = random_cases(510)  # 170 of each of three kites


@pytest.fixture(params=MODULES)
def formulation(request: pytest.FixtureRequest) -> Formulation:
    return shipped(request.param)


def test_pose_and_velocity_follow_from_q_and_its_rates(formulation):
    assert rungs.motion(formulation, CASES) <= rungs.MOTION


def test_accelerations_agree_at_every_state(formulation):
    assert rungs.accelerations(formulation, CASES) <= rungs.ACCELERATION[formulation.name]


def test_tensions_agree_at_every_state(formulation):
    assert rungs.tensions(formulation, CASES) <= rungs.TENSION[formulation.name]


def test_a_nervous_flight_is_followed(formulation):
    assert rungs.trajectory(formulation) <= rungs.TRAJECTORY[formulation.name]


def test_energy_changes_by_the_work_of_air_and_lines(formulation):
    assert rungs.balance(formulation) <= rungs.BALANCE[formulation.name]


def test_steps_converge_as_runge_kutta_promises(formulation):
    assert rungs.order(formulation) >= rungs.ORDER
