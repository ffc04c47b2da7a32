"""What a recording says of itself before its first row: enough to fly it again."""

import json
import platform
from dataclasses import asdict, dataclass, field, replace
from datetime import datetime
from functools import cache
from importlib.metadata import version
from typing import Annotated, Any, ClassVar

from annotated_types import Gt, Interval, Len, MinLen
from pydantic import ConfigDict, TypeAdapter, ValidationError

from kitemj.dynamics.formulation import MAX_STEP, MIN_STEP, MODELS
from kitemj.dynamics.motion import State
from kitemj.errors import InputError
from kitemj.flight.live import TICK, SteeredFlight
from kitemj.physics.code_folder import formula_hash
from kitemj.physics.frames import Angles
from kitemj.physics.parameter_files import LAWS, NAMED_BY, parameter_tables, told_parameters
from kitemj.physics.parameters import Parameters
from kitemj.registry import Registry

FORMAT = 2
"""Rises when an older kitemj could no longer read what is written, or the other way round."""

Four = Annotated[list[float], Len(4, 4)]
"""Numbers of q or of q̇."""

PACKAGES = ("kitemj", "mujoco", "numba", "llvmlite", "numpy", "ruckig")
"""What the bits of a flight may depend on."""


@dataclass(frozen=True)
class Header:
    """Model, reference ("": none), their longest `step` [s], the `tick` [s], parameters, starts.

    `versions` of the packages, of Python, of the machine, and of who brought a law or a model
    that is not ours; `seeds` of what is random, by name: the noise of an autopilot's sensors.
    Floats survive the way through JSON to the last bit.
    """

    __pydantic_config__: ClassVar = ConfigDict(strict=True, allow_inf_nan=False, extra="forbid")

    scenario: str
    model: str
    reference: str
    step: Annotated[float, Interval(ge=MIN_STEP, le=MAX_STEP)]
    parameters: dict[str, dict[str, Any]]
    starts: Annotated[list[Annotated[list[Four], Len(2, 2)]], MinLen(1)]
    written: str
    versions: dict[str, str]
    seeds: dict[str, int] = field(default_factory=dict)
    tick: Annotated[float, Gt(0.0)] = TICK
    format: int = FORMAT

    @property
    def states(self) -> list[State]:
        """q [rad] and q̇ [rad/s] at which flights begin."""
        return [State(Angles(*q), Angles(*q_dot)) for q, q_dot in self.starts]

    def checked_parameters(self, source: str) -> Parameters:
        """The parameter set; InputError, which names `source`, where it is none."""
        for registry, law in self._named():
            if registry is not MODELS:
                self.check(registry, law, source)
        return told_parameters(self.parameters, source)

    def check(self, registry: Registry[Any], name: str, source: str) -> None:
        """Raises InputError for a law or a model of this flight that is not known here."""
        if name not in registry:
            whose = self.versions.get(f"{registry.kind} {name}", "somebody else")
            raise InputError(
                f"{source} was flown with the {registry.kind} {name!r} of {whose}: install the "
                f"package, or use the module, that adds it"
            )

    def present_versions(self) -> dict[str, str]:
        """As `versions`, but of what is here."""
        named = self._named()
        brought = {f"{each.kind} {name}": each.origin(name) for each, name in named if name in each}
        return present_versions() | {name: whose for name, whose in brought.items() if whose}

    def _named(self) -> list[tuple[Registry[Any], str]]:
        """What was flown with by its name, and where that is looked up; nothing is imported."""
        laws = [
            (LAWS[section], self.parameters[section].get(NAMED_BY[section])) for section in LAWS
        ]
        models = [(MODELS, self.model), (MODELS, self.reference)]
        return [(registry, name) for registry, name in (*laws, *models) if name]


def header_of(flight: SteeredFlight) -> Header:
    """The header of a live flight that is about to begin."""
    pilot = flight.scenario.pilot
    header = Header(
        scenario=flight.scenario.source,
        model=flight.kite.name,
        reference=flight.reference.name if flight.reference else "",
        step=flight.step,
        parameters=parameter_tables(flight.parameters),
        starts=[[list(start.q), list(start.q_dot)] for start in flight.starts],
        written=datetime.now().astimezone().isoformat(timespec="seconds"),
        versions={},
        seeds={"pilot": pilot.seed} if pilot else {},
    )
    return replace(header, versions=header.present_versions())


def present_versions() -> dict[str, str]:
    """Versions of what the bits of a flight depend on; `formulas` is a hash of their source."""
    machine = {"python": platform.python_version(), "machine": platform.machine()}
    return {name: version(name) for name in PACKAGES} | {"formulas": formula_hash()} | machine


def to_json(header: Header) -> bytes:
    """The header as it stands in a file."""
    return json.dumps(asdict(header)).encode()


def from_json(text: bytes, source: str) -> Header:
    """The header of the file called `source`; InputError for one that cannot be read."""
    try:
        tables = json.loads(text)
        written_in = tables["format"]
        theirs = str(tables["versions"]["kitemj"])
    except (ValueError, KeyError, TypeError, RecursionError):
        raise InputError(f"{source} has no header that can be read: it is damaged") from None
    if type(written_in) is not int:
        raise InputError(f"{source} has a damaged header: format must be a whole number")
    if written_in > FORMAT:
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
        header: Header = _adapter().validate_json(text)
    except ValidationError as error:
        first = error.errors()[0]
        field = ".".join(str(each) for each in first["loc"])
        got = "" if first["type"] == "missing" else f", got {first['input']!r:.60}"
        raise InputError(f"{source} has a damaged header: {field}: {first['msg']}{got}") from None
    for section in Parameters._fields:
        named = header.parameters.get(section, {}).get(NAMED_BY.get(section, ""), "")
        if section not in header.parameters or not isinstance(named, str):
            raise InputError(f"{source} has a damaged header: it lacks what its {section} is")
    return header


@cache
def _adapter() -> TypeAdapter[Header]:
    return TypeAdapter(Header)
