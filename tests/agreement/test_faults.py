"""Faults planted one at a time: a ladder that no fault can break proves nothing.

Faults of the forces, the frames or the steering, which all models share, cannot be seen by
comparing models; those rooms are held against outside numbers in ``tests/authorities``.
"""

import pytest

from tests.agreement.faults import FAULTS
from tests.agreement.formulations import MODULES, copied
from tests.agreement.rungs import RUNGS, climb, holds
from tests.support import random_cases

CASES = random_cases(12)


@pytest.mark.parametrize("model", MODULES)
def test_a_copy_without_a_fault_stands(model):
    """Else a fault would be noticed for the copying alone."""
    assert climb(copied(model), CASES) == ""


@pytest.mark.parametrize("fault", FAULTS, ids=[f"{f.model}: {f.what}" for f in FAULTS])
def test_the_ladder_breaks_where_a_fault_is(fault):
    faulty = copied(fault.model, fault.module, fault.right, fault.wrong)
    assert climb(faulty, CASES) == fault.rung


BREAKS = {  # a fault for each rung, though an earlier one may notice it too
    "motion": "a line attached 1 cm too low",
    "accelerations": "J̇q̇ dropped",
    "tensions": "tensions of left and right exchanged",
    "trajectory": "quaternion turning backwards",
    "balance": "gravity 1 % too strong in the engine",
    "order": "lines and wind taken at the start of the step",
}


@pytest.mark.parametrize("rung", RUNGS)
def test_every_rung_can_break(rung):
    [fault] = [f for f in FAULTS if f.what == BREAKS[rung]]
    assert not holds(rung, copied(*fault[1:5]), CASES)


def test_a_fault_must_be_planted_not_believed_to_be():
    with pytest.raises(ValueError, match="stands 0 times in lagrange"):
        copied("lagrange", "lagrange", "no such line", "")
