"""Linear systems, modes and thresholds, held against flights and against laws of scale."""

from dataclasses import replace
from math import cos, exp, pi, sin

import numpy as np
import pytest
from scipy.linalg import expm

from kitemj.cli import main
from kitemj.dynamics.formulation import MODELS
from kitemj.equilibria.linearise import (
    INPUTS,
    OUTPUTS,
    STATES,
    Array,
    jacobian,
    linearise,
    outputs,
    state_units,
)
from kitemj.equilibria.maps import stability_map
from kitemj.equilibria.minimal import Minimal, held
from kitemj.equilibria.modes import MOTIONS, Crossing, crossings, growth, stability
from kitemj.equilibria.tables import map_table
from kitemj.equilibria.trim import trimmed
from kitemj.equilibria.vary import parameter_names, value_of, with_value
from kitemj.errors import InputError
from kitemj.physics.parameter_files import parameter_set
from kitemj.physics.parameters import Parameters
from kitemj.physics.steering import Control, rest_ell

LAKSA, THESIS = parameter_set("laksa"), parameter_set("thesis")
SAME = {"newton-euler": 1e-6, "mujoco": 1e-4}
"""Relative; of eigenvalues, to those of Lagrange's equations."""


def ell_of(parameters: Parameters) -> float:
    return rest_ell(parameters.lines.length, parameters.kite.y_A)


def eigenvalues(parameters: Parameters, model: str, delta: float = 0.0) -> Array:
    found = stability(parameters, delta=delta, model=model).modes
    return np.array([complex(mode.real, mode.imag) for mode in found])


def lost(parameters: Parameters, model: str = "lagrange") -> Crossing:
    (found,) = crossings(parameters, "aero.Cl_beta", -1.0, 0.0, model=model)
    return found


@pytest.mark.parametrize("parameters", [LAKSA, THESIS], ids=["laksa", "thesis"])
@pytest.mark.parametrize("delta", [0.0, 0.08])
@pytest.mark.parametrize("model", SAME)
def test_eigenvalues_agree(parameters: Parameters, delta: float, model: str) -> None:
    reference = eigenvalues(parameters, "lagrange", delta)
    other = eigenvalues(parameters, model, delta)
    assert np.max(np.abs(other - reference) / np.abs(reference)) < SAME[model]


@pytest.mark.parametrize("model", SAME)
def test_whole_linear_systems_agree(model: str) -> None:
    x0, control = trimmed(LAKSA, delta=0.05)[0], held(ell_of(LAKSA), 0.05)
    reference = linearise(Minimal("lagrange", LAKSA), x0, control)
    other = linearise(Minimal(model, LAKSA), x0, control)
    for block in "ABCD":
        a, b = getattr(other, block), getattr(reference, block)
        assert np.abs(a - b).max() < 1e-8 * np.abs(b).max(), block


def test_shapes_follow_the_named_states_inputs_and_outputs() -> None:
    linear = stability(LAKSA).linear
    n, m, p = len(STATES), len(INPUTS), len(OUTPUTS)
    assert (linear.A.shape, linear.B.shape) == ((n, n), (n, m))
    assert (linear.C.shape, linear.D.shape) == ((p, n), (p, m))
    assert linear.y0[OUTPUTS.index("tension_plus")] == pytest.approx(43.7845, abs=1e-4)


def test_the_shown_error_covers_the_true_one() -> None:
    def f(z: Array) -> Array:
        x, y = map(float, z)
        return np.array([exp(3 * x) * sin(y), 1e3 * cos(40 * x), y**7])

    x, y = 0.3, 0.7
    exact = np.array(
        [
            [3 * exp(3 * x) * sin(y), exp(3 * x) * cos(y)],
            [-4e4 * sin(40 * x), 0],
            [0, 7 * y**6],
        ]
    )
    for step in (4e-2, 4e-3, 4e-6, 4e-9):  # from truncation to rounding
        J, error = jacobian(f, np.array([x, y]), np.ones(2), step)
        assert (np.abs(J - exact) <= error).all(), step


