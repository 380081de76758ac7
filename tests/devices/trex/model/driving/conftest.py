"""Devices without a window, and a simulated board in RC mode."""

from collections.abc import Iterator

import pytest
from pytestqt.qtbot import QtBot

from tests.support.program import new_controller
from tests.support.simulator import SimulatedDevice, StartSimulator
from trex_gui.devices.trex.model.controller import TrexController
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.ui.devices.connection import ConnectionState


@pytest.fixture
def device(qtbot: QtBot) -> Iterator[Device]:
    device = Device()
    yield device
    qtbot.waitUntil(device.shut_down)


@pytest.fixture
def controller(qtbot: QtBot) -> Iterator[TrexController]:
    controller = new_controller()
    yield controller
    qtbot.waitUntil(controller.device.shut_down)


@pytest.fixture
def rc_board(start_simulator: StartSimulator) -> SimulatedDevice:
    """Simulated board in RC mode with all sticks at rest."""
    return start_simulator("--unpaced", "--mode", "rc")


@pytest.fixture
def rc_device(device: Device, rc_board: SimulatedDevice, qtbot: QtBot) -> Device:
    """Device that is connected to `rc_board`, before the first sample."""
    device.connect_to(ConnectionSettings(rc_board.url))
    qtbot.waitUntil(lambda: device.link is ConnectionState.CONNECTED)
    return device
