"""Films and windows of recordings: what they show, and what they refuse."""

from contextlib import nullcontext
from dataclasses import replace
from math import atan2, degrees
from pathlib import Path

import av
import numpy as np
import pygame
import pytest

import kitemj
from kitemj.cli import main
from kitemj.cockpit import film_sources, film_title, filming
from kitemj.cockpit.film_sources import RecordingSource
from kitemj.cockpit.film_title import with_title
from kitemj.cockpit.filming import FilmStyle, film
from kitemj.cockpit.parallel_painting import Stage, painted
from kitemj.cockpit.replay_player import SPEEDS, Player
from kitemj.cockpit.replay_slider import HEIGHT, HINT, hints
from kitemj.cockpit.replay_window import ReplayWindow
from kitemj.cockpit.screens import Window, display_found
from kitemj.controls.settings import Settings
from kitemj.controls.stick import PersonStick
from kitemj.drawing.picture import Picture
from kitemj.drawing.recorded_traces import RecordedTraces
from kitemj.drawing.text import width
from kitemj.flight.limits import SLACK, TWIST, touches_ground
from kitemj.pilots.manoeuvres import Land
from kitemj.recording.file import read_recording
from kitemj.recording.replay import replay
from kitemj.recording.track import Track
from kitemj.scene.eye import Eye
from tests.recording.flights import LOOPS, live_flight, recorded, restless

SMALL = (320, 180)
SIZE = f"{SMALL[0]}x{SMALL[1]}"
ROWS = range(0, 301, 10)
WCAG = 4.5


def luminance(rgb):
    """Relative luminance of sRGB (..., 3) by WCAG 2.1."""
    c = rgb / 255
    linear = np.where(c <= 0.04045, c / 12.92, ((c + 0.055) / 1.055) ** 2.4)
    return linear @ [0.2126, 0.7152, 0.0722]


ANSWER = 0.25
"""s; a slider that is felt to answer at once takes 0.1 s, measured: 0.06 s at 1280 x 720."""


@pytest.fixture(scope="module")
def file(tmp_path_factory):
    """3 s of a kite that loops, and 3 s more after a restart."""
    path = tmp_path_factory.mktemp("recordings") / "kite.arrows"
    return recorded(path, 300, LOOPS, restless(2, ell=0.1, hold=90), episodes=2)


def frames_of(path):
    with av.open(str(path)) as container:
        return [frame.to_ndarray(format="rgb24") for frame in container.decode(video=0)]


class Reel(nullcontext):
    """Takes the place of painter and film: keeps the shots, writes nothing."""

    def __init__(self):
        super().__init__()
        self.motions, self.cameras, self.written = [], [], []

    def take(self, stage, shots, workers):
        for (shot,) in shots:
            self.motions.append(shot.motion)
            self.cameras.append(shot.camera)
        return (frame for frame in ())

    def add(self, frame):
        self.written.append(frame)

    def __call__(self, *words):
        return self

    @property
    def frames(self):
        return len(self.motions)


@pytest.mark.parametrize("by", ["call", "command"])
def test_a_film_shows_the_rows_that_were_simulated_for_it(by, monkeypatch, tmp_path):
    """Twice as fast at 20 frames/s is a frame for each 0.1 s of the flight, and a row for each."""
    reel, rows = Reel(), []
    monkeypatch.setattr(filming, "painted", reel.take)
    monkeypatch.setattr(filming, "Film", reel)
    simulated = film_sources.flight_of_simulation
    note = lambda flown: rows.extend(flown.motions) or simulated(flown)  # noqa: E731
    monkeypatch.setattr(film_sources, "flight_of_simulation", note)
    tables, path = {"set": "sport", "duration": 0.5}, tmp_path / "a.mp4"
    if by == "call":
        kitemj.film(tables, path, model="lagrange", rate=20, speed=2.0)
    else:
        (tmp_path / "a.toml").write_text('set = "sport"\nduration = 0.5\n', encoding="utf-8")
        words = ["--rate", "20", "--speed", "2", "--output", str(path), "--model", "lagrange"]
        assert main(["film", str(tmp_path / "a.toml"), *words]) == 0
    assert [motion.t for motion in reel.motions] == pytest.approx([0.0, 0.1, 0.2, 0.3, 0.4, 0.5])
    assert reel.motions == rows, "no motion between two rows"


