"""Control lines of the simulator."""

import json
from typing import Any

import pytest

from tests.devices.trex.simulator.ports import create_board, exchange
from trex_gui.core.simulator.control_lines import GOODBYE
from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.simulator.channels import Signal
from trex_gui.devices.trex.simulator.command import SIMULATOR
from trex_gui.devices.trex.simulator.control import control, report
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.line import SimulatedBoards
from trex_gui.devices.trex.simulator.physics import CONSTANTS
from trex_gui.devices.trex.simulator.uart import SerialPort


def show(line: SimulatedBoards, name: str = "") -> dict[str, Any]:
    reply = control(line, f"{name} show")
    assert reply.startswith("ok ")
    state: dict[str, Any] = json.loads(reply.removeprefix("ok "))
    return state


@pytest.fixture
def two_boards() -> SimulatedBoards:
    return SimulatedBoards([create_board(7), create_board(9, model="trexjr")])


def test_help_lists_every_control_line() -> None:
    listed = SIMULATOR.help.partition("Control lines: ")[2].partition(";")[0]
    known = control(SimulatedBoards([Board()]), "nosuch").partition("commands are ")[2]
    assert set(listed.split(", ")) == set(known.split(", "))


@pytest.mark.parametrize(
    ("text", "signal"),
    [
        ("3750", "1500us"),
        ("Silent", "silent"),
        ("1500us noise 2us lost 0.1", "1500us noise 2us lost 0.1"),
        ("2.5v noise 20mv", "2.5V noise 0.02V"),
    ],
)
def test_reply_and_show_name_the_channel_signal(
    line: SimulatedBoards, text: str, signal: str
) -> None:
    assert control(line, f"channel 1 {text}") == f"ok channel 1 gets {signal}"
    assert show(line)["channels"][0]["signal"] == signal
    assert control(line, f"channel 1 {signal}") == f"ok channel 1 gets {signal}"


def test_power_commands_switch_power(line: SimulatedBoards) -> None:
    assert control(line, "power off") == "ok power off"
    assert show(line)["power"] is False
    assert control(line, "power on") == "ok power on"
    assert show(line)["power"] is True
    control(line, "power cycle")
    assert show(line)["counters"]["power_ups"] == 3


def test_load_and_current_commands_set_motor_current(line: SimulatedBoards) -> None:
    line.send(bytes.fromhex("C2 7F"))
    assert control(line, "load 1 6").startswith("ok")
    line.advance(3)
    assert show(line)["motors"][0]["current"] == pytest.approx(6, abs=0.3)
    assert control(line, "current 1 9.0").startswith("ok")
    assert show(line)["motors"][0]["current"] == pytest.approx(9)
    assert control(line, "current 1 auto").startswith("ok")
    line.advance(1)
    assert show(line)["motors"][0]["current"] == pytest.approx(6, abs=0.3)


@pytest.mark.parametrize(
    ("text", "fault", "value"),
    [
        *(("mute on", "mute", True), ("unplug", "plugged", False), ("noise 0.25", "noise", 0.25)),
        *(
            ("drop 3", "to_drop", 3),
            ("drop 2 sent", "to_drop_sent", 2),
            ("delay 0.5", "delay", 0.5),
        ),
        *(("corrupt 4", "to_corrupt", 4), ("double 5", "to_double", 5)),
    ],
)
def test_line_command_causes_line_fault(
    line: SimulatedBoards, text: str, fault: str, value: float
) -> None:
    assert control(line, f"line {text}").startswith("ok")
    assert getattr(line.faults, fault) == value


def test_line_commands_end_faults(line: SimulatedBoards) -> None:
    line.unplug()
    vars(line.faults).update(mute=True, noise=1.0, to_drop=9, to_corrupt=9, to_double=9, delay=9.0)
    for fault in ("mute off", "drop 0", "noise 0", "corrupt 0", "double 0", "delay 0", "plug"):
        assert control(line, f"line {fault}").startswith("ok")
    for text in ("line garbage 00ff", "line garbage 0A 0b"):
        assert control(line, text).startswith("ok 2 bytes")
    line.advance(1)
    assert line.receive() == bytes.fromhex("00 FF 0A 0B")


