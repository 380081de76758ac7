"""A person whose board has line settings that nobody remembers."""

import sys
from collections.abc import Callable
from typing import TypeVar

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QAction
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractButton,
    QLabel,
    QListWidget,
    QProgressBar,
    QToolButton,
    QWidget,
)
from pytestqt.qtbot import QtBot

from tests.support.simulator import SimulatedDevice, StartSimulator
from trex_gui.link.client import Client
from trex_gui.link.discovery import attempts
from trex_gui.link.settings import LinkSettings
from trex_gui.model.device import Link
from trex_gui.protocol.commands import SetParameter
from trex_gui.protocol.line_settings import Detection, LineSettings
from trex_gui.runtime import open_transport
from trex_gui.views.find_dialog import FindDialog
from trex_gui.window import Program

if sys.platform == "win32":
    pytest.skip("has no pseudo-terminals", allow_module_level=True)

WidgetT = TypeVar("WidgetT", bound=QWidget)

EVEN = LineSettings(57600, Detection.EVEN)


class Person:
    """What a person can do and see, by the names of the widgets."""

    def __init__(self, program: Program, qtbot: QtBot) -> None:
        self.program = program
        self.qtbot = qtbot

    def find(self, kind: type[WidgetT], name: str) -> WidgetT:
        widget = self.program.window.findChild(kind, name)
        assert isinstance(widget, kind), name
        return widget

    def sees(self, name: str) -> bool:
        widget = self.program.window.findChild(QWidget, name)
        return widget is not None and widget.isVisible()

    def press(self, name: str) -> None:
        button = self.find(QAbstractButton, name)
        assert button.isVisible(), f"{name} is hidden"
        assert button.isEnabled(), f"{name} is greyed"
        QTest.mouseClick(button, Qt.MouseButton.LeftButton)

    def text(self, name: str) -> str:
        return self.find(QLabel, name).text()

    def wait(self, condition: Callable[[], bool]) -> None:
        self.qtbot.waitUntil(condition, timeout=60_000)

    @property
    def dialog(self) -> FindDialog:
        return self.find(FindDialog, "findDialog")

    def look_on(self, *urls: str) -> None:
        """Open the dialog and tick these ports alone."""
        self.press("findButton")
        assert self.dialog.isVisible()
        ports = self.find(QListWidget, "findPorts")
        for row in range(ports.count()):
            item = ports.item(row)
            ticked = any(item.text().startswith(url) for url in urls)
            item.setCheckState(Qt.CheckState.Checked if ticked else Qt.CheckState.Unchecked)
        self.press("findStartButton")

    def wait_for_the_end(self) -> None:
        self.wait(lambda: not self.program.connector.finder.running)


