"""Columns of tables, and curves of figures, at numbers that are written down here."""

from math import atan2, degrees, pi, radians
from types import SimpleNamespace

import numpy as np
import pytest

from kitemj.dynamics.motion import energy
from kitemj.flight.live import Command, Episode, TickResult
from kitemj.physics.shaping import StickLaw
from kitemj.physics.steering import Control
from kitemj.physics.vectors import Rotation, Vector
from kitemj.plots.flight import flight_of_motions
from kitemj.plots.series import angles_figure, ell_and_delta, steering_figure
from kitemj.plots.window import bearing
from kitemj.recording.table import Tick, limit_numbers, table
from kitemj.recording.track import Track, between
from tests.authorities.by_hand import motion, rolled
from tests.support import LAKSA

NUMBERED = Rotation(Vector(11.0, 12.0, 13.0), Vector(21.0, 22.0, 23.0), Vector(31.0, 32.0, 33.0))
"""No rotation, but every number tells its place: x_B in E is the first row."""
HANDS = Control(1.0, 2.0, 3.0, 4.0, 5.0, 6.0)
NOW = motion(
    Vector(-1.0, -2.0, -3.0),
    NUMBERED,
    Vector(0.1, 0.2, 0.3),
    Vector(0.4, 0.5, 0.6),
    air=(12.5, -7.5, 9.0),
    tensions=(70.0, 80.0),
    lengths=(198.0, 202.0),
    t=61.0,
)
COLUMNS = {
    **{"t_s": 61.0, "x_E_m": -1.0, "y_E_m": -2.0, "z_E_m": -3.0},
    **{"alpha_deg": 12.5, "beta_deg": -7.5, "airspeed_m_s": 9.0},
    **{"tension_plus_N": 70.0, "tension_minus_N": 80.0},
    **{"length_plus_m": 198.0, "length_minus_m": 202.0},
    **{"R_BE_xx": 11.0, "R_BE_xy": 12.0, "R_BE_yx": 21.0, "R_BE_zx": 31.0, "R_BE_zz": 33.0},
    **{"vx_E_m_s": 0.1, "vy_E_m_s": 0.2, "vz_E_m_s": 0.3},
    **{"omega_x_B_rad_s": 0.4, "omega_y_B_rad_s": 0.5, "omega_z_B_rad_s": 0.6},
    **{"ell_m": 1.0, "ell_dot_m_s": 2.0, "ell_ddot_m_s2": 3.0},
    **{"delta_rad": 4.0, "delta_dot_rad_s": 5.0, "delta_ddot_rad_s2": 6.0},
    **{"stick_delta": -0.25, "stick_ell": 0.75, "stick_law": 2.0, "lateness_s": 0.125},
    **{"leg": 3.0, "tick": 17.0, "parent": 1.0, "start": 0.0, "gap_m": 0.5},
    **{"assist_hand": 0.375},
    **{"ref_x_E_m": -1.0, "ref_z_E_m": -3.0, "ref_R_BE_yx": 21.0},
}


def recorded(now=NOW):
    """The columns of one tick, which `now` is the end of."""
    now = now._replace(q=(0.0, 0.0, 0.0, 0.0))
    result = TickResult(now, now, 0.0, 0.5, None)
    command = Command(-0.25, 0.75, StickLaw.ACCELERATION)
    return table(LAKSA, [Tick(Episode(3, 1, 0), 17, HANDS, command, result, 0.125, 0.375)])


def test_every_column_holds_what_its_name_says():
    found = recorded()
    for name, value in COLUMNS.items():
        assert float(found[name][0]) == pytest.approx(value), name


class OneRow:
    """As much of a recording as a track reads."""

    parameters, header = LAKSA, SimpleNamespace(tick=0.01)

    def __init__(self, columns):
        self.columns = columns

    def __len__(self):
        return 1


def test_what_is_read_from_columns_is_what_was_flown():
    """And the lines at the tick's end: 1 + 2·0.01 + 3·0.01²/2 and 4 + 5·0.01 + 6·0.01²/2."""
    found = Track(OneRow(recorded())).motion(0.0)
    assert found.t == NOW.t
    for part in ("p_G_E", "v_G_E", "omega_B"):
        assert getattr(found.body, part) == pytest.approx(getattr(NOW.body, part))
    assert np.array(found.body.R_BE) == pytest.approx(np.array(NUMBERED))
    assert found.air == pytest.approx((radians(12.5), radians(-7.5), 9.0))
    assert (found.tensions, found.lengths) == ((70.0, 80.0), (198.0, 202.0))
    assert (found.control.ell, found.control.delta) == pytest.approx((1.02015, 4.0503))


