"""Packets that keep idle motors at rest on a line that damages bytes."""

from trex_gui.devices.trex.driving.requests import SetAuxiliary, SetMotor
from trex_gui.devices.trex.driving.setpoints import LineQuality, SetpointRefresh
from trex_gui.devices.trex.protocol.commands import DriveAuxiliary, DriveMotor
from trex_gui.devices.trex.protocol.driving import Drive

BRAKES = [DriveMotor(1, Drive.brake()), DriveMotor(2, Drive.brake())]


def test_stop_of_auxiliary_motor_is_repeated() -> None:
    idle = SetpointRefresh(LineQuality(), lambda: False)
    idle.note_setpoints([SetAuxiliary(50)], 0.0)
    assert idle.take_idle() == BRAKES, "a running motor is not at rest"
    idle.note_stop(0.2)
    assert idle.take_idle() == [*BRAKES, DriveAuxiliary(0)]


def test_unstarted_auxiliary_motor_is_left_alone() -> None:
    idle = SetpointRefresh(LineQuality(), lambda: False)
    idle.note_setpoints([SetMotor(1, Drive.at(50))], 0.0)
    assert idle.take_idle() == BRAKES[1:]
