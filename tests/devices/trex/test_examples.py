"""Example programs in `resources/examples` on simulated boards."""

import io
import json
import runpy
import subprocess
import sys
import time
from contextlib import redirect_stdout
from pathlib import Path
from queue import SimpleQueue

import click
import pytest
from mcap.reader import make_reader

from tests.devices.trex.conftest import STOPPED, motor, target_speeds
from tests.support.library_program import Program
from tests.support.simulator import SimulatedDevice, StartSimulator
from tests.support.virtual_time import VirtualRuntime
from trex_gui import Trex
from trex_gui.core.resource_files import resource
from trex_gui.devices.trex.settings.history import SettingsHistory

EXAMPLES = resource("examples")


class Example(Program):
    """Example program that runs beside the test."""

    def __init__(self, runtime: VirtualRuntime, name: str, *arguments: str) -> None:
        self.output = io.StringIO()
        path = str(EXAMPLES / f"{name}.py")

        def run() -> None:
            saved, sys.argv = sys.argv, [path, *arguments]
            try:
                with redirect_stdout(self.output):
                    runpy.run_path(path, run_name="__main__")
            finally:
                sys.argv = saved

        super().__init__(runtime, run)

    @property
    def text(self) -> str:
        return self.output.getvalue()


def run(runtime: VirtualRuntime, name: str, *arguments: object) -> str:
    """Run an example to its end and return its output."""
    example = Example(runtime, name, *map(str, arguments))
    example.end()
    return example.text


def run_to_exit(runtime: VirtualRuntime, name: str, *arguments: object) -> tuple[str, object]:
    """Run an example that exits. Return its output and exit code."""
    example = Example(runtime, name, *map(str, arguments))
    with pytest.raises(SystemExit) as exit_:
        example.end()
    return example.text, exit_.value.code


@pytest.fixture
def profile(virtual_time: VirtualRuntime, quick_simulator: SimulatedDevice, tmp_path: Path) -> Path:
    """Settings file that differs from the simulated board in one parameter."""
    file = tmp_path / "profile.txt"

    def save() -> None:
        with Trex(quick_simulator.url) as trex:
            trex.save_settings(file)

    Program(virtual_time, save).end()
    text = file.read_text("utf-8")
    assert text.count("serial_timeout: 0") == 1
    file.write_text(text.replace("serial_timeout: 0", "serial_timeout: 5"), "utf-8")
    return file


def test_status_is_printed(virtual_time: VirtualRuntime, quick_simulator: SimulatedDevice) -> None:
    quick_simulator.do("channel 2 1250us")
    assert virtual_time.run_until(lambda: quick_simulator.show()["channels"][1]["raw"] == 3125, 1)
    text = run(virtual_time, "read_status", quick_simulator.url)
    assert text.startswith("TReX 1.2: Serial mode, with inputs read as RC pulses.\n")
    assert "Currents: 0.00 A, 0.00 A\n" in text
    assert "Channel 2: 1250.0, remapped -59" in text
    assert "Errors: none\nSerial timeout: off\n" in text


def test_currents_are_logged(
    virtual_time: VirtualRuntime, quick_simulator: SimulatedDevice
) -> None:
    quick_simulator.do("current 2 3.0")
    rows = run(virtual_time, "log_currents", quick_simulator.url, 1).splitlines()
    assert rows[0] == "time_s,motor_1_current_A,motor_2_current_A"
    assert len(rows) > 20
    assert rows[-1].endswith(",0.0,3.0")


def test_channel_is_calibrated(
    virtual_time: VirtualRuntime, quick_simulator: SimulatedDevice
) -> None:
    quick_simulator.do("channel 1 1510us")
    example = Example(virtual_time, "calibrate", quick_simulator.url, "1")
    example.until(lambda: "both ends" in example.text)
    for pulse in ("1100us", "1900us"):
        quick_simulator.do(f"channel 1 {pulse}")
        virtual_time.run_until(lambda: False, 1)
    example.end()
    assert "Stored: Calibration(minimum=2750, neutral=3775, maximum=4750" in example.text


