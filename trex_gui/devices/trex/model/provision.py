"""Setup of several boards, one by one, from a profile."""

from collections.abc import Callable
from dataclasses import replace
from enum import Enum, auto

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.core.errors import BadRequest, StudioError
from trex_gui.core.translation import in_english, tr
from trex_gui.devices.trex.board import WriteResult
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.setup.pulses import MotorPulses
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.devices.trex.settings.comparison import (
    Comparison,
    compare_with_board,
    values_to_write,
)
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.provision_record import (
    ENDED_IN_MOTOR_TEST,
    ProvisionedBoard,
    ProvisionRecord,
    differing,
    fingerprint,
    result_text,
)
from trex_gui.ui.files import in_background
from trex_gui.ui.translations import error_sentence, error_text


class ProvisionStep(Enum):
    PROFILE = auto()  # not started
    WAIT = auto()  # waiting for a board
    REVIEW = auto()
    WRITE = auto()
    MOTORS = auto()
    UNPLUG = auto()  # the board is finished or unsuitable


class Provision(QObject):
    """Sets up each connected board after the user's review."""

    changed = Signal()  # any public attribute

    def __init__(self, device: Device, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.step = ProvisionStep.PROFILE
        self.board: ProvisionedBoard | None = None  # entry of the record, proposed or final
        self.comparison = Comparison(())  # differences, before or after the write
        self.done: list[ProvisionedBoard] = []  # entries added to the record since `start`
        self.problem = ""  # reason why the board or the record cannot be used
        self.pulses = MotorPulses(device, self)
        self.turns_motors = False  # after the write, the user turns the motors of each board
        self._device = device
        self._profile: Settings | None = None
        self._record: ProvisionRecord | None = None
        self._is_ending = False
        self._after_saving: Callable[[], None] | None = None  # called once the record is saved
        device.link_changed.connect(self._on_board_changed)
        device.state_changed.connect(self._on_board_changed)
        device.applied.connect(self._on_applied)
        device.request_failed.connect(self._on_request_failed)
        device.connection.line_closed.connect(self._on_line_closed)

    # --- User actions -------------------------------------------------------------------

    def start(self, profile: Settings, record: ProvisionRecord, *, turns_motors: bool) -> None:
        self._profile, self._record, self.turns_motors = profile, record, turns_motors
        self.done, self._is_ending = [], False
        self._set_step(ProvisionStep.WAIT)
        self._on_board_changed()

    def write(self) -> None:
        """Save the proposed entry in the record, then write the reviewed values."""
        if self.step is ProvisionStep.REVIEW and self.board and self._device.writer.can_apply:
            self._set_step(ProvisionStep.WRITE)
            self._save(self.board, self._write)

    def skip(self) -> None:
        stored = self._device.draft.stored
        if self.step is ProvisionStep.REVIEW and self.board and self._record and stored:
            self._finish(self._record.skipped(self.board, stored))

    def finish_motors(self, *, turned: bool) -> None:
        if self.step is ProvisionStep.MOTORS and self.board is not None:
            self.pulses.stop("")
            self._finish(self.board if turned else replace(self.board, result=ENDED_IN_MOTOR_TEST))

    def retry(self) -> None:
        if self.problem and self._after_saving is not None and self.board is not None:
            self._save(self.board, self._after_saving)

    def stop(self) -> None:
        """End the setup after the current board."""
        self.finish_motors(turned=False)
        self._is_ending = True
        if self.problem or (self.step is not ProvisionStep.WRITE and self._after_saving is None):
            self._after_saving = None
            self._set_step(ProvisionStep.PROFILE)

    # --- Boards, one by one -------------------------------------------------------------

    @Slot()
    def _on_board_changed(self) -> None:
        device, stored = self._device, self._device.draft.stored
        is_present = device.is_connected and device.state is not None and stored is not None
        number = stored.parameters.get(ParameterKey.DEVICE_NUMBER) if stored else None
        match self.step:
            case ProvisionStep.WAIT if is_present and device.is_writable:
                self._review()
            case ProvisionStep.REVIEW:
                if is_present:
                    self._review()
                else:
                    self._set_step(ProvisionStep.WAIT)
            case ProvisionStep.MOTORS if not is_present:
                self.finish_motors(turned=False)
            case ProvisionStep.UNPLUG if self._after_saving is None:
                if not is_present or (self.board is not None and number != self.board.number):
                    self._set_step(ProvisionStep.WAIT)
                    self._on_board_changed()

    def _review(self) -> None:
        try:
            self.comparison = self._compare()
            if self._record is not None and (stored := self._device.draft.stored):
                signature, rows = str(self._device.signature or ""), self.comparison.rows
                self.board = self._record.propose(stored, signature, rows)
        except BadRequest as error:
            self.board, self.comparison = None, Comparison(())
            self._set_step(ProvisionStep.UNPLUG, error_text(error))
        else:
            self._set_step(ProvisionStep.REVIEW)

    def _compare(self) -> Comparison:
        state, stored = self._device.state, self._device.draft.stored
        if state is None or stored is None or self._profile is None:
            return Comparison(())
        return Comparison(differing(compare_with_board(stored, state.source, self._profile)))

    def _write(self) -> None:
        parameters, calibrations = values_to_write(self.comparison.rows)
        stored, board = self._device.draft.stored, self.board
        key = ParameterKey.DEVICE_NUMBER
        if stored is not None and board is not None and stored.parameters[key] != board.number:
            parameters = (*parameters, (key, board.number))
        if not (parameters or calibrations):
            self._on_written("")
        elif self._device.writer.can_apply:
            reason = tr("Set up as {0}").format(board.name if board else "")
            self._device.writer.write(reason, parameters, calibrations)
        else:
            self._on_written(tr("No board is connected."))

    @Slot(object)
    def _on_applied(self, results: tuple[WriteResult, ...]) -> None:
        if self.step is not ProvisionStep.WRITE or self._after_saving is not None:
            return
        failed = [result for result in results if result.error is not None]
        with in_english():
            reasons = dict.fromkeys(error_sentence(result.error) for result in failed)
        keys = " ".join(result.key for result in failed)
        self._on_written(f"not verified: {keys}: {' '.join(reasons)}" if failed else "")

    @Slot(str)
    def _on_request_failed(self, reason: str) -> None:
        if self.step is ProvisionStep.WRITE and self._after_saving is None:
            self._on_written(reason)

    @Slot()
    def _on_line_closed(self) -> None:
        self._on_request_failed(tr("The connection was closed."))

    def _on_written(self, problem: str) -> None:
        stored = self._device.draft.stored
        if self.board is None or self._profile is None or stored is None:
            return
        result = problem or result_text(self._profile, stored, self._compare().rows)
        self.board = replace(self.board, calibrations=fingerprint(stored), result=result)
        if self.turns_motors and not self._is_ending and result.startswith("ok"):
            self._set_step(ProvisionStep.MOTORS)
        else:
            self._finish(self.board)

    def _finish(self, board: ProvisionedBoard) -> None:
        self._set_step(ProvisionStep.UNPLUG)

        def on_saved() -> None:
            self.done.append(board)
            if self._is_ending:
                self._set_step(ProvisionStep.PROFILE)
            else:
                self.changed.emit()
                self._on_board_changed()

        self._save(board, on_saved)

    def _save(self, board: ProvisionedBoard, then: Callable[[], None]) -> None:
        if (record := self._record) is None:
            return
        self.board, self._after_saving, self.problem = board, then, ""
        record.add(board)
        in_background(self, record.save, lambda _: self._on_saved(), self._on_not_saved)
        self.changed.emit()

    def _on_saved(self) -> None:
        then, self._after_saving = self._after_saving, None
        if then is not None:
            then()

    def _on_not_saved(self, error: StudioError) -> None:
        self.problem = error_text(error)
        self.changed.emit()

    def _set_step(self, step: ProvisionStep, problem: str = "") -> None:
        self.step, self.problem = step, problem
        if step in {ProvisionStep.PROFILE, ProvisionStep.WAIT}:
            self.board, self.comparison = None, Comparison(())
        self.changed.emit()
