import json
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from trex_gui.emulator.control import GOODBYE, control
from trex_gui.emulator.eeprom import Eeprom
from trex_gui.emulator.firmware import Board
from trex_gui.emulator.line import Line


def show(line: Line, name: str = "") -> dict[str, Any]:
    answer = control(line, f"{name} show")
    assert answer.startswith("ok ")
    shown: dict[str, Any] = json.loads(answer.removeprefix("ok "))
    return shown


@pytest.fixture
def two() -> Line:
    boards = []
    for number, model in ((7, "trex"), (9, "trexjr")):
        eeprom = Eeprom(model)
        eeprom.write("device_number", number)
        boards.append(Board(eeprom=eeprom))
    return Line(boards)


@pytest.mark.parametrize(
    ("text", "raw"),
    [
        ("channel 2 4000", 4000),
        ("channel 2 1600us", 4000),
        ("channel 2 1600 us", 4000),
        ("channel 2 invalid", None),
        ("  CHANNEL   2   INVALID  ", None),
    ],
)
def test_channels_are_set(line: Line, text: str, raw: int | None) -> None:
    assert control(line, text).startswith("ok")
    assert show(line)["channels"][1]["raw"] == raw


def test_voltages_are_set_where_they_are_measured(line: Line) -> None:
    line.boards[0].eeprom.write("channel_input_source", 1)
    control(line, "power cycle")
    assert control(line, "channel 5 2.5V") == "ok channel 5 reads 512"
    assert show(line)["mode"] == "a"


def test_jumpers(line: Line) -> None:
    assert control(line, "jumper mode rc").startswith("ok")
    assert show(line)["mode"] == "r"
    control(line, "power cycle")
    assert show(line)["mode"] == "R"
    control(line, "channel 2 1750us")
    assert show(line)["channels"][0]["remapped"] == 0
    assert control(line, "jumper mix on").startswith("ok")
    assert show(line)["channels"][0]["remapped"] > 0
    assert control(line, "jumper so-ground on").startswith("ok")
    assert line.boards[0].so_ground


def test_power(line: Line) -> None:
    assert control(line, "power off") == "ok power off"
    assert show(line)["power"] is False
    assert control(line, "power on") == "ok power on"
    assert show(line)["power"] is True
    control(line, "power cycle")
    assert show(line)["counters"]["power_ups"] == 3


def test_loads_and_currents(line: Line) -> None:
    line.send(bytes.fromhex("C2 7F"))
    assert control(line, "load 1 6").startswith("ok")
    line.advance(3)
    assert show(line)["motors"][0]["current"] == pytest.approx(6, abs=0.3)
    assert control(line, "current 1 9.0").startswith("ok")
    assert show(line)["motors"][0]["current"] == pytest.approx(9)
    assert control(line, "current 1 auto").startswith("ok")
    line.advance(1)
    assert show(line)["motors"][0]["current"] == pytest.approx(6, abs=0.3)


def test_faults(line: Line) -> None:
    assert control(line, "fault 2 on").startswith("ok")
    assert show(line)["motors"][1]["fault"] is True
    assert control(line, "fault 2 off").startswith("ok")
    assert show(line)["motors"][1]["fault"] is False


def test_faults_of_the_wire(line: Line) -> None:
    for text in ("line mute on", "line drop 3", "line drop 2 sent", "line noise 0.25"):
        assert control(line, text).startswith("ok")
    assert (line.mute, line.to_drop, line.to_drop_sent, line.noise) == (True, 3, 2, 0.25)
    control(line, "line mute off")
    control(line, "line drop 0")
    control(line, "line noise 0")
    for text in ("line garbage 00ff", "line garbage 0A 0b"):
        assert control(line, text).startswith("ok 2 bytes")
    line.advance(1)
    assert len(line.receive()) == 4
    assert control(line, "line unplug").startswith("ok")
    assert not line.plugged
    assert control(line, "line plug").startswith("ok")
    assert line.plugged


def test_show_counts_what_the_wire_did(line: Line) -> None:
    line.send(b"\x81")
    line.advance(1)
    counters = show(line)["counters"]
    assert (counters["bytes_sent"], counters["packets"]) == (7, 1)
    assert counters["line"]["received"] == 7


def test_one_of_several_boards_is_named(two: Line) -> None:
    assert control(two, "@9 power off") == "ok power off"
    assert show(two, "@7")["power"] is True
    assert show(two, "@9")["power"] is False
    assert show(two, "@9")["model"] == "trexjr"
    assert control(two, "line mute on").startswith("ok")
    assert control(two, "power off") == "error say which board first: @7, @9"
    assert control(two, "@8 power off") == "error there is no board @8, but @7, @9"


def test_a_board_keeps_its_name_when_its_number_changes(two: Line) -> None:
    two.send(bytes.fromhex("80 09 2F 00 0C 55 2A"))
    two.advance(1)
    assert show(two, "@9")["parameters"]["device_number"] == 12


@pytest.mark.parametrize(
    "text",
    [
        "",
        "   ",
        "@7",
        "dance",
        "@8 show",
        "show all",
        "channel",
        "channel 1",
        "channel 0 1500us",
        "channel 6 1500us",
        "channel ² 1500us",
        "channel 1 9V",
        "channel 1 nan",
        "jumper",
        "jumper mode turbo",
        "jumper mix maybe",
        "power",
        "power up",
        "load 1",
        "load 3 1",
        "load 1 -1",
        "load 1 inf",
        "load 1 nan",
        "current 1 much",
        "fault 1",
        "fault 1 maybe",
        "line",
        "line drop -1",
        "line drop 1.5",
        "line drop 99999999999",
        "line noise 1.5",
        "line noise nan",
        "line garbage",
        "line garbage 0",
        "line garbage xy",
        "quit now",
    ],
)
def test_what_makes_no_sense_gives_one_line_that_says_why(line: Line, text: str) -> None:
    before = line.boards[0].show()
    answer = control(line, text)
    assert answer.startswith("error ")
    assert "\n" not in answer
    assert len(answer) > 12
    assert line.boards[0].show() == before


def test_quit_is_answered(line: Line) -> None:
    assert control(line, " Quit ") == GOODBYE == "ok bye"


COMMANDS = ["channel", "jumper", "power", "load", "current", "fault", "line", "show", "@7", "@9"]
DETAILS = ["1", "5", "-1", "1e9", "on", "off", "cycle", "auto", "mode", "mix", "rc", "mute", "drop"]
MORE = ["garbage", "noise", "unplug", "plug", "00", "ff", "0.5", "1500us", "2.5V", "silent"]
words = st.sampled_from(COMMANDS + DETAILS + MORE)


@given(text=st.text(max_size=40) | st.lists(words, max_size=5).map(" ".join))
def test_no_control_line_makes_it_raise(text: str) -> None:
    line = Line([Board()])
    answer = control(line, text)
    assert answer.startswith(("ok", "error "))
    assert "\n" not in answer
    line.advance(0.05)
