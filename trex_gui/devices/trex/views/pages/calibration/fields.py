"""Minimum, neutral, maximum and deadband to type; what the board would refuse is not taken."""

from dataclasses import replace
from functools import partial

from PySide6.QtCore import QSignalBlocker, Signal, Slot
from PySide6.QtWidgets import QGridLayout, QHBoxLayout, QLabel, QWidget

from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.devices.trex.protocol.channel_text import wrong_order
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.views.count_editor import CountEditor
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets.bar import NO_VALUE


class CalibrationFields(QWidget):
    """Four fields in µs or V, each with its counts; arrow keys step by one count.

    Signals:
        wished: a calibration that the board would take.
        stepped: the same, one step further; and an object that stays the same until the field is
            left or typed into: such steps are taken back at once.
        refused: why what was typed was not taken, for people; and the name of the field whose
            value stands in the way of another, empty when it is no value at all.
    """

    wished = Signal(object)
    stepped = Signal(object, object)
    refused = Signal(str, str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._source = InputSource.RC
        self._calibration: Calibration | None = None
        self._editors: dict[str, CountEditor] = {}
        self._counts: dict[str, QLabel] = {}
        self._run = object()
        layout = QGridLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setHorizontalSpacing(12)
        layout.setVerticalSpacing(2)
        for column, (field, title) in enumerate(
            (
                ("minimum", self.tr("Mi&nimum")),
                ("neutral", self.tr("Neu&tral")),
                ("maximum", self.tr("Ma&ximum")),
                ("deadband", self.tr("Dead&band ±")),
            )
        ):
            editor = CountEditor(self._source, self)
            editor.setObjectName(f"{field}Edit")
            editor.setAccessibleName(title.replace("&", ""))
            label = QLabel(title, self)
            label.setBuddy(editor)
            counts = QLabel(self)
            counts.setObjectName(f"{field}Counts")
            head = QHBoxLayout()
            head.setSpacing(8)
            head.addWidget(label)
            head.addStretch(1)
            head.addWidget(counts)
            layout.addLayout(head, 0, column)
            layout.addWidget(editor, 1, column)
            layout.setColumnStretch(column, 1)
            editor.valueChanged.connect(partial(self._on_edited, field))
            editor.editingFinished.connect(self._on_run_ended)
            editor.refused.connect(self._on_no_value)
            self._editors[field] = editor
            self._counts[field] = counts
        theme().changed.connect(self._on_theme_changed)
        self._on_theme_changed()

    def show_calibration(
        self, source: InputSource, calibration: Calibration | None, *, editable: bool
    ) -> None:
        """Show these values; `None`: they are not known."""
        self._source = source
        self._calibration = calibration
        for field, editor in self._editors.items():
            editor.set_source(source)
            editor.setEnabled(editable and calibration is not None)
            count = getattr(calibration, field) if calibration is not None else 0
            with QSignalBlocker(editor):
                editor.setSpecialValueText(NO_VALUE if calibration is None else "")
                editor.setValue(count)
            words = self.tr("= 1 count") if count == 1 else self.tr("= {0} counts").format(count)
            self._counts[field].setText(words if calibration is not None else "")

    def _on_edited(self, field: str, count: int) -> None:
        calibration = self._calibration
        if calibration is None:
            return
        wanted = replace(calibration, **{field: count})
        if wrong := wrong_order(wanted, self._source):
            self.show_calibration(self._source, calibration, editable=True)
            self.refused.emit(wrong, field)
        elif self._editors[field].stepping:
            self.stepped.emit(wanted, self._run)
        else:
            self._on_run_ended()
            self.wished.emit(wanted)

    @Slot(str)
    def _on_no_value(self, why: str) -> None:
        self.refused.emit(why, "")

    @Slot()
    def _on_run_ended(self) -> None:
        self._run = object()

    @Slot()
    def _on_theme_changed(self) -> None:
        for label in self._counts.values():
            palette = label.palette()
            palette.setColor(label.foregroundRole(), theme().color("muted"))
            label.setPalette(palette)
