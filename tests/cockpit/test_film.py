"""The film file: complete or not there, readable, refused with a sentence."""

import os
import signal
from fractions import Fraction
from pathlib import Path
from typing import Any

import av
import numpy as np
import pytest
from numpy.typing import NDArray
from PIL import Image

from kitemj.cockpit import gif_colours
from kitemj.cockpit.film import Film
from kitemj.errors import InputError
from kitemj.signals import orderly

WIDTH, HEIGHT = 64, 48


def frame(level: int) -> NDArray[np.uint8]:
    return np.full((HEIGHT, WIDTH, 3), (level, 128, 255 - level), np.uint8)


def frames_of(path: Path) -> list[NDArray[np.uint8]]:
    with av.open(str(path)) as container:
        return [
            np.asarray(f.to_ndarray(format="rgb24"), np.uint8) for f in container.decode(video=0)
        ]


def test_every_frame_comes_back_in_its_order_and_colour(tmp_path: Path) -> None:
    levels = range(20, 220, 10)
    with Film(tmp_path / "kite.mp4", WIDTH, HEIGHT, rate=25) as film:
        for level in levels:
            film.add(frame(level))
    with av.open(str(tmp_path / "kite.mp4")) as container:
        stream = container.streams.video[0]
        assert stream.codec_context.name == "h264"
        assert stream.average_rate == Fraction(25)
        assert stream.codec_context.pix_fmt == "yuv420p"
    pictures = frames_of(tmp_path / "kite.mp4")
    assert len(pictures) == len(levels)
    for picture, level in zip(pictures, levels, strict=True):
        # 12 of 255: what the coarser colours of yuv420p and the compression may change
        assert np.abs(picture.mean(axis=(0, 1)) - (level, 128, 255 - level)).max() < 12


@pytest.mark.parametrize(("kind", "rate"), [("webp", 25), ("gif", 20)])
def test_a_film_for_pages_has_all_frames_in_their_colours_and_begins_anew(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, kind: str, rate: int
) -> None:
    monkeypatch.setattr(gif_colours, "RUN", 4)
    levels = range(20, 220, 20)
    with Film(tmp_path / f"kite.{kind}", WIDTH, HEIGHT, rate) as film:
        for level in levels:
            film.add(frame(level))
    shown: Any
    with Image.open(tmp_path / f"kite.{kind}") as shown:
        assert (shown.n_frames, shown.size) == (len(levels), (WIDTH, HEIGHT))
        assert shown.info["loop"] == 0  # for ever
        for number, level in enumerate(levels):
            shown.seek(number)
            shown.load()
            assert shown.info["duration"] == 1000 // rate
            # 12 of 255: what compression, and the colours of yuv420p or a palette, may change
            picture = np.asarray(shown.convert("RGB"), float)
            assert np.abs(picture.mean(axis=(0, 1)) - (level, 128, 255 - level)).max() < 12


