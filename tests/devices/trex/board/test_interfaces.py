"""Window, command line and library save the same files."""

import re
from collections.abc import Callable
from functools import partial
from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot
from serial.tools import list_ports
from serial.tools.list_ports_common import ListPortInfo

from tests.support.library_program import Program
from tests.support.simulator import SimulatedDevice, StartSimulator
from tests.support.virtual_command import VirtualCommand
from tests.support.virtual_time import VirtualRuntime
from trex_gui import Calibration, Trex
from trex_gui.core.files import data_folder
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.protocol.calibration import CalibrationKey
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.settings.history import SettingsHistory
from trex_gui.ui.devices.connection import ConnectionState

VALUES = {"serial_timeout": 7, "uart_error_shutdown": 2}  # a shutdown of 2 is outside the limits
CALIBRATION = Calibration(2500, 3700, 5100, 60)
KEY = CalibrationKey.RC_CHANNEL_2
NOTE = "The radio drops out."

_MASKED = re.compile(r"(# (?:taken|reason|adapter|serial timeout|.*(?:applied|read)):? ).*")


class InterfaceHarness:
    """Board and data folder that one interface uses."""

    def __init__(self, simulator: SimulatedDevice, runtime: VirtualRuntime, folder: Path) -> None:
        self.simulator = simulator
        self.runtime = runtime
        self.folder = folder

    @property
    def saved_files(self) -> dict[str, str]:
        """Saved files by name, without times, ports and reasons. Snapshots are in order."""
        snapshots = reversed([snapshot.path for snapshot in SettingsHistory().snapshots()])
        records = [*(self.folder / "boards").iterdir(), self.folder / "accepted_values.json"]
        named = {f"snapshot {number}": path for number, path in enumerate(snapshots)}
        named |= {path.name: path for path in records}
        return {name: _MASKED.sub(r"\1…", path.read_text("utf-8")) for name, path in named.items()}


def change_by_window(harness: InterfaceHarness, qtbot: QtBot) -> None:
    device = Device()
    results: list[object] = []
    device.applied.connect(results.append)

    def is_saved() -> bool:
        return device.records.files.is_idle

    def apply() -> None:
        results.clear()
        device.writer.apply()
        qtbot.waitUntil(lambda: bool(results) and is_saved())

    device.connect_to(ConnectionSettings(harness.simulator.url))
    qtbot.waitUntil(lambda: device.link is ConnectionState.CONNECTED and is_saved())
    for key, wire in VALUES.items():
        device.parameters.edit(key, wire, forced=True)
    apply()
    device.calibrations.edit(KEY.channel, CALIBRATION)
    apply()
    device.draft.notes.edit("serial_timeout", NOTE)
    device.parameters.edit("device_number", 9)
    apply()
    results.clear()
    device.writer.reset_to_factory()
    qtbot.waitUntil(lambda: bool(results) and is_saved())
    qtbot.waitUntil(device.shut_down)


def run_command(harness: InterfaceHarness, *words: str) -> None:
    command = VirtualCommand(harness.runtime, words, {"TREX_PORT": harness.simulator.url}, None)
    command.wait()
    assert command.result.exit_code == 0, command.result.output


def change_by_command(harness: InterfaceHarness, _qtbot: QtBot) -> None:
    run = partial(run_command, harness)
    file = harness.folder / "settings.txt"
    lines = ["product: TReX", *(f"{key}: {wire}" for key, wire in VALUES.items())]
    file.write_text("\n".join(lines), "utf-8")
    run("set-settings", "--force", str(file))
    values = CALIBRATION.minimum, CALIBRATION.neutral, CALIBRATION.maximum, CALIBRATION.deadband
    run("calibration", "set", str(KEY.channel), *map(str, values))
    file.write_text(
        f"product: TReX\n# Note on serial_timeout: {NOTE}\nserial_timeout: 7\n", "utf-8"
    )
    run("set-settings", str(file))
    run("set", "device_number", "9")
    run("restore-defaults", "--yes")


def change_by_library(harness: InterfaceHarness, _qtbot: QtBot) -> None:
    def change() -> None:
        with Trex(harness.simulator.url) as board:
            board.set_parameters(force=True, **VALUES)
            board.set_calibration(KEY.channel, CALIBRATION)
            board.set_note("serial_timeout", NOTE)
            board.set_parameters(device_number=9)
            board.restore_defaults()

    Program(harness.runtime, change).end()


def test_window_command_and_library_save_equal_files(
    qtbot: QtBot,
    virtual_time: VirtualRuntime,
    start_simulator: StartSimulator,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    interfaces: dict[str, Callable[[InterfaceHarness, QtBot], None]] = {
        "window": change_by_window,
        "command": change_by_command,
        "library": change_by_library,
    }
    saved_files = {}
    for name, change in interfaces.items():
        (folder := tmp_path / name).mkdir()
        monkeypatch.setenv("TREX_STUDIO_DATA", str(folder))
        harness = InterfaceHarness(start_simulator("--unpaced"), virtual_time, folder)
        harness.simulator.do("accept uart_error_shutdown 3")
        change(harness, qtbot)
        saved_files[name] = harness.saved_files
    assert saved_files["command"] == saved_files["window"]
    assert saved_files["library"] == saved_files["window"]
    assert len([name for name in saved_files["window"] if name.startswith("snapshot")]) == 4
    assert NOTE in saved_files["window"]["trex-1.2-9.txt"]
    assert '"uart_error_shutdown"' in saved_files["window"]["accepted_values.json"]


def set_note_by_library(harness: InterfaceHarness) -> None:
    def set_note() -> None:
        with Trex(harness.simulator.url) as board:
            board.set_note("serial_timeout", NOTE)

    Program(harness.runtime, set_note).end()


@pytest.mark.parametrize(
    "change",
    [lambda harness: run_command(harness, "set", "serial_timeout", "7"), set_note_by_library],
    ids=["set", "library"],
)
def test_command_and_library_record_the_adapter(
    change: Callable[[InterfaceHarness], None],
    virtual_time: VirtualRuntime,
    quick_simulator: SimulatedDevice,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    port = ListPortInfo(quick_simulator.url)
    port.vid, port.pid, port.serial_number = 0x0403, 0x6001, "A10KX7YZ"
    monkeypatch.setattr(list_ports, "comports", lambda: [port])
    change(InterfaceHarness(quick_simulator, virtual_time, data_folder()))
    text = (data_folder() / "boards" / "trex-1.2-7.txt").read_text("utf-8")
    assert "# adapter: 0403:6001-A10KX7YZ" in text


def test_motor_command_saves_no_record(
    virtual_time: VirtualRuntime, quick_simulator: SimulatedDevice
) -> None:
    harness = InterfaceHarness(quick_simulator, virtual_time, data_folder())
    run_command(harness, "motor", "1", "20", "--seconds", "0.2")
    assert not (data_folder() / "boards").exists()
