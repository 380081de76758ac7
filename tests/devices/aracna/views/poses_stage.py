"""A panel of poses on a library, driven with mouse and keyboard."""

from PySide6.QtCore import QModelIndex, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QAbstractItemView, QCheckBox, QLineEdit, QSpinBox
from pytestqt.qtbot import QtBot

from tests.support.window import LEFT, WidgetDriver
from trex_gui.devices.aracna.model.library import Library
from trex_gui.devices.aracna.session.messages import Play
from trex_gui.devices.aracna.views.poses.name_list import NameList
from trex_gui.devices.aracna.views.poses.panel import PosesPanel
from trex_gui.ui.notifier import Notifier

EIGHT = (100, 200, 101, 201, 102, 202, 103, 203)


class PosesPanelDriver(WidgetDriver):
    """A panel on a library of its own.

    Attributes:
        plays: the playbacks that the panel requested, in order.
        requested_goals: the positions that it requested with Go to, in order.
        messages: its messages and rejections, in order.
    """

    def __init__(self, qtbot: QtBot) -> None:
        self.library = Library()
        notifier = Notifier()
        self.panel = PosesPanel(self.library, notifier)
        notifier.setParent(self.panel)
        super().__init__(self.panel, qtbot)
        self.plays: list[Play] = []
        self.messages: list[str] = []
        self.requested_goals: list[tuple[int, ...]] = []
        self.panel.play_requested.connect(self.plays.append)
        self.panel.go_to_requested.connect(self.requested_goals.append)
        notifier.info.connect(self.messages.append)
        notifier.error.connect(self.messages.append)
        self.panel.resize(640, 600)
        self.panel.show()
        qtbot.waitExposed(self.panel)

    def close(self) -> None:
        self.panel.close()
        self.panel.deleteLater()

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
