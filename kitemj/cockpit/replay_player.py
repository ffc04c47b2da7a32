"""The position and speed of a replay; it has no clock and no window of its own."""

from dataclasses import dataclass

SPEEDS = (0.05, 0.1, 0.25, 0.5, 1.0, 2.0, 5.0, 10.0, 50.0)


@dataclass
class Player:
    """`t` [s] of `duration` [s]; plays `speed` times as fast as it was flown."""

    duration: float
    t: float = 0.0
    playing: bool = True
    speed: float = 1.0

    def advance(self, wall: float) -> None:
        """Lets `wall` [s] pass; stops at the end."""
        if self.playing:
            self.seek(self.t + wall * self.speed)
            self.playing = self.t < self.duration

    def seek(self, t: float) -> None:
        """Goes to `t` [s], or to the end that is nearer."""
        self.t = min(max(t, 0.0), self.duration)

    def toggle(self) -> None:
        """Plays or pauses; from the end it begins anew."""
        self.playing = not self.playing
        if self.playing and self.t >= self.duration:
            self.t = 0.0

    def change_speed(self, by: int) -> None:
        """Changes to the next of `SPEEDS` up (+1) or down (-1)."""
        self.speed = SPEEDS[min(max(SPEEDS.index(self.speed) + by, 0), len(SPEEDS) - 1)]
