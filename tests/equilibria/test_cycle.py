"""The cycles a kite flies by itself: closed, mirrored, attracting, the same in every model."""

from math import exp, pi, sqrt
from pathlib import Path

import numpy as np
import pytest

from kitemj.dynamics.formulation import MODELS
from kitemj.dynamics.lagrange_kite import LagrangeKite
from kitemj.equilibria.cycle import Cycle, cycle
from kitemj.equilibria.linearise import state_units
from kitemj.equilibria.minimal import Minimal, held, state_of, steps_for
from kitemj.equilibria.modes import crossings, stability
from kitemj.equilibria.orbit import range_of
from kitemj.equilibria.shooting import monodromy
from kitemj.equilibria.tables import matrices
from kitemj.equilibria.vary import with_value
from kitemj.errors import InputError
from kitemj.physics.parameter_files import parameter_set
from kitemj.physics.parameters import Parameters
from kitemj.physics.steering import Segment, rest_ell

SETS = {
    name: with_value(parameter_set(name), "aero.Cl_beta", -0.49) for name in ("laksa", "thesis")
}
MIRROR = np.array([-1, 1, -1, 1, -1, 1, -1, 1])
SAME_PERIOD = 1e-6
"""Relative; the engine's steps of 5 ms differ from the reference by 1e-9."""
SAME_RANGE = 1e-5
"""Relative; of swings and tensions."""


@pytest.fixture(scope="module", params=SETS)
def case(request: pytest.FixtureRequest) -> tuple[Parameters, Cycle]:
    return SETS[request.param], cycle(SETS[request.param])


def ell_of(parameters: Parameters) -> float:
    return rest_ell(parameters.lines.length, parameters.kite.y_A)


def test_the_cycle_closes_by_another_integrator(case: tuple[Parameters, Cycle]) -> None:
    parameters, found = case
    kite, programme = LagrangeKite(parameters), Segment(0.0, held(ell_of(parameters)))
    kite.start(state_of(found.x0), programme)
    kite.trajectory(programme, [0.0, found.period])
    end = np.array([*kite.state.q, *kite.state.q_dot])
    assert end == pytest.approx(found.x0, abs=1e-7)


def test_once_round_is_once_round(case: tuple[Parameters, Cycle]) -> None:
    parameters, found = case
    kite, control = Minimal("lagrange", parameters), held(ell_of(parameters))
    for part in (2, 3, 4):
        gap = kite.flow(found.x0, control, found.period / part) - found.x0
        assert np.abs(gap).max() > 0.1


def test_the_second_half_mirrors_the_first(case: tuple[Parameters, Cycle]) -> None:
    parameters, found = case
    kite, control = Minimal("lagrange", parameters), held(ell_of(parameters))
    half = kite.flow(found.x0, control, found.period / 2)
    assert half == pytest.approx(MIRROR * found.x0, abs=1e-7)
    orbit = found.orbit
    assert orbit.tension_plus == pytest.approx(orbit.tension_minus, rel=1e-6)
    assert orbit.phi.low == pytest.approx(-orbit.phi.high, rel=1e-6)


def test_the_kite_comes_back_to_it_as_fast_as_the_multipliers_say(
    case: tuple[Parameters, Cycle],
) -> None:
    parameters, found = case
    assert found.stable
    assert found.trivial < 1e-6
    assert found.multipliers[-1] == pytest.approx(1.0, abs=1e-6)
    kite, control = Minimal("lagrange", parameters), held(ell_of(parameters))
    units = state_units(parameters, control.ell)
    steps = steps_for(found.period)
    M = monodromy(kite, found.x0, found.period, control, steps, units)
    e = 1e-5 * np.array([1, 1, -1, 1, 1, -1, 1, 1])
    x, predicted = found.x0 + units * e, e
    for _ in range(6):
        x = kite.flow(x, control, found.period, steps)
        predicted = M @ predicted
    assert (x - found.x0) / units == pytest.approx(predicted, abs=4e-7)

    changes = []  # from round to round: only the phase is left, which does not change
    for _ in range(10):
        before, x = x, kite.flow(x, control, found.period, steps)
        changes.append(np.linalg.norm((x - before) / units))
    assert changes[8] < changes[0] * (abs(found.multipliers[0]) + 0.1) ** 8


def test_it_stays_within_validity_and_crosses_the_wind(case: tuple[Parameters, Cycle]) -> None:
    parameters, found = case
    orbit = found.orbit
    assert found.departure is None
    assert orbit.tension_plus.low > 0
    assert orbit.y_E.swing > 2 * parameters.kite.span
    assert orbit.airspeed.high > 1.2 * parameters.wind.speed
    assert orbit.motions[-1].t == pytest.approx(found.period)


