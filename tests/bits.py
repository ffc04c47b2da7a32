"""Every formula's results at random states, bit by bit: run as a program, it prints them.

``NUMBA_DISABLE_JIT=1 python -m tests.bits`` takes the interpreter's way.
"""

from collections.abc import Iterator

import numba

from kitemj.dynamics import lagrange, newton_euler, straight, taut
from kitemj.dynamics.motion import angles_of, energy
from kitemj.physics.aerodynamics import TableAero
from kitemj.physics.frames import quaternion
from kitemj.physics.loads import aerodynamic_wrench, air
from kitemj.physics.steering import Sines, control, line_motion
from kitemj.physics.wind import wind_velocity
from tests.support import random_cases

CASES = 300
TABLE = TableAero(
    tuple(
        tuple((0.1 * i - 0.2, 0.03 * k - 0.1, 0.01 * (i + k)) for k in range(8)) for i in range(6)
    ),
    (0.1, -0.05, 0.02),
)


def results() -> dict[str, list[object]]:
    """By formula, what it says of each case."""
    said: dict[str, list[object]] = {}
    for case in random_cases(CASES):
        parameters, state, segment = case
        c = segment.control
        sines = Sines(c.ell, c.delta, 0.1, 0.7, 1.0, 0.3)
        body = lagrange.body(parameters, *state, c)
        general = parameters._replace(aero=TABLE)
        where = (body.p_G_E, body.R_BE, body.v_G_E)
        free = newton_euler.placed(parameters, segment, state)
        for name, value in (
            ("wind", wind_velocity(parameters.wind, body.p_G_E, 1.3)),
            ("air", air(parameters, *where, 1.3)),
            ("wrench", aerodynamic_wrench(parameters, *where, body.omega_B, 1.3)),
            ("wrench of a table", aerodynamic_wrench(general, *where, body.omega_B, 1.3)),
            ("control", control(sines, 1.3)),
            ("line motion", line_motion(parameters.kite.y_A, control(sines, 1.3), -1.0)),
            ("quaternion", quaternion(body.R_BE)),
            ("angles", angles_of(parameters, body)),
            ("energy", energy(parameters, body)),
            ("lagrange: body", body),
            ("lagrange: accelerations", lagrange.accelerations(parameters, c, 1.3, *state)),
            ("newton-euler: placed", free),
            ("newton-euler: rates", newton_euler.rates(parameters, segment, 0.0, free)),
            ("newton-euler: corrected", newton_euler.corrected(parameters, segment, 0.0, free)),
            ("mujoco: straight body", straight.straight_body(parameters, *state, c)),
            ("mujoco: line", taut.line_of(parameters, body, 1.0)),
        ):
            said.setdefault(name, []).append(value)
    return said


def numbers(value: object) -> Iterator[float]:
    """The numbers in nested tuples."""
    if isinstance(value, tuple):
        for part in value:
            yield from numbers(part)
    else:
        yield float(value)  # type: ignore[arg-type]


if __name__ == "__main__":
    print("compiled", float(not numba.config.DISABLE_JIT).hex(), sep="\t")
    for name, values in results().items():
        print(name, *(number.hex() for number in numbers(tuple(values))), sep="\t")
