"""The parameter table in the hands of a person, for tests."""

from typing import TypeVar

from PySide6.QtCore import QModelIndex, QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QWidget
from pytestqt.qtbot import QtBot

from trex_gui.model.adviser import Adviser
from trex_gui.model.parameter_filter import ParameterFilter
from trex_gui.model.parameters import Column
from trex_gui.model.settings_draft import SettingsDraft
from trex_gui.protocol.parameters import ParameterSet
from trex_gui.settings.document import Settings
from trex_gui.views.widgets.parameter_table import ParameterTable
from trex_gui.views.widgets.parameter_view import ParameterView

WidgetT = TypeVar("WidgetT", bound=QWidget)


class Person:
    """Has a draft of settings in a table of its own before them."""

    def __init__(self, qtbot: QtBot) -> None:
        self.qtbot = qtbot
        self.draft = SettingsDraft()
        self.model = self.draft.parameters
        self.table = ParameterTable(self.draft, Adviser(self.draft))
        self.refused: list[str] = []
        self.table.refused.connect(self.refused.append)
        qtbot.addWidget(self.table)
        self.table.resize(1050, 700)
        self.table.show()
        self.view = self.find(ParameterView, "parametersView")

    def load(self, specs: ParameterSet, **other: int) -> None:
        """Let a board have the factory's values, except for some."""
        values = {spec.key: spec.default for spec in specs.readable} | other
        self.model.load(specs, values, {}, power_cycled=True)
        self.draft.loaded.emit()

    def open_file(self, specs: ParameterSet, **given: int) -> None:
        self.draft.take_settings(Settings(specs.model, specs.firmware, given))

    def find(self, kind: type[WidgetT], name: str) -> WidgetT:
        found = self.table.findChild(kind, name)
        assert isinstance(found, kind), name
        return found

    @property
    def rows(self) -> ParameterFilter:
        rows = self.view.model()
        assert isinstance(rows, ParameterFilter)
        return rows

    def place_of(self, index: QModelIndex) -> QPoint:
        self.view.scrollTo(index)
        return self.view.visualRect(index).center()

    def click(self, key: str, column: Column) -> None:
        place = self.place_of(self.rows.index_of(key, column))
        QTest.mouseClick(self.view.viewport(), Qt.MouseButton.LeftButton, pos=place)

    def go_to(self, key: str, column: Column = Column.VALUE) -> None:
        self.view.setCurrentIndex(self.rows.index_of(key, column))

    def press(self, key: Qt.Key) -> None:
        QTest.keyClick(self.view, key)

    def open_with_mouse(self, key: str, column: Column = Column.VALUE) -> QWidget:
        """Click a cell twice; return the editor that opens."""
        place = self.place_of(self.rows.index_of(key, column))
        left = Qt.MouseButton.LeftButton
        QTest.mouseClick(self.view.viewport(), left, pos=place)
        QTest.mouseDClick(self.view.viewport(), left, pos=place)
        return self.editor(key)

    def open_with_keys(self, key: str) -> QWidget:
        self.go_to(key)
        self.press(Qt.Key.Key_F2)
        return self.editor(key)

    def editor(self, key: str) -> QWidget:
        editor = self.view.indexWidget(self.rows.index_of(key))
        assert editor is not None, key
        return editor

    def is_editing(self, key: str) -> bool:
        return self.view.indexWidget(self.rows.index_of(key)) is not None

    def close_editor(self, key: str) -> None:
        QTest.keyClick(self.editor(key), Qt.Key.Key_Escape)
        self.wait_for_no_editor(key)

    def wait_for_no_editor(self, key: str) -> None:
        self.qtbot.waitUntil(lambda: not self.is_editing(key))

    def wait_for_value(self, key: str, wire: int | None) -> None:
        self.qtbot.waitUntil(lambda: self.model.value_of(key) == wire)
