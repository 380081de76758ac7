"""Return of a board that was lost while driven."""

from dataclasses import replace

import pytest
from pytestqt.qtbot import QtBot

from tests.support.simulator import StartSimulator
from tests.support.virtual_devices import VirtualSimulator
from tests.support.virtual_time import VirtualQtBot
from trex_gui.devices.trex.driving.timeout_stop import TimeoutStop
from trex_gui.devices.trex.model.controller import TrexController
from trex_gui.devices.trex.model.drive_status import drive_inputs
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.notifier import Answer, Remedies

OUTAGE_S = 4.0


class LostBoard:
    """Board whose connection is lost for some seconds while motor 1 is driven.

    With `unstopped` no timeout stops the motor: it needs UART-Error Shutdown, which is off.
    """

    def __init__(
        self, controller: TrexController, board: VirtualSimulator, qtbot: QtBot, *, unstopped: bool
    ) -> None:
        self.board, self.qtbot, self.unstopped = board, qtbot, unstopped
        self.device = device = controller.device
        self.infos: list[str] = []
        self.answers: dict[str, Answer] = {}
        device.notifier.info.connect(self.infos.append)
        device.notifier.remedies_offered.connect(self._on_offered)

    def turns(self) -> bool:
        return bool(self.board.show()["motors"][0]["direction"] == "forward")

    def _on_offered(self, remedies: Remedies) -> None:
        self.answers = {answer.name: answer for answer in remedies if isinstance(answer, Answer)}

    def lose_and_reconnect(
        self, *, name: str = "", seconds: float = OUTAGE_S, power: str = "", new_port: str = ""
    ) -> None:
        motors, qtbot = self.device.motors, self.qtbot
        assert isinstance(qtbot, VirtualQtBot)
        settings = ConnectionSettings(self.board.url, name=name)
        self.device.connect_to(settings)
        qtbot.waitUntil(lambda: motors.is_available)
        motors.arm()
        motors.set_speed(1, 30)
        qtbot.waitUntil(self.turns)
        self.board.do("line unplug")
        qtbot.waitUntil(lambda: self.device.link is ConnectionState.DISCONNECTED)
        if power:
            self.board.do(power)
        qtbot.runtime.advance(seconds)
        assert power or self.turns() is self.unstopped
        self.board.do("line plug")
        if new_port:
            qtbot.runtime.ports[new_port] = self.board
        self.device.connect_to(replace(settings, url=new_port or settings.url))
        qtbot.waitUntil(lambda: bool(self.infos))
        qtbot.runtime.advance(1.0)


@pytest.fixture
def unstopped() -> bool:
    return False


@pytest.fixture
def lost(
    controller: TrexController, start_simulator: StartSimulator, qtbot: QtBot, *, unstopped: bool
) -> LostBoard:
    options = ("--timeout-needs-shutdown=on", "--error-shutdown=off") if unstopped else ()
    board = start_simulator("--unpaced", *options)
    assert isinstance(board, VirtualSimulator)
    board.do("eeprom serial_timeout 5", "power cycle")
    return LostBoard(controller, board, qtbot, unstopped=unstopped)


@pytest.mark.parametrize("unstopped", [False, True])
@pytest.mark.parametrize(
    ("answer", "expected"),
    [("timeoutWorked", TimeoutStop.TRIED), ("timeoutFailed", TimeoutStop.FAILED)],
)
def test_answer_about_the_timeout_is_saved_for_the_board(
    lost: LostBoard, answer: str, expected: TimeoutStop
) -> None:
    lost.lose_and_reconnect()
    assert (drive_inputs(lost.device).silence_remedy == "Cut the power.") is lost.unstopped
    assert lost.infos[-1].startswith(
        "The board is back. It has confirmed the stop. It received nothing for 4 s"
    )
    lost.answers[answer].then()
    if expected is TimeoutStop.FAILED and lost.unstopped:
        expected = TimeoutStop.REFUTED  # with UART-Error Shutdown the timeout may stop motors
    assert lost.device.board.timeout_stop is expected

    lost.lose_and_reconnect()
    lost.answers["timeoutWorked"].then()
    newest = lost.device.board.timeout_stop
    assert newest is TimeoutStop.TRIED


@pytest.mark.parametrize("adapter", ["0403:6001-A500001", ""])
def test_adapter_is_recognized_at_another_port(lost: LostBoard, adapter: str) -> None:
    errors: list[str] = []
    lost.device.notifier.error.connect(errors.append)
    lost.device.notifier.error.connect(lost.infos.append)
    lost.device.motors.adapter = adapter
    lost.lose_and_reconnect(new_port="/virtual/another")
    assert ("timeoutFailed" in lost.answers) is bool(adapter)
    warnings = [text for text in errors if "If this is another board, cut the power" in text]
    assert bool(warnings) is not bool(adapter)
    assert all(lost.board.url in text for text in warnings)
    assert not lost.device.may_move


@pytest.mark.parametrize(
    ("name", "seconds", "power"),
    [("Demo", OUTAGE_S, ""), ("", 1.0, ""), ("", OUTAGE_S, "power cycle")],
    ids=["simulated", "too short", "power was cut"],
)
def test_short_or_explained_outage_asks_no_question(
    lost: LostBoard, name: str, seconds: float, power: str
) -> None:
    lost.lose_and_reconnect(name=name, seconds=seconds, power=power)
    assert lost.infos == ["The board is back. It has confirmed the stop."]
