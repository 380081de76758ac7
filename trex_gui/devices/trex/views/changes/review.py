"""Review of the changes that Apply writes: preview, progress and outcome."""

from collections.abc import Iterable, Iterator
from enum import Enum, auto
from functools import partial

from PySide6.QtCore import QObject, Slot
from PySide6.QtWidgets import QWidget

from trex_gui.core.errors import NoReply, PortUnavailable, StudioError
from trex_gui.core.texts import title_of
from trex_gui.core.translation import tr
from trex_gui.devices.trex.board import WriteResult
from trex_gui.devices.trex.model.boards import BoardList
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.linter import BoardLinter
from trex_gui.devices.trex.model.power_cycle import PowerCycle, PowerCycleStage
from trex_gui.devices.trex.model.settings.draft import diff_against_draft
from trex_gui.devices.trex.protocol.parameters import ParameterKey, unconfirmed_defaults
from trex_gui.devices.trex.settings.comparison import Comparison, compare, settings_after
from trex_gui.devices.trex.settings.document import factory_settings, serial_defaults
from trex_gui.devices.trex.settings.rules import LintFinding
from trex_gui.devices.trex.views.changes.dialog import Changes, ChangesDialog, Names, Rows, TickedOf
from trex_gui.devices.trex.views.power_cycle import PowerCyclePanel
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.notifier import Answer
from trex_gui.ui.translations import error_sentence
from trex_gui.ui.widgets.builders import button, progress_bar


class _Phase(Enum):
    REVIEW = auto()
    WRITING = auto()
    DONE = auto()


