"""Fixtures and checks of all tests: no screen, separate settings, virtual time."""

import gc
import itertools
import os
import signal
import sys
import threading
import time
from collections.abc import Iterator
from functools import partial
from pathlib import Path
from typing import Any, NoReturn

import hypothesis
import pytest

if os.environ.get("QT_QPA_PLATFORM", "offscreen") == "offscreen":  # the default is 800×800
    _SCREEN = Path(__file__).parent / "support" / "screen.json"
    os.environ["QT_QPA_PLATFORM"] = f"offscreen:configfile={_SCREEN}"
os.environ["LC_ALL"] = "C.UTF-8"  # programs started by tests use English

from PySide6.QtCore import QCoreApplication, QEvent, QSettings, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QWidget
from pytestqt.qtbot import QtBot
from serial.tools import list_ports
from serial.tools.list_ports_common import ListPortInfo

from tests.support.matrix import LONG_FACTOR
from tests.support.patient import PatientQtBot
from tests.support.program import trex
from tests.support.simulator import SimulatedDevice, SimulatorProcess, StartSimulator
from tests.support.virtual import SessionHarness
from tests.support.virtual_devices import VirtualProcess, VirtualSimulator
from tests.support.virtual_time import VirtualQtBot, VirtualRuntime
from tests.support.window import WindowDriver
from trex_gui.composition import build
from trex_gui.core.recording.store import RecordingWriter
from trex_gui.core.timing import Timeouts
from trex_gui.devices.trex.protocol.calibration import FULL_SCALE
from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.files import end_background
from trex_gui.ui.program import Program
from trex_gui.ui.runtime import use_runtime
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.translations import ENGLISH, install_translations
from trex_gui.ui.units import units

# Several processes may share the computer, so run times of examples mean nothing.
hypothesis.settings.register_profile("gate", deadline=None, derandomize=True, max_examples=100)
hypothesis.settings.register_profile(
    "all", deadline=None, derandomize=False, max_examples=100 * LONG_FACTOR
)
hypothesis.settings.load_profile(os.environ.get("HYPOTHESIS_PROFILE", "gate"))


def pytest_configure() -> None:
    """Reset ignored signals, because `nohup` and `&` ignore some signals."""
    defaults: dict[str, Any] = {
        "SIGINT": signal.default_int_handler,
        "SIGHUP": signal.SIG_DFL,
        "SIGQUIT": signal.SIG_DFL,
    }
    for name, handler in defaults.items():
        number = getattr(signal, name, None)
        if number is not None and signal.getsignal(number) is signal.SIG_IGN:
            signal.signal(number, handler)


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--all", action="store_true", help="run the tests marked slow, too")


def pytest_ignore_collect(collection_path: Path, config: pytest.Config) -> bool | None:
    """Skip files without realtime tests if only realtime tests run. Importing takes time."""
    is_unneeded = collection_path.name.startswith("test_") and (
        config.getoption("markexpr") == "realtime"
        and b"realtime" not in collection_path.read_bytes()
    )
    return True if is_unneeded else None  # `None` leaves the decision to other plugins


# These files need pseudo-terminals and POSIX signals. On Windows they cannot even be imported.
_POSIX_FILES = (
    "core/guardian/test_guardian.py",
    "core/transport/test_late_thread.py",
    "end_to_end/test_closing_unconfirmed_stop.py",
    "end_to_end/test_every_stop_cause.py",
)


class _PosixModule(pytest.Module):
    """Test file that is skipped as a whole."""

    def collect(self) -> NoReturn:
        pytest.skip("needs pseudo-terminals and POSIX signals", allow_module_level=True)


def pytest_pycollect_makemodule(
    module_path: Path, parent: pytest.Collector
) -> pytest.Module | None:
    """Skip files that cannot be imported on Windows."""
    if sys.platform == "win32" and module_path.as_posix().endswith(_POSIX_FILES):
        return _PosixModule.from_parent(parent, path=module_path)
    return None


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    if config.getoption("--all"):
        return
    slow = [item for item in items if item.get_closest_marker("slow")]
    items[:] = [item for item in items if not item.get_closest_marker("slow")]
    config.hook.pytest_deselected(items=slow)


def pytest_collection_finish() -> None:
    """Run Python's collector in the GUI thread only, like the program.

    Loaded objects are frozen, because scanning them would take a fifth of the run. The collector
    stays off to the end of the process. Otherwise it could run in any thread that allocates, and
    freeing windows there would crash the process.
    """
    gc.disable()
    gc.collect()
    gc.freeze()