@pytest.fixture(autouse=True)
def _no_other_ports(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("serial.tools.list_ports.comports", list)


@pytest.fixture
def person(_no_other_ports: None, program: Program, qtbot: QtBot) -> Person:
    return Person(program, qtbot)


def set_to(simulator: SimulatedDevice, line: LineSettings) -> None:
    """Store UART settings in a board and switch it off and on."""
    settings = LinkSettings(simulator.url)
    client = Client(open_transport(settings), settings)
    client.request(SetParameter(0x7E, line.to_wire()))
    client.close()
    simulator.do("power cycle")


def test_a_board_at_unknown_settings_is_found_and_connected_to(
    person: Person, program: Program, quick_simulator: SimulatedDevice
) -> None:
    set_to(quick_simulator, LineSettings(57600))
    program.ports.add_typed(quick_simulator.url)
    person.look_on(quick_simulator.url)
    bar = person.find(QProgressBar, "findProgress")
    said: list[tuple[str, int]] = []
    program.connector.finder.progressed.connect(
        lambda: said.append((person.text("findProgressText"), bar.maximum()))
    )
    assert person.find(QAbstractButton, "findCancelButton").isEnabled()
    assert not person.find(QAbstractButton, "findStartButton").isEnabled()
    person.wait(lambda: person.sees("connectFound0"))
    at_115200 = [most for text, most in said if text.startswith("Looking for TReX at 115200")]
    assert set(at_115200) == {93}
    assert person.text("findText0").startswith(
        f"TReX 1.2 on {quick_simulator.url} at 57600 8N1, device 7."
    )
    person.wait_for_the_end()
    assert person.text("findProgressText") == "1 board found."
    person.press("connectFound0")
    person.wait(lambda: program.device.link is Link.UP)
    assert program.device.settings is not None
    assert program.device.settings.line == LineSettings(57600)
    assert person.find(QToolButton, "lineButton").text() == "57600 8N1"
    shown = quick_simulator.show()
    assert all(motor["direction"] == "brake" for motor in shown["motors"])


@pytest.mark.slow
@pytest.mark.timeout(120)
@pytest.mark.filterwarnings("ignore:set(Daemon|Name):DeprecationWarning")
def test_a_board_with_parity_is_found_where_parity_can_be_seen(
    person: Person,
    program: Program,
    start_simulator: StartSimulator,
) -> None:
    simulator = start_simulator("--unpaced", "--rfc2217", "127.0.0.1:0")
    set_to(simulator, EVEN)
    program.ports.add_typed(simulator.url)
    program.connector.finder.start([program.ports.entries[-2]])
    person.press("findButton")
    assert person.sees("findCancelButton")
    person.wait_for_the_end()
    (finding,) = program.connector.finder.findings
    assert finding.text == f"TReX 1.2 on {simulator.url} at 57600 8E1, device 7."
    person.press("connectFound0")
    person.wait(lambda: program.device.link is Link.UP)
    assert program.device.settings is not None
    assert program.device.settings.line == EVEN


def test_a_search_can_be_cancelled(
    person: Person, program: Program, quick_simulator: SimulatedDevice
) -> None:
    quick_simulator.do("power off")
    program.ports.add_typed(quick_simulator.url)
    person.look_on(quick_simulator.url)
    person.wait(lambda: program.connector.finder.done > 1)
    person.press("findCancelButton")
    person.wait_for_the_end()
    assert person.text("findProgressText") == "The search was broken off."
    assert person.find(QAbstractButton, "findStartButton").isEnabled()
    assert not person.sees("findText0")
    quick_simulator.do("power on")


def test_closing_the_dialog_ends_the_search(
    person: Person, program: Program, quick_simulator: SimulatedDevice
) -> None:
    quick_simulator.do("power off")
    program.ports.add_typed(quick_simulator.url)
    person.look_on(quick_simulator.url)
    person.press("findCloseButton")
    person.wait_for_the_end()
    assert program.connector.finder.summary == "The search was broken off."
    quick_simulator.do("power on")


def test_closing_the_window_ends_the_search(
    person: Person, program: Program, quick_simulator: SimulatedDevice
) -> None:
    quick_simulator.do("power off")
    program.ports.add_typed(quick_simulator.url)
    person.look_on(quick_simulator.url)
    program.window.close()
    assert not program.connector.finder.running
    assert not person.dialog.isVisible()
    quick_simulator.do("power on")


def test_where_nobody_answers_it_says_what_to_look_at(
    person: Person,
    program: Program,
    quick_simulator: SimulatedDevice,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    few = list(attempts())[:3]  # all of them take half a minute
    monkeypatch.setattr("trex_gui.link.discovery.attempts", lambda *, full: few)
    quick_simulator.do("power off")
    program.ports.add_typed(quick_simulator.url)
    person.look_on(quick_simulator.url)
    person.wait_for_the_end()
    assert person.text("findText0").startswith(f"No TReX answers on {quick_simulator.url} at any")
    assert not person.sees("connectFound0")
    assert person.text("findProgressText") == "No board was found."
    quick_simulator.do("power on")


def test_a_port_that_another_program_has_is_told(
    person: Person, program: Program, quick_simulator: SimulatedDevice
) -> None:
    other = open_transport(LinkSettings(quick_simulator.url))
    program.ports.add_typed(quick_simulator.url)
    person.look_on(quick_simulator.url)
    person.wait_for_the_end()
    other.close()
    assert "is in use" in person.text("findText0")


def test_the_port_of_this_window_is_not_searched_until_it_is_given_back(
    person: Person, program: Program, quick_simulator: SimulatedDevice
) -> None:
    url = quick_simulator.url
    program.connector.connect_to(program.ports.add_typed(url))
    person.wait(lambda: program.device.link is Link.UP)
    person.press("findButton")
    ports = person.find(QListWidget, "findPorts")
    assert f"{url} – connected to this window" in [
        ports.item(row).text() for row in range(ports.count())
    ]
    assert person.text("findBusyLabel").startswith(f"{url} is connected to this window")
    person.press("findDisconnectButton")
    person.wait(lambda: program.device.link is Link.NONE)
    assert not person.sees("findBusyLabel")
    person.press("findStartButton")
    person.wait(lambda: person.sees("connectFound0"))
    person.wait_for_the_end()


def test_who_gets_no_answer_is_pointed_to_find(
    person: Person, program: Program, quick_simulator: SimulatedDevice
) -> None:
    quick_simulator.do("power off")
    program.connector.connect_to(program.ports.add_typed(quick_simulator.url))
    person.wait(lambda: program.device.link is Link.NONE)
    assert person.text("bannerText").endswith(" Find a board (Ctrl+Shift+F) tries every setting.")
    action = program.window.findChild(QAction, "findAction")
    assert action is not None
    action.trigger()
    assert person.dialog.isVisible()
    quick_simulator.do("power on")
