"""Cases of the matrix: every fault at every moment."""

from tests.fault_matrix.faults import FAULTS
from tests.fault_matrix.moments import DRIVING, MOMENTS

Case = tuple[str, str]
"""Names of a fault and a moment."""

CASES: list[Case] = [(fault, moment) for moment in MOMENTS for fault in FAULTS]


_FAULTS, _MOMENTS = list(FAULTS), sorted(MOMENTS, key=lambda moment: moment not in DRIVING)


def timeout_needs_shutdown(fault: str, moment: str) -> bool:
    """Return whether the serial timeout stops motors only together with UART-Error Shutdown.

    The manual does not specify this. The values alternate, so that each fault meets both values.
    """
    return (_FAULTS.index(fault) + _MOMENTS.index(moment)) % 2 == 1


def name_of(fault: str, moment: str) -> str:
    return f"{fault}-{moment}"
