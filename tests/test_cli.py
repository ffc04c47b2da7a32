"""The command as a person meets it: what it writes, prints and refuses."""

import csv
import os
import subprocess
import sys
from pathlib import Path

import pytest

from kitemj.cli import main
from kitemj.flight.motion_table import COLUMNS

ROOT = Path(__file__).parent.parent
REFERENCE = ROOT / "scenarios" / "steer_200m.toml"
SHORT = """
set = "thesis"
duration = 1.0
output_interval = 0.25
"""


@pytest.fixture
def short(tmp_path):
    path = tmp_path / "short.toml"
    path.write_text(SHORT)
    return path


def test_simulate_writes_the_agreed_columns(short, tmp_path, capsys):
    output = tmp_path / "flight.csv"
    assert main(["simulate", str(short), "--model", "lagrange", "--output", str(output)]) == 0
    with output.open() as file:
        rows = list(csv.reader(file))
    assert tuple(rows[0]) == COLUMNS
    assert [float(row[0]) for row in rows[1:]] == [0.0, 0.25, 0.5, 0.75, 1.0]
    assert "5 rows" in capsys.readouterr().out


def test_output_that_exists_is_left_alone_until_asked(short, tmp_path, capsys):
    output = tmp_path / "flight.csv"
    output.write_text("mine")
    words = ["simulate", str(short), "--output", str(output)]
    assert main(words) == 2
    assert output.read_text() == "mine"
    assert "exists" in capsys.readouterr().err
    assert main([*words, "--overwrite"]) == 0
    assert output.read_text().startswith("t_s,")


MAP = ["--map", "kite.mass", "3", "5", "kite.span", "5", "6"]
BAD = {
    "no scenario": (["simulate", "none.toml", "--output", "x.csv"], "cannot read none.toml"),
    "unknown model": (["simulate", "SHORT", "--output", "x.csv", "--model", "x"], "no model 'x'"),
    "no step": (["simulate", "SHORT", "--output", "x.csv", "--step", "0"], "--step must be > 0 s"),
    "no folder": (["simulate", "SHORT", "--output", "none/x.csv"], "there is no folder none"),
    "size": (["film", "SHORT", "--output", "x.mp4", "--size", "big"], "must be like 1280x720"),
    "other digits": (["film", "SHORT", "--output", "x.mp4", "--size", "²x²"], "like 1280x720"),
    "huge": (["film", "SHORT", "--output", "x.mp4", "--size", "20000x20000"], "16 to 8192"),
    "slow film": (["film", "SHORT", "--output", "x.mp4", "--speed", "1e-9"], "too many rows"),
    "soon": (["film", "SHORT", "--output", "x.png", "--still", "nan"], "--still: must be a number"),
    "rate": (["film", "SHORT", "--output", "x.mp4", "--rate", "99999"], "1 to 1000 frames/s"),
    "step": (["simulate", "SHORT", "--output", "x.csv", "--step", "1e-12"], "must be >= 1e-06 s"),
    "no name": (["simulate", "SHORT", "--output", ""], "--output: must be the name of a file"),
    "unkept": (["stability", "SHORT", "--map", *"a12b34"], "a map needs --save FIGURE"),
    "map": (
        ["stability", "SHORT", "--json", *MAP[:3], "nan", *MAP[4:]],
        "B must be a number",
    ),
    "points": (
        ["stability", "SHORT", "--json", "--points", "9999", *MAP],
        "at most, got 9999",
    ),
    "one model": (["compare", "SHORT", "--models", "mujoco"], "models needs two or more"),
}


@pytest.mark.parametrize("name", BAD)
def test_bad_words_are_one_line_and_status_2(name, short, tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    words, sentence = BAD[name]
    try:
        status = main([str(short) if word == "SHORT" else word for word in words])
    except SystemExit as stopped:
        status = stopped.code
    assert status == 2
    error = capsys.readouterr().err
    assert sentence in error
    assert error.count("\n") == 1
    assert [file.name for file in tmp_path.iterdir()] == ["short.toml"]


@pytest.mark.parametrize("words", [["--cycle"], ["--vary", "kite.mass", "--range", "3.9", "4.1"]])
def test_what_is_not_there_is_an_answer(words, short, capsys):
    assert main(["stability", str(short), *words]) == 1
    assert "equilibrium is stable" in capsys.readouterr().err


@pytest.mark.skipif(os.geteuid() == 0, reason="root may write anywhere")
def test_folder_that_is_not_writable(short, tmp_path, capsys):
    folder = tmp_path / "locked"
    folder.mkdir(mode=0o555)
    assert main(["simulate", str(short), "--output", str(folder / "x.csv")]) == 2
    assert "not writable" in capsys.readouterr().err


def test_misspelt_word_is_status_2(capsys):
    with pytest.raises(SystemExit) as stopped:
        main(["simulate", "x.toml", "--outputt", "y.csv"])
    assert stopped.value.code == 2
    assert capsys.readouterr().err.count("\n") == 1


def test_compare_prints_gaps_and_says_no_beyond_the_tolerance(short, capsys):
    assert main(["compare", str(short), "--models", "mujoco,lagrange"]) == 0
    assert "yes" in capsys.readouterr().out
    swinging = REFERENCE.read_text().replace("60.0", "5.0")
    short.write_text(swinging)
    coarse = ["compare", str(short), "--models", "mujoco,lagrange", "--step", "0.05"]
    assert main(coarse) == 1
    assert "NO" in capsys.readouterr().out


def test_fly_with_no_display_films_a_show_and_ends_well(tmp_path):
    """In a process of its own: this is what `make fly` does on a server."""
    environment = {
        name: value
        for name, value in os.environ.items()
        if name not in ("DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER")
    }
    done = subprocess.run(
        [sys.executable, "-m", "kitemj", "fly", "--duration", "2", "--size", "640x360"],
        cwd=tmp_path,
        env=environment,
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert "there is no display" in done.stdout
    assert "missed" in done.stdout
    assert len(list(tmp_path.glob("*.mp4"))) == 1


def test_every_command_has_help_with_an_example(capsys):
    from kitemj.cli import COMMANDS

    for command in COMMANDS:
        with pytest.raises(SystemExit) as stopped:
            main([command, "--help"])
        assert stopped.value.code == 0
        assert "example" in capsys.readouterr().out
