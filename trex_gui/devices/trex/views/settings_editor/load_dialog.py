"""What a settings file would change of the board, before anything becomes an edit."""

from dataclasses import dataclass, replace

from PySide6.QtCore import Qt, Signal, Slot
from PySide6.QtWidgets import QDialog, QPushButton, QWidget

from trex_gui.core.errors import BadRequest, sentence
from trex_gui.core.files import Finding
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.settings.draft import diff_against_draft
from trex_gui.devices.trex.settings.comparison import Comparison
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.views.comparison_view import ComparisonView
from trex_gui.devices.trex.views.settings_editor.findings_panel import FindingsPanel, line_of_key
from trex_gui.ui.devices.connection_state import ConnectionState
from trex_gui.ui.theme.icons import set_icon
from trex_gui.ui.widgets.builders import button, column, label, row
from trex_gui.ui.widgets.labels import Note

_NAMED = 3
"""How many settings or findings are shown before the rest is only hinted at."""

_NO_LIMIT = (1 << 24) - 1


@dataclass(frozen=True, slots=True)
class ReadFile:
    """What reading a settings file gave.

    Attributes:
        settings: `None` when the file cannot be used.
        findings: the reader's findings.
    """

    name: str
    text: str
    settings: Settings | None
    findings: tuple[Finding, ...]