class Review(QObject):
    def __init__(
        self, device: Device, linter: BoardLinter, boards: BoardList, parent: QWidget
    ) -> None:
        super().__init__(parent)
        self._device = device
        self._undo = device.draft.undo
        self._linter = linter
        self._boards = boards
        self._cycle = PowerCycle(device, self)
        self._phase = _Phase.REVIEW
        self._problem = self._detail = ""  # error message and its consequences
        self._title = ""  # title of the reviewed defaults, empty for other edits
        self._serial_only = False
        self._defaults: Rows = ()
        self._writing = Comparison(())  # changes of the current or last write
        self._outcomes: dict[str, str] = {}
        self._findings: tuple[LintFinding, ...] = ()
        self._unstaged = self._staged = -1  # undo indexes before and after the defaults were staged

        draft_changes = device.draft.pending_changed, device.draft.loaded
        self.dialog = ChangesDialog(
            device,
            parent,
            names=Names("reviewDialog", "review", "writeButton", "reviewCloseButton"),
            describe=self._describe,
            on_action=self._on_write_clicked,
            refresh_on=(linter.changed, boards.changed, device.link_changed, *draft_changes),
        )
        self._progress = progress_bar(self.dialog, "reviewProgress", tr("Progress of writing"))
        self._progress.setTextVisible(True)
        self._power = PowerCyclePanel(self._cycle, self.dialog)
        tip = tr(
            "Resets every parameter with the board's own reset command when the board next starts"
        )
        title = tr("&Let the board reset itself…")
        self._reset = button(self.dialog, "boardResetButton", title, tip=tip, default=False)
        self._reset.clicked.connect(self._on_reset_clicked)
        self.dialog.add_above_buttons(self._power)
        self.dialog.add_beside_buttons(self._progress, 3)
        self.dialog.add_beside_buttons(self._reset)

        self.dialog.finished.connect(self._on_finished)
        self.dialog.findings.accepted.connect(self._on_accepted)
        device.link_changed.connect(self._on_link_changed)
        device.connection.progressed.connect(self._on_progressed)
        device.applied.connect(self._on_applied)
        device.request_failed.connect(self._on_failed)
        self._enter(_Phase.REVIEW)

    @Slot()
    def review(self) -> None:
        if self._staged != self._undo.index():
            self._title = ""
        self._open()

    def review_defaults(self, *, serial_only: bool) -> None:
        """Stage all defaults, or only the serial defaults. Closing the review reverts them."""
        draft, shown = self._device.draft, self._device.draft.shown
        if self._phase is not _Phase.WRITING and shown is not None:
            self._revert()
            before = self._undo.index()
            titles = tr("Restore factor&y defaults…"), tr("Restore ser&ial defaults…")
            self._title, self._serial_only = title_of(titles[serial_only]), serial_only
            defaults = serial_defaults if serial_only else factory_settings
            comparison = diff_against_draft(draft, defaults(shown.product, shown.firmware))
            self._defaults = tuple(row for row in comparison.rows if row.changed)
            draft.stage(self._defaults, self._title)
            if self._undo.index() > before:
                self._unstaged, self._staged = before, self._undo.index()
        self._open()

    def _open(self) -> None:
        if self._phase is _Phase.WRITING:
            self.dialog.show_in_front()
        else:
            if self._phase is _Phase.DONE:
                self.dialog.hide()  # otherwise Enter would press Close, which has the focus
            self._problem = ""
            self._cycle.end()
            self._enter(_Phase.REVIEW)
            self.dialog.reset_and_show()

    @Slot()
    def close_if_verified(self) -> None:
        """Close the result if it requires no user action."""
        if self._phase is _Phase.DONE and not self._problem and self._power.isHidden():
            self.dialog.close()

    def _changes(self) -> Comparison:
        stored, shown = self._device.draft.stored, self._device.draft.shown
        if stored is None or shown is None:
            return Comparison(())
        return Comparison(compare(stored, shown).differing)

    @property
    def _can_write(self) -> bool:
        return self._device.is_writable and not self._device.draft.reset_pending

    @property
    def _is_cancellable(self) -> bool:
        return self._phase is _Phase.WRITING and self._device.writer.is_saving_snapshot

    def _on_write_clicked(self, rows: Rows) -> None:
        if rows and self._phase is _Phase.REVIEW and self._can_write:
            self.dialog.question.prompt_before(partial(self._write_rows, rows), self._doubts)

    def _doubts(self) -> list[str]:
        if self._phase is not _Phase.REVIEW or not self._can_write:
            return []
        return self._device.parameters.values.doubtful(self.dialog.ticked)

    def _write_rows(self, rows: Rows) -> None:
        written = {row.key for row in rows}
        left_out = {row.key for row in self._changes().rows} - written
        if left_out and self._revert():  # omitted defaults must not remain as edits
            remaining = (row for row in self._defaults if row.key not in left_out)
            self._device.draft.stage((*remaining, *rows), self._title)
        self._problem = ""
        self._writing, self._outcomes = Comparison(rows), {}
        self._progress.setRange(0, len(rows))
        self._progress.setValue(0)
        self._enter(_Phase.WRITING)
        self._device.writer.apply(frozenset(written))

    def _on_reset_clicked(self) -> None:
        text = tr(
            "At its next start the board will reset every parameter, including the unchecked "
            "ones. The current settings of the board are saved first (File, History). "
            "Unapplied changes are discarded; Undo restores them."
        )
        conflict = tr(
            "The board would get device number {0}, which another board on this line already "
            "has. Both would reply at the same time, and neither could be read. Give the "
            "other board a different number first."
        )
        specs = self._device.parameters.values.specs
        number = specs[ParameterKey.DEVICE_NUMBER].default
        is_taken = number in self._boards.unselected_numbers
        text = f"{conflict.format(number)} {text}" if is_taken else text
        answer = Answer("boardResetSureButton", tr("Reset the &board"), self._reset_board)

        def is_valid() -> bool:
            return self._device.is_writable and is_taken == (
                number in self._boards.unselected_numbers
            )

        self.dialog.question.prompt(text, answer, is_valid=is_valid)

    def _reset_board(self) -> None:
        self.dialog.close()
        self._device.writer.reset_to_factory()

    @Slot(object)
    def _on_accepted(self, finding: LintFinding) -> None:
        """Accept a proposal and check its rows, even if the user has unchecked them."""
        is_newest = self._staged == self._undo.index()
        self._linter.accept(finding)
        if is_newest:
            self._staged = self._undo.index()
        self.dialog.rows.table.tick(finding.change.keys())

    @Slot()
    def _on_finished(self) -> None:
        if self._is_cancellable:
            self._phase = _Phase.REVIEW
            self._device.writer.cancel()
        elif self._phase is _Phase.DONE:  # writing continues while the dialog is hidden
            self._cycle.end()
        if self._phase is _Phase.REVIEW:
            self._revert()
        self._unstaged = self._staged = -1

    def _revert(self) -> bool:
        """Undo staged defaults if they are the newest edit. Return whether they were undone."""
        is_newest = self._staged == self._undo.index()
        if is_newest:
            self._undo.setIndex(self._unstaged)
        self._unstaged = self._staged = -1
        return is_newest

    @Slot()
    def _on_link_changed(self) -> None:
        if self._phase is _Phase.WRITING and self._device.link is ConnectionState.DISCONNECTED:
            self._fail(self._problem or tr("The connection was lost."))

    @Slot(int, int, str)
    def _on_progressed(self, done: int, total: int, name: str) -> None:
        if self._phase is _Phase.WRITING and self._device.writer.running:
            self._progress.setRange(0, total)
            self._progress.setValue(done)
            text = tr("{0} of {1}: {2}")
            self._progress.setFormat(text.format(min(done + 1, total), total, name))

    @Slot(object)
    def _on_applied(self, results: tuple[WriteResult, ...]) -> None:
        keys = [result.key for result in results]
        written = {row.key for row in self._writing.rows}
        if self._phase is not _Phase.WRITING or not written.issuperset(keys):
            return  # result of another request, such as a reset
        self._outcomes = dict(zip(keys, _outcomes(results), strict=True))
        errors = [result.error for result in results if result.error is not None]
        if errors:
            text = tr("{0} of {1} settings could not be verified and are still pending.")
            self._problem = text.format(len(errors), len(results))
        if any(isinstance(error, (NoReply, PortUnavailable)) for error in errors):
            self._detail = tr(
                "The value that was being written when the connection was lost may be the old "
                "one, the new one or, after a power cut, the default. It will be read again."
            )
        if self._device.parameters.values.waiting_for_power:
            self._cycle.start([result.key for result in results if result.error is not None])
        self._enter(_Phase.DONE)

    @Slot(str)
    def _on_failed(self, reason: str) -> None:
        if self._phase is _Phase.WRITING and not self._device.writer.running:
            self._fail(reason)

    def _fail(self, reason: str) -> None:
        self._problem = reason
        self._enter(_Phase.DONE)

    def _enter(self, phase: _Phase) -> None:
        self._phase = phase
        if phase is _Phase.DONE:
            self._staged = -1
        else:
            self._detail = ""
        is_waiting = self._cycle.stage is not PowerCycleStage.NONE
        self._progress.setVisible(phase is _Phase.WRITING)
        self._power.setVisible(phase is _Phase.DONE and is_waiting)
        self.dialog.refresh()
        if phase is _Phase.DONE:
            self.dialog.fit()

    def _describe(self, ticked_of: TickedOf) -> Changes:
        before, after = tr("Before", "value"), tr("After", "value")
        offers_reset = bool(self._title) and not self._serial_only
        self._reset.setVisible(offers_reset and self._phase is _Phase.REVIEW)
        self._reset.setEnabled(self._device.is_writable)
        if self._phase is not _Phase.REVIEW:
            return Changes(
                self._result(),
                has_failed=bool(self._problem),
                caption=self._board_text(),
                rows=self._writing,
                sides=(before, after),
                with_ticks=False,
                outcomes=self._outcomes,
                summary=" ",
                remarks=self._findings,
                problem=self._detail,
                close="" if self._is_cancellable else tr("Close"),
            )
        rows, stored = self._changes(), self._device.draft.stored
        if not rows.rows:
            text, obstacle = tr("Nothing to write."), self._obstacle()
            return Changes(text, rows=rows, summary=" ", problem=obstacle, close=tr("Close"))
        ticked = ticked_of(rows)
        count = len(ticked)
        if stored is not None:
            settings = settings_after(stored, ((row.key, row.after) for row in ticked))
            self._findings = self._linter.check(settings)
        text = tr("Write %n setting(s) to the board", "", count)
        return Changes(
            self._title or (text if count else tr("Nothing to write.")),
            caption=self._caption() if count else self._board_text(),
            rows=rows,
            sides=(tr("Board now"), after),
            summary=" ",
            remarks=(*self._findings, *self._remarks(ticked)),
            can_accept=self._device.is_writable,
            problem=self._obstacle(),
            action=tr("&Write %n setting(s)", "", count),
            can_act=self._can_write and count > 0,
        )

    def _result(self) -> str:
        if self._phase is _Phase.DONE:
            text = tr("%n setting(s) written and verified.", "", len(self._writing.rows))
            return self._problem or text
        if self._is_cancellable:
            return tr("Saving a snapshot. Nothing has been written yet.")
        return tr("Writing. Leave the power on.")

    def _obstacle(self) -> str:
        if not self._device.is_connected:
            return tr("No board is responding. The edits are kept.")
        if self._device.draft.reset_pending:
            return tr(
                "The board will reset itself at its next start, and values written now would "
                "be lost. Switch the board off and on first (Device, Make stored settings "
                "active)."
            )
        return self._device.writer.blocker

    def _caption(self) -> str:
        text = tr("A snapshot of all settings is saved first. Each value is read back.")
        if self._title:
            text += " " + tr("Channel calibrations are not changed.")
        return " · ".join(filter(None, (self._board_text(), text)))

    def _board_text(self) -> str:
        state, settings = self._device.state, self._device.settings
        if state is None or settings is None:
            return ""
        number = state.parameters.get(ParameterKey.DEVICE_NUMBER)
        if number is None:
            return f"{state.signature} ({settings.label})"
        text = tr("{0} (device number {1}, {2})")
        return text.format(state.signature, number, settings.label)

    def _remarks(self, ticked: Rows) -> Iterator[str]:
        if keys := self._device.calibrations.out_of_reach:
            text = tr(
                "These calibrations stay pending until the board uses their input source again: "
                "{0}."
            )
            yield text.format(", ".join(key.label for key in keys))
        values = self._device.parameters.values
        specs = [values.specs[row.key] for row in ticked if not row.is_calibration]
        if later := [spec.name for spec in specs if spec.needs_power_cycle]:
            text = tr("Active only after the board is switched off and on: {0}.")
            yield text.format(", ".join(later))
        if self._title and (unsure := unconfirmed_defaults(specs)):
            yield tr("No source confirms these defaults: {0}.").format(unsure)


def _outcomes(results: Iterable[WriteResult]) -> Iterator[str]:
    previous_error: StudioError | None = None
    for result in results:
        if result.error is None:
            yield ""
        elif result.error is previous_error:
            yield tr("not attempted")
        else:
            previous_error = result.error
            yield error_sentence(result.error)
