"""The command `provision`."""

import csv
from pathlib import Path

import pytest

from tests.devices.trex.cli.conftest import changed
from tests.devices.trex.conftest import STOPPED, motor
from tests.support.library_program import Program
from tests.support.simulator import SimulatedDevice, StartSimulator
from tests.support.virtual_command import RunCommand, StartCommand, VirtualCommand
from tests.support.virtual_time import VirtualRuntime
from trex_gui import Trex
from trex_gui.core.errors import BadRequest
from trex_gui.devices.trex.cli.provision import pulse
from trex_gui.devices.trex.settings.provision_record import ProvisionedBoard, ProvisionRecord


@pytest.fixture
def profile(saved: Path) -> Path:
    """Profile that differs from a new board in two parameters."""
    return changed(saved, serial_timeout=5, motor1_acceleration=20)


def rows_of(file: Path) -> list[dict[str, str]]:
    with file.open(newline="", encoding="utf-8") as stream:
        return list(csv.DictReader(stream))


class ProvisionHarness:
    """Cable to which new boards are connected in turn, and the record of these boards."""

    def __init__(self, board: SimulatedDevice, start: StartCommand, profile: Path) -> None:
        self.board = board
        self.record = profile.with_name("record.csv")
        self._start, self._profile = start, profile

    @property
    def rows(self) -> list[dict[str, str]]:
        return rows_of(self.record) if self.record.exists() else []

    def start_command(self, keys: str, *options: str) -> VirtualCommand:
        words = "provision", str(self._profile), "--record", str(self.record)
        return self._start(*words, "--limit", str(len(keys)), *options, stdin=keys)

    def wait_for_rows(self, runtime: VirtualRuntime, count: int) -> None:
        """Wait until this many boards have a result."""
        assert runtime.run_until(
            lambda: len(self.rows) == count and self.rows[-1]["result"] != "begun", 60
        )

    def connect_new_board(self, runtime: VirtualRuntime) -> None:
        self.board.do("power off")
        runtime.run_until(lambda: False, 8)
        self.board.do("factory", "power on")


@pytest.fixture
def harness(
    quick_simulator: SimulatedDevice, start: StartCommand, profile: Path
) -> ProvisionHarness:
    return ProvisionHarness(quick_simulator, start, profile)


def test_each_board_is_provisioned_with_one_key_press(
    virtual_time: VirtualRuntime, harness: ProvisionHarness
) -> None:
    command = harness.start_command("\r" * 5, "--first", "5")
    for count in range(1, 6):
        harness.wait_for_rows(virtual_time, count)
        stored = harness.board.show()["parameters"]
        assert (stored["serial_timeout"], stored["motor1_acceleration"]) == (5, 20)
        harness.connect_new_board(virtual_time)
    assert command.wait() == 0, command.result.output
    rows = harness.rows
    assert [row["number"] for row in rows] == ["5", "6", "8", "9", "10"], "new boards have 7"
    assert [row["name"] for row in rows][:2] == ["robot 5", "robot 6"]
    assert {row["result"] for row in rows} == {"ok"}
    assert {row["certainty"] for row in rows} == {"new"}
    assert rows[0]["differences"] == "serial_timeout motor1_acceleration device_number"
    assert rows[0]["board"] == "TReX 1.2"


def test_known_board_keeps_number_and_name(harness: ProvisionHarness) -> None:
    assert harness.start_command("\r", "--name", "arm {number}").wait() == 0
    assert harness.rows[-1]["name"] == "arm 1"
    assert harness.start_command("s").wait() == 0
    row = harness.rows[-1]
    assert (row["name"], row["number"]) == ("arm 1", "1")
    assert (row["result"], row["certainty"]) == ("skipped", "known")
    assert not row["differences"]


def test_board_of_another_model_is_skipped(
    start: StartCommand, start_simulator: StartSimulator, profile: Path
) -> None:
    words = "provision", str(profile), "--record", str(profile.with_name("record.csv"))
    command = start(*words, "--limit", "1", url=start_simulator("--model", "trexjr").url)
    assert command.wait() == 0
    assert "are for a TReX, not a TReX Jr" in command.result.stderr
    assert rows_of(profile.with_name("record.csv")) == []


