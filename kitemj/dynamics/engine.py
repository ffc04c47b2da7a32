"""MuJoCo as the compiled loop sees it: its C functions by name, its arrays by reference."""

from pathlib import Path
from typing import Any, NamedTuple

import llvmlite.binding as llvm
import numpy as np
from numba import types
from numpy.typing import NDArray

from kitemj.data_files import model_file
from kitemj.dynamics.motion import HULL, Body
from kitemj.mujoco_import import mujoco
from kitemj.physics.compiled import Array, compiled
from kitemj.physics.frames import Quaternion, R_BE_of, quaternion, world, world_quaternion
from kitemj.physics.parameters import Parameters
from kitemj.physics.vectors import Vector


def _load_library() -> None:
    """Makes the symbols of the very library that mujoco loaded known to compiled code."""
    folder = Path(str(mujoco.__file__)).parent
    names = ("libmujoco.so*", "libmujoco*.dylib", "mujoco.dll")
    library = next(file for name in names for file in sorted(folder.glob(name)))
    llvm.load_library_permanently(str(library))


_load_library()


def _engine_function(name: str) -> Any:
    """The engine's C function `name` of (model, data), to be called from compiled code."""
    return types.ExternalFunction(name, types.void(types.uintp, types.uintp))


kinematics = _engine_function("mj_kinematics")
com_pos = _engine_function("mj_comPos")
tendon = _engine_function("mj_tendon")
collision = _engine_function("mj_collision")
make_constraint = _engine_function("mj_makeConstraint")
project_constraint = _engine_function("mj_projectConstraint")
forward_velocity = _engine_function("mj_fwdVelocity")
forward_acceleration = _engine_function("mj_fwdAcceleration")
forward_constraint = _engine_function("mj_fwdConstraint")


@compiled
def forward(model: int, data: int) -> None:
    """``mj_forward`` of the present qpos and qvel, less what this model has none of.

    No cameras, lights, flexes, actuators, sensors or energies; and the mass matrix of one
    free body about its centre of mass never changes, so `build`'s stays. A third is saved.
    """
    kinematics(model, data)
    com_pos(model, data)
    tendon(model, data)
    collision(model, data)
    make_constraint(model, data)
    project_constraint(model, data)
    forward_velocity(model, data)
    forward_acceleration(model, data)
    forward_constraint(model, data)


class Engine(NamedTuple):
    """One flight's MuJoCo data. Rows of line arrays: 0 is A₊, 1 is A₋.

    The engine's own arrays, by reference; then, for each line's constraint
    J q̈ = -damping J q̇ - stiffness (length - target) - R f, its constants, and `softness`,
    R f of the evaluation before (negative while the line pulls), and room for the
    stages, and for what a step began with and what the search for the ground goes back to.
    """

    model: int
    data: int
    qpos: Array
    qvel: Array
    qacc: Array
    qacc_smooth: Array
    qfrc_applied: Array
    eq_active: NDArray[np.uint8]
    eq_data: Array
    ten_length: Array
    ten_velocity: Array
    ten_length_0: Array
    stiffness: Array
    damping: Array
    R: Array
    softness: Array
    start: Array
    stage: Array
    total: Array
    before: Array
    softness_before: Array
    kept: Array


def build(parameters: Parameters, step: float) -> tuple[Any, Any, Engine]:
    """MjModel and MjData of ``models/kite.xml`` with the set's numbers, and the `Engine` on them.

    `step` [s] sets how stiffly the lines hold: τ = 4 steps (k = 1/τ², b = 2/τ).
    """
    kite, length = parameters.kite, parameters.lines.length
    spec = mujoco.MjSpec.from_file(str(model_file("kite.xml")))
    spec.option.timestep = step
    spec.option.gravity = (0.0, 0.0, -parameters.environment.gravity)
    body = spec.body("kite")
    body.pos = (-0.4 * length, 0.0, 0.9 * length)
    body.mass = kite.mass
    body.fullinertia = (kite.inertia_x, kite.inertia_y, kite.inertia_z, 0.0, -kite.inertia_xz, 0.0)
    spec.site("A_plus").pos = (kite.x_A, kite.y_A, kite.z_A)
    spec.site("A_minus").pos = (kite.x_A, -kite.y_A, kite.z_A)
    spec.geom("hull").size = (kite.chord / 2, kite.span / 2, HULL)
    tau = 4 * step
    for equality in spec.equalities:
        equality.solref = (-1 / tau**2, -2 / tau)
    model = spec.compile()
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    K, b, impedance, _ = data.efc_KBIP[:2].T
    engine = Engine(
        *(model._address, data._address),
        *(data.qpos, data.qvel, data.qacc, data.qacc_smooth, data.qfrc_applied),
        *(data.eq_active.view(np.uint8), model.eq_data),
        *(data.ten_length, data.ten_velocity, model.tendon_length0),
        *(K * impedance, b.copy(), data.efc_R[:2].copy(), np.zeros(2)),
        *(np.zeros(13), np.zeros(13), np.zeros(13), np.zeros(13), np.zeros(2)),
        np.zeros(17),
    )
    return model, data, engine


@compiled
def body_of(engine: Engine) -> Body:
    """The pose and velocity that the engine holds, in E and B."""
    p, v = engine.qpos, engine.qvel
    scale = 1.0 / np.sqrt(p[3] * p[3] + p[4] * p[4] + p[5] * p[5] + p[6] * p[6])
    turned = Quaternion(scale * p[3], scale * p[4], scale * p[5], scale * p[6])
    return Body(
        world(Vector(p[0], p[1], p[2])),
        R_BE_of(world_quaternion(turned)),
        world(Vector(v[0], v[1], v[2])),
        Vector(v[3], v[4], v[5]),
    )


@compiled
def place(engine: Engine, body: Body) -> None:
    """Puts the kite where `body` is, moving as it moves."""
    p, v, e = world(body.p_G_E), world(body.v_G_E), world_quaternion(quaternion(body.R_BE))
    engine.qpos[0], engine.qpos[1], engine.qpos[2] = p
    engine.qpos[3], engine.qpos[4], engine.qpos[5], engine.qpos[6] = e
    engine.qvel[0], engine.qvel[1], engine.qvel[2] = v
    engine.qvel[3], engine.qvel[4], engine.qvel[5] = body.omega_B
