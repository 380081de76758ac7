"""The page of poses on a robot whose state is set by the test."""

from collections.abc import Iterator

import pytest
from pytestqt.qtbot import QtBot

from tests.devices.aracna.views.poses_stage import StagedPageDriver


@pytest.fixture
def driver(qtbot: QtBot) -> Iterator[StagedPageDriver]:
    driver = StagedPageDriver(qtbot)
    yield driver
    driver.close()
