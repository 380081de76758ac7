"""A person records a session, sees that it is recorded, and opens it again without the board."""

import os
import select
import signal
import subprocess
import sys
from collections.abc import Callable
from importlib import import_module
from pathlib import Path

import pytest
from PySide6.QtCore import QMimeData, QPoint, QPointF, Qt, QThread, QTimer, QUrl
from PySide6.QtGui import QAction, QDragEnterEvent, QDropEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QFileDialog, QLabel, QPushButton, QWidget
from pytestqt.qtbot import QtBot

from tests.recording.samples import an_hour, write, write_an_hour_of_csv
from tests.support.simulator import SimulatedDevice
from trex_gui.link.settings import LinkSettings
from trex_gui.link.timeouts import Timeouts
from trex_gui.model.device import Link
from trex_gui.runtime import now
from trex_gui.views.recording.indicator import RecordIndicator
from trex_gui.window import Program


@pytest.fixture
def connected(program: Program, quick_simulator: SimulatedDevice, qtbot: QtBot) -> Program:
    program.device.connect_to(LinkSettings(quick_simulator.url))
    qtbot.waitUntil(lambda: program.device.link is Link.UP, timeout=20_000)
    return program


def indicator(program: Program) -> RecordIndicator:
    found = program.window.findChild(RecordIndicator, "recordIndicator")
    assert found is not None
    return found


def text(window: QWidget, name: str) -> str:
    label = window.findChild(QLabel, name)
    assert label is not None
    return label.text()


def action(program: Program, key: str) -> QAction:
    found = program.window.findChild(QAction, f"{key}Action")
    assert found is not None
    return found


def record(program: Program, path: Path, qtbot: QtBot) -> None:
    """Record until there is something in the file, and end it with the button."""
    program.desk.recordings.record(path)
    qtbot.waitUntil(lambda: indicator(program).isVisible())
    samples = program.device.telemetry.samples
    qtbot.waitUntil(lambda: program.device.telemetry.samples > samples + 300, timeout=30_000)
    button = indicator(program).findChild(QPushButton, "stopRecordingButton")
    assert button is not None
    with qtbot.waitSignal(program.desk.recordings.recorder.ended, timeout=20_000):
        QTest.mouseClick(button, Qt.MouseButton.LeftButton)


def test_recording_is_seen_on_every_page_with_time_and_size(
    connected: Program, tmp_path: Path, qtbot: QtBot
) -> None:
    assert not indicator(connected).isVisible()
    connected.desk.recordings.record(tmp_path / "a.trexrec")
    qtbot.waitUntil(lambda: "Recording  0:00:" in text(connected.window, "recordText"))
    qtbot.waitUntil(lambda: " kB" in text(connected.window, "recordText"), timeout=20_000)
    for page in range(connected.window.pages.count()):
        connected.window.pages.setCurrentIndex(page)
        assert indicator(connected).isVisible()
        assert "Recording" in indicator(connected).accessibleName()
    assert action(connected, "record").text() == "Stop &recording"
    with qtbot.waitSignal(connected.desk.recordings.recorder.ended, timeout=20_000):
        action(connected, "record").trigger()
    assert not indicator(connected).isVisible()
    assert action(connected, "record").text() == "&Record…"
    assert "Recorded in" in text(connected.window, "bannerText")


@pytest.mark.parametrize("suffix", [".trexrec", ".csv"])
def test_a_recording_is_opened_again_without_a_board(
    connected: Program, tmp_path: Path, qtbot: QtBot, suffix: str
) -> None:
    path = tmp_path / f"session{suffix}"
    record(connected, path, qtbot)
    connected.device.disconnect_line()
    qtbot.waitUntil(lambda: connected.device.link is Link.NONE, timeout=20_000)
    connected.desk.recordings.open_file(path)
    (window,) = connected.desk.recordings.windows
    qtbot.waitUntil(lambda: window.playback.is_loaded)
    assert window.playback.problems == []
    assert window.playback.end > window.playback.start
    window.playback.set_position(window.playback.end)
    assert text(window, "channel1PhysicalAtPosition").endswith("µs")
    connected.desk.recordings.open_file(path)
    assert connected.desk.recordings.windows == [window]
    button = window.findChild(QPushButton, "settingsInForceButton")
    assert button is not None
    QTest.mouseClick(button, Qt.MouseButton.LeftButton)
    (editor,) = connected.desk.files.editors
    assert editor.document.readable
    editor.close()
    window.close()
    assert connected.desk.recordings.windows == []