def test_parameters_are_stored_after_a_snapshot(
    virtual_time: VirtualRuntime, quick_simulator: SimulatedDevice
) -> None:
    text = run(virtual_time, "set_parameters", quick_simulator.url)
    assert "serial_timeout: 0.5 s\n" in text
    assert "2 changed." in text
    assert quick_simulator.show()["parameters"]["serial_timeout"] == 5
    (snapshot,) = SettingsHistory().snapshots()
    assert snapshot.reason == "library: serial_timeout, motor1_acceleration"
    assert run(virtual_time, "set_parameters", quick_simulator.url) == "0 changed.\n"
    assert len(SettingsHistory().snapshots()) == 1


def test_motor_is_driven_and_stopped(
    virtual_time: VirtualRuntime, quick_simulator: SimulatedDevice
) -> None:
    example = Example(virtual_time, "drive", quick_simulator.url, "60")
    example.until(lambda: motor(quick_simulator) == ("forward", 60))
    start = virtual_time.now()
    example.until(lambda: motor(quick_simulator) == STOPPED)
    assert 1.8 < virtual_time.now() - start < 2.2
    example.end()
    assert example.text == "The board has confirmed the stop.\n"


def test_profile_is_applied_to_board_that_differs(
    virtual_time: VirtualRuntime, quick_simulator: SimulatedDevice, profile: Path
) -> None:
    text = run(virtual_time, "apply_profile", quick_simulator.url, profile)
    assert text == "Serial Timeout: off -> 0.5 s\n1 written and read back.\n"
    assert quick_simulator.show()["parameters"]["serial_timeout"] == 5
    text = run(virtual_time, "apply_profile", quick_simulator.url, profile)
    assert text == "0 written and read back.\n"


def test_boards_are_audited(
    virtual_time: VirtualRuntime,
    quick_simulator: SimulatedDevice,
    start_simulator: StartSimulator,
    profile: Path,
) -> None:
    jr = start_simulator("--model", "trexjr")
    text, code = run_to_exit(virtual_time, "audit", profile, quick_simulator.url, jr.url)
    assert code == 1
    lines = text.splitlines()
    assert lines[0] == f"{quick_simulator.url}: serial_timeout"
    assert lines[1].endswith("These settings are for a TReX, not a TReX Jr")
    run(virtual_time, "apply_profile", quick_simulator.url, profile)
    text, code = run_to_exit(virtual_time, "audit", profile, quick_simulator.url)
    assert code == 0
    assert text.endswith(": as the file\n")


def test_stop_reasons_and_errors_are_explained(
    virtual_time: VirtualRuntime, quick_simulator: SimulatedDevice
) -> None:
    example = Example(virtual_time, "explain", quick_simulator.url)
    quick_simulator.do("fault 1 on")
    example.end()
    assert "- Motor 1 fault" in example.text
    assert "shut itself down" in example.text


def test_parameters_are_listed(
    virtual_time: VirtualRuntime, quick_simulator: SimulatedDevice
) -> None:
    lines = run(virtual_time, "list_parameters", quick_simulator.url).splitlines()
    assert len(lines) == 28
    assert [line.split() for line in lines if line.startswith("serial_timeout")] == [
        ["serial_timeout", "0", "off"]
    ]


def test_measurements_are_logged_as_mcap(
    virtual_time: VirtualRuntime, quick_simulator: SimulatedDevice, tmp_path: Path
) -> None:
    quick_simulator.do("current 2 3.0")
    run(virtual_time, "log_mcap", quick_simulator.url, 1, tmp_path / "log.mcap")
    with (tmp_path / "log.mcap").open("rb") as stream:
        messages = make_reader(stream).iter_messages()
        rows = [json.loads(message.data) for _, _, message in messages]
    assert len(rows) > 20
    assert rows[-1]["motor_2_current_A"] == 3.0


def test_lost_settings_are_recovered(
    virtual_time: VirtualRuntime, quick_simulator: SimulatedDevice
) -> None:
    run(virtual_time, "set_parameters", quick_simulator.url)
    quick_simulator.do("factory")
    text = run(virtual_time, "recover", quick_simulator.url)
    assert "Serial Timeout is off, and 0.5 s was applied.\n" in text
    assert text.endswith("2 restored.\n")
    assert quick_simulator.show()["parameters"]["serial_timeout"] == 5