def test_line_echo_command_switches_echo(line: SimulatedBoards) -> None:
    for text, echo in (("on", True), ("off", False)):
        assert control(line, f"line echo {text}").startswith("ok")
        assert line.echo is echo


def test_battery_command_sets_voltage_and_resistance(line: SimulatedBoards) -> None:
    ohm = CONSTANTS["trex"].battery_resistance
    assert control(line, "battery 9") == f"ok battery 9 V, {ohm} ohm"
    assert control(line, "battery 7.5V 0.25") == "ok battery 7.5 V, 0.25 ohm"
    assert show(line)["battery"] == 7.5
    line.advance(0.01)
    assert show(line)["supply"] == 7.5


def test_eeprom_command_takes_effect_after_power_cycle(line: SimulatedBoards) -> None:
    assert control(line, "eeprom uart_settings 0x0A") == (
        "ok uart_settings is 10; takes effect after a power cycle"
    )
    assert show(line)["active_uart"]["baud"] == 19200
    control(line, "power cycle")
    assert show(line)["active_uart"]["baud"] == 115200


def test_power_on_with_empty_battery_is_explained(line: SimulatedBoards) -> None:
    control(line, "battery 2")
    line.advance(0.01)
    assert control(line, "power on").startswith("ok power on, but the battery is too low")
    assert show(line)["power"] is False


def test_prefix_selects_one_of_several_boards(two_boards: SimulatedBoards) -> None:
    assert control(two_boards, "@9 power off") == "ok power off"
    assert show(two_boards, "@7")["power"] is True
    assert show(two_boards, "@9")["power"] is False
    assert show(two_boards, "@9")["model"] == "trexjr"
    assert control(two_boards, "line mute on").startswith("ok")
    assert control(two_boards, "power off") == "error begin the line with a board: @7, @9"
    assert (
        control(two_boards, "@8 power off") == "error there is no board @8; the boards are @7, @9"
    )


def test_board_keeps_its_name_when_its_number_changes(two_boards: SimulatedBoards) -> None:
    two_boards.send(bytes.fromhex("80 09 2F 00 0C 55 2A"))
    two_boards.advance(1)
    assert show(two_boards, "@9")["parameters"]["device_number"] == 12


INVALID = {
    "": ("", "   ", "@7", "dance", "@8 show", "show all", "factory now", "quit now"),
    "channel ": (
        *("", "1", "0 1500us", "6 1500us", "² 1500us", "1 9V", "1 nan", "1 1500us noise"),
        *("1 1500us lost 2", "1 1500us noise 1V"),
    ),
    "battery ": ("", "-1", "25", "nan", "12 -1", "12 101", "12 0.1 x"),
    "eeprom ": (
        *("", "device_number", "device_number 128", "device_number seven", "warp_factor 9"),
        "factory_reset 127",
    ),
    "jumper ": ("", "mode turbo", "mix maybe"),
    "power ": ("", "up"),
    "load ": ("1", "3 1", "1 -1", "1 inf", "1 nan"),
    "current ": ("1 much",),
    "fault ": ("1", "1 maybe"),
    "line ": (
        *("", "error", "error noise", "error framing 10001", "error framing -1", "drop -1"),
        *("drop 1.5", "drop 99999999999", "noise 1.5", "noise nan", "delay 61", "double -1"),
        *("corrupt all", "echo", "garbage", "garbage 0", "garbage xy"),
    ),
}


@pytest.mark.parametrize("text", [word + rest for word in INVALID for rest in INVALID[word]])
def test_invalid_command_gives_one_line_error_and_no_change(
    line: SimulatedBoards, text: str
) -> None:
    before = report(line.boards[0])
    reply = control(line, text)
    assert reply.startswith("error ")
    assert "\n" not in reply
    assert len(reply) > 12
    assert report(line.boards[0]) == before


def test_quit_command_replies_goodbye(line: SimulatedBoards) -> None:
    assert control(line, " Quit ") == GOODBYE == "ok bye"


# --- The command `show` ---------------------------------------------------------------


