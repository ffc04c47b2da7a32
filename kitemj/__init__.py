"""kitemj: a two-line kite in MuJoCo, flown in real time beside a Lagrangian reference.

The names below are what programs are written with; each is loaded when it is first asked for.
"""

TYPE_CHECKING = False  # as in `typing`, which takes longer to load than all of this
if TYPE_CHECKING:
    from kitemj.api import (
        compare,
        cycle,
        film,
        identify,
        margins,
        replay,
        simulate,
        stability,
        sweep,
        trim,
    )
    from kitemj.autopilot.autopilot import Autopilot
    from kitemj.dynamics.formulation import MODELS
    from kitemj.dynamics.motion import Motion, State
    from kitemj.equilibria.cycle import Cycle
    from kitemj.equilibria.modes import Stability
    from kitemj.equilibria.trim import Trim
    from kitemj.errors import FlightError, InputError, NoGraphics
    from kitemj.flight.compare import Comparison
    from kitemj.flight.limits import Ending
    from kitemj.flight.live import TICK, Command, TickResult
    from kitemj.flight.scenario import Scenario, as_scenario
    from kitemj.physics.parameter_files import parameter_set, set_names
    from kitemj.physics.parameters import Parameters
    from kitemj.physics.shaping import StickLaw
    from kitemj.pilots.manoeuvres import Eight, Hold, Land, Loop, Pilot
    from kitemj.pilots.registry import PILOTS
    from kitemj.pilots.sight import Sight, sight
    from kitemj.plots.figures import FIGURES
    from kitemj.plots.flight import Flight
    from kitemj.plots.sources import read_flight
    from kitemj.recording.file import Recording, read_recording
    from kitemj.recording.live import LiveFlight
    from kitemj.recording.replay import Replay
    from kitemj.robustness.margins import LoopMargins
    from kitemj.studies.result import StudyResult
    from kitemj.turning.identification import Identification

    __version__: str

__all__ = [
    "FIGURES", "MODELS", "PILOTS", "TICK", "Autopilot", "Command", "Comparison", "Cycle", "Eight",
    "Ending", "Flight", "FlightError", "Hold", "Identification", "InputError", "Land", "LiveFlight",
    "Loop", "LoopMargins", "Motion", "NoGraphics", "Parameters", "Pilot", "Recording", "Replay",
    "Scenario", "Sight", "Stability", "State", "StickLaw", "StudyResult", "TickResult", "Trim",
    "__version__", "as_scenario", "compare", "cycle", "film", "identify", "margins",
    "parameter_set", "read_flight", "read_recording", "replay", "set_names", "sight", "simulate",
    "stability", "sweep", "trim",
]  # fmt: skip

_MODULES = {
    "api": "compare cycle film identify margins replay simulate stability sweep trim",
    "autopilot.autopilot": "Autopilot",
    "turning.identification": "Identification",
    "dynamics.formulation": "MODELS",
    "dynamics.motion": "Motion State",
    "errors": "FlightError InputError NoGraphics",
    "flight.compare": "Comparison",
    "flight.limits": "Ending",
    "flight.live": "TICK Command TickResult",
    "flight.scenario": "Scenario as_scenario",
    "physics.parameter_files": "parameter_set set_names",
    "robustness.margins": "LoopMargins",
    "physics.parameters": "Parameters",
    "physics.shaping": "StickLaw",
    "pilots.manoeuvres": "Eight Hold Land Loop Pilot",
    "pilots.registry": "PILOTS",
    "pilots.sight": "Sight sight",
    "plots.figures": "FIGURES",
    "plots.flight": "Flight",
    "plots.sources": "read_flight",
    "recording.file": "Recording read_recording",
    "recording.live": "LiveFlight",
    "recording.replay": "Replay",
    "equilibria.cycle": "Cycle",
    "equilibria.modes": "Stability",
    "equilibria.trim": "Trim",
    "studies.result": "StudyResult",
}
"""Where the names are, below kitemj."""


def __getattr__(name: str) -> object:
    """What is called `name`, loaded now (PEP 562)."""
    if name == "__version__":
        from importlib.metadata import version

        return version("kitemj")
    for module, names in _MODULES.items():
        if name in names.split():
            from importlib import import_module

            globals()[name] = found = getattr(import_module(f"kitemj.{module}"), name)
            return found
    raise AttributeError(f"module 'kitemj' has no attribute {name!r}")


def __dir__() -> list[str]:
    """The public names."""
    return __all__
