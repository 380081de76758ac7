"""How much of many cases the gate runs, and the long tests."""

import os
from collections.abc import Iterable
from typing import Any

import hypothesis
import pytest

LONG_FACTOR = 5
"""How many times more examples hypothesis tries in the long tests."""


def examples(count: int, **options: Any) -> hypothesis.settings:
    """Return settings of hypothesis for so many examples in the gate."""
    if os.environ.get("HYPOTHESIS_PROFILE") == "all":
        count *= LONG_FACTOR
    return hypothesis.settings(max_examples=count, **options)


def sampled(cases: Iterable[Any], *, every: int) -> list[Any]:
    """Return cases of which all but each `every`-th are marked slow; a tuple has several values."""
    return [
        pytest.param(
            *(case if isinstance(case, tuple) else (case,)),
            marks=[pytest.mark.slow] if index % every else [],
        )
        for index, case in enumerate(cases)
    ]
