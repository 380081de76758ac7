"""Regressions across layers: each test failed before its fault was fixed."""

import logging

import pytest
from PySide6.QtCore import QSettings
from pytestqt.qtbot import QtBot

from tests.devices.trex.session.helpers import among, moving, outcomes, run_for, samples
from tests.devices.trex.session.test_schedule import on_line, simulate
from tests.support.program import new_controller
from tests.support.simulator import SimulatedDevice, StartSimulator
from tests.support.virtual import Stage
from trex_gui.core.errors import BadRequest, PortUnavailable
from trex_gui.core.session import Closed
from trex_gui.devices.trex.client.telemetry import LatchedStatus
from trex_gui.devices.trex.client.write_once import write_parameter
from trex_gui.devices.trex.driving.requests import SetAuxiliary, SetMotor, Stop
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.motors import Motors
from trex_gui.devices.trex.model.parameters.parameters import ParameterModel
from trex_gui.devices.trex.plugin import TREX
from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.devices.trex.protocol.commands import STOP, GetMode
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.devices.trex.protocol.flags import InputSource, Status
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings
from trex_gui.devices.trex.protocol.parameters import parameters_of
from trex_gui.devices.trex.session.messages import Connected, Reload, Request, RunCommand, Write
from trex_gui.devices.trex.session.polling import rates
from trex_gui.devices.trex.simulator.motors import MotorDirection as EmulatedDirection
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.devices.simulator import Simulator
from trex_gui.ui.runtime import runtime

SPECS = parameters_of("trex", "1.2")


@pytest.mark.parametrize("baud", [1200, 4800, 9600])
def test_slow_line_is_shared_fairly(baud: int) -> None:
    wanted = rates(InputSource.RC)
    requested = simulate(wanted, on_line(baud), 100.0)
    shares = [requested[topic] / rate for topic, rate in wanted.items()]
    assert min(shares) > 0.9 * max(shares)


@pytest.mark.parametrize("setpoint", [SetAuxiliary(300), SetMotor(3, Drive.at(5))], ids=str)
def test_invalid_setpoint_does_not_end_session(stage: Stage, setpoint: Request) -> None:
    stage.script.at(1.0, setpoint).at(1.2, RunCommand(1, GetMode()))
    reports = run_for(stage, 1.5)
    assert reports[-1] == Closed(None)


def test_stop_just_before_closing_is_sent(stage: Stage) -> None:
    stage.script.at(1.0, Stop(1))
    run_for(stage, 1.0)
    assert STOP[0] in moving(stage.transport.sent)


@pytest.mark.parametrize("lost", [8, 10])
def test_lost_stop_is_not_taken_as_confirmed(stage: Stage, lost: int) -> None:
    def lose() -> None:
        stage.line.faults.to_drop_sent = lost

    stage.script.at(1.0, SetMotor(1, Drive.at(100))).at(1.5, lose)
    closed = run_for(stage, 1.5)[-1]
    assert isinstance(closed, Closed)
    assert closed.may_move or stage.board.motors[0].direction is EmulatedDirection.BRAKE


@pytest.mark.parametrize(
    "request_",
    [RunCommand(1, GetMode()), Reload(1), Write(1, (("serial_timeout", 1),)), Stop(1)],
    ids=str,
)
def test_internal_error_completes_the_current_request(
    stage: Stage, request_: Request, caplog: pytest.LogCaptureFixture
) -> None:
    def break_() -> None:
        stage.transport.fail = RuntimeError("a bug")

    stage.script.at(1.0, break_).at(1.0, request_)
    with caplog.at_level(logging.CRITICAL):
        reports = run_for(stage, 2.0)
    assert set(outcomes(reports)) == {1}
    assert isinstance(reports[-1], Closed)


@pytest.mark.parametrize(
    "settings",
    [
        ConnectionSettings("x", device_number=300),
        ConnectionSettings("x", LineSettings(detection=Detection.CRC7), polynomial=3),
    ],
    ids=str,
)
def test_invalid_settings_release_the_port(stage: Stage, settings: ConnectionSettings) -> None:
    reports = run_for(stage, 1.0, settings)
    assert isinstance(reports[-1], Closed)
    assert stage.transport.closed or not stage.transport.sent


def test_reload_after_power_loss_counts_as_power_cycle(stage: Stage) -> None:
    stage.script.at(1.0, stage.board.power_off).at(3.0, stage.board.power_on).at(3.0, Reload(1))
    run_for(stage, 4.0)
    assert [one.occasion for one in among(stage.reports, Connected)][1].power_cycled


