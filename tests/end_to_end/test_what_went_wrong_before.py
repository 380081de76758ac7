"""Faults that once were, across layers: each test failed before its fault was mended."""

import logging

import pytest
from pytestqt.qtbot import QtBot

from tests.link.helpers import (
    among,
    moving,
    outcomes,
    run_for,
    samples,
)
from tests.link.test_schedule import on_line, simulate
from tests.support.simulator import SimulatedDevice, StartSimulator
from tests.support.virtual import Stage
from trex_gui.emulator.motors import Direction as EmulatedDirection
from trex_gui.link.messages import (
    Ask,
    Closed,
    Connected,
    Reload,
    Request,
    SetAuxiliary,
    SetDrive,
    Stop,
    Write,
)
from trex_gui.link.schedule import rates
from trex_gui.link.settings import LinkSettings
from trex_gui.link.telemetry import StatusNews
from trex_gui.link.writing import write_parameter
from trex_gui.model.device import Device, Link
from trex_gui.model.simulator import Simulator
from trex_gui.protocol.calibration import Calibration
from trex_gui.protocol.commands import STOP, Drive, GetMode
from trex_gui.protocol.errors import PortUnavailable
from trex_gui.protocol.flags import InputSource, Status
from trex_gui.protocol.line_settings import Detection, LineSettings
from trex_gui.protocol.parameters import parameters_of
from trex_gui.runtime import runtime

SPECS = parameters_of("trex", "1.2")


@pytest.mark.parametrize("baud", [1200, 4800, 9600])
def test_a_slow_line_is_shared_fairly(baud: int) -> None:
    wanted = rates(InputSource.RC)
    asked = simulate(wanted, on_line(baud), 100.0)
    shares = [asked[topic] / rate for topic, rate in wanted.items()]
    assert min(shares) > 0.9 * max(shares)


@pytest.mark.parametrize("wish", [SetAuxiliary(300), SetDrive(3, Drive.at(5))], ids=str)
def test_a_wish_that_no_motor_can_obey_does_not_end_the_session(
    stage: Stage, wish: Request
) -> None:
    stage.script.at(1.0, wish).at(1.2, Ask(1, GetMode()))
    reports = run_for(stage, 1.5)
    assert reports[-1] == Closed(None)


def test_a_stop_just_before_closing_is_sent(stage: Stage) -> None:
    stage.script.at(1.0, Stop(1))
    run_for(stage, 1.0)
    assert STOP[0] in moving(stage.transport.sent)


@pytest.mark.parametrize("lost", [8, 10])
def test_a_stop_that_is_lost_whole_is_not_taken_for_proved(stage: Stage, lost: int) -> None:
    def lose() -> None:
        stage.line.to_drop_sent = lost

    stage.script.at(1.0, SetDrive(1, Drive.at(100))).at(1.5, lose)
    closed = run_for(stage, 1.5)[-1]
    assert isinstance(closed, Closed)
    assert closed.may_move or stage.board.motors[0].direction is EmulatedDirection.BRAKE


@pytest.mark.parametrize(
    "request_", [Ask(1, GetMode()), Reload(1), Write(1, (("serial_timeout", 1),)), Stop(1)], ids=str
)
def test_a_mistake_of_ours_in_the_middle_of_a_request_leaves_nobody_waiting(
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
        LinkSettings("x", device_number=300),
        LinkSettings("x", LineSettings(detection=Detection.CRC7), polynomial=3),
    ],
    ids=str,
)
def test_settings_that_cannot_be_do_not_keep_the_port(stage: Stage, settings: LinkSettings) -> None:
    reports = run_for(stage, 1.0, settings)
    assert isinstance(reports[-1], Closed)
    assert stage.transport.closed or not stage.transport.sent


def test_reading_again_a_board_that_was_silent_is_its_return(stage: Stage) -> None:
    stage.script.at(1.0, stage.board.power_off).at(3.0, stage.board.power_on).at(3.0, Reload(1))
    run_for(stage, 4.0)
    assert [one.occasion for one in among(stage.reports, Connected)][1].power_cycled


