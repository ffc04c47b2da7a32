"""The pilot in the picture: hands that do what the lines do."""

import numpy as np
import pytest
from numpy.typing import NDArray

from kitemj.physics.frames import Angles
from kitemj.physics.parameter_files import parameter_set
from kitemj.physics.vectors import dot, minus, norm
from kitemj.scene import figure
from kitemj.scene.cloth import Colour
from kitemj.scene.figure import ARM, hands
from kitemj.scene.strokes import Strokes
from kitemj.scene.views import UP, downwind
from tests.scene.motions import motion_at
from tests.support import pulling

STUNT = parameter_set("sport")
AHEAD = Angles(0.0, 0.7, 0.0, -0.1)
WIND = downwind(STUNT)


def ahead(delta: float) -> tuple[float, float]:
    """How far [m] downwind the hands are, the left and the right, for the same kite."""
    held = hands(STUNT, pulling(motion_at(STUNT, AHEAD._replace(eta=-delta), delta), 0.0, 0.0))
    return dot(held.left, WIND), dot(held.right, WIND)


def test_the_hand_that_pulls_goes_back_and_the_other_out() -> None:
    rest, pulled = ahead(0.0), ahead(0.3)  # δ > 0: the right hand pulls
    way = STUNT.kite.y_A * np.sin(0.3)
    assert rest[0] == pytest.approx(rest[1])
    assert rest[1] - pulled[1] == pytest.approx(way, rel=0.15), "soft at the end of the arm"
    assert pulled[0] - rest[0] == pytest.approx(way, rel=0.15)
    assert ahead(-0.3) == pytest.approx(pulled[::-1])


def test_hands_are_as_far_as_arms_reach() -> None:
    far = motion_at(STUNT, AHEAD)
    reeled = far._replace(lines=tuple(line._replace(length=40.0) for line in far.lines))
    assert norm(minus(hands(STUNT, reeled).left, hands(STUNT, far).left)) <= ARM


def test_the_left_hand_is_on_the_left_of_one_who_faces_the_kite() -> None:
    for phi in (-1.0, 0.0, 1.0):
        motion = motion_at(STUNT, AHEAD._replace(phi=phi))
        left, right = hands(STUNT, motion)
        G = motion.body.p_G_E
        across = minus(left, right)
        facing = (-G.y, G.x)  # 90° to the left of the kite, seen from above with z down
        assert across.x * facing[0] + across.y * facing[1] < 0 or G.y == 0
        assert dot(across, minus(motion.lines[0].points[-1], motion.lines[1].points[-1])) > 0


def test_a_strong_pull_is_leant_against() -> None:
    motion = motion_at(STUNT, AHEAD)
    heads = [
        figure._axes(STUNT, pulling(motion, pull, pull))[2] @ WIND for pull in (0.0, 50.0, 2e4)
    ]
    assert heads[0] == pytest.approx(0.0)
    assert 0 > heads[1] > heads[2] > -0.5, "upwind, and never lies on the ground"
    up = figure._axes(STUNT, motion)[2]
    assert up @ UP > 0.9


def test_arms_have_their_length() -> None:
    for away in ([0.0, 0.0, 0.0], [0.1, 0.2, 0.1], [-0.5, -0.1, 0.0]):
        hand = figure.HANDS + np.array(away)
        elbow = figure._elbow(figure.SHOULDER, hand, figure.ELBOW)
        upper = np.linalg.norm(elbow - figure.SHOULDER)
        assert upper == pytest.approx(figure.UPPER_ARM, abs=0.01)
        assert np.linalg.norm(hand - elbow) == pytest.approx(figure.FOREARM, abs=0.1)
        assert elbow[1] > 0.1, "out"


class Limbs(Strokes):
    """Keeps what is drawn of a person."""

    def __init__(self) -> None:
        self.upper_arms: list[NDArray[np.float64]] = []

    def egg(self, *_: object) -> None:
        """Is no limb."""

    def limb(self, ends: NDArray[np.float64], radius: float, colour: Colour) -> None:
        """Keeps an upper arm, which is in a sleeve."""
        if colour == figure.SHIRT:
            self.upper_arms.append(ends)


def test_each_arm_hangs_from_its_own_shoulder() -> None:
    motion, drawn = motion_at(STUNT, AHEAD), Limbs()
    figure.add_pilot(drawn, STUNT, motion)
    to_the_left = figure._axes(STUNT, motion)[1]
    places = [ends @ to_the_left for ends in drawn.upper_arms]
    assert [[*np.sign(ends)] for ends in places] == [[1, 1], [-1, -1]]
