"""The row above the parameter table: what of it is shown, and how it is edited."""

from PySide6.QtCore import QSettings, QSignalBlocker, Slot
from PySide6.QtGui import QKeySequence, QShortcut
from PySide6.QtWidgets import QCheckBox, QComboBox, QLineEdit, QWidget

from trex_gui.devices.trex.model.parameters.filter import ParameterFilter
from trex_gui.ui.widgets.builders import label, row

_BOTH_MOTORS = "parameters/both_motors"


class ParameterFilters(QWidget):
    """Words to search for, a group, ticks for what is worth a look, and one for both motors."""

    def __init__(self, rows: ParameterFilter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._rows = rows
        self._store = QSettings(self)

        self._words = QLineEdit(self)
        self._words.setObjectName("parameterSearch")
        self._words.setAccessibleName(self.tr("Search parameters"))
        self._words.setPlaceholderText(self.tr("Search names and descriptions (Ctrl+F)"))
        self._words.setClearButtonEnabled(True)
        self._group = QComboBox(self)
        self._group.setObjectName("parameterGroup")
        self._group.setAccessibleName(self.tr("Group of parameters"))
        self._modified = QCheckBox(self.tr("Modified only"), self)
        self._modified.setObjectName("modifiedOnly")
        self._modified.setToolTip(self.tr("Show only what you have changed"))
        self._not_default = QCheckBox(self.tr("Not default only"), self)
        self._not_default.setObjectName("notDefaultOnly")
        self._not_default.setToolTip(self.tr("Show only values that differ from their default"))
        self._both = QCheckBox(self.tr("Both motors as one"), self)
        self._both.setObjectName("bothMotors")
        self._both.setToolTip(
            self.tr("What you change for one motor is changed for the other, too, in one step")
        )
        self._count = label(self, "parameterCount")

        layout = row(
            (self._words, 1),
            self._count,
            self._group,
            self._modified,
            self._not_default,
            into=self,
            margins=0,
        )
        layout.addSpacing(layout.spacing())
        layout.addWidget(self._both)

        QShortcut(QKeySequence.StandardKey.Find, self, self._on_find)
        self._words.textChanged.connect(rows.set_words)
        self._group.currentIndexChanged.connect(self._on_group_chosen)
        self._modified.toggled.connect(rows.set_modified_only)
        self._not_default.toggled.connect(rows.set_not_default_only)
        self._both.toggled.connect(self._on_both_toggled)
        for changed in (rows.rowsInserted, rows.rowsRemoved, rows.modelReset, rows.layoutChanged):
            changed.connect(self._show_count)
        rows.modelReset.connect(self._on_reset)
        self._both.setChecked(self._store.value(_BOTH_MOTORS, False, bool) is True)
        self._on_reset()

    def clear(self) -> None:
        """Show every row again."""
        self._words.clear()
        self._group.setCurrentIndex(0)
        self._modified.setChecked(False)
        self._not_default.setChecked(False)

    @Slot()
    def _on_find(self) -> None:
        self._words.setFocus()
        self._words.selectAll()

    @Slot()
    def _on_reset(self) -> None:
        """Offer the groups that there are."""
        parameters = self._rows.parameters
        wanted = self._group.currentData() or ""
        with QSignalBlocker(self._group):
            self._group.clear()
            self._group.addItem(self.tr("All groups"), "")
            for group in parameters.groups:
                self._group.addItem(parameters.title_of(group), group)
            self._group.setCurrentIndex(max(0, self._group.findData(wanted)))
        self.setEnabled(parameters.count > 0)
        if self._group.currentData() != wanted:
            self._on_group_chosen(0)
        self._show_count()

    @Slot(int)
    def _on_group_chosen(self, _index: int) -> None:
        self._rows.set_group(str(self._group.currentData()))

    @Slot(bool)
    def _on_both_toggled(self, both: bool) -> None:
        self._rows.parameters.set_both_motors(both)
        self._store.setValue(_BOTH_MOTORS, both)

    @Slot()
    def _show_count(self) -> None:
        shown, total = self._rows.shown, self._rows.parameters.count
        self._count.setVisible(shown < total)
        text = self.tr("None of {1} matches") if shown == 0 else self.tr("{0} of {1}")
        self._count.setText(text.format(shown, total))
