import json

import pytest

from trex_gui.emulator.channels import Signal
from trex_gui.emulator.firmware import Board
from trex_gui.emulator.uart import SerialPort
from trex_gui.protocol.flags import InputSource


def test_show_has_what_scripts_rely_on() -> None:
    shown = json.loads(json.dumps(Board("trexjr", "1.0", mode="rc").show()))
    assert {
        "model", "firmware", "power", "mode", "serial_controls", "override", "safe_start",
        "motors", "aux", "channels", "parameters", "active_uart", "leds", "counters",
    } <= set(shown)  # fmt: skip
    assert (shown["model"], shown["firmware"], shown["mode"]) == ("trexjr", "1.0", "R")
    assert [set(motor) for motor in shown["motors"]] == [
        {"direction", "speed", "target_direction", "target_speed", "current", "fault"}
    ] * 2
    assert shown["channels"] == [{"raw": 3750, "remapped": 0}] * 5
    assert "uart_response_delay" not in shown["parameters"]
    assert "factory_reset" not in shown["parameters"]
    expected = {"baud": 19200, "parity": "none", "stop_bits": 1, "crc": False}
    assert shown["active_uart"] == expected


@pytest.mark.parametrize(
    ("settings", "expected"),
    [
        (0x2A, {"baud": 115200, "parity": "none", "stop_bits": 1, "crc": True}),
        (0x53, {"baud": 9600, "parity": "even", "stop_bits": 2, "crc": False}),
        (0x60, {"baud": 1200, "parity": "odd", "stop_bits": 1, "crc": False}),
    ],
)
def test_show_tells_the_line_settings_that_act(
    board: Board, settings: int, expected: dict[str, object]
) -> None:
    board.eeprom.write("uart_settings", settings)
    board.power_cycle()
    assert board.show()["active_uart"] == expected


def test_an_invalid_channel_shows_as_null(board: Board) -> None:
    board.connect(1, Signal.parse("invalid", InputSource.RC))
    assert board.show()["channels"][0] == {"raw": None, "remapped": 0}


def test_the_leds_tell_who_controls_and_flicker_with_packets(
    board: Board, port: SerialPort
) -> None:
    board.advance(2)
    assert board.show()["leds"] == {"red": "on", "green": "off"}
    port.feed(0x86)
    assert board.show()["leds"] == {"red": "on", "green": "on"}
    port.feed(0x1F)
    assert board.show()["leds"] == {"red": "on", "green": "off"}


def test_in_rc_mode_the_leds_change_places() -> None:
    board = Board(mode="rc")
    board.connect(2, Signal.pulses(1900))
    board.power_cycle()
    board.advance(2)
    assert board.show()["leds"] == {"red": "off", "green": "fast flash"}
    board.connect(2, Signal.pulses(1500))
    assert board.show()["leds"] == {"red": "off", "green": "on"}
    SerialPort(board).feed(0x86)
    assert board.show()["leds"] == {"red": "on", "green": "on"}


def test_at_power_up_five_flashes_tell_the_learned_channels(board: Board) -> None:
    calibration = board.calibration(1)
    board.eeprom.write_calibration(InputSource.RC, 2, type(calibration)(2000, 3000, 4000, 50))
    board.power_cycle()
    seen = []
    for _ in range(5):
        seen.append(board.show()["leds"])
        board.advance(0.2)
        assert board.show()["leds"] == {"red": "off", "green": "off"}
        board.advance(0.1)
    red, green = {"red": "on", "green": "off"}, {"red": "off", "green": "on"}
    assert seen == [red, green, red, red, red]


def test_without_power_no_led_is_lit(board: Board) -> None:
    board.power_off()
    assert board.show()["leds"] == {"red": "off", "green": "off"}
