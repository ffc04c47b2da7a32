"""The settings of an autopilot as they stand in a recording."""

import json
from math import degrees
from typing import Any

from kitemj.errors import InputError
from kitemj.flight.pilot_settings import PilotSettings
from kitemj.physics.checked import checked


def pilot_json(pilot: PilotSettings) -> bytes:
    """The settings as JSON; floats survive to the last bit."""
    return json.dumps(plain(pilot)).encode()


def pilot_from_json(text: bytes, source: str) -> PilotSettings:
    """The settings in the file called `source`; InputError where they are damaged."""
    try:
        table = json.loads(text)
    except (ValueError, RecursionError):
        table = None
    if not isinstance(table, dict):
        raise InputError(f"{source} is damaged: its autopilot's settings cannot be read")
    return checked(PilotSettings, table, "pilot", source)


def plain(value: Any) -> Any:
    """Named tuples as dictionaries of what is in them; what is None is left out."""
    if hasattr(value, "_asdict"):
        known = value._asdict().items()
        return {name: plain(each) for name, each in known if each is not None}
    return value


def pilot_in_words(pilot: PilotSettings) -> str:
    """What the scenario's autopilot was to fly, and how well it was told."""
    path, sensors = pilot.path, pilot.sensors
    phases = " ".join(("path:", path.kind)) if path else "path: the usual eight"
    told = ", ".join(phases if phase == "path" else phase for phase in pilot.phases)
    measured = f"{sensors.rate:g} measurements/s, {1e3 * sensors.delay:g} ms late"
    return f"{told}; {measured}, {degrees(sensors.noise):.3g}° of noise"