def test_show_contains_fields_used_by_scripts() -> None:
    state = json.loads(json.dumps(report(Board("trexjr", "1.0", mode="rc"))))
    assert {
        "model", "firmware", "power", "mode", "serial_controls", "override", "safe_start",
        "motors", "aux", "channels", "parameters", "active_uart", "leds", "counters",
        "jumpers", "battery", "supply", "calibrations", "learned",
    } <= set(state)  # fmt: skip
    assert (state["model"], state["firmware"], state["mode"]) == ("trexjr", "1.0", "R")
    assert [set(motor) for motor in state["motors"]] == [
        {
            "direction", "speed", "target_direction", "target_speed", "current", "fault",
            "pwm_hz", "load", "stall", "rpm",
        }
    ] * 2  # fmt: skip
    assert state["channels"] == [{"raw": None, "remapped": 0, "signal": "rest"}] * 5
    assert state["jumpers"] == {"mode": "rc", "mix": False, "so_ground": False}
    assert (state["battery"], state["supply"]) == (12.0, 12.0)
    assert [motor["stall"] for motor in state["motors"]] == [5.0, 5.0]
    assert "uart_response_delay" not in state["parameters"]
    assert "factory_reset" not in state["parameters"]
    expected = {"baud": 19200, "parity": "none", "stop_bits": 1, "crc": False}
    assert state["active_uart"] == expected


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


def test_rc_mode_exchanges_leds() -> None:
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
    board.eeprom.write_calibration(InputSource.RC, 2, Calibration(2000, 3000, 4000, 50))
    board.power_cycle()
    flashes = []
    for _ in range(5):
        flashes.append(report(board)["leds"])
        board.advance(0.2)
        assert report(board)["leds"] == {"red": "off", "green": "off"}
        board.advance(0.1)
    red, green = {"red": "on", "green": "off"}, {"red": "off", "green": "on"}
    assert flashes == [red, green, red, red, red]


def test_leds_are_off_without_power(board: Board) -> None:
    board.power_off()
    assert report(board)["leds"] == {"red": "off", "green": "off"}


@pytest.mark.parametrize("number", [1, 2])
@pytest.mark.parametrize(
    ("prescaler", "maximum", "hertz"), [(0, 0x3F, 19531), (0, 0x7F, 9766), (3, 0x3F, 153)]
)
def test_prescaler_and_maximum_set_pwm_frequency_at_once(
    board: Board, port: SerialPort, number: int, prescaler: int, maximum: int, hertz: int
) -> None:
    before = report(board)["motors"][2 - number]["pwm_hz"]
    assert exchange(port, f"AF {8 + number:02X} {prescaler:02X} 55 2A") == "00"
    assert exchange(port, f"AF {10 + number:02X} {maximum:02X} 55 2A") == "00"
    assert report(board)["motors"][number - 1]["pwm_hz"] == pytest.approx(hertz, abs=0.6)
    assert report(board)["motors"][2 - number]["pwm_hz"] == before


def test_show_reports_motor_load_and_rpm(board: Board, port: SerialPort) -> None:
    board.physics[0].load = 4.0
    exchange(port, "C1 7F")
    board.advance(2)
    motor, other = report(board)["motors"]
    assert motor["load"] == 4.0
    assert -15_000 < motor["rpm"] < -10_000
    assert other["rpm"] == 0
    assert isinstance(motor["rpm"], int)


def test_show_reports_calibrations_and_learned_channels(board: Board) -> None:
    state = report(board)
    assert list(state["calibrations"]) == [
        f"{source}_channel_{channel}" for source in ("rc", "analog") for channel in range(1, 6)
    ]
    rc = {"minimum": 2500, "neutral": 3750, "maximum": 5000, "deadband": 75}
    assert state["calibrations"]["rc_channel_4"] == rc
    assert state["learned"] == {"rc": 0, "analog": 0}
    board.eeprom.write_calibration(InputSource.RC, 4, Calibration(2500, 3700, 5000, 75))
    assert report(board)["calibrations"]["rc_channel_4"] == {**rc, "neutral": 3700}
    assert report(board)["learned"] == {"rc": 0b01000, "analog": 0}
