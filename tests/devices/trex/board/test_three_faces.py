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

VALUES = {"serial_timeout": 7, "uart_error_shutdown": 2}  # a shutdown of 2 is beyond its limit
LEARNED = Calibration(2500, 3700, 5100, 60)
KEY = CalibrationKey.RC_CHANNEL_2
NOTE = "The radio drops out."

_MASKED = re.compile(r"(# (?:taken|reason|adapter|serial timeout|.*(?:applied|read)):? ).*")


class Bench:
    """A board and an empty data folder."""

    def __init__(self, simulator: SimulatedDevice, runtime: VirtualRuntime, folder: Path) -> None:
        self.simulator = simulator
        self.runtime = runtime
        self.folder = folder

    @property
    def kept(self) -> dict[str, str]:
        """The files by name, without times, ports and reasons. Snapshots are in their order."""
        snapshots = reversed([each.path for each in SettingsHistory().snapshots()])
        others = [*(self.folder / "boards").iterdir(), self.folder / "accepted_values.json"]
        named = {f"snapshot {turn}": path for turn, path in enumerate(snapshots)}
        named |= {path.name: path for path in others}
        return {name: _MASKED.sub(r"\1…", path.read_text("utf-8")) for name, path in named.items()}


def by_window(bench: Bench, qtbot: QtBot) -> None:
    device = Device()
    results: list[object] = []
    device.applied.connect(results.append)

    def saved() -> bool:
        return device.records.files.is_idle

    def apply() -> None:
        results.clear()
        device.writer.apply()
        qtbot.waitUntil(lambda: bool(results) and saved())

    device.connect_to(ConnectionSettings(bench.simulator.url))
    qtbot.waitUntil(lambda: device.link is ConnectionState.CONNECTED and saved())
    for key, wire in VALUES.items():
        device.parameters.edit(key, wire, forced=True)
    apply()
    device.calibrations.edit(KEY.channel, LEARNED)
    apply()
    device.draft.notes.edit("serial_timeout", NOTE)
    device.parameters.edit("device_number", 9)
    apply()
    results.clear()
    device.writer.reset_to_factory()
    qtbot.waitUntil(lambda: bool(results) and saved())
    qtbot.waitUntil(device.shut_down)


def run_command(bench: Bench, *words: str) -> None:
    command = VirtualCommand(bench.runtime, words, {"TREX_PORT": bench.simulator.url}, None)
    command.wait()
    assert command.result.exit_code == 0, command.result.output


def by_command(bench: Bench, _qtbot: QtBot) -> None:
    run = partial(run_command, bench)
    file = bench.folder / "settings.txt"
    lines = ["product: TReX", *(f"{key}: {wire}" for key, wire in VALUES.items())]
    file.write_text("\n".join(lines), "utf-8")
    run("set-settings", "--force", str(file))
    values = LEARNED.minimum, LEARNED.neutral, LEARNED.maximum, LEARNED.deadband
    run("calibration", "set", str(KEY.channel), *map(str, values))
    file.write_text(
        f"product: TReX\n# Note on serial_timeout: {NOTE}\nserial_timeout: 7\n", "utf-8"
    )
    run("set-settings", str(file))
    run("set", "device_number", "9")
    run("restore-defaults", "--yes")


def by_library(bench: Bench, _qtbot: QtBot) -> None:
    def change() -> None:
        with Trex(bench.simulator.url) as board:
            board.set_parameters(force=True, **VALUES)
            board.set_calibration(KEY.channel, LEARNED)
            board.set_note("serial_timeout", NOTE)
            board.set_parameters(device_number=9)
            board.restore_defaults()

    Program(bench.runtime, change).end()


def test_each_interface_saves_equal_files(
    qtbot: QtBot,
    virtual_time: VirtualRuntime,
    start_simulator: StartSimulator,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    faces: dict[str, Callable[[Bench, QtBot], None]] = {
        "window": by_window,
        "command": by_command,
        "library": by_library,
    }
    kept = {}
    for name, change in faces.items():
        (folder := tmp_path / name).mkdir()
        monkeypatch.setenv("TREX_STUDIO_DATA", str(folder))
        bench = Bench(start_simulator("--unpaced"), virtual_time, folder)
        bench.simulator.do("accept uart_error_shutdown 3")
        change(bench, qtbot)
        kept[name] = bench.kept
    assert kept["command"] == kept["window"]
    assert kept["library"] == kept["window"]
    assert len([name for name in kept["window"] if name.startswith("snapshot")]) == 4
    assert NOTE in kept["window"]["trex-1.2-9.txt"]
    assert '"uart_error_shutdown"' in kept["window"]["accepted_values.json"]


def set_note_by_library(bench: Bench) -> None:
    def change() -> None:
        with Trex(bench.simulator.url) as board:
            board.set_note("serial_timeout", NOTE)

    Program(bench.runtime, change).end()


@pytest.mark.parametrize(
    "face",
    [lambda bench: run_command(bench, "set", "serial_timeout", "7"), set_note_by_library],
    ids=["set", "library"],
)
def test_faces_without_a_window_know_the_adapter(
    face: Callable[[Bench], None],
    virtual_time: VirtualRuntime,
    quick_simulator: SimulatedDevice,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    port = ListPortInfo(quick_simulator.url)
    port.vid, port.pid, port.serial_number = 0x0403, 0x6001, "A10KX7YZ"
    monkeypatch.setattr(list_ports, "comports", lambda: [port])
    face(Bench(quick_simulator, virtual_time, data_folder()))
    text = (data_folder() / "boards" / "trex-1.2-7.txt").read_text("utf-8")
    assert "# adapter: 0403:6001-A10KX7YZ" in text


def test_run_of_a_motor_saves_nothing(
    virtual_time: VirtualRuntime, quick_simulator: SimulatedDevice
) -> None:
    bench = Bench(quick_simulator, virtual_time, data_folder())
    run_command(bench, "motor", "1", "20", "--seconds", "0.2")
    assert not (data_folder() / "boards").exists()
