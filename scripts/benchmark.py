"""How fast kitemj is, and how exact for that: ``python scripts/benchmark.py --help``.

Ratios come first, because they hold on other machines too. Values are medians with the
quartiles in brackets. Writes a page of Markdown and a figure (with matplotlib).
"""

import argparse
import json
import tempfile
from contextlib import ExitStack
from pathlib import Path

import numpy as np

from kitemj.dynamics import lagrange_kite, mujoco_kite, newton_euler_kite
from kitemj.dynamics.adaptive import right_side
from kitemj.dynamics.batch import X, Z
from kitemj.dynamics.formulation import make_model
from kitemj.dynamics.motion import Motion
from kitemj.dynamics.taut import evaluate
from kitemj.flight.scenario import read_scenario
from kitemj.mujoco_import import mujoco
from kitemj.physics.compiled import compiled
from kitemj.physics.loads import aerodynamic_wrench
from kitemj.physics.vectors import Vector
from timing import interleaved, machine, program, ratios, resident, seconds, spread, table

ROOT = Path(__file__).parent.parent
STEER = read_scenario(ROOT / "scenarios" / "steer_200m.toml")
TIMES = np.array(STEER.output_times)
ONLY = ("step", "precision", "sides", "flights", "length", "frame", "start", "memory")
STEPS = (0.04, 0.02, 0.01, 0.005, 0.004, 0.002, 0.001)
TOLERANCES = (1e-4, 1e-6, 1e-8, 1e-10, 1e-12)
LOW = -1e9
"""m; no flight is ended by the ground."""


def step(rounds: int) -> list[str]:
    """Our step over the engine's own of the same model, hanging in the same wind."""
    kite = mujoco_kite.MujocoKite(STEER.parameters, 0.002)
    kite.start(STEER.start, STEER.programme)
    kite.advance(STEER.programme, 0.1)
    model, flying = kite._model, kite._data
    bare = mujoco.MjData(model)
    n = 2000

    def engine(integrator: int) -> None:
        model.opt.integrator = integrator
        bare.qpos[:], bare.qvel[:] = flying.qpos, 0.0
        bare.qfrc_applied[:] = flying.qfrc_applied
        mujoco.mj_step(model, bare, n)

    integrators = mujoco.mjtIntegrator
    ours, rk4, euler = interleaved(
        [
            lambda: kite.advance(STEER.programme, n * 0.002),
            lambda: engine(int(integrators.mjINT_RK4)),
            lambda: engine(int(integrators.mjINT_EULER)),
        ],
        rounds,
    )
    return table(
        ("step of the MuJoCo kite (4 stages: air, line targets, slack)", "median (quartiles)"),
        [
            ("ours / the engine's bare Runge-Kutta step", ratios(ours, rk4)),
            ("ours / 4 of the engine's bare Euler steps", ratios(ours, [4 * t for t in euler])),
            ("ours [µs]", spread(ours).times(1e6 / n)),
            ("bare Runge-Kutta [µs]", spread(rk4).times(1e6 / n)),
            ("bare Euler [µs]", spread(euler).times(1e6 / n)),
        ],
    )


def precision(rounds: int, figure: Path) -> list[str]:
    """Largest error in 60 s of the reference scenario over the time that it takes."""
    exact = _batch(make_model("lagrange", STEER.parameters), 1e-13)[:, X : Z + 1]
    rows, curves = [], {}
    for name in ("mujoco", "newton-euler", "lagrange"):
        fixed = name == "mujoco"
        for setting in STEPS if fixed else TOLERANCES:
            kite = make_model(name, STEER.parameters, setting if fixed else 0.1)
            tolerance = 0.0 if fixed else setting
            error = np.abs(np.linalg.norm(_batch(kite, tolerance)[:, X : Z + 1] - exact, axis=1))
            [times] = interleaved([lambda k=kite, t=tolerance: _batch(k, t)], rounds)
            worst, cost = float(error.max()), spread(times)
            curves.setdefault(name, []).append((cost.middle, worst))
            what = f"{setting * 1e3:g} ms" if fixed else f"tolerance {setting:g}"
            speed = f"{TIMES[-1] / cost.middle:,.0f}"
            rows.append((f"{name}, {what}", f"{worst * 1e6:.2g}", cost.times(1e3), speed))
    _figure(curves, figure)
    head = ("60 s of steering on 200 m lines", "error [µm]", "time [ms]", "x real time")
    return [*table(head, rows), f"![Error over time of computing]({figure.name})", ""]