def test_a_film_has_the_frames_that_its_words_ask_for(file, tmp_path):
    words = ["film", str(file), "--size", SIZE, "--from", "1", "--to", "2.5", "--rate", "20"]
    assert main([*words, "--speed", "2", "--output", str(tmp_path / "a.mp4")]) == 0
    frames = frames_of(tmp_path / "a.mp4")
    assert len(frames) == 1.5 / 2 * 20 + 1
    assert frames[0].shape == (*SMALL[::-1], 3)
    assert np.abs(frames[0].astype(int) - frames[-1]).max() > 50  # the kite moved


def test_a_gif_by_its_name(file, tmp_path):
    words = ["film", str(file), "--size", SIZE, "--to", "0.5", "--rate", "10"]
    assert main([*words, "--output", str(tmp_path / "a.gif")]) == 0
    assert (tmp_path / "a.gif").read_bytes().startswith(b"GIF89a")
    assert len(frames_of(tmp_path / "a.gif")) == 6


@pytest.mark.parametrize("turn", [30.0, -90.0])
def test_the_eye_of_an_orbit_goes_round_to_the_right_by_so_many_degrees(
    file, monkeypatch, tmp_path, turn
):
    reel = Reel()
    monkeypatch.setattr(filming, "painted", reel.take)
    monkeypatch.setattr(filming, "Film", reel)
    words = ["--view", "orbit", "--turn", str(turn), "--rate", "10", "--to", "1"]
    assert main(["film", str(file), *words, "--output", str(tmp_path / "a.mp4")]) == 0
    assert len(reel.cameras) == 11
    # it looks along the wind, which blows along -x, and from the right, which is -y, to the left
    azimuths = [degrees(atan2(c.forward.y, -c.forward.x)) for c in reel.cameras]
    assert np.diff(np.unwrap(azimuths, period=360)) == pytest.approx(turn / 10, abs=ASIDE)
    right = reel.cameras[1].position.y < reel.cameras[0].position.y
    assert right == (turn > 0)


ASIDE = 0.01
"""deg; what is left of a direction when the eye looks at a kite that moved."""


def test_a_simulated_flight_has_the_trail_of_what_was_shown_before():
    source = film_sources.film_source({"set": "sport", "duration": 1.0}, interval=0.1)
    trails = [source.shot(t, 1.0).readings.traces.trail for t in (0.5, 1.0, 0.2)]
    assert [len(trail) for trail in trails] == [6, 11, 3], "back in time too"
    assert (trails[2] == trails[1][:3]).all()


def test_a_title_comes_and_goes_in_the_first_three_seconds(file, monkeypatch, tmp_path):
    reel, grey = Reel(), np.full((180, 320, 3), 120, np.uint8)
    monkeypatch.setattr(filming, "painted", lambda stage, shots, w: (grey for shot in shots))
    monkeypatch.setattr(filming, "Film", reel)
    words = ["--title", "Figures of eight", "--rate", "10", "--output", str(tmp_path / "a.mp4")]
    assert main(["film", str(file), *words, "--to", "4"]) == 0
    written = [(frame != grey).any(axis=(1, 2)) for frame in reel.written]
    assert len(written) == 41
    assert not written[0].any(), "it fades in"
    assert all(rows.any() for rows in written[1:30])
    assert not any(rows.any() for rows in written[30:])
    half, whole = (reel.written[i].max() for i in (2, 15))
    assert 120 < half < whole == 255, "white letters"
    assert not any(rows[:60].any() for rows in written), "nothing over the kite in the sky"


