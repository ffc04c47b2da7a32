"""The unit, meaning and bounds that a parameter carries in its type annotation."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Quantity:
    """``Annotated[float, Quantity("kg", "mass of the kite", gt=0)]``."""

    unit: str
    meaning: str
    gt: float | None = None
    ge: float | None = None
    lt: float | None = None
