"""The report as a file and as a promise: nothing missing, the same each time, nothing lost."""

import ast
import re
import sys
import tomllib
from pathlib import Path
from types import SimpleNamespace

import pytest

import thesis
from kitemj.cli import main
from kitemj.commands import thesis as thesis_command
from kitemj.errors import InputError
from kitemj.tables import Table
from thesis import answers, equilibrium, parameters, report
from thesis.section import Answer, Drawing, NamedTable, Section, Verdict
from thesis.typesetting import typeset, typeset_cell, typeset_heading

ROOT = Path(__file__).parents[2]
THESIS = ROOT / "scripts" / "thesis"
FILE = re.compile(r"(?<![\w/.])[\w/]+\.(?:py|toml|xml|md)\b").findall
OWN = {file.name for file in THESIS.glob("*.toml")}
"""Opened by the code, not told to the reader."""
CHEAP = (parameters, equilibrium)
ITEMS = [f"Figure {i}" for i in range(1, 56)] + [f"Table {i}" for i in range(1, 15)]


def quiet(name, done):
    """Tells nobody."""


def write(folder, modules=CHEAP, overwrite=False):
    return report.write_report(folder, overwrite, modules, quiet)


def module(name="one", tables=("numbers",), given=(), fault=None):
    """A section of a table or two, or one that fails."""

    def section(scratch):
        if fault:
            raise fault
        named = [NamedTable(each, Table(each, ("t_s",), [(1.0,), (2.5,)])) for each in tables]
        return Section(name, given, ["said"], ["found & <seen>"], tables=named)

    return SimpleNamespace(__name__=f"x.{name}", ANSWERS=given, section=section)


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    folder = tmp_path_factory.mktemp("report") / "report"
    write(folder)
    return folder


def test_every_item_of_the_thesis_is_answered_once():
    assert list(answers.captions()) == ITEMS
    given = [answer for each in report.SECTIONS for answer in each.ANSWERS]
    assert answers.mistakes(given) == []


def test_what_is_wrong_with_a_list_is_told():
    given = [answer for each in report.SECTIONS for answer in each.ANSWERS]
    one = given[0]
    assert answers.mistakes(given[1:]) == [f"{one.item} is not answered"]
    assert answers.mistakes([*given, one]) == [f"{one.item} is answered 2 times"]
    odd = Answer("Figure 56", Verdict.NOT_APPLICABLE, "there is none")
    assert answers.mistakes([*given, odd]) == ["the thesis has no Figure 56"]
    hidden = one._replace(shown_by="")
    assert answers.mistakes([hidden, *given[1:]]) == [
        f"{one.item} is {one.verdict.value} and nothing is shown"
    ]
    mute = one._replace(verdict=Verdict.DIFFERS, reason="")
    assert answers.mistakes([mute, *given[1:]]) == [f"{one.item} is differs and no reason is given"]


def test_an_answer_points_to_what_its_section_shows():
    for each in CHEAP:
        assert answers.dangling(each.section(Path())) == []
    lost = Section("one", [Answer("Figure 1", Verdict.REPRODUCED, shown_by="none")], [], [])
    assert len(answers.dangling(lost)) == 1


def texts(file):
    """Every string of a file of the report."""
    if file.suffix == ".toml":
        return list(tomllib.loads(file.read_text())["background"].values())
    tree = ast.parse(file.read_text())
    found = [node for node in ast.walk(tree) if isinstance(node, ast.Constant)]
    return [node.value for node in found if isinstance(node.value, str)]


def test_files_that_the_report_names_are_there():
    """A path begins at the top of the repository; `name.py` alone would lead nobody anywhere."""
    files = [THESIS / "items.toml", *THESIS.glob("*.py")]
    named = {(name, file.name) for file in files for text in texts(file) for name in FILE(text)}
    assert len({name for name, _ in named if "/" in name}) >= 15
    for name, file in named:
        assert name in OWN or (ROOT / name).is_file(), f"{file} names {name}"


def test_the_page_names_every_section_and_links_to_files_that_are_there(made):
    page = (made / "index.html").read_text(encoding="utf-8")
    links = re.findall(r'(?:src|href)="([^"#]+)"', page)
    assert len(links) > 5
    for link in links:
        assert (made / link).stat().st_size > 0, link
    anchors = set(re.findall(r'id="([^"]+)"', page))
    for target in re.findall(r'href="#([^"]+)"', page):
        assert target in anchors, target
    assert "Table 11" in page
    for name in ("mujoco", "numpy", "Python"):
        assert name in page


def test_tables_are_the_same_each_time_and_in_both_formats(made, tmp_path):
    from pyarrow import csv, parquet

    write(tmp_path / "again")
    tables = sorted(made.glob("tables/*"))
    assert len(tables) >= 10
    for table in tables:
        assert (tmp_path / "again" / "tables" / table.name).read_bytes() == table.read_bytes()
    columns = csv.read_csv(made / "tables" / "standing.csv")
    assert columns.equals(parquet.read_table(made / "tables" / "standing.parquet"))
    assert columns.num_rows == 16


def test_drawings_are_the_same_each_time(made, tmp_path):
    write(tmp_path / "again", [equilibrium])
    [drawing] = (tmp_path / "again" / "figures").glob("*.svg")
    assert drawing.read_bytes() == (made / "figures" / drawing.name).read_bytes()