@pytest.mark.parametrize("size", [(640, 360), (1280, 720), (960, 960)])
def test_a_title_is_read_over_the_whitest_cloud(monkeypatch, size):
    """WCAG 2.1: 4.5 to 1, at every pixel of the text's lines."""
    lines = []
    monkeypatch.setattr(film_title, "put", lambda *given: lines.append(given[1:5]))
    cloud = np.full((size[1], size[0], 3), 255, np.uint8)
    shaded = with_title(cloud, "A title that is longer than one line, and still to be read at once")
    assert len(lines) == 2
    for text, x, y, height in lines:
        rows = slice(int(y - 0.7 * height), int(y + 0.9 * height))
        behind = shaded[rows, int(x) : int(x) + width(text, height)]
        assert behind.shape[1] > 50
        assert 1.05 / (luminance(behind).max() + 0.05) > WCAG


def test_a_still_is_the_frame_of_that_moment(file, tmp_path):
    words = ["film", str(file), "--size", SIZE, "--still", "2.2"]
    assert main([*words, "--output", str(tmp_path / "a.png")]) == 0
    image = pygame.image.load(str(tmp_path / "a.png"))
    assert image.get_size() == SMALL
    source = RecordingSource(read_recording(file))
    with Picture(source.parameters, *SMALL, "film") as picture:
        frame = picture.paint(*source.shot(2.2, 1.0)[:3])
    np.testing.assert_array_equal(pygame.surfarray.array3d(image).swapaxes(0, 1), frame)


def test_without_instruments_nothing_is_written_over_the_view(file, tmp_path):
    words = ["film", str(file), "--size", SIZE, "--still", "1", "--instruments", "none"]
    assert main([*words, "--output", str(tmp_path / "bare.png")]) == 0
    assert main([*words[:-2], "--output", str(tmp_path / "full.png")]) == 0
    bare, full = (
        pygame.surfarray.array3d(pygame.image.load(str(tmp_path / f"{name}.png"))).astype(int)
        for name in ("bare", "full")
    )
    corner = np.s_[-70:, -45:]
    assert np.abs(bare - full)[corner].max() > 50


def test_two_stand_side_by_side(file, tmp_path):
    words = ["film", str(file), str(file), "--size", "640x180", "--still", "1"]
    assert main([*words, "--output", str(tmp_path / "two.png")]) == 0
    both = pygame.surfarray.array3d(pygame.image.load(str(tmp_path / "two.png")))
    assert both.shape == (640, 180, 3)
    np.testing.assert_array_equal(both[:319], both[320:639])
    assert main([*words, "--output", str(tmp_path / "no.png"), "--model", "mujoco,lagrange"]) == 2


def test_two_models_of_one_scenario(tmp_path):
    scenario = Path(__file__).parent.parent.parent / "scenarios" / "steer_80m.toml"
    words = ["film", str(scenario), "--size", "640x180", "--still", "1"]
    words += ["--model", "mujoco,newton-euler", "--output", str(tmp_path / "two.png")]
    assert main(words) == 0
    assert (tmp_path / "two.png").stat().st_size > 1000


def test_frames_of_two_processes_are_those_of_one(file):
    source = RecordingSource(read_recording(file))
    stage = Stage((source.parameters,), ("",), SMALL, "pilot", "engineer")
    eye, style = Eye(source.parameters), FilmStyle(view="pilot")
    shots = [[filming._seen(source.shot(0.3 * i, 1.0), eye, style)] for i in range(12)]
    alone = [frame.copy() for frame in painted(stage, shots, 1)]
    together = [frame.copy() for frame in painted(stage, shots, 2)]
    np.testing.assert_array_equal(alone, together)


