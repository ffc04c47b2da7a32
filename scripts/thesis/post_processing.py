"""Appendix A: every quantity of LAKSA's post-processing, with its value at one time of a flight."""

from math import asin, atan2, degrees
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from kitemj.dynamics.motion import Motion, attachment_E
from kitemj.dynamics.newton_euler import Accelerations, accelerations
from kitemj.flight.scenario import Scenario, scenario_of
from kitemj.flight.simulate import simulate
from kitemj.physics.loads import aerodynamic_wrench
from kitemj.tables import Cell, Table
from thesis.section import Answer, NamedTable, Section, Verdict

Array = NDArray[np.float64]

WHEN = 20.0
"""s; the moment that is looked at, of a flight with δ = 0.1 rad · sin(0.1 rad/s · t)."""
ANSWERS = tuple(
    Answer(
        f"Table {number}",
        Verdict.REPRODUCED,
        "all its quantities, with their values at one moment of a flight",
        "instant",
    )
    for number in (12, 13, 14)
)


def section(scratch: Path) -> Section:
    """Of the set thesis, by the model newton-euler."""
    table, left_over = post_processing_table()
    return Section(
        "What is known of an instant (appendix A)",
        ANSWERS,
        thesis=[
            "Tables 12 to 14 name what LAKSA's Fun_Post_KA computes of a state: kinematics, "
            "forces and moments, angles of the air and lengths of the lines.",
        ],
        here=[
            f"All of it at t = {WHEN:g} s of a flight with δ = 0.1 rad · sin(0.1 rad/s · t), under "
            "the thesis's names and ours. Here an instant is a Motion "
            "(kitemj/dynamics/motion.py), which pictures, recordings and comparisons are made of; "
            "accelerations and forces follow from it and are not stored.",
            "Two sums must vanish: all forces less m a, and all moments about G less the change "
            f"of angular momentum. Of them {left_over[0]:.0e} N and {left_over[1]:.0e} N m are "
            "left, by rounding.",
        ],
        tables=[NamedTable("instant", table)],
    )


def post_processing_table() -> tuple[Table, tuple[float, float]]:
    """A row for each quantity; what is left over of force [N] and moment [N m]."""
    steering = {"programme": "sine", "delta_amplitude": 0.1, "delta_frequency": 0.1}
    scenario = scenario_of({"set": "thesis", "duration": WHEN, "steering": steering}, "instant")
    motion = simulate(scenario, "newton-euler").motions[-1]
    now = accelerations(scenario.parameters, scenario.programme, WHEN, motion.body)
    return _table(scenario, motion, now)


def _table(
    scenario: Scenario, motion: Motion, now: Accelerations
) -> tuple[Table, tuple[float, float]]:
    parameters, body = scenario.parameters, motion.body
    kite = parameters.kite
    R, G = np.array(body.R_BE), np.array(body.p_G_E)
    line_forces, line_moments = [], []
    for side, tension in zip((1.0, -1.0), motion.tensions, strict=True):
        p_A = np.array(attachment_E(parameters, body, side))
        line_forces.append(-tension * p_A / np.linalg.norm(p_A))
        line_moments.append(np.cross(p_A - G, line_forces[-1]))
    air = aerodynamic_wrench(parameters, *body, WHEN)
    force, moment = R.T @ np.array(air.force), R.T @ np.array(air.moment)
    weight = np.array([0.0, 0.0, kite.mass * parameters.environment.gravity])
    omega, omega_dot = np.array(body.omega_B), np.array(now.omega_dot_B)
    tensor = np.diag([kite.inertia_x, kite.inertia_y, kite.inertia_z])
    tensor[0, 2] = tensor[2, 0] = -kite.inertia_xz
    spin = R.T @ (tensor @ omega_dot + np.cross(omega, tensor @ omega))
    left_over = (
        float(np.linalg.norm(force + sum(line_forces) + weight - kite.mass * np.array(now.a_G_E))),
        float(np.linalg.norm(moment + sum(line_moments) - spin)),
    )
    euler = (atan2(R[0, 1], R[0, 0]), asin(-R[0, 2]), atan2(R[1, 2], R[2, 2]))
    yaw_pitch_roll = np.degrees(euler)
    rows: list[tuple[Cell, ...]] = [
        *(
            _row(12, "RBE", f"R_BE, row {axis}", "", row)
            for axis, row in zip("xyz", R, strict=True)
        ),
        _row(12, "rk", "p_G_E", "m", G),
        _row(12, "vk", "v_G_E", "m/s", body.v_G_E),
        _row(12, "ak", "a_G_E", "m/s²", now.a_G_E),
        _row(12, "euler", "yaw, pitch, roll", "°", yaw_pitch_roll),
        _row(12, "omega", "ω in E", "rad/s", R.T @ omega),
        _row(12, "omega_p", "ω in B", "rad/s", omega),
        _row(12, "omega_p", "ω̇ in B", "rad/s²", omega_dot),
        _row(13, "Lambda", "tensions of A₊, A₋", "N", motion.tensions),
        _row(13, "FAP", "force at A₊ in E", "N", line_forces[0]),
        _row(13, "FAM", "force at A₋ in E", "N", line_forces[1]),
        _row(13, "MAP", "moment of it about G, in E", "N m", line_moments[0]),
        _row(13, "MAM", "moment of it about G, in E", "N m", line_moments[1]),
        _row(13, "FA", "force of the air in E", "N", force),
        _row(13, "MA", "moment of the air in E", "N m", moment),
        _row(13, "W", "weight in E", "N", weight),
        _row(14, "alpha", "α", "°", [degrees(motion.air.alpha)]),
        _row(14, "beta", "β", "°", [degrees(motion.air.beta)]),
        _row(14, "LP, LM", "lengths of the lines of A₊, A₋", "m", motion.lengths),
    ]
    columns = ("table", "thesis", "here", "unit", "first", "second", "third")
    return Table(f"The kite at t = {WHEN:g} s", columns, rows), left_over


def _row(
    table: int, name: str, here: str, unit: str, values: "Array | tuple[float, ...] | list[float]"
) -> tuple[Cell, ...]:
    filled = [*map(float, values), *[float("nan")] * (3 - len(values))]
    return (table, name, here, unit, *filled)
