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
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.runtime import now


class Pad:
    """Control on armed motors that records its speeds and their times."""

    def __init__(self, ceiling: int) -> None:
        self.motors = Motors()
        self.motors.set_ceiling(ceiling)
        self.drive = MomentaryDrive(self.motors, "pad")
        self.sent: list[tuple[float, dict[int, Drive]]] = []
        self.motors.requested.connect(self._on_requested)
        self.motors.set_available(True)
        self.motors.arm()

    def _on_requested(self, request: SetpointRequest) -> None:
        drives = {
            one.motor: one.drive for one in setpoints_in(request) if isinstance(one, SetMotor)
        }
        self.sent.append((now(), drives))

    @property
    def speeds(self) -> tuple[int, int]:
        first, second = self.motors.drive(1), self.motors.drive(2)
        assert first is not None
        assert second is not None
        return first.signed, second.signed


@pytest.fixture
def pad(qtbot: QtBot) -> Pad:
    return Pad(FULL_SCALE)


# --- The ceiling ------------------------------------------------------------------------


def connect(device: Device, settings: ConnectionSettings, qtbot: QtBot) -> None:
    device.connect_to(settings)
    qtbot.waitUntil(lambda: device.link is ConnectionState.CONNECTED and device.motors.is_available)


def test_ceiling_is_low_at_first_and_saved_for_each_board(
    device: Device, start_simulator: StartSimulator, qtbot: QtBot
) -> None:
    boards = [
        ConnectionSettings(start_simulator("--unpaced", *options).url)
        for options in (["--device", "9"], ["--device", "9", "--firmware", "1.1"])
    ]
    one, other = boards
    simulated = ConnectionSettings(one.url, name="Demo")
    motors = device.motors
    for each in (one, other, simulated):
        connect(device, each, qtbot)
        assert motors.ceiling == motors.ceiling_in_force == FIRST_CEILING == 38
        assert motors.is_first_drive
        motors.arm()
        motors.set_speed(1, -FULL_SCALE)
        assert motors.drive(1) == Drive.at(-FIRST_CEILING)
        motors.set_ceiling(90)
        assert not motors.is_first_drive

    connect(device, other, qtbot)
    motors.set_ceiling(60)
    qtbot.waitUntil(device.shut_down)
    restarted = Device()
    for each, chosen in ((one, 90), (other, 60), (simulated, 90)):
        connect(restarted, each, qtbot)
        assert restarted.motors.ceiling == chosen
        assert not restarted.motors.is_first_drive
    qtbot.waitUntil(restarted.shut_down)


def test_ceiling_falls_back_when_another_board_takes_over(qtbot: QtBot) -> None:
    motors = Motors()
    motors.set_board("one")
    motors.set_ceiling(FULL_SCALE)
    motors.set_board("another")
    assert motors.ceiling_in_force == FIRST_CEILING
    motors.set_available(True)
    motors.arm()
    motors.set_speed(1, FIRST_CEILING)
    motors.set_ceiling(FULL_SCALE)
    assert motors.drive(1) == Drive.at(FIRST_CEILING), "a raised ceiling speeds up no motor"
    motors.set_board("one")
    motors.set_board("another")
    assert motors.ceiling == FULL_SCALE


def test_inputs_that_drive_are_switched_off_for_another_board(qtbot: QtBot) -> None:
    device = Device()
    motors, gamepad = device.motors, Gamepad(device, HeldPads(PAD))
    page = QWidget()
    qtbot.addWidget(page)
    keys = DriveWith(device, page).keys

    def states() -> tuple[bool, bool, bool]:
        return keys.isChecked(), gamepad.on, motors.linked

    motors.set_board("demo")
    keys.setChecked(True)
    gamepad.switch_on()
    motors.set_linked(True)
    motors.set_board("demo")
    motors.set_board("demo, renumbered", is_renamed=True)
    assert states() == (True, True, True)
    motors.set_board("real")
    assert states() == (False, False, False)


def test_equal_boards_on_two_adapters_have_own_ceilings(qtbot: QtBot) -> None:
    motors = Motors()
    for adapter, expected in (("one", FIRST_CEILING), ("two", FIRST_CEILING), ("one", 90)):
        motors.adapter = adapter
        motors.set_board("trex-1.2-7")
        assert motors.ceiling == expected
        motors.set_ceiling(90)


