"""The trail: wide and bright where it is new, its colour what the lines pulled there."""

import numpy as np
import pygame
import pytest
from numpy.typing import NDArray

from kitemj.drawing.history import History
from kitemj.drawing.recorded_traces import RecordedTraces
from kitemj.drawing.tensions import Scale
from kitemj.drawing.trail import HEAT, paint_trail, pull_colours
from kitemj.recording.file import read_recording
from kitemj.recording.track import Track
from tests.recording.flights import recorded
from tests.scene.motions import EQUILIBRIUM, LAKSA, motion_at
from tests.support import pulling


def ribbon(colours: NDArray[np.float64] | None = None) -> NDArray[np.uint8]:
    """A trail from left to right over black: (columns, rows, 3)."""
    surface = pygame.Surface((200, 40))
    places = np.stack([np.linspace(10.0, 190.0, 61), np.full(61, 20.0)], axis=1)
    paint_trail(surface, places, np.full(61, True), surface.get_rect(), 10.0, colours)
    return pygame.surfarray.array3d(surface)


def test_it_grows_and_brightens_towards_the_kite() -> None:
    image = ribbon().astype(int).sum(axis=2)
    bright = [image[x].max() for x in range(30, 190, 20)]
    assert bright == sorted(bright)
    assert bright[-1] > 3 * bright[0]
    wide = [(image[x] > 0.5 * image[x].max()).sum() for x in (40, 110, 180)]
    assert wide == sorted(wide)
    assert wide[-1] > 1.5 * wide[0]


def test_its_colour_is_the_pull_by_the_scale_of_the_bars() -> None:
    """As the square root of the pull, and no further than the bars' end."""
    scale = Scale(4.0, 100.0)
    pulls = np.array([-3.0, 0.0, 6.25, 25.0, 56.25, 100.0, 900.0])
    found = pull_colours(pulls, scale)
    assert found == pytest.approx(HEAT[[0, 0, 1, 2, 3, 4, 4]])
    image = ribbon(pull_colours(np.linspace(100.0, 0.0, 61), scale)).astype(int)
    red, _, blue = image[40, 20]
    assert red > 2 * blue
    red, _, blue = image[188, 20]
    assert blue > 2 * red


def test_what_is_remembered_is_the_mean_pull_of_the_lines() -> None:
    history = History(LAKSA)
    for i, pulls in enumerate([(10.0, 30.0), (0.0, 100.0)]):
        history.add(0.1 * i, pulling(motion_at(LAKSA, EQUILIBRIUM), *pulls)._replace(t=0.1 * i))
    assert history.traces(0.1).pull == pytest.approx(np.array([20.0, 50.0]))


def test_a_recording_has_the_pulls_of_its_motions(tmp_path) -> None:
    recording = read_recording(recorded(tmp_path / "x.arrows", 120))
    track = Track(recording)
    traces = RecordedTraces(recording, track).at(100)
    motions = [track.motion(row) for row in range(1, 101, 3)]
    assert traces.pull is not None
    assert len(traces.pull) == len(traces.trail)
    told = [np.mean(motion.tensions) for motion in motions if motion]
    assert traces.pull[-len(told) :] == pytest.approx(np.array(told))
