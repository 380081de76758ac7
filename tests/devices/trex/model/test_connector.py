"""From a choice in the port list to an open line, and the simulated board of the list."""

import sys
from collections.abc import Iterator
from functools import partial

import pytest
from PySide6.QtCore import QSettings
from pytestqt.qtbot import QtBot

from tests.devices.trex.model.conftest import Connect, Until
from tests.support.program import new_controller, new_ports
from tests.support.simulator import SimulatedDevice, StartSimulator
from tests.support.virtual_devices import VirtualSimulator
from trex_gui.devices.trex.model.controller import TrexController
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.plugin import TREX
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.devices.ports import Port, PortKind, Ports
from trex_gui.ui.devices.scanner import DeviceScanner
from trex_gui.ui.devices.simulator import Simulator, simulator_command

# --- Line settings ----------------------------------------------------------------------


def test_line_settings_default_to_factory(connector: TrexController) -> None:
    assert connector.settings == ConnectionSettings("")


@pytest.mark.parametrize("number", [None, 0, 7, 127])
def test_line_settings_are_saved(
    connector: TrexController, device: Device, ports: Ports, qtbot: QtBot, number: int | None
) -> None:
    line = LineSettings(57600, Detection.CRC7, 2)
    with qtbot.waitSignal(connector.changed):
        connector.set_settings(ConnectionSettings("ignored", line, number, 0x91, name="ignored"))
    expected = ConnectionSettings("", line, number, 0x91)
    assert connector.settings == expected
    assert new_controller(device, ports).settings == expected


def scanner_is_idle(scanner: DeviceScanner) -> bool:
    return not scanner.running


def test_search_keeps_to_a_line_that_other_devices_share(
    connector: TrexController,
    quick_simulator: SimulatedDevice,
    device: Device,
    ports: Ports,
    until: Until,
) -> None:
    assert isinstance(quick_simulator, VirtualSimulator)
    shared = ConnectionSettings("", LineSettings(57600), 7, reserved=frozenset({0, 1}))
    sent = bytearray()
    quick_simulator.on_write = sent.extend
    port = ports.add_typed(quick_simulator.url)
    ports.lead_to(port, "trex", ConnectionSettings("").packed)
    connector.set_settings(shared)
    for controller in (connector, new_controller(device, ports)):
        assert controller.settings == shared
        scanner = controller._scanner
        scanner.start([port], full=True)
        until(partial(scanner_is_idle, scanner))
        assert sent == bytes.fromhex("80 07 01")
        assert "Other devices share the line" in scanner.findings[0].text
        sent.clear()
        scanner.start([ports.now(port) or port], only_recall=True)  # found by a compact packet
        until(partial(scanner_is_idle, scanner))
        assert sent == bytes.fromhex("80 07 01")
        sent.clear()


def test_numbers_of_other_devices_outlast_the_choice_of_a_port(
    connector: TrexController, ports: Ports
) -> None:
    reserved = frozenset({0, 7})
    shared = ConnectionSettings("", LineSettings(57600), 9, reserved=reserved)
    connector.set_settings(shared)
    for name, number, expected in (
        ("/dev/ttyA", None, shared),  # a compact packet would reach the others
        ("/dev/ttyB", 7, shared),  # so would this number
        ("/dev/ttyC", 8, ConnectionSettings("", device_number=8, reserved=reserved)),
    ):
        port = ports.add_typed(name)
        ports.lead_to(port, "trex", ConnectionSettings("", device_number=number).packed)
        connector.choose(ports.now(port) or port)
        assert connector.settings == expected


def test_stored_number_of_another_device_opens_no_port(
    connector: TrexController,
    quick_simulator: SimulatedDevice,
    device: Device,
    ports: Ports,
    until: Until,
) -> None:
    assert isinstance(quick_simulator, VirtualSimulator)
    sent = bytearray()
    quick_simulator.on_write = sent.extend
    shared = ConnectionSettings("", LineSettings(57600), 7, reserved=frozenset({7}))
    connector.set_settings(shared)
    controller = new_controller(device, ports)
    assert controller.settings == shared
    failures: list[str] = []
    device.notifier.error.connect(failures.append)
    controller.connect_to(ports.add_typed(quick_simulator.url))
    until(lambda: bool(failures))
    assert failures == ["The board needs a number that no other device has."]
    assert not sent


@pytest.mark.parametrize(
    ("key", "value", "left"),
    [
        ("line/settings", "nonsense", 19200),
        ("line/settings", 15, 19200),
        ("line/device_number", 300, 57600),
        ("line/polynomial", "", 57600),
        ("line/reserved", "0;1", 19200),
    ],
)
def test_invalid_saved_line_settings_fall_back_to_factory(
    device: Device, ports: Ports, key: str, value: object, left: int, connector: TrexController
) -> None:
    connector.set_settings(ConnectionSettings("", LineSettings(57600)))
    QSettings().setValue(key, value)
    assert new_controller(device, ports).settings == ConnectionSettings("", LineSettings(left))