def test_status_read_before_line_loss_is_reported(stage: Stage) -> None:
    gone = PortUnavailable("gone")
    stage.script.at(1.0, SetMotor(1, Drive.at(1)))  # a stop is due at the end
    stage.script.at(1.2, lambda: stage.board.set_fault(1, fault=True))
    stage.script.at(1.2, lambda: stage.board.set_fault(1, fault=False))
    send = stage.transport.write

    def write(data: bytes) -> None:
        if not stage.board.serial.status and stage.line.now > 1.2:
            stage.transport.fail = gone  # right after the status was read
        send(data)

    stage.transport.write = write  # type: ignore[method-assign]  # the wire fails just then
    run_for(stage, 2.0)
    assert Status.MOTOR1_FAULT in [one.status for one in samples(stage.reports, LatchedStatus)]


def test_new_device_number_is_used_despite_lost_reply(stage: Stage) -> None:
    client = stage.client(ConnectionSettings("virtual", device_number=7))
    stage.line.faults.to_drop = 1
    assert write_parameter(client.request, SPECS["device_number"], 42) == 42


def test_apply_without_a_board_does_not_lock_apply(
    qtbot: QtBot, simulator: SimulatedDevice
) -> None:
    device = Device()
    device.connect_to(ConnectionSettings(simulator.url))
    qtbot.waitUntil(lambda: device.link is ConnectionState.CONNECTED)
    device.parameters.setData(device.parameters.index_of("serial_timeout"), 9)
    device.disconnect_line()
    qtbot.waitUntil(lambda: device.link is ConnectionState.DISCONNECTED)
    device.writer.apply()
    try:
        assert not device.writer.running
        device.connect_to(ConnectionSettings(simulator.url))
        qtbot.waitUntil(lambda: device.link is ConnectionState.CONNECTED)
        with qtbot.waitSignal(device.applied):
            device.writer.apply()
    finally:
        device.shut_down()


def test_closing_connection_is_never_reported_connected(
    qtbot: QtBot, simulator: SimulatedDevice
) -> None:
    device = Device()
    links = []
    device.link_changed.connect(lambda: links.append(device.link))
    device.connect_to(ConnectionSettings(simulator.url))
    while simulator.show()["counters"]["packets"] < 45:
        runtime().sleep(0.001)  # the window hangs meanwhile; `Connected` waits in its queue
    device.disconnect_line()
    qtbot.waitUntil(lambda: device.link is ConnectionState.DISCONNECTED)
    device.shut_down()
    assert links == [
        ConnectionState.CONNECTING,
        ConnectionState.DISCONNECTING,
        ConnectionState.DISCONNECTED,
    ]


def test_stopping_simulator_reports_no_failure(qtbot: QtBot) -> None:
    simulator = Simulator(TREX)
    failures: list[str] = []
    simulator.failed.connect(failures.append)
    with qtbot.waitSignal(simulator.ready):
        simulator.start()
    simulator.stop()
    assert failures == []


def test_non_numeric_text_is_rejected_with_a_message(qtbot: QtBot) -> None:
    model = ParameterModel()
    model.load(SPECS, {s.key: s.default for s in SPECS.readable}, {}, power_cycled=True)
    with qtbot.waitSignal(model.rejected) as refused:
        model.setData(model.index_of("serial_timeout"), "abc")
    assert "Serial Timeout" in refused.args[0]


def test_calibration_edits_do_not_carry_over_to_other_model(
    qtbot: QtBot, start_simulator: StartSimulator
) -> None:
    device = Device()
    try:
        device.connect_to(ConnectionSettings(start_simulator().url))
        qtbot.waitUntil(lambda: device.link is ConnectionState.CONNECTED)
        device.calibrations.edit(1, Calibration(2400, 3700, 5100, 80))
        other = start_simulator("--model", "trexjr").url
        device.connect_to(ConnectionSettings(other))
        qtbot.waitUntil(
            lambda: (
                device.link is ConnectionState.CONNECTED
                and device.settings is not None
                and device.settings.url == other
            )
        )
        assert device.calibrations.pending == ()
    finally:
        device.shut_down()


def test_invalid_stored_polynomial_is_dropped_without_crc(qtbot: QtBot) -> None:
    QSettings().setValue("line/polynomial", 3)
    settings = new_controller(Device()).settings
    assert settings.polynomial >= 0x80


def test_motors_reject_invalid_auxiliary_speed(qtbot: QtBot) -> None:
    motors = Motors()
    motors.set_available(True)
    motors.arm()
    with pytest.raises(BadRequest):
        motors.set_auxiliary(300)
