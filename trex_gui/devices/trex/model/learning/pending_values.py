"""Learned values as pending edits."""

from collections.abc import Iterable, Sequence

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.devices.trex.board import WriteResult
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.learning.channels import Choice
from trex_gui.devices.trex.protocol.flags import channel_mask, channels_in
from trex_gui.devices.trex.protocol.parameters import ParameterKey

_REVERSED = ParameterKey.REVERSED_CHANNELS


class PendingLearnedValues(QObject):
    """Puts learned values into the draft, and reports when they are stored.

    Values are not reported if they are undone, edited again or lost with the connection.
    """

    stored = Signal(object)  # channels whose values were written and verified

    def __init__(self, device: Device, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._device = device
        self._unstored: dict[int, Choice] = {}

        device.applied.connect(self._on_applied)
        device.link_changed.connect(self._on_link_changed)
        device.draft.pending_changed.connect(self._on_pending_changed)

    def edit(self, choices: dict[int, Choice], name: str) -> bool:
        """Edit these channels in one undo step. Return whether an edit is pending."""
        reversed_ = self._reversed_channels()
        with self._device.draft.one_edit(name):
            for number, choice in choices.items():
                self._device.calibrations.edit(number, choice.calibration)
                reversed_.discard(number)
                if choice.reversed_:
                    reversed_.add(number)
            if self._device.parameters.values.can_edit(_REVERSED):
                self._device.parameters.edit(_REVERSED, channel_mask(reversed_), alone=True)
        is_pending = any(map(self.has_edit, choices))
        self._unstored = dict(choices) if is_pending else {}
        return is_pending

    def clear(self) -> None:
        self._unstored = {}

    def has_edit(self, number: int) -> bool:
        """Return whether the calibration or direction of a channel is edited."""
        return self._calibration_edits((number,)) > 0 or number in self._edited_directions()

    def other_edits(self, numbers: Sequence[int]) -> int:
        """Return the number of pending edits of other settings."""
        directions = self._edited_directions()
        own = self._calibration_edits(numbers) + bool(directions and directions <= set(numbers))
        return self._device.draft.pending - own

    def _calibration_edits(self, numbers: Iterable[int]) -> int:
        return sum(key.channel in numbers for key, _ in self._device.calibrations.pending)

    def _edited_directions(self) -> set[int]:
        """Return the channels with a pending change of direction."""
        stored = channels_in(self._device.parameters.values.stored.get(_REVERSED) or 0)
        return self._reversed_channels() ^ set(stored)

    def _reversed_channels(self) -> set[int]:
        return set(channels_in(self._device.parameters.values.value_of(_REVERSED) or 0))

    @Slot(object)
    def _on_applied(self, results: tuple[WriteResult, ...]) -> None:
        verified = [result for result in results if result.error is None]
        written = {result.channel for result in verified}
        are_directions_written = any(result.key == _REVERSED for result in verified)
        stored_numbers = tuple(
            number
            for number in self._unstored
            if (number in written or are_directions_written) and not self.has_edit(number)
        )
        for number in stored_numbers:
            del self._unstored[number]
        if stored_numbers:
            self.stored.emit(stored_numbers)

    @Slot()
    def _on_link_changed(self) -> None:
        if not self._device.is_connected:
            self.clear()

    @Slot()
    def _on_pending_changed(self) -> None:
        shown, reversed_ = self._device.calibrations.shown, self._reversed_channels()
        has_directions = self._device.parameters.values.can_edit(_REVERSED)
        self._unstored = {
            number: choice
            for number, choice in self._unstored.items()
            if shown(number) == choice.calibration
            and (not has_directions or (number in reversed_) is choice.reversed_)
        }
