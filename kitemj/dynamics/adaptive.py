"""Runge-Kutta of order 8 with error control, compiled: DOP853 without a Python call in a step.

The method of Dormand and Prince with error estimates of orders 5 and 3, in the form and with
the numbers of Hairer, Nørsett, Wanner, "Solving Ordinary Differential Equations I", 2nd ed.
(1993), section II.5. Steps end exactly at the time that is asked for, so there is nothing to
interpolate; the step size that the error allows is kept from one call to the next.
"""

from math import isfinite, sqrt
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from kitemj.physics.compiled import compiled, law

Array = NDArray[np.float64]

STAGES = 12
SAFETY, SMALLEST, LARGEST = 0.9, 0.2, 10.0
"""Of the step size that the error allows: part taken, least and greatest change at once."""

NODES = np.zeros(STAGES)
NODES[1:] = (
    *(0.0526001519587677318785587544488, 0.0789002279381515978178381316732),
    *(0.118350341907227396726757197510, 0.281649658092772603273242802490, 1 / 3, 1 / 4, 4 / 13),
    *(127 / 195, 3 / 5, 6 / 7, 1.0),
)

WEIGHTS = np.zeros((STAGES, STAGES))
"""Row i: the stages before that make stage i."""
WEIGHTS[1, :1] = 5.26001519587677318785587544488e-2
WEIGHTS[2, :2] = 1.97250569845378994544595329183e-2, 5.91751709536136983633785987549e-2
WEIGHTS[3, :3] = 2.95875854768068491816892993775e-2, 0.0, 8.87627564304205475450678981324e-2
WEIGHTS[4, :4] = (
    *(2.41365134159266685502369798665e-1, 0.0),
    *(-8.84549479328286085344864962717e-1, 9.24834003261792003115737966543e-1),
)
WEIGHTS[5, :5] = (
    *(1 / 27, 0.0, 0.0),
    *(1.70828608729473871279604482173e-1, 1.25467687566822425016691814123e-1),
)
WEIGHTS[6, :6] = (
    *(0.037109375, 0.0, 0.0),
    *(1.70252211019544039314978060272e-1, 6.02165389804559606850219397283e-2, -0.017578125),
)
WEIGHTS[7, :7] = (
    *(3.70920001185047927108779319836e-2, 0.0, 0.0),
    *(1.70383925712239993810214054705e-1, 1.07262030446373284651809199168e-1),
    *(-1.53194377486244017527936158236e-2, 8.27378916381402288758473766002e-3),
)
WEIGHTS[8, :8] = (
    *(6.24110958716075717114429577812e-1, 0.0, 0.0),
    *(-3.36089262944694129406857109825, -8.68219346841726006818189891453e-1),
    *(2.75920996994467083049415600797e1, 2.01540675504778934086186788979e1),
    -4.34898841810699588477366255144e1,
)
WEIGHTS[9, :9] = (
    *(4.77662536438264365890433908527e-1, 0.0, 0.0),
    *(-2.48811461997166764192642586468, -5.90290826836842996371446475743e-1),
    *(2.12300514481811942347288949897e1, 1.52792336328824235832596922938e1),
    *(-3.32882109689848629194453265587e1, -2.03312017085086261358222928593e-2),
)
WEIGHTS[10, :10] = (
    *(-9.3714243008598732571704021658e-1, 0.0, 0.0),
    *(5.18637242884406370830023853209, 1.09143734899672957818500254654),
    *(-8.14978701074692612513997267357, -1.85200656599969598641566180701e1),
    *(2.27394870993505042818970056734e1, 2.49360555267965238987089396762),
    -3.0467644718982195003823669022,
)
WEIGHTS[11, :11] = (
    *(2.27331014751653820792359768449, 0.0, 0.0),
    *(-1.05344954667372501984066689879e1, -2.00087205822486249909675718444),
    *(-1.79589318631187989172765950534e1, 2.79488845294199600508499808837e1),
    *(-2.85899827713502369474065508674, -8.87285693353062954433549289258),
    *(1.23605671757943030647266201528e1, 6.43392746015763530355970484046e-1),
)

RESULT = np.zeros(STAGES)
"""What the stages make of a step, order 8."""
RESULT[[0, 5, 6, 7, 8, 9, 10, 11]] = (
    *(5.42937341165687622380535766363e-2, 4.45031289275240888144113950566),
    *(1.89151789931450038304281599044, -5.8012039600105847814672114227),
    *(3.1116436695781989440891606237e-1, -1.52160949662516078556178806805e-1),
    *(2.01365400804030348374776537501e-1, 4.47106157277725905176885569043e-2),
)

