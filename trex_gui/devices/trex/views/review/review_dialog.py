"""Review of what Apply writes: before, while writing, and the outcome of each value."""

from collections.abc import Iterator
from enum import Enum, auto
from functools import partial

from PySide6.QtCore import Slot
from PySide6.QtWidgets import QWidget

from trex_gui.core.errors import NoReply, PortUnavailable, StudioError
from trex_gui.core.translation import tr
from trex_gui.devices.trex.board import WriteResult
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.linter import BoardLinter
from trex_gui.devices.trex.model.power_cycle import PowerCycle, PowerCycleStage
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.devices.trex.settings.comparison import Comparison, compare, settings_after
from trex_gui.devices.trex.settings.rules import LintFinding
from trex_gui.devices.trex.views.comparison_view import ComparisonView
from trex_gui.devices.trex.views.findings_list import FindingsList, LimitsPrompt
from trex_gui.devices.trex.views.motor_controls import ActionBar
from trex_gui.devices.trex.views.review.power_cycle import PowerCyclePanel
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.translations import error_sentence
from trex_gui.ui.widgets.behaviour import ReusedDialog
from trex_gui.ui.widgets.builders import button, column, label, named, progress_bar, row
from trex_gui.ui.widgets.labels import Note
from trex_gui.ui.widgets.messages import MessageRoom
from trex_gui.ui.widgets.placement import resize_with_font
from trex_gui.ui.widgets.scroll_box import ScrollBox


class _Phase(Enum):
    REVIEW = auto()
    WRITING = auto()
    DONE = auto()


