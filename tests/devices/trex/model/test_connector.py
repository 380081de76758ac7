"""Connections from the port list, the simulator, and changed line settings."""

import sys
from collections.abc import Callable, Iterator

import pytest
from PySide6.QtCore import QSettings
from pytestqt.qtbot import QtBot

from tests.support.program import new_controller, new_ports
from tests.support.simulator import SimulatedDevice, StartSimulator
from tests.support.virtual_devices import VirtualSimulator
from trex_gui.devices.trex.model.power_cycle import PowerCycle
from trex_gui.devices.trex.plugin import TREX
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.devices.ports import Port, PortKind
from trex_gui.ui.devices.scanner import DeviceScanner
from trex_gui.ui.devices.simulator import Simulator, simulator_command


class ConnectorSetup:
    """Controller of a device that is not connected, and a list of ports."""

    def __init__(self, qtbot: QtBot) -> None:
        self.ports = new_ports()
        self.connector = new_controller(self.ports)
        self.device = self.connector.device
        self.until = qtbot.waitUntil

    def until_link(self, link: ConnectionState) -> None:
        self.until(lambda: self.device.link is link)

    def connect(self, port: Port) -> None:
        """Connect to a board that responds."""
        self.connector.connect_to(port)
        self.until_link(ConnectionState.CONNECTED)

    def disconnect(self) -> None:
        self.connector.disconnect_device()
        self.until_link(ConnectionState.DISCONNECTED)


@pytest.fixture
def setup(qtbot: QtBot) -> Iterator[ConnectorSetup]:
    setup = ConnectorSetup(qtbot)
    yield setup
    setup.connector.shut_down()
    setup.ports.deleteLater()


# --- Line settings ----------------------------------------------------------------------


@pytest.mark.parametrize("number", [None, 0, 7, 127])
def test_line_settings_are_saved(setup: ConnectorSetup, qtbot: QtBot, number: int | None) -> None:
    assert setup.connector.settings == ConnectionSettings("")
    line = LineSettings(57600, Detection.CRC7, 2)
    with qtbot.waitSignal(setup.connector.changed):
        setup.connector.set_settings(
            ConnectionSettings("ignored", line, number, 0x91, name="ignored")
        )
    expected = ConnectionSettings("", line, number, 0x91)
    assert setup.connector.settings == expected
    assert new_controller(setup.ports).settings == expected


def test_scan_sends_only_to_one_number_on_a_shared_line(
    setup: ConnectorSetup, quick_simulator: VirtualSimulator
) -> None:
    shared = ConnectionSettings("", LineSettings(57600), 7, reserved=frozenset({0, 1}))
    sent = bytearray()
    quick_simulator.on_write = sent.extend
    port = setup.ports.add_typed(quick_simulator.url)
    setup.ports.assign(port, "trex", ConnectionSettings("").packed)
    setup.connector.set_settings(shared)

    def sent_by(scanner: DeviceScanner, scanned: Port | None, **options: bool) -> str:
        sent.clear()
        scanner.start([scanned or port], **options)
        setup.until(lambda: not scanner.running)
        return sent.hex(" ")

    for controller in (setup.connector, new_controller(setup.ports)):
        assert controller.settings == shared
        scanner = controller._scanner
        assert sent_by(scanner, port, full=True) == "80 07 01"
        assert "other devices share the line" in scanner.findings[0].text
        entry = setup.ports.current_entry(port)  # has the settings of a compact packet
        assert sent_by(scanner, entry, only_recall=True) == "80 07 01"


def test_reserved_numbers_survive_the_selection_of_a_port(setup: ConnectorSetup) -> None:
    reserved = frozenset({0, 7})
    shared = ConnectionSettings("", LineSettings(57600), 9, reserved=reserved)
    setup.connector.set_settings(shared)
    for name, number, expected in (
        ("/dev/ttyA", None, shared),  # a compact packet would reach the other devices
        ("/dev/ttyB", 7, shared),  # a packet with this number would reach another device
        ("/dev/ttyC", 8, ConnectionSettings("", device_number=8, reserved=reserved)),
    ):
        port = setup.ports.add_typed(name)
        setup.ports.assign(port, "trex", ConnectionSettings("", device_number=number).packed)
        setup.connector.select(setup.ports.current_entry(port) or port)
        assert setup.connector.settings == expected


def test_saved_number_of_another_device_opens_no_port(
    setup: ConnectorSetup, quick_simulator: VirtualSimulator
) -> None:
    sent = bytearray()
    quick_simulator.on_write = sent.extend
    shared = ConnectionSettings("", LineSettings(57600), 7, reserved=frozenset({7}))
    setup.connector.set_settings(shared)
    controller = new_controller(setup.ports)
    assert controller.settings == shared
    failures: list[str] = []
    controller.device.notifier.error.connect(failures.append)
    controller.connect_to(setup.ports.add_typed(quick_simulator.url))
    setup.until(lambda: bool(failures))
    assert failures == ["The board needs a device number that no other device on the line has."]
    assert not sent
    controller.shut_down()


