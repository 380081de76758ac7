"""Network server of a board. The Zenoh engine handles the network in its own threads."""

import json
import logging
import queue
import tempfile
import threading
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import zenoh

from trex_gui.core.host import Host
from trex_gui.core.session import Close, Closed, Outcome, RequestQueue
from trex_gui.core.transport.traffic import TrafficDirection, TrafficEvent, logged
from trex_gui.core.transport.urls import LOCAL_USER
from trex_gui.devices.trex.board.keeper import Keeper
from trex_gui.devices.trex.board.mirror import BoardMirror
from trex_gui.devices.trex.client.telemetry import Sample
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.errors import ErrorCode, TrexNoReplyError
from trex_gui.devices.trex.recording import MeasurementTable
from trex_gui.devices.trex.serve.lease import Party, Role, User
from trex_gui.devices.trex.serve.network import declare_publisher, key, open_server
from trex_gui.devices.trex.serve.server import BoardServer
from trex_gui.devices.trex.session.messages import (
    Batch,
    Connected,
    OfBoard,
    Report,
    SetReconnectCandidates,
    SetWatched,
    Traffic,
    Written,
)
from trex_gui.devices.trex.session.session import TrexSession
from trex_gui.devices.trex.settings.board_records import utc_now

log = logging.getLogger(__name__)

_RETRY_S = 1.0  # seconds between two attempts to open the line
_OUTBOX_TIMEOUT = 0.5  # seconds to send the last messages to a client
_CLIENT_LIMIT = 16  # maximum number of clients of a user
_EVENT_LIMIT = 1000  # maximum number of events in a batch
_MESSAGE_LIMIT = 300  # maximum number of messages in a queue, which span about five seconds


class _Outbox:
    """Queue of messages to a client. Only the thread of the queue waits for the client."""

    def __init__(self, session: zenoh.Session, name: str, on_full: Callable[[], None]) -> None:
        self._messages = queue.Queue[bytes | None](_MESSAGE_LIMIT)
        self._on_full = on_full
        self._is_full = False  # True after the queue was full for the first time
        self._publisher = declare_publisher(session, name)
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()

    def close(self, seconds: float) -> None:
        self.put(None)
        self._thread.join(seconds)

    def put(self, message: bytes | None) -> None:
        try:
            self._messages.put_nowait(message)
        except queue.Full:
            if not self._is_full:
                self._is_full = True
                self._on_full()

    def _run(self) -> None:
        while (message := self._messages.get()) is not None and not self._is_full:
            try:
                self._publisher.put(message)
            except Exception:  # the client was lost
                log.info("a message could not be sent", exc_info=True)
        self._publisher.undeclare()  # type: ignore[no-untyped-call]