def test_the_shown_error_is_not_a_blank_cheque() -> None:
    J, error = jacobian(np.sin, np.array([0.3]), np.ones(1))
    assert abs(J[0, 0] - cos(0.3)) <= error[0, 0] < 1e-11


def test_the_shown_error_of_A_covers_a_finer_method() -> None:
    # a stencil of eighth order at another step; its own error is below 1e-12 of A
    parameters, x0 = THESIS, trimmed(THESIS)[0]
    control, kite = held(ell_of(parameters)), Minimal("lagrange", THESIS)
    linear = linearise(kite, x0, control)
    h, columns = 1e-2, []
    for unit, e in zip(state_units(parameters, control.ell), np.eye(8), strict=True):
        column = np.zeros(8)
        for k, weight in enumerate((4 / 5, -1 / 5, 4 / 105, -1 / 280), start=1):
            step = k * h * unit * e
            after, before = kite.answer(x0 + step, control), kite.answer(x0 - step, control)
            column += weight * (after.x_dot - before.x_dot) / (h * unit)
        columns.append(column)
    A = np.column_stack(columns)
    slack = 1e-12 * np.abs(A).max()
    assert (np.abs(A - linear.A) <= linear.A_error + slack).all()
    assert linear.error < 1e-9


@pytest.mark.parametrize("model", MODELS)
def test_a_small_disturbance_flies_as_A_says(model: str) -> None:
    x0, control = trimmed(LAKSA)[0], held(ell_of(LAKSA))
    kite = Minimal(model, LAKSA)
    A = linearise(Minimal("lagrange", LAKSA), x0, control).A
    e = 1e-5 * state_units(LAKSA, control.ell) * (1, -1, 1, 1, -1, 1, 1, -1)
    flown = kite.flow(x0 + e, control, 3.0) - x0
    assert flown == pytest.approx(expm(3.0 * A) @ e, rel=1e-3, abs=1e-8)


@pytest.mark.parametrize(("du", "size"), [("ell", 1e-2), ("delta", 1e-4)])
def test_a_small_step_of_the_lines_flies_as_B_says(du: str, size: float) -> None:
    x0, control = trimmed(THESIS)[0], held(ell_of(THESIS))
    kite = Minimal("lagrange", THESIS)
    linear = linearise(kite, x0, control)
    u = np.zeros(6)
    u[INPUTS.index(du)] = size
    moved = Control(*map(float, np.array(control) + u))
    flown = kite.flow(x0, moved, 2.0) - x0
    both = np.zeros((9, 9))
    both[:8, :8], both[:8, 8] = linear.A, linear.B @ u
    assert flown == pytest.approx(expm(2.0 * both)[:8, 8], rel=2e-3, abs=5e-9)


@pytest.mark.parametrize("name", INPUTS)
def test_B_and_D_are_the_slopes_of_rates_and_outputs(name: str) -> None:
    x0, control = trimmed(LAKSA, delta=0.05)[0], held(ell_of(LAKSA), 0.05)
    kite = Minimal("newton-euler", LAKSA)
    linear = linearise(Minimal("lagrange", LAKSA), x0, control)
    j, h = INPUTS.index(name), 1e-4
    u = h * np.eye(6)[j]
    after, before = (
        outputs(kite, x0, Control(*map(float, np.array(control) + s * u))) for s in (1, -1)
    )
    for slope, column in zip(
        ((a - b) / (2 * h) for a, b in zip(after, before, strict=True)),
        (linear.B[:, j], linear.D[:, j]),
        strict=True,
    ):
        assert slope == pytest.approx(column, rel=1e-5, abs=1e-6 * np.abs(column).max() + 1e-9)


def test_modes_are_of_the_plane_of_symmetry_or_across_it() -> None:
    modes = stability(LAKSA).modes
    assert sum(2 if mode.imag else 1 for mode in modes) == 8
    for mode in modes:
        share = dict(zip(MOTIONS, mode.shares, strict=True))
        within = share["heave"] + share["pitch"]
        assert min(within, 1 - within) < 1e-12
        assert sum(mode.shares) == pytest.approx(1.0)
    (pitch,) = [mode for mode in modes if mode.name.startswith("pitch")]
    assert pitch.frequency == pytest.approx(abs(pitch.imag) / (2 * pi))
    assert 0 < pitch.damping < 1
    assert max(mode.error for mode in modes) < 1e-7


