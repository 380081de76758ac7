"""Final report of a session, and requests while a session ends."""

import threading
from collections.abc import Callable

import pytest
from pytestqt.qtbot import QtBot

from tests.support.program import new_controller, scanner_of
from tests.support.simulator import SimulatedDevice
from tests.support.virtual_time import VirtualRuntime
from trex_gui.core.session import Close, Closed, RequestQueue
from trex_gui.devices.aracna.model.robot import Robot
from trex_gui.devices.aracna.session.messages import Halt
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.devices.device_manager import DeviceManager
from trex_gui.ui.devices.ports import Port, PortKind
from trex_gui.ui.devices.scanner import ScanWorker
from trex_gui.ui.runtime import runtime
from trex_gui.ui.workers.session_thread import SessionThread
from trex_gui.ui.workers.threads import have_orphans_ended

Emit = Callable[[object], None]


class Gate:
    """Blocks a thread of the program until the test opens it."""

    def __init__(self) -> None:
        self._condition = runtime().condition()
        self._is_open = False

    def wait(self) -> None:
        with self._condition:
            while not self._is_open:
                self._condition.wait()

    def open(self) -> None:
        with self._condition:
            self._is_open = True
            self._condition.notify()


class RecordingSession:
    """Session that records its requests. It ends with a given report."""

    def __init__(self, final_report: object = None, gate: Gate | None = None) -> None:
        self.requests: list[object] = []
        self._final_report, self._gate = final_report, gate

    def create(self, inbox: RequestQueue, emit: Emit) -> "RecordingSession":
        self._inbox, self._emit = inbox, emit
        return self

    def run(self) -> None:
        while (request := self._inbox.get(60)) is not None:
            self.requests.append(request)
            if isinstance(request, Close):
                break
        if self._gate is not None:
            self._gate.wait()
        if self._final_report is not None:
            self._emit(self._final_report)


# --- Final report -----------------------------------------------------------------------


@pytest.mark.parametrize("may_move", [True, False])
def test_shutdown_records_whether_motors_may_still_move(
    qtbot: QtBot, virtual_time: VirtualRuntime, may_move: bool
) -> None:
    line = SessionThread()
    line.start(RecordingSession(Closed(None, may_move)).create, may_move=True)
    with qtbot.assertNotEmitted(line.closed):
        qtbot.waitUntil(line.shut_down)
        virtual_time.advance(0.01)
    assert line.last == Closed(None, may_move)


def test_may_move_remains_set_without_a_final_report(qtbot: QtBot) -> None:
    line = SessionThread()
    line.start(RecordingSession().create, may_move=True)
    qtbot.waitUntil(line.shut_down)
    assert line.last is not None
    assert line.last.may_move


def test_late_final_report_of_a_session_is_emitted(qtbot: QtBot) -> None:
    gate = Gate()
    line = SessionThread()
    line.start(RecordingSession(Closed(None, may_move=False), gate).create, may_move=True)
    assert not line.shut_down()
    assert line.last is None
    assert not have_orphans_ended()
    with qtbot.waitSignal(line.closed) as closed:
        gate.open()
    assert closed.args == [Closed(None, may_move=False)]
    qtbot.waitUntil(line.shut_down)


def test_final_report_does_not_close_the_next_session(
    qtbot: QtBot, virtual_time: VirtualRuntime
) -> None:
    gate = Gate()
    line = SessionThread()
    line.start(RecordingSession(Closed(None), gate).create, may_move=False)
    assert not line.shut_down()
    line.start(RecordingSession(Closed(None, may_move=True)).create, may_move=False)
    with qtbot.assertNotEmitted(line.closed):
        gate.open()
        qtbot.waitUntil(have_orphans_ended)
        virtual_time.advance(0.01)
    assert line.is_open
    qtbot.waitUntil(line.shut_down)
    assert line.last == Closed(None, may_move=True)


@pytest.mark.parametrize("is_mute", [True, False])
def test_only_confirmed_stop_clears_may_move_after_shutdown(
    quick_simulator: SimulatedDevice, qtbot: QtBot, is_mute: bool
) -> None:
    device = Device()
    device.connect_to(ConnectionSettings(quick_simulator.url))
    qtbot.waitUntil(lambda: device.link is ConnectionState.CONNECTED and device.motors.is_available)
    device.motors.arm()
    device.motors.set_speed(1, 60)
    qtbot.waitUntil(lambda: quick_simulator.show()["motors"][0]["speed"] == 60)
    assert device.may_move
    if is_mute:
        quick_simulator.do("line mute on")
    qtbot.waitUntil(device.shut_down)
    assert device.link is ConnectionState.DISCONNECTED
    assert device.may_move is is_mute


# --- Order of the shutdown --------------------------------------------------------------


def test_shutdown_closes_the_line_before_it_waits_for_a_scan(
    quick_simulator: SimulatedDevice, qtbot: QtBot, monkeypatch: pytest.MonkeyPatch
) -> None:
    controller, links = new_controller(), list[ConnectionState]()
    manager = DeviceManager({"trex": lambda: controller}, scanner_of(controller))
    close = ScanWorker.close

    def record_and_close(worker: ScanWorker) -> bool:
        links.append(controller.link)
        return close(worker)

    controller.device.connect_to(ConnectionSettings(quick_simulator.url))
    qtbot.waitUntil(lambda: controller.link is ConnectionState.CONNECTED)
    monkeypatch.setattr(ScanWorker, "close", record_and_close)
    manager.scanner.start([Port(PortKind.TYPED, "/dev/ttyNothing9", "/dev/ttyNothing9", "trex")])
    manager.shut_down()
    assert links
    assert ConnectionState.CONNECTED not in links
    qtbot.waitUntil(manager.shut_down)


# --- Requests from other threads --------------------------------------------------------


def test_request_is_accepted_while_the_session_ends() -> None:
    class EndingSessionThread(SessionThread):
        """Thread whose session ends while a request is submitted."""

        def moves(self, request: object) -> bool:
            self._worker = None
            return False

    line, session = EndingSessionThread(), RecordingSession(Closed(None))
    line.start(session.create, may_move=False)
    worker = line._worker
    assert worker is not None
    assert line.submit("request")
    assert worker.close(15_000)
    assert session.requests == ["request", Close()]


def test_halt_from_another_thread_also_closes_the_session(
    qtbot: QtBot, monkeypatch: pytest.MonkeyPatch
) -> None:
    def end_session(line: Robot, request: object) -> bool:
        line._worker = None
        return False

    robot, session = Robot(), RecordingSession(Closed(None))
    robot.start(session.create, may_move=False)
    worker = robot._worker
    assert worker is not None
    monkeypatch.setattr(Robot, "moves", end_session)
    thread = threading.Thread(target=robot.halt_now, kwargs={"ending": True})
    thread.start()
    thread.join(15)
    worker.submit(None)  # so that the thread ends after a failure too
    assert worker.wait(15_000)
    assert session.requests == [Halt(), Close()]
