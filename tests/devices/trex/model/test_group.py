"""Group of boards on one line."""

from pytestqt.qtbot import QtBot

from tests.support.simulator import StartSimulator
from trex_gui.core.events import Event, EventKind
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.group import BoardGroup
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.ui.runtime import now


def test_late_event_of_another_board_is_forwarded(
    start_simulator: StartSimulator, qtbot: QtBot
) -> None:
    """A fault has the time of its sample, so later events may already be in the log."""
    line, device = start_simulator("--unpaced", "--device", "7", "--device", "9"), Device()
    group = BoardGroup(device)
    device.connect_to(ConnectionSettings(line.url).with_group((7, 9)))
    qtbot.waitUntil(lambda: device.motors.is_available)
    events = group.devices[9].events
    events.add(EventKind.NOTE, "newer")
    events.put(Event(now() - 1.0, EventKind.FAULT, "older", is_problem=True))
    texts = [event.text for event in device.events.all]
    assert texts.count("Board 9: newer") == texts.count("Board 9: older") == 1
    qtbot.waitUntil(device.shut_down)
