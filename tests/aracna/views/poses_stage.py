"""A panel of poses on a library, driven with mouse and keyboard."""

from PySide6.QtCore import QModelIndex, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QCheckBox,
    QLabel,
    QLineEdit,
    QPushButton,
    QSpinBox,
    QToolButton,
    QWidget,
)
from pytestqt.qtbot import QtBot

from trex_gui.aracna.link.messages import Play
from trex_gui.aracna.model.library import Library
from trex_gui.aracna.views.poses.name_list import NameList
from trex_gui.aracna.views.poses.panel import PosesPanel

EIGHT = (100, 200, 101, 201, 102, 202, 103, 203)


class Stage:
    """A panel on a library, and what it asked for."""

    def __init__(self, qtbot: QtBot) -> None:
        self.qtbot = qtbot
        self.library = Library()
        self.panel = PosesPanel(self.library)
        self.plays: list[Play] = []
        self.said: list[str] = []
        self.gone_to: list[tuple[int, ...]] = []
        self.panel.play_requested.connect(self.plays.append)
        self.panel.go_to_requested.connect(self.gone_to.append)
        self.panel.told.connect(self.said.append)
        self.panel.refused.connect(self.said.append)
        self.panel.resize(640, 600)
        self.panel.show()
        qtbot.waitExposed(self.panel)

    def button(self, name: str) -> QAbstractButton:
        found = self.panel.findChild(QPushButton, name) or self.panel.findChild(QToolButton, name)
        assert found is not None
        return found

    def click(self, name: str) -> None:
        button = self.button(name)
        assert button.isEnabled()
        QTest.mouseClick(button, Qt.MouseButton.LeftButton)

    def spin(self, name: str) -> QSpinBox:
        found = self.panel.findChild(QSpinBox, name)
        assert found is not None
        return found

    def check(self, name: str, on: bool) -> None:
        box = self.panel.findChild(QCheckBox, name)
        assert box is not None
        box.setChecked(on)

    def names(self, name: str) -> NameList:
        found = self.panel.findChild(NameList, name)
        assert found is not None
        return found

    @property
    def steps(self) -> QAbstractItemView:
        found = self.panel.findChild(QAbstractItemView, "aracnaSteps")
        assert found is not None
        return found

    @property
    def summary(self) -> str:
        found = self.panel.findChild(QLabel, "aracnaPlaySummary")
        assert found is not None
        return found.text()

    def choose(self, where: str, text: str) -> None:
        """Click on the row with a text."""
        view = self.names(where)
        self.click_index(view, self.find(view, text))

    def find(self, view: QAbstractItemView, text: str) -> QModelIndex:
        model = view.model()
        for row in range(model.rowCount()):
            if model.index(row, 0).data() == text:
                return model.index(row, 0)
        raise AssertionError(text)

    def click_index(self, view: QAbstractItemView, index: QModelIndex) -> None:
        view.scrollTo(index)
        point = view.visualRect(index).center()
        QTest.mouseClick(view.viewport(), Qt.MouseButton.LeftButton, pos=point)
        assert view.currentIndex() == index

    def type_name(self, view: QWidget, name: str) -> None:
        """Type into the editor that is open in a list."""
        editor = view.findChild(QLineEdit)
        assert editor is not None
        editor.setText(name)
        QTest.keyClick(editor, Qt.Key.Key_Return)
        self.qtbot.waitUntil(lambda: view.findChild(QLineEdit) is None)  # Qt takes it later

    def pose_names(self) -> list[str]:
        return [pose.name for pose in self.library.poses]