def test_nothing_is_written_when_the_user_quits(
    trexcmd: RunCommand, quick_simulator: SimulatedDevice, profile: Path, tmp_path: Path
) -> None:
    before = quick_simulator.show()["parameters"]
    record = tmp_path / "record.csv"
    result = trexcmd("provision", str(profile), "--record", str(record), stdin="q")
    assert "Serial Timeout: off -> 0.5 s" in result.stderr
    assert quick_simulator.show()["parameters"] == before
    assert rows_of(record) == []


def test_file_that_is_no_record_is_not_overwritten(
    trexcmd: RunCommand, quick_simulator: SimulatedDevice, profile: Path, tmp_path: Path
) -> None:
    record = tmp_path / "record.csv"
    record.write_text("my,table\n1,2\n", "utf-8")
    result = trexcmd("provision", str(profile), "--record", str(record), exits=1)
    assert "is not a record of boards" in result.stderr
    assert record.read_text("utf-8") == "my,table\n1,2\n"
    head = "time,name,number,board,calibrations,differences,result,certainty\n"
    record.write_text(f"{head}now,robot,seven,TReX,,,ok,new\n", "utf-8")
    assert "damaged" in trexcmd("provision", str(profile), "--record", str(record), exits=1).stderr


def test_skipped_board_reserves_no_number(
    virtual_time: VirtualRuntime, harness: ProvisionHarness
) -> None:
    command = harness.start_command("s\r\r")
    for count in (1, 2, 3):
        harness.wait_for_rows(virtual_time, count)
        harness.connect_new_board(virtual_time)
    assert command.wait() == 0, command.result.output
    found = [(row["name"], row["number"], row["result"]) for row in harness.rows]
    assert found == [("robot 1", "7", "skipped"), ("robot 1", "1", "ok"), ("robot 2", "2", "ok")]
    assert {row["certainty"] for row in harness.rows} == {"new"}


def test_number_of_a_board_lost_while_writing_stays_reserved(
    virtual_time: VirtualRuntime, harness: ProvisionHarness
) -> None:
    command = harness.start_command("\r")
    assert virtual_time.run_until(
        lambda: harness.board.show()["parameters"]["serial_timeout"] == 5, 60
    )
    harness.board.do("power off")
    assert command.wait() == 0, command.result.output
    (row,) = harness.rows
    assert row["number"] == "1"
    assert row["result"] not in {"ok", "begun"}
    assert ProvisionRecord(harness.record).free_number() == 2


def test_record_that_another_program_changed_is_not_overwritten(tmp_path: Path) -> None:
    file = tmp_path / "record.csv"
    first, second = ProvisionRecord(file), ProvisionRecord(file)
    board = ProvisionedBoard("now", "robot 1", 1, "TReX 1.2", "", "", "ok", "new")
    first.add(board)
    first.save()
    second.add(board)
    with pytest.raises(BadRequest, match="Another program"):
        second.save()
    assert len(rows_of(file)) == 1


def test_motor_turns_only_while_space_is_held(
    virtual_time: VirtualRuntime, quick_simulator: SimulatedDevice
) -> None:
    key, results = "", []

    def run() -> None:
        with Trex(quick_simulator.url) as trex:
            results.append(pulse(trex, 1, lambda: key))

    program = Program(virtual_time, run)
    virtual_time.run_until(lambda: False, 3)
    key = "x"
    virtual_time.run_until(lambda: False, 1)
    assert motor(quick_simulator)[0] != "forward", "another key does not drive"
    key = " "
    program.until(lambda: motor(quick_simulator) == ("forward", 30))
    virtual_time.run_until(lambda: False, 2)
    assert motor(quick_simulator) == ("forward", 30)
    key, released = "", virtual_time.now()
    program.until(lambda: motor(quick_simulator) == STOPPED)
    assert virtual_time.now() - released < 0.5
    assert not program.has_ended
    key = "q"
    program.end()
    assert results == [False], "the next motor is not tried"
