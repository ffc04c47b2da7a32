"""A user's own law compiles with the formulas of the package, and leaves their cache alone."""

import subprocess
import sys

LAW = """
from typing import NamedTuple
from kitemj.physics.aerodynamics import Coefficients, aero_law
from kitemj.physics.compiled import compiled

class Paper(NamedTuple):
    Cx: float

@aero_law.of(Paper)
@compiled
def paper(aero, *arguments):
    return Coefficients({number}, 0.0, 0.0, 0.0, 0.0, 0.0)
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
    (tmp_path / "paper.py").write_text(LAW.format(number=0.1))
    usual, with_own = caches(tmp_path, "import paper")
    assert with_own != usual
    assert caches(tmp_path, "") == [usual, usual]
    assert caches(tmp_path, "import paper") == [usual, with_own]
    (tmp_path / "paper.py").write_text(LAW.format(number=0.2))
    assert caches(tmp_path, "import paper")[1] not in (usual, with_own)
