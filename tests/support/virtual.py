"""Board, wire and session in virtual time."""

from collections import deque
from collections.abc import Callable

from tests.support.transport import SimulatedTransport
from trex_gui.core.session import Close
from trex_gui.devices.trex.client.client import TrexClient
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.session.messages import Report, Request
from trex_gui.devices.trex.session.session import TrexSession
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.line import SimulatedBoards

VirtualTransport = SimulatedTransport[SimulatedBoards]


class Script:
    """Inbox whose requests arrive at given virtual times. After the last, it closes the line.

    A step is a request, or a function that changes the board.
    """

    def __init__(self, line: SimulatedBoards) -> None:
        self._line = line
        self._done = False
        self._steps: deque[tuple[float, Request | Callable[[], object]]] = deque()

    def at(self, time: float, step: Request | Callable[[], object]) -> "Script":
        """Perform a step `time` seconds after the start of the line. Times must not decrease."""
        self._steps.append((time, step))
        return self

    def get(self, seconds: float) -> Request | None:
        end = self._line.now + seconds
        while True:
            if not self._steps:
                if self._done:
                    return None
                self._done = True
                return Close()
            time, step = self._steps[0]
            if time > end:
                self._line.advance(end - self._line.now)
                return None
            self._line.advance(max(0.0, time - self._line.now))
            self._steps.popleft()
            if not callable(step):
                return step
            step()


class SessionHarness:
    """Board, wire, and a session that follows a script. `other_boards` share the wire."""

    def __init__(self, board: Board, *other_boards: Board, echo: bool = False) -> None:
        self.board = board
        self.line = SimulatedBoards([board, *other_boards], echo=echo)
        self.transport = VirtualTransport(self.line)
        self.script = Script(self.line)
        self.reports: list[Report] = []

    def client(self, settings: ConnectionSettings | None = None) -> TrexClient:
        return TrexClient(
            self.transport, settings or ConnectionSettings("virtual"), echo=self.line.echo
        )

    def fault(self, **values: float) -> Callable[[], None]:
        """Return a step of the script that changes the faults of the line."""
        return lambda: vars(self.line.faults).update(values)

    def run(
        self, settings: ConnectionSettings | None = None, *, may_move: bool = False
    ) -> list[Report]:
        """Open the line, run the script, close the line. Return all reports."""
        session = TrexSession(
            settings or ConnectionSettings("virtual"),
            self.script,
            self.reports.append,
            lambda _settings: self.transport,
            may_move=may_move,
        )
        session.run()
        return self.reports
