"""Setpoints and stops between the window and a board in another process."""

import threading
import time
from collections.abc import Iterator
from itertools import pairwise

import pytest
from pytestqt.qtbot import QtBot

from tests.support.simulator import SimulatedDevice
from tests.support.virtual_devices import VirtualSimulator
from tests.support.virtual_time import VirtualRuntime
from trex_gui.core.errors import StudioError
from trex_gui.core.guardian.log import log_file
from trex_gui.core.timing import Timeouts
from trex_gui.devices.trex.driving.requests import Heartbeat, MotorsStopped
from trex_gui.devices.trex.model.connection import Connection
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.drive_controller import DriveController
from trex_gui.devices.trex.model.motors import Motors
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.descriptions import STOP_WITHOUT_EFFECT
from trex_gui.devices.trex.protocol.errors import ErrorCode
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.notifier import Notifier, Remedy
from trex_gui.ui.runtime import now, runtime

STOOD_STILL = "The program did not respond for more than half a second."


class DrivenDevice(Device):
    """Device whose motor 1 runs."""

    def __init__(self, simulator: SimulatedDevice, qtbot: QtBot) -> None:
        super().__init__()
        self.simulator = simulator
        self.wait = qtbot.waitUntil
        self.connect_to(ConnectionSettings(simulator.url))
        self.wait(lambda: self.link is ConnectionState.CONNECTED and self.motors.is_available)
        self.motors.arm()
        self.motors.accelerate = False
        self.motors.set_speed(1, 90)
        self.wait(lambda: simulator.show()["motors"][0]["speed"] == 90)


@pytest.fixture
def driven(quick_simulator: SimulatedDevice, qtbot: QtBot) -> Iterator[DrivenDevice]:
    driven = DrivenDevice(quick_simulator, qtbot)
    yield driven
    qtbot.waitUntil(driven.shut_down)


def is_braked(simulator: SimulatedDevice) -> bool:
    return bool(simulator.show()["motors"][0]["direction"] == "brake")


def test_stop_from_another_thread_drops_later_setpoints(driven: DrivenDevice) -> None:
    thread = threading.Thread(target=driven.connection.stop_now)
    thread.start()
    thread.join()
    # The window does not know it yet, and continues to send setpoints.
    driven.motors.set_speed(1, 70)
    driven.wait(lambda: is_braked(driven.simulator))
    driven.motors.set_speed(1, 80)
    driven.motors.stop()
    driven.wait(lambda: not driven.may_move)
    assert is_braked(driven.simulator)
    driven.motors.arm()
    driven.motors.set_speed(1, 40)
    driven.wait(lambda: driven.simulator.show()["motors"][0]["speed"] == 40)


def test_stop_without_outcome_fails_when_the_line_closes(driven: DrivenDevice) -> None:
    answers: list[StudioError | None] = []
    driven.driving.stop(answers.append)
    assert driven.shut_down()
    assert [str(answer) for answer in answers] == [
        "The connection was closed before this was complete."
    ]


def test_restarted_board_disarms_the_motors(driven: DrivenDevice) -> None:
    """Only the changed input source reveals the short restart."""
    driven.simulator.do("eeprom channel_input_source 1")
    driven.simulator.do("power cycle")
    driven.wait(lambda: not driven.motors.armed)
    assert "restarted" in driven.motors.stop_reason
    driven.wait(lambda: not driven.may_move)
    assert not driven.motors.armed


def test_line_error_disarms_and_clears_setpoints(driven: DrivenDevice) -> None:
    driven.simulator.do("line error framing 1")
    driven.wait(lambda: not driven.motors.armed)
    assert "framing error" in driven.motors.stop_reason
    assert driven.motors.text == ""
    driven.wait(lambda: not driven.may_move)
    assert is_braked(driven.simulator)
    assert any("motor commands are repeated" in event.text for event in driven.events.all)


def test_frozen_window_reports_the_confirmed_stop(driven: DrivenDevice) -> None:
    said: list[str] = []
    driven.notifier.error.connect(said.append)
    deadline = now() + 15
    while not is_braked(driven.simulator):  # without events of the window
        assert now() < deadline, "the motor was not stopped"
        runtime().sleep(0.05)
    driven.wait(lambda: not driven.may_move)
    assert said == [f"{STOOD_STILL} The motors were stopped. Arm the motors again to continue."]
    assert driven.motors.stop_reason == STOOD_STILL
    cleared: list[bool] = []
    driven.notifier.cleared.connect(lambda: cleared.append(driven.motors.armed))
    driven.wait(lambda: driven.motors.can_arm)
    driven.motors.arm()
    assert cleared == [True], "the message is over"


def hang(driven: DrivenDevice, seconds: float) -> None:
    """Block the session in its next write, and wait until it is blocked."""
    simulator = driven.simulator
    assert isinstance(simulator, VirtualSimulator)
    hanging: list[bytes] = []

    def block(data: bytes) -> None:
        if not hanging:
            hanging.append(data)
            runtime().sleep(seconds)

    simulator.on_write = block
    driven.wait(lambda: bool(hanging))


