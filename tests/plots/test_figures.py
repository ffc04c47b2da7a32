"""What is drawn is what was flown: numbers read back from the figures; units, text, lines."""

import re
from dataclasses import replace
from math import sin

import numpy as np
import pytest
from matplotlib.text import Text

from kitemj.dynamics.lagrange_kite import motion_at
from kitemj.flight.guided_table import guided_columns
from kitemj.flight.pilot_settings import Guided
from kitemj.plots.figures import FIGURES
from kitemj.plots.flight import flight_of_motions, flight_of_simulation
from kitemj.plots.limits import limits_figure
from kitemj.plots.rates import q_dot
from kitemj.plots.window import bearing
from tests.plots.flights import TABLES, by_hand, simulation
from tests.support import random_cases

RATES = 1e-12
"""rad/s; a few roundings of rates of some rad/s."""
STEERING = 1e-9
"""rad and m; δ comes back out of lengths of 25 m that differ by their last digits."""
ONE_SCALE = 1e-9
"""Of the scale of each axis of the path."""
DRAWN = {**{name: FIGURES[name] for name in FIGURES}, "limits": limits_figure}
UNIT = re.compile(r"\[(s|m|N|deg|deg/s|-)\]$")
SMALLEST = 8.0  # pt


@pytest.fixture(scope="module")
def flight():
    """As of a scenario's table, an autopilot having flown the second half of it."""
    found = flight_of_simulation(simulation())
    told = [Guided("path", 0.02, t, 0.1, 0.7, 0.0) if t > 1.0 else None for t in found.t]
    return replace(found, columns={**found.columns, **guided_columns(told)})


@pytest.fixture(scope="module")
def motions():
    return simulation().motions


def curves(figure, ax):
    """The vertical numbers of the curves of one diagram, lines across it left out."""
    lines = figure.axes[ax].get_lines()
    return [line.get_ydata() for line in lines if len(line.get_xdata()) > 2]


def test_rates_are_those_of_the_state():
    for case in random_cases(30):
        motion = motion_at(case.parameters, case.segment, 0.0, case.state)
        found = q_dot(flight_of_motions("test", case.parameters, [motion]))
        assert np.allclose(found[0], case.state.q_dot, rtol=0, atol=RATES)


def test_state_and_rates(flight, motions):
    for name, expected in (("state", [m.q for m in motions]), ("rates", q_dot(flight))):
        figure = FIGURES[name](flight)
        for ax, column in enumerate(np.degrees(expected).T):
            (drawn,) = curves(figure, ax)
            assert np.array_equal(drawn, column)


def test_the_state_does_not_jump_by_whole_turns(flight):
    turned = (flight.columns["phi_rad"] + 40.0 * flight.t + np.pi) % (2 * np.pi) - np.pi
    figure = FIGURES["state"](replace(flight, columns={**flight.columns, "phi_rad": turned}))
    (drawn,) = curves(figure, 0)
    assert np.ptp(turned) < 2 * np.pi
    assert np.ptp(np.radians(drawn)) > 79.0


def test_tensions_left_and_right(flight, motions):
    figure = FIGURES["tensions"](flight)
    for ax in (0, 1):
        left, right = figure.axes[ax].get_lines()[:2]
        assert np.array_equal(left.get_ydata(), [m.tensions[0] for m in motions])
        assert np.array_equal(right.get_ydata(), [m.tensions[1] for m in motions])
        assert left.get_linestyle() != right.get_linestyle()
    assert [line.get_ydata()[0] for line in figure.axes[0].get_lines()[2:]] == [0.0, 700.0]


def test_angles(flight, motions):
    figure = FIGURES["angles"](flight)
    alpha, beta, _ = np.degrees([m.air for m in motions]).T
    for ax, expected in enumerate((alpha, alpha, beta, beta)):
        assert np.array_equal(curves(figure, ax)[0], expected)


def test_steering_is_that_of_the_programme(flight):
    figure = FIGURES["steering"](flight)
    (delta,), (ell,) = curves(figure, 0), curves(figure, 1)
    amplitude, omega = (TABLES["steering"][f"delta_{name}"] for name in ("amplitude", "frequency"))
    expected = [amplitude * sin(omega * t) for t in flight.t]
    assert np.allclose(np.radians(delta), expected, rtol=0, atol=STEERING)
    assert np.allclose(ell, ell[0], rtol=0, atol=STEERING)
    assert np.array_equal(curves(figure, 2)[0], flight.columns["length_plus_m"])


