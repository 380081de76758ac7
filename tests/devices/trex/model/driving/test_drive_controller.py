"""Setpoints and stops between the window and a simulated board."""

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
from trex_gui.ui.notifier import Notifier, Remedy
from trex_gui.ui.runtime import now, runtime

NO_RESPONSE = "The program did not respond for more than half a second."


class DrivenDevice(Device):
    """Device that drives motor 1."""

    def __init__(self, simulator: SimulatedDevice, qtbot: QtBot) -> None:
        super().__init__()
        self.simulator = simulator
        self.wait = qtbot.waitUntil
        self.connect_to(ConnectionSettings(simulator.url))
        self.wait(lambda: self.motors.is_available)
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
    # The window has not received the stop yet and still sends setpoints.
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
    outcomes: list[StudioError | None] = []
    driven.driving.stop(outcomes.append)
    assert driven.shut_down()
    (error,) = outcomes
    assert str(error) == "The connection was closed before the request was complete."


def test_restarted_board_disarms_the_motors(driven: DrivenDevice) -> None:
    """The changed input source is the only sign of the short restart."""
    driven.simulator.do("eeprom channel_input_source 1", "power cycle")
    driven.wait(lambda: not driven.motors.armed)
    assert "restarted" in driven.motors.stop_reason
    driven.wait(lambda: not driven.may_move)
    assert not driven.motors.armed


def test_line_error_disarms_and_clears_setpoints(driven: DrivenDevice) -> None:
    driven.simulator.do("line error framing 1")
    driven.wait(lambda: not driven.motors.armed)
    assert "Framing error" in driven.motors.stop_reason
    assert driven.motors.text == ""
    driven.wait(lambda: not driven.may_move)
    assert is_braked(driven.simulator)


def test_hanging_window_reports_the_confirmed_stop(driven: DrivenDevice) -> None:
    errors: list[str] = []
    driven.notifier.error.connect(errors.append)
    deadline = now() + 15
    while not is_braked(driven.simulator):  # without running the window's events
        assert now() < deadline, "the motor was not stopped"
        runtime().sleep(0.05)
    driven.wait(lambda: not driven.may_move)
    assert errors == [f"{NO_RESPONSE} The motors were stopped. Arm the motors again to continue."]
    assert driven.motors.stop_reason == NO_RESPONSE
    cleared: list[bool] = []
    driven.notifier.cleared.connect(lambda: cleared.append(driven.motors.armed))
    driven.wait(lambda: driven.motors.can_arm)
    driven.motors.arm()
    assert cleared == [True]


def hang(driven: DrivenDevice, seconds: float) -> None:
    """Block the session in its next write, and wait until it is blocked."""
    simulator = driven.simulator
    assert isinstance(simulator, VirtualSimulator)
    blocked: list[bytes] = []

    def block(data: bytes) -> None:
        if not blocked:
            blocked.append(data)
            runtime().sleep(seconds)

    simulator.on_write = block
    driven.wait(lambda: bool(blocked))


@pytest.mark.parametrize(
    ("is_guarded", "remedy"),
    [(True, "The guardian process is sending the stop now."), (False, "Cut the power.")],
)
def test_stop_of_a_hanging_session_is_reported_once(
    is_guarded: bool, remedy: str, driven: DrivenDevice, virtual_time: VirtualRuntime
) -> None:
    warnings: list[str] = []
    driven.notifier.danger.connect(warnings.append)
    hang(driven, 2.0)
    driven.connection.is_guarded = is_guarded
    for _ in range(3):
        driven.motors.press_stop()
        virtual_time.advance(0.24)
    (warning,) = warnings
    assert "The connection is not responding, so the stop could not be sent." in warning
    assert remedy in warning
    driven.wait(lambda: not driven.may_move)
    assert is_braked(driven.simulator)


@pytest.mark.parametrize(
    ("result", "expected"),
    [
        ("confirmed", ["The guardian process stopped the motors, and the board confirmed it."]),
        ("unconfirmed", []),
    ],
)
def test_hanging_session_and_the_stop_by_the_guardian_are_reported(
    result: str, expected: list[str], driven: DrivenDevice
) -> None:
    warnings: list[str] = []
    infos: list[str] = []
    driven.notifier.danger.connect(warnings.append)
    driven.notifier.info.connect(infos.append)
    hang(driven, 2.0)
    start = now()
    log_file().parent.mkdir(parents=True, exist_ok=True)
    line = f"{time.strftime('%Y-%m-%d %H:%M:%S')} {result}: in time\n"
    log_file().write_text(line, encoding="utf-8")
    driven.wait(lambda: bool(warnings))
    assert now() - start < 1.0
    assert warnings[0].startswith("Motor 1 may still be turning. Cut the power.")
    assert driven.motors.stop_reason == "The connection is not responding."
    driven.wait(lambda: not driven.may_move)
    assert infos == expected


