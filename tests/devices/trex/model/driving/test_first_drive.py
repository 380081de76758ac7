"""First drive of a board: low ceiling, and speeds that grow slowly."""

from itertools import pairwise

import pytest
from PySide6.QtWidgets import QWidget
from pytestqt.qtbot import QtBot

from tests.support.pads import PAD, HeldPads
from tests.support.simulator import StartSimulator
from tests.support.virtual_time import VirtualRuntime
from trex_gui.devices.trex.driving.requests import SetMotor, SetpointRequest, setpoints_in
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.gamepad import Gamepad
from trex_gui.devices.trex.model.momentary_drive import GROWTH, MomentaryDrive
from trex_gui.devices.trex.model.motors import FIRST_CEILING, Motors
from trex_gui.devices.trex.protocol.calibration import FULL_SCALE
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.devices.trex.views.pages.motors.options import DriveWith
from trex_gui.ui.runtime import now


class RecordedPad:
    """Drive pad with armed motors. Records its setpoints and their times."""

    def __init__(self, ceiling: int) -> None:
        self.motors = Motors()
        self.motors.set_ceiling(ceiling)
        self.drive = MomentaryDrive(self.motors, "pad")
        self.sent: list[tuple[float, dict[int, Drive]]] = []
        self.motors.requested.connect(self._on_requested)
        self.motors.set_available(True)
        self.motors.arm()

    def _on_requested(self, request: SetpointRequest) -> None:
        setpoints = [each for each in setpoints_in(request) if isinstance(each, SetMotor)]
        self.sent.append((now(), {each.motor: each.drive for each in setpoints}))

    @property
    def speeds(self) -> tuple[int, int]:
        first, second = self.motors.drive(1), self.motors.drive(2)
        assert first is not None
        assert second is not None
        return first.signed, second.signed


@pytest.fixture
def pad(qtbot: QtBot) -> RecordedPad:
    return RecordedPad(FULL_SCALE)


# --- Ceiling ----------------------------------------------------------------------------


def connect(device: Device, settings: ConnectionSettings, qtbot: QtBot) -> None:
    device.connect_to(settings)
    qtbot.waitUntil(lambda: device.is_connected and device.motors.is_available)


def test_ceiling_is_low_at_first_and_saved_for_each_board(
    device: Device, start_simulator: StartSimulator, qtbot: QtBot
) -> None:
    new, old = (
        ConnectionSettings(start_simulator("--unpaced", "--device", "9", *options).url)
        for options in ([], ["--firmware", "1.1"])
    )
    simulated = ConnectionSettings(new.url, name="Demo")
    motors, ceilings = device.motors, ((new, 90), (old, 60), (simulated, 80))
    for board, ceiling in ceilings:
        connect(device, board, qtbot)
        assert motors.ceiling == motors.ceiling_in_force == FIRST_CEILING == 38
        assert motors.is_first_drive
        motors.arm()
        motors.set_speed(1, -FULL_SCALE)
        assert motors.drive(1) == Drive.at(-FIRST_CEILING)
        motors.set_ceiling(ceiling)
        assert not motors.is_first_drive
    for board, ceiling in ceilings:
        connect(device, board, qtbot)
        assert motors.ceiling == ceiling
        assert not motors.is_first_drive


def test_ceiling_of_another_board_is_low_at_first(qtbot: QtBot) -> None:
    motors = Motors()
    motors.set_board("first")
    motors.set_ceiling(FULL_SCALE)
    motors.set_board("second")
    assert motors.ceiling_in_force == FIRST_CEILING
    motors.set_available(True)
    motors.arm()
    motors.set_speed(1, FIRST_CEILING)
    motors.set_ceiling(FULL_SCALE)
    assert motors.drive(1) == Drive.at(FIRST_CEILING), "a higher ceiling speeds up no motor"
    motors.set_board("first")
    motors.set_board("second")
    assert motors.ceiling == FULL_SCALE
    motors.adapter = "another adapter"
    motors.set_board("second")
    assert motors.ceiling == FIRST_CEILING, "equal boards on two adapters"
    restarted = Motors()
    restarted.set_board("second")
    assert restarted.ceiling == FULL_SCALE
    assert not restarted.is_first_drive


