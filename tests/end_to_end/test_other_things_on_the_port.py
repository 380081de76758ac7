"""Lines that are remote, damaged, or hold something that is no TReX."""

import os
import socket
import sys
import threading
from collections.abc import Iterator

import pytest
from PySide6.QtWidgets import QLabel
from pytestqt.qtbot import QtBot

from tests.support.simulator import SimulatedDevice, StartSimulator
from trex_gui.link.settings import LinkSettings
from trex_gui.model.device import Link
from trex_gui.protocol.line_settings import Detection, LineSettings
from trex_gui.window import Program


def banner(program: Program) -> str:
    label = program.window.findChild(QLabel, "bannerText")
    assert label is not None
    return label.text()


@pytest.fixture
def chatterer() -> Iterator[str]:
    """A device that sends without being asked, as a GPS receiver does."""
    server = socket.create_server(("127.0.0.1", 0))
    ending = threading.Event()

    def talk() -> None:
        connection, _ = server.accept()
        with connection:
            while not ending.is_set():
                try:
                    connection.sendall(b"$GPGGA,123519,4807.038,N\r\n" * 20)
                except OSError:
                    return

    thread = threading.Thread(target=talk)
    thread.start()
    yield f"socket://127.0.0.1:{server.getsockname()[1]}"
    ending.set()
    server.close()
    thread.join(5)


@pytest.mark.parametrize("kind", ["--tcp", "--rfc2217"])
@pytest.mark.filterwarnings("ignore:set(Daemon|Name):DeprecationWarning")
@pytest.mark.realtime
def test_a_board_behind_a_network_connects_and_its_loss_is_noticed(
    kind: str, program: Program, qtbot: QtBot, start_simulator: StartSimulator
) -> None:
    simulator = start_simulator(kind, "127.0.0.1:0")
    program.device.connect_to(LinkSettings(simulator.url))
    qtbot.waitUntil(lambda: program.device.link is Link.UP, timeout=30_000)
    simulator.do("line unplug")
    qtbot.waitUntil(lambda: program.device.link is Link.NONE)
    assert "gone" in banner(program)


def test_something_that_talks_by_itself_is_a_sentence(
    program: Program, qtbot: QtBot, chatterer: str
) -> None:
    program.device.connect_to(LinkSettings(chatterer))
    qtbot.waitUntil(lambda: program.device.link is Link.NONE, timeout=30_000)
    assert "not as a TReX does" in banner(program)
    assert program.device.shut_down()


@pytest.mark.skipif(sys.platform == "win32", reason="needs pseudo-terminals")
def test_a_port_with_nothing_behind_it_is_a_sentence(program: Program, qtbot: QtBot) -> None:
    master, slave = os.openpty()
    try:
        program.device.connect_to(LinkSettings(os.ttyname(slave)))
        qtbot.waitUntil(lambda: program.device.link is Link.NONE, timeout=30_000)
        assert "No TReX answers" in banner(program)
        assert "power" in banner(program)
    finally:
        os.close(master)
        os.close(slave)


def test_another_baud_rate_is_a_sentence_that_names_it(
    program: Program, qtbot: QtBot, simulator: SimulatedDevice
) -> None:
    program.device.connect_to(LinkSettings(simulator.url, LineSettings(9600)))
    qtbot.waitUntil(lambda: program.device.link is Link.NONE, timeout=30_000)
    assert "9600 baud" in banner(program)


def test_a_board_that_wants_crc_connects_with_it(
    program: Program, qtbot: QtBot, simulator: SimulatedDevice
) -> None:
    program.device.connect_to(LinkSettings(simulator.url))
    qtbot.waitUntil(lambda: program.device.link is Link.UP)
    model = program.device.parameters
    model.setData(model.index_of("uart_settings"), 0x2A)
    program.device.apply()
    qtbot.waitUntil(lambda: model.waiting_for_power == ("UART Settings",))
    simulator.do("power off")
    simulator.do("power on")
    settings = LinkSettings(simulator.url, LineSettings(115200, Detection.CRC7))
    program.device.connect_to(settings)
    qtbot.waitUntil(lambda: program.device.settings == settings)
    qtbot.waitUntil(lambda: program.device.link is Link.UP)
    assert model.waiting_for_power == ()


def test_an_addressed_board_with_an_echo_connects(
    program: Program, qtbot: QtBot, start_simulator: StartSimulator
) -> None:
    simulator = start_simulator("--echo", "--device", "9")
    program.device.connect_to(LinkSettings(simulator.url, device_number=9))
    qtbot.waitUntil(lambda: program.device.link is Link.UP)
    assert program.device.echo


def test_driving_goes_on_over_an_echo_that_is_damaged_now_and_then(
    program: Program, qtbot: QtBot, start_simulator: StartSimulator
) -> None:
    simulator = start_simulator("--echo")
    program.device.connect_to(LinkSettings(simulator.url))
    qtbot.waitUntil(lambda: program.device.link is Link.UP)
    program.device.motors.arm()
    simulator.do("line noise 0.01")
    for speed in range(1, 60):
        program.device.motors.set_speed(1, speed)
        qtbot.wait(10)
    simulator.do("line noise 0")
    assert program.device.link is not Link.NONE
    program.device.motors.stop()
    qtbot.waitUntil(lambda: not program.device.may_move)
    assert simulator.show()["motors"][0]["direction"] == "brake"
