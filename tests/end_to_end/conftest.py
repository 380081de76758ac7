"""What every test with a real line stands on: whoever stands still for seconds changes nothing."""

import pytest

from tests.support.standing_still import LONG_PATIENCE


@pytest.fixture
def usual_patience() -> None:
    """Wait no longer for window and board than the program does by itself."""


@pytest.fixture(autouse=True)
def _long_patience(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    if "usual_patience" not in request.fixturenames:
        for module, name, value in LONG_PATIENCE:
            monkeypatch.setattr(module, name, value)
