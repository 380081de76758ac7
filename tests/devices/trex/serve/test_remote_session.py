"""Session of a served board in virtual time, over a network that loses messages."""

from collections import deque
from collections.abc import Callable, Iterable

import pytest

from tests.devices.trex.serve.test_server import CONNECTED
from tests.devices.trex.session.helpers import error_code
from trex_gui.core.session import Close, Outcome
from trex_gui.devices.trex.driving.requests import Arm, Heartbeat, MotorsStopped, Stop
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.errors import ErrorCode
from trex_gui.devices.trex.serve import remote_session
from trex_gui.devices.trex.serve.lease import Party, Role
from trex_gui.devices.trex.serve.remote_session import RemoteSession
from trex_gui.devices.trex.serve.server import BoardServer
from trex_gui.devices.trex.session.messages import (
    AskLease,
    Connected,
    Report,
    Request,
    SetReconnectCandidates,
    SetWatched,
    Write,
)

_REPLY_S = 0.05  # seconds until the board confirms a stop
_CLIENT = Party("1", "local", Role.OWN)

Step = tuple[float, Request | bool]  # seconds, and a request or whether the link works


class Network:
    """Server of a board, with the link and the inbox of its client.

    Attributes:
        requests: time and type of each request that the board received.
    """

    def __init__(self) -> None:
        self.requests: list[tuple[float, type]] = []
        self._now = 0.0
        self._is_cut = False
        self._server = BoardServer("arm", self._handle, self._send, self._clock)
        self._server.report(CONNECTED)
        self._outcomes: deque[tuple[float, Outcome]] = deque()
        self._script: deque[Step] = deque()
        self._receive: Callable[[bytes], None] | None = None

    def run(self, script: Iterable[Step], *, may_move: bool = False) -> list[Report]:
        """Run a session until the script closes it. Return its reports."""
        reports: list[Report] = []
        self._script.extend(script)
        settings = ConnectionSettings("trex://127.0.0.1/arm")
        RemoteSession(settings, self, reports.append, self._clock, may_move=may_move).run()
        return reports

    def connect(self, _address: object, receive: Callable[[bytes], None]) -> "Network":
        self._receive = receive
        return self

    def send(self, message: bytes, *, is_stop: bool = False) -> None:
        del is_stop
        if not self._is_cut:
            self._server.handle(_CLIENT, message)

    def close(self) -> None:
        pass

    def get(self, seconds: float) -> Request | None:
        """Let time pass. Return the next request of the script if it is due."""
        self._now += seconds
        self._server.step()
        while self._outcomes and self._outcomes[0][0] <= self._now:
            self._server.report(self._outcomes.popleft()[1])
        while self._script and self._script[0][0] <= self._now:
            _, step = self._script.popleft()
            if not isinstance(step, bool):
                return step
            self._is_cut = not step
        return None

    def _clock(self) -> float:
        return self._now

    def _send(self, _party: Party, message: bytes) -> None:
        if self._receive is not None and not self._is_cut:
            self._receive(message)

    def _handle(self, request: object) -> None:
        if isinstance(request, Stop):
            self._outcomes.append((self._now + _REPLY_S, Outcome(request.id)))
        if not isinstance(request, SetWatched | Heartbeat):
            self.requests.append((self._now, type(request)))


@pytest.fixture
def network(monkeypatch: pytest.MonkeyPatch) -> Network:
    network = Network()
    monkeypatch.setattr(remote_session, "ClientLink", network.connect)
    return network


def outcomes(reports: Iterable[Report]) -> list[int]:
    return [report.id for report in reports if isinstance(report, Outcome)]


@pytest.mark.parametrize("seconds", [0.01, 0.4])
def test_stop_that_is_lost_is_repeated(network: Network, seconds: float) -> None:
    script: list[Step] = [(1.0, False), (1.0, Stop(5)), (1.0 + seconds, True), (3.0, Close())]
    assert outcomes(network.run(script)) == [5]
    ((time, _),) = network.requests
    assert time < 1.0 + seconds + 0.3


@pytest.mark.parametrize("number", [0, 5])
def test_confirmed_stop_is_not_repeated(network: Network, number: int) -> None:
    assert outcomes(network.run([(1.0, Stop(number)), (3.0, Close())])) == [number]
    assert len(network.requests) == 1


def test_lost_outcome_is_replaced_and_reported_once(network: Network) -> None:
    script: list[Step] = [(1.0, Stop(5)), (1.01, False), (1.1, True), (3.0, Close())]
    assert outcomes(network.run(script)) == [5]
    assert len(network.requests) == 2


def test_slow_stop_has_one_outcome(network: Network, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("tests.devices.trex.serve.test_remote_session._REPLY_S", 1.0)
    assert outcomes(network.run([(1.0, Stop(5)), (3.0, Close())])) == [5]
    assert len(network.requests) == 1


def test_lost_stop_is_sent_before_arming_and_not_after(
    network: Network, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("tests.devices.trex.serve.test_remote_session._REPLY_S", 1.0)
    script: list[Step] = [
        (0.5, AskLease()),
        (1.0, False),
        (1.0, Stop(5)),
        (1.05, True),
        (1.1, Arm()),
    ]
    network.run([*script, (3.0, Close())])
    assert [kind for time, kind in network.requests if time < 3.0] == [Stop, Arm]


def test_motors_of_an_earlier_session_are_stopped_first(network: Network) -> None:
    reports = network.run([(1.0, Close())], may_move=True)
    assert [kind for _, kind in network.requests] == [Stop]
    states = [report for report in reports if isinstance(report, Connected | MotorsStopped)]
    assert [state.may_move for state in states if isinstance(state, Connected)] == [True]
    assert states[-1] == MotorsStopped(None, confirmed=True)


def test_stop_leaves_a_write_that_waits_for_the_lease(network: Network) -> None:
    write, candidates = Write(3, (("serial_timeout", 5),)), SetReconnectCandidates(())
    script: list[Step] = [(1.0, False), (1.0, candidates), (1.0, write), (1.0, Arm())]
    script += [(1.0, Stop(4)), (1.1, True), (1.5, AskLease()), (2.0, Close())]
    network.run(script)
    requests = [kind for _, kind in network.requests]
    assert requests[:3] == [Stop, SetReconnectCandidates, Write]
    assert Arm not in requests


def test_request_that_waits_for_the_lease_ends_with_the_session(network: Network) -> None:
    script: list[Step] = [(1.0, False), (1.0, Write(3, ())), (1.0, Close())]
    assert outcomes(network.run(script)) == [3]


def test_request_fails_without_an_answer_about_the_lease(network: Network) -> None:
    script: list[Step] = [(1.0, False), (1.0, Write(3, ())), (1.1, True), (6.0, AskLease())]
    network.run([*script, (7.0, Close())])
    assert Write not in [kind for _, kind in network.requests]


def test_watcher_learns_that_it_may_not_drive(
    network: Network, monkeypatch: pytest.MonkeyPatch
) -> None:
    watcher = Party("1", "local", Role.WATCH)
    monkeypatch.setattr("tests.devices.trex.serve.test_remote_session._CLIENT", watcher)
    reports = network.run([(1.0, Write(3)), (1.1, Arm()), (2.0, Close())])
    assert error_code(reports, 3) is ErrorCode.MAY_NOT_DRIVE
    assert MotorsStopped(ErrorCode.MAY_NOT_DRIVE, confirmed=True) in reports
    assert Arm not in [kind for _, kind in network.requests]
