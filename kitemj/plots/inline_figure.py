"""A figure that a notebook shows by itself, small, with no window behind it."""

from base64 import b64encode
from io import BytesIO

from matplotlib.figure import Figure

SHARPNESS = 70
"""dots per inch."""


class InlineFigure(Figure):
    """A `Figure`, shown where a notebook's block ends with it."""

    def _repr_html_(self) -> str:
        picture = BytesIO()
        self.savefig(picture, format="png", dpi=SHARPNESS)
        return f'<img src="data:image/png;base64,{b64encode(picture.getvalue()).decode()}">'
