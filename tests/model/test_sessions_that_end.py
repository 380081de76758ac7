"""The last word of a session, and requests while it ends."""

import threading
from collections.abc import Callable, Iterator

import pytest
from pytestqt.qtbot import QtBot

from tests.support.simulator import SimulatedDevice
from trex_gui.aracna.link.messages import Halt
from trex_gui.aracna.model.connection import RobotConnection
from trex_gui.aracna.model.robot import Robot
from trex_gui.link.inbox import QueueInbox
from trex_gui.link.messages import Close, Closed
from trex_gui.link.settings import LinkSettings
from trex_gui.model.connector import Connector
from trex_gui.model.device import Device, Link
from trex_gui.model.ports import Port, PortKind, Ports
from trex_gui.model.session_thread import SessionThread
from trex_gui.runtime import runtime
from trex_gui.worker import abandoned
from trex_gui.worker.find_worker import FindWorker

Emit = Callable[[object], None]


class Noting:
    """A session that notes what it is asked, and ends as it is told to."""

    def __init__(self, last: object = None, until: threading.Event | None = None) -> None:
        self.asked: list[object] = []
        self._last, self._until = last, until

    def make(self, inbox: QueueInbox, emit: Emit) -> "Noting":
        self._inbox, self._emit = inbox, emit
        return self

    def run(self) -> None:
        while (request := self._inbox.get(60)) is not None:
            self.asked.append(request)
            if isinstance(request, Close):
                break
        if self._until is not None:
            while not self._until.is_set():
                runtime().sleep(0.01)
        if self._last is not None:
            self._emit(self._last)


# --- The last word ----------------------------------------------------------------------


@pytest.mark.parametrize("may_move", [True, False])
def test_who_shuts_down_knows_whether_motors_may_still_turn(qtbot: QtBot, may_move: bool) -> None:
    line = SessionThread()
    line.start(Noting(Closed(None, may_move)).make, may_move=True)
    with qtbot.assertNotEmitted(line.closed):
        qtbot.waitUntil(line.shut_down)
        qtbot.wait(10)
    assert line.last == Closed(None, may_move)


def test_a_session_without_a_last_word_leaves_turning_what_was_driven(qtbot: QtBot) -> None:
    line = SessionThread()
    line.start(Noting().make, may_move=True)
    qtbot.waitUntil(line.shut_down)
    assert line.last is not None
    assert line.last.may_move


def test_the_last_word_of_a_session_that_ends_too_late_is_told(qtbot: QtBot) -> None:
    goes_on = threading.Event()
    line = SessionThread()
    line.start(Noting(Closed(None, may_move=False), goes_on).make, may_move=True)
    assert not line.shut_down()
    assert line.last is None
    assert abandoned.any_running()
    with qtbot.waitSignal(line.closed) as closed:
        goes_on.set()
    assert closed.args == [Closed(None, may_move=False)]
    qtbot.waitUntil(line.shut_down)


def test_the_last_word_of_a_session_that_was_given_up_ends_no_other(qtbot: QtBot) -> None:
    goes_on = threading.Event()
    line = SessionThread()
    line.start(Noting(Closed(None), goes_on).make, may_move=False)
    assert not line.shut_down()
    line.start(Noting(Closed(None, may_move=True)).make, may_move=False)
    with qtbot.assertNotEmitted(line.closed):
        goes_on.set()
        qtbot.waitUntil(lambda: not abandoned.any_running())
        qtbot.wait(10)
    assert line.is_open
    qtbot.waitUntil(line.shut_down)
    assert line.last == Closed(None, may_move=True)


def driven(simulator: SimulatedDevice, qtbot: QtBot) -> Device:
    """A device whose first motor runs."""
    device = Device()
    device.connect_to(LinkSettings(simulator.url))
    qtbot.waitUntil(lambda: device.link is Link.UP and device.motors.can_arm)
    device.motors.arm()
    device.motors.set_speed(1, 60)
    qtbot.waitUntil(lambda: simulator.show()["motors"][0]["speed"] == 60)
    return device


def test_a_board_that_does_not_prove_its_stop_may_move_when_the_line_is_closed(
    quick_simulator: SimulatedDevice, qtbot: QtBot
) -> None:
    device = driven(quick_simulator, qtbot)
    quick_simulator.do("line mute on")
    qtbot.waitUntil(device.shut_down)
    assert device.link is Link.NONE
    assert device.may_move


def test_motors_that_were_proved_to_stand_move_no_more_when_the_line_is_closed(
    quick_simulator: SimulatedDevice, qtbot: QtBot
) -> None:
    device = driven(quick_simulator, qtbot)
    assert device.may_move
    qtbot.waitUntil(device.shut_down)
    assert not device.may_move


# --- Who waits for whom -----------------------------------------------------------------


@pytest.fixture
def connector(qtbot: QtBot) -> Iterator[Connector]:
    connector = Connector(Device(), Ports())
    yield connector
    qtbot.waitUntil(connector.shut_down)


def test_the_line_is_told_to_end_before_a_search_is_waited_for(
    connector: Connector,
    quick_simulator: SimulatedDevice,
    qtbot: QtBot,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    device, links = connector._device, list[Link]()
    close = FindWorker.close

    def note_and_close(worker: FindWorker) -> bool:
        links.append(device.link)
        return close(worker)

    device.connect_to(LinkSettings(quick_simulator.url))
    qtbot.waitUntil(lambda: device.link is Link.UP)
    monkeypatch.setattr(FindWorker, "close", note_and_close)
    connector.finder.start([Port(PortKind.TYPED, "/dev/ttyNothing9", "/dev/ttyNothing9")])
    connector.shut_down()
    assert links
    assert Link.UP not in links


# --- Requests from other threads --------------------------------------------------------


def test_a_request_that_comes_while_the_session_ends_is_no_mistake() -> None:
    class Ending(SessionThread):
        """A line whose session ends while somebody hands over a request."""

        def moves(self, request: object) -> bool:
            self._worker = None
            return False

    line, session = Ending(), Noting(Closed(None))
    line.start(session.make, may_move=False)
    worker = line._worker
    assert worker is not None
    assert line.submit("something")
    assert worker.close(15_000)
    assert session.asked == ["something", Close()]


def test_a_halt_from_another_thread_is_followed_by_the_close_of_the_same_session(
    qtbot: QtBot, monkeypatch: pytest.MonkeyPatch
) -> None:
    def end_meanwhile(line: RobotConnection, request: object) -> bool:
        line._worker = None
        return False

    robot, session = Robot(), Noting(Closed(None))
    robot._line.start(session.make, may_move=False)
    worker = robot._line._worker
    assert worker is not None
    monkeypatch.setattr(RobotConnection, "moves", end_meanwhile)
    thread = threading.Thread(target=robot.halt_now, kwargs={"ending": True})
    thread.start()
    thread.join(15)
    worker.submit(None)  # where nobody has closed it: the thread has to end
    assert worker.wait(15_000)
    assert session.asked == [Halt(), Close()]
