"""Stop sequences for the guardian, and stops by the guardian."""

import pytest

from tests.devices.trex.session.helpers import (
    commands,
    create_harness,
    is_stopped,
    of_type,
    outcomes,
    read_at,
    run_for,
)
from tests.support.guardian import VirtualGuardian
from tests.support.virtual import SessionHarness
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


def test_guardian_is_ready_before_connection_is_reported(harness: SessionHarness) -> None:
    reports = run_for(harness, 0.5)
    kinds = [type(report) for report in reports]
    assert reports[kinds.index(GuardianChanged)] == GuardianChanged(is_ready=True)
    assert kinds.index(GuardianChanged) < kinds.index(Connected)


@pytest.mark.parametrize("cause", [Arm(), SETPOINT])
def test_guardian_starts_to_watch_before_a_motor_may_move(
    harness: SessionHarness, cause: Arm | SetMotor
) -> None:
    before = read_at(harness, 0.5, lambda: list(harness.transport.guardian.watched))
    harness.script.at(0.5, cause)
    after = read_at(harness, 0.6, lambda: list(harness.transport.guardian.watched))
    run_for(harness, 0.7)
    assert before == [[]]
    assert after[0]
    assert None not in after[0]


@pytest.mark.parametrize("detection", [Detection.NONE, Detection.CRC7])
@pytest.mark.parametrize("model", ["trex", "trexjr"])
def test_guardian_receives_stop_sequence_of_connection(model: str, detection: Detection) -> None:
    harness, settings = create_harness(detection=detection, model=model)
    harness.script.at(0.5, Arm())
    run_for(harness, 0.7, settings)
    sequence = harness.transport.guardian.watched[0]
    assert sequence is not None
    framing = settings.framing
    assert sequence.packets == b"".join(map(framing.encode, STOP))
    assert commands(sequence.packets, framing.polynomial) == [*STOP]
    assert sequence.queries[0] == framing.encode(GetStatus())
    assert sequence.reply_size == (2 if detection is Detection.CRC7 else 1)
    harness.line.send(sequence.packets + sequence.queries[0])
    assert len(harness.line.read(9, sequence.seconds)) == sequence.reply_size


def test_confirmed_stop_ends_the_watch(harness: SessionHarness) -> None:
    harness.script.at(0.5, SETPOINT).at(1.0, Stop(1))
    last = read_at(harness, 1.5, lambda: harness.transport.guardian.watched[-1])
    reports = run_for(harness, 2.0)
    assert outcomes(reports)[1].error is None
    assert last == [None]


def test_guardian_watches_silent_board_whose_motors_may_move(
    harness: SessionHarness,
) -> None:
    harness.script.at(0.5, SETPOINT)
    harness.script.at(1.0, harness.fault(mute=True))
    earlier = read_at(harness, 2.5, lambda: len(harness.transport.guardian.watched))
    later = read_at(harness, 3.5, lambda: len(harness.transport.guardian.watched))
    reports = run_for(harness, 4.0)
    assert of_type(reports, NotResponding)
    assert later[0] >= earlier[0] + 5


@pytest.mark.parametrize("confirms", [True, False])
def test_guardian_stops_motors_after_session_loses_its_port(
    harness: SessionHarness, confirms: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    requested: list[float] = []

    def stop(_guardian: VirtualGuardian, seconds: float) -> bool:
        requested.append(seconds)
        return confirms

    monkeypatch.setattr(VirtualGuardian, "stop", stop)
    harness.script.at(0.5, SETPOINT)
    harness.script.at(1.0, lambda: setattr(harness.transport, "fail", PortUnavailable("lost")))
    reports = run_for(harness, 2.0)
    (closed,) = of_type(reports, Closed)
    assert isinstance(closed.error, PortUnavailable)
    assert len(requested) == 1
    assert closed.may_move != confirms


def test_stop_by_guardian_is_not_reported_as_corrupted_reply(harness: SessionHarness) -> None:
    read = harness.transport.read

    def suspend_while_reading() -> None:
        def suspended_read(size: int, seconds: float) -> bytes:
            harness.transport.read = read  # type: ignore[method-assign]
            harness.transport.guardian.has_acted = True
            harness.line.read(size, seconds)  # by the guardian
            return b""

        harness.transport.read = suspended_read  # type: ignore[method-assign]

    harness.script.at(0.5, SETPOINT).at(1.0, suspend_while_reading).at(1.5, Stop(1))
    completed = read_at(harness, 1.8, lambda: set(outcomes(harness.reports)))
    reports = run_for(harness, 3.0)
    assert of_type(reports, MotorsStopped)[0].reason is ErrorCode.NO_HEARTBEAT
    assert outcomes(reports)[1].error is None
    assert completed == [{1}]


def test_motors_are_stopped_if_lost_guardian_cannot_be_replaced(
    harness: SessionHarness, monkeypatch: pytest.MonkeyPatch
) -> None:
    def lose_guardian() -> None:
        lost = harness.transport.guardian
        lost.is_ready = False
        monkeypatch.setattr(harness.transport, "start_guardian", lambda _silence: lost)

    harness.script.at(0.5, SETPOINT).at(1.0, lose_guardian)
    stopped = read_at(harness, 1.8, lambda: is_stopped(harness.board))
    (report,) = of_type(run_for(harness, 2.0), MotorsStopped)
    assert (report.reason, stopped) == (ErrorCode.NO_GUARDIAN, [True])


def test_guardian_sends_no_stop_if_no_motor_was_driven(
    harness: SessionHarness, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(VirtualGuardian, "stop", lambda *_: pytest.fail("no motor was driven"))
    harness.script.at(1.0, lambda: setattr(harness.transport, "fail", PortUnavailable("lost")))
    assert not of_type(run_for(harness, 2.0), Closed)[0].may_move


def test_guardian_receives_changed_device_number(harness: SessionHarness) -> None:
    harness.board.eeprom.write("device_number", 7)
    harness.board.power_cycle()
    harness.script.at(0.5, SETPOINT).at(0.7, Stop(1))
    harness.script.at(1.0, Write(2, (("device_number", 9),)))
    harness.script.at(2.5, Arm()).at(2.5, SETPOINT)
    run_for(harness, 3.0, ConnectionSettings("virtual", device_number=7))
    numbers = {sequence.packets[1] for sequence in filter(None, harness.transport.guardian.watched)}
    assert numbers == {7, 9}


def test_close_with_armed_motors_ends_the_watch(harness: SessionHarness) -> None:
    harness.script.at(0.4, Arm()).at(0.5, SETPOINT)
    reports = run_for(harness, 0.8)
    assert reports[-1] == Closed(None)
    assert harness.transport.guardian.watched[-1] is None
