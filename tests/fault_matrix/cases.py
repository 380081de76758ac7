"""The matrix: every fault at every moment, and what is known to fall short."""

from tests.fault_matrix.faults import FAULTS
from tests.fault_matrix.moments import MOMENTS

Case = tuple[str, str]
"""The names of a fault and a moment."""

CASES: list[Case] = [(fault, moment) for moment in MOMENTS for fault in FAULTS]

_ALIKE = (
    "Apply goes on at a board of the same model that answers within its attempts: their signatures "
    "are alike, and the device number is not read again"
)

KNOWN: dict[Case, str] = {
    ("other_board", "apply_snapshot"): _ALIKE,
    ("other_board", "apply_parameters"): _ALIKE,
    ("other_board", "apply_line_settings"): _ALIKE,
    ("echo", "connect"): "an echo that was found when connecting is expected until the line is "
    "closed, so a board whose echo ends does not come back by itself",
}
"""What the program does not do yet, and why."""


def name_of(fault: str, moment: str) -> str:
    return f"{fault}-{moment}"