# --- Connecting -------------------------------------------------------------------------


def test_port_is_opened_with_the_chosen_settings(
    connector: TrexController,
    device: Device,
    ports: Ports,
    start_simulator: StartSimulator,
    connect: Connect,
) -> None:
    url = start_simulator().url
    connector.set_settings(ConnectionSettings("", device_number=7))
    connect(ports.add_typed(url))
    assert device.settings == ConnectionSettings(url, device_number=7)
    assert connector.port == ports.find(url)
    assert new_ports().preferred == ports.find(url)


def test_failed_open_clears_the_port(
    connector: TrexController, device: Device, until: Until
) -> None:
    connector.connect_to(Port(PortKind.TYPED, "/dev/ttyNothing9", "x", "trex"))
    assert connector.port is not None
    until(lambda: device.link is ConnectionState.DISCONNECTED)
    assert connector.port is None


def test_disconnecting_clears_the_port(
    connector: TrexController,
    device: Device,
    ports: Ports,
    quick_simulator: SimulatedDevice,
    until: Until,
    connect: Connect,
) -> None:
    connect(ports.add_typed(quick_simulator.url))
    connector.leave()
    until(lambda: device.link is ConnectionState.DISCONNECTED)
    assert connector.port is None


def test_choosing_the_demo_port_starts_the_simulator(
    connector: TrexController, device: Device, ports: Ports, until: Until
) -> None:
    connector.set_settings(ConnectionSettings("", LineSettings(115200, Detection.CRC7)))
    connector.connect_to(ports.demo_of("trex"))
    starting: list[bool] = [connector.starting]
    until(lambda: device.link is ConnectionState.CONNECTED)
    assert [*starting, connector.starting] == [True, False]
    assert connector.port == ports.demo_of("trex")
    assert connector.simulator.url
    assert device.settings is not None
    assert device.settings.line == LineSettings()


def test_simulator_keeps_running_after_disconnect(
    connector: TrexController, device: Device, ports: Ports, until: Until, connect: Connect
) -> None:
    connect(ports.demo_of("trex"))
    url = connector.simulator.url
    connector.leave()
    until(lambda: device.link is ConnectionState.DISCONNECTED)
    connect(ports.demo_of("trex"))
    assert connector.simulator.url == url


def test_later_port_choice_wins_while_the_simulator_starts(
    connector: TrexController,
    device: Device,
    ports: Ports,
    quick_simulator: SimulatedDevice,
    until: Until,
) -> None:
    connector.connect_to(ports.demo_of("trex"))
    connector.connect_to(ports.add_typed(quick_simulator.url))
    until(lambda: device.link is ConnectionState.CONNECTED and connector.simulator.url != "")
    assert device.settings is not None
    assert device.settings.url == quick_simulator.url


def test_disconnecting_while_the_simulator_starts_cancels(
    connector: TrexController, device: Device, ports: Ports, until: Until
) -> None:
    connector.connect_to(ports.demo_of("trex"))
    connector.leave()
    assert connector.port is None
    until(lambda: connector.simulator.url != "")
    assert device.link is ConnectionState.DISCONNECTED


def test_shutdown_ends_line_and_simulator(
    connector: TrexController, device: Device, ports: Ports, connect: Connect
) -> None:
    connect(ports.demo_of("trex"))
    connector.shut_down()
    assert connector.simulator.url == ""
    assert device.state is None


# --- The simulator ----------------------------------------------------------------------


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
    with qtbot.waitSignal(demo.ready):
        demo.start()
    demo.stop()
    assert demo.url == ""
    with qtbot.waitSignal(demo.ready):
        demo.start()


def test_stop_without_running_simulator_is_harmless(demo: Simulator) -> None:
    demo.stop()
    demo.send("power off")


@pytest.mark.realtime
def test_simulator_that_exits_at_start_reports_the_reason(
    demo: Simulator, qtbot: QtBot, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(
        "trex_gui.ui.devices.simulator.simulator_command",
        lambda: (sys.executable, ["-c", "raise SystemExit('no room')"]),
    )
    with qtbot.waitSignal(demo.failed) as failed:
        demo.start()
    assert failed.args == ["The simulator ended at once. no room"]


def test_missing_simulator_program_is_reported(
    demo: Simulator, qtbot: QtBot, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(
        "trex_gui.ui.devices.simulator.simulator_command", lambda: ("/nothing/here", [])
    )
    with qtbot.waitSignal(demo.failed) as failed:
        demo.start()
    assert "does not start" in failed.args[0]


def test_frozen_program_runs_itself_as_simulator(monkeypatch: pytest.MonkeyPatch) -> None:
    assert simulator_command() == (sys.executable, ["-m", "trex_gui.cli.simulator"])
    monkeypatch.setattr(sys, "frozen", True, raising=False)
    assert simulator_command() == (sys.executable, ["--simulator"])
