"""Automatic connections, only when the user can expect them."""

import pytest
from pytestqt.qtbot import QtBot
from serial.tools.list_ports_common import ListPortInfo

from tests.support.simulator import SimulatedDevice, StartSimulator
from tests.support.virtual_devices import VirtualSimulator
from tests.support.virtual_time import VirtualRuntime
from tests.support.window import WindowDriver
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.line_settings import LineSettings
from trex_gui.ui.devices import auto_connect
from trex_gui.ui.devices.auto_connect import set_automatic
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.notifier import Remedy

FACTORY = ConnectionSettings("")


def adapter(url: str, number: str, socket: str = "1-2") -> ListPortInfo:
    info = ListPortInfo(url, skip_link_detection=True)
    info.vid, info.pid, info.serial_number, info.location = 0x0403, 0x6001, number, socket
    return info


class Bench:
    """Window without a connection, and two boards on known adapters."""

    def __init__(
        self,
        window: WindowDriver,
        computer: list[ListPortInfo],
        start_simulator: StartSimulator,
        virtual_time: VirtualRuntime,
    ) -> None:
        self.window = window
        self.device = window.device
        self._computer = computer
        self._time = virtual_time
        self.boards = [start_simulator("--unpaced"), start_simulator("--unpaced")]
        self.adapters = [adapter(b.url, f"A500000{i}") for i, b in enumerate(self.boards)]
        self.plug(*self.adapters)
        for board in self.boards:  # the second board was used last
            ports = window.program.ports
            port = ports.find(board.url)
            assert port is not None
            ports.assign(port, "trex", FACTORY.packed)

    def plug(self, *adapters: ListPortInfo) -> None:
        """Plug in only these adapters, and wait for the result."""
        self._computer[:] = adapters
        self.window.program.ports.refresh()
        self.settle()

    def start(self) -> None:
        self.window.program.auto_connect.start()
        self.settle()

    def settle(self) -> None:
        self._time.advance(1.5)

    @property
    def url(self) -> str:
        """Address of the connected board, or empty."""
        settings = self.device.settings
        is_connected = self.device.link is ConnectionState.CONNECTED
        return settings.url if settings is not None and is_connected else ""

    def listen(self, board: SimulatedDevice) -> list[bytes]:
        """Return a list that collects the bytes received by a board."""
        sent: list[bytes] = []
        assert isinstance(board, VirtualSimulator)
        board.on_write = sent.append
        return sent


@pytest.fixture
def bench(
    qtbot: QtBot,
    window: WindowDriver,
    computer: list[ListPortInfo],
    start_simulator: StartSimulator,
    virtual_time: VirtualRuntime,
) -> Bench:
    return Bench(window, computer, start_simulator, virtual_time)


def test_last_board_is_tried_first_at_the_start(bench: Bench) -> None:
    first, second = bench.boards
    sent = bench.listen(first)
    bench.start()
    assert bench.url == second.url
    assert not sent


def test_other_known_board_is_connected_if_the_last_is_silent(bench: Bench) -> None:
    first, second = bench.boards
    second.do("power off")
    sent = bench.listen(second)
    bench.start()
    assert bench.url == first.url
    assert set(b"".join(sent)) == {0xFF, 0x81}, "one harmless probe, no error"
    assert not bench.window.has("bannerText")


def test_board_is_found_at_the_settings_of_its_adapter(bench: Bench) -> None:
    first, second = bench.boards
    bench.plug(bench.adapters[0])
    ports = bench.window.program.ports
    port = ports.find(first.url)
    assert port is not None
    ports.assign(port, "trex", ConnectionSettings("", LineSettings(57600)).packed)
    bench.start()
    assert bench.url == "", "it is at another rate"
    bench.plug(*bench.adapters)
    assert bench.url == second.url
    assert bench.device.settings is not None
    assert bench.device.settings.line == LineSettings()


def test_nothing_is_connected_if_two_known_boards_answer(bench: Bench) -> None:
    bench.plug()
    bench.start()
    bench.plug(*bench.adapters)
    assert bench.url == ""
    bench.plug(bench.adapters[0])
    bench.plug(*bench.adapters)
    assert bench.url == bench.boards[1].url, "only one was plugged in now"


def test_unsuitable_ports_are_not_opened(bench: Bench, monkeypatch: pytest.MonkeyPatch) -> None:
    first, second = bench.boards
    sent = [bench.listen(board) for board in bench.boards]
    bench.plug()
    ports = bench.window.program.ports
    ports.assign(ports.add_typed(first.url), "trex", FACTORY.packed)
    assert ports.last_used is not None
    bench.start()
    assert bench.url == ""
    bench.plug(adapter(first.url, "B700000"), ListPortInfo(second.url, skip_link_detection=True))
    monkeypatch.setattr(auto_connect, "holder_of", lambda _: "minicom (process 7)")
    bench.plug()
    bench.plug(bench.adapters[0])
    assert bench.url == ""
    assert sent == [[], []]


def test_nothing_is_connected_against_the_users_wish(bench: Bench) -> None:
    set_automatic(False)
    bench.start()
    assert bench.url == "", "it is switched off"

    set_automatic(True)
    bench.plug()
    bench.window.device.notifier.report("Something is wrong.", (Remedy.FIND,))
    bench.plug(bench.adapters[0])
    assert bench.url == "", "a problem is shown"

    bench.window.click("bannerDismiss")
    bench.plug()
    bench.plug(bench.adapters[0])
    assert bench.url == bench.boards[0].url
    bench.window.disconnect()
    bench.plug()
    bench.plug(bench.adapters[0])
    assert bench.url == "", "the user has disconnected"
