"""The settings file: defaults, what is wrong with it in one sentence, and that nothing is lost."""

import tomllib

import pytest

from kitemj.controls.notices import Notices
from kitemj.controls.pad_layout import Layout, PadSource
from kitemj.controls.settings import (
    NEW_FILE,
    Feel,
    Invert,
    Settings,
    check_writable,
    read_settings,
    settings_of,
    settings_or_defaults,
    settings_path,
    write_layout,
)
from kitemj.errors import InputError
from kitemj.physics.shaping import StickLaw

LAYOUT = Layout(
    "odd pad",
    steer=PadSource("axis", 1, sign=-1),
    right_line=PadSource("hat", 0, 1),
    buttons={"two sticks": PadSource("button", 4)},
)
WHOLE = """\
# mine
dead_zone = 0.2  # worn
expo = 0.5
two_sticks = true
law = "rate"
assist = "never"
invert = { reel = true }
"""


@pytest.fixture
def path(tmp_path):
    return tmp_path / "settings.toml"


def test_no_file_is_the_defaults(path):
    assert read_settings(path) == Settings()
    assert settings_or_defaults(path) == (Settings(), "")


def test_the_file_is_where_the_system_keeps_such_files(monkeypatch, tmp_path):
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path))
    assert settings_path().name == "settings.toml"
    assert settings_path().parent.name == "kitemj"


def test_a_whole_file(path):
    path.write_text(WHOLE)
    assert read_settings(path) == Settings(
        Feel(0.2, 0.5, True), StickLaw.RATE, Invert(False, True), "never", True, {}
    )


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("dead_zone = 0.6", "dead_zone must be <= 0.5, got 0.6"),
        ("dead_zone = nan", "dead_zone must be a finite number"),
        ("expo = -0.1", "expo must be >= 0, got -0.1"),
        ('expo = "much"', "expo must be a number, got 'much'"),
        ("two_sticks = 1", "two_sticks must be true or false, got 1"),
        ('law = "speed"', "law must be one of angle, rate, acceleration, got 'speed'"),
        ("law = [1]", "law must be one of angle, rate, acceleration, got [1]"),
        ('assist = "yes"', "assist must be one of lessons, always, never, got 'yes'"),
        ("deadzone = 0.1", "deadzone is not known: did you mean 'dead_zone'?"),
        ("invert = { stear = true }", "invert.stear is not known: did you mean 'steer'?"),
        ("invert = true", "invert must be a table, got True"),
        ("[pads.abc]\nsteer = 'axle 1'", "pads.abc.steer must be like 'axis 0'"),
        ("expo = ", "is not valid TOML"),
    ],
)
def test_a_damaged_file_is_a_sentence_and_is_left_alone(path, text, says):
    path.write_text(text)
    settings, message = settings_or_defaults(path)
    assert settings == Settings()
    assert says in message
    assert str(path) in message
    assert "\n" not in message
    with pytest.raises(InputError, match="mend it, or overwrite to"):
        write_layout(path, "abc", LAYOUT)
    assert path.read_text() == text
    write_layout(path, "abc", LAYOUT, overwrite=True)
    assert read_settings(path).pads == {"abc": LAYOUT}


def test_a_layout_comes_back_and_all_else_stays(path):
    path.write_text(WHOLE)
    before = read_settings(path)
    write_layout(path, "abc", LAYOUT)
    write_layout(path, "def", LAYOUT._replace(name="other"))
    write_layout(path, "abc", LAYOUT._replace(reel=PadSource("buttons", 3, 4)))
    after = read_settings(path)
    assert path.read_text().startswith(WHOLE)
    assert after[:3] == before[:3]
    assert after.pads == {
        "abc": LAYOUT._replace(reel=PadSource("buttons", 3, 4)),
        "def": LAYOUT._replace(name="other"),
    }
    assert [file.name for file in path.parent.iterdir()] == [path.name]


def test_a_new_file_tells_the_defaults(path):
    write_layout(path, "abc", LAYOUT)
    assert path.read_text().startswith(NEW_FILE)
    told = "\n".join(line.removeprefix("# ") for line in NEW_FILE.splitlines()[1:])
    assert settings_of(tomllib.loads(told), "the new file") == Settings()
    assert set(tomllib.loads(told)) == {*Feel._fields, "law", "assist", "invert", "sound"}


def test_a_folder_is_made_and_a_link_stays_a_link(tmp_path):
    real = tmp_path / "dotfiles.toml"
    real.write_text(WHOLE)
    link = tmp_path / "settings.toml"
    link.symlink_to(real)
    write_layout(link, "abc", LAYOUT)
    assert link.is_symlink()
    assert read_settings(real).pads == {"abc": LAYOUT}
    write_layout(tmp_path / "new" / "deep" / "settings.toml", "abc", LAYOUT)
    assert read_settings(tmp_path / "new" / "deep" / "settings.toml").pads == {"abc": LAYOUT}


def test_a_file_where_a_folder_should_be_is_a_sentence(tmp_path):
    (tmp_path / "kitemj").write_text("")
    with pytest.raises(InputError, match="is not writable"):
        check_writable(tmp_path / "kitemj" / "settings.toml", overwrite=False)


def test_the_newest_notice_is_shown_and_an_older_one_comes_back():
    now = [0.0]
    notices = Notices(lambda: now[0])
    assert notices.newest == ""
    notices.say("long", 20.0)
    notices.say("short", 5.0)
    assert notices.newest == "short"
    now[0] = 6.0
    assert notices.newest == "long"
    now[0] = 21.0
    assert notices.newest == ""


def test_sound_is_on_unless_the_file_says_not():
    assert Settings().sound
    assert not settings_of({"sound": False}, "test").sound
    with pytest.raises(InputError, match=r"sound must be true or false, got 'no' \(test\)"):
        settings_of({"sound": "no"}, "test")
