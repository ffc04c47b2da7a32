"""What a recording says of itself before its first row: enough to fly it again."""

import json
import platform
from dataclasses import asdict, dataclass, field
from datetime import datetime
from importlib.metadata import version
from typing import Any

from kitemj.dynamics.motion import State
from kitemj.errors import InputError
from kitemj.flight.live import TICK, LiveFlight
from kitemj.physics.compiled import cache_folder
from kitemj.physics.frames import Angles
from kitemj.physics.parameter_files import AERO_LAWS, SECTIONS, parameter_set
from kitemj.physics.parameters import Parameters

FORMAT = 2
"""Rises when an older kitemj could no longer read what is written, or the other way round."""

PACKAGES = ("kitemj", "mujoco", "numba", "llvmlite", "numpy", "ruckig")
"""What the bits of a flight may depend on."""


@dataclass(frozen=True)
class Header:
    """Model, reference ("": none), their longest `step` [s], the `tick` [s], parameters, starts.

    `versions` of the packages, of Python and of the machine; `seeds` by name (nothing in a
    flight is random so far). Floats survive the way through JSON to the last bit.
    """

    scenario: str
    model: str
    reference: str
    step: float
    parameters: dict[str, Any]
    starts: list[list[list[float]]]
    written: str
    versions: dict[str, str]
    seeds: dict[str, int] = field(default_factory=dict)
    tick: float = TICK
    format: int = FORMAT

    @property
    def states(self) -> list[State]:
        """q [rad] and q̇ [rad/s] at which flights begin."""
        return [State(Angles(*q), Angles(*q_dot)) for q, q_dot in self.starts]

    def checked_parameters(self, source: str) -> Parameters:
        """The parameter set; InputError, which names `source`, where it is none."""
        return parameter_set("laksa", self.parameters, source)


def header_of(flight: LiveFlight) -> Header:
    """The header of a live flight that is about to begin."""
    return Header(
        scenario=flight.scenario.source,
        model=flight.kite.name,
        reference=flight.reference.name if flight.reference else "",
        step=flight.step,
        parameters=parameter_tables(flight.parameters),
        starts=[[list(start.q), list(start.q_dot)] for start in flight.starts],
        written=datetime.now().astimezone().isoformat(timespec="seconds"),
        versions=present_versions(),
    )


def present_versions() -> dict[str, str]:
    """Versions of what the bits of a flight depend on; `formulas` is a hash of their source."""
    formulas = cache_folder().name.rpartition("-")[2]
    machine = {"python": platform.python_version(), "machine": platform.machine()}
    return {name: version(name) for name in PACKAGES} | {"formulas": formulas} | machine


def parameter_tables(parameters: Parameters) -> dict[str, Any]:
    """A parameter set as the tables of a scenario file, angles in rad."""
    tables: dict[str, Any] = {name: getattr(parameters, name)._asdict() for name in SECTIONS}
    law = next(name for name, kind in AERO_LAWS.items() if isinstance(parameters.aero, kind))
    return tables | {"aero": {"law": law, **parameters.aero._asdict()}}


def to_json(header: Header) -> bytes:
    """The header as it stands in a file."""
    return json.dumps(asdict(header)).encode()


def from_json(text: bytes, source: str) -> Header:
    """The header of the file called `source`; InputError for one that cannot be read."""
    try:
        tables = json.loads(text)
        written_in = int(tables["format"])
    except (ValueError, KeyError, TypeError):
        raise InputError(f"{source} has no header that can be read: it is damaged") from None
    if written_in > FORMAT:
        theirs = tables.get("versions", {}).get("kitemj", "a later version")
        raise InputError(
            f"{source} has format {written_in} (kitemj {theirs}), this kitemj {version('kitemj')} "
            f"reads up to {FORMAT}: upgrade kitemj"
        )
    if written_in < FORMAT:
        raise InputError(
            f"{source} has format {written_in}, of an earlier kitemj; this one reads format "
            f"{FORMAT}: film or export it with the kitemj that recorded it"
        )
    try:
        return Header(**tables)
    except TypeError as error:
        raise InputError(f"{source} has a damaged header: {error}") from None
