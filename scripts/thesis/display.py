"""Section 4.5: pictures of the cockpit and its views, painted of a flight in real time."""

from pathlib import Path

import numpy as np
import pygame
from numpy.typing import NDArray

from kitemj.controls.actions import VIEWS
from kitemj.controls.programmed import ProgrammedStick, Row
from kitemj.drawing.picture import Picture
from kitemj.drawing.readings import Readings
from kitemj.errors import NoGraphics
from kitemj.flight.live import TICK
from kitemj.flight.scenario import scenario_of
from thesis.observed_flight import InstrumentedProcess, flight_process, observe, readings_of
from thesis.section import Answer, Drawing, Section, Verdict

ANSWERS = (
    Answer(
        "Figure 29",
        Verdict.NOT_APPLICABLE,
        "a Simulink block diagram; stick, flight and painting meet in kitemj/cockpit/fly.py",
    ),
    Answer(
        "Figure 30",
        Verdict.REPRODUCED,
        "the kite from near and the whole in one frame, as LAKSA has it",
        "display_cockpit",
    ),
    Answer(
        "Figure 31",
        Verdict.DIFFERS,
        "two figures, which saved time in MATLAB, are one frame here; each view is shown alone",
        "display_pilot",
    ),
    Answer(
        "Figure 32",
        Verdict.REPRODUCED,
        "kite, knob and punctuality side by side, in one frame that nobody has to arrange",
        "display_cockpit",
    ),
)

SECONDS = 8.0
MOVES = ((1.0, 1.0), (6.5, -0.6))
"""Time [s] and stick from then on."""

SIZE = (1280, 720)
FRAME_TIME = 1 / 30  # s
SHOWN_ALONE = {"trail", "forces", "labels"}
"""What stays in a view that is shown alone."""

CAPTIONS = {
    "pilot": "From behind the pilot, who stands at the ground point O_E: the kite against the sky.",
    "chase": "Along the lines, from near: the canopy with the forces on it, the lines, the trail; "
    "how it tilts is seen best here.",
    "side": "From the side, at a right angle to the wind: elevation and length of the lines.",
    "top": "From above: azimuth, and the rings on the ground that tell distances.",
    "orbit": "From wherever the mouse turns the eye.",
}
Frame = NDArray[np.uint8]


def section(scratch: Path) -> Section:
    """Frames; where there is no OpenGL, the sentence that says how to get it."""
    scenario = scenario_of({"set": "thesis", "duration": SECONDS}, "the flight of section 4.5")
    try:
        with Picture(scenario.parameters, *SIZE) as picture, flight_process(scenario) as physics:
            frames = paint_frames(physics, picture, SECONDS)
    except NoGraphics as error:
        return _without_pictures(str(error))
    drawings = []
    for name, frame in frames.items():
        path = scratch / f"display_{name}.png"
        pygame.image.save(pygame.image.frombuffer(frame.tobytes(), SIZE, "RGB"), path)
        drawings.append(Drawing(f"display_{name}", CAPTIONS.get(name, _COCKPIT), path))
    return Section(_TITLE, ANSWERS, _THESIS, _HERE, _WHY, drawings)


def paint_frames(
    physics: InstrumentedProcess, picture: Picture, seconds: float
) -> dict[str, Frame]:
    """The last moment of a flight in real time: the cockpit, then each view alone."""
    stick = ProgrammedStick([Row(t, steer) for t, steer in MOVES], physics.parameters)
    picture.depth = "engineer"
    picture.paint(physics.result.motion, None, Readings())
    observe(physics, round(seconds / TICK), lambda: picture, FRAME_TIME, stick)
    result, readings = physics.result, readings_of(physics)
    frames = {"cockpit": picture.paint(result.motion, result.reference, readings, "chase")}
    picture.shown = set(SHOWN_ALONE)
    for view in VIEWS:
        frames[view] = picture.paint(result.motion, result.reference, readings, view)
    return frames


def _without_pictures(reason: str) -> Section:
    """The section where nothing can be painted."""
    here = f"No frame is shown: {reason}."
    cause = "nothing can be painted on this machine"
    answers = [Answer(a.item, Verdict.NOT_APPLICABLE, cause) for a in ANSWERS[1:]]
    return Section(_TITLE, [ANSWERS[0], *answers], _THESIS, [here], _WHY)


_TITLE = "The display (section 4.5)"

_COCKPIT = (
    "The cockpit, as a pilot sees it. Left, from above: where the kite is; α and β as parts of "
    "what the model is valid for; tensions of both lines. Below: the knob, which shows the δ that "
    "is flown and, in yellow, the δ that is asked for; the model, and how far its reference is. "
    "Right: the same from behind the pilot; the wind window; missed ticks over the last 20 s, "
    "with how late ticks were (green) and how long frames took (blue)."
)

_THESIS = [
    "LAKSA drew the kite and, as an inset, its canopy from near, after the simulation (Figures 3 "
    "and 30). The thesis draws while it simulates. To save time it puts the inset into a figure "
    "of its own, sets the axes up once, and draws at a rate of its own (Figures 29 and 31).",
    "The screen is arranged in four parts: two figures of the kite, the knob, and the graph of "
    "missed ticks (Figure 32).",
]

_HERE = [
    "One frame holds everything: the kite from near with the forces on it, as the pilot sees it "
    "besides, knob, limits, tensions, punctuality. Main view and instruments are chosen by keys.",
    f"The frames below are of the last moment of {SECONDS:g} s in real time under a programmed "
    f"stick, painted while it was flown; every number in them is that flight's. The kite is "
    f"drawn to scale from near, and larger than it is from afar, where it could not be seen.",
]

_WHY = [
    "A frame is painted from a motion by the renderer of MuJoCo; the flight has a process of its "
    "own and does not wait for it. So nothing has to be left out to keep time, and a recording, a "
    "film and a live flight look the same. What painting costs is measured in the section on real "
    "time.",
]