ERROR_3 = RESULT.copy()
"""The result less one of order 3."""
ERROR_3[[0, 8, 11]] -= (
    *(0.244094488188976377952755905512, 0.733846688281611857341361741547),
    0.220588235294117647058823529412e-1,
)

ERROR_5 = np.zeros(STAGES)
"""The result less one of order 5."""
ERROR_5[[0, 5, 6, 7, 8, 9, 10, 11]] = (
    *(0.1312004499419488073250102996e-1, -0.1225156446376204440720569753e1),
    *(-0.4957589496572501915214079952, 0.1664377182454986536961530415e1),
    *(-0.3503288487499736816886487290, 0.3341791187130174790297318841),
    *(0.8192320648511571246570742613e-1, -0.2235530786388629525884427845e-1),
)


class Room(NamedTuple):
    """What one integration works in: `x` (n,), the stages' rates, and one stage's x.

    `state` holds (step size that the error allows, whether `rates[0]` is that of `x`,
    evaluations so far).
    """

    x: Array
    rates: Array
    stage: Array
    state: Array


def room_for(x: Array, step: float = 1e-3) -> Room:
    """Room for an integration from `x` (n,), which is copied; `step` [s]: the first to try."""
    n = len(x)
    return Room(x.copy(), np.empty((STAGES, n)), np.empty(n), np.array([step, 0.0, 0.0]))


def _right_side(system: Any, t: float, x: Array, out: Array) -> None:
    """Writes dx/dt of `system` (a ``NamedTuple``) at time `t` [s] and `x` (n,) to `out` (n,)."""
    raise NotImplementedError


right_side, system_law = law(_right_side)


@compiled
def _add(total: Array, weight: float, x: Array) -> None:
    """total += weight x."""
    if weight != 0.0:
        for j in range(len(total)):
            total[j] += weight * x[j]


@compiled
def carried(system: Any, room: Room, t: float, end: float, tolerance: float) -> float:
    """Takes ``room.x`` from time `t` to `end` [s]; the time that was reached.

    `tolerance` bounds the error of a step in each number, relative to its size plus one.
    What was reached is before `end` where no step is short enough: a singular or non-finite
    right-hand side.
    """
    x, rates, stage, state = room
    n = len(x)
    while t < end:
        h, last = state[0], False
        if t + 1.000001 * h >= end:  # no crumb of a step at the end
            h, last = end - t, True
        first = 0 if state[1] == 0.0 else 1
        for i in range(first, STAGES):  # one call of the right side: it is compiled where it stands
            for j in range(n):
                stage[j] = x[j]
            for k in range(i):
                _add(stage, h * WEIGHTS[i, k], rates[k])
            right_side(system, t + NODES[i] * h, stage, rates[i])
        state[1], state[2] = 1.0, state[2] + STAGES - first
        error = _error(room, h, tolerance)  # leaves the new x in `stage`
        if not isfinite(error):
            factor = SMALLEST
        else:
            factor = min(LARGEST, max(SMALLEST, SAFETY * max(error, 1e-30) ** -0.125))
        if error <= 1.0:
            for j in range(n):
                x[j] = stage[j]
            t = end if last else t + h
            state[0] = max(state[0], factor * h) if last else factor * h
            state[1] = 0.0
        else:
            state[0] = min(1.0, factor) * h
            if not state[0] > 1e-14 * max(1.0, abs(t)):
                return t
    return t


@compiled
def _error(room: Room, h: float, tolerance: float) -> float:
    """The step's error over what is allowed (root mean square); its result goes to `stage`."""
    x, rates, stage, _ = room
    by_3, by_5 = 0.0, 0.0
    for j in range(len(x)):
        total, error_3, error_5 = 0.0, 0.0, 0.0
        for k in range(STAGES):
            total += RESULT[k] * rates[k, j]
            error_3 += ERROR_3[k] * rates[k, j]
            error_5 += ERROR_5[k] * rates[k, j]
        stage[j] = x[j] + h * total
        allowed = tolerance * (1.0 + max(abs(x[j]), abs(stage[j])))
        by_3 += (error_3 / allowed) ** 2
        by_5 += (error_5 / allowed) ** 2
    if by_5 == 0.0 and by_3 == 0.0:
        return 0.0
    return abs(h) * by_5 / sqrt((by_5 + 0.01 * by_3) * len(x))
