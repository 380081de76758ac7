"""What the models stand on: a simulator or a window that stands still for seconds changes nothing.

How soon the program notices either is shown in virtual time, in `tests/link`.
"""

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
