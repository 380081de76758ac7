"""Command line of trex-gui, its log, and the tour that creates pictures."""

import json
import platform
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from PySide6.QtCore import QSize
from pytestqt.qtbot import QtBot

from tests.devices.trex.simulator.waiting import comes_true
from tests.support.scripts import load_script
from tests.support.simulator import SimulatedDevice
from tests.support.window import WindowDriver
from trex_gui.app import main
from trex_gui.core.files import log_folder
from trex_gui.core.log_file import log_file
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.ui.program import Program
from trex_gui.version import __version__

HelpTour = load_script("pictures").HelpTour
PICTURES = Path(__file__).parents[1] / "resources" / "help" / "pictures"


def run(*arguments: str, timeout: float = 50) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-m", "trex_gui", *arguments]
    return subprocess.run(command, capture_output=True, text=True, timeout=timeout, check=False)


def test_version_option_prints_version(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as exit_info:
        main(["--version"])
    assert exit_info.value.code == 0
    assert __version__ in capsys.readouterr().out


@pytest.mark.parametrize(
    "arguments",
    [
        ["--nonsense"],
        ["--timeout", "-1"],
        ["--timeout", "61"],
        ["--timeout", "soon"],
        ["--port", "foo://x"],
        ["--port", "socket://nohost"],
        ["--port", ""],
        ["--settings", ""],
        ["--tour", ""],
        ["--demo", "--port", "COM3"],
        ["--demo", "--device", "toaster"],
    ],
)
def test_invalid_option_exits_with_2(arguments: list[str]) -> None:
    with pytest.raises(SystemExit) as exit_info:
        main(arguments)
    assert exit_info.value.code == 2


@pytest.mark.realtime
def test_simulator_option_runs_simulator() -> None:
    result = run("--simulator", "--version")
    assert result.returncode == 0
    assert "trex-sim" in result.stdout


def test_tour_writes_a_picture_of_every_page(
    program: Program, qtbot: QtBot, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("trex_gui.ui.tour._STEP_MS", 20)
    tour = HelpTour(program, tmp_path, schemes=("dark",), size=QSize(800, 600))
    tour.start()
    with qtbot.waitSignal(tour.finished, timeout=120_000) as finished:
        program.connect_to_demo("trex")
    assert finished.args == [True]
    names = {path.name for path in tmp_path.glob("*.png")}
    assert names == {f"{page}-dark.png" for page in tour_pages()}
    assert all(path.stat().st_size > 10_000 for path in tmp_path.glob("*.png"))
    digests = json.loads((PICTURES / "digests.json").read_text(encoding="utf-8"))
    outdated = [name for name, digest in digests.items() if tour.digests[name] != digest]
    assert not outdated, (
        "the window no longer looks like these pictures of the help; "
        "create them again: python3 packaging/bootstrap.py pictures"
    )


def tour_pages() -> list[str]:
    pages = ["board", "channels", "motors", "currents", "parameters"]
    pages += [f"learn-{step}" for step in ("rest", "travel", "review", "test")]
    setup_steps = ("driver", "jumpers", "sticks", "motors", "limits", "review")
    pages += [f"setup-{step}" for step in setup_steps]
    pages += ["errors", "trexLog", "transcript", "check-leds", "check-jumpers"]
    names = ("Robot", "Poses", "Errors", "Log", "Transcript")
    robot_pages = [f"aracna{name}" for name in names]
    return [*pages, *robot_pages, *(f"{page}-moving" for page in robot_pages)]


@pytest.mark.realtime
@pytest.mark.slow
@pytest.mark.timeout(180)
def test_tour_option_writes_every_picture_and_exits(tmp_path: Path) -> None:
    result = run("--tour", str(tmp_path), timeout=160)
    assert result.returncode == 0, result.stderr
    names = {path.name for path in tmp_path.glob("*.png")}
    assert names == {
        f"{page}-{scheme}.png" for page in tour_pages() for scheme in ("light", "dark")
    }


@pytest.mark.realtime
@pytest.mark.skipif(sys.platform == "win32", reason="POSIX signals")
def test_sigterm_ends_program_cleanly(quick_simulator: SimulatedDevice) -> None:
    command = [sys.executable, "-m", "trex_gui", "--port", quick_simulator.url, "--timeout", "0.1"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:

        def is_connected() -> bool:
            assert process.poll() is None
            packets: int = quick_simulator.show()["counters"]["packets"]
            return packets >= 20

        try:
            assert comes_true(is_connected)
            process.send_signal(signal.SIGTERM)
            assert process.wait(30) == 0
        finally:
            process.kill()
    first, *between, last = log_file().read_text(encoding="utf-8").splitlines()
    assert f"TReX Studio {__version__} started on {platform.system()}" in first
    assert any(line.endswith(f"ended by signal {signal.SIGTERM:d}") for line in between)
    assert last.endswith("ended with exit code 0")
    assert list(log_folder().iterdir()) == [log_file()], "a proper end leaves no crash report"


def test_settings_file_is_opened_when_board_connects(
    window: WindowDriver, quick_simulator: SimulatedDevice, tmp_path: Path
) -> None:
    path = tmp_path / "rover.txt"
    path.write_text("product: TReX\nserial_timeout: 5\n", encoding="utf-8")
    window.program.open_file(path, connecting=True)
    window.device.connect_to(ConnectionSettings(quick_simulator.url))
    window.wait(lambda: window.has("takeChangesButton"))
    window.click("takeChangesButton")
    assert window.device.draft.pending == 1
