"""The machine of phases: what is flown when, and when it is over.

The phases of the settings are flown in turn, each until it is over. Two are also flown in between:
`climb`, when the path was lost, and `untwist`, when the lines are wound up too far; both lead back.
Whatever the phase, a dive that would end too low is turned up first; not in a launch, at the edge
to land, or in a loop, which has begun where there is room for it.
"""

from collections.abc import Callable
from math import cos, isnan, nan
from typing import NamedTuple

from kitemj.autopilot import edges, laps, untwist
from kitemj.autopilot.follow import NEAR, Estimate
from kitemj.autopilot.joining import NOWHERE
from kitemj.autopilot.memory import Asked, Kite, Memory, upward
from kitemj.flight.pilot_settings import PhaseName


class Phase(NamedTuple):
    """What a phase does and until when, in words; what it asks for, and whether it is over.

    `between`: which phases come in between, and when.
    """

    does: str
    until: str
    ask: Callable[[Kite, Estimate, Memory], Asked]
    over: Callable[[Kite, Estimate, Memory], bool]
    between: tuple[tuple[Callable[[Kite, Estimate, Memory], bool], PhaseName], ...] = ()


PHASES: dict[PhaseName, Phase] = {
    "launch": Phase(
        "from the ground at the edge: the nose up, leaning to the middle",
        "25° high, or 0.8 of the height of rest",
        edges.launch,
        edges.airborne,
    ),
    "climb": Phase(
        "to the path, on a way that bends into it and keeps off the ground",
        "on the path to 2°, its course to 11°",
        laps.climb,
        laps.joined,
    ),
    "path": Phase(
        "along the path, learning from lap to lap",
        "`laps` are flown",
        laps.path,
        laps.flown,
        ((untwist.wound_up, "untwist"), (laps.lost, "climb")),
    ),
    "untwist": Phase(
        "up to the middle, and from there loops against the twist",
        "less than half a turn of twist is left",
        untwist.untwist,
        untwist.untwisted,
    ),
    "hold": Phase(
        "at `azimuth`, as high as the wind lifts the kite",
        "`hold` seconds are over",
        edges.hold,
        edges.held,
    ),
    "land": Phase(
        "low to the edge on `side`, the nose out of the window, and down",
        "the ground",
        edges.land,
        edges.never,
    ),
}
"""By name."""

BACK: dict[PhaseName, PhaseName] = {"climb": "path", "untwist": "climb"}
"""Where a phase leads that was flown in between."""


def flown(kite: Kite, seen: Estimate, memory: Memory) -> Asked:
    """What the phase asks for that is on now, and what is remembered."""
    memory = changed(kite, seen, memory)
    asked = PHASES[memory.phase].ask(kite, seen, memory)
    return turned_up(kite, seen, asked)


def changed(kite: Kite, seen: Estimate, memory: Memory) -> Memory:
    """The memory in the phase that is on now."""
    named, phase = kite.settings.phases, PHASES[memory.phase]
    if phase.over(kite, seen, memory):
        if memory.phase != named[memory.step]:
            return begun(kite, memory, BACK[memory.phase], memory.step)
        if memory.step + 1 < len(named):
            return begun(kite, memory, named[memory.step + 1], memory.step + 1)
    for needed, other in phase.between:
        if needed(kite, seen, memory):
            return begun(kite, memory, other, memory.step)
    return memory


def begun(kite: Kite, memory: Memory, phase: PhaseName, step: int) -> Memory:
    """The memory at the beginning of a phase."""
    so_far = laps.laps(kite, memory) if memory.phase == "path" else memory.laps
    memory = memory._replace(step=step, phase=phase, since=memory.t, laps=so_far)
    return memory._replace(
        progress=nan, way=NOWHERE, planned=nan, pressed=0.0, at_edge=False, goal=nan
    )


def turned_up(kite: Kite, seen: Estimate, asked: Asked) -> Asked:
    """What is asked for; instead, in a dive off the path that would end too low, the nose up."""
    guidance, memory = asked
    on_path = not isnan(guidance.progress) and abs(guidance.error) < NEAR
    looping, launched = not isnan(memory.goal), memory.phase == "launch"
    if on_path or looping or launched or memory.at_edge or cos(seen.course) > 0.0:
        return Asked(guidance, memory._replace(refused=0.0))
    up, side, low = upward(kite, seen, memory)
    if low > kite.low:
        return Asked(guidance, memory._replace(refused=0.0))
    return Asked(up, memory._replace(refused=side))
