"""Fields for minimum, neutral, maximum and deadband."""

from dataclasses import replace
from functools import partial

from PySide6.QtCore import QSignalBlocker, Signal, Slot
from PySide6.QtWidgets import QLabel, QWidget

from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.devices.trex.protocol.channel_text import wrong_order
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.views.count_editor import CountEditor
from trex_gui.ui.widgets.bar import NO_VALUE
from trex_gui.ui.widgets.builders import grid, label, named, row
from trex_gui.ui.widgets.labels import Muted


class CalibrationFields(QWidget):
    """Four fields in µs or V, each with its counts; arrow keys step by one count.

    Signals:
        edited: a valid calibration, and the run of steps that it belongs to: an object, or
            `None` for a typed value. Undo reverts a run at once.
        rejected: why what was typed is invalid, for the user; and the name of the field whose
            value conflicts with another, empty when it is not a value at all.
    """

    edited = Signal(object, object)
    rejected = Signal(str, str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._source = InputSource.RC
        self._calibration: Calibration | None = None
        self._editors: dict[str, CountEditor] = {}
        self._counts: dict[str, QLabel] = {}
        self._run = object()
        titles = {
            "minimum": self.tr("Mi&nimum"),
            "neutral": self.tr("Neu&tral"),
            "maximum": self.tr("Ma&ximum"),
            "deadband": self.tr("Dead&band ±"),
        }
        layout = grid(self, margins=0, spacing=(12, 2), stretch=[(each, 1) for each in range(4)])
        for number, (field, title) in enumerate(titles.items()):
            editor = named(
                CountEditor(self._source, self),
                f"{field}Edit",
                accessible=title.replace("&", ""),
            )
            counts = named(Muted("", self), f"{field}Counts")
            counts.setWordWrap(False)
            layout.addLayout(row(label(self, text=title, buddy=editor), 1, counts), 0, number)
            layout.addWidget(editor, 1, number)
            editor.valueChanged.connect(partial(self._on_value_changed, field))
            editor.editingFinished.connect(self._on_run_ended)
            editor.rejected.connect(self._on_invalid_text)
            self._editors[field] = editor
            self._counts[field] = counts

    def show_calibration(
        self, source: InputSource, calibration: Calibration | None, *, editable: bool
    ) -> None:
        """Show these values; `None`: unknown."""
        self._source = source
        self._calibration = calibration
        for field, editor in self._editors.items():
            editor.set_source(source)
            editor.setEnabled(editable and calibration is not None)
            count = getattr(calibration, field) if calibration is not None else 0
            with QSignalBlocker(editor):
                editor.setSpecialValueText(NO_VALUE if calibration is None else "")
                editor.setValue(count)
            text = self.tr("= 1 count") if count == 1 else self.tr("= {0} counts").format(count)
            self._counts[field].setText(text if calibration is not None else "")

    def _on_value_changed(self, field: str, count: int) -> None:
        calibration = self._calibration
        if calibration is None:
            return
        wanted = replace(calibration, **{field: count})
        if wrong := wrong_order(wanted, self._source):
            self.show_calibration(self._source, calibration, editable=True)
            self.rejected.emit(wrong, field)
        elif self._editors[field].stepping:
            self.edited.emit(wanted, self._run)
        else:
            self._on_run_ended()
            self.edited.emit(wanted, None)

    @Slot(str)
    def _on_invalid_text(self, why: str) -> None:
        self.rejected.emit(why, "")

    @Slot()
    def _on_run_ended(self) -> None:
        self._run = object()
