"""Prompts about unapplied edits, lost settings, and the driver of a board."""

from collections.abc import Callable
from functools import partial

from PySide6.QtCore import QObject, Slot

from trex_gui.core.translation import tr
from trex_gui.devices.trex.driving.requests import MotorsStopped
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.protocol.errors import ErrorCode
from trex_gui.devices.trex.session.messages import HandOver, TakeLease
from trex_gui.devices.trex.settings.board_records import utc_now
from trex_gui.devices.trex.settings.comparison import ComparisonRow
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.views.settings_files import SettingsFiles
from trex_gui.ui.frame.main_window import MainWindow
from trex_gui.ui.notifier import Answer
from trex_gui.ui.translations import local_time
from trex_gui.ui.widgets.messages import InlinePrompt


class ClosePrompt(QObject):
    def __init__(
        self, device: Device, files: SettingsFiles, review: Callable[[], object], frame: MainWindow
    ) -> None:
        super().__init__(frame)
        self._device = device
        self._files = files
        self._review = review
        self._frame = frame
        self._agreed: Settings | None = None  # settings with edits, as they were at the last answer
        self.keeps_edits = True  # True if edits are saved for the next connection of the board
        device.draft.pending_changed.connect(self._on_pending_changed)

    def may_close(self, leave: Callable[[], object]) -> bool:
        """Return whether the window may close now. `leave` closes the window after an answer."""
        device, draft, question = self._device, self._device.draft, self._frame.question
        agreed, self._agreed = self._agreed, None
        may_leave = agreed is not None and agreed == draft.shown
        if may_leave or not (device.writer.running or draft.pending):
            leave_now = partial(self._close, leave, draft.shown if may_leave else None)
            return self._files.may_close(leave_now)

        def close(agreed: Settings | None, *, keep_edits: bool) -> None:
            self.keeps_edits = keep_edits
            self._close(leave, agreed)

        def close_with_edits() -> None:
            close(draft.shown, keep_edits=True)

        def discard() -> None:
            close(draft.shown, keep_edits=False)

        def save_and_close() -> None:
            self._files.saver.prompt_and_save(partial(close, draft.shown, keep_edits=False))

        self._frame.activateWindow()
        if device.writer.running:
            text = tr(
                "Settings are still being written. Close anyway? Unwritten settings are "
                "offered when the board is connected again."
            )
            answer = Answer("closeYes", tr("Close anyway"), close_with_edits)
            question.prompt(text, answer, is_valid=lambda: device.writer.running)
        else:
            apply = Answer("applyFirst", tr("Review and apply…"), self._review)
            question.prompt(
                tr("There are unapplied changes."),
                *([apply] if device.writer.can_apply else []),
                Answer("saveAndClose", tr("Save as a settings file…"), save_and_close),
                Answer("keepAndClose", tr("Keep and close"), close_with_edits),
                Answer("closeYes", tr("Discard and close"), discard),
                is_valid=lambda: draft.pending > 0 and not device.writer.running,
            )
        return False

    @Slot()
    def _on_pending_changed(self) -> None:
        """Clear an earlier decision to discard edits, because it does not apply to new edits."""
        self.keeps_edits = True

    def _close(self, leave: Callable[[], object], agreed: Settings | None) -> None:
        """Close the window. Prompt again only if the edits differ from `agreed`."""
        self._agreed = agreed
        leave()