class LoadDialog(QDialog):
    """Beside the window, never in its way; it follows what the board's settings become.

    Signals:
        staged: changes became edits; the count, for the user.
        edit_wanted: the file is to be opened in a window of its own.
        ended: why the dialog closed by itself, for the user.
    """

    staged = Signal(str)
    edit_wanted = Signal()
    ended = Signal(str)

    def __init__(self, device: Device, file: ReadFile, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("loadSettingsDialog")
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle(self.tr("Load settings from {0}").format(file.name))
        self.resize(940, 620)
        self._device = device
        self._name = file.name
        self._settings = file.settings
        self._findings = file.findings
        self._text = file.text
        self._has_rows = False

        self._head = label(self, "loadHead", wrap=True, plain=True)
        self._trouble = Note(1, self)
        self._trouble.setObjectName("loadTrouble")
        self._list = FindingsPanel(self, with_lines=False)
        self._list.setObjectName("loadFindings")
        self._rows = ComparisonView(self)
        self._foot = label(self, "loadFoot", wrap=True)
        self._take = QPushButton(self)
        self._take.setObjectName("takeChangesButton")
        self._take.setDefault(True)
        set_icon(self._take, "edited")
        self._edit = button(self, "editFileButton", self.tr("&Edit the file instead"))
        self._cancel = button(self, "cancelLoadButton", self.tr("Cancel"))

        buttons = row(self._edit, 1, self._take, self._cancel)
        column(
            self._head,
            self._trouble,
            (self._list, 1),
            (self._rows, 3),
            self._foot,
            buttons,
            into=self,
        )

        self._take.clicked.connect(self._on_take_clicked)
        self._edit.clicked.connect(self._on_edit_clicked)
        self._cancel.clicked.connect(self.close)
        self._rows.ticked_changed.connect(self._on_actions_changed)
        device.draft.pending_changed.connect(self._on_draft_changed)
        device.draft.loaded.connect(self._on_draft_changed)
        device.link_changed.connect(self._on_link_changed)
        device.state_changed.connect(self._on_link_changed)
        self._on_draft_changed()

    def offer_editing(self, offered: bool) -> None:
        """Say whether the file may be opened in a window of its own; it may have one already."""
        self._edit.setVisible(offered)

    # --- User actions -----------------------------------------------------------------

    @Slot()
    def _on_take_clicked(self) -> None:
        rows = self._rows.table.ticked
        if not rows:
            return
        text = self.tr("Load {0}").format(self._name)
        try:
            self._device.draft.stage(rows, text)
        except BadRequest as error:
            self._trouble.show_note(sentence(error), alarming=True)
            self._trouble.show()
            return
        count = len(rows)
        words = self.tr("{0}: {1} now; Apply settings writes them.")
        what = self.tr("1 change is an edit") if count == 1 else self.tr("{0} changes are edits")
        self.staged.emit(words.format(self._name, what.format(count)))
        self.close()

    @Slot()
    def _on_edit_clicked(self) -> None:
        self.edit_wanted.emit()
        self.close()

    # --- What has changed ---------------------------------------------------------------

    @Slot()
    def _on_link_changed(self) -> None:
        if self._device.state is None:
            if self.isVisible():
                self.ended.emit(
                    self.tr("{0} was not loaded: no board is connected any more.").format(
                        self._name
                    )
                )
                self.close()
            return
        self._on_actions_changed()

    @Slot()
    def _on_draft_changed(self) -> None:
        """Compare again; cleared check boxes stay cleared."""
        trouble = ""
        comparison: Comparison | None = None
        if self._settings is None:
            trouble = self.tr("This file cannot be used: it has errors. Nothing was changed.")
        else:
            try:
                # What only the board's firmware has is not given; that is no loss to speak of.
                given = replace(self._settings, firmware=None)
                comparison = diff_against_draft(self._device.draft, given)
            except BadRequest as error:
                trouble = self.tr("This file is for another board. Nothing was changed.")
                self._show_findings(str(error))
        if comparison is not None:
            self._show_rows(comparison)
        if comparison is not None or self._settings is None:
            self._show_findings("")
        self._rows.setVisible(comparison is not None)
        self._foot.setVisible(comparison is not None)
        self._trouble.show_note(trouble, alarming=True)
        self._trouble.setVisible(bool(trouble))
        self._head.setText(self._words())
        self._on_actions_changed()

    def _show_rows(self, comparison: Comparison) -> None:
        """Show what the file gives; the rest stays as it is."""
        words = self.tr(
            "Ticked changes become edits. Nothing is written to the board before Apply."
        )
        if missing := [row for row in comparison.rows if row.is_missing]:
            names = ", ".join(row.name for row in missing[:_NAMED])
            if len(missing) > _NAMED:
                names = self.tr("{0} and {1} more").format(names, len(missing) - _NAMED)
            words += "\n" + self.tr("Not in the file, so they stay as they are: {0}.").format(names)
        self._foot.setText(words)
        given = replace(comparison, rows=tuple(r for r in comparison.rows if not r.is_missing))
        if self._has_rows:
            self._rows.renew(given)
        else:
            self._rows.show_comparison(given, self.tr("Board, as shown"), self.tr("File"))
            self._has_rows = True

    def _show_findings(self, refusal: str) -> None:
        """List what reading found, and why the board takes nothing of it."""
        found = self._findings
        summary = ""
        if refusal:
            line = line_of_key(self._text, "product")
            found = (Finding(line, "product", refusal), *found)
            summary = self.tr("The board takes nothing of this file.")
        self._list.show_findings(found, summary=summary)
        self._list.setVisible(bool(found))
        lines = min(len(found), _NAMED) + 4
        most = lines * (self.fontMetrics().height() + 12)
        is_short = self._settings is not None and not refusal
        self._list.setMaximumHeight(most if is_short else _NO_LIMIT)

    def _words(self) -> str:
        """What the file is for, and where that is not what is connected."""
        if self._settings is None:
            return self._name
        product, firmware = self._settings.product.name, self._settings.firmware
        words = self.tr("{0}: settings for a {1}").format(self._name, product)
        if firmware is not None:
            words += " " + self.tr("with firmware {0}").format(firmware)
        state = self._device.state
        is_other = state is not None and firmware not in {None, state.signature.firmware}
        if state is not None and is_other and state.signature.model == self._settings.product:
            words += self.tr("; the board has {0}").format(state.signature.firmware)
        return f"{words}."

    @Slot()
    def _on_actions_changed(self) -> None:
        count = len(self._rows.table.ticked) if self._has_rows else 0
        if count == 0:
            self._take.setText(self.tr("&Make changes edits"))
        elif count == 1:
            self._take.setText(self.tr("&Make 1 change an edit"))
        else:
            self._take.setText(self.tr("&Make {0} changes edits").format(count))
        up = self._device.link is ConnectionState.CONNECTED and not self._device.applying
        self._take.setEnabled(up and count > 0 and not self._rows.isHidden())
