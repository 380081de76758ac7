"""What a start of the program shows, and what it takes over from the start before."""

from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, contextmanager

import pytest
from PySide6.QtCore import QByteArray, QCoreApplication, QRect, QSettings
from PySide6.QtWidgets import QApplication, QWidget
from pytestqt.qtbot import QtBot

from tests.support.keyboard import check_keyboard
from tests.support.simulator import SimulatedDevice
from tests.support.window import WindowDriver
from trex_gui.composition import build
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.theme.theme import theme

Start = Callable[[], AbstractContextManager[WindowDriver]]


@pytest.fixture
def start(qtbot: QtBot, qapp: QApplication) -> Start:
    """Start the program; it ends as if it had crashed unless its window is closed."""
    theme().install(qapp)

    @contextmanager
    def started() -> Iterator[WindowDriver]:
        program = build()
        program.window.show()
        program.complete()
        try:
            yield WindowDriver(program, qtbot)
            QCoreApplication.processEvents()
        finally:
            program.window.hide()
            assert program.close(), "a thread of the program lives on"

    return started


@pytest.fixture
def _first_start() -> None:
    QSettings().setValue("start/welcomed", False)


@pytest.mark.usefixtures("_first_start")
def test_only_first_start_shows_welcome(start: Start) -> None:
    with start() as window:
        assert window.has("welcome")
        assert not window.has("startDemo")
        check_keyboard(window.window)
        window.open_page("channelsPage")
        window.open_page("statusPage")
        assert window.has("welcome")
        window.click("welcomeConnect")
        assert not window.has("welcome")
        assert window.has("startDemo")
        assert window.find(QWidget, "startWay1").hasFocus()
    with start() as window:  # the window was not closed
        assert window.has("startDemo")
        assert not window.has("welcome")


@pytest.mark.usefixtures("_first_start")
def test_welcome_is_over_once_the_demo_was_tried(window: WindowDriver) -> None:
    window.click("welcomeFind")
    dialog = window.dialog("findDialog").root
    window.wait(dialog.isVisible)
    dialog.close()
    window.click("welcomeDemo")
    window.wait(lambda: window.device.link is ConnectionState.CONNECTED)
    window.disconnect()
    assert window.has("startDemo")
    assert not window.has("welcome")


@pytest.mark.usefixtures("_first_start")
def test_who_has_used_the_program_is_not_welcomed(start: Start) -> None:
    QSettings().setValue("window/state", QByteArray(b"x"))
    with start() as window:
        assert window.has("startDemo")
        assert not window.has("welcome")


@pytest.mark.parametrize("is_closed", [True, False])
def test_device_and_pages_return(
    start: Start, quick_simulator: SimulatedDevice, is_closed: bool
) -> None:
    place = QRect(50, 60, 1000, 650)
    with start() as window:
        window.window.setGeometry(place)
        window.open_page("motorsPage")
        window.program.device_manager.switch_to("aracna", lambda: None)
        window.open_page("aracnaPosesPage")
        if is_closed:
            assert window.window.close()
    with start() as window:
        assert window.has("aracnaPosesPage")
        assert window.program.device_manager.current.plugin.key == "aracna"
        if is_closed:
            assert window.window.geometry() == place
        window.connect(quick_simulator.url)
        assert window.has("motorsPage")
        assert window.window.close()
    with start() as window:
        assert window.has("motorsPage")
        assert window.device.link is ConnectionState.DISCONNECTED
