"""Long lists of cases, of which the gate runs some."""

from collections.abc import Iterable
from typing import Any

import pytest


def sampled(cases: Iterable[Any], *, every: int) -> list[Any]:
    """Return cases of which all but each `every`-th are marked slow; a tuple has several values."""
    return [
        pytest.param(
            *(case if isinstance(case, tuple) else (case,)),
            marks=[pytest.mark.slow] if index % every else [],
        )
        for index, case in enumerate(cases)
    ]