class ReviewDialog(ReusedDialog):
    """Not modal, with a stop button of its own; follows the edits until they are written."""

    def __init__(self, device: Device, linter: BoardLinter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("reviewDialog")
        self.setWindowTitle(tr("Apply settings"))
        resize_with_font(self, 920, 560)
        self._device = device
        self._undo = device.draft.undo
        self._linter = linter
        self._cycle = PowerCycle(device, self)
        self._phase = _Phase.REVIEW
        self._problem = ""
        self._written: frozenset[str] = frozenset()
        self._unstaged = self._staged = -1  # undo steps before and after what closing reverts

        self._head = named(Note(1, self), "reviewHead")
        self._rows = ComparisonView(self)
        self._findings_head = label(self, "reviewFindingsHead", wrap=True, bold=True)
        self._findings = FindingsList("review", self._rows, self, is_wide=True)
        self._findings_area = ScrollBox(self._findings, self)
        self._question = named(LimitsPrompt(self), "reviewQuestion")
        self._foot = label(self, "reviewFoot", wrap=True)
        self._progress = progress_bar(self, "reviewProgress", tr("Progress of writing"))
        self._progress.setTextVisible(True)
        self._power = PowerCyclePanel(self._cycle, self)
        bar = ActionBar(device, "reviewStopButton", self)
        self._write = button(
            self, "writeButton", icon="apply", confirms=True, on_click=self._on_write_clicked
        )
        self._close = button(self, "reviewCloseButton", on_click=self.close)

        row(bar.stop, (self._progress, 1), 1, self._write, self._close, into=bar)
        findings = self._findings_head, (self._findings_area, 1)
        below = self._foot, MessageRoom(self, self._question), self._power, bar
        column(self._head, (self._rows, 2), *findings, *below, into=self)

        self.finished.connect(self._on_finished)
        self._rows.ticked_changed.connect(self._describe)
        self._findings.accepted.connect(self._on_accepted)
        linter.changed.connect(self._describe)
        device.draft.pending_changed.connect(self._on_draft_changed)
        device.draft.loaded.connect(self._on_draft_changed)
        device.link_changed.connect(self._on_link_changed)
        device.connection.progressed.connect(self._on_progressed)
        device.applied.connect(self._on_applied)
        device.request_failed.connect(self._on_failed)
        self._describe()

    def review(self) -> None:
        """Show what Apply would write, or the progress while it writes."""
        if self._phase is not _Phase.WRITING:
            if self._phase is _Phase.DONE:
                self.hide()  # its Close has the focus, and Enter is to write again
            self._problem = ""
            self._cycle.end()
            before, after = tr("In the board"), tr("Will be written")
            self._rows.show_comparison(self._changes(), before, after, summary=self._summary())
            self._enter(_Phase.REVIEW)
        self.show_in_front()

    @Slot()
    def review_staged(self) -> None:
        """Review the newest edit, which is undone if the dialog is closed without writing."""
        self._staged = self._undo.index()
        self._unstaged = self._staged - 1
        self.review()

    @Slot()
    def close_if_verified(self) -> None:
        """Close a result that asks for nothing more."""
        if self._phase is _Phase.DONE and not self._problem and self._power.isHidden():
            self.close()

    def _changes(self) -> Comparison:
        stored, shown = self._device.draft.stored, self._device.draft.shown
        if stored is None or shown is None:
            return Comparison(())
        return Comparison(compare(stored, shown).differing)

    def _summary(self) -> str:
        return tr("Clear the check box of any setting you want to apply later.")

    @property
    def _can_write(self) -> bool:
        """Whether the board accepts settings now and will store them."""
        return self._device.is_writable and not self._device.draft.reset_pending

    @property
    def _is_cancellable(self) -> bool:
        """Whether it was told to write, and nothing is written yet."""
        return self._phase is _Phase.WRITING and self._device.writer.is_saving_snapshot

    @Slot()
    def _on_write_clicked(self) -> None:
        wanted = frozenset(row.key for row in self._rows.table.ticked)
        if not wanted or self._phase is not _Phase.REVIEW or not self._can_write:
            return
        self._question.ask_before(partial(self._write_rows, wanted), self._doubts)

    def _doubts(self) -> list[str]:
        """Return the checked values of which only the board can tell whether it takes them."""
        if self._phase is not _Phase.REVIEW or not self._can_write:
            return []
        return self._device.parameters.values.doubtful(self._rows.table.ticked)

    def _write_rows(self, wanted: frozenset[str]) -> None:
        self._problem = ""
        self._phase = _Phase.WRITING  # the findings stay
        self._rows.freeze(tr("Before", "value"), tr("New value"))
        self._progress.setRange(0, len(wanted))
        self._progress.setValue(0)
        self._enter(_Phase.WRITING)
        self._written = wanted
        self._device.writer.apply(wanted)

    @Slot(object)
    def _on_accepted(self, finding: LintFinding) -> None:
        """Add a proposal to what is written, also where its edit was to wait."""
        is_newest = self._staged == self._undo.index()
        self._linter.accept(finding)
        if is_newest:
            self._staged = self._undo.index()
        self._rows.table.tick(finding.change.keys())

    @Slot()
    def _on_finished(self) -> None:
        if self._is_cancellable:
            self._phase = _Phase.REVIEW
            self._device.writer.cancel()
        elif self._phase is _Phase.DONE:  # writing continues while the dialog is hidden
            self._cycle.end()
        if self._phase is _Phase.REVIEW and self._staged == self._undo.index():
            self._undo.setIndex(self._unstaged)
        self._unstaged = self._staged = -1

    @Slot()
    def _on_draft_changed(self) -> None:
        if self._phase is _Phase.REVIEW and self.isVisible():
            self._rows.renew(self._changes(), self._summary())
            self._describe()

    @Slot()
    def _on_link_changed(self) -> None:
        if self._phase is _Phase.WRITING and self._device.link is ConnectionState.DISCONNECTED:
            self._problem = self._problem or tr("The connection was lost.")
            self._enter(_Phase.DONE)
        elif self.isVisible():
            self._describe()

    @Slot(int, int, str)
    def _on_progressed(self, done: int, total: int, what: str) -> None:
        if self._phase is _Phase.WRITING and self._device.writer.running:
            self._progress.setRange(0, total)
            self._progress.setValue(done)
            text = tr("{0} of {1}: {2}").format(min(done + 1, total), total, what)
            self._progress.setFormat(text)

    @Slot(object)
    def _on_applied(self, results: tuple[WriteResult, ...]) -> None:
        keys = [result.key for result in results]
        if self._phase is not _Phase.WRITING or not self._written.issuperset(keys):
            return  # the result of another request, such as a reset
        self._rows.table.set_outcomes(dict(zip(keys, self._outcomes(results), strict=True)))
        self._problem = self._problem_text(results)
        if self._device.parameters.values.waiting_for_power:
            self._cycle.begin([result.key for result in results if result.error is not None])
        self._enter(_Phase.DONE)

    def _outcomes(self, results: tuple[WriteResult, ...]) -> Iterator[str]:
        """Yield the reason of each failure, once for each error; empty for stored values."""
        occurred: StudioError | None = None
        for result in results:
            if result.error is None:
                yield ""
            elif result.error is occurred:
                yield tr("not attempted")
            else:
                occurred = result.error
                yield error_sentence(result.error)

    def _problem_text(self, results: tuple[WriteResult, ...]) -> str:
        errors = [result.error for result in results if result.error is not None]
        if not errors:
            return ""
        text = tr("{0} of {1} could not be verified; still pending.")
        text = text.format(len(errors), len(results))
        if any(isinstance(error, (NoReply, PortUnavailable)) for error in errors):
            text += " " + tr(
                "The value that was being written when the connection was lost may be the old "
                "one, the new one or, after a power cut, the default. It will be read again."
            )
        return text

    @Slot(str)
    def _on_failed(self, reason: str) -> None:
        if self._phase is _Phase.WRITING and not self._device.writer.running:
            self._problem = reason
            self._enter(_Phase.DONE)

    def _enter(self, phase: _Phase) -> None:
        self._phase = phase
        if phase is _Phase.DONE:
            self._staged = -1
        self._describe()

    @Slot()
    def _describe(self) -> None:
        count = len(self._rows.table.ticked)
        reviewing, done = self._phase is _Phase.REVIEW, self._phase is _Phase.DONE
        cancellable = reviewing or self._is_cancellable
        self._progress.setVisible(self._phase is _Phase.WRITING)
        self._power.setVisible(done and self._cycle.stage is not PowerCycleStage.NONE)
        self._write.setVisible(reviewing)
        self._write.setEnabled(reviewing and self._can_write and count > 0)
        self._write.setText(tr("&Write %n setting(s)", "", count))
        self._write.setDefault(self._write.isEnabled())
        self._close.setText(tr("Cancel") if cancellable else tr("Close"))
        self._close.setDefault(not self._write.isDefault())
        text, alarming = self._head_text()
        self._head.show_note(text, alarming=alarming)
        self._show_findings()
        self._question.reconsider()
        self._foot.setVisible(reviewing)
        self._foot.setText(self._foot_text())

    def _show_findings(self) -> None:
        """Check what the board will store; while and after writing, keep what was left."""
        reviewing, stored = self._phase is _Phase.REVIEW, self._device.draft.stored
        if reviewing and stored is not None:
            ticked = ((row.key, row.after) for row in self._rows.table.ticked)
            after = settings_after(stored, ticked)
            self._findings.show_findings(self._linter.check(after))
        self._findings.set_can_accept(reviewing and self._device.is_writable)
        count = self._findings.count
        for widget in (self._findings_head, self._findings_area):
            widget.setVisible(count > 0)
        text = tr("%n finding(s). Accept a proposal, or leave the setting as it is.", "", count)
        self._findings_head.setText(text if reviewing else tr("%n finding(s) left.", "", count))

    def _head_text(self) -> tuple[str, bool]:
        """Return the state of the review, and whether it is alarming."""
        count = len(self._rows.table.comparison.rows)
        state = self._device.state
        match self._phase:
            case _Phase.WRITING if self._is_cancellable:
                text = tr("Saving the board's present settings before anything is written.")
                return text, False
            case _Phase.WRITING:
                return tr("Writing. Each value is read back; leave the power on."), False
            case _Phase.DONE if self._problem:
                return self._problem, True
            case _Phase.DONE:
                return tr("%n setting(s) written and verified.", "", count), False
        if count == 0:
            return tr("There is nothing to write: no setting was changed."), False
        if not self._device.is_connected:
            return tr("No board is responding. The edits are kept."), False
        if self._device.draft.reset_pending:
            return tr(
                "The board will reset itself at its next start and would lose what is "
                "written now. Switch it off and on first (Device, Make stored settings active)."
            ), True
        if state is not None and not state.mode.is_serial:
            text = tr(
                "The board is in {0} mode and does not accept settings. Set its mode jumper to "
                "serial, then switch it off and on."
            )
            return text.format(state.mode.source.word), True
        text = tr("%n setting(s) of the {0} will change.", "", count)
        return text.format(self._board_text()), False

    def _board_text(self) -> str:
        """Return the kind, number and port of the board."""
        state, settings = self._device.state, self._device.settings
        if state is None or settings is None:
            return ""
        number = state.parameters.get(ParameterKey.DEVICE_NUMBER)
        if number is None:
            return f"{state.signature} ({settings.label})"
        text = tr("{0} (device number {1}, {2})")
        return text.format(state.signature, number, settings.label)

    def _foot_text(self) -> str:
        parts = [
            tr(
                "The board's present settings are saved first (File, History). Each value is "
                "read back to verify it; serial settings are written last."
            )
        ]
        if keys := self._device.calibrations.out_of_reach:
            text = tr(
                "These calibrations stay pending until the board uses their input source again: "
                "{0}."
            )
            parts.append(text.format(", ".join(key.label for key in keys)))
        ticked = (row for row in self._rows.table.ticked if not row.is_calibration)
        specs = [self._device.parameters.values.specs[row.key] for row in ticked]
        if later := [spec.name for spec in specs if spec.needs_power_cycle]:
            text = tr("Active only after the board is switched off and on: {0}.")
            parts.append(text.format(", ".join(later)))
        return " ".join(parts)