def test_arming_on_a_noisy_line_recommends_crc(driven: DrivenDevice, qtbot: QtBot) -> None:
    driven.board.quality.is_noisy = True
    with qtbot.waitSignal(driven.notifier.remedies_offered) as offered:
        driven.motors.arming_changed.emit()
    assert offered.args == [(Remedy.SET_UP_CRC,)]


def test_short_hang_of_the_session_disarms_the_motors(driven: DrivenDevice) -> None:
    errors: list[str] = []
    driven.notifier.error.connect(errors.append)
    hang(driven, 0.55)
    driven.motors.set_speed(1, 90)
    driven.wait(lambda: not driven.motors.armed)
    driven.wait(lambda: not driven.may_move)
    assert driven.motors.stop_reason == NO_RESPONSE
    assert len(errors) == 1
    assert is_braked(driven.simulator)


def test_unconfirmed_stop_is_reported_as_unconfirmed(qtbot: QtBot) -> None:
    connection, motors, notifier = Connection(), Motors(), Notifier()
    driving = DriveController(motors, Device().board, connection, notifier)
    with qtbot.waitSignal(notifier.error) as error:
        connection.motors_stopped.emit(MotorsStopped(ErrorCode.NO_HEARTBEAT, confirmed=False))
    assert error.args == [f"{NO_RESPONSE} A stop was sent but is not confirmed yet."]
    assert motors.stop_reason == NO_RESPONSE
    assert not driving.may_move


def test_armed_motors_send_heartbeats_at_a_steady_rate(
    virtual_time: VirtualRuntime, monkeypatch: pytest.MonkeyPatch
) -> None:
    times: list[float | None] = []

    def submit(_connection: Connection, request: object) -> bool:
        if isinstance(request, Heartbeat):
            times.append(request.sent)
        return True

    monkeypatch.setattr(Connection, "submit", submit)
    connection, motors, notifier = Connection(), Motors(), Notifier()
    driving = DriveController(motors, Device().board, connection, notifier)
    assert not driving.may_move
    motors.set_available(True)
    motors.arm()
    virtual_time.advance(10.0)
    sent = [sent for sent in times if sent is not None]
    gaps = [later - earlier for earlier, later in pairwise(sent)]
    assert max(gaps) < Timeouts().heartbeat / 2, "one heartbeat may be late or lost"
    assert min(gaps) > 0.05, "heartbeats hardly load the line"
    motors.stop()
    virtual_time.advance(1.0)
    assert times == sent


def test_confirmed_stop_is_reported_once_and_without_a_warning(
    device: Device,
    quick_simulator: SimulatedDevice,
    qtbot: QtBot,
    virtual_time: VirtualRuntime,
) -> None:
    outcomes: list[StudioError | None] = []
    failures: list[str] = []
    device.notifier.error.connect(failures.append)
    device.notifier.danger.connect(failures.append)
    device.connect_to(ConnectionSettings(quick_simulator.url))
    qtbot.waitUntil(lambda: device.motors.is_available)
    device.driving.stop(outcomes.append)
    qtbot.waitUntil(lambda: outcomes == [None])
    device.driving.stop(lambda _error: None)
    virtual_time.advance(1.0)
    assert outcomes == [None]
    assert failures == []


def test_motor_driven_again_before_the_confirmation_may_move(driven: DrivenDevice) -> None:
    outcomes: list[StudioError | None] = []
    driven.driving.stop(outcomes.append)
    driven.motors.arm()
    driven.motors.set_speed(1, 40)
    driven.wait(lambda: outcomes == [None])
    assert driven.may_move


def test_stop_warns_that_the_channels_may_go_on_driving(rc_device: Device, qtbot: QtBot) -> None:
    with qtbot.waitSignal(rc_device.notifier.error) as error:
        rc_device.motors.stop()
    assert error.args == [STOP_WITHOUT_EFFECT]
