"""Parameters, frames, equilibrium and instant of the report, against what others know of them."""

from math import degrees

import numpy as np
import pytest

from kitemj.physics.frames import R_1E
from tests.support import LAKSA
from thesis import coordinate_frames_geometry, equilibrium, misprints, parameters, post_processing

ROUNDING = 1e-12
"""Of numbers of size 1: some thousand times what a double rounds by."""


@pytest.mark.parametrize(
    ("printed", "value", "verdict"),
    [
        ("0.0037", 0.00375, "agrees"),  # a half rounds either way
        ("0.0037", 0.0145, "no"),
        ("2.92e-5", 2.9125e-5, "last digit"),
        ("1.12e-4", 1.125e-4, "agrees"),
        ("440.4", 441.0, "no"),
        ("4", 4.0, "agrees"),
        ("-0.7633", -0.76, "no"),
    ],
)
def test_numbers_agree_to_the_digits_that_are_printed(printed, value, verdict):
    assert parameters.agreement(printed, value) == verdict


def test_the_set_thesis_is_what_the_thesis_prints_but_for_the_length():
    rows = {(row[0], row[4]): row[-1] for row in parameters.dimensional_table().rows}
    assert rows.pop(("L₀", "200")) == "laksa"
    assert set(rows.values()) == {"both", "thesis"}
    assert [key[0] for key, sets in rows.items() if sets == "thesis"] == [
        "C_xα",
        "C_m0",
        "C_mα",
        "C_mq",
        "L₀",
    ]


def test_the_dimensionless_table_mixes_two_lengths():
    rows = {row[0]: row[-2:] for row in parameters.dimensionless_table().rows}
    assert rows["ν_W"] == ("no", "agrees")
    assert rows["y_A"] == rows["μ"] == ("no", "no")
    fine = [name for name, said in rows.items() if said == ("agrees", "no")]
    assert fine == ["ε_c", "ε_b", "x_A", "z_A", "i_x", "i_z"]


def test_R_1E_is_a_rotation_only_with_its_phi():
    right, *wrong = misprints.rotation_table().rows
    assert right[1] < ROUNDING
    assert right[3] < ROUNDING
    for row in wrong:
        assert row[1] > 0.05
        assert row[3] > 0.05


def test_every_misprint_is_one():
    for row in misprints.misprint_table().rows:
        if row[1] != "unit of I_x":  # printed in a unit that cannot be; the number is right
            assert row[2] != pytest.approx(row[3], rel=1e-3), row


def test_frames_are_where_their_definitions_say():
    found = coordinate_frames_geometry.frame_geometry()
    points, axes = found.points, found.axes
    kite, q = LAKSA.kite, coordinate_frames_geometry.Q
    to_G = axes["B"] @ (points["G"] - points["O_2"])
    assert to_G == pytest.approx([-kite.x_A, 0.0, -kite.z_A], abs=ROUNDING)
    across = points["A₊"] - points["A₋"]
    assert across / np.linalg.norm(across) == pytest.approx(axes["2"][1], abs=ROUNDING)
    assert points["A₊"] @ axes["1"][0] == pytest.approx(0.0, abs=ROUNDING)  # π holds both lines
    assert points["A₋"] @ axes["1"][0] == pytest.approx(0.0, abs=ROUNDING)
    median = -points["O_2"] / np.linalg.norm(points["O_2"])
    assert np.arccos(median @ axes["2"][2]) == pytest.approx(
        coordinate_frames_geometry.DELTA, abs=1e-9
    )
    assert axes["1"] == pytest.approx(np.array(R_1E(q.phi, q.gamma)), abs=ROUNDING)


def test_the_scalar_equation_has_the_paper_s_root():
    """The numbers for the set laksa are those of the 2017 paper's equation, solved by others."""
    alpha, gamma, theta, tension = equilibrium.by_equation(LAKSA)
    angles = [degrees(angle) for angle in (alpha, gamma, theta)]
    assert angles == pytest.approx([7.746286, 22.882617, -15.136331], abs=5e-7)
    assert tension == pytest.approx(43.7845, abs=5e-5)


def test_models_stand_where_the_equation_says():
    """To 1e-9°: rounding in the engine's accelerations is some 1e-12 of g."""
    rows = equilibrium.equilibrium_table().rows
    assert len(rows) == 16
    for row in rows:
        of_equation = next(r for r in rows if r[:2] == row[:2])
        assert row[3:6] == pytest.approx(of_equation[3:6], abs=1e-9)
        assert row[6:8] == pytest.approx(of_equation[6:8], abs=1e-7)


def test_forces_and_moments_of_an_instant_add_up():
    table, (force, moment) = post_processing.post_processing_table()
    assert force < 1e-10  # N; of forces of some 100 N
    assert moment < 1e-10  # N m
    assert {row[0] for row in table.rows} == {12, 13, 14}
