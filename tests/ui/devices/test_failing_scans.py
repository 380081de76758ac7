"""An internal error on one port does not end the scan of the next."""

from dataclasses import replace

import pytest
from pytestqt.qtbot import QtBot

from tests.support.simulator import SimulatedDevice
from trex_gui.core.discovery import scan
from trex_gui.core.discovery.prober import Prober, ProberInfo
from trex_gui.core.plugin import Lazy
from trex_gui.core.transport.settings import PortSettings
from trex_gui.devices.trex.plugin import TREX
from trex_gui.ui.devices.ports import Port, PortKind
from trex_gui.ui.devices.scanner import DeviceScanner, ScanWorker


def at(url: str) -> Port:
    return Port(PortKind.TYPED, url, url, "trex")


def _unexpected(settings: PortSettings, *, full: bool, known: bool) -> Prober:
    raise ZeroDivisionError("on purpose")


ODD = ProberInfo("Odd", _unexpected)


@pytest.fixture
def finder(qtbot: QtBot) -> DeviceScanner:
    odd = replace(TREX, key="odd", name="Odd", prober=Lazy(f"{__name__}:ODD"))
    return DeviceScanner([TREX, odd])


def test_internal_error_is_listed_and_the_scan_continues(
    finder: DeviceScanner, quick_simulator: SimulatedDevice, qtbot: QtBot
) -> None:
    finder.start([at(quick_simulator.url), at("/dev/ttyNothing9")])
    qtbot.waitUntil(lambda: not finder.running)
    first, second = finder.findings
    assert "(ZeroDivisionError: on purpose)" in first.text
    assert second.text.startswith("There is no port /dev/ttyNothing9.")
    assert finder.summary == ("No board was found. 1 port could not be searched (internal error).")


def test_ports_left_unscanned_are_counted(
    finder: DeviceScanner, qtbot: QtBot, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(ScanWorker, "run", lambda _worker: None)  # as a thread that dies
    finder.start([at("/dev/ttyNothing8"), at("/dev/ttyNothing9")])
    qtbot.waitUntil(lambda: not finder.running)
    assert finder.summary == ("No board was found. 2 ports could not be searched (internal error).")


def test_scan_without_internal_error_mentions_none(finder: DeviceScanner, qtbot: QtBot) -> None:
    assert not scan.PortScan().is_fault
    finder.start([at("/dev/ttyNothing9")])
    qtbot.waitUntil(lambda: not finder.running)
    assert finder.summary == "No board was found."
