"""A rig with a third line goes through flights, tables, recordings and pictures."""

from pathlib import Path
from typing import Annotated, NamedTuple

import numpy as np
import pytest

import kitemj
from kitemj.drawing.picture import Picture
from kitemj.drawing.readings import Readings
from kitemj.dynamics.formulation import MODELS, make_model
from kitemj.dynamics.lagrange_kite import LagrangeKite
from kitemj.dynamics.motion import LineState
from kitemj.errors import InputError
from kitemj.flight.motion_table import write_csv
from kitemj.flight.scenario import as_scenario, scenario_of
from kitemj.flight.simulate import simulate
from kitemj.physics.kite import Lines
from kitemj.physics.parameter_files import LINES, parameter_set
from kitemj.physics.quantity import Quantity
from kitemj.physics.rig import RIGS, Rig
from kitemj.physics.vectors import Vector, norm, plus, times
from kitemj.recording.file import read_recording
from kitemj.recording.live import LiveFlight
from kitemj.recording.replay import replay
from kitemj.recording.track import Track
from kitemj.scene.figure import hands
from kitemj.scene.lines import drawn
from kitemj.scene.views import side
from kitemj.studies.flights import fly, result_columns
from kitemj.studies.study import study_of

LIMP = 2.5
"""N in the third line, whatever flies."""
O_E = Vector(0.0, 0.0, 0.0)
SAGGING = Vector(-15.0, 0.0, -2.0)
"""m, E; far from the straight line to the kite."""
SAME = 1e-9
"""m; tracks are made of numbers with all their digits."""


class ThreeLines(NamedTuple):
    """Two lines as ever, and one to the centre of mass."""

    length: Annotated[float, Quantity("m", "of the first two", gt=0)]
    rigid: Annotated[bool, Quantity("", "as of two lines")] = False
    sag: Annotated[float, Quantity("m", "of the third", ge=0)] = 1.0


THREE = Rig(
    "two straight lines and a third",
    ("plus", "minus", "middle"),
    lambda kite: (
        Vector(kite.x_A, kite.y_A, kite.z_A),
        Vector(kite.x_A, -kite.y_A, kite.z_A),
        Vector(0.0, 0.0, 0.0),
    ),
    ("phi", "gamma", "eta", "theta"),
)


class ThreeLineKite(LagrangeKite):
    """The kite on its first two lines; the third pulls nobody."""

    name, rigs = "three", (THREE,)

    def __init__(self, parameters, step=0.002):
        lines = parameters.lines
        super().__init__(parameters._replace(lines=Lines(lines.length, lines.rigid)), step)
        self.sag = lines.sag

    def motion(self, programme):
        now = super().motion(programme)
        G = now.body.p_G_E
        middle = plus(times(0.5, G), Vector(0.0, 0.0, self.sag))
        third = LineState(norm(G), 0.0, LIMP, (Vector(0.0, 0.0, 0.0), middle, G))
        return now._replace(lines=(*now.lines, third))

    def batch(self, programme, times, touch, tolerance):
        rows = super().batch(programme, times, touch, tolerance)
        return np.column_stack([rows, np.full(len(rows), LIMP)])


@pytest.fixture
def tables(monkeypatch):
    """A scenario on three lines."""
    monkeypatch.setitem(RIGS, ThreeLines, THREE)
    monkeypatch.setitem(LINES._loaded, "three", ThreeLines)
    monkeypatch.setitem(MODELS._loaded, "three", ThreeLineKite)
    return {"set": "sport", "duration": 0.5, "lines": {"kind": "three", "sag": 2.0}}


@pytest.fixture
def recording(tables, tmp_path):
    """Half a second of it flown live."""
    path = tmp_path / "three.arrows"
    with LiveFlight(
        scenario_of(tables, "test"), model="three", reference=None, record=path
    ) as flight:
        for _ in range(50):
            flight.tick(kitemj.Command(0.3))
    return read_recording(path)


def test_models_of_two_lines_refuse_it_in_one_sentence(tables):
    with pytest.raises(InputError) as refused:
        kitemj.simulate(tables, model="lagrange")
    assert str(refused.value) == (
        "the model lagrange flies two straight lines, not two straight lines and a third: "
        "choose another model"
    )
    with pytest.raises(InputError, match="flies two straight lines and a third, not two"):
        make_model("three", parameter_set("sport"))


def test_its_table_has_columns_for_the_third_line(tables, tmp_path):
    flight = kitemj.simulate(tables, model="three")
    assert (flight["tension_middle_N"] == LIMP).all()
    position = np.stack([flight[name] for name in ("x_E_m", "y_E_m", "z_E_m")])
    assert flight["length_middle_m"] == pytest.approx(np.linalg.norm(position, axis=0), abs=SAME)
    write_csv(tmp_path / "three.csv", simulate(as_scenario(tables), "three"))
    header, first, *_ = (tmp_path / "three.csv").read_text().splitlines()
    named = dict(zip(header.split(","), first.split(","), strict=True))
    assert float(named["tension_middle_N"]) == LIMP
    assert flight.departure is None
    figure = flight.plot("tensions")
    assert "middle" in [text.get_text() for text in figure.axes[0].get_legend().get_texts()]


def test_its_recording_replays_exports_and_is_drawn_on_three_lines(recording, tmp_path):
    assert recording.parameters.lines == ThreeLines(recording.parameters.lines.length, False, 2.0)
    assert replay(recording, "three").identical
    for place in (10.0, 10.5):
        motion = Track(recording).motion(place)
        assert motion.lines[2].tension_kite == LIMP
        assert norm(motion.lines[2].points[-1]) == pytest.approx(norm(motion.body.p_G_E), abs=SAME)
        assert len(motion.tensions) == 3


def test_a_study_of_it_has_the_third_tension(tables):
    study = study_of(
        {"scenario": tables, "model": "three", "list": [{"lines.sag": 1.0}]}, "test", Path()
    )
    row = fly(study.base, 0, study.design.point(0))
    assert row["ending"] == "finished", row
    assert row["tension_middle_min_N"] == row["tension_middle_max_N"] == LIMP
    assert "tension_middle_min_N" in result_columns(study.rig)


def test_a_picture_has_the_third_line_through_its_points(recording):
    """Halfway to the point in its middle, where a straight line or an arrow would not be."""
    motion = Track(recording).motion(10.0)
    third = motion.lines[2]
    ways = (O_E, third.points[-1]), (O_E, SAGGING, third.points[-1])
    flights = [
        motion._replace(lines=(*motion.lines[:2], third._replace(points=way))) for way in ways
    ]
    with Picture(recording.parameters) as picture:
        eye = side(recording.parameters, motion)._replace(wide=False)  # the pilot in true size
        straight, bent = (picture.paint(each, None, Readings(), eye) for each in flights)
        hand = times(0.5, plus(*hands(recording.parameters, motion)))
        start, bend, *_ = drawn(flights[1].lines[2], hand)
        assert start == pytest.approx(hand), "a line beyond two begins between the hands"
        x, y = (round(at) for at in picture.pixel(times(0.5, plus(start, bend))))
    around = slice(y - 2, y + 3), slice(x - 2, x + 3)
    assert (straight[around] != bent[around]).any()
