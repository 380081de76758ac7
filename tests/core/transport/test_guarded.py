"""Heartbeats to the guardian, and writes of a session that was suspended."""

from collections.abc import Callable, Collection

import pytest

from tests.support.guardian import VirtualGuardian
from trex_gui.core.errors import NoReply, PortUnavailable
from trex_gui.core.guardian.guardian import HEARTBEAT_INTERVAL, StopSequence
from trex_gui.core.transport.guarded import GuardedTransport
from trex_gui.core.transport.settings import SerialFormat

STOP = StopSequence(b"\xc1\x00\xf0\x00", (b"\x84",), 1, 1, has_echo=False, seconds=0.1)
SETPOINT = b"\xc2\x40"
SILENCE = 0.5


class Line:
    """Line whose time passes only while the session waits."""

    latency = 0.0
    is_configurable = True

    def __init__(self) -> None:
        self.now = 0.0
        self.written: list[bytes] = []
        self.guardians: list[VirtualGuardian] = []
        self.discards = 0
        self.ended_before_close: list[bool] = []

    def clock(self) -> float:
        return self.now

    def rates(self, wanted: Collection[int]) -> frozenset[int] | None:
        return None

    def reconfigure(self, line: SerialFormat) -> None:
        pass

    def write(self, data: bytes) -> None:
        self.written.append(data)

    def read(self, size: int, seconds: float) -> bytes:
        self.now += max(0.0, seconds)
        return b""

    def discard(self) -> bytes:
        self.discards += 1
        return b""

    def wait(self, seconds: float) -> None:
        self.now += seconds

    def start_guardian(self, silence: float) -> VirtualGuardian:
        self.guardians.append(VirtualGuardian())
        return self.guardians[-1]

    def close(self) -> None:
        self.ended_before_close = [guardian.has_ended for guardian in self.guardians]


class Session:
    """Session on a guarded line. `stop`: present stop while motors may be moving."""

    def __init__(self) -> None:
        self.line = Line()
        self.stop: StopSequence | None = None
        self.stop_is_due = False
        self.taken_over: list[bool | None] = []
        self.transport = GuardedTransport(
            self.line,
            SILENCE,
            lambda: self.stop,
            taken_over=self.taken_over.append,
            stop_is_due=lambda: self.stop_is_due,
        )

    @property
    def watched(self) -> list[StopSequence | None]:
        return self.line.guardians[-1].watched


@pytest.fixture
def session() -> Session:
    return Session()


def test_no_heartbeat_is_sent_while_no_motor_may_move(session: Session) -> None:
    session.transport.write(b"\x84")
    session.transport.read(1, 3.0)
    assert session.watched == []


def test_guardian_knows_the_stop_before_the_first_setpoint_is_sent(session: Session) -> None:
    session.stop = STOP
    session.transport.write(SETPOINT)
    assert (session.watched, session.line.written) == ([STOP], [SETPOINT])


@pytest.mark.parametrize("wait", ["wait", "read"])
def test_heartbeats_continue_during_long_wait(session: Session, wait: str) -> None:
    session.stop = STOP
    if wait == "wait":
        session.transport.wait(3.0)
    else:
        session.transport.read(5, 3.0)
    assert session.line.now == pytest.approx(3.0)
    assert 3.0 / (2 * HEARTBEAT_INTERVAL) < len(session.watched) <= 31
    assert session.taken_over == []


def test_changed_stop_is_sent_at_once_and_end_of_motion_once(session: Session) -> None:
    session.stop = STOP
    session.transport.beat()
    changed = StopSequence(b"\xc1\x00\x07", (b"\x84\x01",), 2, 1, has_echo=False, seconds=0.1)
    for session.stop in (changed, None, None):
        session.transport.beat()
    assert session.watched == [STOP, changed, None]


def test_suspended_session_sends_its_stop_before_any_setpoint(session: Session) -> None:
    session.stop = STOP
    session.transport.beat()
    session.line.now += SILENCE
    with pytest.raises(NoReply):
        session.transport.write(SETPOINT)
    assert (session.taken_over, session.line.written) == ([False], [])
    assert session.line.guardians[0].has_ended
    with pytest.raises(NoReply):
        session.transport.write(SETPOINT)
    session.transport.write(STOP.packets[:2])
    session.transport.write(SETPOINT)  # the session may send anything again
    assert session.line.written == [STOP.packets[:2], SETPOINT]


