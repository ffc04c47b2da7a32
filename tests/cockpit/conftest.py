"""A window that no screen shows."""

from collections.abc import Iterator

import pygame
import pytest

from kitemj.cockpit.screens import Window, display_found
from kitemj.controls.settings import Settings
from kitemj.controls.stick import PersonStick
from kitemj.physics.parameter_files import parameter_set

SIZE = (640, 360)
"""px; of its picture."""


@pytest.fixture
def window(monkeypatch: pytest.MonkeyPatch) -> Iterator[Window]:
    """A person's window at the kite `sport`."""
    monkeypatch.setenv("SDL_VIDEODRIVER", "dummy")
    monkeypatch.setenv("SDL_AUDIODRIVER", "dummy")
    assert display_found()
    window = Window(*SIZE, "test", PersonStick(Settings(), parameter_set("sport")))
    yield window
    window.close()
    pygame.display.quit()