def test_keys_gamepad_and_link_are_off_for_another_board(qtbot: QtBot) -> None:
    device = Device()
    motors, gamepad = device.motors, Gamepad(device, HeldPads(PAD))
    page = QWidget()
    qtbot.addWidget(page)
    keys = DriveWith(device, page).keys

    def states() -> tuple[bool, bool, bool]:
        return keys.isChecked(), gamepad.is_on, motors.linked

    motors.set_board("demo")
    keys.setChecked(True)
    gamepad.switch_on()
    motors.set_linked(True)
    motors.set_board("demo")
    motors.set_board("demo, renumbered", is_renamed=True)
    assert states() == (True, True, True)
    motors.set_board("real")
    assert states() == (False, False, False)


@pytest.mark.parametrize("ceiling", [FIRST_CEILING, 60])
def test_new_device_number_does_not_change_the_ceiling(
    device: Device, start_simulator: StartSimulator, qtbot: QtBot, ceiling: int
) -> None:
    """Another ceiling is saved for the new number."""
    other, board = (
        ConnectionSettings(start_simulator("--unpaced", "--device", number).url)
        for number in ("9", "8")
    )
    connect(device, other, qtbot)
    motors = device.motors
    motors.set_ceiling(FULL_SCALE)
    connect(device, board, qtbot)
    if ceiling != FIRST_CEILING:
        motors.set_ceiling(ceiling)
    device.parameters.edit("device_number", 9)
    device.writer.apply()
    qtbot.waitUntil(lambda: not device.draft.pending and not device.writer.running)
    assert motors.ceiling_in_force == ceiling
    device.reload()
    connect(device, board, qtbot)
    assert motors.ceiling == motors.ceiling_in_force == ceiling
    assert motors.is_first_drive is (ceiling == FIRST_CEILING)


# --- Ramp -------------------------------------------------------------------------------


def test_speeds_grow_along_a_ramp(pad: RecordedPad, virtual_time: VirtualRuntime) -> None:
    start = now()
    pad.drive.steer(1.0, 0.0)
    virtual_time.advance(2.0)
    assert pad.speeds == (FULL_SCALE, FULL_SCALE)
    for time, drives in pad.sent:
        assert drives[1] == drives[2]
        assert drives[1].signed == pytest.approx(GROWTH * (time - start), abs=6)
    steps = [after[1].signed - before[1].signed for (_, before), (_, after) in pairwise(pad.sent)]
    assert min(steps) > 0
    assert max(steps) <= 5
    assert pad.sent[-1][0] - start == pytest.approx(1.0, abs=0.05)


def test_ramp_retains_the_curve_radius(pad: RecordedPad, virtual_time: VirtualRuntime) -> None:
    pad.drive.steer(1.0, 0.5)
    for _ in range(5):
        virtual_time.advance(0.1)
        left, right = pad.speeds
        assert right == pytest.approx(left * 42 / 127, abs=1)


def test_many_mouse_moves_do_not_shorten_the_ramp(
    pad: RecordedPad, virtual_time: VirtualRuntime
) -> None:
    for step in range(1, 101):
        pad.drive.steer(step / 100, 0.0)
        virtual_time.advance(0.001)
    assert max(pad.speeds) <= GROWTH * 0.1 + 5


def test_late_timer_does_not_make_the_speed_jump(
    pad: RecordedPad, virtual_time: VirtualRuntime
) -> None:
    pad.drive.steer(1.0, 0.0)
    virtual_time.sleep(0.5)  # the window hangs
    pad.drive.steer(1.0, 0.1)
    assert max(pad.speeds) <= 10


@pytest.mark.parametrize("seconds", [0.0, 0.3, 2.0])
def test_release_and_stop_do_not_wait_for_the_ramp(
    pad: RecordedPad, virtual_time: VirtualRuntime, seconds: float
) -> None:
    pad.drive.steer(1.0, 0.0)
    virtual_time.advance(seconds)
    pad.drive.release()
    assert pad.sent[-1] == (now(), {1: Drive.brake(), 2: Drive.brake()})

    pad.drive.steer(-1.0, 0.0)
    virtual_time.advance(seconds)
    sent, stops = len(pad.sent), []
    pad.motors.stop_requested.connect(lambda: stops.append(now()))
    pad.motors.stop()
    assert stops == [now()]
    virtual_time.advance(1.0)
    assert len(pad.sent) == sent
    pad.motors.arm()
    virtual_time.advance(1.0)
    assert len(pad.sent) == sent
    pad.drive.steer(1.0, 0.0)
    assert 0 <= pad.speeds[0] <= 5, "a new press starts at rest"
