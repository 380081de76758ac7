"""Try a value beyond a limit that no source confirms."""

from PySide6.QtCore import Qt, Slot
from PySide6.QtWidgets import QDialog, QWidget

from trex_gui.core.errors import BadRequest
from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.parameters.parameters import ParameterModel
from trex_gui.devices.trex.protocol.device_table import HIGHEST_WIRE
from trex_gui.ui.translations import error_sentence
from trex_gui.ui.widgets.builders import button, column, label, named, row, spin_box
from trex_gui.ui.widgets.labels import Note

_WIDTH = 480  # pixels


class WireDialog(QDialog):
    """Makes any wire value of one parameter an edit, which the review asks about."""

    def __init__(self, model: ParameterModel, key: str, parent: QWidget) -> None:
        super().__init__(parent)
        self.setObjectName("wireDialog")
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        spec = model.spec_of(key)
        self.setWindowTitle(spec.name)
        self._model, self._key = model, key
        text = tr(
            "{0} is {1}{2}. No document confirms this limit. You can try any wire value from "
            "0 to {3}. The board decides: it may reject the value, or store another "
            "one, and the program shows which. A value that the board stores is remembered for "
            "its firmware."
        )
        text = text.format(spec.name, spec.range_text(), spec.limits_mark, HIGHEST_WIRE)
        note = label(self, "wireNote", text, wrap=True)
        self._value = spin_box(self, "wireField", tr("Wire value"), 0, HIGHEST_WIRE)
        self._value.setValue(model.value_of(key) or 0)
        self._trouble = named(Note(2, self), "wireTrouble")
        self._accept = button(
            self, "tryWireButton", tr("&Try this value"), default=True, on_click=self._on_click
        )
        cancel = button(self, "cancelWireButton", tr("Cancel"), on_click=self.close)
        before = label(self, text=tr("&Wire value:"), buddy=self._value)
        column(
            note,
            row(before, self._value, 1),
            self._trouble,
            row(1, self._accept, cancel),
            into=self,
        )
        if (layout := self.layout()) is not None:
            self.resize(_WIDTH, layout.totalHeightForWidth(_WIDTH))
        model.modelReset.connect(self._on_board_changed)

    @Slot()
    def _on_board_changed(self) -> None:
        self._accept.setEnabled(self._model.can_edit(self._key))

    @Slot()
    def _on_click(self) -> None:
        try:
            self._model.edit(self._key, self._value.value(), forced=True)
        except BadRequest as error:
            self._trouble.show_note(error_sentence(error), alarming=True)
        else:
            self.close()
