"""The numbers that a picture shows beside what is in the motion."""

from typing import NamedTuple

from kitemj.drawing.history import Traces
from kitemj.drawing.wished import Wished
from kitemj.physics.shaping import StickLaw
from kitemj.pilots.course import LessonStatus
from kitemj.pilots.crash import Touch


class Readings(NamedTuple):
    """Numbers shown that are not in the motion."""

    model: str = "mujoco"
    gap: float | None = None  # m, distance to the reference
    delta_command: float = 0.0  # rad, what the stick asks for, if it asks for δ
    law: StickLaw = StickLaw.ANGLE  # what it asks for; the same part of another limit
    missed_ticks: int = 0
    lateness: float = 0.0  # s, of the last tick
    assist: bool = False  # whether an assist stands between the stick and the lines
    stick: str = ""  # what steers: "gamepad", "keys", "programme"
    speed: float = 1.0  # simulated time over wall time
    message: str = ""  # one line that must be seen
    traces: Traces | None = None  # what a History remembers
    lesson: LessonStatus | None = None
    touch: Touch | None = None  # how the kite met the ground
    wished: Wished | None = None  # what the autopilot flies, where it does
    help: tuple[str, ...] = ()  # lines over everything; a tab parts a key from what it does
