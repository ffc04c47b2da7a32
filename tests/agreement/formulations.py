"""The three formulations through one door, whether shipped or a copy with a fault in it."""

import ctypes
import re
import sys
from functools import cache
from importlib import import_module
from itertools import count
from pathlib import Path
from types import ModuleType

import llvmlite.binding as llvm

import kitemj.dynamics
from kitemj.dynamics.formulation import MODELS, Instant
from kitemj.dynamics.motion import Body
from tests.support import Case

MODULES = {  # in the order of import
    "lagrange": ("solve4", "lagrange", "lagrange_kite"),
    "newton-euler": ("newton_euler", "newton_euler_kite"),
    "mujoco": ("straight", "engine", "taut", "slack", "mujoco_kite"),
}
KITE = {
    name: place.removeprefix("kitemj.dynamics.").split(":")
    for name, place in MODELS.shipped.items()
}
ROOM = "kitemj.dynamics."
copies = count()


class Formulation:
    """A model by name, and the modules that its formulas are taken from."""

    def __init__(self, name: str, modules: dict[str, ModuleType]) -> None:
        self.name, self.modules = name, modules
        file, kite = KITE[name]
        self.kite = cache(getattr(modules[file], kite))  # one engine for each kite and step

    def at(self, case: Case) -> Instant:
        """The instant at the case's start."""
        return self.kite(case.parameters).at(case.state, case.segment.control, 0.0)

    def body(self, case: Case) -> Body:
        """Pose and velocity there."""
        return self.at(case).body


def shipped(name: str) -> Formulation:
    """The compiled formulas that fly."""
    return Formulation(name, {file: import_module(ROOM + file) for file in MODULES[name]})


def copied(name: str, file: str = "", old: str = "", new: str = "") -> Formulation:
    """Copies of the model's modules in plain Python, with `old` in `file` made `new`.

    Raises ValueError unless `old` stands there exactly once: a fault must be planted, not
    believed to be.
    """
    alias = f"planted_{next(copies)}_"
    modules = {}
    try:
        for part in MODULES[name]:
            source = (Path(kitemj.dynamics.__path__[0]) / f"{part}.py").read_text("utf-8")
            if part == file:
                if source.count(old) != 1:
                    raise ValueError(f"{old!r} stands {source.count(old)} times in {file}.py")
                source = source.replace(old, new)
            modules[part] = _run(alias + part, _plain(source, alias, MODULES[name]))
    finally:
        for part in MODULES[name]:
            sys.modules.pop(alias + part, None)
    return Formulation(name, modules)


def _plain(source: str, alias: str, parts: tuple[str, ...]) -> str:
    """The source without numba, its imports of the model's own modules turned to the copies."""
    source = source.replace("@compiled\n", "")
    for part in parts:
        source = re.sub(rf"\b{re.escape(ROOM)}{part}\b(?= import)", alias + part, source)
    return source


def _run(name: str, source: str) -> ModuleType:
    module = ModuleType(name)
    sys.modules[name] = module
    exec(compile(source, name, "exec"), module.__dict__)
    if "_load_library" in module.__dict__:  # compiled code calls the engine by name
        module.__dict__["forward"] = _forward()
    return module


@cache
def _forward():
    address = llvm.address_of_symbol("mj_forward")
    return ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_void_p)(address)