def test_last_change_is_undone(
    virtual_time: VirtualRuntime, quick_simulator: SimulatedDevice, monkeypatch: pytest.MonkeyPatch
) -> None:
    run(virtual_time, "set_parameters", quick_simulator.url)
    monkeypatch.setattr("builtins.input", lambda _: "n")
    text = run(virtual_time, "undo", quick_simulator.url)
    assert text.startswith("Before 'library: serial_timeout, motor1_acceleration' at ")
    assert "Serial Timeout: 0.5 s -> off\n" in text
    assert quick_simulator.show()["parameters"]["serial_timeout"] == 5
    monkeypatch.setattr("builtins.input", lambda _: "y")
    assert run(virtual_time, "undo", quick_simulator.url).endswith("2 restored.\n")
    assert quick_simulator.show()["parameters"]["serial_timeout"] == 0


def test_drive_is_replayed_from_csv(
    virtual_time: VirtualRuntime, quick_simulator: SimulatedDevice, tmp_path: Path
) -> None:
    file = tmp_path / "drive.csv"
    file.write_text("time_s,motor_1,motor_2\n0,40,-40\n1.0,60,60\n2.0,0,0\n", "utf-8")
    example = Example(virtual_time, "replay_drive", quick_simulator.url, str(file))
    example.until(lambda: motor(quick_simulator, 2) == ("reverse", 40))
    example.until(lambda: motor(quick_simulator) == ("forward", 60))
    example.end()
    assert motor(quick_simulator) == STOPPED


def test_keys_of_a_terminal_drive_the_motors(
    virtual_time: VirtualRuntime,
    quick_simulator: SimulatedDevice,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    keys = SimpleQueue[str]()
    monkeypatch.setattr(click, "getchar", keys.get)
    example = Example(virtual_time, "teleoperate", quick_simulator.url)

    def press(key: str, state: tuple[str, int]) -> None:
        keys.put(key)
        example.until(lambda: motor(quick_simulator) == state)

    press("w", ("forward", 40))
    press("a", ("reverse", 30))
    press(" ", STOPPED)
    keys.put("wwwww q")
    keys.put("q")
    example.end()
    assert motor(quick_simulator) == STOPPED


def test_example_waits_for_line_in_use(
    virtual_time: VirtualRuntime,
    quick_simulator: SimulatedDevice,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(time, "sleep", virtual_time.sleep)

    def hold_line() -> None:
        with Trex(quick_simulator.url) as trex:
            trex.wait(5)

    other = Program(virtual_time, hold_line)
    virtual_time.run_until(lambda: False, 1)
    text = run(virtual_time, "wait_for_line", quick_simulator.url)
    assert "is in use by another program" in text.splitlines()[0]
    assert text.endswith("TReX: the line is free.\n")
    other.end()


@pytest.mark.realtime
def test_program_is_tested_with_a_simulated_board() -> None:
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", "-p", "no:randomly"]
    result = subprocess.run(
        [*command, "--rootdir", str(EXAMPLES), str(EXAMPLES / "test_robot.py")],
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )
    assert "2 passed" in result.stdout, result.stdout + result.stderr


def test_every_example_is_tested() -> None:
    files = Path(__file__), Path(__file__).parent / "serve" / "test_network.py"
    text = "".join(file.read_text("utf-8") for file in files)
    names = [path.stem for path in EXAMPLES.glob("*.py")]
    assert len(names) >= 15
    assert [name for name in names if f'"{name}"' not in text and f"{name}.py" not in text] == []


def test_two_boards_are_driven_on_one_line(
    virtual_time: VirtualRuntime, start_simulator: StartSimulator
) -> None:
    boards = start_simulator("--unpaced", "--device", "7", "--device", "9")
    example = Example(virtual_time, "drive_two", boards.url, "40")
    example.until(lambda: target_speeds(boards) == [40, 40])
    example.until(lambda: target_speeds(boards) == [40, 0])
    example.end()
    assert "confirmed" in example.text
