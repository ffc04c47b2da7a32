"""Painting in processes of their own, one of which may be lost."""

import numpy as np
import pytest

from kitemj.cockpit.film_sources import film_source
from kitemj.cockpit.parallel_painting import Painter, Painters, Shot, Stage, painted
from kitemj.controls.actions import PANELS
from kitemj.drawing.alarms import Alarm
from kitemj.drawing.history import CHART_COLUMNS, Traces
from kitemj.errors import NoGraphics
from kitemj.flight.limits import SLACK, Departure

SOURCE = film_source({"set": "sport", "duration": 0.1})
SIZE = (1280, 360)
STAGE = Stage((SOURCE.parameters,), (SOURCE.caption,), (320, 180), "chase", "engineer")
SHOTS = [[SOURCE.shot(t, 1.0)] for t in (0.0, 0.1)]


def test_a_painter_that_is_lost_is_replaced_and_the_frame_is_the_same() -> None:
    here = list(painted(STAGE, SHOTS, workers=1))
    for edge, beside in (np.s_[:, :2], np.s_[:, 2:4]), (np.s_[-2:], np.s_[-4:-2]):
        assert here[0][edge].min(axis=2).mean() > 0.8 * here[0][beside].min(axis=2).mean()
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


def alarmed(shot: Shot) -> Shot:
    """The shot with an alarm."""
    alarm = Alarm(Departure(0.0, SLACK, "left -0.12 N, right 33.00 N"), 0.0)
    empty = np.empty((0, 3)), 0.0, np.full(CHART_COLUMNS, 0.0), np.full(CHART_COLUMNS, 0.0)
    return shot._replace(readings=shot.readings._replace(traces=Traces(*empty, alarm)))


def test_captions_stand_where_no_instrument_is() -> None:
    shot = alarmed(SHOTS[0][0])
    stage = Stage(
        (SOURCE.parameters,) * 2, ("sport: mujoco", "sport: lagrange"), SIZE, "side", "engineer"
    )
    with Painter(stage) as painter:
        for picture in painter._pictures:
            picture.shown = {*PANELS, "inset"}
        captioned = painter.paint([shot, shot])
        written = painter._pictures[0].paint(*shot[:3], "side")
        painter._pictures[0].depth = "none"
        bare = painter._pictures[0].paint(*shot[:3], "side")
    half = captioned[:, : SIZE[0] // 2 - 1]  # a line parts the two
    caption = (half != written[:, :-1]).any(axis=2)
    instruments = (written != bare).any(axis=2)[:, :-1]
    assert caption.sum() > 1000
    assert instruments.sum() > 1000
    assert not (caption & instruments).any()
