"""Restore the defaults: show the changes, then make edits or let the board reset itself."""

from PySide6.QtCore import Signal, Slot
from PySide6.QtWidgets import (
    QDialog,
    QPushButton,
    QWidget,
)

from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.settings.draft import diff_against_draft
from trex_gui.devices.trex.settings.comparison import Comparison
from trex_gui.devices.trex.settings.document import factory_settings, serial_defaults
from trex_gui.devices.trex.views.action_bar import StopButton
from trex_gui.devices.trex.views.comparison_view import ComparisonView
from trex_gui.ui.devices.connection_state import ConnectionState
from trex_gui.ui.widgets.builders import button, column, label, row


class DefaultsDialog(QDialog):
    """Beside the window, never in its way; nothing is written from here without a second word.

    Signals:
        staged: the ticked changes are edits now, and wait for their review.
        reset_requested: the board is to reset every parameter by itself.
    """

    staged = Signal()
    reset_requested = Signal()

    def __init__(self, device: Device, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("defaultsDialog")
        self.resize(880, 520)
        self._device = device
        self._serial_only = False

        self._intro = label(self, "defaultsIntro", wrap=True)
        self._rows = ComparisonView(self)
        self._inferred = label(self, "defaultsInferred", wrap=True)
        self._reset = button(
            self,
            "boardResetButton",
            self.tr("Let the board reset itself…"),
            tip=self.tr("Every parameter, by the board's own command, at its next start"),
        )
        self._take = QPushButton(self)
        self._take.setObjectName("takeDefaultsButton")
        self._take.setDefault(True)
        self._cancel = button(self, "defaultsCancelButton", self.tr("Cancel"))

        self._question = label(
            self,
            "boardResetQuestion",
            self.tr(
                "At its next start the board will reset every parameter, including those cleared "
                "here. What it stores now is saved first (File, History). Unapplied changes are "
                "discarded; Undo restores them."
            ),
            wrap=True,
        )
        self._sure = button(self, "boardResetSureButton", self.tr("Reset the board"))

        buttons = row(
            StopButton(device, "defaultsStopButton", self),
            self._reset,
            self._sure,
            1,
            self._take,
            self._cancel,
        )
        column(self._intro, (self._rows, 1), self._inferred, self._question, buttons, into=self)

        self._reset.clicked.connect(lambda: self._ask(True))
        self._sure.clicked.connect(self._on_sure_clicked)
        self._take.clicked.connect(self._on_take_clicked)
        self._cancel.clicked.connect(self.close)
        self._rows.ticked_changed.connect(self._on_ticked_changed)
        device.draft.pending_changed.connect(self._on_draft_changed)
        device.draft.loaded.connect(self._on_draft_changed)
        device.link_changed.connect(self._on_link_changed)

    def preview(self, *, serial_only: bool) -> None:
        """Show what the defaults, or only the serial ones, would change."""
        self._serial_only = serial_only
        self.setWindowTitle(
            self.tr("Restore serial defaults")
            if serial_only
            else self.tr("Restore factory defaults")
        )
        self._intro.setText(
            self.tr(
                "The communication settings go back to their defaults. They become "
                "active when the board is switched off and on."
            )
            if serial_only
            else self.tr(
                "Every parameter goes back to its default; the channel calibrations "
                "stay. Clear the check box of any parameter to keep. Nothing is written before "
                "the review."
            )
        )
        self._ask(False)
        self._rows.show_comparison(
            self._changes(), self.tr("Now"), self.tr("Factory default"), with_ticks=True
        )
        self._describe()
        self.show()
        self.activateWindow()

    def _changes(self) -> Comparison:
        shown = self._device.draft.shown
        if shown is None:
            return Comparison(())
        make = serial_defaults if self._serial_only else factory_settings
        changes = diff_against_draft(self._device.draft, make(shown.product, shown.firmware))
        rows = tuple(row for row in changes.rows if row.after is not None)
        return Comparison(rows, changes.left_out)

    @Slot()
    def _on_take_clicked(self) -> None:
        self._device.draft.stage(self._rows.table.ticked, self.windowTitle())
        self.close()
        self.staged.emit()

    def _ask(self, asking: bool) -> None:
        """Ask within the dialog: a box in front of it would keep the mouse off the stop button."""
        self._question.setVisible(asking)
        self._sure.setVisible(asking)
        self._reset.setVisible(not asking and not self._serial_only)

    @Slot()
    def _on_sure_clicked(self) -> None:
        self.close()
        self.reset_requested.emit()

    @Slot()
    def _on_draft_changed(self) -> None:
        if self.isVisible():
            self._rows.renew(self._changes())
            self._describe()

    @Slot()
    def _on_link_changed(self) -> None:
        if self.isVisible():
            self._describe()

    @Slot(int)
    def _on_ticked_changed(self, _count: int) -> None:
        self._describe()

    def _describe(self) -> None:
        count = len(self._rows.table.ticked)
        up = self._device.link is ConnectionState.CONNECTED and not self._device.applying
        self._take.setText(
            self.tr("Make 1 change an edit")
            if count == 1
            else self.tr("Make {0} changes edits").format(count)
        )
        self._take.setEnabled(up and count > 0)
        self._reset.setEnabled(up)
        self._sure.setEnabled(up)
        spec_of = self._device.parameters.spec_of
        unsure = [
            row.name for row in self._rows.table.ticked if not spec_of(row.key).default_confirmed
        ]
        self._inferred.setText(
            self.tr("No source confirms the default of: {0}.").format(", ".join(unsure))
        )
        self._inferred.setVisible(bool(unsure))
