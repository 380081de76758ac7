"""Lines that end without a last report."""

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
def test_crashed_session_closes_the_line_and_keeps_may_move(
    qtbot: QtBot, monkeypatch: pytest.MonkeyPatch, drives: bool
) -> None:
    monkeypatch.setattr(TrexSession, "run", lambda _: runtime().sleep(0.1))
    line = Connection()
    line.open(ConnectionSettings("nowhere"), may_move=False)
    if drives:
        line.submit(SetMotor(1, Drive.at(20)))
    with qtbot.waitSignal(line.closed) as last:
        pass
    assert isinstance(last.args, list)
    (closed,) = last.args
    assert isinstance(closed, Closed)
    assert "Internal error" in str(closed.error)
    assert closed.may_move is drives
    assert not line.is_open


def test_requests_without_a_session_are_rejected(qtbot: QtBot) -> None:
    del qtbot
    line = Connection()
    outcomes: list[object] = []
    assert not line.request(Reload, outcomes.append)
    assert not line.submit(Reload(1))
    assert outcomes == []
    assert line.shut_down()
