"""Load a settings file: what it would change of the board, and taking it as edits."""

from dataclasses import replace

from PySide6.QtCore import Qt, Signal, Slot
from PySide6.QtWidgets import QWidget

from trex_gui.core.errors import BadRequest
from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.settings.document import SettingsDocument
from trex_gui.devices.trex.model.settings.draft import diff_against_draft
from trex_gui.devices.trex.settings.comparison import Comparison
from trex_gui.devices.trex.settings.conversion import Conversion, convert
from trex_gui.devices.trex.views.comparison_view import ComparisonView
from trex_gui.devices.trex.views.conversion_view import ConversionView
from trex_gui.devices.trex.views.settings_editor.findings_panel import FindingsPanel
from trex_gui.ui.translations import error_sentence
from trex_gui.ui.widgets.behaviour import ReusedDialog
from trex_gui.ui.widgets.builders import button, column, label, named, row
from trex_gui.ui.widgets.labels import Note
from trex_gui.ui.widgets.placement import resize_with_font

_NAMED = 3  # how many settings or findings are listed before the rest is only counted
_NO_LIMIT = (1 << 24) - 1


class LoadDialog(ReusedDialog):
    """Shows what a file would change of the board; follows edits and is not modal."""

    staged = Signal(str)  # changes became edits; a message
    edit_wanted = Signal()
    ended = Signal(str)  # why the dialog closed by itself

    def __init__(
        self, device: Device, document: SettingsDocument, parent: QWidget, *, heading: str = ""
    ) -> None:
        """Name the side of the document `heading`, by default `File`."""
        super().__init__(parent)
        self.setObjectName("loadSettingsDialog")
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle(tr("Load settings from {0}").format(document.name))
        resize_with_font(self, 940, 620)
        self._device = device
        self._heading = heading or tr("File")
        # The document itself may be edited or deleted meanwhile.
        self._name = document.name
        self._settings, self._read_findings = document.settings, document.findings

        self._head = label(self, "loadHead", wrap=True)
        self._trouble = named(Note(2, self), "loadTrouble")
        self._findings = named(FindingsPanel(self, with_lines=False), "loadFindings")
        self._conversion = ConversionView(self)
        self._view = ComparisonView(self)
        self._foot = label(self, "loadFoot", wrap=True)
        text = tr("&Edit the file instead")
        self._edit = button(self, "editFileButton", text, on_click=self._on_edit_clicked)
        self._take = button(
            self, "takeChangesButton", icon="edited", default=True, on_click=self._on_take_clicked
        )
        cancel = button(self, "cancelLoadButton", tr("Cancel"), on_click=self.close)

        lists = (self._findings, 1), (self._conversion, 2), (self._view, 3)
        buttons = row(self._edit, 1, self._take, cancel)
        column(self._head, self._trouble, *lists, self._foot, buttons, into=self)

        self._view.ticked_changed.connect(self._update_take)
        device.draft.pending_changed.connect(self._on_draft_changed)
        device.draft.loaded.connect(self._on_draft_changed)
        device.link_changed.connect(self._on_link_changed)
        device.state_changed.connect(self._on_link_changed)
        self._on_draft_changed()

    def offer_editing(self, offered: bool) -> None:
        self._edit.setVisible(offered)

    @Slot()
    def _on_take_clicked(self) -> None:
        rows = self._view.table.ticked
        if not rows:
            return
        try:
            self._device.draft.stage(rows, tr("Load {0}").format(self._name))
        except BadRequest as error:
            self._trouble.show_note(error_sentence(error), alarming=True)
            return
        text = tr("{0}: %n change(s) pending: review them to write them.", "", len(rows))
        self.staged.emit(text.format(self._name))
        self.close()

    @Slot()
    def _on_edit_clicked(self) -> None:
        self.edit_wanted.emit()
        self.close()

    @Slot()
    def _on_link_changed(self) -> None:
        if self._device.state is not None:
            self._update_take()
        elif self.isVisible():
            text = tr("{0} was not loaded: the board is no longer connected.")
            self.ended.emit(text.format(self._name))
            self.close()

    @Slot()
    def _on_draft_changed(self) -> None:
        """Compare again; cleared check boxes stay cleared."""
        trouble, comparison = "", None
        settings, state = self._settings, self._device.state
        conversion: Conversion | None = None
        if settings is None:
            trouble = tr("This file cannot be used: it has errors. Nothing was changed.")
        elif state is not None:
            board = state.signature
            conversion = convert(settings, board.model, board.firmware)
            if settings.product == board.model and not conversion.alters:
                conversion = None
            # Settings that only the board's firmware has are not missed.
            given = replace(settings, firmware=None) if conversion is None else conversion.settings
            try:
                comparison = diff_against_draft(self._device.draft, given)
            except BadRequest as error:
                trouble = error_sentence(error)
        if conversion is not None:
            self._conversion.show_conversion(conversion)
        if comparison is not None:
            converted = tr("{0}, converted").format(self._heading)
            self._show_rows(comparison, self._heading if conversion is None else converted)
        self._show_findings(is_short=comparison is not None)
        self._conversion.setVisible(conversion is not None)
        for widget in (self._view, self._foot):
            widget.setVisible(comparison is not None)
        self._trouble.show_note(trouble, alarming=True)
        self._head.setText(self._head_text())
        self._update_take()

    def _show_rows(self, comparison: Comparison, heading: str) -> None:
        text = tr(
            "Checked changes become edits. Nothing is written to the board until you click Apply."
        )
        if missing := [row for row in comparison.rows if row.is_missing]:
            names = ", ".join(row.name for row in missing[:_NAMED])
            if len(missing) > _NAMED:
                names = tr("{0} and {1} more").format(names, len(missing) - _NAMED)
            text += "\n" + tr("Not in the file, so they stay as they are: {0}.").format(names)
        self._foot.setText(text)
        given = replace(comparison, rows=tuple(r for r in comparison.rows if not r.is_missing))
        now = tr("Board, as shown")
        self._view.show_comparison(given, now, heading, keep_ticks=True)

    def _show_findings(self, *, is_short: bool) -> None:
        found = self._read_findings
        self._findings.show_findings(found)
        self._findings.setVisible(bool(found))
        lines = min(len(found), _NAMED) + 2  # the summary and the header
        height = lines * (self.fontMetrics().height() + 12)
        self._findings.setMaximumHeight(height if is_short else _NO_LIMIT)

    def _head_text(self) -> str:
        settings, state = self._settings, self._device.state
        if settings is None:
            return self._name
        product, firmware = settings.product, settings.firmware
        if state is not None and state.signature.model != product:
            text = tr("{0}: settings for a {1}; the board is a {2}.")
            return text.format(self._name, product.name, state.signature)
        if firmware is None:
            return tr("{0}: settings for a {1}.").format(self._name, product.name)
        if state is None or state.signature.firmware == firmware:
            text = tr("{0}: settings for a {1} with firmware {2}.")
            return text.format(self._name, product.name, firmware)
        text = tr("{0}: settings for a {1} with firmware {2}; the board has {3}.")
        return text.format(self._name, product.name, firmware, state.signature.firmware)

    @Slot()
    def _update_take(self) -> None:
        count = len(self._view.table.ticked)
        self._take.setText(tr("&Load %n change(s)", "", count))
        offered = count > 0 and not self._view.isHidden()
        self._take.setEnabled(offered and self._device.is_writable)