@pytest.mark.parametrize("model", [name for name in MODELS if name != "lagrange"])
def test_the_other_models_fly_the_same_cycle(model: str) -> None:
    parameters = SETS["thesis"]
    reference, other = cycle(parameters), cycle(parameters, model=model)
    assert other.model == model
    assert other.period == pytest.approx(reference.period, rel=SAME_PERIOD)
    assert other.orbit.phi.swing == pytest.approx(reference.orbit.phi.swing, rel=SAME_RANGE)
    for line in ("tension_plus", "tension_minus"):
        assert getattr(other.orbit, line) == pytest.approx(
            getattr(reference.orbit, line), rel=SAME_RANGE
        )
    assert other.multipliers[:3] == pytest.approx(reference.multipliers[:3], abs=1e-4)


def test_a_cycle_is_born_small_at_the_threshold_with_its_period() -> None:
    laksa = parameter_set("laksa")
    (lost,) = crossings(laksa, "aero.Cl_beta", -1.0, 0.0)
    near, further = (
        cycle(with_value(laksa, "aero.Cl_beta", lost.value - beyond)) for beyond in (5e-4, 2e-3)
    )
    assert near.period == pytest.approx(2 * pi / lost.omega, rel=1e-3)
    ratio = further.orbit.phi.swing / near.orbit.phi.swing
    assert ratio == pytest.approx(sqrt(4), rel=0.02)  # Hopf: the swing grows as a square root
    # and what is left of a disturbance after a round is exp(-2 growth T), also Hopf's
    grows = stability(with_value(laksa, "aero.Cl_beta", lost.value - 5e-4)).modes[0].real
    assert abs(near.multipliers[0]) == pytest.approx(exp(-2 * grows * near.period), rel=1e-3)


def test_a_cycle_is_found_after_a_start_that_loops() -> None:
    # the settling flight goes round the sky's pole and comes back a turn later
    found = cycle(with_value(parameter_set("laksa"), "aero.Cl_beta", -0.6))
    assert found.stable
    assert found.period == pytest.approx(7.8906, abs=1e-3)


def test_a_stable_kite_has_no_cycle_to_grow_into() -> None:
    with pytest.raises(InputError, match="the equilibrium is stable"):
        cycle(parameter_set("laksa"))


def test_a_flight_that_finds_no_cycle_says_so() -> None:
    with pytest.raises(InputError, match="no cycle"):
        cycle(with_value(parameter_set("laksa"), "aero.Cl_beta", -2.0))


def test_extremes_are_those_between_the_samples() -> None:
    t = np.linspace(0, 2 * pi, 101)
    found = range_of(3 + 2 * np.sin(t - 0.017))
    assert found == pytest.approx((1.0, 5.0), abs=1e-6)
    assert found.swing == pytest.approx(2.0, abs=1e-6)


def test_tables_hold_the_numbers_in_named_units(case: tuple[Parameters, Cycle]) -> None:
    parameters, found = case
    rows = {row["quantity"]: row for row in found.tables()[0].records()}
    assert rows["phi"]["unit"] == "deg"
    assert rows["phi"]["swing"] == pytest.approx(np.degrees(found.orbit.phi.swing))
    assert rows["tension_plus"]["high"] == found.orbit.tension_plus.high
    assert len(found.tables()[1].rows) == 8
    unstable = stability(parameters)
    assert unstable.tables()[0].rows[0][2] == unstable.modes[0].real > 0
    assert matrices(unstable.linear)["B"] == unstable.linear.B.tolist()


def test_figures_are_drawn_and_saved(case: tuple[Parameters, Cycle], tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    from kitemj.equilibria import plots
    from kitemj.equilibria.maps import stability_map
    from kitemj.equilibria.trim import equilibria
    from kitemj.plots.figure_output import save_figures

    parameters, found = case
    area = stability_map(parameters, ("aero.Cl_beta", -0.6, 0.2), ("wind.speed", 2.0, 9.0), 8)
    figures = {
        "cycle.png": plots.cycle_figure(found),
        "modes.svg": plots.modes_figure(stability(parameters)),
        "trim.pdf": plots.trim_figure(equilibria(parameters)),
        "map.png": plots.map_figure(area),
    }
    of_one_unit = figures["cycle.png"].axes[0], figures["modes.svg"].axes[1]
    assert [ax.get_aspect() for ax in of_one_unit] == [1.0, 1.0]
    for name, figure in figures.items():
        save_figures({name: figure}, tmp_path / name)
        assert (tmp_path / name).stat().st_size > 5000
    with pytest.raises(InputError, match=r"must end in one of .png, .pdf, .svg"):
        save_figures(figures, tmp_path / "trim.gif")
