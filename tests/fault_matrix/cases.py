"""The matrix: every fault at every moment."""

from tests.fault_matrix.faults import FAULTS
from tests.fault_matrix.moments import MOMENTS

Case = tuple[str, str]
"""The names of a fault and a moment."""

CASES: list[Case] = [(fault, moment) for moment in MOMENTS for fault in FAULTS]


def name_of(fault: str, moment: str) -> str:
    return f"{fault}-{moment}"
