"""The bars of tensions: what a pilot flies by is a good part of them, at every set."""

from math import inf

import numpy as np
import pygame
import pytest

from kitemj.drawing import tensions
from kitemj.drawing.colours import BAD, CALL, LEFT, WHITE
from kitemj.drawing.panel import Panel
from kitemj.drawing.tensions import BAR, FASTEST, ROOM, Scale, paint_tensions, scale_of
from kitemj.physics.parameter_files import parameter_set, set_names
from kitemj.physics.rig import TWO_LINES
from tests.scene.motions import EQUILIBRIUM, LAKSA, motion_at
from tests.support import pulling

CALM = motion_at(LAKSA, EQUILIBRIUM)
SPORT = parameter_set("sport")
SIZE = (427, 118)


def painted(pull, parameters=SPORT, motion=CALM):
    """Pixels (columns, rows, 3) of the panel, both lines pulling with `pull` [N]."""
    surface = pygame.Surface(SIZE)
    motion = pulling(motion, *(pull for _ in motion.lines))
    paint_tensions(Panel(surface, (0, 0, *SIZE), 1.0), parameters, scale_of(parameters), motion, 0)
    return pygame.surfarray.array3d(surface)


def filled(image, colour=LEFT):
    """The part of the left line's bar that has this colour."""
    row = image[round(BAR) : round(BAR + ROOM), 50]
    return (row == colour).all(axis=1).mean()


@pytest.mark.parametrize("name", set_names())
def test_rest_and_three_times_its_airspeed_are_well_apart_on_the_bar(name):
    scale = scale_of(parameter_set(name))
    assert 0.15 < scale.share(scale.rest) < 0.4
    assert scale.share(9 * scale.rest) - scale.share(scale.rest) > 0.3


def test_the_bar_is_as_long_as_the_scale_says():
    scale = scale_of(SPORT)
    assert scale.rest == pytest.approx(5.0, abs=0.1), "N, what its file says it stands with"
    assert scale.full == FASTEST**2 * scale.rest
    mark = 2 / ROOM  # is painted over the bar
    for times in (0.5, 2.0, 4.0):
        share = filled(painted(times**2 * scale.rest))
        assert share == pytest.approx(times / FASTEST, abs=1.5 * mark)
    assert filled(painted(300.0)) == pytest.approx(1.0, abs=1.5 * mark)
    assert filled(painted(701.0), BAD) == pytest.approx(1.0, abs=1.5 * mark)
    assert filled(painted(-1.0), CALL) > 0.3, "slack, with words over it"


def test_marks_stand_at_rest_and_at_the_ceiling_where_it_is_on_the_bar():
    thesis = parameter_set("thesis")
    for parameters, tall in ((SPORT, [1 / FASTEST]), (thesis, [(44.745 / 600) ** 0.5, 1.0])):
        row = painted(1e-3, parameters)[:, 38]
        found = np.flatnonzero((row == WHITE).all(axis=1)).reshape(-1, 2)
        found = found[(found[:, 0] > BAR) & (found[:, 0] < BAR + ROOM)]
        assert (found.mean(axis=1) - BAR) / ROOM == pytest.approx(np.array(tall), abs=0.01)


def test_a_kite_that_cannot_rest_has_bars_up_to_the_ceiling():
    calm = SPORT._replace(wind=SPORT.wind._replace(speed=1.0))
    assert scale_of(calm) == Scale(inf, SPORT.limits.tension_max)
    assert filled(painted(175.0, calm)) == pytest.approx(0.5, abs=0.01)


def test_a_third_lines_long_name_stays_before_its_bar(monkeypatch):
    names = ("plus", "minus", "the brake of the left wing's tip")
    monkeypatch.setattr(tensions, "rig_of", lambda parameters: TWO_LINES._replace(lines=names))
    motion = CALM._replace(lines=(*CALM.lines, CALM.lines[0]))
    image = painted(5.0, motion=motion)
    edge = image[round(BAR) - 4 : round(BAR), 90:112]
    assert not edge.any()
    assert image[12 : round(BAR) - 4, 90:112].any()