@pytest.mark.parametrize("chosen", [FIRST_CEILING, 60])
def test_new_device_number_changes_no_ceiling(
    device: Device, start_simulator: StartSimulator, qtbot: QtBot, chosen: int
) -> None:
    """A ceiling may be saved for the new number."""
    fast, slow = (
        ConnectionSettings(start_simulator("--unpaced", "--device", number).url)
        for number in ("9", "8")
    )
    connect(device, fast, qtbot)
    motors = device.motors
    motors.set_ceiling(FULL_SCALE)
    connect(device, slow, qtbot)
    if chosen != FIRST_CEILING:
        motors.set_ceiling(chosen)
    device.parameters.edit("device_number", 9)
    device.writer.apply()
    qtbot.waitUntil(lambda: not device.draft.pending and not device.writer.running)
    assert motors.ceiling_in_force == chosen
    device.reload()
    connect(device, slow, qtbot)
    assert motors.ceiling == motors.ceiling_in_force == chosen
    assert motors.is_first_drive is (chosen == FIRST_CEILING)


# --- Growing ----------------------------------------------------------------------------


def test_speeds_grow_along_a_ramp(pad: Pad, virtual_time: VirtualRuntime) -> None:
    began = now()
    pad.drive.steer(1.0, 0.0)
    virtual_time.advance(2.0)
    assert pad.speeds == (FULL_SCALE, FULL_SCALE)
    for moment, drives in pad.sent:
        assert drives[1] == drives[2], "straight on"
        assert drives[1].signed == pytest.approx(GROWTH * (moment - began), abs=6)
    steps = [after[1].signed - before[1].signed for (_, before), (_, after) in pairwise(pad.sent)]
    assert min(steps) > 0
    assert max(steps) <= 5
    assert pad.sent[-1][0] - began == pytest.approx(1.0, abs=0.05)


def test_ramp_keeps_the_curve(pad: Pad, virtual_time: VirtualRuntime) -> None:
    pad.drive.steer(1.0, 0.5)
    for _ in range(5):
        virtual_time.advance(0.1)
        left, right = pad.speeds
        assert right == pytest.approx(left * 42 / 127, abs=1)


def test_hand_that_moves_fast_speeds_up_no_faster(pad: Pad, virtual_time: VirtualRuntime) -> None:
    for step in range(1, 101):  # steps of a mouse
        pad.drive.steer(step / 100, 0.0)
        virtual_time.advance(0.001)
    assert max(pad.speeds) <= GROWTH * 0.1 + 5


def test_late_timer_makes_no_jump(pad: Pad, virtual_time: VirtualRuntime) -> None:
    pad.drive.steer(1.0, 0.0)
    virtual_time.sleep(0.5)  # the window hangs
    pad.drive.steer(1.0, 0.1)
    assert max(pad.speeds) <= 10


@pytest.mark.parametrize("seconds", [0.0, 0.3, 2.0])
def test_release_and_stop_do_not_wait_for_the_ramp(
    pad: Pad, virtual_time: VirtualRuntime, seconds: float
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
    assert len(pad.sent) == sent, "nothing grows after a stop"
    pad.motors.arm()
    virtual_time.advance(1.0)
    assert len(pad.sent) == sent, "nor after arming again"
    pad.drive.steer(1.0, 0.0)
    assert 0 <= pad.speeds[0] <= 5, "a new press begins at rest"


def test_ceiling_that_changes_while_speeds_grow(qtbot: QtBot, virtual_time: VirtualRuntime) -> None:
    pad = Pad(FIRST_CEILING)
    pad.drive.steer(1.0, 0.0)
    virtual_time.advance(0.1)
    pad.motors.set_ceiling(FULL_SCALE)
    virtual_time.advance(2.0)
    assert pad.speeds == (FIRST_CEILING, FIRST_CEILING), "raised: it counts from the next press"
    pad.drive.release()
    pad.drive.steer(1.0, 0.0)
    virtual_time.advance(0.5)
    pad.motors.set_ceiling(20)
    assert pad.speeds == (20, 20), "lowered: at once"
    virtual_time.advance(2.0)
    assert pad.speeds == (20, 20)
