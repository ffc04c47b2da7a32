"""A user's own law compiles with the formulas of the package, and leaves their cache alone."""

import subprocess
import sys

LAW = """
from typing import NamedTuple
from kitemj.physics.aerodynamics import Coefficients, aero_law
from kitemj.physics.compiled import compiled
from helper import helped

class Paper(NamedTuple):
    Cx: float

@aero_law.of(Paper)
@compiled
def paper(aero, *arguments):
    return Coefficients(helped(0.1), 0.0, 0.0, 0.0, 0.0, 0.0)
"""
HELPER = """
from kitemj.physics.compiled import compiled

@compiled
def helped(x):
    return {number} * x
"""
ASK = """
from kitemj.dynamics.mujoco_kite import step
print(step._cache.cache_path)
{then}
print(step._cache.cache_path)
"""


def caches(folder, then):
    """Where the step of the MuJoCo kite is kept before and after `then`."""
    script = ASK.format(then=then)
    done = subprocess.run(
        [sys.executable, "-c", script], cwd=folder, capture_output=True, text=True, check=True
    )
    return done.stdout.split()


def test_machine_code_with_an_own_formula_is_kept_elsewhere(tmp_path):
    (tmp_path / "paper.py").write_text(LAW)
    (tmp_path / "helper.py").write_text(HELPER.format(number=1.0))
    usual, with_own = caches(tmp_path, "import paper")
    assert with_own != usual
    assert caches(tmp_path, "") == [usual, usual]
    assert caches(tmp_path, "import paper") == [usual, with_own]
    (tmp_path / "helper.py").write_text(HELPER.format(number=2.0))
    assert caches(tmp_path, "import paper")[1] not in (usual, with_own)
