"""A session in its thread, with a robot at its real pace."""

import sys

import pytest
from pytestqt.qtbot import QtBot

from tests.support.simulator import StartSimulator
from trex_gui.core.discovery.scan import scan_port
from trex_gui.core.session import Closed
from trex_gui.core.timing import Timeouts
from trex_gui.core.transport.settings import PortSettings
from trex_gui.devices.aracna.discovery import ARACNA_PROBER
from trex_gui.devices.aracna.session.messages import Connected
from trex_gui.devices.aracna.session.session import AracnaSession
from trex_gui.ui.runtime import open_transport
from trex_gui.ui.workers.session_thread import LineWorker


@pytest.mark.realtime
@pytest.mark.skipif(sys.platform == "win32", reason="needs pseudo-terminals")
def test_just_started_robot_is_found_and_connected(
    start_simulator: StartSimulator, qtbot: QtBot
) -> None:
    settings = PortSettings(start_simulator("--aracna").url, timeouts=Timeouts(extra=0.2))
    [found] = scan_port(settings, {"aracna": ARACNA_PROBER}).found
    assert found.name == "Aracna 1"
    worker = LineWorker(
        lambda inbox, notify: AracnaSession(settings, inbox, notify, open_transport)
    )
    reports: list[object] = []
    worker.reported.connect(reports.append)
    worker.start()
    qtbot.waitUntil(lambda: any(isinstance(one, Connected) for one in reports), timeout=15_000)
    assert worker.close(15_000)
    qtbot.waitUntil(lambda: isinstance(reports[-1], Closed), timeout=15_000)
