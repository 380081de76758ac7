"""Packets that keep resting motors at rest on a line that damages bytes."""

from trex_gui.devices.trex.driving.idle_refresh import IdleRefresh
from trex_gui.devices.trex.protocol.commands import Drive, DriveAuxiliary, DriveMotor
from trex_gui.devices.trex.session.messages import SetAuxiliary, SetMotor

BRAKES = [DriveMotor(1, Drive.brake()), DriveMotor(2, Drive.brake())]


def test_stop_of_auxiliary_motor_is_repeated() -> None:
    resting = IdleRefresh()
    resting.note_setpoints([SetAuxiliary(50)], 0.0)
    assert resting.take(0.1) == BRAKES, "a running motor is not at rest"
    resting.note_stop(0.2)
    assert resting.take(0.3) == [*BRAKES, DriveAuxiliary(0)]


def test_unstarted_auxiliary_motor_is_left_alone() -> None:
    resting = IdleRefresh()
    resting.note_setpoints([SetMotor(1, Drive.at(50))], 0.0)
    assert resting.take(0.1) == BRAKES[1:]