@pytest.fixture
def virtual_time() -> Iterator[VirtualRuntime]:
    """Run the program in virtual time."""
    virtual = VirtualRuntime()
    virtual.create_process = partial(VirtualProcess, virtual)
    previous = use_runtime(virtual)
    yield virtual
    use_runtime(previous)
    assert virtual.is_idle, "a thread of the program is still running"


def _is_real(request: pytest.FixtureRequest) -> bool:
    return request.node.get_closest_marker("realtime") is not None


@pytest.fixture(autouse=True)
def _time(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Run the program in virtual time, with the same port on every computer.

    Tests marked `realtime` use the clock and the ports of the computer.
    """
    if not _is_real(request):
        request.getfixturevalue("virtual_time")
        ports = [ListPortInfo("/dev/ttyS0")]
        monkeypatch.setattr(list_ports, "comports", lambda: ports)
    yield
    end_background(60_000)  # the closing window may still be reading files


@pytest.fixture(scope="session")
def qapp(qapp: QApplication) -> QApplication:
    """Application with its style and English plural forms, and a cursor that does not blink."""
    qapp.setCursorFlashTime(0)
    install_translations(qapp, ENGLISH)
    theme().install(qapp)
    return qapp


@pytest.fixture
def qtbot(qapp: QApplication, request: pytest.FixtureRequest) -> QtBot:
    """Wait in virtual time. In real time wait longer than pytest-qt's default."""
    del qapp
    if _is_real(request):
        return PatientQtBot(request)
    return VirtualQtBot(request, request.getfixturevalue("virtual_time"))


@pytest.fixture
def light_scheme(qapp: QApplication) -> None:
    """Use light colours and the default font size on every computer."""
    del qapp
    theme().set_scheme("light")
    theme().set_font_size(100)


@pytest.fixture
def no_ports(monkeypatch: pytest.MonkeyPatch) -> None:
    """Hide the computer's ports. List only ports that a test adds."""
    monkeypatch.setattr(list_ports, "comports", list)


@pytest.fixture
def computer(monkeypatch: pytest.MonkeyPatch) -> list[ListPortInfo]:
    """Serial ports of the simulated computer. Request this fixture before the window."""
    ports: list[ListPortInfo] = []
    monkeypatch.setattr(list_ports, "comports", lambda: list(ports))
    return ports


@pytest.fixture
def board() -> Board:
    return Board()


@pytest.fixture
def harness(board: Board) -> SessionHarness:
    return SessionHarness(board)


_ORGANIZATION, _APPLICATION = "TReX Studio tests", "TReX Studio"


@pytest.fixture(scope="session")
def _settings_root(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Folder for settings. Boards with the default number may drive at full speed."""
    root = tmp_path_factory.mktemp("settings")
    boards = [
        f"{prefix}{model.key}-{firmware}-7"
        for prefix in ("", "demo-")
        for model in device_table().models
        for firmware in model.firmware
    ]
    file = root / "system" / _ORGANIZATION / f"{_APPLICATION}.ini"
    file.parent.mkdir(parents=True)
    lines = (f"ceilings\\{board}={FULL_SCALE}\n" for board in boards)
    file.write_text(f"[motors]\n{''.join(lines)}", encoding="utf-8")
    QSettings.setPath(QSettings.Format.IniFormat, QSettings.Scope.SystemScope, str(root / "system"))
    return root


_folders = itertools.count(1)


@pytest.fixture(autouse=True)
def _own_settings(_settings_root: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Save the program's data in a folder of the test.

    Does not use `tmp_path`, which becomes slow because pytest scans all earlier folders.
    """
    folder = _settings_root / str(next(_folders))
    folder.mkdir()
    monkeypatch.setenv("TREX_STUDIO_DATA", str(folder))
    QCoreApplication.setOrganizationName(_ORGANIZATION)
    QCoreApplication.setApplicationName(_APPLICATION)
    QSettings.setDefaultFormat(QSettings.Format.IniFormat)
    QSettings.setPath(QSettings.Format.IniFormat, QSettings.Scope.UserScope, str(folder))


_MOUSE_BUTTONS = (
    Qt.MouseButton.LeftButton,
    Qt.MouseButton.MiddleButton,
    Qt.MouseButton.RightButton,
)
_MANY_OBJECTS = 100_000  # a window has about 40,000 objects with references


class _ReleaseTarget(QWidget):
    """Target for releases of mouse buttons."""

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        event.accept()


@pytest.fixture(autouse=True)
def _clean_up() -> Iterator[None]:
    """Clean up after a test. Fail a test that leaves a thread or window behind.

    Garbage is collected after a few windows, or after many small tests.
    """
    threads = _threads()
    yield
    _restore_preferences()
    _release_mouse()
    _check_threads_and_windows(threads)
    if gc.get_count()[0] > _MANY_OBJECTS:  # objects that were created and not freed
        gc.collect()
        gc.freeze()  # caches, and pytest's data about every test


def _restore_preferences() -> None:
    units.cache_clear()
    theme().set_font_size(100)
    if theme().choice != "system":
        theme().set_scheme("system")
        QCoreApplication.processEvents()


def _release_mouse() -> None:
    """Release mouse buttons that a test left pressed. QTest would keep them pressed."""
    if isinstance(QCoreApplication.instance(), QApplication):
        target = _ReleaseTarget()
        for button in _MOUSE_BUTTONS:
            QTest.mouseRelease(target, button)


def _check_threads_and_windows(threads: set[threading.Thread]) -> None:
    deadline = time.monotonic() + 20
    while (_threads() - threads or _windows()) and time.monotonic() < deadline:
        QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
        QCoreApplication.processEvents()
        time.sleep(0.01)
    assert not _threads() - threads
    assert not _windows()


@pytest.fixture(autouse=True, scope="session")
def _ends_every_process() -> Iterator[None]:
    """Fail the run if a process that a test started is still running or a zombie."""
    yield
    path = Path(f"/proc/{os.getpid()}/task/{os.getpid()}/children")
    children = path.read_text(encoding="ascii").split() if path.exists() else []
    assert not children


def _threads() -> set[threading.Thread]:
    """Return running Python threads, without dummies for Qt's threads."""
    return {
        thread
        for thread in threading.enumerate()
        if not isinstance(thread, threading.Timer)  # the test's own time limit
        and type(thread).__name__ != "_DummyThread"
    }


def _windows() -> list[str]:
    if not isinstance(app := QCoreApplication.instance(), QApplication):
        return []
    return [repr(widget) for widget in app.topLevelWidgets() if widget.isVisible()]


@pytest.fixture
def start_simulator(request: pytest.FixtureRequest) -> Iterator[StartSimulator]:
    """Start simulators that end with the test."""
    running: list[SimulatedDevice] = []

    def start(*arguments: str) -> SimulatedDevice:
        if _is_real(request):
            running.append(SimulatorProcess(*arguments))
        else:
            virtual = request.getfixturevalue("virtual_time")
            url = f"/virtual/port{len(virtual.ports)}"
            running.append(VirtualSimulator(virtual, url, *arguments))
        return running[-1]

    yield start
    for simulator in running:
        simulator.end()


@pytest.fixture
def simulator(start_simulator: StartSimulator) -> SimulatedDevice:
    return start_simulator()


@pytest.fixture
def quick_simulator(start_simulator: StartSimulator) -> SimulatedDevice:
    """Simulated board that transmits without delay."""
    return start_simulator("--unpaced")


@pytest.fixture
def timeouts() -> Timeouts:
    """Timeouts of the window."""
    return Timeouts()


@pytest.fixture
def program(qtbot: QtBot, qapp: QApplication, timeouts: Timeouts) -> Iterator[Program]:
    """Window and its models without a connection. No thread may outlive the test.

    A page is created when it is shown or searched for.
    """
    program = build(timeouts)
    program.window.show()
    yield program
    trex(program).device.draft.discard_edits()
    program.window.close()
    assert trex(program).device.link is ConnectionState.DISCONNECTED
    assert program.close(), "a thread of the program is still running"


@pytest.fixture
def window(program: Program, qtbot: QtBot) -> WindowDriver:
    """Window without a connection."""
    return WindowDriver(program, qtbot)


@pytest.fixture
def connected_window(window: WindowDriver, quick_simulator: SimulatedDevice) -> WindowDriver:
    """Window connected to a simulated board that transmits without delay."""
    window.connect(quick_simulator.url)
    return window


@pytest.fixture
def full_disk(monkeypatch: pytest.MonkeyPatch) -> None:
    """Make recordings run out of disk space."""
    initialize = RecordingWriter.__init__

    def init_on_full_disk(writer: RecordingWriter[Any, Any], *args: Any) -> None:
        initialize(writer, *args)
        writer._database.execute("PRAGMA max_page_count = 12")

    monkeypatch.setattr(RecordingWriter, "__init__", init_on_full_disk)
