"""Apply the same settings to several boards."""

from collections.abc import Collection
from dataclasses import dataclass, replace
from enum import Enum, auto
from typing import Any

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.core.errors import BadRequest, StudioError
from trex_gui.core.translation import tr
from trex_gui.devices.trex.board import WriteResult
from trex_gui.devices.trex.model.boards import BoardList
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.settings.draft import diff_against_draft
from trex_gui.devices.trex.protocol.errors import ErrorCode, TrexError
from trex_gui.devices.trex.session.reconnecting import LINK_KEYS
from trex_gui.devices.trex.settings.comparison import Comparison, settings_after, values_to_write
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.rules import Context, LintFinding, lint
from trex_gui.ui.translations import error_text


class BoardStep(Enum):
    WAITING = auto()
    READING = auto()
    REVIEWED = auto()
    WRITING = auto()
    WRITTEN = auto()
    FAILED = auto()  # not read, not written, or not verified; see `BoardPlan.problem`
    SKIPPED = auto()  # the work ended before this board


@dataclass(frozen=True, slots=True)
class BoardPlan:
    number: int  # device number
    step: BoardStep = BoardStep.WAITING
    changes: Comparison | None = None  # `None` before reading
    problem: str = ""  # reason for the user
    findings: tuple[LintFinding, ...] = ()  # about the settings after these changes
    doubts: tuple[str, ...] = ()  # changes that the board may reject

    @property
    def to_write(self) -> int:
        """Number of settings to write."""
        return 0 if self.changes is None else self.changes.changed


