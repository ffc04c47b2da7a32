"""Section 3: the coordinate frames, drawn from the rotations that the models use."""

from pathlib import Path

import numpy as np

from kitemj.tables import Cell, Table
from thesis.coordinate_frames_figures import all_figure, planes_figure
from thesis.coordinate_frames_geometry import FrameGeometry, frame_geometry
from thesis.section import Answer, Drawing, NamedTable, Section, Verdict

ANSWERS = (
    Answer("Figure 12", Verdict.REPRODUCED, shown_by="frames_all"),
    Answer("Figure 13", Verdict.REPRODUCED, shown_by="frames_planes"),
)


def section(scratch: Path) -> Section:
    """Drawn at `Q`, with lines of about `ELL`."""
    found = frame_geometry()
    return Section(
        "Frames (section 3)",
        ANSWERS,
        thesis=[
            "Four frames lead from the ground to the kite: S_E, turned by φ about z_E and by γ "
            "about y_1 into S_1, whose y and z span the plane π of the two lines; turned by η "
            "about x_1 into S_2 at O_2, midway between the attachments; turned by θ about y_2 "
            "into S_B at the centre of mass.",
        ],
        here=[
            "The drawings are computed with the rotations that the models fly with "
            "(kitemj/physics/frames.py), at angles far larger than in flight. x_E points into the "
            "wind and z_E down, so that the kite hangs at negative x_E and z_E. A₊ is on the "
            "pilot's left.",
            "The table has the origin and the axes of each frame and how far its three axes are "
            "from being orthogonal unit vectors.",
        ],
        drawings=[
            Drawing(
                "frames_all",
                "Figure 12 again: the frames E, 1, 2 and B, the two lines and the plane π "
                "(shaded), at φ = 30°, γ = 25°, η = 25°, θ = −35°, δ = 20° and lines of some 7 m.",
                all_figure(found),
            ),
            Drawing(
                "frames_planes",
                "Left: within the plane π, seen against x_1; η turns y_1 into y_2, δ is the angle "
                "between z_2 and the median O_E O_2. Right: Figure 13 again, within the kite's "
                "plane of symmetry, y_2 pointing away; θ turns S_2 into S_B.",
                planes_figure(found),
            ),
        ],
        tables=[NamedTable("frames", frames_table(found))],
    )


def frames_table(found: FrameGeometry) -> Table:
    """A row for each axis."""
    rows: list[tuple[Cell, ...]] = []
    for frame, R in found.axes.items():
        off = float(np.abs(R @ R.T - np.eye(3)).max())
        for letter, axis in zip("xyz", R, strict=True):
            origin = found.points[found.origins[frame]]
            rows.append((f"{letter}_{frame}", *map(float, axis), *map(float, origin), off))
    columns = ("axis", "on_x_E", "on_y_E", "on_z_E", "from_x_E_m", "from_y_E_m", "from_z_E_m")
    return Table("Axes and origins of the frames", (*columns, "not_orthogonal_by"), rows)