def test_a_frame_of_the_cockpit_is_copied(tmp_path):
    picture = tmp_path / "frame.png"
    picture.write_bytes(b"a picture")
    section = Section("one", [], [], [], drawings=[Drawing("seen", "as seen", picture)])
    one = SimpleNamespace(__name__="one", ANSWERS=(), section=lambda scratch: section)
    write(tmp_path / "report", [one])
    assert (tmp_path / "report" / "figures" / "seen.png").read_bytes() == b"a picture"


def test_what_people_write_is_escaped(tmp_path):
    write(tmp_path / "report", [module()])
    assert "found &amp; &lt;seen&gt;" in (tmp_path / "report" / "index.html").read_text()


def test_a_folder_with_content_is_left_alone_until_asked(tmp_path, capsys, monkeypatch):
    monkeypatch.setattr(report, "SECTIONS", (module(),))
    folder = tmp_path / "report"
    folder.mkdir()
    words = ["thesis", "--output", str(folder)]
    assert main(words) == 0  # an empty folder is as good as none
    (folder / "tables" / "mine.csv").write_text("mine")
    (folder / "index.html").write_text("old")
    capsys.readouterr()
    assert main(words) == 2
    said = capsys.readouterr().err
    assert "exists and is not empty" in said
    assert said.count("\n") == 1
    assert (folder / "index.html").read_text() == "old"
    assert main([*words, "--overwrite"]) == 0
    assert (folder / "index.html").read_text() != "old"
    assert (folder / "tables" / "mine.csv").read_text() == "mine"
    assert [file.name for file in tmp_path.iterdir()] == ["report"]


@pytest.mark.parametrize("fault", [RuntimeError("no"), InputError("no"), KeyboardInterrupt()])
def test_a_section_that_fails_leaves_nothing(tmp_path, fault):
    with pytest.raises(type(fault)):
        write(tmp_path / "report", [module(), module("two", fault=fault)])
    assert list(tmp_path.iterdir()) == []


def test_mistakes_of_sections_are_found_before_anything_is_written(tmp_path):
    with pytest.raises(ValueError, match="two tables are called numbers"):
        write(tmp_path / "report", [module(), module("two")])
    lost = (Answer("Figure 12", Verdict.REPRODUCED, shown_by="none"),)
    with pytest.raises(ValueError, match="there is no drawing or table none"):
        write(tmp_path / "report", [module(given=lost)])
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("name", ["a file", "no parent"])
def test_bad_names_are_a_sentence_and_status_2(name, tmp_path, capsys):
    (tmp_path / "file").write_text("mine")
    path, sentence = {
        "a file": (tmp_path / "file", "is no folder"),
        "no parent": (tmp_path / "none" / "report", "there is no folder"),
    }[name]
    assert main(["thesis", "--output", str(path)]) == 2
    assert sentence in capsys.readouterr().err
    assert [file.name for file in tmp_path.iterdir()] == ["file"]


def test_a_link_that_leads_nowhere_is_no_folder(tmp_path, capsys):
    link = tmp_path / "report"
    for end in ("report", "none"):
        link.symlink_to(end)
        assert main(["thesis", "--output", str(link)]) == 2
        assert capsys.readouterr().err == f"kitemj: {link} is no folder; give the name of one\n"
        link.unlink()


def test_an_installation_without_the_repository_says_where_the_report_is(
    tmp_path, capsys, monkeypatch
):
    monkeypatch.setattr(thesis_command, "SCRIPTS", tmp_path)
    assert main(["thesis", "--output", str(tmp_path / "report")]) == 2
    assert "made in the repository" in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []


def test_a_package_that_is_not_installed_is_named(tmp_path, capsys, monkeypatch):
    monkeypatch.delitem(sys.modules, "thesis.report")
    monkeypatch.delattr(thesis, "report")
    monkeypatch.setitem(sys.modules, "jinja2", None)
    assert main(["thesis", "--output", str(tmp_path / "report")]) == 2
    said = capsys.readouterr().err
    assert "pip install jinja2" in said
    assert said.count("\n") == 1
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("cell", "text"),
    [
        (True, "yes"),
        (0.0, "0"),
        (-0.1, "−0.1"),
        (1.3e-12, "1.3\u00a0·\u00a010⁻¹²"),
        (float("nan"), "–"),
    ],
)
def test_numbers_are_written_for_people(cell, text):
    assert typeset_cell(cell) == text


def test_units_of_columns_are_written_for_people():
    assert typeset_heading("beta_max_deg") == "β max [°]"
    assert typeset_heading("C_lβ") == "C<sub>lβ</sub>"
    assert typeset_heading("growth_per_s") == "growth [1/s]"
    assert typeset_heading("within_limits") == "within limits"


@pytest.mark.parametrize(
    ("text", "html"),
    [
        ("C_lβ = -0.1", "C<sub>lβ</sub> = −0.1"),
        ("depends on C_lβ.", "depends on C<sub>lβ</sub>."),
        ("x_E < 3e-07 m", "x<sub>E</sub> &lt; 3\u00a0·\u00a010⁻⁷ m"),
        ("Fun_Post_KA and scripts/thesis/free_and_steered.py", None),
        ("newton-euler, Figures 3-5", None),
    ],
)
def test_sentences_are_typeset(text, html):
    assert typeset(text) == (html or text)


def test_dots_are_drawn_where_they_are_seen():
    html = typeset("|δ̈_max|")
    assert 'data-dots="¨"' in html
    assert html.endswith(">δ</span><sub>max</sub>|")
