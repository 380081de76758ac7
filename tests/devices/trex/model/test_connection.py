"""Connections without a running session."""

import pytest
from pytestqt.qtbot import QtBot

from trex_gui.core.session import Closed
from trex_gui.devices.trex.driving.requests import SetMotor
from trex_gui.devices.trex.model.connection import Connection
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.devices.trex.session.messages import Reload
from trex_gui.devices.trex.session.session import TrexSession
from trex_gui.ui.runtime import runtime


@pytest.mark.parametrize("drives", [False, True])
def test_crashed_session_closes_the_line_and_retains_may_move(
    qtbot: QtBot, monkeypatch: pytest.MonkeyPatch, drives: bool
) -> None:
    monkeypatch.setattr(TrexSession, "run", lambda _: runtime().sleep(0.1))
    connection = Connection()
    connection.open(ConnectionSettings("nowhere"), may_move=False)
    if drives:
        connection.submit(SetMotor(1, Drive.at(20)))
    with qtbot.waitSignal(connection.closed) as signal:
        pass
    assert isinstance(signal.args, list)
    (closed,) = signal.args
    assert isinstance(closed, Closed)
    assert "Internal error" in str(closed.error)
    assert closed.may_move is drives
    assert not connection.is_open


@pytest.mark.usefixtures("qapp")
def test_requests_without_a_session_are_rejected() -> None:
    connection = Connection()
    outcomes: list[object] = []
    assert not connection.request(Reload, outcomes.append)
    assert not connection.submit(Reload(1))
    assert outcomes == []
    assert connection.shut_down()