@pytest.mark.parametrize("parameters", [LAKSA, THESIS], ids=["laksa", "thesis"])
def test_flights_beside_the_threshold_fade_and_grow_at_its_frequency(
    parameters: Parameters,
) -> None:
    found = lost(parameters)
    period, control = 2 * pi / found.omega, held(ell_of(parameters))
    for factor, grows in ((0.99, False), (1.01, True)):
        there = with_value(parameters, "aero.Cl_beta", factor * found.value)
        kite, x0 = Minimal("lagrange", there), trimmed(there)[0]
        x = x0 + np.array([1e-4, 0, 0, 0, 0, 0, 0, 0])
        later = kite.flow(x, control, 10 * period)
        values, left = np.linalg.eig(linearise(kite, x0, control).A.T)
        w = left[:, np.argmax(values.real)]  # w · x is the part of x in the least stable mode
        change = (w @ (later - x0)) / (w @ (x - x0))
        assert (abs(change) > 1) == grows
        assert abs(change) == pytest.approx(exp(10 * period * growth(there).real), rel=1e-4)
        assert abs(np.angle(change)) < 10 * 2 * pi * 0.01  # ten rounds, each in a period


@pytest.mark.parametrize("model", SAME)
def test_models_lose_stability_at_the_same_value(model: str) -> None:
    reference, other = lost(LAKSA), lost(LAKSA, model)
    assert other.value == pytest.approx(reference.value, rel=1e-7)
    assert other.omega == pytest.approx(reference.omega, rel=1e-7)
    assert other.above
    assert other.mode == "sway + yaw swing"


def test_the_threshold_is_that_of_a_kite_twice_as_large() -> None:
    # Froude: lengths s, masses s³, inertia s⁵, speeds √s leave every coefficient what it is
    s = 2.0
    k, w = LAKSA.kite, LAKSA.wind
    large = LAKSA._replace(
        kite=k._replace(
            mass=s**3 * k.mass,
            inertia_x=s**5 * k.inertia_x,
            inertia_y=s**5 * k.inertia_y,
            inertia_z=s**5 * k.inertia_z,
            chord=s * k.chord,
            span=s * k.span,
            area=s**2 * k.area,
            x_A=s * k.x_A,
            y_A=s * k.y_A,
            z_A=s * k.z_A,
        ),
        lines=LAKSA.lines._replace(length=s * LAKSA.lines.length),
        wind=w._replace(speed=s**0.5 * w.speed),
        aero=with_value(LAKSA, "aero.V_ref", s**0.5 * 7.0).aero,
    )
    small, big = lost(LAKSA), lost(large)
    assert big.value == pytest.approx(small.value, rel=1e-8)
    assert big.omega == pytest.approx(small.omega / s**0.5, rel=1e-8)


def test_V_ref_stays_what_the_set_says_in_another_wind() -> None:
    windy = with_value(LAKSA, "wind.speed", 10.0)
    assert stability(windy).V_ref == 7.0
    assert lost(windy).value < 1.5 * lost(with_value(windy, "aero.V_ref", 10.0)).value < 0


def test_lines_that_are_varied_take_the_kite_with_them() -> None:
    unsteady = with_value(LAKSA, "aero.Cl_beta", -0.32)
    found = crossings(unsteady, "lines.length", 40.0, 300.0)
    for crossing in found:
        there = with_value(unsteady, "lines.length", crossing.value)
        assert crossing.unit == "m"
        assert lost(there).value == pytest.approx(-0.32, rel=1e-8)


