"""What goes to the motors over one line; the session around it has tests of its own."""

import pytest

from tests.devices.trex.session.helpers import moving, staged
from tests.support.virtual import Stage
from trex_gui.core.errors import NoReply, PortUnavailable
from trex_gui.core.session.messages import Outcome
from trex_gui.devices.trex.client.telemetry import LatchedStatus, StatusReader
from trex_gui.devices.trex.driving.motors import DRIVE_INTERVAL, MotorOutput
from trex_gui.devices.trex.driving.setpoint_retry import REPEATS
from trex_gui.devices.trex.protocol.commands import Drive, DriveAuxiliary, DriveMotor
from trex_gui.devices.trex.session.messages import MotorsStopped, SetAuxiliary, SetMotor, Stop
from trex_gui.devices.trex.session.request_queues import RequestQueues
from trex_gui.devices.trex.simulator.motors import MotorDirection


class MotorsHarness:
    """`MotorOutput` connected to a simulated board, and what they report."""

    def __init__(self, stage: Stage) -> None:
        self.stage = stage
        self.client = stage.client()
        self.status = StatusReader(stage.transport.clock)
        self.outcomes: list[Outcome | MotorsStopped] = []
        self.news: list[LatchedStatus] = []
        stage.script.at(3600.0, lambda: None)  # an empty script asks for the end
        self.mail = RequestQueues(stage.script)
        self.motors = MotorOutput(self.mail, self.outcomes.append, self.news.extend, may_move=False)

    def stop(self) -> None:
        self.mail.stops.append(Stop(1))
        self.motors.stop(self.client, self.status)

    def drive(self, speed: int) -> None:
        self.mail.drives.put(SetMotor(1, Drive.at(speed)))
        self.motors.drive(self.client)

    def advance(self, seconds: float) -> None:
        """Let time pass and send whenever that is due, as a session does."""
        end = self.client.transport.clock() + seconds
        while (due := self.motors.seconds_to_drive(self.client)) is not None:
            if self.client.transport.clock() + due > end:
                break
            if due > 0:
                self.client.transport.wait(max(due, 1e-5))
            else:
                self.motors.drive(self.client)


@pytest.fixture
def harness() -> MotorsHarness:
    return MotorsHarness(staged()[0])


def test_seconds_to_drive_is_none_without_setpoint(harness: MotorsHarness) -> None:
    assert harness.motors.seconds_to_drive(harness.client) is None
    assert not harness.motors.may_move


def test_newest_setpoint_is_sent_and_next_one_waits(harness: MotorsHarness) -> None:
    harness.stage.line.advance(1.0)
    harness.mail.drives.put(SetMotor(1, Drive.at(10)))
    assert (harness.motors.seconds_to_drive(harness.client) or 0) <= 0
    harness.drive(20)
    assert moving(harness.stage.transport.sent) == [DriveMotor(1, Drive.at(20))]
    assert harness.motors.may_move
    harness.mail.drives.put(SetMotor(1, Drive.at(30)))
    seconds = harness.motors.seconds_to_drive(harness.client)
    assert seconds is not None
    assert seconds >= DRIVE_INTERVAL


def test_lost_setpoint_is_resent(harness: MotorsHarness) -> None:
    harness.stage.line.to_drop_sent = 2  # the whole packet, so the board latches nothing
    harness.drive(20)
    assert harness.stage.board.motors[0].target_speed == 0
    harness.advance(4.0)
    sent = moving(harness.stage.transport.sent)
    assert sent == [DriveMotor(1, Drive.at(20))] * (1 + len(REPEATS))
    assert harness.stage.board.motors[0].target_speed == 20
    assert harness.motors.seconds_to_drive(harness.client) is None


def test_newer_setpoint_replaces_unconfirmed_one(harness: MotorsHarness) -> None:
    harness.drive(20)
    harness.advance(0.2)
    harness.mail.drives.put(SetAuxiliary(9))
    harness.mail.drives.put(SetMotor(1, Drive.at(30)))
    harness.advance(4.0)
    sent = moving(harness.stage.transport.sent)
    assert sent[:2] == [DriveMotor(1, Drive.at(20))] * 2
    assert sent[2:] == [DriveMotor(1, Drive.at(30)), DriveAuxiliary(9)] * (1 + len(REPEATS))


def test_no_setpoint_is_pending_after_stop(harness: MotorsHarness) -> None:
    harness.drive(20)
    harness.stop()
    assert harness.motors.seconds_to_drive(harness.client) is None
    harness.drive(20)
    harness.motors.stop_without_reply(harness.client)
    assert harness.motors.seconds_to_drive(harness.client) is None
    harness.drive(20)
    harness.motors.forget()
    assert harness.motors.seconds_to_drive(harness.client) is None


def test_confirmed_stop_is_reported_and_clears_may_move(harness: MotorsHarness) -> None:
    harness.drive(90)
    harness.stop()
    assert harness.outcomes == [Outcome(1)]
    assert not harness.motors.may_move
    assert harness.stage.board.motors[0].direction is MotorDirection.BRAKE


def test_unconfirmed_stop_is_reported_and_keeps_may_move(harness: MotorsHarness) -> None:
    harness.drive(90)
    harness.stage.board.power_off()
    harness.stop()
    (outcome,) = harness.outcomes
    assert isinstance(outcome, Outcome)
    assert isinstance(outcome.error, NoReply)
    assert "cut its power" in str(outcome.error)
    assert harness.motors.may_move


def test_stop_is_queued_again_when_port_is_lost(harness: MotorsHarness) -> None:
    harness.drive(90)
    harness.stage.transport.fail = PortUnavailable("gone")
    with pytest.raises(PortUnavailable):
        harness.stop()
    assert harness.mail.stops == [Stop(1)]
    assert not harness.outcomes
    assert harness.motors.may_move


def test_unresponsive_board_is_sent_stop_only_if_driven(harness: MotorsHarness) -> None:
    harness.motors.stop_without_reply(harness.client)
    assert not harness.stage.transport.sent
    harness.drive(90)
    harness.motors.stop_without_reply(harness.client)
    assert len(moving(harness.stage.transport.sent)) == 3