def test_ctrl_c_leaves_a_complete_film(file, tmp_path, monkeypatch):
    source, seen = RecordingSource(read_recording(file)), []

    def shot(t, speed):
        seen.append(t)
        if len(seen) > 5:
            raise KeyboardInterrupt
        return RecordingSource.shot(source, t, speed)

    monkeypatch.setattr(source, "shot", shot)
    film([source], tmp_path / "a.mp4", FilmStyle(SMALL), end=2.0)
    assert len(frames_of(tmp_path / "a.mp4")) == 5


@pytest.mark.parametrize(
    ("words", "reason"),
    [
        (["--output", "a.avi"], "ends with .mp4, .webp or .gif"),
        (["--output", "a.png"], "ends with .mp4, .webp or .gif"),
        (["--output", "a.mp4", "--still", "1"], "ends with .png"),
        (["--output", "a.png", "--still", "99"], "--still must be"),
        (["--output", "a.mp4", "--from", "99"], "--from must be"),
        (["--output", "a.mp4", "--speed", "0"], "--speed must be"),
        (["--output", "a.gif", "--rate", "60"], "1 to 50"),
        (["--output", "a.mp4", "--turn", "9"], "--turn is for the --view orbit"),
        (["--output", "a.mp4", "--view", "orbit", "--turn", "-999"], "--turn must be within 360"),
        (["--output", "a.mp4", "--size", "321x181"], "must be even"),
        (["--output", "a.mp4", "--model", "laksa"], "there is no model"),
    ],
)
def test_bad_words_are_a_sentence(file, tmp_path, monkeypatch, capsys, words, reason):
    monkeypatch.chdir(tmp_path)
    assert main(["film", str(file), *words]) == 2
    said = capsys.readouterr().err
    assert reason in said
    assert said.count("\n") == 1
    assert list(tmp_path.iterdir()) == []


def test_an_output_that_exists_is_kept(file, tmp_path, capsys):
    precious = tmp_path / "a.mp4"
    precious.write_bytes(b"precious")
    assert main(["film", str(file), "--output", str(precious)]) == 2
    assert "exists" in capsys.readouterr().err
    assert precious.read_bytes() == b"precious"


def test_player_stops_at_the_end_and_begins_anew():
    player = Player(10.0)
    player.advance(3.0)
    assert player.t == 3.0
    player.change_speed(1)
    player.advance(1.0)
    assert (player.t, player.speed) == (5.0, 2.0)
    player.advance(60.0)
    assert (player.t, player.playing) == (10.0, False)
    player.toggle()
    assert (player.t, player.playing) == (0.0, True)
    for _ in range(20):
        player.change_speed(-1)
    assert player.speed == SPEEDS[0]


@pytest.fixture
def window(file, monkeypatch):
    monkeypatch.setenv("SDL_VIDEODRIVER", "dummy")
    assert display_found()
    recording = read_recording(file)
    window = Window(640, 360 + HEIGHT, "test", PersonStick(Settings(), recording.parameters))
    with Picture(recording.parameters, 640, 360) as picture:
        yield ReplayWindow(recording, replay(recording, "lagrange"), picture, window)
    window.close()
    pygame.display.quit()


def press(window, key, mod=0):
    pygame.event.post(pygame.event.Event(pygame.KEYDOWN, key=key, mod=mod))
    window.poll()
    window.paint()


