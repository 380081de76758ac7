"""The row above the parameter table that narrows it down."""

from PySide6.QtCore import Slot
from PySide6.QtGui import QKeySequence, QShortcut
from PySide6.QtWidgets import QCheckBox, QComboBox, QHBoxLayout, QLabel, QLineEdit, QWidget

from trex_gui.model.parameter_filter import ParameterFilter


class ParameterFilters(QWidget):
    """Words to search for, a group, and ticks for what is worth a look."""

    def __init__(self, rows: ParameterFilter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._rows = rows

        self._words = QLineEdit(self)
        self._words.setObjectName("parameterSearch")
        self._words.setAccessibleName(self.tr("Search parameters"))
        self._words.setPlaceholderText(self.tr("Search names and descriptions (Ctrl+F)"))
        self._words.setClearButtonEnabled(True)
        self._group = QComboBox(self)
        self._group.setObjectName("parameterGroup")
        self._group.setAccessibleName(self.tr("Group of parameters"))
        for title, group in (
            (self.tr("All groups"), ""),
            (self.tr("Motors"), "motors"),
            (self.tr("Channels"), "channels"),
            (self.tr("Serial"), "serial"),
            (self.tr("System"), "system"),
        ):
            self._group.addItem(title, group)
        self._modified = QCheckBox(self.tr("Modified only"), self)
        self._modified.setObjectName("modifiedOnly")
        self._modified.setToolTip(self.tr("Show only what waits for Apply"))
        self._not_default = QCheckBox(self.tr("Not default only"), self)
        self._not_default.setObjectName("notDefaultOnly")
        self._not_default.setToolTip(self.tr("Show only what differs from the factory's value"))
        self._count = QLabel(self)
        self._count.setObjectName("parameterCount")

        layout = QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self._words, 1)
        layout.addWidget(self._group)
        layout.addWidget(self._modified)
        layout.addWidget(self._not_default)
        layout.addWidget(self._count)

        QShortcut(QKeySequence.StandardKey.Find, self, self._words.setFocus)
        self._words.textChanged.connect(rows.set_words)
        self._group.currentIndexChanged.connect(self._on_group_chosen)
        self._modified.toggled.connect(rows.set_modified_only)
        self._not_default.toggled.connect(rows.set_not_default_only)
        for changed in (rows.rowsInserted, rows.rowsRemoved, rows.modelReset, rows.layoutChanged):
            changed.connect(self._show_count)
        self._show_count()

    def clear(self) -> None:
        """Show every row again."""
        self._words.clear()
        self._group.setCurrentIndex(0)
        self._modified.setChecked(False)
        self._not_default.setChecked(False)

    @Slot(int)
    def _on_group_chosen(self, _index: int) -> None:
        self._rows.set_group(str(self._group.currentData()))

    @Slot()
    def _show_count(self) -> None:
        shown, total = self._rows.rowCount(), self._rows.sourceModel().rowCount()
        self._count.setVisible(shown < total)
        text = self.tr("None of {1} matches") if shown == 0 else self.tr("{0} of {1}")
        self._count.setText(text.format(shown, total))
