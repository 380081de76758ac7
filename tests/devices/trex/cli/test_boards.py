"""Commands for several boards on one line."""

import json
from pathlib import Path

import pytest

from tests.support.simulator import StartSimulator
from tests.support.virtual_command import RunCommand, StartCommand
from tests.support.virtual_devices import VirtualSimulator
from tests.support.virtual_time import VirtualRuntime
from trex_gui.core.files import save

EXPANDED = ("--protocol", "expanded", "--device", "7")


@pytest.fixture
def line(start_simulator: StartSimulator) -> VirtualSimulator:
    """Boards 3, 7 and 9. Board 9 is a TReX Jr."""
    options = [word for board in ("3", "7", "9:trexjr") for word in ("--device", board)]
    started = start_simulator("--unpaced", *options)
    assert isinstance(started, VirtualSimulator)
    return started


@pytest.fixture
def run(start: StartCommand, line: VirtualSimulator) -> RunCommand:
    return lambda *words, exits=0: start(*words, url=line.url).ends(exits)


def stored(line: VirtualSimulator, key: str) -> list[int]:
    return [line.show(name)["parameters"][key] for name in ("@3", "@7", "@9")]


def test_boards_lists_each_device_number(run: RunCommand, line: VirtualSimulator) -> None:
    before = line.show("@7")["motors"]
    result = run("boards", "--json")
    found = json.loads(result.stdout)
    assert [(row["device_number"], row["product"], row["firmware"]) for row in found] == [
        (3, "TReX", "1.2"),
        (7, "TReX", "1.2"),
        (9, "TReX Jr", "1.2"),
    ]
    assert found[0]["options"].endswith("--protocol expanded --device 3")
    text = run("boards").stdout.splitlines()
    assert text[2].startswith("9\tTReX Jr 1.2\t--port ")
    assert line.show("@7")["motors"] == before
    for name in ("@3", "@7", "@9"):
        line.do(f"{name} power off")
    assert "No board replies to a device number" in run("boards", exits=1).stderr


@pytest.mark.parametrize("command", ["list", "list --device 5", "boards", "status"])
def test_reserved_number_gets_no_packet(
    run: RunCommand, line: VirtualSimulator, command: str
) -> None:
    sent = bytearray()
    line.on_write = sent.extend
    result = run(*command.split(), "--reserve", "0,3")
    assert {byte for byte in sent if byte > 0x7F} == {0x80}
    assert not {0, 3} & {packet[0] for packet in sent.split(b"\x80")[1:]}
    options = "--protocol expanded --device 7 --reserve 0,3"
    assert command != "boards" or options in result.stdout


def test_command_without_a_number_names_the_list_of_boards(
    run: RunCommand, line: VirtualSimulator
) -> None:
    result = run("set", "serial_timeout", "7", exits=1)
    assert "Several boards reply at once" in result.stderr
    assert "`trexcmd boards` prints the options that reach each board." in result.stderr
    assert stored(line, "serial_timeout") == [0, 0, 0]


def test_identical_boards_with_merged_replies_are_not_driven(
    start: StartCommand, start_simulator: StartSimulator
) -> None:
    boards = start_simulator("--unpaced", "--device", "9", "--device", "12")
    for words in (("motor", "1", "20", "--seconds", "1"), ("set", "serial_timeout", "7")):
        errors = start(*words, url=boards.url).ends(1).stderr
        assert "Several boards reply at once" in errors
    for name in ("@9", "@12"):
        assert boards.show(name)["motors"][0]["direction"] == "brake"
        assert boards.show(name)["parameters"]["serial_timeout"] == 0


def test_number_of_another_board_is_not_stored(run: RunCommand, line: VirtualSimulator) -> None:
    result = run("set", *EXPANDED, "device_number", "9", exits=1)
    assert "Another board on this line has the device number 9" in result.stderr
    assert stored(line, "device_number") == [3, 7, 9]
    run("set", *EXPANDED, "device_number", "12")
    assert stored(line, "device_number") == [3, 12, 9]


def test_reset_to_the_number_of_another_board_is_rejected(
    run: RunCommand, line: VirtualSimulator
) -> None:
    line.do("@3 eeprom serial_timeout 9")
    board_3 = ("--device", "3")  # implies the expanded protocol
    result = run("restore-defaults", "--yes", *board_3, exits=1)
    assert "Another board on this line has the device number 7" in result.stderr
    line.do("@3 power cycle")
    assert stored(line, "serial_timeout") == [9, 0, 0]
    run("set", *EXPANDED, "device_number", "12")
    run("restore-defaults", "--yes", *board_3)
    line.do("@3 power cycle")
    assert stored(line, "device_number") == [7, 12, 9]


def test_file_is_written_to_several_boards(
    run: RunCommand, line: VirtualSimulator, tmp_path: Path
) -> None:
    path = tmp_path / "fleet.txt"
    save(path, "product: TReX\ndevice_number: 55\nuart_settings: 10\nserial_timeout: 7\n")
    # Every board is checked before the first board is written to.
    result = run("set-settings", str(path), "--devices", "3,7,9", exits=1)
    assert "the board is a TReX Jr" in result.stderr
    assert stored(line, "serial_timeout") == [0, 0, 0]

    result = run("set-settings", str(path), "--devices", "3,7", "--dry-run")
    assert result.stdout.count("serial_timeout") == 2
    assert stored(line, "serial_timeout") == [0, 0, 0]

    result = run("set-settings", str(path), "--devices", "3,7")
    assert result.stderr.count("1 of 1 change stored and verified.") == 2
    assert stored(line, "serial_timeout") == [7, 7, 0]
    assert stored(line, "device_number") == [3, 7, 9]
    assert stored(line, "uart_settings") == [5, 5, 5]


def test_motors_of_several_boards_run_and_stop(
    virtual_time: VirtualRuntime, start: StartCommand, run: RunCommand, line: VirtualSimulator
) -> None:
    def directions() -> list[str]:
        return [line.show(name)["motors"][0]["direction"] for name in ("@3", "@7", "@9")]

    command = start("motor", "1", "40", "--boards", "7,9", "--seconds", "1", url=line.url)
    assert virtual_time.run_until(lambda: directions()[1:] == ["forward"] * 2, 30)
    command.ends(0)
    assert directions()[1:] == ["brake"] * 2
    for name in ("@7", "@9"):
        line.do(f"{name} jumper mode serial")
    result = run("stop", "--boards", "7,9")
    assert "Stopped." in result.stderr
    line.do("@9 power off")
    assert "Board 9: " in run("stop", "--boards", "7,9", exits=1).stderr
    assert "Board 9: " in run("motor", "1", "40", "--boards", "7,9", exits=1).stderr
    assert "--boards" in run("motor", "1", "40", "--boards", "7", exits=2).stderr
