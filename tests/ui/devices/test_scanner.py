"""Scans for boards."""

import threading
from collections.abc import Iterator

import pytest
from pytestqt.qtbot import QtBot

from tests.support.program import new_controller, new_ports, scanner_of
from tests.support.simulator import SimulatedDevice, StartSimulator
from tests.support.virtual_time import VirtualRuntime
from trex_gui.devices.trex.plugin import TREX
from trex_gui.devices.trex.protocol.line_settings import LineSettings
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.devices.ports import Port, PortKind
from trex_gui.ui.devices.scanner import DeviceScanner
from trex_gui.ui.devices.simulator import Simulator
from trex_gui.ui.runtime import now


@pytest.fixture
def scanner(qtbot: QtBot) -> Iterator[DeviceScanner]:
    simulator = Simulator(TREX)
    scanner = DeviceScanner([TREX])
    scanner.add_simulator("trex", simulator)
    yield scanner
    assert scanner.shut_down()
    simulator.stop()


def typed_port(url: str) -> Port:
    return Port(PortKind.TYPED, url, url, "trex")


def test_found_board_is_listed_with_port_and_settings(
    scanner: DeviceScanner, quick_simulator: SimulatedDevice, qtbot: QtBot
) -> None:
    port = typed_port(quick_simulator.url)
    scanner.start([port])
    assert scanner.running
    assert scanner.is_scanning(port)
    qtbot.waitUntil(lambda: not scanner.running)
    (finding,) = scanner.findings
    assert finding.port == port
    assert finding.text == f"TReX 1.2, device 7 on {port.url} at 19200 baud."
    assert finding.found is not None
    assert scanner.summary == "1 board found."
    assert not scanner.is_scanning(port)


@pytest.mark.realtime
def test_progress_and_findings_arrive_in_gui_thread(
    scanner: DeviceScanner, quick_simulator: SimulatedDevice, qtbot: QtBot
) -> None:
    threads: set[threading.Thread] = set()
    for signal in (scanner.progressed, scanner.changed):
        signal.connect(lambda: threads.add(threading.current_thread()))
    scanner.start([typed_port(quick_simulator.url), typed_port("/dev/ttyNothing9")])
    qtbot.waitUntil(lambda: not scanner.running)
    assert len(scanner.findings) == 2
    assert threads == {threading.main_thread()}


def test_scan_reports_progress_until_cancelled(
    scanner: DeviceScanner, quick_simulator: SimulatedDevice, qtbot: QtBot
) -> None:
    quick_simulator.do("power off")
    reports: list[tuple[int, int, str]] = []
    scanner.progressed.connect(lambda: reports.append((scanner.done, scanner.total, scanner.text)))
    scanner.start([typed_port(quick_simulator.url), typed_port("/dev/ttyNothing9")])
    qtbot.waitUntil(lambda: len(reports) >= 5)
    start = now()
    scanner.cancel()
    assert scanner.text == "Ending the search …"
    qtbot.waitUntil(lambda: not scanner.running)
    assert now() - start < 1.0
    quick_simulator.do("power on")
    texts = [text for _, _, text in reports]
    assert texts[0] == f"Opening {quick_simulator.url} …"
    assert f"Looking for TReX at 19200 baud on {quick_simulator.url} …" in texts
    assert f"Looking for TReX at 115200 baud on {quick_simulator.url} …" in texts
    assert (1, 194) in [(done, total) for done, total, _ in reports]
    assert scanner.findings == ()
    assert scanner.summary == "Search cancelled."
    assert scanner.text == ""


def test_findings_have_port_order_and_a_second_start_is_ignored(
    scanner: DeviceScanner, start_simulator: StartSimulator, qtbot: QtBot
) -> None:
    scanner.start([])
    assert not scanner.running
    trex, junior = (start_simulator("--unpaced", "--model", model) for model in ("trex", "trexjr"))
    scanner.start([typed_port(trex.url), typed_port("/dev/ttyNothing9"), typed_port(junior.url)])
    scanner.start([typed_port("/dev/ttyNothing8")])
    qtbot.waitUntil(lambda: not scanner.running)
    first, second, third = (finding.text for finding in scanner.findings)
    assert first.startswith("TReX 1.2, device 7 on")
    assert second.startswith("There is no port /dev/ttyNothing9.")
    assert third.startswith("TReX Jr 1.2, device 7 on")


def test_scan_emits_nothing_after_shutdown(
    scanner: DeviceScanner,
    quick_simulator: SimulatedDevice,
    qtbot: QtBot,
    virtual_time: VirtualRuntime,
) -> None:
    quick_simulator.do("power off")
    scanner.start([typed_port(quick_simulator.url)])
    with qtbot.assertNotEmitted(scanner.finished):
        assert scanner.shut_down()
        virtual_time.advance(0.05)
    assert not scanner.running


def test_connecting_to_a_scanned_port_ends_the_scan_first(
    quick_simulator: SimulatedDevice, qtbot: QtBot
) -> None:
    ports = new_ports()
    connector = new_controller(ports)
    device = connector.device
    port = ports.add_typed(quick_simulator.url)
    quick_simulator.do("line mute on")
    scanner_of(connector).start([port])
    qtbot.waitUntil(lambda: scanner_of(connector).done > 0)
    quick_simulator.do("line mute off")
    connector.connect_to(port)
    assert connector.port is None
    qtbot.waitUntil(lambda: device.link is ConnectionState.CONNECTED)
    assert not scanner_of(connector).running
    connector.shut_down()


def test_simulated_board_can_be_found_and_connected(qtbot: QtBot) -> None:
    ports = new_ports()
    connector = new_controller(ports)
    device = connector.device
    connector.simulator.start()
    qtbot.waitUntil(lambda: connector.simulator.url != "")
    scanner_of(connector).start([ports.demo_of("trex")])
    qtbot.waitUntil(lambda: not scanner_of(connector).running)
    (finding,) = scanner_of(connector).findings
    assert finding.text == "TReX 1.2, device 7 on the Demo TReX at 19200 baud."
    assert finding.found is not None
    connector.connect_with(finding.port, finding.found.settings)
    qtbot.waitUntil(lambda: device.link is ConnectionState.CONNECTED)
    assert connector.demo_in_use
    assert device.settings is not None
    assert device.settings.line == LineSettings()
    connector.shut_down()
