"""Driver of the window with an Aracna, and its simulated robot."""

import json
from collections.abc import Callable
from typing import Any

from PySide6.QtCore import QItemSelectionModel
from PySide6.QtWidgets import QLabel, QListView, QMenu, QSlider, QSpinBox, QWidget
from pytestqt.qtbot import QtBot

from tests.support.program import aracna
from tests.support.window import WindowDriver
from trex_gui.devices.aracna.session.messages import Moving, SpeedsHeld
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.program import Program

ROBOT_PAGE, POSES_PAGE, PROBLEMS_PAGE = range(3)


class RobotWindow(WindowDriver):
    """Driver of the whole program with an Aracna.

    Attributes:
        simulator: process of the simulated robot.
        goals: goals of the sent motions, in order.
        speeds: speeds that the robot has confirmed, in order.
    """

    def __init__(self, program: Program, qtbot: QtBot) -> None:
        super().__init__(program, qtbot)
        self.simulator = aracna(program).controller.simulator
        self.goals: list[tuple[int, ...]] = []
        self.speeds: list[tuple[int, ...]] = []
        self._silences = 0
        self.robot.link_changed.connect(self._count_silences)
        self.robot.reported.connect(self._record)

    def _count_silences(self) -> None:
        if self.robot.link is ConnectionState.NOT_RESPONDING:
            self._silences += 1

    def _record(self, report: object) -> None:
        if isinstance(report, Moving):
            self.goals.append(report.goals)
        elif isinstance(report, SpeedsHeld):
            self.speeds.append(report.held)

    # --- Connect ------------------------------------------------------------------------

    @property
    def port(self) -> str:
        """Port shown in the list."""
        return self.combo("portCombo").currentText()

    def is_idle(self) -> bool:
        """Return whether no device is connected."""
        return self.program.device_manager.is_idle

    def select_demo(self, kind: str = "aracna") -> None:
        """Select a simulated device in the port list and connect to it."""
        self.connect_port(self.program.ports.demo_of(kind))
        self.wait_until_up(kind)

    def press_connect(self, kind: str = "aracna") -> None:
        """Press Connect and wait until the device is connected."""
        self.click("connectButton")
        self.wait_until_up(kind)

    def press_disconnect(self) -> None:
        self.click("connectButton")
        self.wait(self.is_idle)

    def wait_for_silence(self, cause: Callable[[], object]) -> None:
        """Call `cause`. Wait until the robot stops responding, as it does during a reset."""
        previous = self._silences
        cause()
        self.wait(lambda: self._silences > previous)

    # --- The simulated robot ------------------------------------------------------------

    def control(self, line: str) -> str:
        """Send a control line to the simulator. Return the reply."""
        replies: list[str] = []
        self.simulator.send(line, replies.append)
        self.wait(lambda: replies)
        assert replies[0].startswith("ok"), replies
        return replies[0].removeprefix("ok").strip()

    def simulated(self) -> dict[str, Any]:
        """Return the state of the simulated robot."""
        state: dict[str, Any] = json.loads(self.control("show"))
        return state

    def servos_turn(self) -> bool:
        return any(servo["moving"] for servo in self.simulated()["servos"])

    # --- Move ---------------------------------------------------------------------------

    def wait_for_motion(self, before: int) -> None:
        """Wait until more than `before` motions were sent and the last motion is over."""
        self.wait(lambda: len(self.goals) > before and self.robot.state.moving is None)

    def move(self) -> None:
        """Press Move. Wait for the robot's reply."""
        before = self.robot.state.moved
        self.click("aracnaMoveButton")
        self.wait(lambda: self.robot.state.moved not in (None, before))

    def block_and_lose_motor(self, motor: int) -> None:
        """Block a motor, then make it fail while it moves."""
        self.control(f"servo {motor} block")
        slider = self.find(QSlider, f"aracnaSlider{motor}")
        self.drag(slider.objectName(), slider.value() - 32)
        self.click("aracnaMoveButton")
        self.wait(lambda: self.simulated()["servos"][motor]["goal"] == slider.value())
        self.control(f"servo {motor} dead")
        self.control(f"servo {motor} free")
        self.wait(lambda: self.robot.state.stuck is not None)

    def page_text(self, page: str, name: str) -> str:
        """Return the text of a label on a page. Other pages may have a label of this name."""
        label = self.find(QWidget, page).findChild(QLabel, name)
        assert label is not None
        return label.text()

    def goal_box(self, motor: int) -> QSpinBox:
        return self.find(QSpinBox, f"aracnaGoal{motor}")

    # --- Pages --------------------------------------------------------------------------

    def show_page(self, index: int) -> None:
        """Show a page of the robot by its menu entry."""
        key = ("robot", "poses", "errors")[index]
        self.trigger(f"aracna_{key}")
        assert aracna(self.program).workspace.pages.currentIndex() == index

    def select_row(self, list_name: str, text: str) -> None:
        """Select the row of a list that begins with a text."""
        view = self.find(QListView, list_name)
        model = view.model()
        rows = [model.index(row, 0) for row in range(model.rowCount())]
        index = next(each for each in rows if str(each.data()).startswith(text))
        view.scrollTo(index)
        view.selectionModel().setCurrentIndex(
            index, QItemSelectionModel.SelectionFlag.ClearAndSelect
        )

    @property
    def menus(self) -> list[str]:
        """Titles of the visible menus."""
        return [
            menu.title().replace("&", "")
            for action in self.window.menuBar().actions()
            if action.isVisible() and isinstance(menu := action.menu(), QMenu)
        ]

    # --- Mouse and keys -----------------------------------------------------------------

    def type_unconfirmed(self, name: str, text: str) -> None:
        """Type into a number box without leaving it."""
        self.wait(lambda: self.has(name))
        self.window.activateWindow()
        editor = self.find(QWidget, name)
        editor.setFocus()
        self.wait(editor.hasFocus)
        self.type_into(name, text, enter=False)
