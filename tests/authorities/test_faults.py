"""Faults planted one at a time in what all formulations share: an outside number must notice.

They read that code alike, so that comparing them (``tests/agreement``) says nothing of it.
"""

import pytest

from tests.authorities.faults import FAULTS
from tests.authorities.planted import outcome, planted


def test_a_copy_without_a_fault_stands():
    """Else a fault would be noticed for the copying alone."""
    with planted():
        assert not [test for test in sorted({fault.test for fault in FAULTS}) if outcome(test)]


@pytest.mark.parametrize("fault", FAULTS, ids=[fault.what for fault in FAULTS])
def test_an_authority_notices(fault):
    with planted(f"kitemj.{fault.module}", fault.right, fault.wrong):
        assert outcome(fault.test)


def test_a_fault_must_be_planted_not_believed_to_be():
    fault = FAULTS[0]
    with (
        planted(f"kitemj.{fault.module}", "no such line", ""),
        pytest.raises(ValueError, match=r"stands 0 times in kitemj\.physics\.wind"),
    ):
        outcome(fault.test)
