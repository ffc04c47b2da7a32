"""The display: frames of the flight that was flown, or a sentence where none can be painted."""

import numpy as np
import pygame
import pytest

from kitemj.controls.actions import VIEWS
from kitemj.drawing.picture import Picture
from kitemj.errors import NoGraphics
from thesis import display
from thesis.answers import dangling
from thesis.display import CAPTIONS, SIZE, section
from thesis.section import Verdict

SHORT = 0.3


def test_every_view_is_painted_and_no_two_are_the_same(tmp_path, monkeypatch):
    try:
        Picture(display.scenario_of({"set": "thesis", "duration": 1.0}, "test").parameters).close()
    except NoGraphics as reason:
        pytest.skip(str(reason))
    monkeypatch.setattr(display, "SECONDS", SHORT)
    found = section(tmp_path)
    assert found.answers == display.ANSWERS
    assert not dangling(found)
    assert [d.name for d in found.drawings] == [f"display_{n}" for n in ("cockpit", *VIEWS)]
    frames = [pygame.image.load(d.figure) for d in found.drawings]
    pixels = [pygame.surfarray.array3d(frame) for frame in frames]
    assert all(frame.get_size() == SIZE for frame in frames)
    for i, one in enumerate(pixels):
        assert one.std() > 20  # not one colour
        assert all(np.any(one != other) for other in pixels[:i])


def test_every_view_has_a_caption():
    assert set(CAPTIONS) == set(VIEWS)


def test_without_opengl_a_sentence_stands_in_place_of_frames(tmp_path, monkeypatch):
    def none(*_):
        raise NoGraphics("cannot draw: install what is missing")

    monkeypatch.setattr(display, "Picture", none)
    found = section(tmp_path)
    assert not found.drawings
    assert not dangling(found)
    assert "install what is missing" in found.here[0]
    assert [a.item for a in found.answers] == [a.item for a in display.ANSWERS]
    assert {a.verdict for a in found.answers} == {Verdict.NOT_APPLICABLE}
