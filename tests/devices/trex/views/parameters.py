"""Driver for the parameter table and its editors."""

from PySide6.QtCore import QModelIndex, QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QWidget
from pytestqt.qtbot import QtBot

from tests.support.window import LEFT, WidgetDriver
from trex_gui.devices.trex.model.linter import SettingsLinter
from trex_gui.devices.trex.model.parameters.parameters import ParameterRole
from trex_gui.devices.trex.model.parameters.text import ParameterColumn
from trex_gui.devices.trex.model.settings.draft import SettingsDraft
from trex_gui.devices.trex.protocol.parameters import ParameterSet
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.views.pages.parameters.page import ParameterTable
from trex_gui.devices.trex.views.pages.parameters.view import ParameterView


class ParametersDriver(WidgetDriver):
    """Parameter table with a draft of settings.

    Attributes:
        rejected: messages about rejected input.
    """

    def __init__(self, qtbot: QtBot) -> None:
        self.draft = SettingsDraft()
        self.model = self.draft.parameters
        self.table = ParameterTable(self.draft, SettingsLinter(self.draft))
        super().__init__(self.table, qtbot)
        self.rejected: list[str] = []
        self.draft.parameters.rejected.connect(self.rejected.append)
        qtbot.addWidget(self.table)
        self.table.resize(1050, 700)
        self.table.show()
        self.view = self.find(ParameterView, "parametersView")

    def load(self, specs: ParameterSet, **stored: int) -> None:
        """Load a board with factory defaults, except for the `stored` values."""
        values = {spec.key: spec.default for spec in specs.readable} | stored
        self.model.load(specs, values, {}, power_cycled=True)
        self.draft.loaded.emit()

    def open_file(self, specs: ParameterSet, **values: int) -> None:
        """Load a settings file that contains only these values."""
        self.draft.load_settings(Settings(specs.model, specs.firmware, values))

    # --- Rows ---------------------------------------------------------------------------

    @property
    def headings(self) -> list[QModelIndex]:
        rows = (row for row in range(self.model.rowCount()) if not self.view.isRowHidden(row))
        cells = (self.model.index(row, 0) for row in rows)
        return [cell for cell in cells if cell.data(ParameterRole.GROUP) is not None]

    @property
    def current(self) -> str:
        """Key of the current parameter."""
        return self.view.current_key

    def search(self, words: str) -> None:
        self.type_into("parameterSearch", words, enter=False)
        if not words:
            QTest.keyClick(self.find(QWidget, "parameterSearch"), Qt.Key.Key_Delete)

    def place_of(self, index: QModelIndex) -> QPoint:
        self.view.scrollTo(index)
        return self.view.visualRect(index).center()

    def cell(self, key: str, column: ParameterColumn | None = None) -> QModelIndex:
        """Return the value cell of a parameter, or another cell of its row."""
        value = self.model.index_of(key)
        return value if column is None else value.siblingAtColumn(column)

    def click_cell(self, key: str, column: ParameterColumn | None = None) -> None:
        place = self.place_of(self.cell(key, column))
        QTest.mouseClick(self.view.viewport(), LEFT, pos=place)

    def go_to(self, key: str) -> None:
        self.view.setCurrentIndex(self.cell(key))

    def press(self, key: Qt.Key, modifier: Qt.KeyboardModifier | None = None) -> None:
        QTest.keyClick(self.view, key, modifier or Qt.KeyboardModifier.NoModifier)

    def focus_view(self) -> None:
        self.table.activateWindow()
        self.view.setFocus()
        self.wait(self.view.hasFocus)

    # --- Editors ------------------------------------------------------------------------

    def open_with_mouse(self, key: str, column: ParameterColumn | None = None) -> QWidget:
        """Double-click a cell. Return its editor."""
        place = self.place_of(self.cell(key, column))
        QTest.mouseClick(self.view.viewport(), LEFT, pos=place)
        QTest.mouseDClick(self.view.viewport(), LEFT, pos=place)
        return self.editor(key)

    def open_with_keys(self, key: str) -> QWidget:
        """Press F2 on a parameter. Return its editor."""
        self.go_to(key)
        self.press(Qt.Key.Key_F2)
        return self.editor(key)

    def editor(self, key: str) -> QWidget:
        editor = self.view.indexWidget(self.model.index_of(key))
        assert editor is not None, key
        return editor

    def is_editing(self, key: str) -> bool:
        return self.view.indexWidget(self.model.index_of(key)) is not None

    def close_editor(self, key: str) -> None:
        QTest.keyClick(self.editor(key), Qt.Key.Key_Escape)
        self.wait_for_no_editor(key)

    def wait_for_no_editor(self, key: str) -> None:
        self.wait(lambda: not self.is_editing(key))

    def wait_for_value(self, key: str, wire: int | None) -> None:
        self.wait(lambda: self.model.values.value_of(key) == wire)
