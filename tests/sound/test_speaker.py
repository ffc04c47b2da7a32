"""The loudspeaker: chunks follow one another, and no device is never in the way."""

import time

import numpy as np
import pygame
import pytest

from kitemj.sound.hearing import SILENCE, Heard
from kitemj.sound.speaker import BUFFER, Speaker
from kitemj.sound.synthesis import CHUNK

CALM = Heard(8.0, 0.2, 0.2, 0.0, 0.4)


class Channel:
    """Takes chunks; as they come the kite changes, and falls silent after `most`."""

    def __init__(self, speaker, most):
        self.speaker, self.most, self.chunks = speaker, most, []

    def get_busy(self):
        return bool(self.chunks)

    def get_queue(self):
        return None

    def play(self, sound):
        self.queue(sound)

    def queue(self, sound):
        self.chunks.append(np.array(pygame.sndarray.array(sound)))
        louder = CALM._replace(airspeed=8.0 + len(self.chunks), right=0.8)
        self.speaker.hear(louder if len(self.chunks) < self.most else SILENCE)


@pytest.fixture
def speaker(monkeypatch):
    monkeypatch.setenv("SDL_AUDIODRIVER", "dummy")
    speaker = Speaker()
    yield speaker
    speaker.close()
    pygame.mixer.quit()


def test_chunks_lead_from_silence_to_silence_without_a_jump(speaker):
    channel = speaker._wind = Channel(speaker, 5)
    speaker.hear(CALM)
    while len(channel.chunks) < 6:
        time.sleep(0.01)
    speaker.close()
    assert len(channel.chunks) == 6, "nothing is made while all is silent"
    whole = np.concatenate(channel.chunks).astype(float)
    steps = np.abs(np.diff(whole, axis=0)).max(axis=1)
    edges = np.arange(CHUNK - 1, len(steps), CHUNK)
    assert steps[edges].max() <= np.delete(steps, edges).max()
    assert np.abs(whole[[0, -1]]).max() <= 1


class Forgetful(Channel):
    """Takes the second chunk just as the first one ends, and so never plays it."""

    def get_busy(self):
        return len(self.chunks) not in (0, 2)

    def get_queue(self):
        return "a chunk that is never played" if len(self.chunks) == 2 else None

    def queue(self, sound):
        super().queue(sound)
        if len(self.chunks) > 2:
            self.speaker.hear(SILENCE)


def test_a_chunk_that_the_system_lost_is_not_waited_for(speaker):
    channel = speaker._wind = Forgetful(speaker, 9)
    speaker.hear(CALM)
    until = time.monotonic() + 10.0
    while len(channel.chunks) < 3 and time.monotonic() < until:
        time.sleep(0.01)
    assert len(channel.chunks) >= 3
    assert np.abs(channel.chunks[2][0]).max() <= 1, "it begins from silence, without a click"


def test_a_chunk_is_whole_buffers_of_the_system():
    """SDL leaves the rest of a buffer silent where a sound ends within it."""
    assert CHUNK % BUFFER == 0


def test_without_a_device_it_is_silent_and_says_nothing(monkeypatch, capfd):
    pygame.mixer.quit()
    monkeypatch.setenv("SDL_AUDIODRIVER", "alsa")
    monkeypatch.setenv("ALSA_CONFIG_PATH", "/nowhere")
    speaker = Speaker()
    speaker.hear(CALM)
    speaker.thud(5.0)
    speaker.close()
    assert speaker._thread is None
    assert capfd.readouterr() == ("", "")