def test_limits_of_columns_are_those_of_the_file():
    """25°, 15° and 600 N, in the units of the columns."""
    for air, tensions, left in (
        ((24.9, 14.9, 9.0), (599.0, 599.0), set()),
        ((25.1, -14.9, 9.0), (0.1, 9.0), {"stall"}),
        ((0.9, -15.1, 9.0), (9.0, 601.0), {"sideslip", "overload"}),
        ((10.0, 0.3, 9.0), (9.0, -0.1), {"slack"}),
    ):
        columns = recorded(motion(NOW.body.p_G_E, air=air, tensions=tensions))
        names = ("stall", "sideslip", "overload", "slack", "ground")
        assert {name for name in names if columns[name][0]} == left
        numbers = limit_numbers(columns)
        assert (numbers.alpha[0], numbers.beta[0]) == pytest.approx(tuple(map(radians, air[:2])))


def test_halfway_between_two_ticks_is_where_a_throw_is():
    """A cubic through a parabola is that parabola: 3 m/s, then 5 m/s; attitude half turned."""
    start = motion(Vector(-10.0, 0.0, -50.0), rolled(0.0), Vector(3.0, 0.0, 0.0))
    end = motion(Vector(-6.0, 0.0, -50.0), rolled(20.0), Vector(5.0, 0.0, 0.0), t=1.0)
    half = between(LAKSA, start, end, 0.5, HANDS)
    assert half.body.p_G_E.x == pytest.approx(-10.0 + 3.0 * 0.5 + 0.5 * 2.0 * 0.25)
    assert half.body.v_G_E.x == pytest.approx(4.0)
    for found, expected in zip(half.body.R_BE, rolled(10.0), strict=True):
        assert found == pytest.approx(expected)


def test_energy_of_a_spinning_plate():
    """½ m v² + ½ (I_x p² + I_y q² + I_z r²) - I_xz p r + m g h, in whole numbers."""
    kite = LAKSA.kite._replace(
        mass=2.0, inertia_x=4.0, inertia_y=6.0, inertia_z=8.0, inertia_xz=1.0
    )
    parameters = LAKSA._replace(kite=kite, environment=LAKSA.environment._replace(gravity=10.0))
    now = motion(Vector(0.0, 0.0, -5.0), v_G_E=Vector(1.0, 2.0, 2.0), omega_B=Vector(1.0, 2.0, 3.0))
    assert energy(parameters, now.body) == pytest.approx(9.0 + 2.0 + 12.0 + 36.0 - 3.0 + 100.0)


def steered():
    """Two rows with lines of 5 and 5, then of √37 and √13, of a kite with Y_A = 3."""
    wide = LAKSA._replace(kite=LAKSA.kite._replace(y_A=3.0))
    hands = ((5.0, 5.0), (37.0**0.5, 13.0**0.5))
    rows = [motion(NOW.body.p_G_E, lengths=pair, t=float(i)) for i, pair in enumerate(hands)]
    return flight_of_motions("by hand", wide, [r._replace(q=(0.0,) * 4) for r in rows])


def test_figures_are_in_the_units_of_their_axes():
    """δ = 30° where lines of √37 and √13 hold a kite 6 m wide; α in degrees below 25."""
    flight = steered()
    ell, delta = ell_and_delta(flight)
    assert ell == pytest.approx([4.0, 4.0])
    assert delta == pytest.approx([0.0, pi / 6])
    (drawn,) = steering_figure(flight).axes[0].get_lines()
    assert drawn.get_ydata() == pytest.approx([0.0, 30.0])
    axes = angles_figure(flight).axes
    assert axes[0].get_lines()[0].get_ydata() == pytest.approx([10.0, 10.0])
    limits = {round(float(line.get_ydata()[0]), 9) for ax in axes for line in ax.get_lines()}
    assert {25.0, 15.0, -15.0, 0.0} <= limits
    beside = np.array([[-3.0, 4.0, -12.0], [-3.0, -4.0, -12.0]])
    azimuth, elevation = degrees(atan2(4, 3)), degrees(atan2(12, 5))
    expected = np.array([[-azimuth, elevation], [azimuth, elevation]])  # right is positive here
    assert bearing(flight, beside) == pytest.approx(expected)
