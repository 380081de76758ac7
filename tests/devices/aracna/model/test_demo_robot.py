"""Demo Aracna: control lines and state."""

from dataclasses import replace

import pytest
from pytestqt.qtbot import QtBot

from tests.support.aracna import AracnaHarness
from tests.support.demo_panels import RecordingSimulator
from trex_gui.devices.aracna.model.demo import (
    DemoRobot,
    DemoServo,
    FirmwareState,
    RobotSnapshot,
    read_snapshot,
)
from trex_gui.devices.aracna.plugin import ARACNA
from trex_gui.devices.aracna.simulator.control import control
from trex_gui.devices.aracna.views.demo import power_text, servo_text, state_text

GOALS = b".c300,300,300,300,300,300,300,300\n"


def snapshot_of(harness: AracnaHarness) -> RobotSnapshot:
    return read_snapshot(control(harness.line, "show").removeprefix("ok "))


# --- Snapshots --------------------------------------------------------------------------


def test_new_robot_is_idle_limp_and_centred() -> None:
    snapshot = snapshot_of(AracnaHarness())
    assert snapshot.power
    assert snapshot.servo_power
    assert snapshot.state is FirmwareState.IDLE
    assert snapshot.boots == 1
    assert not snapshot.led
    assert not snapshot.is_moving
    assert snapshot.servos == (DemoServo(512, 512, 0, False, False, True, False, 0.0),) * 8
    assert snapshot.line.plugged
    assert not snapshot.line.mute


def test_faults_and_missing_power_are_read_for_each_servo() -> None:
    harness = AracnaHarness()
    harness.do("servo 1 dead", "servo 2 block", "servo 3 load 0.25", "line noise 0.5")
    snapshot = snapshot_of(harness)
    assert [servo.dead for servo in snapshot.servos] == [False, True, *[False] * 6]
    assert [servo.blocked for servo in snapshot.servos] == [False, False, True, *[False] * 5]
    assert [servo.load for servo in snapshot.servos] == [0, 0, 0, 0.25, 0, 0, 0, 0]
    assert snapshot.line.noise == 0.5
    harness.do("servo power off")
    snapshot = snapshot_of(harness)
    assert (snapshot.power, snapshot.servo_power) == (True, False)
    assert [servo.dead for servo in snapshot.servos] == [False, True, *[False] * 6]


def test_blocked_or_unpowered_servos_do_not_count_as_moving() -> None:
    harness = AracnaHarness()
    harness.line.send(GOALS)
    harness.line.advance(0.1)
    assert snapshot_of(harness).is_moving
    for motor in range(8):
        harness.do(f"servo {motor} block")
    assert not snapshot_of(harness).is_moving
    harness.do("servo 4 free")
    assert snapshot_of(harness).is_moving
    harness.do("servo power off")
    assert not snapshot_of(harness).is_moving


# --- Texts ------------------------------------------------------------------------------


def test_firmware_state_is_described_as_text() -> None:
    harness = AracnaHarness(booted=False)
    assert "Booting" in state_text(snapshot_of(harness))
    harness.line.advance(1.1)
    assert state_text(snapshot_of(harness)) == "Idle: waiting for commands."
    harness.line.send(b".v90,90,90,90,90,90,90,90\n")
    harness.line.advance(0.02)
    assert "Setting speeds" in state_text(snapshot_of(harness))
    harness.line.advance(1)
    harness.line.send(GOALS)
    harness.line.advance(0.2)
    assert "every servo has arrived" in state_text(snapshot_of(harness))
    harness.do("servo 5 block")
    harness.line.advance(2)
    assert "a servo that is blocked" in state_text(snapshot_of(harness))
    harness.do("servo power off")
    assert "servos that have no power" in state_text(snapshot_of(harness))
    harness.do("power off")
    assert "power is off" in state_text(snapshot_of(harness))


def test_servo_power_text_is_urgent_in_motion_and_when_off() -> None:
    harness = AracnaHarness()
    text, urgent = power_text(snapshot_of(harness))
    assert "switch off the servo power" in text
    assert not urgent
    harness.line.send(GOALS)
    harness.line.advance(0.1)
    assert power_text(snapshot_of(harness)) == (text, True)
    harness.do("servo power off")
    assert power_text(snapshot_of(harness)) == (
        "Servo power is off: no servo moves, holds its position or replies.",
        True,
    )
    harness.do("power off")
    assert "switch is off" in power_text(snapshot_of(harness))[0]


WHOLE = DemoServo(512, 600, 0, True, True, True, False, 0.0)


@pytest.mark.parametrize(
    ("servo", "powered", "words"),
    [
        (WHOLE, True, "512 = 150.1°, moving to 600"),
        (replace(WHOLE, moving=False), True, "512 = 150.1°, holds"),
        (replace(WHOLE, blocked=True), True, "512 = 150.1°, cannot reach 600"),
        (replace(WHOLE, load=1.0), True, "512 = 150.1°, cannot reach 600"),
        (replace(WHOLE, load=0.5), True, "512 = 150.1°, moving to 600"),
        (replace(WHOLE, dead=True), True, "512 = 150.1°, dead"),
        (replace(WHOLE, torque=False), True, "512 = 150.1°, limp until its first goal"),
        (replace(WHOLE, dead=True), False, "512 = 150.1°, no power"),
    ],
)
def test_servo_state_is_described_as_text(servo: DemoServo, powered: bool, words: str) -> None:
    assert servo_text(servo, powered) == words


# --- Control lines ----------------------------------------------------------------------


def test_each_loss_sends_its_control_line(qtbot: QtBot) -> None:
    simulator = RecordingSimulator(ARACNA)
    with qtbot.waitSignal(simulator.ready, timeout=15_000):
        simulator.start()
    robot = DemoRobot(simulator)
    robot.watch(True)
    qtbot.waitUntil(lambda: robot.snapshot is not None, timeout=15_000)
    simulator.lines.clear()
    losses = ["drop 1", "drop 1 sent", "cut 6"]
    with qtbot.assertNotEmitted(robot.rejected):
        for loss in losses:
            robot.lose(loss)
        replies: list[str] = []
        simulator.send("show", replies.append)
        qtbot.waitUntil(lambda: bool(replies), timeout=15_000)
    assert simulator.changes() == [f"line {loss}" for loss in losses]
    robot.watch(False)
    simulator.stop()
