"""Scans for boards."""

import threading
from collections.abc import Callable, Iterator
from dataclasses import replace

import pytest
from pytestqt.qtbot import QtBot

from tests.support.program import new_controller, new_ports, scanner_of
from tests.support.simulator import SimulatedDevice, StartSimulator
from tests.support.virtual_time import VirtualRuntime
from trex_gui.core.discovery.prober import Prober, ProberInfo
from trex_gui.core.plugin import Lazy
from trex_gui.core.transport.settings import PortSettings
from trex_gui.devices.trex.plugin import TREX
from trex_gui.devices.trex.protocol.line_settings import LineSettings
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.devices.ports import Port, PortKind
from trex_gui.ui.devices.scanner import DeviceScanner
from trex_gui.ui.devices.simulator import Simulator
from trex_gui.ui.runtime import now

Until = Callable[[Callable[[], bool]], None]


@pytest.fixture
def until(qtbot: QtBot) -> Until:
    return qtbot.waitUntil


@pytest.fixture
def finder(qtbot: QtBot) -> Iterator[DeviceScanner]:
    simulator = Simulator(TREX)
    finder = DeviceScanner([TREX])
    finder.add_simulator("trex", simulator)
    yield finder
    assert finder.shut_down()
    simulator.stop()


def at(url: str) -> Port:
    return Port(PortKind.TYPED, url, url, "trex")


def test_found_board_is_listed_with_port_and_settings(
    finder: DeviceScanner, quick_simulator: SimulatedDevice, until: Until
) -> None:
    port = at(quick_simulator.url)
    finder.start([port])
    assert finder.running
    assert finder.is_searching(port)
    until(lambda: not finder.running)
    (finding,) = finder.findings
    assert finding.port == port
    assert finding.text == f"TReX 1.2, device 7 on {port.url} at 19200 baud."
    assert finding.found is not None
    assert finder.summary == "1 board found."
    assert not finder.is_searching(port)


@pytest.mark.realtime
def test_progress_and_findings_arrive_in_gui_thread(
    finder: DeviceScanner, quick_simulator: SimulatedDevice, until: Until
) -> None:
    threads: set[threading.Thread] = set()
    for signal in (finder.progressed, finder.changed):
        signal.connect(lambda: threads.add(threading.current_thread()))
    finder.start([at(quick_simulator.url), at("/dev/ttyNothing9")])
    until(lambda: not finder.running)
    assert len(finder.findings) == 2
    assert threads == {threading.main_thread()}


def test_scan_reports_progress_until_cancelled(
    finder: DeviceScanner, quick_simulator: SimulatedDevice, until: Until
) -> None:
    quick_simulator.do("power off")
    seen: list[tuple[int, int, str]] = []
    finder.progressed.connect(lambda: seen.append((finder.done, finder.total, finder.text)))
    finder.start([at(quick_simulator.url), at("/dev/ttyNothing9")])
    until(lambda: len(seen) >= 5)
    begun = now()
    finder.cancel()
    assert finder.text == "Ending the search …"
    until(lambda: not finder.running)
    assert now() - begun < 1.0
    quick_simulator.do("power on")
    texts = [text for _, _, text in seen]
    assert texts[0] == f"Opening {quick_simulator.url} …"
    assert f"Looking for TReX at 19200 baud on {quick_simulator.url} …" in texts
    assert f"Looking for TReX at 115200 baud on {quick_simulator.url} …" in texts
    assert (1, 194) in [(done, total) for done, total, _ in seen]
    assert finder.findings == ()
    assert finder.summary == "Search cancelled."
    assert finder.text == ""


def test_findings_are_in_the_order_of_the_first_scan_that_was_started(
    finder: DeviceScanner, start_simulator: StartSimulator, until: Until
) -> None:
    finder.start([])
    assert not finder.running
    trex, junior = (start_simulator("--unpaced", "--model", model) for model in ("trex", "trexjr"))
    finder.start([at(trex.url), at("/dev/ttyNothing9"), at(junior.url)])
    finder.start([at("/dev/ttyNothing8")])
    until(lambda: not finder.running)
    first, second, third = (finding.text for finding in finder.findings)
    assert first.startswith("TReX 1.2, device 7 on")
    assert second.startswith("There is no port /dev/ttyNothing9.")
    assert third.startswith("TReX Jr 1.2, device 7 on")


def test_scan_emits_nothing_after_shutdown(
    finder: DeviceScanner,
    quick_simulator: SimulatedDevice,
    qtbot: QtBot,
    virtual_time: VirtualRuntime,
) -> None:
    quick_simulator.do("power off")
    finder.start([at(quick_simulator.url)])
    with qtbot.assertNotEmitted(finder.finished):
        assert finder.shut_down()
        virtual_time.advance(0.05)
    assert not finder.running


def test_connecting_to_a_scanned_port_ends_the_scan_first(
    quick_simulator: SimulatedDevice, until: Until
) -> None:
    ports = new_ports()
    connector = new_controller(ports)
    device = connector.device
    port = ports.add_typed(quick_simulator.url)
    quick_simulator.do("line mute on")
    scanner_of(connector).start([port])
    until(lambda: scanner_of(connector).done > 0)
    quick_simulator.do("line mute off")
    connector.connect_to(port)
    assert connector.port is None
    until(lambda: device.link is ConnectionState.CONNECTED)
    assert not scanner_of(connector).running
    connector.shut_down()


def test_simulated_board_can_be_found_and_connected(until: Until) -> None:
    ports = new_ports()
    connector = new_controller(ports)
    device = connector.device
    connector.simulator.start()
    until(lambda: connector.simulator.url != "")
    scanner_of(connector).start([ports.demo_of("trex")])
    until(lambda: not scanner_of(connector).running)
    (finding,) = scanner_of(connector).findings
    assert finding.text == "TReX 1.2, device 7 on the Demo TReX at 19200 baud."
    assert finding.found is not None
    connector.connect_with(finding.port, finding.found.settings)
    until(lambda: device.link is ConnectionState.CONNECTED)
    assert connector.demo_in_use
    assert device.settings is not None
    assert device.settings.line == LineSettings()
    connector.shut_down()


# --- Internal errors --------------------------------------------------------------------


def _unexpected(settings: PortSettings, *, full: bool, known: bool) -> Prober:
    raise ZeroDivisionError("on purpose")


ODD = ProberInfo("Odd", _unexpected)


@pytest.fixture
def faulty(qtbot: QtBot) -> DeviceScanner:
    odd = replace(TREX, key="odd", name="Odd", prober=Lazy(f"{__name__}:ODD"))
    return DeviceScanner([TREX, odd])


def test_internal_error_is_listed_and_the_scan_continues(
    faulty: DeviceScanner, quick_simulator: SimulatedDevice, qtbot: QtBot
) -> None:
    faulty.start([at(quick_simulator.url), at("/dev/ttyNothing9")])
    qtbot.waitUntil(lambda: not faulty.running)
    first, second = faulty.findings
    assert "(ZeroDivisionError: on purpose)" in first.text
    assert second.text.startswith("There is no port /dev/ttyNothing9.")
    assert faulty.summary == "No board was found."
