"""The matrix: every fault at every moment."""

from tests.fault_matrix.faults import FAULTS
from tests.fault_matrix.moments import DRIVING, MOMENTS

Case = tuple[str, str]
"""Names of a fault and a moment."""

CASES: list[Case] = [(fault, moment) for moment in MOMENTS for fault in FAULTS]


_FAULTS, _MOMENTS = list(FAULTS), sorted(MOMENTS, key=lambda moment: moment not in DRIVING)


def timeout_needs_shutdown(fault: str, moment: str) -> bool:
    """Return the hypothesis about UART-Error Shutdown for a case.

    They alternate, so that each fault is seen with both while motors are driven.
    """
    return (_FAULTS.index(fault) + _MOMENTS.index(moment)) % 2 == 1


def name_of(fault: str, moment: str) -> str:
    return f"{fault}-{moment}"
