import json

import pytest

from tests.devices.trex.simulator.ports import ask
from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.simulator.channels import Signal
from trex_gui.devices.trex.simulator.control import report
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.uart import SerialPort


def test_show_contains_fields_used_by_scripts() -> None:
    shown = json.loads(json.dumps(report(Board("trexjr", "1.0", mode="rc"))))
    assert {
        "model", "firmware", "power", "mode", "serial_controls", "override", "safe_start",
        "motors", "aux", "channels", "parameters", "active_uart", "leds", "counters",
        "jumpers", "battery", "supply", "calibrations", "learned",
    } <= set(shown)  # fmt: skip
    assert (shown["model"], shown["firmware"], shown["mode"]) == ("trexjr", "1.0", "R")
    assert [set(motor) for motor in shown["motors"]] == [
        {
            "direction", "speed", "target_direction", "target_speed", "current", "fault",
            "pwm_hz", "load", "stall", "rpm",
        }
    ] * 2  # fmt: skip
    assert shown["channels"] == [{"raw": None, "remapped": 0, "signal": "rest"}] * 5
    assert shown["jumpers"] == {"mode": "rc", "mix": False, "so_ground": False}
    assert (shown["battery"], shown["supply"]) == (12.0, 12.0)
    assert [motor["stall"] for motor in shown["motors"]] == [5.0, 5.0]
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
def test_show_reports_active_line_settings(
    board: Board, settings: int, expected: dict[str, object]
) -> None:
    board.eeprom.write("uart_settings", settings)
    board.power_cycle()
    assert report(board)["active_uart"] == expected


def test_leds_show_serial_control_and_packet_activity(board: Board, port: SerialPort) -> None:
    board.advance(2)
    assert report(board)["leds"] == {"red": "on", "green": "off"}
    port.feed(0x86)
    assert report(board)["leds"] == {"red": "on", "green": "on"}
    port.feed(0x1F)
    assert report(board)["leds"] == {"red": "on", "green": "off"}


def test_rc_mode_swaps_leds() -> None:
    board = Board(mode="rc")
    board.channels.signals[2] = Signal.pulses(1900)
    board.power_cycle()
    board.advance(2)
    assert report(board)["leds"] == {"red": "off", "green": "fast flash"}
    board.channels.signals[2] = Signal.pulses(1500)
    assert report(board)["leds"] == {"red": "off", "green": "fast flash"}
    board.advance(0.03)
    assert report(board)["leds"] == {"red": "off", "green": "on"}
    SerialPort(board).feed(0x86)
    assert report(board)["leds"] == {"red": "on", "green": "on"}


def test_power_up_flashes_show_learned_channels(board: Board) -> None:
    calibration = board.calibration(1)
    board.eeprom.write_calibration(InputSource.RC, 2, type(calibration)(2000, 3000, 4000, 50))
    board.power_cycle()
    seen = []
    for _ in range(5):
        seen.append(report(board)["leds"])
        board.advance(0.2)
        assert report(board)["leds"] == {"red": "off", "green": "off"}
        board.advance(0.1)
    red, green = {"red": "on", "green": "off"}, {"red": "off", "green": "on"}
    assert seen == [red, green, red, red, red]


def test_leds_are_off_without_power(board: Board) -> None:
    board.power_off()
    assert report(board)["leds"] == {"red": "off", "green": "off"}


# Prescaler, wire value of the maximum, and what both together give: prescalers divide 20 MHz by
# 8, 64, 256 or 1024, and the wire carries the upper seven bits of the maximum.
PWM = [
    (0, 0x3F, 19531), (0, 0x7F, 9766),
    (1, 0x3F, 2441), (1, 0x7F, 1221),
    (2, 0x3F, 610), (2, 0x7F, 305),
    (3, 0x3F, 153), (3, 0x7F, 76),
]  # fmt: skip


@pytest.mark.parametrize("number", [1, 2])
@pytest.mark.parametrize(("prescaler", "maximum", "hertz"), PWM)
def test_prescaler_and_maximum_set_pwm_frequency_at_once(
    board: Board, port: SerialPort, number: int, prescaler: int, maximum: int, hertz: int
) -> None:
    before = report(board)["motors"][2 - number]["pwm_hz"]
    assert ask(port, f"AF {8 + number:02X} {prescaler:02X} 55 2A") == "00"
    assert ask(port, f"AF {10 + number:02X} {maximum:02X} 55 2A") == "00"
    assert report(board)["motors"][number - 1]["pwm_hz"] == pytest.approx(hertz, abs=0.6)
    assert report(board)["motors"][2 - number]["pwm_hz"] == before


def test_show_reports_motor_load_and_rpm(board: Board, port: SerialPort) -> None:
    board.physics[0].load = 4.0
    ask(port, "C1 7F")
    board.advance(2)
    motor, other = report(board)["motors"]
    assert motor["load"] == 4.0
    assert -15_000 < motor["rpm"] < -10_000
    assert other["rpm"] == 0
    assert isinstance(motor["rpm"], int)


def test_show_reports_calibrations_and_learned_channels(board: Board) -> None:
    shown = report(board)
    assert list(shown["calibrations"]) == [
        f"{source}_channel_{channel}" for source in ("rc", "analog") for channel in range(1, 6)
    ]
    rc = {"minimum": 2500, "neutral": 3750, "maximum": 5000, "deadband": 75}
    assert shown["calibrations"]["rc_channel_4"] == rc
    assert shown["learned"] == {"rc": 0, "analog": 0}
    board.eeprom.write_calibration(InputSource.RC, 4, Calibration(2500, 3700, 5000, 75))
    assert report(board)["calibrations"]["rc_channel_4"] == {**rc, "neutral": 3700}
    assert report(board)["learned"] == {"rc": 0b01000, "analog": 0}