@pytest.mark.parametrize(
    ("is_guarded", "remedy"),
    [(True, "The guardian process sends it now."), (False, "Cut the power.")],
)
def test_stop_of_a_hanging_session_is_reported(
    is_guarded: bool, remedy: str, driven: DrivenDevice, virtual_time: VirtualRuntime
) -> None:
    said: list[str] = []
    driven.notifier.danger.connect(said.append)
    hang(driven, 2.0)
    driven.connection.is_guarded = is_guarded
    for _ in range(3):  # pressed again and again
        driven.motors.press_stop()
        virtual_time.advance(0.24)
    assert len(said) == 1
    assert "The connection is not responding, so the stop could not be sent." in said[0]
    assert remedy in said[0]
    driven.wait(lambda: not driven.may_move)
    assert is_braked(driven.simulator)


@pytest.mark.parametrize(
    ("result", "news"),
    [
        ("confirmed", ["The guardian process stopped the motors, and the board confirmed it."]),
        ("unconfirmed", []),
    ],
)
def test_session_that_hangs_is_noticed_within_a_second(
    result: str, news: list[str], driven: DrivenDevice
) -> None:
    said: list[str] = []
    told: list[str] = []
    driven.notifier.danger.connect(said.append)
    driven.notifier.info.connect(told.append)
    hang(driven, 2.0)
    began = now()
    log_file().parent.mkdir(parents=True, exist_ok=True)
    line = f"{time.strftime('%Y-%m-%d %H:%M:%S')} {result}: in time\n"
    log_file().write_text(line, encoding="utf-8")
    driven.wait(lambda: bool(said))
    assert now() - began < 1.0
    assert said[0].startswith("Motor 1 may still be turning. Cut the power.")
    assert driven.motors.stop_reason == "The connection is not responding."
    driven.wait(lambda: not driven.may_move)
    assert told == news


def test_arming_on_a_noisy_line_recommends_crc(driven: DrivenDevice, qtbot: QtBot) -> None:
    driven.board.quality.is_noisy = True
    with qtbot.waitSignal(driven.notifier.remedies_offered) as offered:
        driven.motors.arming_changed.emit()
    assert offered.args == [(Remedy.SET_UP_CRC,)]


def test_session_that_did_not_respond_disarms_the_motors(driven: DrivenDevice) -> None:
    said: list[str] = []
    driven.notifier.error.connect(said.append)
    hang(driven, 0.55)
    driven.motors.set_speed(1, 90)
    driven.wait(lambda: not driven.motors.armed)
    driven.wait(lambda: not driven.may_move)
    assert driven.motors.stop_reason == STOOD_STILL
    assert len(said) == 1
    assert is_braked(driven.simulator)


def test_unconfirmed_stop_is_reported_as_unconfirmed(qtbot: QtBot) -> None:
    connection, motors = Connection(), Motors()
    notifier = Notifier()
    driving = DriveController(motors, Device().board, connection, notifier)
    with qtbot.waitSignal(notifier.error) as said:
        connection.motors_stopped.emit(MotorsStopped(ErrorCode.NO_HEARTBEAT, confirmed=False))
    assert said.args == [f"{STOOD_STILL} A stop was sent but is not confirmed yet."]
    assert motors.stop_reason == STOOD_STILL
    assert not driving.may_move


def test_armed_motors_send_heartbeats_at_a_steady_rate(
    virtual_time: VirtualRuntime, monkeypatch: pytest.MonkeyPatch
) -> None:
    moments: list[float | None] = []

    def submit(_connection: Connection, request: object) -> bool:
        if isinstance(request, Heartbeat):
            moments.append(request.sent)
        return True

    monkeypatch.setattr(Connection, "submit", submit)
    connection, motors = Connection(), Motors()
    notifier = Notifier()
    driving = DriveController(motors, Device().board, connection, notifier)
    assert not driving.may_move
    motors.set_available(True)
    motors.arm()
    virtual_time.advance(10.0)
    sent = [moment for moment in moments if moment is not None]
    gaps = [later - earlier for earlier, later in pairwise(sent)]
    assert max(gaps) < Timeouts().heartbeat / 2, "one may be late or lost"
    assert min(gaps) > 0.05, "they are no load for the line"
    motors.stop()
    virtual_time.advance(1.0)
    assert moments == sent


def test_confirmed_stop_is_reported_once_and_without_a_warning(
    device: Device,
    quick_simulator: SimulatedDevice,
    qtbot: QtBot,
    virtual_time: VirtualRuntime,
) -> None:
    outcomes: list[StudioError | None] = []
    failures: list[str] = []
    for failed in (device.notifier.error, device.notifier.danger):
        failed.connect(failures.append)
    device.connect_to(ConnectionSettings(quick_simulator.url))
    qtbot.waitUntil(lambda: device.motors.is_available)
    device.driving.stop(outcomes.append)
    qtbot.waitUntil(lambda: outcomes == [None])
    device.driving.stop(lambda _error: None)
    virtual_time.advance(1.0)
    assert outcomes == [None]
    assert failures == []


def test_stop_warns_that_channel_driven_motors_may_go_on(rc_device: Device, qtbot: QtBot) -> None:
    with qtbot.waitSignal(rc_device.notifier.error) as said:
        rc_device.motors.stop()
    assert said.args == [STOP_WITHOUT_EFFECT]
