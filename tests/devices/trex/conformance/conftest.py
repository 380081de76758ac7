"""Board under test, in each variant."""

from collections.abc import Iterator

import pytest

from tests.devices.trex.conformance.harnesses import Harness, ParserHarness, WireHarness
from tests.devices.trex.conformance.trex import VARIANTS, Trex, Variant, mark_slow


@pytest.fixture
def _own_settings() -> None:
    """Replaces the fixture that creates a settings folder, because these tests save nothing."""


@pytest.fixture(params=mark_slow(VARIANTS), ids=str)
def trex(request: pytest.FixtureRequest) -> Iterator[Trex]:
    """A new board in serial mode, in each variant that the test allows."""
    variant: Variant = request.param
    harness: Harness
    if variant.harness == "wire":
        harness = WireHarness(model=variant.model, firmware=variant.firmware, echo=variant.echo)
    else:
        harness = ParserHarness(variant.model, variant.firmware)
    trex = Trex(harness, variant)
    yield trex
    if not variant.echo:
        trex.assert_silence()