def test_a_recording_that_is_dropped_onto_the_window_opens(
    program: Program, tmp_path: Path, qtbot: QtBot
) -> None:
    path = tmp_path / "a.trexrec"
    write(path, list(an_hour(5)))
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(path))])
    copy = Qt.DropAction.CopyAction
    left, none = Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier
    enter = QDragEnterEvent(QPoint(9, 9), copy, data, left, none)
    QApplication.sendEvent(program.window, enter)
    assert enter.isAccepted()
    QApplication.sendEvent(program.window, QDropEvent(QPointF(9, 9), copy, data, left, none))
    (window,) = program.desk.recordings.windows
    qtbot.waitUntil(lambda: window.playback.is_loaded)
    window.close()


def test_a_file_that_is_none_is_refused_with_its_name(program: Program, tmp_path: Path) -> None:
    path = tmp_path / "none.trexrec"
    path.write_text("nothing of the kind")
    program.desk.recordings.open_file(path)
    assert "none.trexrec, byte 0: This is no recording" in text(program.window, "bannerText")
    assert program.desk.recordings.windows == []


def test_nothing_can_be_recorded_without_a_board(program: Program, tmp_path: Path) -> None:
    assert not action(program, "record").isEnabled()
    assert action(program, "open_recording").isEnabled()


def test_a_recording_that_runs_is_whole_after_the_window_is_closed(
    connected: Program, tmp_path: Path, qtbot: QtBot, make_sure: Callable[[Path], None]
) -> None:
    path = tmp_path / "a.trexrec"
    connected.desk.recordings.record(path)
    samples = connected.device.telemetry.samples
    qtbot.waitUntil(lambda: connected.device.telemetry.samples > samples + 100, timeout=20_000)
    connected.window.close()
    make_sure(path)


@pytest.fixture
def make_sure() -> Callable[[Path], None]:
    """Fail where a recording is not whole."""
    from trex_gui.recording.files import open_recording

    def check(path: Path) -> None:
        file = open_recording(path)
        assert file.problems == []
        assert sum(block.count for block in file.blocks) > 50
        file.close()

    return check


@pytest.mark.realtime
@pytest.mark.skipif(sys.platform == "win32", reason="POSIX signals")
@pytest.mark.timeout(120)
@pytest.mark.parametrize("disk", ["0.05", pytest.param("never", marks=pytest.mark.slow)])
def test_a_signal_while_it_is_recorded_ends_the_program_in_good_order(
    disk: str,
    quick_simulator: SimulatedDevice,
    tmp_path: Path,
    make_sure: Callable[[Path], None],
) -> None:
    path = tmp_path / "a.trexrec"
    command = [sys.executable, "-m", "tests.support.recording_window"]
    with subprocess.Popen(
        [*command, quick_simulator.url, str(path), disk],
        cwd=Path(__file__).parents[2],
        env={**os.environ, "XDG_CONFIG_HOME": str(tmp_path)},
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    ) as process:
        try:
            assert process.stdout is not None
            ready, _, _ = select.select([process.stdout], [], [], 40)
            assert ready, "it never recorded"
            assert process.stdout.readline() == "recording\n"
            process.send_signal(signal.SIGTERM)
            _, errors = process.communicate(timeout=40)  # the disk hangs for 60 s
        finally:
            process.kill()
    assert process.returncode == 0
    assert "QThread" not in errors
    assert "Traceback" not in errors
    if disk != "never":
        make_sure(path)


@pytest.mark.parametrize("ask", ["ask_and_open", "ask_and_record"])
def test_esc_in_a_file_dialog_stops_the_motors(program: Program, qtbot: QtBot, ask: str) -> None:
    stops: list[str] = []
    program.device.motors.stop_requested.connect(lambda: stops.append("stop"))

    def press_esc() -> None:
        dialog = QApplication.activeModalWidget()
        assert isinstance(dialog, QFileDialog)
        window = dialog.windowHandle()
        QTest.qWaitForWindowActive(dialog)
        QTest.keyClick(window, Qt.Key.Key_Escape)

    QTimer.singleShot(100, press_esc)
    getattr(program.desk.recordings, ask)()
    assert stops == ["stop"]


@pytest.mark.realtime
def test_file_dialogs_are_those_in_which_esc_can_be_seen() -> None:
    script = (
        "import sys; from PySide6.QtCore import Qt; from PySide6.QtWidgets import QApplication; "
        "from trex_gui import app, window; "
        "native = Qt.ApplicationAttribute.AA_DontUseNativeDialogs; "
        "window.build = lambda *_: sys.exit(7 if QApplication.testAttribute(native) else 8); "
        "app.main([])"
    )
    result = subprocess.run([sys.executable, "-c", script], timeout=40, check=False)
    assert result.returncode == 7