@pytest.mark.parametrize(
    ("key", "value", "baud"),
    [
        ("line/settings", "nonsense", 19200),
        ("line/settings", 15, 19200),
        ("line/device_number", 300, 57600),
        ("line/polynomial", "", 57600),
        ("line/polynomial", 3, 19200),
        ("line/reserved", "0;1", 19200),
    ],
)
def test_invalid_saved_line_settings_fall_back_to_factory(
    setup: ConnectorSetup, key: str, value: object, baud: int
) -> None:
    setup.connector.set_settings(ConnectionSettings("", LineSettings(57600)))
    QSettings().setValue(key, value)
    assert new_controller(setup.ports).settings == ConnectionSettings("", LineSettings(baud))


# --- Connecting -------------------------------------------------------------------------


def test_port_is_opened_with_the_selected_settings(
    setup: ConnectorSetup, start_simulator: StartSimulator
) -> None:
    url = start_simulator().url
    setup.connector.set_settings(ConnectionSettings("", device_number=7))
    setup.connect(setup.ports.add_typed(url))
    assert setup.device.settings == ConnectionSettings(url, device_number=7)
    assert setup.connector.port == setup.ports.find(url)
    assert new_ports().preferred == setup.ports.find(url)


def test_failed_connection_clears_the_port(setup: ConnectorSetup) -> None:
    setup.connector.connect_to(Port(PortKind.TYPED, "/dev/ttyNothing9", "x", "trex"))
    assert setup.connector.port is not None
    setup.until_link(ConnectionState.DISCONNECTED)
    assert setup.connector.port is None


def test_selecting_the_demo_port_starts_the_simulator(setup: ConnectorSetup) -> None:
    setup.connector.set_settings(ConnectionSettings("", LineSettings(115200, Detection.CRC7)))
    setup.connector.connect_to(setup.ports.demo_of("trex"))
    starting: list[bool] = [setup.connector.starting]
    setup.until_link(ConnectionState.CONNECTED)
    assert [*starting, setup.connector.starting] == [True, False]
    assert setup.connector.port == setup.ports.demo_of("trex")
    assert setup.connector.simulator.url
    assert setup.device.settings is not None
    assert setup.device.settings.line == LineSettings()


def test_simulator_keeps_running_after_disconnect(setup: ConnectorSetup) -> None:
    setup.connect(setup.ports.demo_of("trex"))
    url = setup.connector.simulator.url
    setup.disconnect()
    assert setup.connector.port is None
    setup.connect(setup.ports.demo_of("trex"))
    assert setup.connector.simulator.url == url


def test_port_selected_while_the_simulator_starts_is_opened(
    setup: ConnectorSetup, quick_simulator: SimulatedDevice
) -> None:
    setup.connector.connect_to(setup.ports.demo_of("trex"))
    setup.connector.connect_to(setup.ports.add_typed(quick_simulator.url))
    setup.until(
        lambda: (
            setup.device.link is ConnectionState.CONNECTED and setup.connector.simulator.url != ""
        )
    )
    assert setup.device.settings is not None
    assert setup.device.settings.url == quick_simulator.url


def test_disconnecting_cancels_the_start_of_a_connection(setup: ConnectorSetup) -> None:
    setup.connector.connect_to(setup.ports.demo_of("trex"))
    setup.connector.disconnect_device()
    assert setup.connector.port is None
    setup.until(lambda: setup.connector.simulator.url != "")
    assert setup.device.link is ConnectionState.DISCONNECTED


def test_shutdown_ends_connection_and_simulator(setup: ConnectorSetup) -> None:
    setup.connect(setup.ports.demo_of("trex"))
    setup.connector.shut_down()
    assert setup.connector.simulator.url == ""
    assert setup.device.state is None


# --- Simulator --------------------------------------------------------------------------


@pytest.fixture
def demo(qtbot: QtBot) -> Iterator[Simulator]:
    demo = Simulator(TREX)
    yield demo
    demo.stop()


def test_running_simulator_is_not_started_twice(demo: Simulator, qtbot: QtBot) -> None:
    with qtbot.waitSignal(demo.ready) as first:
        demo.start()
        demo.start()
    with qtbot.waitSignal(demo.ready) as second:
        demo.start()
    assert first.args == second.args == [demo.url]


def test_stopped_simulator_can_be_restarted(demo: Simulator, qtbot: QtBot) -> None:
    failures: list[str] = []
    demo.failed.connect(failures.append)
    demo.stop()
    demo.send("power off")
    with qtbot.waitSignal(demo.ready):
        demo.start()
    demo.stop()
    assert failures == []
    assert demo.url == ""
    with qtbot.waitSignal(demo.ready):
        demo.start()


