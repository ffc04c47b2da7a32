"""MuJoCo, imported so that a machine without OpenGL can still fly.

``import mujoco`` reads MUJOCO_GL and loads that library at once; where it is missing the
import itself dies. Physics needs no OpenGL, so the variable is out of sight meanwhile;
`kitemj.scene.gl` respects it when there is something to draw.
"""

import os
from types import ModuleType


def _without_gl() -> ModuleType:
    asked = os.environ.pop("MUJOCO_GL", None)
    try:
        import mujoco
    finally:
        if asked is not None:
            os.environ["MUJOCO_GL"] = asked
    return mujoco  # type: ignore[no-any-return]


mujoco = _without_gl()
