"""A board that was without power while somebody drove: it stands until it is armed anew."""

from tests.devices.trex.session.helpers import among, is_stopped, moving, run_for, seen_at, staged
from trex_gui.devices.trex.driving.requests import Arm, SetMotor
from trex_gui.devices.trex.protocol.commands import DriveMotor
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.devices.trex.session.messages import Connected, ReadReason


def test_mode_change_stops_motors_and_drops_setpoints() -> None:
    stage, _ = staged()

    def restart() -> None:
        stage.board.eeprom.write("channel_input_source", 1)
        stage.board.power_cycle()

    stage.script.at(1.0, Arm())
    for step in range(60):
        if step == 10:
            stage.script.at(1.5, restart)
        stage.script.at(1.0 + step / 20, SetMotor(1, Drive.at(60 + step % 40)))
    stopped = seen_at(stage, 4.5, lambda: is_stopped(stage.board))
    reports = among(run_for(stage, 5.0), Connected)
    assert [(one.occasion, one.may_move) for one in reports][-1] == (ReadReason.RESTARTED, False)
    assert stopped == [True]


def test_confirmed_setpoint_is_not_resent() -> None:
    stage, _ = staged()
    stage.script.at(1.0, SetMotor(1, Drive.at(50))).at(2.0, SetMotor(1, Drive.brake(127)))
    run_for(stage, 4.0)
    sent = moving(stage.transport.sent)
    assert sent.count(DriveMotor(1, Drive.at(50))) == 1, "it would go round the current limiter"
    assert sent.count(DriveMotor(1, Drive.brake(127))) == 2
