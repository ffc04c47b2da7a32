"""The recorded input flown once more, through the same model or another."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kitemj.dynamics.formulation import MODELS, make_model
from kitemj.errors import FlightError
from kitemj.physics.rig import rig_of
from kitemj.physics.steering import Control, Segment
from kitemj.recording.closed_loop import check_closed_loop, closed_flown
from kitemj.recording.file import Recording
from kitemj.recording.table import LIMITS, STEERING, Columns, motion_columns, motion_row

POSITION = ("x_E_m", "y_E_m", "z_E_m")


@dataclass(frozen=True)
class Replay:
    """The columns of a motion that `model` flies from the steering of `recording`.

    Not a number where the model could not fly on; `note` says why. `step` [s] is its longest.
    """

    recording: Recording
    model: str
    step: float
    columns: Columns
    note: str

    @property
    def identical(self) -> bool:
        """Whether every number has the same bits as the recorded one."""
        recorded = self.recording.columns
        return all(
            np.array_equal(self.columns[name].view(np.int64), recorded[name].view(np.int64))
            for name in self.columns
        )

    @property
    def gaps(self) -> NDArray[np.float64]:
        """Distance [m] between the two centres of mass, shape (rows,)."""
        recorded = self.recording.columns
        apart = [self.columns[name] - recorded[name] for name in POSITION]
        return np.asarray(np.sqrt(np.sum(np.square(apart), axis=0)))

    @property
    def valid(self) -> NDArray[np.bool_]:
        """Rows before the first departure of their episode from any limit, shape (rows,)."""
        return self.recording.before(LIMITS)

    @property
    def comparable(self) -> NDArray[np.bool_]:
        """Rows at which the replay says something of the recording, shape (rows,).

        Models part where a line goes slack or the kite touches the ground: some have
        neither. The same model once more is held against every row.
        """
        same = self.model == self.recording.header.model
        return self.recording.before(() if same else ("slack", "ground"))

    def largest_gap(self, rows: NDArray[np.bool_]) -> tuple[float, int] | None:
        """The largest gap [m] among `rows` that were flown, and where; None: there are none."""
        gaps = np.where(rows & np.isfinite(self.gaps), self.gaps, -1.0)
        row = int(np.argmax(gaps))
        return (float(gaps[row]), row) if gaps[row] >= 0.0 else None


def replay(
    recording: Recording, model: str, step: float | None = None, closed_loop: bool = False
) -> Replay:
    """Flies every episode; `step` [s] is that of the recording if left out.

    In a `closed_loop` the autopilot of the recording's scenario flies again, wherever it flew,
    by what its sensors tell of `model`; whatever else moved the stick moves it as it did. Raises
    InputError for a model that is not known here, a step that cannot be, and a closed loop of a
    flight without such an autopilot.
    """
    if closed_loop:
        check_closed_loop(recording)
    if model == recording.header.model:
        recording.header.check(MODELS, model, recording.path.name)
    step = step or recording.header.step
    names = motion_columns(rig_of(recording.parameters))
    columns = np.full((len(names), len(recording)), np.nan)
    notes = []
    for episode in recording.episodes:
        try:
            flown = closed_flown if closed_loop else _flown
            for row, numbers in flown(recording, episode, model, step):
                columns[:, row] = numbers
        except FlightError as error:
            notes.append(str(error))
    found = dict(zip(names, columns, strict=True))
    return Replay(recording, model, step, found, "; ".join(notes))


def _flown(
    recording: Recording, episode: slice, model: str, step: float
) -> Iterator[tuple[int, list[float]]]:
    """Each row of an episode with its motion, by the very calls that `SteeredFlight` makes.

    An episode that goes on from another is flown from that one's start.
    """
    kite = make_model(model, recording.parameters, step)
    tick, way = recording.header.tick, recording.way_to(episode)
    steering = zip(*(recording.columns[name][way].tolist() for name in STEERING), strict=True)
    numbers = recording.columns["tick"][way].tolist()
    for row, k, control in zip(way.tolist(), numbers, steering, strict=True):
        if k == 0:
            segment = Segment(0.0, Control(*control))
            start = recording.header.states[recording.columns["start"][row]]
            kite.start(start, segment)
        else:
            segment = Segment((k - 1) * tick, Control(*control))
            kite.advance(segment, tick)
            kite.t = k * tick
        motion = motion_row(kite.motion(segment))
        if row >= episode.start:
            yield row, motion