def test_window_answers_keys_and_mouse(window):
    player = window.player
    press(window, pygame.K_SPACE)
    assert not player.playing
    press(window, pygame.K_RIGHT)
    press(window, pygame.K_RIGHT, pygame.KMOD_LSHIFT)
    assert player.t == pytest.approx(1.01)
    before = pygame.surfarray.array3d(pygame.display.get_surface())
    press(window, pygame.K_v)
    assert window.view == "chase"
    after = pygame.surfarray.array3d(pygame.display.get_surface())
    assert np.abs(before.astype(int) - after).mean() > 5
    press(window, pygame.K_END)
    assert player.t == player.duration
    # in the middle of the slider, which lies between button and numbers
    middle = (48 + (640 - 250 - 48) // 2, 360 + 24)
    pygame.event.post(pygame.event.Event(pygame.MOUSEBUTTONDOWN, button=1, pos=middle))
    window.poll()
    assert player.t == pytest.approx(player.duration / 2, rel=0.01)
    press(window, pygame.K_ESCAPE)
    assert window.leaving


def test_no_display_is_said(file, monkeypatch, capsys):
    for name in ("DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER"):
        monkeypatch.delenv(name, raising=False)
    pygame.display.quit()
    assert main(["replay", str(file)]) == 0
    assert "kitemj film" in capsys.readouterr().out


def test_a_twist_is_an_alarm_when_it_was_one(file):
    """Of lines that may not be turned by more than half of what this flight turns them."""
    recording = read_recording(file)
    twists = np.array([RecordedTraces(recording, Track(recording)).at(k).twist for k in ROWS])
    parameters = recording.parameters
    limits = parameters.limits._replace(
        twist_max=np.abs(twists).max() / 2, alpha_stall=1e9, beta_max=1e9, tension_max=1e9
    )
    strict = replace(recording, parameters=parameters._replace(limits=limits))
    traces = RecordedTraces(strict, Track(strict))
    slack = recording.columns["slack"]
    for k, twist in zip(ROWS, twists, strict=True):
        alarm = traces.at(k).alarm
        if abs(twist) > limits.twist_max and not slack[k]:
            assert alarm.departure.limit is TWIST
            assert alarm.age == 0.0
        else:
            assert alarm is None or alarm.age > 0.0 or alarm.departure.limit is SLACK


def test_the_reference_of_another_model_is_there_until_a_line_is_slack(file):
    recording = read_recording(file)
    again = replay(recording, "lagrange")
    source = RecordingSource(recording, again)
    slack = np.flatnonzero(recording.columns["slack"])
    assert slack[0] > 10
    shot = source.shot(0.1, 1.0)
    assert shot.reference is not None
    assert shot.readings.gap == pytest.approx(again.gaps[10])
    late = source.shot((slack[0] + 1) * 0.01, 1.0)
    assert late.reference is None
    assert late.readings.gap is None


def test_the_page_of_keys_stops_the_player(window, monkeypatch):
    press(window, pygame.K_F1)
    ticks = iter([100, 100])
    monkeypatch.setattr(window, "poll", lambda: setattr(window, "leaving", not next(ticks, 0)))
    shown = []
    monkeypatch.setattr(window, "paint", lambda: shown.append(window.player.t))
    window.run()
    assert shown == [0.0, 0.0, 0.0]
    window.help, window.leaving, ticks = False, False, iter([100, 100])
    window.run()
    assert shown[-1] > 0.0


@pytest.mark.parametrize("room", [100, 500, 2000])
def test_hints_fit_and_begin_with_the_page_of_all_keys(room):
    line = hints(room)
    assert line.startswith("F1: all keys")
    assert width(line, HINT) <= room
    assert ("Esc: leave" in line) == (room >= 500)
    assert ("full screen" in line) == (room == 2000)


def test_a_flight_after_a_restart_has_no_alarm_of_the_one_before(file):
    recording = read_recording(file)
    traces, restart = RecordedTraces(recording, Track(recording)), recording.episodes[1].start
    assert recording.columns["slack"][:restart].any()
    assert traces.at(restart - 1).alarm is not None
    assert traces.at(restart).alarm is None


def test_a_landing_looks_the_same_again(tmp_path):
    flight, pilot = live_flight({"set": "sport", "duration": 30.0}, record=tmp_path / "a"), Land()
    while not touches_ground(flight.parameters, flight.result.motion) and flight.ticks < 2000:
        flight.tick(pilot.command(flight.result.motion))
    flight.close("landed")
    source = RecordingSource(read_recording(tmp_path / "a"))
    assert source.shot(source.duration - 0.01, 1.0).readings.touch is None
    touch = source.shot(source.duration, 1.0).readings.touch
    assert touch is not None
    assert touch.gentle