def test_path_is_upright_and_not_mirrored(flight, motions):
    (ax,) = FIGURES["path"](flight).axes
    path = np.array(ax.get_lines()[0].get_data_3d()).T
    expected = [(p.x, -p.y, -p.z) for p in (m.body.p_G_E for m in motions)]
    assert np.array_equal(path, expected)
    assert path[:, 2].min() > 0.0
    sides = np.ptp([ax.get_xlim(), ax.get_ylim(), ax.get_zlim()], axis=1)
    scale = ax.get_box_aspect() / sides
    assert np.allclose(scale, scale[0], rtol=ONE_SCALE)


def test_lines_end_at_the_attachments(flight, motions):
    (ax,) = FIGURES["path"](flight).axes
    ends = [np.array(line.get_data_3d()).T for line in ax.get_lines()]
    first = [e[1] for e in ends if len(e) == 2 and not e[0].any()][:2]
    assert np.allclose(np.linalg.norm(first, axis=1), motions[0].lengths, rtol=0, atol=STEERING)


def test_window_is_seen_by_the_pilot():
    flight = by_hand()
    ahead, left, above = bearing(flight, np.array([[-1, 0, -1], [-1, 1, 0], [-1e-9, 0, -5]]))
    assert ahead == pytest.approx((0.0, 45.0))
    assert left == pytest.approx((-45.0, 0.0))
    assert above[1] == pytest.approx(90.0)
    wind = flight.parameters.wind._replace(azimuth=0.5)
    turned = replace(flight, parameters=flight.parameters._replace(wind=wind))
    downwind = np.array([[-np.cos(0.5), -np.sin(0.5), 0.0]])
    assert bearing(turned, downwind)[0] == pytest.approx((0.0, 0.0))


def test_window_draws_the_bearings(flight):
    p = np.column_stack([flight.columns[f"{axis}_E_m"] for axis in "xyz"])
    for ax in FIGURES["window"](flight).axes:
        assert np.array_equal(np.transpose(ax.get_lines()[0].get_data()), bearing(flight, p))


@pytest.mark.parametrize("name", DRAWN)
def test_units_and_text(name, flight):
    figure = DRAWN[name](flight)
    figure.draw_without_rendering()
    for ax in figure.axes:
        labels = [axis.label.get_text() for axis in ax._axis_map.values()]
        shared = not ax.xaxis.get_tick_params().get("labelbottom", True)
        for label in labels[shared:]:
            assert UNIT.search(label), label
    sizes = {text.get_fontsize() for text in figure.findobj(Text) if text.get_text()}
    assert min(sizes) >= SMALLEST
    assert figure.get_figwidth() <= 7.0


@pytest.mark.parametrize("name", DRAWN)
def test_what_is_beyond_the_limits_says_so(name, flight):
    beta = flight.columns["beta_deg"].copy()
    beta[20:23] = 40.0
    flight = replace(flight, columns={**flight.columns, "beta_deg": beta})
    (legend,) = DRAWN[name](flight).legends
    told = " ".join(text.get_text() for text in legend.get_texts())
    assert f"at t = {flight.t[20]:.2f} s: the sideslip angle is beyond β_max" in told.replace(
        "\n", " "
    )


def test_the_ground_does_not_set_the_scale(flight):
    wild, ground = flight.columns["theta_rad"].copy(), np.arange(len(flight.t)) > 30
    wild[31:] += 50.0
    figure = FIGURES["state"](
        replace(flight, columns={**flight.columns, "theta_rad": wild, "ground": ground})
    )
    assert max(figure.axes[3].get_ylim()) < 360.0


NOISE = 1e-11
"""Of a flight at rest, in the unit of each column."""


@pytest.mark.parametrize("name", ["state", "tensions", "angles", "steering", "limits"])
def test_rounding_of_a_flight_at_rest_is_a_flat_line(name):
    turns = {angle: [0.3] * 50 for angle in ("phi_rad", "gamma_rad", "eta_rad", "theta_rad")}
    lengths = {"length_plus_m": [200.0] * 50, "length_minus_m": [200.0] * 50}
    flight, rng = by_hand(50, **turns, **lengths), np.random.default_rng(5)
    noisy = {
        column: values + NOISE * rng.standard_normal(len(values))
        for column, values in flight.columns.items()
        if column != "t_s" and values.dtype.kind == "f"
    }
    flight = replace(flight, columns=flight.columns | noisy)
    figure = limits_figure(flight) if name == "limits" else flight.plot(name)
    for ax in figure.axes:
        bottom, top = ax.get_ylim()
        heights = [np.ptp(line.get_ydata()) for line in ax.get_lines()]
        assert max(heights) < 1e-3 * (top - bottom)
        marks = {label.get_text() for label in ax.get_yticklabels()}
        assert ax.yaxis.get_major_formatter().get_offset() == ""
        assert len(marks) > 1
