"""Settings of another model or firmware: what is carried over, changed and left out."""

from pathlib import Path

from PySide6.QtCore import Signal, Slot
from PySide6.QtWidgets import QWidget

from trex_gui.core.errors import StudioError
from trex_gui.core.translation import tr
from trex_gui.devices.trex.client.reading import DeviceState
from trex_gui.devices.trex.model.settings.document import SettingsDocument
from trex_gui.devices.trex.protocol.device_table import Model, device_table
from trex_gui.devices.trex.settings.conversion import Conversion, Fate, convert
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.edit_in_place import amend
from trex_gui.devices.trex.settings.writer import write_settings
from trex_gui.devices.trex.views.text_table import TextTable
from trex_gui.ui.theme.icons import icon
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets.behaviour import ReusedDialog
from trex_gui.ui.widgets.builders import button, column, combo_box, label, row
from trex_gui.ui.widgets.placement import resize_with_font

_SIGNS = {
    Fate.CHANGED: ("edited", "icon"),
    Fate.LEFT_OUT: ("warning", "warning"),
    Fate.CARRIED_OVER: ("ok", "good"),
}


class ConversionView(QWidget):
    """The counts, and a table with a row for each setting of a file, changes first."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("conversionView")
        self._conversion: Conversion | None = None
        self._summary = label(self, "conversionSummary", wrap=True)
        title = tr("Converted settings")
        self._table = TextTable("conversionTable", title, (34, 26, 26), self)
        column(self._summary, (self._table, 1), into=self, margins=0)
        theme().changed.connect(self._fill)

    def show_conversion(self, conversion: Conversion) -> None:
        if conversion != self._conversion:
            self._conversion = conversion
            self._fill()

    @Slot()
    def _fill(self) -> None:
        conversion = self._conversion
        if conversion is None:
            return
        counts = (len(conversion.of(fate)) for fate in (Fate.CARRIED_OVER, *_SIGNS))
        text = tr("For a {0}: {1} carried over, {2} changed, {3} left out.")
        self._summary.setText(text.format(conversion.board, *counts))
        results = {
            Fate.CHANGED: tr("Changed."),
            Fate.LEFT_OUT: tr("Left out."),
            Fate.CARRIED_OVER: tr("Carried over."),
        }
        board = tr("For a {0}").format(conversion.board)
        titles = (tr("Setting"), tr("In the file"), board, tr("Result"))
        self._table.setHorizontalHeaderLabels(titles)
        rows = []
        for each in conversion.rows:
            result = f"{results[each.fate]} {each.reason}".rstrip()
            rows.append(
                (icon(*_SIGNS[each.fate]), (each.name, each.before, each.after or "–", result))
            )
        self._table.show_rows(rows)


class ConvertDialog(ReusedDialog):
    """Makes a new file of the settings of an editor, for another board; that file stays."""

    converted = Signal(object)  # the new `SettingsDocument`

    def __init__(
        self, document: SettingsDocument, state: DeviceState | None, parent: QWidget
    ) -> None:
        """Offer the board with this `state` first, if the file is not for it."""
        super().__init__(parent)
        self.setObjectName("convertDialog")
        self._document = document
        self.setWindowTitle(tr("Convert {0}").format(document.name))
        resize_with_font(self, 860, 520)
        boards = [(m, firmware) for m in device_table().models for firmware in m.firmware[::-1]]
        text, title = tr("{0}, firmware {1}"), tr("Board to convert for")
        items = [
            (text.format(model.name, firmware), (model, firmware)) for model, firmware in boards
        ]
        self._board = combo_box(
            self, "convertBoard", title, items=items, on_activate=self._on_changed
        )
        self._board.setCurrentIndex(boards.index(self._first_choice(state)))
        self._view = ConversionView(self)
        text = tr(
            "Opens the converted settings as a new file, with the comments of this one. {0} "
            "stays as it is."
        )
        note = label(self, "convertNote", text.format(document.name), wrap=True)
        self._convert = button(
            self, "convertButton", tr("&Convert"), default=True, on_click=self._on_clicked
        )
        cancel = button(self, "cancelConvertButton", tr("Cancel"), on_click=self.close)
        above = label(self, text=tr("Convert &for:"), buddy=self._board)
        choice, buttons = row(above, self._board, 1), row(1, self._convert, cancel)
        column(choice, (self._view, 1), note, buttons, into=self)
        document.changed.connect(self._on_changed)
        self._on_changed()

    def _first_choice(self, state: DeviceState | None) -> tuple[Model, str]:
        settings = self._document.settings
        own = None if settings is None else (settings.product, settings.specs.firmware)
        if state is not None and (state.signature.model, state.signature.firmware) != own:
            return state.signature.model, state.signature.firmware
        models = [model for model in device_table().models if own is None or model != own[0]]
        return models[0], models[0].firmware[-1]

    def _conversion(self) -> Conversion | None:
        settings: Settings | None = self._document.settings
        model, firmware = self._board.currentData()
        return None if settings is None else convert(settings, model, firmware)

    @Slot()
    def _on_changed(self) -> None:
        conversion = self._conversion()
        self._convert.setEnabled(conversion is not None)
        if conversion is not None:
            self._view.show_conversion(conversion)

    @Slot()
    def _on_clicked(self) -> None:
        conversion = self._conversion()
        if conversion is None:
            return
        try:
            text = amend(self._document.text, conversion.settings, self._document.name)
        except StudioError:  # written in a way that cannot be changed in place
            text = write_settings(conversion.settings)
        stem = Path(self._document.name).stem
        name = f"{stem}_{conversion.settings.product.key}.txt"
        self.converted.emit(SettingsDocument(text, name))
        self.close()