def test_a_map_shows_what_single_points_do() -> None:
    found = stability_map(LAKSA, ("aero.Cl_beta", -0.8, 0.0), ("wind.speed", 2.0, 12.0), 11)
    assert found.real.shape == (11, 11)
    assert np.isnan(found.real[0]).all()  # 2 m/s: too weak
    assert np.isfinite(found.real[1:]).all()
    row = found.y.values.tolist().index(7.0)
    there = with_value(LAKSA, "aero.Cl_beta", float(found.x.values[3]))
    single = growth(there)
    assert found.real[row, 3] == pytest.approx(single.real, rel=1e-12)
    assert found.omega[row, 3] == pytest.approx(single.imag, rel=1e-12)
    unstable = found.x.values[found.real[row] > 0]
    assert unstable.max() < lost(LAKSA).value < unstable.max() + 0.08
    rows = map_table(found).rows
    assert len(rows) == 121
    point = (found.x.values[3], 7.0, found.real[row, 3], found.omega[row, 3])
    assert rows[11 * row + 3] == point


def test_every_named_parameter_can_be_set() -> None:
    for name in parameter_names(LAKSA):
        assert value_of(with_value(LAKSA, name, 0.125), name) == 0.125


@pytest.mark.parametrize(
    ("name", "low", "high", "says"),
    [
        ("aero.Cl_bet", 0.0, 1.0, "aero.Cl_bet is not known.*aero.Cl_beta.*kite.mass"),
        ("limits.alpha_stall", 0.1, 0.5, "is not known"),
        ("aero.Cl_beta", -0.1, 0.0, "no stability is lost"),
        ("aero.Cl_beta", -0.1, -0.2, "must ascend"),
        ("wind.speed", 0.5, 2.0, "no equilibrium for wind.speed from 0.5 to 2 m/s"),
        ("kite.mass", -1.0, 2.0, "kite.mass must be > 0 kg, got -1"),
        ("lines.length", 1.0, 100.0, "lines.length must be > kite.y_A"),
    ],
)
def test_a_range_without_an_answer_is_one_sentence(
    name: str, low: float, high: float, says: str
) -> None:
    with pytest.raises(InputError, match=says) as caught:
        crossings(LAKSA, name, low, high)
    assert "\n" not in str(caught.value)


def test_maps_refuse_what_they_cannot_draw() -> None:
    C = ("aero.Cl_beta", -0.5, 0.0)
    with pytest.raises(InputError, match="two different parameters"):
        stability_map(LAKSA, C, C)
    with pytest.raises(InputError, match="no equilibrium anywhere"):
        stability_map(LAKSA, C, ("wind.speed", 0.5, 1.5), 3)
    with pytest.raises(InputError, match="2 or more points"):
        stability_map(LAKSA, C, ("wind.speed", 5.0, 6.0), 1)


def test_a_result_cannot_be_changed() -> None:
    found = stability(LAKSA)
    with pytest.raises(AttributeError):
        found.V_ref = 1.0  # type: ignore[misc]
    assert replace(found, V_ref=None).V_ref is None


def test_a_sentence_says_what_the_table_says() -> None:
    """The time to half or double is ln 2 of the table's time constant, here of laksa's modes."""
    stable = stability(LAKSA)
    assert stable.modes[0].time_constant * np.log(2) == pytest.approx(10.4, abs=0.05)
    assert stable.in_words == "stable; slowest: sideways, halved in 10 s"
    unstable = stability(with_value(LAKSA, "aero.Cl_beta", -0.6))
    swing, time = 1 / unstable.modes[0].frequency, unstable.modes[0].time_constant * np.log(2)
    assert (swing, time) == (pytest.approx(8.0, abs=0.05), pytest.approx(4.1, abs=0.05))
    told = "unstable: swinging sideways, 8 s a swing, doubled in 4.1 s"
    assert unstable.in_words == told
    first = unstable.modes[0]
    both = replace(unstable, modes=[first, first])
    assert both.in_words == f"{told}; others that grow: 1"
    for real in (-1e-12, 0.0, 1e-12):
        border = replace(stable, modes=[stable.modes[0]._replace(real=real, error=1e-11)])
        assert border.in_words.startswith("on the border of stability: sideways")


@pytest.mark.parametrize("command", ["trim", "stability"])
def test_commands_end_in_that_sentence(command: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main([command, "rest_200m"]) == 0
    last = capsys.readouterr().out.splitlines()[-1]
    where = "at elevation 67.1°, 186 m high: " if command == "trim" else ""
    assert last == f"{where}stable; slowest: sideways, halved in 10 s"