class RestorePrompt(QObject):
    """Prompts about earlier edits and lost settings, shown at each connection."""

    def __init__(self, device: Device, files: SettingsFiles, question: InlinePrompt) -> None:
        super().__init__(files)
        self._device = device
        self._files = files
        self._question = question
        self._reported: set[ComparisonRow] = set()  # lost settings that were already reported
        device.edit_backup.offered.connect(self._on_edits_offered)
        device.records.changed.connect(self._on_memory_changed)

    @Slot()
    def _on_edits_offered(self) -> None:
        backup = self._device.edit_backup
        offer = backup.offer
        self._question.reconsider()
        if offer is None:
            self._on_memory_changed()
            return
        if self._question.text:
            return  # the offer waits until the next connection
        text = tr(
            "Edited earlier but not applied: %n setting(s) of this {0} ({1}). Restore them "
            "as pending edits?",
            "",
            len(offer.rows),
        )
        saved = local_time(offer.saved.saved)
        self._question.prompt(
            text.format(offer.saved.settings.product.name, saved),
            Answer("restoreEdits", tr("Restore edits"), backup.restore),
            Answer("discardEdits", tr("Discard edits"), backup.discard_offer),
            is_valid=lambda: backup.offer is offer,
        )

    @Slot()
    def _on_memory_changed(self) -> None:
        """Report differences from the last applied settings once per connection."""
        memory = self._device.board.memory
        differing, record = memory.differing, memory.expected
        self._question.reconsider()
        new = set(differing.rows) - self._reported
        if not differing.rows or record is None or record.applied is None:
            self._reported = set()
        elif new and not self._question.text:
            self._reported = set(differing.rows)
            text = tr(
                "%n setting(s) of this {0} differ from the last applied values ({1}). They "
                "were lost or changed by another program, or this is another board.",
                "",
                len(differing.rows),
            )
            keep = tr("Keep the values of the board")
            self._question.prompt(
                text.format(record.settings.product.name, local_time(record.applied)),
                Answer("showDiffering", tr("Show…"), self._show_differing),
                Answer("keepDiffering", keep, lambda: memory.accept(utc_now())),
                is_valid=lambda: memory.differing == differing,
            )

    def _show_differing(self) -> None:
        applied, record = self._device.board.memory.applied, self._device.board.memory.expected
        if applied is not None and record is not None and record.applied is not None:
            self._files.offer_settings(applied, local_time(record.applied))


class LeasePrompt(QObject):
    def __init__(self, device: Device, question: InlinePrompt, parent: QObject) -> None:
        super().__init__(parent)
        self._device, self._question = device, question
        self._offered: tuple[str, ...] = ()  # users who were waiting at the last prompt
        self._is_waiting = False  # True after this user has requested to drive
        device.lease_changed.connect(self._on_lease_changed)
        device.connection.motors_stopped.connect(self._on_motors_stopped)
        device.connection.line_closed.connect(self._on_line_closed)

    @Slot()
    def _on_lease_changed(self) -> None:
        lease = self._device.board.lease
        if lease is None:
            return
        if lease.is_mine and self._is_waiting:
            self._is_waiting = False
            self._device.notifier.info.emit(tr("You may drive now: arm the motors."))
        if not lease.is_mine:
            self._offered = ()
        elif lease.waiting != self._offered:
            self._offered = lease.waiting
            if lease.waiting:
                self._prompt_to_hand_over(lease.waiting[0])
        self._question.reconsider()

    def _prompt_to_hand_over(self, user: str) -> None:
        def is_valid() -> bool:
            lease = self._device.board.lease
            return lease is not None and lease.is_mine and user in lease.waiting

        text = tr("{0} wants to drive. Handing over stops the motors.").format(user)
        submit = partial(self._device.connection.submit, HandOver(user))
        self._question.prompt(text, Answer("handOver", tr("Hand over"), submit), is_valid=is_valid)

    @Slot(object)
    def _on_motors_stopped(self, report: MotorsStopped) -> None:
        """Offer to take over if arming failed because another user drives."""
        if report.reason is not ErrorCode.OTHER_DRIVES:
            return
        self._is_waiting = True
        lease = self._device.board.lease
        if lease is None or not lease.may_take or lease.is_mine:
            return

        def is_valid() -> bool:
            lease = self._device.board.lease
            return lease is not None and not lease.is_mine and bool(lease.driver)

        text = tr("{0} is driving. Taking over stops the motors.").format(lease.driver)
        submit = partial(self._device.connection.submit, TakeLease())
        self._question.prompt(text, Answer("takeOver", tr("Take over"), submit), is_valid=is_valid)

    @Slot()
    def _on_line_closed(self) -> None:
        self._offered, self._is_waiting = (), False
        self._question.reconsider()
