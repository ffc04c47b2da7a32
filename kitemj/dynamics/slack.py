"""A line that would push goes slack; one that has run out catches, and takes energy, never gives.

A slack line's constraint is switched off. The step in which it runs out is cut at that
moment; there the line pulls with the impulse that stops it outrunning what is paid out
(plastic: the kinetic energy along the line is lost), and holds again from there on. Both
lines share that impulse where the other is taut; a line that would have to push for it
goes slack instead. A kite may so rock from line to line, ever faster and weaker: below
`QUIET` both lines hold at once. Each of these is a projection of the velocity in the
metric of the masses, so none gives energy.
"""

from kitemj.dynamics.engine import Engine, body_of, place
from kitemj.dynamics.motion import Body, attachment_E
from kitemj.dynamics.taut import SIDES, Line, line_of, mobility, settle, spin_of
from kitemj.physics.compiled import compiled
from kitemj.physics.parameters import Parameters
from kitemj.physics.steering import Control, Programme, control, line_motion
from kitemj.physics.vectors import norm, plus, times

TAUT = 1e-9
"""m; a slack line this much too long has run out: above rounding, below what is measured."""

QUIET = 0.01
"""m/s; slower catches stop the other line too: 10 µJ for a kite of 0.2 kg."""


@compiled
def excess(parameters: Parameters, c: Control, body: Body, side: float) -> float:
    """How much [m] the line is longer than what is paid out; negative: slack."""
    distance = norm(attachment_E(parameters, body, side))
    return distance - line_motion(parameters.kite.y_A, c, side).length


@compiled
def excess_rate(parameters: Parameters, c: Control, line: Line, side: float) -> float:
    """How fast [m/s] the line outruns what is paid out."""
    return line.rate - line_motion(parameters.kite.y_A, c, side).rate


@compiled
def pulled(parameters: Parameters, body: Body, line: Line, impulse: float) -> Body:
    """The body after the line pulled with `impulse` [N s] at once."""
    kite = parameters.kite
    J = times(-impulse, line.arm_B)
    return Body(
        body.p_G_E,
        body.R_BE,
        plus(body.v_G_E, times(-impulse / kite.mass, line.u_E)),
        plus(body.omega_B, spin_of(parameters, J)),
    )


@compiled
def release(engine: Engine, parameters: Parameters) -> None:
    """Lets each line go slack that pushes, unless lines are rigid."""
    if parameters.lines.rigid:
        return
    for i in range(2):
        if engine.eq_active[i] and engine.softness[i] > 0.0:
            engine.eq_active[i] = 0
            engine.softness[i] = 0.0


@compiled
def slack_excess(
    engine: Engine, parameters: Parameters, programme: Programme, t: float, i: int
) -> float:
    """How much [m] line `i` of the engine's present state is too long at time `t` [s]."""
    return excess(parameters, control(programme, t), body_of(engine), SIDES[i])


@compiled
def run_out(engine: Engine, parameters: Parameters, programme: Programme, t: float) -> int:
    """The slack line (0 or 1) that is the most too long at time `t` [s]; -1: none is."""
    worst, line = TAUT, -1
    for i in range(2):
        if not engine.eq_active[i]:
            over = slack_excess(engine, parameters, programme, t, i)
            if over > worst:
                worst, line = over, i
    return line


@compiled
def catch(engine: Engine, parameters: Parameters, programme: Programme, t: float, i: int) -> None:
    """Line `i` holds from now on: it takes the speed at which it outran its length."""
    body, c, k = body_of(engine), control(programme, t), 1 - i
    line, other = line_of(parameters, body, SIDES[i]), line_of(parameters, body, SIDES[k])
    too_fast = excess_rate(parameters, c, line, SIDES[i])
    own = mobility(parameters, line, line)
    alone = max(0.0, too_fast / own)
    body_alone = pulled(parameters, body, line, alone)
    if not engine.eq_active[k]:
        body = body_alone
    else:
        also = excess_rate(parameters, c, other, SIDES[k])
        theirs, cross_term = mobility(parameters, other, other), mobility(parameters, line, other)
        D = own * theirs - cross_term * cross_term
        first = (theirs * too_fast - cross_term * also) / D
        second = (own * also - cross_term * too_fast) / D
        if too_fast < QUIET or (first >= 0.0 and second >= 0.0):
            body = pulled(parameters, pulled(parameters, body, line, first), other, second)
        else:
            body = body_alone
            engine.eq_active[k] = 0
            engine.softness[k] = 0.0
    place(engine, body)
    engine.eq_active[i] = 1
    settle(engine, parameters, programme, t)