def test_bits_that_were_read_just_before_the_line_was_lost_are_reported(stage: Stage) -> None:
    gone = PortUnavailable("gone")
    stage.script.at(1.0, SetDrive(1, Drive.at(1)))  # a stop is due at the end
    stage.script.at(1.2, lambda: stage.board.set_fault(1, fault=True))
    stage.script.at(1.2, lambda: stage.board.set_fault(1, fault=False))
    send = stage.transport.write

    def write(data: bytes) -> None:
        if not stage.board.serial.status and stage.line.now > 1.2:
            stage.transport.fail = gone  # right after the status was read
        send(data)

    stage.transport.write = write  # type: ignore[method-assign]  # the wire fails just then
    run_for(stage, 2.0)
    assert Status.MOTOR1_FAULT in [one.status for one in samples(stage.reports, StatusNews)]


def test_a_device_number_whose_reply_is_lost_is_followed(stage: Stage) -> None:
    client = stage.client(LinkSettings("virtual", device_number=7))
    stage.line.to_drop = 1
    assert write_parameter(client.request, SPECS["device_number"], 42) == 42


def test_apply_without_a_board_does_not_lock_apply(
    qtbot: QtBot, simulator: SimulatedDevice
) -> None:
    device = Device()
    device.connect_to(LinkSettings(simulator.url))
    qtbot.waitUntil(lambda: device.link is Link.UP)
    device.parameters.setData(device.parameters.index_of("serial_timeout"), 9)
    device.disconnect_line()
    qtbot.waitUntil(lambda: device.link is Link.NONE)
    device.apply()
    try:
        assert not device.applying
        device.connect_to(LinkSettings(simulator.url))
        qtbot.waitUntil(lambda: device.link is Link.UP)
        with qtbot.waitSignal(device.applied):
            device.apply()
    finally:
        device.shut_down()


def test_a_line_that_closes_is_not_up_again_in_between(
    qtbot: QtBot, simulator: SimulatedDevice
) -> None:
    device = Device()
    links = []
    device.link_changed.connect(lambda: links.append(device.link))
    device.connect_to(LinkSettings(simulator.url))
    while simulator.show()["counters"]["packets"] < 45:
        runtime().sleep(0.001)  # the window hangs meanwhile; `Connected` waits in its queue
    device.disconnect_line()
    qtbot.waitUntil(lambda: device.link is Link.NONE)
    device.shut_down()
    assert links == [Link.OPENING, Link.CLOSING, Link.NONE]


def test_stopping_the_simulator_is_no_failure(qtbot: QtBot) -> None:
    simulator = Simulator()
    failures: list[str] = []
    simulator.failed.connect(failures.append)
    with qtbot.waitSignal(simulator.ready):
        simulator.start()
    simulator.stop()
    assert failures == []


def test_what_is_no_number_is_refused_in_words(qtbot: QtBot) -> None:
    from trex_gui.model.parameters import ParameterModel

    model = ParameterModel()
    model.load(SPECS, {s.key: s.default for s in SPECS.readable}, {}, power_cycled=True)
    with qtbot.waitSignal(model.refused) as refused:
        model.setData(model.index_of("serial_timeout"), "abc")
    assert "Serial Timeout" in refused.args[0]


def test_calibrations_edited_for_one_kind_of_board_do_not_wait_for_another(
    qtbot: QtBot, start_simulator: StartSimulator
) -> None:
    device = Device()
    try:
        device.connect_to(LinkSettings(start_simulator().url))
        qtbot.waitUntil(lambda: device.link is Link.UP)
        device.calibrations.edit(1, Calibration(2400, 3700, 5100, 80))
        other = start_simulator("--model", "trexjr").url
        device.connect_to(LinkSettings(other))
        qtbot.waitUntil(
            lambda: (
                device.link is Link.UP
                and device.settings is not None
                and device.settings.url == other
            )
        )
        assert device.calibrations.pending == ()
    finally:
        device.shut_down()


def test_polynomials_that_cannot_be_are_forgotten_though_crc_is_off(qtbot: QtBot) -> None:
    from PySide6.QtCore import QSettings

    from trex_gui.model.connector import Connector
    from trex_gui.model.ports import Ports

    QSettings().setValue("line/polynomial", 3)
    settings = Connector(Device(), Ports()).settings
    assert settings.polynomial >= 0x80


def test_motors_refuse_an_auxiliary_speed_that_cannot_be(qtbot: QtBot) -> None:
    from trex_gui.model.driving.motors import Motors
    from trex_gui.protocol.errors import BadRequest

    motors = Motors()
    motors.allow(True)
    motors.arm()
    with pytest.raises(BadRequest):
        motors.set_auxiliary(300)