@pytest.mark.parametrize("use", ["wait", "read", "discard", "reconfigure"])
def test_takeover_detected_late_also_blocks_setpoints(use: str, session: Session) -> None:
    session.stop = STOP
    session.transport.beat()
    session.line.now += SILENCE
    uses: dict[str, Callable[[], object]] = {
        "wait": lambda: session.transport.wait(0.1),
        "read": lambda: session.transport.read(1, 0.1),
        "discard": session.transport.discard,
        "reconfigure": lambda: session.transport.reconfigure(SerialFormat()),
    }
    uses[use]()
    assert session.taken_over == [False]
    session.stop = None  # as after a lock-out
    with pytest.raises(NoReply):
        session.transport.write(SETPOINT)
    assert session.line.written == []


def test_port_failure_during_takeover_counts_as_takeover(session: Session) -> None:
    """For a moment, the guardian and the session both read, and one of them gets nothing."""
    session.stop = STOP
    session.transport.beat()
    guardian = session.line.guardians[0]

    def read(size: int, seconds: float) -> bytes:
        del size, seconds
        guardian.has_acted = True
        session.line.now += 0.01
        raise PortUnavailable("gone")

    session.line.read = read  # type: ignore[method-assign]
    with pytest.raises(PortUnavailable):  # the new guardian has not acted
        session.transport.read(1, 1.0)
    assert session.taken_over == [False]


@pytest.mark.parametrize("may_move", [True, False])
def test_due_stop_shortens_wait_for_reply(session: Session, may_move: bool) -> None:
    session.stop = STOP if may_move else None
    session.stop_is_due = True
    session.transport.read(1, 60.0)
    assert session.line.now < 0.5 if may_move else session.line.now >= 60.0


def test_acting_guardian_is_replaced_before_line_is_used(session: Session) -> None:
    session.stop = STOP
    session.transport.beat()
    guardian = session.line.guardians[0]
    guardian.has_acted = guardian.confirms = True
    session.transport.read(1, 0.0)
    assert session.taken_over == [True]
    assert guardian.has_ended
    assert session.line.discards == 1, "the replies to the guardian"
    session.transport.beat()
    assert session.watched == [STOP]


@pytest.mark.parametrize("stop", [None, STOP], ids=["at rest", "moving"])
def test_lost_guardian_is_replaced_at_once_each_time(
    stop: StopSequence | None, session: Session
) -> None:
    session.transport.wait_for_guardian()
    session.line.guardians[0].is_ready = False
    session.stop = stop
    session.transport.beat()
    assert session.line.guardians[0].has_ended
    assert len(session.line.guardians) == 2
    assert session.watched[-1:] == [stop][: stop is not None]
    assert session.transport.is_guarded
    session.transport.wait(1.0)
    session.line.guardians[1].is_ready = False
    session.transport.beat()
    assert len(session.line.guardians) == 3
    assert session.taken_over == []


def test_motors_are_stopped_if_lost_guardian_is_not_replaced(
    session: Session, monkeypatch: pytest.MonkeyPatch
) -> None:
    session.transport.wait_for_guardian()
    assert session.transport.is_guarded
    session.stop = STOP
    session.transport.beat()
    session.line.guardians[0].is_ready = False
    monkeypatch.setattr(VirtualGuardian, "__init__", fail_to_start)
    session.transport.wait(0.35)
    assert session.transport.is_guarded, "a replacement is starting"
    assert session.taken_over == []
    session.transport.wait(0.15)
    assert session.taken_over == [None]
    with pytest.raises(NoReply):
        session.transport.write(SETPOINT)
    session.transport.write(STOP.packets)
    session.transport.write(SETPOINT)  # from the user
    assert (session.transport.is_guarded, len(session.line.guardians)) == (False, 2)


def fail_to_start(guardian: VirtualGuardian) -> None:
    guardian.is_ready = guardian.has_acted = False
    guardian.watched = []


@pytest.mark.parametrize("has_acted", [False, True])
def test_guardian_ends_before_the_line_is_closed_unless_it_stops_the_motors(
    session: Session, has_acted: bool
) -> None:
    session.line.guardians[0].has_acted = has_acted
    session.transport.close()
    assert session.line.ended_before_close == [not has_acted]