class ApplyToBoards(QObject):
    """Reads several boards, then writes the same settings to each.

    Device numbers and serial settings stay unchanged. The work continues after a board that is
    silent, rejects writes, is of another model, or has changed since the review. Any other error,
    or a stop by the user, ends the work. Finally, the board that was selected at the start is
    selected again.
    """

    changed = Signal()  # `plans` or `is_running`
    finished = Signal()  # reading or writing is complete, or has ended early

    def __init__(self, boards: BoardList, device: Device, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._boards = boards
        self._device = device
        self.plans: tuple[BoardPlan, ...] = ()
        self.is_running = False
        self.is_writing = False  # false for a review
        self.was_stopped = False  # the user pressed Stop, which ended the work
        self._target: Settings | None = None
        self._initial: int | None = None  # board that was selected at the start
        self._is_cancelled = False
        self._current: int | None = None  # board being written
        device.applied.connect(self._on_applied)
        device.request_failed.connect(self._on_request_failed)
        device.connection.line_closed.connect(self._on_line_closed)
        device.motors.stop_requested.connect(self._on_stop_requested)

    def review(self, settings: Settings, numbers: Collection[int]) -> None:
        if self.is_running:
            return
        self._target = settings.without(LINK_KEYS)
        self._start([BoardPlan(number) for number in sorted(numbers)], is_writing=False)

    def write(self, numbers: Collection[int]) -> None:
        if not self.is_running:
            plans = [
                replace(plan, step=BoardStep.WAITING)
                if plan.number in numbers and plan.step is BoardStep.REVIEWED and plan.to_write
                else plan
                for plan in self.plans
            ]
            self._start(plans, is_writing=True)

    def cancel(self) -> None:
        """End the work after the current board, or at once if nothing was sent to it yet."""
        self._is_cancelled = True
        if self._device.writer.is_saving_snapshot and self._current is not None:
            self._device.writer.cancel()
            number, self._current = self._current, None
            self._finish_board(number, BoardStep.SKIPPED)

    def _start(self, plans: list[BoardPlan], *, is_writing: bool) -> None:
        self.plans = tuple(plans)
        self.is_running, self.was_stopped = True, False
        self.is_writing, self._is_cancelled = is_writing, False
        self._initial = self._boards.selected
        self._continue()

    def _set_step(self, number: int, step: BoardStep, problem: str = "", **changes: Any) -> None:
        self.plans = tuple(
            replace(plan, step=step, problem=problem, **changes) if plan.number == number else plan
            for plan in self.plans
        )
        self.changed.emit()

    def _finish_board(self, number: int, step: BoardStep, problem: str = "") -> None:
        self._set_step(number, step, problem)
        self._continue()

    # --- Boards, one by one -------------------------------------------------------------

    def _continue(self) -> None:
        waiting = [plan.number for plan in self.plans if plan.step is BoardStep.WAITING]
        if self._is_cancelled or not waiting:
            self._end()
            return
        number = waiting[0]
        self._set_step(number, BoardStep.READING)
        self._select(number)

    def _select(self, number: int) -> None:
        boards = self._boards
        is_selected = number == boards.selected and boards.is_addressed
        if is_selected and self._device.is_connected:
            self._on_selected(number, None)
        elif not boards.can_select:
            self._on_selected(number, TrexError(ErrorCode.CLOSED))
        elif is_selected:
            self._on_selected(number, TrexError(ErrorCode.NOT_SELECTED_SILENT, number))
        else:
            boards.select(number, lambda error: self._on_selected(number, error))

    def _on_selected(self, number: int, error: StudioError | None) -> None:
        if not self.is_running:
            return
        if error is not None:
            problem = error_text(error)
            if isinstance(error, TrexError) and error.code is ErrorCode.NOT_SELECTED_SILENT:
                problem = tr("The board does not respond. Check that it has power.")
            else:
                self._is_cancelled = True
            self._finish_board(number, BoardStep.FAILED, problem)
            return
        if self.is_writing and self._is_cancelled:
            self._finish_board(number, BoardStep.SKIPPED)
            return
        if (blocker := self._device.writer.blocker) or self._target is None:
            self._finish_board(number, BoardStep.FAILED, blocker)
            return
        try:
            changes = diff_against_draft(self._device.draft, self._target, is_stored=True)
        except BadRequest as mismatch:
            self._finish_board(number, BoardStep.FAILED, error_text(mismatch))
            return
        if self.is_writing:
            self._write(number, changes)
        else:
            self._set_step(
                number,
                BoardStep.REVIEWED,
                changes=changes,
                findings=self._findings(changes),
                doubts=tuple(self._device.parameters.values.doubtful(changes.rows)),
            )
            self._continue()

    def _findings(self, changes: Comparison) -> tuple[LintFinding, ...]:
        stored, settings = self._device.draft.stored, self._device.settings
        if stored is None or settings is None:
            return ()
        after = settings_after(stored, ((row.key, row.after) for row in changes.rows))
        rates = self._device.connection.port_rates
        return lint(after, Context(port_rates=rates, active_line=settings.line))

    def _write(self, number: int, changes: Comparison) -> None:
        if changes != next(plan.changes for plan in self.plans if plan.number == number):
            problem = tr(
                "Not written: the settings stored in the board have changed since the review."
            )
            self._finish_board(number, BoardStep.FAILED, problem)
            return
        values = values_to_write(row for row in changes.rows if row.changed)
        self._current = number
        self._set_step(number, BoardStep.WRITING)
        self._device.writer.write(tr("The same settings for several boards"), *values)

    @Slot(object)
    def _on_applied(self, results: tuple[WriteResult, ...]) -> None:
        if (number := self._current) is None:
            return
        self._current = None
        failed = [result for result in results if result.error is not None]
        if failed:
            names = ", ".join(self._device.draft.name_of(result.key) for result in failed)
            reasons = dict.fromkeys(error_text(result.error) for result in failed if result.error)
            text = tr("Not verified: {0}. {1}").format(names, " ".join(reasons))
            self._is_cancelled = True
            self._finish_board(number, BoardStep.FAILED, text)
        else:
            self._finish_board(number, BoardStep.WRITTEN)

    @Slot(str)
    def _on_request_failed(self, reason: str) -> None:
        if (number := self._current) is not None:
            self._current, self._is_cancelled = None, True
            self._finish_board(number, BoardStep.FAILED, reason)

    @Slot()
    def _on_stop_requested(self) -> None:
        unfinished = {BoardStep.WAITING, BoardStep.READING, BoardStep.WRITING}
        is_working = self.is_running and any(plan.step in unfinished for plan in self.plans)
        if is_working and not self._device.motors.stop_reason:
            self.was_stopped = True
            self.cancel()

    @Slot()
    def _on_line_closed(self) -> None:
        if not self.is_running:
            return
        for plan in self.plans:
            if plan.step in {BoardStep.READING, BoardStep.WRITING}:
                self._set_step(plan.number, BoardStep.FAILED, tr("The connection was closed."))
        self._current = self._initial = None
        self._end()

    def _end(self) -> None:
        for plan in self.plans:
            if plan.step is BoardStep.WAITING:
                self._set_step(plan.number, BoardStep.SKIPPED)
        initial, self._initial = self._initial, None
        if initial is not None and initial != self._boards.selected and self._boards.can_select:
            self._boards.select(initial, lambda _error: self._finish())
        else:
            self._finish()

    def _finish(self) -> None:
        if self.is_running:
            self.is_running = False
            self.changed.emit()
            self.finished.emit()