def _batch(kite, tolerance):
    kite.start(STEER.start, STEER.programme)
    return kite.batch(STEER.programme, TIMES, LOW, tolerance)


def _figure(curves, path: Path) -> None:
    try:
        import matplotlib

        matplotlib.use("Agg")
        from matplotlib import pyplot
    except ImportError:
        print("no figure: matplotlib is not installed")
        return
    figure, axes = pyplot.subplots(figsize=(7, 4.5), layout="constrained")
    for (name, points), marker in zip(curves.items(), "osv", strict=True):
        axes.loglog(*zip(*points, strict=True), marker=marker, label=name)
    for times in (100, 1_000, 10_000):
        axes.axvline(TIMES[-1] / times, color="0.8", zorder=0)
        axes.text(TIMES[-1] / times, 1.01, f"{times:,} x", ha="center",
                  transform=axes.get_xaxis_transform())  # fmt: skip
    axes.set(xlabel="computing [s], one core, for 60 s of flight", ylabel="largest error [m]")
    axes.grid(alpha=0.3)
    axes.legend()
    figure.savefig(path, dpi=120)


@compiled
def _sides(system, x, out, n):
    for _ in range(n):
        right_side(system, 0.0, x, out)
        x[0] += 1e-18 * out[0]


@compiled
def _evaluations(engine, parameters, programme, n):
    for _ in range(n):
        evaluate(engine, parameters, programme, 0.0)


@compiled
def _wrenches(parameters, body, n):
    v = body.v_G_E
    for _ in range(n):
        wrench = aerodynamic_wrench(parameters, body.p_G_E, body.R_BE, v, body.omega_B, 0.0)
        v = Vector(v.x + 1e-18 * wrench.force.x, v.y, v.z)  # each waits for the one before
    return v.x


def sides(rounds: int) -> list[str]:
    """One evaluation of the equations of motion."""
    p, steering = STEER.parameters, STEER.programme
    kites = [make_model(name, p) for name in ("mujoco", "newton-euler", "lagrange")]
    for kite in kites:
        kite.start(STEER.start, steering)
    x13, x8, n = np.empty(13), np.array([*STEER.start.q, *STEER.start.q_dot]), 20_000
    newton_euler_kite.put(kites[1]._y, x13)
    free = newton_euler_kite.NewtonEulerSystem(p, steering)
    minimal = lagrange_kite.LagrangeSystem(p, steering)
    out13, out8, body = np.empty(13), np.empty(8), kites[2].motion(steering).body
    works = {
        "mujoco: stage of a step": lambda: _evaluations(kites[0]._engine, p, steering, n),
        "newton-euler": lambda: _sides(free, x13, out13, n),
        "lagrange": lambda: _sides(minimal, x8, out8, n),
        "of which wind and aerodynamics": lambda: _wrenches(p, body, n),
    }
    times = interleaved(list(works.values()), rounds)
    rows = [(name, spread(t).times(1e6 / n)) for name, t in zip(works, times, strict=True)]
    return table(("right-hand side", "µs"), rows)


STUDY = """
scenario = "{root}/scenarios/steer_200m.toml"
model = "{model}"
step = {step}
tolerance = 1e-7
[hypercube]
count = {count}
"kite.mass" = [3.9, 4.1]
"""


