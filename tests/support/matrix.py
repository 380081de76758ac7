"""Numbers of test cases in the gate and in the long tests."""

import os
from collections.abc import Iterable
from typing import Any

import hypothesis
import pytest

LONG_FACTOR = 5
"""Ratio of hypothesis examples in the long tests to those in the gate."""


def examples(count: int, **options: Any) -> hypothesis.settings:
    """Return hypothesis settings with this number of examples in the gate."""
    if os.environ.get("HYPOTHESIS_PROFILE") == "all":
        count *= LONG_FACTOR
    return hypothesis.settings(max_examples=count, **options)


def sampled(cases: Iterable[Any], *, every: int) -> list[Any]:
    """Mark all cases as slow, except the first of every `every`. A tuple has several values."""
    return [
        pytest.param(
            *(case if isinstance(case, tuple) else (case,)),
            marks=[pytest.mark.slow] if index % every else [],
        )
        for index, case in enumerate(cases)
    ]
