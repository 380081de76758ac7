"""Automatic connection at the start and after an adapter is plugged in."""

import pytest
from serial.tools.list_ports_common import ListPortInfo

from tests.support.simulator import SimulatedDevice, StartSimulator
from tests.support.virtual_devices import VirtualSimulator
from tests.support.virtual_time import VirtualRuntime
from tests.support.window import WindowDriver
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.line_settings import LineSettings
from trex_gui.ui.devices import auto_connect
from trex_gui.ui.devices.auto_connect import set_connects_automatically
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.notifier import Remedy

FACTORY = ConnectionSettings("")


def adapter(url: str, serial_number: str) -> ListPortInfo:
    port = ListPortInfo(url, skip_link_detection=True)
    port.vid, port.pid, port.serial_number, port.location = 0x0403, 0x6001, serial_number, "1-2"
    return port


class ConnectionHarness:
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
        self._ports = computer
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
        """Plug in only these adapters and unplug all others. Wait for the result."""
        self._ports[:] = adapters
        self.window.program.ports.refresh()
        self.wait()

    def start(self) -> None:
        self.window.program.auto_connect.start()
        self.wait()

    def wait(self) -> None:
        self._time.advance(1.5)

    @property
    def url(self) -> str:
        """URL of the connected board. Empty without a connection."""
        settings = self.device.settings
        is_connected = self.device.link is ConnectionState.CONNECTED
        return settings.url if settings is not None and is_connected else ""

    def record_packets(self, board: SimulatedDevice) -> list[bytes]:
        """Return a list to which the packets for a board will be added."""
        packets: list[bytes] = []
        assert isinstance(board, VirtualSimulator)
        board.on_write = packets.append
        return packets


@pytest.fixture
def harness(
    computer: list[ListPortInfo],
    window: WindowDriver,
    start_simulator: StartSimulator,
    virtual_time: VirtualRuntime,
) -> ConnectionHarness:
    return ConnectionHarness(window, computer, start_simulator, virtual_time)


def test_last_used_board_is_connected_at_the_start(harness: ConnectionHarness) -> None:
    first, second = harness.boards
    packets = harness.record_packets(first)
    harness.start()
    assert harness.url == second.url
    assert not packets


def test_other_known_board_is_connected_if_last_one_is_silent(harness: ConnectionHarness) -> None:
    first, second = harness.boards
    second.do("power off")
    packets = harness.record_packets(second)
    harness.start()
    assert harness.url == first.url
    assert set(b"".join(packets)) == {0xFF, 0x81}, "one probe that moves no motor"
    assert not harness.window.has("bannerText")


def test_board_is_connected_with_the_settings_of_its_adapter(harness: ConnectionHarness) -> None:
    first, second = harness.boards
    harness.plug(harness.adapters[0])
    ports = harness.window.program.ports
    port = ports.find(first.url)
    assert port is not None
    ports.assign(port, "trex", ConnectionSettings("", LineSettings(57600)).packed)
    harness.start()
    assert harness.url == "", "the board uses another baud rate"
    harness.plug(*harness.adapters)
    assert harness.url == second.url
    assert harness.device.settings is not None
    assert harness.device.settings.line == LineSettings()


def test_nothing_is_connected_if_two_known_boards_answer(harness: ConnectionHarness) -> None:
    harness.plug()
    harness.start()
    harness.plug(*harness.adapters)
    assert harness.url == ""
    harness.plug(harness.adapters[0])
    harness.plug(*harness.adapters)
    assert harness.url == harness.boards[1].url, "only this board is new"


def test_unsuitable_ports_are_not_opened(
    harness: ConnectionHarness, monkeypatch: pytest.MonkeyPatch
) -> None:
    first, second = harness.boards
    packets = [harness.record_packets(board) for board in harness.boards]
    harness.plug()
    ports = harness.window.program.ports
    ports.assign(ports.add_typed(first.url), "trex", FACTORY.packed)
    assert ports.last_used is not None
    harness.start()
    assert harness.url == ""
    harness.plug(adapter(first.url, "B700000"), ListPortInfo(second.url, skip_link_detection=True))
    monkeypatch.setattr(auto_connect, "holder_of", lambda _: "minicom (process 7)")
    harness.plug()
    harness.plug(harness.adapters[0])
    assert harness.url == ""
    assert packets == [[], []]


def test_user_choice_or_problem_prevents_connection(harness: ConnectionHarness) -> None:
    set_connects_automatically(False)
    harness.start()
    assert harness.url == "", "automatic connection is switched off"

    set_connects_automatically(True)
    harness.plug()
    harness.window.device.notifier.report("Something is wrong.", (Remedy.FIND,))
    harness.plug(harness.adapters[0])
    assert harness.url == "", "a problem is shown"

    harness.window.click("bannerDismiss")
    harness.plug()
    harness.plug(harness.adapters[0])
    assert harness.url == harness.boards[0].url
    harness.window.disconnect()
    harness.plug()
    harness.plug(harness.adapters[0])
    assert harness.url == "", "the user has disconnected"
