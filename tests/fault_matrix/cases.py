"""The matrix: every fault at every moment, and what is known to fall short."""

from tests.fault_matrix.faults import FAULTS
from tests.fault_matrix.moments import MOMENTS

Case = tuple[str, str]
"""The names of a fault and a moment."""

CASES: list[Case] = [(fault, moment) for moment in MOMENTS for fault in FAULTS]

KNOWN: dict[Case, str] = {
    ("echo", "connect"): "an echo that was found when connecting is expected until the line is "
    "closed, so a board whose echo ends does not come back by itself",
}
"""What the program does not do yet, and why."""


def name_of(fault: str, moment: str) -> str:
    return f"{fault}-{moment}"
