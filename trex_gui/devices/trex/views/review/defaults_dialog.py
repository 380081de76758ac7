"""Restore the defaults: show the changes, then make edits or let the board reset itself."""

from PySide6.QtCore import Signal, Slot
from PySide6.QtWidgets import QWidget

from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.boards import BoardList
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.settings.draft import diff_against_draft
from trex_gui.devices.trex.protocol.parameters import ParameterKey, unconfirmed_defaults
from trex_gui.devices.trex.settings.comparison import Comparison
from trex_gui.devices.trex.settings.document import factory_settings, serial_defaults
from trex_gui.devices.trex.views.comparison_view import ComparisonView
from trex_gui.devices.trex.views.motor_controls import ActionBar
from trex_gui.ui.widgets.behaviour import ReusedDialog
from trex_gui.ui.widgets.builders import button, column, label, named, row
from trex_gui.ui.widgets.labels import Note
from trex_gui.ui.widgets.placement import resize_with_font


class DefaultsDialog(ReusedDialog):
    """Not modal; writes nothing before the review or a confirmation."""

    staged = Signal()  # the selected changes are edits now; show them for review
    reset_requested = Signal()  # the board is to reset every parameter by itself

    def __init__(self, device: Device, boards: BoardList, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("defaultsDialog")
        resize_with_font(self, 880, 520)
        self._device = device
        self._boards = boards
        self._serial_only = self._is_confirming = False

        self._intro = label(self, "defaultsIntro", wrap=True)
        self._rows = ComparisonView(self)
        self._inferred = label(self, "defaultsInferred", wrap=True)
        bar = ActionBar(device, "defaultsStopButton", self)
        tip = tr("Every parameter, by the board's own command, at its next start")
        title = tr("&Let the board reset itself…")
        self._reset = button(self, "boardResetButton", title, tip=tip)
        text = tr(
            "At its next start the board will reset every parameter, including those cleared "
            "here. Its present settings are saved first (File, History). Unapplied changes "
            "are discarded; Undo restores them."
        )
        # Within the dialog: a message box in front of it would block the stop button.
        self._question = label(self, "boardResetQuestion", text, wrap=True)
        self._taken = named(Note(2, self), "boardResetNumberTaken")
        self._sure = button(self, "boardResetSureButton", tr("Reset the &board"), confirms=True)
        self._take = button(self, "takeDefaultsButton", default=True)
        self._cancel = button(self, "defaultsCancelButton", tr("Cancel"), on_click=self.close)

        row(bar.stop, self._reset, self._sure, 1, self._take, self._cancel, into=bar)
        above = self._intro, (self._rows, 1), self._inferred, self._question, self._taken
        column(*above, bar, into=self)

        self._reset.clicked.connect(self._on_reset_clicked)
        self._sure.clicked.connect(self._on_sure_clicked)
        self._take.clicked.connect(self._on_take_clicked)
        self._rows.ticked_changed.connect(self._describe)
        for changed in (device.draft.pending_changed, device.draft.loaded, device.link_changed):
            changed.connect(self._on_changed)
        boards.changed.connect(self._show_taken)

    def preview(self, *, serial_only: bool) -> None:
        """Show what the defaults, or only the serial ones, would change."""
        self._serial_only = serial_only
        serial = tr(
            "The communication settings go back to their defaults. They become active when "
            "the board is switched off and on."
        )
        every = tr(
            "Every parameter goes back to its default; the channel calibrations stay. Clear "
            "the check box of any parameter to keep. Nothing is written before the review."
        )
        titles = tr("Restore factory defaults"), tr("Restore serial defaults")
        self.setWindowTitle(titles[serial_only])
        self._intro.setText(serial if serial_only else every)
        self._confirm_reset(False)
        self._rows.show_comparison(self._changes(), tr("Now"), tr("Factory default"))
        self._describe()
        self.show_in_front()

    def _changes(self) -> Comparison:
        shown = self._device.draft.shown
        if shown is None:
            return Comparison(())
        defaults = serial_defaults if self._serial_only else factory_settings
        changes = diff_against_draft(self._device.draft, defaults(shown.product, shown.firmware))
        rows = tuple(row for row in changes.rows if row.after is not None)
        return Comparison(rows, changes.left_out)

    @Slot()
    def _on_take_clicked(self) -> None:
        self._device.draft.stage(self._rows.table.ticked, self.windowTitle())
        self.close()
        self.staged.emit()

    @Slot()
    def _on_reset_clicked(self) -> None:
        self._cancel.setFocus()  # before the button is hidden and Qt moves on to the confirmation
        self._confirm_reset(True)

    def _confirm_reset(self, confirming: bool) -> None:
        self._is_confirming = confirming
        self._question.setVisible(confirming)
        self._sure.setVisible(confirming)
        self._reset.setVisible(not confirming and not self._serial_only)
        self._show_taken()

    @Slot()
    def _show_taken(self) -> None:
        """Warn of a board that has the number which this one gets by the reset."""
        if not self._is_confirming or self._device.state is None:
            self._taken.show_note("")
            return
        number = self._device.parameters.values.specs[ParameterKey.DEVICE_NUMBER].default
        text = tr(
            "It gets device number {0}, which another board on this line has: both would reply at "
            "once, and neither could be read. Give that board another number first."
        )
        is_taken = number in self._boards.others
        self._taken.show_note(text.format(number) if is_taken else "", alarming=True)

    @Slot()
    def _on_sure_clicked(self) -> None:
        self.close()
        self.reset_requested.emit()

    @Slot()
    def _on_changed(self) -> None:
        if self.isVisible():
            self._rows.renew(self._changes())
            self._describe()

    @Slot()
    def _describe(self) -> None:
        ticked = self._rows.table.ticked
        can_write = self._device.is_writable
        self._take.setText(tr("&Review %n change(s)…", "", len(ticked)))
        self._take.setEnabled(can_write and bool(ticked))
        self._reset.setEnabled(can_write)
        self._sure.setEnabled(can_write)
        specs = [self._device.parameters.values.specs[row.key] for row in ticked]
        unsure = unconfirmed_defaults(specs)
        self._inferred.setText(tr("No source confirms the default of: {0}.").format(unsure))
        self._inferred.setVisible(bool(unsure))
