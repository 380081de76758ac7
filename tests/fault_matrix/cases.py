"""The matrix: every fault at every moment, and what is known to fall short."""

from tests.fault_matrix.faults import FAULTS
from tests.fault_matrix.moments import MOMENTS

Case = tuple[str, str]
"""The names of a fault and a moment."""

CASES: list[Case] = [(fault, moment) for moment in MOMENTS for fault in FAULTS]

KNOWN: dict[Case, str] = dict.fromkeys(
    (
        ("other_board", "apply_snapshot"),
        ("other_board", "apply_parameters"),
        ("other_board", "apply_line_settings"),
    ),
    "Apply goes on at a board of the same model that answers within its attempts: their signatures "
    "are alike, and the device number is not read again",
)
"""What the program does not do yet, and why."""


def name_of(fault: str, moment: str) -> str:
    return f"{fault}-{moment}"
