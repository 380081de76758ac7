"""Boot loader and learning mode."""

import pytest

from tests.devices.trex.simulator.ports import exchange
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.simulator.channels import Signal, SignalKind
from trex_gui.devices.trex.simulator.control import report
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.uart import SerialPort


def boot_step(board: Board) -> str:
    return str(report(board)["boot_mode"])


def start(board: Board) -> Board:
    """Switch on a board with both jumpers."""
    board.so_ground = board.mix = True
    board.power_cycle()
    return board


@pytest.mark.parametrize("mode", ["serial", "rc", "analog"])
def test_boot_mode_needs_both_jumpers(mode: str) -> None:
    board = Board(mode=mode, mix=True)
    board.power_cycle()
    assert board.boot_mode is None
    board.mix, board.so_ground = False, True
    board.power_cycle()
    assert board.boot_mode is None


def test_boot_loader_handshake_restores_serial_settings() -> None:
    board = Board()
    board.eeprom.write("uart_settings", 0x6A)
    board.eeprom.write("crc7_polynomial", 1)
    board.eeprom.write("serial_timeout", 3)
    start(board)
    board.advance(0.1)
    assert report(board)["leds"] == {"red": "alternate 1/s", "green": "alternate 1/s"}
    board.mix = False
    board.advance(0.1)
    assert report(board)["leds"]["red"] == "alternate 4/s"
    board.so_ground = False
    board.advance(0.1)
    assert boot_step(board) == "boot loader: ready"
    board.power_cycle()
    assert boot_step(board) == "None"
    assert (board.memory.baud, board.memory.crc_polynomial) == (19200, None)
    assert board.memory.active["crc7_polynomial"] == 9
    assert board.memory.active["serial_timeout"] == 3


def test_board_waiting_for_boot_loader_ignores_packets() -> None:
    board = start(Board())
    port = SerialPort(board)
    assert exchange(port, "81") == ""
    assert report(board)["counters"]["bytes_received"] == 0


def test_learning_sets_neutral_and_extremes_from_sticks() -> None:
    board = start(Board(mode="rc"))
    board.advance(0.1)
    assert report(board)["leds"] == {"red": "blink 1/s", "green": "blink 1/s"}
    board.channels.signals[1] = Signal.pulses(1480)
    board.channels.signals[2] = Signal(SignalKind.BAD_PULSES)
    board.mix = False
    board.advance(0.05)
    assert report(board)["leds"] == {"red": "on", "green": "off"}
    board.advance(2.0)
    assert boot_step(board) == "learning: neutrals learned"
    board.advance(2.0)
    assert report(board)["leds"] == {"red": "on", "green": "on"}
    for microseconds, seconds in ((1100, 1.0), (2000, 0.2), (1900, 1.0)):  # 0.2 s is too short
        board.channels.signals[1] = Signal.pulses(microseconds)
        board.advance(seconds)
    board.advance(8.0)
    assert boot_step(board) == "learning: done"

    learned = board.calibration(1)
    assert (learned.minimum, learned.neutral, learned.maximum) == (2750, 3700, 4750)
    assert learned.deadband == 75
    assert board.eeprom.learned(InputSource.RC) == 0b00001
    assert board.sticks.safe_start

    board.so_ground = False
    board.power_cycle()
    board.advance(0.1)
    assert board.is_running


def test_learning_shows_each_channel_on_green_led() -> None:
    board = start(Board(mode="rc"))
    board.channels.signals[2] = Signal(SignalKind.BAD_PULSES)
    board.mix = False
    board.advance(2.05)
    green_leds = []
    for _ in range(5):
        green_leds.append(report(board)["leds"]["green"])
        board.advance(0.4)
    assert green_leds == ["on", "off", "on", "on", "on"]


def test_learning_waits_for_signal_and_can_be_aborted() -> None:
    board = Board(mode="rc")
    for channel in range(1, 6):
        board.channels.signals[channel] = Signal(SignalKind.BAD_PULSES)
    start(board)
    board.mix = False
    board.advance(5)
    assert report(board)["leds"] == {"red": "blink 4/s", "green": "blink 4/s"}
    board.so_ground = False
    board.advance(0.1)
    assert board.is_running
    assert board.sticks.safe_start


def test_learning_ends_when_no_channel_is_steady() -> None:
    board = start(Board(mode="analog"))
    board.mix = False
    for index in range(30):
        for channel in range(1, 6):
            board.channels.signals[channel] = Signal.voltage(index % 2)
        board.advance(0.1)
    board.advance(3)
    assert boot_step(board) == "learning: done"
    assert board.eeprom.learned(InputSource.ANALOG) == 0


def test_unmoved_stick_is_not_learned() -> None:
    board = start(Board(mode="rc"))
    board.mix = False
    board.advance(20)
    assert boot_step(board) == "learning: done"
    assert board.eeprom.learned(InputSource.RC) == 0
