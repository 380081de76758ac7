"""What becomes of edits that are not applied when the window closes."""

from collections.abc import Callable
from functools import partial

from PySide6.QtCore import QObject, Slot

from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.views.review.review_dialog import ReviewDialog
from trex_gui.devices.trex.views.settings_files import SettingsFiles
from trex_gui.ui.frame.main_window import MainWindow
from trex_gui.ui.notifier import Answer


class ClosePrompt(QObject):
    """Asks whether to apply, save, keep or discard edits before the window closes."""

    def __init__(
        self, device: Device, files: SettingsFiles, review: ReviewDialog, frame: MainWindow
    ) -> None:
        super().__init__(frame)
        self._device = device
        self._files = files
        self._review = review
        self._frame = frame
        self._agreed: Settings | None = None  # settings shown that may be left as they are
        self.keeps_edits = True  # whether edits are offered when the board is connected again
        device.draft.pending_changed.connect(self._keep_edits)

    def may_close(self, leave: Callable[[], object]) -> bool:
        """Return whether the window may close now; `leave` closes it once that was agreed to."""
        device, draft, question = self._device, self._device.draft, self._frame.question
        agreed, self._agreed = self._agreed, None
        may_leave = agreed is not None and agreed == draft.shown
        if may_leave or not (device.writer.running or draft.pending):
            leave_now = partial(self._leave, leave, draft.shown if may_leave else None)
            return self._files.may_close(leave_now)

        def leave_with(agreed: Settings | None, *, keep_edits: bool) -> None:
            self.keeps_edits = keep_edits
            self._leave(leave, agreed)

        def keep() -> None:
            leave_with(draft.shown, keep_edits=True)

        def discard() -> None:
            leave_with(draft.shown, keep_edits=False)

        def save_and_leave() -> None:
            self._files.ask_and_save(partial(leave_with, draft.shown, keep_edits=False))

        self._frame.activateWindow()
        if device.writer.running:
            question.ask(
                tr(
                    "Settings are still being written. Close anyway? Unwritten settings are "
                    "offered when the board is connected again."
                ),
                Answer("closeYes", tr("Close anyway"), keep),
                still=lambda: device.writer.running,
            )
        else:
            apply = Answer("applyFirst", tr("Review and apply…"), self._review.review)
            question.ask(
                tr("There are unapplied changes."),
                *([apply] if device.writer.can_apply else []),
                Answer("saveAndClose", tr("Save as a settings file…"), save_and_leave),
                Answer("keepAndClose", tr("Keep and close"), keep),
                Answer("closeYes", tr("Discard and close"), discard),
                still=lambda: draft.pending > 0 and not device.writer.running,
            )
        return False

    @Slot()
    def _keep_edits(self) -> None:
        """Keep edits that are made after a question was answered and the window stayed open."""
        self.keeps_edits = True

    def _leave(self, leave: Callable[[], object], agreed: Settings | None) -> None:
        """Leave without a question about the edits, unless others are shown by now."""
        self._agreed = agreed
        leave()
