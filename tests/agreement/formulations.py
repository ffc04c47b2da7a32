"""The three formulations through one door, whether shipped or a copy with a fault in it."""

import ctypes
import re
import sys
from functools import cache
from importlib import import_module
from itertools import count
from pathlib import Path
from types import ModuleType
from typing import NamedTuple

import llvmlite.binding as llvm
import numpy as np

import kitemj.dynamics
from kitemj.dynamics.motion import Body, PerLine
from kitemj.flight.agreement import spatial_accelerations
from kitemj.physics.frames import world
from kitemj.physics.vectors import Vector
from tests.support import Case

MODULES = {  # in the order of import
    "lagrange": ("solve4", "lagrange", "lagrange_kite"),
    "newton-euler": ("newton_euler", "newton_euler_kite"),
    "mujoco": ("straight", "engine", "taut", "slack", "mujoco_kite"),
}
KITE = {
    "lagrange": ("lagrange_kite", "LagrangeKite"),
    "newton-euler": ("newton_euler_kite", "NewtonEulerKite"),
    "mujoco": ("mujoco_kite", "MujocoKite"),
}
ROOM = "kitemj.dynamics."
copies = count()


class Instant(NamedTuple):
    """What a formulation says of one moment."""

    body: Body
    a_G_E: np.ndarray
    omega_dot_B: np.ndarray
    tensions: PerLine


class Formulation:
    """A model by name, and the modules that its formulas are taken from."""

    def __init__(self, name: str, modules: dict[str, ModuleType]) -> None:
        self.name, self.modules = name, modules
        file, kite = KITE[name]
        self.kite = cache(getattr(modules[file], kite))  # one engine for each kite and step

    def body(self, case: Case) -> Body:
        """Pose and velocity at the case's start."""
        parameters, (q, q_dot), segment = case
        if self.name == "lagrange":
            return self.modules["lagrange"].body(parameters, q, q_dot, segment.control)
        if self.name == "newton-euler":
            ne = self.modules["newton_euler"]
            return ne.body_of(ne.placed(parameters, segment, case.state))
        kite = self.kite(parameters)
        kite.start(case.state, segment)
        return self.modules["engine"].body_of(kite._engine)

    def at(self, case: Case) -> Instant:
        """Accelerations and tensions at the case's start."""
        parameters, (q, q_dot), segment = case
        body = self.body(case)
        if self.name == "lagrange":
            now = self.modules["lagrange"].accelerations(parameters, segment.control, 0.0, q, q_dot)
            a, alpha = spatial_accelerations(parameters, segment.control, case.state, now.q_ddot)
            return Instant(body, a, alpha, now.tensions)
        if self.name == "newton-euler":
            now = self.modules["newton_euler"].accelerations(parameters, segment, 0.0, body)
            return Instant(body, np.array(now.a_G_E), np.array(now.omega_dot_B), now.tensions)
        kite = self.kite(parameters)
        a_W, alpha = kite._engine.qacc[:3], kite._engine.qacc[3:].copy()
        tensions = self.modules["taut"].tensions(kite._engine, parameters, body)
        return Instant(body, np.array(world(Vector(*a_W))), alpha, tensions)


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
