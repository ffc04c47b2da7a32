"""The unit, meaning and bounds that a parameter carries in its type annotation."""

from collections.abc import Iterator
from dataclasses import dataclass
from math import inf

from annotated_types import BaseMetadata, GroupedMetadata, Interval

SENSIBLE = {
    **{"kg": (1e-4, 1e5), "kg m²": (1e-9, 1e8), "kg/m³": (1e-6, 1e4), "N": (1e-3, 1e9)},
    **{"m": (1e-3, 1e5), "m²": (1e-6, 1e6), "m/s": (1e-3, 1e3), "m/s²": (1e-3, 1e4)},
    **{"rad": (1e-6, 1e4), "rad/s": (1e-6, 1e4), "rad/s²": (1e-6, 1e6)},
    **{"": (0.0, 1e4), "1/rad": (0.0, 1e4), "s": (1e-9, 1e9)},
}
"""By unit: the least of what must be > 0, and the largest magnitude; no kite comes near either.

From a gram's tenth to a hundred tonnes, a millimetre to 100 km, and below thrice the speed of
sound, so that squares, products and inverses of these numbers keep their digits.
"""


@dataclass(frozen=True)
class Quantity(GroupedMetadata):
    """``Annotated[float, Quantity("kg", "mass of the kite", gt=0)]``."""

    unit: str
    meaning: str
    gt: float | None = None
    ge: float | None = None
    lt: float | None = None
    le: float | None = None

    def __iter__(self) -> Iterator[BaseMetadata]:
        """The bounds in the form that checking libraries read."""
        yield from Interval(gt=self.gt, ge=self.ge, lt=self.lt, le=self.le)

    @property
    def sensible(self) -> tuple[float, float]:
        """The least (where it must be positive) and the largest magnitude; inf for other units."""
        least, most = SENSIBLE.get(self.unit, (0.0, inf))
        return (least if self.gt == 0 else 0.0), most
