"""Every command that writes a file, in short, and what they need in a folder."""

import tempfile
from functools import cache
from pathlib import Path

from kitemj.flight.live import Command
from kitemj.recording.live import LiveFlight

SHORT = 'set = "sport"\nduration = 0.2\noutput_interval = 0.02\n'
STUDY = f'[scenario]\n{SHORT}[grid]\n"wind.speed" = [6.0, 7.0, 8.0]\nmodel = ["lagrange"]\n'
TICKS = 20
PIXELS = ["--size", "320x180"]
COMMANDS = {
    "simulate": ["simulate", "s.toml", "--output", "a.csv"],
    "trim json": ["trim", "s.toml", "--output", "a.json"],
    "trim csv": ["trim", "s.toml", "--output", "a.csv"],
    "trim parquet": ["trim", "s.toml", "--output", "a.parquet"],
    "trim figure": ["trim", "s.toml", "--save", "a.png"],
    "stability": ["stability", "s.toml", "--output", "a.json"],
    "compare": ["compare", "s.toml", "--models", "lagrange,newton-euler", "--markdown", "a.md"],
    "limits": ["limits", "s.toml", "--save", "a.svg"],
    "plot": ["plot", "s.toml", "--save", "a.png"],
    "plot pdf": ["plot", "s.toml", "--save", "a.pdf"],
    "export": ["replay", "a.arrows", "--export", "csv", "--output", "a.csv"],
    "film": ["film", "a.arrows", "--output", "a.mp4", "--to", "0.1", *PIXELS],
    "gif": ["film", "a.arrows", "--output", "a.gif", "--to", "0.1", *PIXELS],
    "still": ["film", "a.arrows", "--output", "a.png", "--still", "0.1", *PIXELS],
    "sweep": ["sweep", "study.toml", "--output", "a.parquet", "--processes", "1"],
}
"""Each writes a file that begins with `a`."""


def prepare(folder: Path) -> None:
    """A scenario, a study and a recording."""
    (folder / "s.toml").write_text(SHORT, encoding="utf-8")
    (folder / "study.toml").write_text(STUDY, encoding="utf-8")
    (folder / "a.arrows").write_bytes(_recording())


@cache
def _recording() -> bytes:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "a.arrows"
        with LiveFlight({"set": "sport", "duration": 1.0}, record=path) as flight:
            for _ in range(TICKS):
                flight.tick(Command(0.1))
        return path.read_bytes()
