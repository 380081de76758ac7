import json
from typing import Any

import pytest

from trex_gui.core.simulator.control_lines import GOODBYE
from trex_gui.devices.trex.simulator.command import SIMULATOR
from trex_gui.devices.trex.simulator.control import control, report
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.line import TrexLine
from trex_gui.devices.trex.simulator.memory import Eeprom
from trex_gui.devices.trex.simulator.physics import CONSTANTS


def show(line: TrexLine, name: str = "") -> dict[str, Any]:
    answer = control(line, f"{name} show")
    assert answer.startswith("ok ")
    shown: dict[str, Any] = json.loads(answer.removeprefix("ok "))
    return shown


@pytest.fixture
def two() -> TrexLine:
    boards = []
    for number, model in ((7, "trex"), (9, "trexjr")):
        eeprom = Eeprom(model)
        eeprom.write("device_number", number)
        boards.append(Board(eeprom=eeprom))
    return TrexLine(boards)


def test_help_lists_every_control_line() -> None:
    listed = SIMULATOR.help.partition("Control lines: ")[2].partition(";")[0]
    known = control(TrexLine([Board()]), "nosuch").partition("commands are ")[2]
    assert set(listed.split(", ")) == set(known.split(", "))


@pytest.mark.parametrize(
    ("text", "signal"),
    [
        ("1500us", "1500us"),
        ("3750", "1500us"),
        ("Silent", "silent"),
        ("1500us noise 2us", "1500us noise 2us"),
        ("1500us noise 2us lost 0.1", "1500us noise 2us lost 0.1"),
        ("1500us lost 1", "1500us lost 1"),
        ("2.5v noise 20mv", "2.5V noise 0.02V"),
    ],
)
def test_reply_and_show_state_channel_signal(line: TrexLine, text: str, signal: str) -> None:
    assert control(line, f"channel 1 {text}") == f"ok channel 1 gets {signal}"
    assert show(line)["channels"][0]["signal"] == signal
    assert control(line, f"channel 1 {signal}") == f"ok channel 1 gets {signal}"


def test_power_commands_switch_power(line: TrexLine) -> None:
    assert control(line, "power off") == "ok power off"
    assert show(line)["power"] is False
    assert control(line, "power on") == "ok power on"
    assert show(line)["power"] is True
    control(line, "power cycle")
    assert show(line)["counters"]["power_ups"] == 3


def test_load_and_current_commands_set_motor_current(line: TrexLine) -> None:
    line.send(bytes.fromhex("C2 7F"))
    assert control(line, "load 1 6").startswith("ok")
    line.advance(3)
    assert show(line)["motors"][0]["current"] == pytest.approx(6, abs=0.3)
    assert control(line, "current 1 9.0").startswith("ok")
    assert show(line)["motors"][0]["current"] == pytest.approx(9)
    assert control(line, "current 1 auto").startswith("ok")
    line.advance(1)
    assert show(line)["motors"][0]["current"] == pytest.approx(6, abs=0.3)


def test_line_commands_cause_line_faults(line: TrexLine) -> None:
    for text in ("line mute on", "line drop 3", "line drop 2 sent", "line noise 0.25"):
        assert control(line, text).startswith("ok")
    assert (line.faults.mute, line.faults.to_drop, line.faults.to_drop_sent, line.faults.noise) == (
        True,
        3,
        2,
        0.25,
    )
    control(line, "line mute off")
    control(line, "line drop 0")
    control(line, "line noise 0")
    for text in ("line corrupt 4", "line double 5", "line delay 0.5", "line echo on"):
        assert control(line, text).startswith("ok")
    assert (line.faults.to_corrupt, line.faults.to_double, line.faults.delay, line.echo) == (
        4,
        5,
        0.5,
        True,
    )
    for text in ("line corrupt 0", "line double 0", "line delay 0", "line echo off"):
        control(line, text)
    for text in ("line garbage 00ff", "line garbage 0A 0b"):
        assert control(line, text).startswith("ok 2 bytes")
    line.advance(1)
    assert len(line.receive()) == 4
    assert control(line, "line unplug").startswith("ok")
    assert not line.faults.plugged
    assert control(line, "line plug").startswith("ok")
    assert line.faults.plugged


def test_battery_command_sets_voltage_and_resistance(line: TrexLine) -> None:
    ohm = CONSTANTS["trex"].battery_resistance
    assert control(line, "battery 9") == f"ok battery 9 V, {ohm} ohm"
    assert control(line, "battery 7.5V 0.25") == "ok battery 7.5 V, 0.25 ohm"
    assert show(line)["battery"] == 7.5
    line.advance(0.01)
    assert show(line)["supply"] == 7.5


def test_eeprom_command_takes_effect_after_power_cycle(line: TrexLine) -> None:
    assert control(line, "eeprom uart_settings 0x0A") == (
        "ok uart_settings is 10; power cycle to use it"
    )
    assert show(line)["active_uart"]["baud"] == 19200
    control(line, "power cycle")
    assert show(line)["active_uart"]["baud"] == 115200


def test_power_on_with_empty_battery_is_explained(line: TrexLine) -> None:
    control(line, "battery 2")
    line.advance(0.01)
    assert control(line, "power on").startswith("ok power on, but the battery is too low")
    assert show(line)["power"] is False


def test_show_reports_line_state(line: TrexLine) -> None:
    assert show(line)["line"] == {"plugged": True, "mute": False, "noise": 0.0}
    for text in ("line unplug", "line mute on", "line noise 0.5"):
        control(line, text)
    assert show(line)["line"] == {"plugged": False, "mute": True, "noise": 0.5}


def test_show_reports_line_counters(line: TrexLine) -> None:
    line.send(b"\x81")
    line.advance(1)
    counters = show(line)["counters"]
    assert (counters["bytes_sent"], counters["packets"]) == (7, 1)
    assert counters["line"]["received"] == 7


def test_prefix_selects_one_of_several_boards(two: TrexLine) -> None:
    assert control(two, "@9 power off") == "ok power off"
    assert show(two, "@7")["power"] is True
    assert show(two, "@9")["power"] is False
    assert show(two, "@9")["model"] == "trexjr"
    assert control(two, "line mute on").startswith("ok")
    assert control(two, "power off") == "error say which board first: @7, @9"
    assert control(two, "@8 power off") == "error there is no board @8, but @7, @9"


def test_board_keeps_its_name_when_its_number_changes(two: TrexLine) -> None:
    two.send(bytes.fromhex("80 09 2F 00 0C 55 2A"))
    two.advance(1)
    assert show(two, "@9")["parameters"]["device_number"] == 12


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
def test_invalid_command_gives_one_line_error_and_no_change(line: TrexLine, text: str) -> None:
    before = report(line.boards[0])
    answer = control(line, text)
    assert answer.startswith("error ")
    assert "\n" not in answer
    assert len(answer) > 12
    assert report(line.boards[0]) == before


def test_quit_command_replies_goodbye(line: TrexLine) -> None:
    assert control(line, " Quit ") == GOODBYE == "ok bye"
