"""Can this system draw without a screen? If not: one sentence that says what mends it, status 1."""

import sys

from kitemj.scene.gl import open_graphics

try:
    open_graphics(16, 16).context.free()
except RuntimeError as error:
    sys.exit(str(error))
