"""What a start of the program shows, and what it takes over from the start before."""

from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, contextmanager

import pytest
from PySide6.QtCore import QCoreApplication, QRect
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

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
