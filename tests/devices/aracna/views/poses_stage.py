"""The page of poses on a library, driven with mouse and keyboard."""

from collections.abc import Sequence

from PySide6.QtCore import QModelIndex, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QAbstractItemView, QCheckBox, QLineEdit, QSpinBox
from pytestqt.qtbot import QtBot

from tests.support.window import LEFT, WidgetDriver
from trex_gui.devices.aracna.model.library import Library
from trex_gui.devices.aracna.model.robot import Robot
from trex_gui.devices.aracna.session.messages import Play, StepBegun
from trex_gui.devices.aracna.views.poses.name_list import NameList
from trex_gui.devices.aracna.views.poses.page import PosesPage
from trex_gui.ui.devices.connection import ConnectionState

EIGHT = (100, 200, 101, 201, 102, 202, 103, 203)


class StagedRobot(Robot):
    """A robot whose state is set by a test, and which keeps what it is requested to do.

    Attributes:
        plays, goals, scales: the requests, in order.
    """

    def __init__(self) -> None:
        super().__init__()
        self.plays: list[Play] = []
        self.goals: list[tuple[int, ...]] = []
        self.scales: list[float] = []

    def play(self, play: Play) -> bool:
        self.plays.append(play)
        return True

    def move(self, goals: Sequence[int]) -> bool:
        self.goals.append(tuple(goals))
        return True

    def set_time_scale(self, factor: float) -> None:
        self.scales.append(factor)


class PosesPageDriver(WidgetDriver):
    """A page on a library of its own.

    Attributes:
        messages: its messages and rejections, in order.
    """

    def __init__(self, qtbot: QtBot, robot: Robot) -> None:
        self.library = Library()
        self.page = PosesPage(robot, self.library)
        robot.setParent(self.page)
        super().__init__(self.page, qtbot)
        self.messages: list[str] = []
        robot.notifier.info.connect(self.messages.append)
        robot.notifier.error.connect(self.messages.append)
        self.page.resize(800, 600)
        self.page.show()
        qtbot.waitExposed(self.page)

    def close(self) -> None:
        self.page.close()
        self.page.deleteLater()

    def spin(self, name: str) -> QSpinBox:
        return self.find(QSpinBox, name)

    def check(self, name: str, on: bool) -> None:
        self.find(QCheckBox, name).setChecked(on)

    def names(self, name: str) -> NameList:
        return self.find(NameList, name)

    @property
    def steps(self) -> QAbstractItemView:
        return self.find(QAbstractItemView, "aracnaSteps")

    @property
    def summary(self) -> str:
        return self.text("aracnaPlaySummary")

    def choose_row(self, list_name: str, text: str) -> None:
        """Click on the row with a text."""
        view = self.names(list_name)
        index = self.index_of(view, text)
        view.scrollTo(index)
        point = view.visualRect(index).center()
        QTest.mouseClick(view.viewport(), LEFT, pos=point)
        assert view.currentIndex() == index

    def index_of(self, view: QAbstractItemView, text: str) -> QModelIndex:
        """Return the row with a text."""
        model = view.model()
        for row in range(model.rowCount()):
            if model.index(row, 0).data() == text:
                return model.index(row, 0)
        raise AssertionError(text)

    def type_name(self, list_name: str, name: str) -> None:
        """Type into the editor that is open in a list."""
        row = WidgetDriver(self.names(list_name), self.qtbot)
        editor = row.find_only(QLineEdit)
        editor.setText(name)
        QTest.keyClick(editor, Qt.Key.Key_Return)
        self.wait(lambda: not row.find_all(QLineEdit))  # Qt takes it later

    def pose_names(self) -> list[str]:
        return [pose.name for pose in self.library.project.poses]


class StagedPageDriver(PosesPageDriver):
    """A page on a robot whose state is set here."""

    def __init__(self, qtbot: QtBot) -> None:
        self.robot = StagedRobot()
        super().__init__(qtbot, self.robot)

    @property
    def plays(self) -> list[Play]:
        return self.robot.plays

    def connect(self) -> None:
        self.robot.link = ConnectionState.CONNECTED
        self.robot.changed.emit()

    def show_present(self, *present: int | None) -> None:
        self.robot.state.present = present
        self.robot.changed.emit()

    def show_playing(self, play: Play | None, step: StepBegun | None = None) -> None:
        self.robot.state.play, self.robot.state.step = play, step
        self.robot.changed.emit()