def test_a_gif_holds_no_more_than_a_run_of_frames(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(gif_colours, "RUN", 4)
    colours = gif_colours.GifColours(WIDTH, HEIGHT, 10)
    done = [len(colours.add(frame(20 * number))) for number in range(10)]
    assert done == [0, 0, 0, 4, 0, 0, 0, 4, 0, 0]
    assert len(colours.rest()) == 2
    assert colours.rest() == []


def test_a_thin_red_line_in_a_wide_sky_is_red_in_a_gif(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Few colours for a sky of many, in which the line has one pixel of two thousand."""
    monkeypatch.setattr(gif_colours, "COLOURS", 16)
    dice, height, width = np.random.default_rng(1), 120, 160
    with Film(tmp_path / "kite.gif", width, height, 10) as film:
        for _ in range(10):
            cloud = dice.uniform(0.0, 1.0, (height, width, 1))
            sky = cloud * (255, 255, 255) + (1 - cloud) * (20, 60, 150)
            sky[40:50, 80] = (200, 20, 30)
            film.add(sky.astype(np.uint8))
    shown: Any
    with Image.open(tmp_path / "kite.gif") as shown:
        shown.seek(5)
        red, green, blue = np.asarray(shown.convert("RGB"), float)[40:50, 80].mean(axis=0)
    # 40 of 255: an eye still calls that red the same
    assert abs(red - 200) < 40
    assert max(green - 20, blue - 30) < 40


def test_the_index_lies_in_front(tmp_path: Path) -> None:
    with Film(tmp_path / "kite.mp4", WIDTH, HEIGHT) as film:
        film.add(frame(10))
    data = (tmp_path / "kite.mp4").read_bytes()
    assert 0 < data.index(b"moov") < data.index(b"mdat")


def test_the_name_appears_only_when_the_film_is_complete(tmp_path: Path) -> None:
    path = tmp_path / "kite.mp4"
    film = Film(path, WIDTH, HEIGHT)
    film.add(frame(1))
    assert not path.exists()
    film.close()
    film.close()
    assert [p.name for p in tmp_path.iterdir()] == ["kite.mp4"]


def test_ctrl_c_leaves_a_film_complete_up_to_then(tmp_path: Path) -> None:
    path = tmp_path / "kite.mp4"

    def filming() -> None:
        with Film(path, WIDTH, HEIGHT) as film:
            for _ in range(7):
                film.add(frame(99))
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        filming()
    assert len(frames_of(path)) == 7


@pytest.mark.skipif(os.name == "nt", reason="Windows has no such signals")
def test_a_signal_in_the_middle_of_a_frame_does_not_cut_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    film = Film(tmp_path / "kite.mp4", WIDTH, HEIGHT)

    class Interrupted:
        """A stream during whose work a signal comes."""

        def __init__(self, stream: Any) -> None:
            self.stream = stream

        def encode(self, picture: Any) -> Any:
            packets = self.stream.encode(picture)
            if film.frames == 60:  # the encoder holds back as many as 50
                os.kill(os.getpid(), signal.SIGTERM)
            return packets

    @orderly
    def filming(words: object) -> int:
        with film:
            for _ in range(100):
                film.add(frame(99))
        return 0

    monkeypatch.setattr(film, "_stream", Interrupted(film._stream))
    assert filming() == 128 + signal.SIGTERM
    assert film.frames == 61
    assert len(frames_of(film.path)) == 61


def test_without_a_frame_there_is_no_file(tmp_path: Path) -> None:
    with Film(tmp_path / "kite.mp4", WIDTH, HEIGHT):
        pass
    assert list(tmp_path.iterdir()) == []


def test_a_film_that_exists_is_kept_unless_told(tmp_path: Path) -> None:
    path = tmp_path / "kite.mp4"
    path.write_bytes(b"precious")
    with pytest.raises(InputError, match="exists; give another"):
        Film(path, WIDTH, HEIGHT)
    assert path.read_bytes() == b"precious"
    with Film(path, WIDTH, HEIGHT, overwrite=True) as film:
        film.add(frame(5))
        assert path.read_bytes() == b"precious"
    assert len(frames_of(path)) == 1


def test_a_place_that_cannot_be_written_is_a_sentence(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="there is no folder"):
        Film(tmp_path / "nowhere" / "kite.mp4", WIDTH, HEIGHT)
    (tmp_path / "folder.mp4").mkdir()
    with pytest.raises(InputError, match="is a folder"):
        Film(tmp_path / "folder.mp4", WIDTH, HEIGHT)


def test_a_folder_without_permission_is_a_sentence(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refused(*arguments: object, **options: object) -> None:
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(os, "open", refused)  # root may write everywhere
    with pytest.raises(InputError, match=r"Permission denied; choose another"):
        Film(tmp_path / "kite.mp4", WIDTH, HEIGHT)


@pytest.mark.parametrize(("width", "height"), [(63, 48), (64, 47), (0, 48)])
def test_a_size_that_h264_cannot_have_is_a_sentence(
    tmp_path: Path, width: int, height: int
) -> None:
    with pytest.raises(InputError, match="must be even"):
        Film(tmp_path / "kite.mp4", width, height)


def test_a_frame_of_another_size_is_a_sentence(tmp_path: Path) -> None:
    with Film(tmp_path / "kite.mp4", WIDTH, HEIGHT) as film:
        with pytest.raises(InputError, match="does not fit"):
            film.add(np.zeros((HEIGHT, WIDTH + 2, 3), np.uint8))
        film.add(frame(3))
    assert len(frames_of(tmp_path / "kite.mp4")) == 1
