"""Painting in processes of their own, one of which may be lost."""

import numpy as np
import pytest

from kitemj.cockpit.film_sources import film_source
from kitemj.cockpit.parallel_painting import Painters, Stage, painted
from kitemj.errors import NoGraphics

SOURCE = film_source({"set": "sport", "duration": 0.1})
STAGE = Stage((SOURCE.parameters,), (SOURCE.caption,), (320, 180), "chase", "engineer")
SHOTS = [[SOURCE.shot(t, 1.0)] for t in (0.0, 0.1)]


def test_a_painter_that_is_lost_is_replaced_and_the_frame_is_the_same() -> None:
    here = list(painted(STAGE, SHOTS, workers=1))
    with Painters(STAGE, 1) as painters:
        painters._children[0].kill()
        assert np.array_equal(painters.paint(SHOTS[0]), here[0])
        assert np.array_equal(painters.paint(SHOTS[1]), here[1])


def test_painters_that_are_lost_again_and_again_are_a_sentence(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def lost(*given: object) -> None:
        raise EOFError

    with Painters(STAGE, 1) as painters:
        monkeypatch.setattr(painters, "_painted", lost)
        with pytest.raises(NoGraphics, match="ended from outside, twice"):
            painters.paint(SHOTS[0])
