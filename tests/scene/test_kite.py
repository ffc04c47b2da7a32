"""The shape of the kite and of its lines."""

from itertools import pairwise

import numpy as np
import pytest

from kitemj.physics.vectors import Vector, minus, norm
from kitemj.scene.canopy import canopy, surface_point
from kitemj.scene.scene import hanging
from tests.scene.motions import LAKSA


def test_a_hanging_line_is_as_long_as_it_is() -> None:
    end, length = Vector(-30.0, 5.0, -50.0), 60.0
    points = hanging(end, length)
    drawn = sum(norm(minus(b, a)) for a, b in pairwise(points))
    assert points[0] == Vector(0.0, 0.0, 0.0)
    assert points[-1] == pytest.approx(end)
    assert drawn == pytest.approx(length, rel=0.01)
    assert max(p.z for p in hanging(Vector(-30.0, 0.0, -1.0), 40.0)) <= 0.0


def test_the_mean_chord_and_the_span_are_the_kites() -> None:
    points = np.concatenate([mesh.vertices for mesh in canopy(LAKSA.kite).values()])
    # the arched section stands upright on the arch: its thickness adds a little at the tips
    assert np.ptp(points[:, 1]) == pytest.approx(LAKSA.kite.span, rel=0.03)
    across = np.linspace(-1, 1, 401)
    nose, tail = ([surface_point(LAKSA.kite, a, s).x for a in across] for s in (0.0, 1.0))
    assert np.mean(np.subtract(nose, tail)) == pytest.approx(LAKSA.kite.chord, rel=0.01)


def test_the_canopy_is_closed_and_faces_outwards() -> None:
    for name, mesh in canopy(LAKSA.kite).items():
        edges = np.concatenate(
            [mesh.faces[:, [0, 1]], mesh.faces[:, [1, 2]], mesh.faces[:, [2, 0]]]
        )
        assert {tuple(e) for e in edges} == {tuple(e[::-1]) for e in edges}, name
        a, b, c = (mesh.vertices[mesh.faces[:, i]] for i in range(3))
        assert np.einsum("ij,ij->i", a, np.cross(b, c)).sum() > 0, name
