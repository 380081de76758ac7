"""What goes to the motors over one line; the session around it has tests of its own."""

import pytest

from tests.link.helpers import moving, staged
from tests.support.virtual import Stage
from trex_gui.emulator.motors import Direction
from trex_gui.link.mailbox import Mailbox
from trex_gui.link.messages import Halted, Outcome, SetAuxiliary, SetDrive, Stop
from trex_gui.link.motors import DRIVE_INTERVAL, Motors
from trex_gui.link.repeating import REPEATS
from trex_gui.link.telemetry import StatusNews, StatusReader
from trex_gui.protocol.commands import Drive, DriveAuxiliary, DriveMotor
from trex_gui.protocol.errors import NoReply, PortUnavailable


class Bench:
    """Motors on a line to a simulated board, and what they tell."""

    def __init__(self, stage: Stage) -> None:
        self.stage = stage
        self.client = stage.client()
        self.status = StatusReader(stage.transport.clock)
        self.outcomes: list[Outcome | Halted] = []
        self.news: list[StatusNews] = []
        stage.script.at(3600.0, lambda: None)  # an empty script asks for the end
        self.mail = Mailbox(stage.script)
        self.motors = Motors(self.mail, self.outcomes.append, self.news.extend, may_move=False)

    def stop(self) -> None:
        self.mail.stops.append(Stop(1))
        self.motors.stop(self.client, self.status)

    def drive(self, speed: int) -> None:
        self.mail.drives.put(SetDrive(1, Drive.at(speed)))
        self.motors.drive(self.client)


@pytest.fixture
def bench() -> Bench:
    return Bench(staged()[0])


def test_without_a_wish_there_is_nothing_to_wait_for(bench: Bench) -> None:
    assert bench.motors.seconds_to_drive(bench.client) is None
    assert not bench.motors.may_move


def test_the_newest_wish_goes_and_the_next_waits_for_its_turn(bench: Bench) -> None:
    bench.stage.line.advance(1.0)
    bench.mail.drives.put(SetDrive(1, Drive.at(10)))
    assert (bench.motors.seconds_to_drive(bench.client) or 0) <= 0
    bench.drive(20)
    assert moving(bench.stage.transport.sent) == [DriveMotor(1, Drive.at(20))]
    assert bench.motors.may_move
    bench.mail.drives.put(SetDrive(1, Drive.at(30)))
    seconds = bench.motors.seconds_to_drive(bench.client)
    assert seconds is not None
    assert seconds >= DRIVE_INTERVAL


def let_time_pass(bench: Bench, seconds: float) -> None:
    """Drive whenever that is due, as a session does."""
    end = bench.client.transport.clock() + seconds
    while (due := bench.motors.seconds_to_drive(bench.client)) is not None:
        if bench.client.transport.clock() + due > end:
            break
        if due > 0:
            bench.client.transport.wait(max(due, 1e-5))
        else:
            bench.motors.drive(bench.client)


def test_a_wish_is_sent_again_for_a_board_that_was_deaf(bench: Bench) -> None:
    bench.stage.line.to_drop_sent = 2  # the whole packet, so the board latches nothing
    bench.drive(20)
    assert bench.stage.board.motors[0].target_speed == 0
    let_time_pass(bench, 4.0)
    assert moving(bench.stage.transport.sent) == [DriveMotor(1, Drive.at(20))] * (1 + len(REPEATS))
    assert bench.stage.board.motors[0].target_speed == 20
    assert bench.motors.seconds_to_drive(bench.client) is None


def test_a_newer_wish_takes_the_place_of_the_one_that_stands(bench: Bench) -> None:
    bench.drive(20)
    let_time_pass(bench, 0.2)
    bench.mail.drives.put(SetAuxiliary(9))
    bench.mail.drives.put(SetDrive(1, Drive.at(30)))
    let_time_pass(bench, 4.0)
    sent = moving(bench.stage.transport.sent)
    assert sent[:2] == [DriveMotor(1, Drive.at(20))] * 2
    assert sent[2:] == [DriveMotor(1, Drive.at(30)), DriveAuxiliary(9)] * (1 + len(REPEATS))


def test_after_a_stop_nothing_stands_any_more(bench: Bench) -> None:
    bench.drive(20)
    bench.stop()
    assert bench.motors.seconds_to_drive(bench.client) is None
    bench.drive(20)
    bench.motors.stop_unheard(bench.client)
    assert bench.motors.seconds_to_drive(bench.client) is None
    bench.drive(20)
    bench.motors.forget()
    assert bench.motors.seconds_to_drive(bench.client) is None


def test_a_proved_stop_is_answered_and_nothing_may_move(bench: Bench) -> None:
    bench.drive(90)
    bench.stop()
    assert bench.outcomes == [Outcome(1)]
    assert not bench.motors.may_move
    assert bench.stage.board.motors[0].direction is Direction.BRAKE


def test_a_stop_that_nobody_confirms_says_so_and_motors_may_move(bench: Bench) -> None:
    bench.drive(90)
    bench.stage.board.power_off()
    bench.stop()
    (outcome,) = bench.outcomes
    assert isinstance(outcome, Outcome)
    assert isinstance(outcome.error, NoReply)
    assert "cut its power" in str(outcome.error)
    assert bench.motors.may_move


def test_a_stop_waits_again_when_the_line_is_gone(bench: Bench) -> None:
    bench.drive(90)
    bench.stage.transport.fail = PortUnavailable("gone")
    with pytest.raises(PortUnavailable):
        bench.stop()
    assert bench.mail.stops == [Stop(1)]
    assert not bench.outcomes
    assert bench.motors.may_move


def test_a_board_that_was_never_driven_is_sent_no_stop_into_its_silence(bench: Bench) -> None:
    bench.motors.stop_unheard(bench.client)
    assert not bench.stage.transport.sent
    bench.drive(90)
    bench.motors.stop_unheard(bench.client)
    assert len(moving(bench.stage.transport.sent)) == 3
