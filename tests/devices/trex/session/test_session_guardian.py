"""Messages and stops between a session and its guardian."""

import pytest

from tests.devices.trex.session.helpers import (
    among,
    commands,
    is_stopped,
    outcomes,
    run_for,
    seen_at,
    staged,
)
from tests.support.guardian import VirtualGuardian
from tests.support.virtual import Stage
from trex_gui.core.errors import PortUnavailable
from trex_gui.core.session import Closed
from trex_gui.devices.trex.driving.requests import Arm, MotorsStopped, SetMotor, Stop
from trex_gui.devices.trex.protocol.commands import STOP, GetStatus
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.devices.trex.protocol.errors import ErrorCode
from trex_gui.devices.trex.protocol.line_settings import Detection
from trex_gui.devices.trex.session.messages import Connected, GuardianChanged, NotResponding, Write

SETPOINT = SetMotor(1, Drive.at(60))


def test_guardian_is_ready_before_the_board_counts_as_connected(stage: Stage) -> None:
    reports = run_for(stage, 0.5)
    kinds = [type(report) for report in reports]
    assert reports[kinds.index(GuardianChanged)] == GuardianChanged(is_ready=True)
    assert kinds.index(GuardianChanged) < kinds.index(Connected)


@pytest.mark.parametrize("cause", [Arm(), SETPOINT])
def test_guardian_watches_from_before_a_motor_may_move(stage: Stage, cause: Arm | SetMotor) -> None:
    before = seen_at(stage, 0.5, lambda: list(stage.transport.guardian.watched))
    stage.script.at(0.5, cause)
    after = seen_at(stage, 0.6, lambda: list(stage.transport.guardian.watched))
    run_for(stage, 0.7)
    assert before == [[]]
    assert after[0]
    assert None not in after[0]


@pytest.mark.parametrize("detection", [Detection.NONE, Detection.CRC7])
@pytest.mark.parametrize("model", ["trex", "trexjr"])
def test_guardian_knows_the_stop_in_force(model: str, detection: Detection) -> None:
    stage, settings = staged(detection=detection, model=model)
    stage.script.at(0.5, Arm())
    run_for(stage, 0.7, settings)
    sequence = stage.transport.guardian.watched[0]
    assert sequence is not None
    framing = settings.framing
    assert sequence.packets == b"".join(map(framing.encode, STOP))
    assert commands(sequence.packets, framing.polynomial) == [*STOP]
    assert sequence.queries[0] == framing.encode(GetStatus())
    assert sequence.reply_size == (2 if detection is Detection.CRC7 else 1)
    stage.line.send(sequence.packets + sequence.queries[0])
    assert len(stage.line.read(9, sequence.seconds)) == sequence.reply_size


def test_confirmed_stop_ends_the_watch(stage: Stage) -> None:
    stage.script.at(0.5, SETPOINT).at(1.0, Stop(1))
    at_rest = seen_at(stage, 1.5, lambda: stage.transport.guardian.watched[-1])
    reports = run_for(stage, 2.0)
    assert outcomes(reports)[1].error is None
    assert at_rest == [None]


def test_guardian_watches_while_the_board_is_silent_and_motors_may_move(stage: Stage) -> None:
    stage.script.at(0.5, SETPOINT)
    stage.script.at(1.0, stage.fault(mute=True))
    count = seen_at(stage, 2.5, lambda: len(stage.transport.guardian.watched))
    later = seen_at(stage, 3.5, lambda: len(stage.transport.guardian.watched))
    reports = run_for(stage, 4.0)
    assert among(reports, NotResponding)
    assert later[0] >= count[0] + 5


@pytest.mark.parametrize("confirms", [True, False])
def test_guardian_stops_motors_on_a_line_that_the_session_has_lost(
    stage: Stage, confirms: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    requested: list[float] = []

    def stop(_guardian: VirtualGuardian, seconds: float) -> bool:
        requested.append(seconds)
        return confirms

    monkeypatch.setattr(VirtualGuardian, "stop", stop)
    stage.script.at(0.5, SETPOINT)
    stage.script.at(1.0, lambda: setattr(stage.transport, "fail", PortUnavailable("gone")))
    reports = run_for(stage, 2.0)
    (closed,) = among(reports, Closed)
    assert isinstance(closed.error, PortUnavailable)
    assert len(requested) == 1
    assert closed.may_move != confirms


def test_take_over_is_not_taken_for_a_line_that_corrupts_bytes(stage: Stage) -> None:
    read = stage.transport.read

    def hang_while_reading() -> None:
        def be_held_up(size: int, seconds: float) -> bytes:
            stage.transport.read = read  # type: ignore[method-assign]
            stage.transport.guardian.has_acted = True
            stage.line.read(size, seconds)  # by the guardian
            return b""

        stage.transport.read = be_held_up  # type: ignore[method-assign]

    stage.script.at(0.5, SETPOINT).at(1.0, hang_while_reading).at(1.5, Stop(1))
    stopped = seen_at(stage, 1.8, lambda: set(outcomes(stage.reports)))
    reports = run_for(stage, 3.0)
    assert among(reports, MotorsStopped)[0].reason is ErrorCode.NO_HEARTBEAT
    assert outcomes(reports)[1].error is None
    assert stopped == [{1}]


def test_motors_are_stopped_where_nothing_replaces_a_lost_guardian(
    stage: Stage, monkeypatch: pytest.MonkeyPatch
) -> None:

    def lose_guardians() -> None:
        lost = stage.transport.guardian
        lost.is_ready = False
        monkeypatch.setattr(stage.transport, "start_guardian", lambda _silence: lost)

    stage.script.at(0.5, SETPOINT).at(1.0, lose_guardians)
    stopped = seen_at(stage, 1.8, lambda: is_stopped(stage.board))
    (report,) = among(run_for(stage, 2.0), MotorsStopped)
    assert (report.reason, stopped) == (ErrorCode.NO_GUARDIAN, [True])


def test_guardian_stops_nothing_if_no_motor_was_driven(
    stage: Stage, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(VirtualGuardian, "stop", lambda *_: pytest.fail("nothing to stop"))
    stage.script.at(1.0, lambda: setattr(stage.transport, "fail", PortUnavailable("gone")))
    assert not among(run_for(stage, 2.0), Closed)[0].may_move


def test_stop_follows_a_changed_device_number(stage: Stage) -> None:
    stage.board.eeprom.write("device_number", 7)
    stage.board.power_cycle()
    stage.script.at(0.5, SETPOINT).at(0.7, Stop(1))
    stage.script.at(1.0, Write(2, (("device_number", 9),)))
    stage.script.at(2.5, Arm()).at(2.5, SETPOINT)
    run_for(stage, 3.0, ConnectionSettings("virtual", device_number=7))
    numbers = {one.packets[1] for one in stage.transport.guardian.watched if one is not None}
    assert numbers == {7, 9}


def test_closing_while_motors_are_armed_ends_the_watch(stage: Stage) -> None:
    stage.script.at(0.4, Arm()).at(0.5, SETPOINT)
    reports = run_for(stage, 0.8)
    assert reports[-1] == Closed(None)
    assert stage.transport.guardian.watched[-1] is None, "the board was not left running"