def flights(rounds: int) -> list[str]:
    """Flights of 60 s per second, as `kitemj sweep` flies them, on 1 and on 2 processes."""
    from kitemj.studies.executors import local_executor
    from kitemj.studies.journal import Journal
    from kitemj.studies.study import read_study
    from kitemj.studies.sweep import sweep

    rows = []
    with tempfile.TemporaryDirectory() as name, local_executor(1) as one, local_executor(2) as two:
        folder = Path(name)

        costs: dict[int, list[float]] = {}

        def flown(executor, study) -> None:
            with Journal(folder / "t", study) as journal:
                sweep(journal, executor, 0.05)
            rows = journal.path.read_text().splitlines()[1:]
            cost = sum(json.loads(row.rpartition(" ")[0])["cost_s"] for row in rows) / len(rows)
            costs.setdefault(executor.workers, []).append(cost)
            journal.path.unlink()

        for model, h, count in (("mujoco", 0.02, 60), ("mujoco", 0.01, 40), ("lagrange", 0.1, 800)):
            text = STUDY.format(root=ROOT, model=model, step=h, count=count)
            (folder / "s.toml").write_text(text)
            study = read_study(folder / "s.toml")
            costs.clear()
            by_one, by_two = interleaved(
                [lambda s=study: flown(one, s), lambda s=study: flown(two, s)],
                max(3, rounds // 3),
                seconds,
            )
            scaling = ratios(costs[1][1:], costs[2][1:]).times(2.0)
            rates = [spread([count / t for t in times]) for times in (by_one, by_two)]
            what = f"{model}, {h * 1e3:g} ms" if model == "mujoco" else f"{model}, tolerance 1e-7"
            minutes = f"{1e4 / rates[1].middle / 60:.1f}"
            rows.append((what, ratios(by_one, by_two), scaling, *rates, minutes))
    head = ("flights of 60 s", "2 / 1 processes", "the same by processor time")
    return table((*head, "1: flights/s", "2: flights/s", "10,000 on 2 [min]"), rows)


def length(rounds: int) -> list[str]:
    """Twice as long a flight, twice the cost."""
    kites = [(make_model(n, STEER.parameters, 0.01), 1e-8) for n in ("mujoco", "lagrange")]
    rows = []
    for kite, tolerance in kites:

        def fly(end: float, kite=kite, tolerance=tolerance) -> None:
            kite.start(STEER.start, STEER.programme)
            kite.batch(STEER.programme, np.arange(0.0, end, 0.1), LOW, tolerance)

        single, double = interleaved([lambda f=fly: f(60.0), lambda f=fly: f(120.0)], rounds)
        rows.append((kite.name, ratios(double, single)))
    return table(("cost of 120 s / cost of 60 s", "ratio"), rows)


def frame(rounds: int) -> list[str]:
    """A frame of the live picture, 1280 x 720, by part."""
    from kitemj.drawing import picture as pictures
    from kitemj.errors import NoGraphics
    from kitemj.scene import renderer

    kites = [make_model(name, STEER.parameters) for name in ("mujoco", "lagrange")]
    for kite in kites:
        kite.start(STEER.start, STEER.programme)
    try:
        picture = pictures.Picture(STEER.parameters)
    except NoGraphics as error:
        return [f"No frames: {error}", ""]
    spent: dict[str, float] = {}
    plainly = ExitStack()

    def watched(owner, name: str, part: str) -> None:
        plain = getattr(owner, name)

        def timed(*words, **named):
            results = []
            took = seconds(lambda: results.append(plain(*words, **named)))
            spent[part] = spent.get(part, 0.0) + took
            return results[0]

        setattr(owner, name, timed)
        plainly.callback(setattr, owner, name, plain)

    watched(renderer.Scene, "fill", "scene: what stands where")
    watched(renderer.mujoco, "mjr_render", "drawing: asked for")
    watched(renderer.mujoco, "mjr_readPixels", "drawing: done, read back")
    watched(pictures.Picture, "_letter", "instruments and labels")
    parts: dict[str, list[float]] = {}
    motions: list[Motion] = []
    with plainly, picture:
        for i in range(10 * rounds):
            spent.clear()
            advance = seconds(lambda: [k.advance(STEER.programme, 1 / 60) for k in kites])
            motions.clear()
            ask = seconds(lambda: motions.extend(k.motion(STEER.programme) for k in kites))
            whole = seconds(lambda: picture.paint(*motions, pictures.Readings()))
            if i >= rounds:
                frame_parts = {"both models, 1/60 s": advance, "their motions": ask, **spent}
                frame_parts["rest of painting"] = whole - sum(spent.values())
                frame_parts["**the frame**"] = whole + advance + ask
                for name, value in frame_parts.items():
                    parts.setdefault(name, []).append(value)
    rows = [(name, spread(values).times(1e3)) for name, values in parts.items()]
    return table(("a frame of 1280 x 720", "ms"), rows)


def start(rounds: int, cold: bool) -> list[str]:
    """From nothing to the first result; the machine code is on disk but for the last line."""
    n = max(3, rounds // 2)
    rows = [
        (f"`import {name}`", program("-c", f"import {name}", rounds=n))
        for name in ("kitemj", "numpy", "numba", "mujoco", "kitemj.flight.simulate")
    ]
    with tempfile.TemporaryDirectory() as folder:
        short = Path(folder) / "short.toml"
        short.write_text("duration = 1.0\n")
        words = ("-m", "kitemj", "simulate", str(short), "--output", f"{folder}/a.csv")
        rows += [("`kitemj --help`", program("-m", "kitemj", "--help", rounds=n))]
        for model in ("mujoco", "lagrange"):
            timed = program(*words, "--model", model, "--overwrite", rounds=n)
            rows.append((f"`kitemj simulate`, 1 s, {model}", timed))
        if cold:
            times = []
            for i in range(2):
                empty = {"XDG_CACHE_HOME": f"{folder}/{i}", "LOCALAPPDATA": f"{folder}/{i}"}
                program("-c", "import kitemj.flight.simulate", rounds=2)
                times.append(seconds(lambda e=empty: _once(words, e)))
            rows.append(("`kitemj simulate`, first run ever", spread(times)))
    return table(("start-up", "s"), rows)


def _once(words: tuple[str, ...], environment: dict[str, str]) -> None:
    import os
    import subprocess
    import sys

    command = [sys.executable, *words, "--overwrite"]
    subprocess.run(command, env={**os.environ, **environment}, check=True, capture_output=True)


def memory(steps: int) -> list[str]:
    """What a process holds before and after many steps."""
    kite = make_model("mujoco", STEER.parameters, 0.002)
    kite.start(STEER.start, STEER.programme)
    kite.advance(STEER.programme, 20.0)
    rows, begun = [], resident()
    for tenth in range(1, 11):
        kite.advance(STEER.programme, steps / 10 * 0.002)
        kite.motion(STEER.programme)
        if tenth in (1, 5, 10):
            grown = f"{resident() - begun:+.2f}"
            rows.append((f"after {steps * tenth // 10:,} steps", f"{resident():.1f}", grown))
    return table(("memory", "MiB", "more than at first"), rows)


def main() -> None:
    """The page, on the screen and in a file."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--output", type=Path, default=ROOT / "docs" / "benchmark.md")
    parser.add_argument("--only", default=",".join(ONLY), help=f"some of {', '.join(ONLY)}")
    parser.add_argument("--rounds", type=int, default=9)
    parser.add_argument("--steps", type=int, default=1_000_000, help="of the memory test")
    parser.add_argument("--cold", action="store_true", help="also a first run with no cache")
    words = parser.parse_args()
    sections = {
        "step": lambda: step(words.rounds),
        "precision": lambda: precision(words.rounds, words.output.with_name("work_precision.png")),
        "sides": lambda: sides(words.rounds),
        "flights": lambda: flights(words.rounds),
        "length": lambda: length(words.rounds),
        "frame": lambda: frame(words.rounds),
        "start": lambda: start(words.rounds, words.cold),
        "memory": lambda: memory(words.steps),
    }
    lines = [
        f"{machine()} Medians, quartiles in brackets; processor time, but for flights, frames and "
        f"start-up, which are by the clock on the wall.",
        "",
    ]
    print("\n".join(lines))
    for name in words.only.split(","):
        part = sections[name]()
        print("\n".join(part), flush=True)
        lines += part
    words.output.write_text("\n".join(lines).rstrip() + "\n", encoding="utf-8")


if __name__ == "__main__":  # worker processes import this file
    main()
