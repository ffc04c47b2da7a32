"""`kitemj plot` and `kitemj limits` as a person meets them."""

import csv
import json
import re
from xml.etree import ElementTree

import matplotlib
import numpy as np
import pytest
from matplotlib import pyplot

from kitemj.cli import main
from kitemj.flight.motion_table import write_csv
from kitemj.plots.figure_output import save_figures, show
from kitemj.plots.figures import FIGURES
from tests.plots.flights import TOML, simulation


@pytest.fixture
def scenario(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "eight.toml").write_text(TOML)
    return "eight.toml"


def listed(folder):
    return sorted(path.name for path in folder.iterdir())


def test_pictures_are_called_by_their_figures(scenario, tmp_path, capsys):
    assert main(["plot", scenario, "--what", "state,window", "--save", "a.png"]) == 0
    assert main(["plot", scenario, "--what", "path", "--save", "path.svg"]) == 0
    alone = ["a-state.png", "a-window.png"]
    assert listed(tmp_path) == [*alone, "a.png", "eight.toml", "path.svg"]
    told = "a.png: state, window\na-state.png: state\na-window.png: window\npath.svg: path\n"
    assert capsys.readouterr().out == told


def test_the_named_picture_shows_every_figure(tmp_path):
    """Each has a colour of its own, and is as large as alone: 2 x 1 and 1 x 2 inches."""
    figures = {}
    for colour, size in (("red", (2, 1)), ("blue", (1, 2)), ("lime", (2, 1))):
        figures[colour] = matplotlib.figure.Figure(figsize=size, facecolor=colour)
        figures[colour].text(0.5, 0.5, colour)
    save_figures(figures, tmp_path / "all.png")
    sheet = pyplot.imread(tmp_path / "all.png")
    for row in np.eye(3):
        assert (sheet[:, :, :3] == row).all(axis=2).sum() == pytest.approx(2 * 100**2, rel=0.1)
    save_figures(figures, tmp_path / "all.svg")
    drawing = ElementTree.parse(tmp_path / "all.svg").getroot()
    names = [each.get("id") for each in drawing.iter() if each.get("id")]
    assert len(names) == len(set(names))
    text = (tmp_path / "all.svg").read_text()
    used = re.findall(r'href="#([^"]+)"|url\(#([^)]+)\)', text)
    assert {a or b for a, b in used} <= set(names)
    for colour in ("#ff0000", "#0000ff", "#00ff00"):
        assert colour in text


def test_a_pdf_has_a_page_for_each(scenario, tmp_path, capsys):
    assert main(["plot", scenario, "--save", "all.pdf"]) == 0
    assert "without guidance: no autopilot flew eight.toml" in capsys.readouterr().out
    pages = re.findall(rb"/Type /Page\b(?!s)", (tmp_path / "all.pdf").read_bytes())
    assert len(pages) == len(FIGURES) - 1
    assert listed(tmp_path) == ["all.pdf", "eight.toml"]


def test_all_leaves_out_what_the_table_lacks(scenario, tmp_path, capsys):
    write_csv(tmp_path / "flight.csv", simulation())
    assert main(["plot", "flight.csv", "--save", "a.pdf"]) == 0
    assert "without rates: flight.csv, lagrange lacks the column R_BE_xx" in capsys.readouterr().out
    assert main(["plot", "flight.csv", "--what", "rates", "--save", "b.pdf"]) == 2
    told = capsys.readouterr().err
    assert "a recording, its exported table and a scenario have it" in told
    assert listed(tmp_path) == ["a.pdf", "eight.toml", "flight.csv", "flight.csv-metadata.json"]


BAD = {
    "format": (["plot", "F", "--save", "x.gif"], "must end in one of .png, .pdf, .svg"),
    "limits format": (["limits", "F", "--save", "x"], "must end in one of .png, .pdf, .svg"),
    "exists": (["plot", "F", "--save", "kept.png"], "kept-path.png exists"),
    "limits exist": (["limits", "F", "--save", "kept-path.png"], "kept-path.png exists"),
    "table exists": (["limits", "F", "--output", "kept.csv"], "kept.csv exists"),
    "folder": (["plot", "F", "--what", "path", "--save", "sub.png"], "sub.png is a folder"),
    "no folder": (["plot", "F", "--save", "none/x.pdf"], "there is no folder none"),
    "figure": (["plot", "F", "--what", "state,x", "--save", "x.png"], "there is no figure 'x'"),
    "table format": (["limits", "F", "--output", "x.txt"], "must end in one of .json, .csv"),
}


@pytest.mark.parametrize("case", BAD)
def test_what_cannot_be_done_writes_nothing(case, scenario, tmp_path, capsys):
    words, says = BAD[case]
    (tmp_path / "kept-path.png").write_text("mine")
    (tmp_path / "kept.csv").write_text("mine")
    (tmp_path / "sub.png").mkdir()
    before = listed(tmp_path)
    assert main([scenario if word == "F" else word for word in words]) == 2
    told = capsys.readouterr().err
    assert told.startswith("kitemj: ")
    assert told.count("\n") == 1
    assert says in told
    assert listed(tmp_path) == before
    assert (tmp_path / "kept-path.png").read_text() == "mine"
    assert (tmp_path / "kept.csv").read_text() == "mine"


def test_overwriting_is_asked_for(scenario, tmp_path):
    (tmp_path / "x.png").write_text("mine")
    assert main(["limits", scenario, "--save", "x.png", "--overwrite"]) == 0
    assert (tmp_path / "x.png").read_bytes().startswith(b"\x89PNG")


def test_without_a_display_it_says_how_to_save(scenario, capsys):
    matplotlib.use("agg")
    assert main(["plot", scenario]) == 2
    assert "give --save a name" in capsys.readouterr().err


def test_windows_hold_every_figure(monkeypatch):
    shown = []
    monkeypatch.setattr(pyplot, "show", lambda: shown.extend(pyplot.get_fignums()))
    drawn = {name: matplotlib.figure.Figure() for name in ("a", "b")}
    show(drawn)
    assert len(shown) == 2
    pyplot.close("all")


def test_limits_prints_and_writes_its_table(scenario, tmp_path, capsys):
    words = ["limits", scenario, "--output", "x.csv", "--save", "x.pdf"]
    assert main(words) == 0
    told = capsys.readouterr().out
    assert "T₊, left" in told
    assert "at rest in a wind of" in told
    assert "within all limits of validity throughout" in told
    assert "never" in told
    with (tmp_path / "x.csv").open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    tensions = [motion.tensions[0] for motion in simulation().motions]
    assert float(rows[0]["largest"]) >= max(tensions) / 700.0
    assert float(rows[0]["smallest"]) <= min(tensions) / 700.0
    assert main([*words[:2], "--output", "x.json"]) == 0
    assert [row["ratio"] for row in json.loads((tmp_path / "x.json").read_text())["limits"]] == [
        row["ratio"] for row in rows
    ]


def test_limits_say_when_a_flight_leaves_them(scenario, tmp_path, capsys):
    (tmp_path / "weak.toml").write_text(TOML + "limits = { tension_max = 5.0 }\n")
    assert main(["limits", "weak.toml"]) == 0
    assert "a line carries more than it may" in capsys.readouterr().out
