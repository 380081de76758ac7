"""A board in each of the variants."""

from collections.abc import Iterator

import pytest

from tests.devices.trex.conformance.ends import End, ParserEnd, WireEnd
from tests.devices.trex.conformance.trex import VARIANTS, Trex, Variant, in_gate


@pytest.fixture
def _own_settings() -> None:
    """Nothing in here remembers settings, and a folder a test costs as much as the test."""


@pytest.fixture(params=in_gate(VARIANTS), ids=str)
def trex(request: pytest.FixtureRequest) -> Iterator[Trex]:
    """A new board in serial mode, in each variant that the test allows."""
    variant: Variant = request.param
    end: End
    if variant.end == "wire":
        end = WireEnd(model=variant.model, firmware=variant.firmware, echo=variant.echo)
    else:
        end = ParserEnd(variant.model, variant.firmware)
    trex = Trex(end, variant)
    yield trex
    if not variant.echo:
        trex.nothing_more_comes()
