"""Commands for the settings of a board."""

from contextlib import suppress
from dataclasses import replace
from functools import cached_property
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.core.errors import BadRequest
from trex_gui.core.translation import tr
from trex_gui.devices.trex.board import WriteResult
from trex_gui.devices.trex.model.boards import BoardList
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.linter import BoardLinter
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.ui.frame.main_window import MainWindow
from trex_gui.ui.notifier import Answer
from trex_gui.ui.translations import error_sentence

if TYPE_CHECKING:
    from trex_gui.devices.trex.views.changes.review import Review
    from trex_gui.devices.trex.views.power_cycle import PowerCycleFlow


class SettingsCommands(QObject):
    parameter_requested = Signal(str)  # key of the parameter to show during its review

    def __init__(
        self, device: Device, linter: BoardLinter, boards: BoardList, frame: MainWindow
    ) -> None:
        super().__init__(frame)
        self._device = device
        self._linter, self._boards, self._frame = linter, boards, frame
        self._question = frame.question
        device.applied.connect(self._on_applied)
        device.applied.connect(frame.question.reconsider)

    @cached_property
    def _review(self) -> "Review":
        from trex_gui.devices.trex.views.changes.review import Review  # noqa: PLC0415

        return Review(self._device, self._linter, self._boards, self._frame)

    @cached_property
    def _power(self) -> "PowerCycleFlow":
        from trex_gui.devices.trex.views.power_cycle import PowerCycleFlow  # noqa: PLC0415
        from trex_gui.devices.trex.views.steps import Steps  # noqa: PLC0415

        flow = PowerCycleFlow(self._device)
        Steps(self._device, flow, self._frame)
        return flow

    @Slot()
    def review(self) -> None:
        """Show the changes to write, or the progress of writing."""
        self._review.review()

    def review_defaults(self, *, serial_only: bool) -> None:
        self._review.review_defaults(serial_only=serial_only)

    @Slot()
    def close_if_verified(self) -> None:
        """Close the review if its result requires no user action."""
        self._review.close_if_verified()

    @Slot()
    def show_power_cycle(self) -> None:
        self._power.start()

    @Slot(object)
    def _on_applied(self, results: tuple[WriteResult, ...]) -> None:
        notifier = self._device.notifier
        failed = [result for result in results if result.error is not None]
        if failed:
            names = ", ".join(self._device.draft.name_of(result.key) for result in failed)
            reasons = " ".join(dict.fromkeys(error_sentence(result.error) for result in failed))
            notifier.error.emit(tr("Not verified: {0}. {1}").format(names, reasons))
            return
        notifier.cleared.emit()
        if any(result.key == ParameterKey.FACTORY_RESET for result in results):
            self.show_power_cycle()
        elif not self._review.dialog.isVisible():
            notifier.info.emit(tr("%n setting(s) written and verified.", "", len(results)))

    @Slot()
    def reload(self) -> None:
        """Read the settings from the board. Prompt first if there are edits."""
        device = self._device

        def discard_and_reload() -> None:
            device.draft.discard_edits()
            device.reload()

        if not device.draft.pending:
            device.reload()
            return
        self._question.prompt(
            tr("Read the settings from the board and discard the edits made here?"),
            Answer("reloadYes", tr("Discard and reload"), discard_and_reload),
            is_valid=lambda: device.draft.pending > 0 and device.is_writable,
        )

    def propose_crc(self) -> None:
        """Propose CRC-7 as an edit of the stored line settings."""
        key, parameters = ParameterKey.UART_SETTINGS, self._device.parameters
        if parameters.values.stored.get(key) != parameters.values.active_of(key):
            self.show_power_cycle()
            return
        self.parameter_requested.emit(key)
        wire = parameters.values.value_of(key)
        if wire is None:
            return
        with suppress(BadRequest):  # invalid baud rate
            line = replace(LineSettings.from_wire(wire), detection=Detection.CRC7)
            parameters.edit(key, line.to_wire())
            text = tr(
                "{0} is now one of the pending changes and takes effect after the board is "
                "switched off and on. This window then uses the new setting. Other programs "
                "on this line must also use the new setting."
            )
            self._device.notifier.info.emit(text.format("CRC-7"))
            self.review()
