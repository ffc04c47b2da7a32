"""The unit, meaning and bounds that a parameter carries in its type annotation."""

from collections.abc import Iterator
from dataclasses import dataclass

from annotated_types import BaseMetadata, GroupedMetadata, Interval


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