@pytest.mark.realtime
@pytest.mark.parametrize(
    ("program", "script", "words"),
    [
        (sys.executable, "raise SystemExit('no memory')", "exited immediately. no memory"),
        ("/nothing/here", "", "could not be started"),
    ],
)
def test_simulator_that_does_not_start_reports_the_reason(
    demo: Simulator,
    qtbot: QtBot,
    monkeypatch: pytest.MonkeyPatch,
    program: str,
    script: str,
    words: str,
) -> None:
    command = "trex_gui.ui.devices.simulator.simulator_command"
    monkeypatch.setattr(command, lambda: (program, ["-c", script]))
    with qtbot.waitSignal(demo.failed) as failed:
        demo.start()
    assert words in failed.args[0]


def test_frozen_program_runs_itself_as_simulator(monkeypatch: pytest.MonkeyPatch) -> None:
    assert simulator_command() == (sys.executable, ["-m", "trex_gui.cli.simulator"])
    monkeypatch.setattr(sys, "frozen", True, raising=False)
    assert simulator_command() == (sys.executable, ["--simulator"])


# --- Board with changed line settings ---------------------------------------------------


NEW = LineSettings(57600, Detection.CRC7)


def store(setup: ConnectorSetup, **wires: int) -> None:
    """Apply these parameters, and wait for the end."""
    device = setup.device
    for key, wire in wires.items():
        device.parameters.edit(key, wire)
    device.writer.apply()
    setup.until(lambda: not device.writer.running and device.draft.pending == 0)


def restart(setup: ConnectorSetup, act: Callable[[], None]) -> None:
    """Wait until a board that is restarted by `act` responds again."""
    act()
    setup.until_link(ConnectionState.NOT_RESPONDING)
    setup.until_link(ConnectionState.CONNECTED)


def line_of(setup: ConnectorSetup) -> LineSettings:
    assert setup.device.settings is not None
    return setup.device.settings.line


def test_reconnect_at_new_line_settings_is_saved(
    setup: ConnectorSetup, quick_simulator: SimulatedDevice
) -> None:
    setup.connect(setup.ports.add_typed(quick_simulator.url))
    store(setup, uart_settings=NEW.to_wire(), crc7_polynomial=0x11)
    setup.device.connection.expect((ConnectionSettings("", NEW, polynomial=0x91),))
    quick_simulator.do("power off")
    setup.until_link(ConnectionState.NOT_RESPONDING)
    assert setup.connector.settings == ConnectionSettings("")
    quick_simulator.do("power on")
    setup.until_link(ConnectionState.CONNECTED)
    expected = ConnectionSettings(quick_simulator.url, NEW, polynomial=0x91)
    assert setup.device.settings == expected
    assert setup.connector.settings == ConnectionSettings("", NEW, polynomial=0x91)
    assert new_controller(setup.ports).settings == setup.connector.settings
    assert setup.device.parameters.values.active_of("uart_settings") == NEW.to_wire()
    setup.disconnect()
    setup.connect(setup.ports.add_typed(quick_simulator.url))
    assert setup.device.settings == expected


def test_failed_write_of_line_settings_retains_candidates(
    setup: ConnectorSetup, quick_simulator: SimulatedDevice
) -> None:
    setup.connect(setup.ports.add_typed(quick_simulator.url))
    setup.device.connection.expect((ConnectionSettings("", NEW),))
    PowerCycle(setup.device).start(failed=["uart_settings"])
    quick_simulator.do("power off")
    setup.until_link(ConnectionState.NOT_RESPONDING)
    quick_simulator.do(f"eeprom uart_settings {NEW.to_wire()}", "power on")
    setup.until_link(ConnectionState.CONNECTED)
    assert line_of(setup) == NEW


def test_simulated_board_has_its_last_line_settings_until_reset(setup: ConnectorSetup) -> None:
    setup.connect(setup.ports.demo_of("trex"))
    store(setup, uart_settings=NEW.to_wire())
    setup.device.connection.expect((ConnectionSettings("", NEW),))
    restart(setup, setup.connector.demo_board.power_cycle)
    assert line_of(setup) == NEW
    assert setup.connector.settings == ConnectionSettings("")  # only for real boards
    setup.disconnect()
    setup.connect(setup.ports.demo_of("trex"))
    assert line_of(setup) == NEW
    restart(setup, setup.connector.demo_board.restore_factory)
    assert line_of(setup) == LineSettings()
    setup.connector.simulator.stop()
    setup.until_link(ConnectionState.DISCONNECTED)
    setup.connect(setup.ports.demo_of("trex"))
    assert line_of(setup) == LineSettings()