def test_stop_reaches_the_board_while_a_full_disk_is_recorded_to(
    connected: Program, quick_simulator: SimulatedDevice, qtbot: QtBot
) -> None:
    full = Path("/dev/full")
    if not full.exists():
        pytest.skip("this system has no disk that is always full")
    device = connected.device
    connected.desk.recordings.record(full)
    device.motors.arm()
    device.motors.accelerate = False
    device.motors.set_speed(1, 60)
    qtbot.waitUntil(
        lambda: quick_simulator.show()["motors"][0]["target_speed"] == 60, timeout=20_000
    )
    device.motors.press_stop()
    qtbot.waitUntil(
        lambda: quick_simulator.show()["motors"][0]["direction"] == "brake", timeout=20_000
    )
    qtbot.waitUntil(
        lambda: "cannot be written: No space left" in text(connected.window, "bannerText"),
        timeout=20_000,
    )
    assert not indicator(connected).isVisible()


@pytest.mark.realtime
@pytest.mark.slow
@pytest.mark.timeout(240)
def test_a_motor_keeps_turning_while_an_hour_of_csv_is_opened(
    connected: Program, quick_simulator: SimulatedDevice, tmp_path: Path, qtbot: QtBot
) -> None:
    import_module("trex_gui.views.recording.window")  # the program does so at its start
    write_an_hour_of_csv(tmp_path / "hour.csv")
    motors = connected.device.motors
    motors.accelerate = False

    def turns() -> bool:
        if not motors.armed:
            motors.arm()
            motors.set_speed(1, 60)
        return bool(quick_simulator.show()["motors"][0]["target_speed"] == 60)

    seen: list[tuple[bool, bool, bool, str]] = []

    def turns_while_it_is_opened() -> bool:
        qtbot.waitUntil(turns, timeout=20_000)
        begin = now()
        connected.desk.recordings.open_file(tmp_path / "hour.csv")
        (window,) = connected.desk.recordings.windows
        # Longer than the silence of a window that stops armed motors.
        qtbot.waitUntil(lambda: now() > begin + 2 * Timeouts().heartbeat, timeout=20_000)
        was_opened_meanwhile = not window.playback.is_loaded
        window.close()
        motor = quick_simulator.show()["motors"][0]
        goes_on = motor["target_speed"] == 60 and motor["direction"] != "brake"
        seen.append((was_opened_meanwhile, motors.armed, goes_on, motors.stop_reason))
        return was_opened_meanwhile and motors.armed and goes_on

    # A computer with far too much to do may stop them by itself, but hardly each time.
    assert any(turns_while_it_is_opened() for _ in range(6)), seen
    assert connected.desk.recordings.windows == []
    device = connected.device
    device.motors.press_stop()
    qtbot.waitUntil(
        lambda: quick_simulator.show()["motors"][0]["direction"] == "brake", timeout=20_000
    )


@pytest.mark.realtime
def test_a_program_that_ends_while_a_recording_is_read_ends_its_thread(
    program: Program, tmp_path: Path, qtbot: QtBot
) -> None:
    write_an_hour_of_csv(tmp_path / "hour.csv", 10)
    program.desk.recordings.open_file(tmp_path / "hour.csv")
    (window,) = program.desk.recordings.windows
    (thread,) = window.playback.findChildren(QThread)
    qtbot.waitUntil(lambda: window.playback.progress > 0, timeout=20_000)
    assert thread.isRunning()
    assert program.shut_down()
    assert thread.isFinished()


@pytest.mark.realtime
def test_the_plotting_library_is_there_before_a_page_with_a_plot_is_shown(tmp_path: Path) -> None:
    script = (
        "import os, sys; from PySide6.QtCore import QTimer; from trex_gui import app, window\n"
        "build = window.build\n"
        "def built(*_):\n"
        "    global timer, ticks\n"
        "    program, ticks, timer = build(), 0, QTimer()\n"
        "    def look():\n"
        "        global ticks\n"
        "        ticks += 1\n"
        "        loaded = 'pyqtgraph' in sys.modules\n"
        "        if loaded or ticks > 1000:\n"
        "            timer.stop(); sys.stdout.write(f'{loaded}'); program.window.close()\n"
        "    timer.timeout.connect(look); timer.start(20)\n"
        "    assert 'pyqtgraph' not in sys.modules\n"
        "    return program\n"
        "window.build = built; app.main([])"
    )
    result = subprocess.run(
        [sys.executable, "-c", script],
        env={**os.environ, "XDG_CONFIG_HOME": str(tmp_path)},
        capture_output=True,
        text=True,
        timeout=40,
        check=False,
    )
    assert (result.stdout, result.returncode) == ("True", 0), result.stderr