class ServedBoard:
    """Network server of a board.

    Args:
        settings: connection settings of the board.
        name: name of the served board.
        listen: endpoints of the engine, such as `tcp/0.0.0.0:7477`.
        users: users who may connect. If empty, every program that reaches the endpoint is an owner.
        computer: provides ports, threads and clock.
        notify: receives messages for the operator of the server.
        tls: certificate and key files.
    """

    def __init__(
        self,
        settings: ConnectionSettings,
        name: str,
        *,
        listen: Sequence[str],
        users: Sequence[User],
        computer: Host,
        notify: Callable[[str], None],
        tls: tuple[Path, Path] | None = None,
    ) -> None:
        self._settings, self.name = settings, name
        self._computer, self._notify = computer, notify
        self._roles = {user.name: user.role for user in users} or {LOCAL_USER: Role.OWN}
        self._inbox = RequestQueue(computer.condition())
        self.server = BoardServer(name, self._put, self._send, computer.clock)
        self._board = BoardMirror(Keeper(log.info, log.warning).memory)
        self._others: dict[int, BoardMirror] = {}  # other boards of the group, by number
        self._traffic: list[TrafficEvent] = []  # events since the last batch
        self._records_traffic = False
        self._present: set[Party] = set()  # connected clients
        self._outboxes: dict[Party, _Outbox] = {}
        self._is_ending = False
        self._is_open = False  # True while a session serves the line
        self._last = Closed(None)  # last report of the last session
        self._closed = threading.Event()
        with tempfile.TemporaryDirectory(prefix="trex-serve-") as folder:
            self._network = open_server(name, listen, users, Path(folder), tls=tls)
        self._measurements = self._network.declare_publisher(key(name, "data", "measurements"))
        self._table: MeasurementTable | None = None
        self._is_subscribed = False  # True if a program subscribes to the measurements
        listener = self._measurements.declare_matching_listener(self._on_matching)
        self._references: list[object] = [
            listener,
            self._network.declare_queryable(key(name, "info"), self._on_query),
        ]
        # Each user has separate expressions, because the engine announces to a client only the
        # expressions that its user may access.
        for user in self._roles:
            self._references += [
                self._network.declare_subscriber(key(name, "from", user, "*"), self._on_request),
                self._network.liveliness().declare_subscriber(
                    key(name, "client", user, "*"), self._on_client, history=True
                ),
                self._network.declare_queryable(key(name, "stop", user), self._on_stop),
            ]

    def run(self, is_ended: Callable[[], object]) -> Closed:
        """Serve until `is_ended` returns true, then stop the motors and close the line.

        The server reopens a lost line. Returns the last report of the session.
        """
        last_error = ""
        while not is_ended():
            self._closed.clear()
            open_transport = logged(
                self._record_traffic, self._computer.open_transport, self._computer.clock
            )
            session = TrexSession(
                self._settings,
                self._inbox,
                self._report,
                open_transport,
                may_move=self._last.may_move,
            )
            self._is_open = True
            join = self._computer.start_thread(session.run)
            while not self._closed.is_set():
                self._closed.wait(self._step())
                if is_ended() and not self._is_ending:
                    self._is_ending = True
                    self._inbox.put(Close())
            join()
            self._is_open = False
            self._inbox = RequestQueue(self._computer.condition())  # drops late setpoints
            last = self._last
            self.server.end(last.error, may_move=last.may_move)
            error = "" if last.error is None else str(last.error)
            if error and error != last_error:
                self._notify(error)
            last_error = error
            self._wait(is_ended)
        for outbox in list(self._outboxes.values()):
            outbox.close(_OUTBOX_TIMEOUT)
        self._network.close()  # type: ignore[no-untyped-call]
        return self._last

    def _wait(self, is_ended: Callable[[], object]) -> None:
        deadline = self._computer.clock() + _RETRY_S
        while not is_ended() and self._computer.clock() < deadline:
            self._closed.clear()
            self._closed.wait(self._step())

    def _step(self) -> float:
        """Apply the timeouts and end unused outboxes. Return the seconds until the next step."""
        seconds = self.server.step()
        outboxes, clients = list(self._outboxes), self.server.parties  # in this order
        for party in outboxes:
            if party not in clients:
                self._outboxes.pop(party).put(None)
        return seconds

    # --- The session --------------------------------------------------------------------

    def _put(self, request: object) -> None:
        inbox = self._inbox  # before the check, so that a closed session's requests are dropped
        if not self._is_open and not isinstance(request, SetWatched):
            return
        if isinstance(request, SetReconnectCandidates):  # clients use another URL for the line
            url, name = self._settings.url, self._settings.name
            local = (replace(settings, url=url, name=name) for settings in request.settings)
            request = SetReconnectCandidates(tuple(local))
        inbox.put(request)

    def _report(self, report: Report) -> None:
        """Handle a report of the session, in the thread of the session."""
        if isinstance(report, OfBoard):
            if report.number not in self._others:
                self._others[report.number] = BoardMirror(Keeper(log.info, log.warning).memory)
            other = self._others[report.number]
            for _ in other.handle(report.report, self._computer.clock(), utc_now()):
                pass
            self.server.report(report)
            return
        for event in self._board.handle(report, self._computer.clock(), utc_now()):
            if isinstance(event, Sample):
                self._publish(event)
        match report:  # a lost line is opened again with the newest settings
            case Connected(settings=settings) | Outcome(value=Written(settings=settings)):
                self._settings = settings
        if isinstance(report, Connected):
            unit = report.state.signature.model.current_unit
            self._table = MeasurementTable(report.state.mode, unit)
        if self._traffic and isinstance(report, Batch):
            events, self._traffic = tuple(self._traffic), []
            self.server.report(Traffic(events))
        if isinstance(report, Closed):
            self._others.clear()
            self._last = report
            self._closed.set()
        else:
            self.server.report(report)

    def _record_traffic(self, event: TrafficEvent) -> None:
        is_start = event.direction is not TrafficDirection.RECEIVED
        self._records_traffic = self.server.shows_traffic and (self._records_traffic or is_start)
        if self._records_traffic and len(self._traffic) < _EVENT_LIMIT:
            self._traffic.append(event)

    def _publish(self, sample: Sample) -> None:
        if self._is_subscribed and self._table is not None and self._table.add(sample):
            row = self._table.finish(sample.time)
            self._measurements.put(json.dumps(row), encoding="application/json")

    # --- The network, in threads of the engine ------------------------------------------

    def _party(self, expression: object) -> Party | None:
        """Return the client of a key `…/USER/CLIENT`, or `None` for an unknown user."""
        user, client = str(expression).split("/")[-2:]
        role = self._roles.get(user)
        return None if role is None else Party(client, user, role)

    def _on_request(self, sample: zenoh.Sample) -> None:
        party = self._party(sample.key_expr)
        if party in self._present or party in self._outboxes:  # `Leave` may come last
            self.server.handle(party, bytes(sample.payload))

    def _on_client(self, sample: zenoh.Sample) -> None:
        party = self._party(sample.key_expr)
        if party is None:
            return
        if sample.kind == zenoh.SampleKind.DELETE:  # each sample has its own kind object
            self._present.discard(party)  # the server keeps its client, which may reconnect
        elif sum(client.user == party.user for client in tuple(self._present)) < _CLIENT_LIMIT:
            self._present.add(party)
        else:
            log.warning("%s has too many clients", party.user)

    def _send(self, party: Party, message: bytes) -> None:
        outbox = self._outboxes.get(party)
        if outbox is None:
            name = key(self.name, "to", party.user, party.id)
            outbox = _Outbox(self._network, name, lambda: self._drop(party))
            self._outboxes[party] = outbox
        outbox.put(message)

    def _drop(self, party: Party) -> None:
        log.warning("%s receives its messages too slowly", party.user)
        threading.Thread(target=self.server.remove, args=(party,), daemon=True).start()

    def _on_query(self, query: zenoh.Query) -> None:
        query.reply(key(self.name, "info"), json.dumps(self.info()))

    def _on_stop(self, query: zenoh.Query) -> None:
        def reply(outcome: Outcome) -> None:
            text = "" if outcome.error is None else str(outcome.error)
            query.reply(query.key_expr, json.dumps({"name": self.name, "error": text}))
            query.drop()  # type: ignore[no-untyped-call]

        def reply_later(outcome: Outcome) -> None:  # the session must not wait for a client
            threading.Thread(target=reply, args=(outcome,), daemon=True).start()

        if self.server.exceeds_limit(str(query.key_expr).rpartition("/")[2], is_stop=True):
            return
        if self._is_open:
            self.server.stop(reply_later)
        else:
            error = self._last.error or TrexNoReplyError(ErrorCode.CLOSED)
            reply(Outcome(0, error=error))

    def _on_matching(self, status: zenoh.MatchingStatus) -> None:
        self._is_subscribed = status.matching

    def info(self) -> dict[str, Any]:
        """Return the entry of the board in the output of `trexcmd robots --json`."""
        board, lease = self._board, self.server.lease
        state = board.state
        boards = [board, *self._others.values()]
        problems = [
            entry.name for mirror in boards for entry in mirror.errors.entries if entry.count
        ]
        return {
            "name": self.name,
            "board": str(state.signature) if state else None,
            "device_number": state.parameters.get("device_number") if state else None,
            "responds": all(mirror.is_responding for mirror in boards),
            "driver": lease.holder.user if lease.holder else None,
            "refused": sum(self.server.refused.values()),
            "clients": len(self.server.users),
            "problems": list(dict.fromkeys(problems)),
        }
