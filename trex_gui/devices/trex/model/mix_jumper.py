"""State of the mix jumper of a board."""

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.devices.trex.calibration.channel_curve import is_mixed
from trex_gui.devices.trex.model.settings.draft import SettingsDraft
from trex_gui.devices.trex.model.telemetry import Telemetry
from trex_gui.devices.trex.protocol.parameters import ParameterKey

_ENOUGH = 3  # consecutive results that make the state known; there are five results a second


class MixJumper(QObject):
    """State of the mix jumper when a stick was last off neutral.

    The jumper may be moved any time, and no command reads it. Its state is inferred from computed
    outputs of channels 1 and 2 and the outputs that the board reports.
    """

    changed = Signal()

    def __init__(
        self, draft: SettingsDraft, telemetry: Telemetry, parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self._draft = draft
        self._telemetry = telemetry
        self.is_on: bool | None = None  # `None`: not known
        self._candidate: bool | None = None
        self._count = 0
        telemetry.updated.connect(self._on_updated)
        telemetry.text_due.connect(self._on_text_due)

    def feed(self, outputs: tuple[int, int], reported: tuple[int, int]) -> None:
        seen = is_mixed(outputs, reported)
        if seen is None:
            return
        self._count = self._count + 1 if seen is self._candidate else 1
        self._candidate = seen
        if self._count >= _ENOUGH:
            self._set(seen)

    def clear(self) -> None:
        self._candidate = None
        self._set(None)

    def _set(self, is_on: bool | None) -> None:
        if is_on is not self.is_on:
            self.is_on = is_on
            self.changed.emit()

    @Slot()
    def _on_updated(self) -> None:
        if self._telemetry.raw is None:
            self.clear()

    @Slot()
    def _on_text_due(self) -> None:
        telemetry, draft = self._telemetry, self._draft
        reported = telemetry.remapped
        if draft.parameters.values.active_of(ParameterKey.MOTOR_MODE) == 1:  # nothing is mixed
            self.clear()
            return
        one, two, flip = (draft.stored_curve(channel) for channel in (1, 2, 4))
        if one and two and flip and reported and not flip.is_switched(4, telemetry.raw_of(4)):
            outputs = one.output(telemetry.raw_of(1)), two.output(telemetry.raw_of(2))
            self.feed(outputs, (reported[0], reported[1]))
