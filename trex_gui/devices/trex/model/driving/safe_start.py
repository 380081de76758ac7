"""Whether safe-start may still be holding the motors where channels drive them."""

from PySide6.QtCore import QObject, Slot

from trex_gui.devices.trex.calibration.proof import NEARLY_NEUTRAL
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.protocol.flags import Mode, channels_in
from trex_gui.devices.trex.protocol.parameter_keys import ParameterKey

_NOISE_COUNTS = 1
"""Counts that may be noise while nothing flows."""


class SafeStartWatch(QObject):
    """Remembers whether sticks were at rest, or motors drew current, since the board came.

    Inferred: the board has no flag for safe-start. It begins at power-up and when a required
    channel falls silent, and ends when the channels that drive are near neutral, all at once;
    how near is inferred, too. Ref: TReX Jr User's Guide 4.e.
    """

    def __init__(self, device: Device, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._device = device
        self._over = False

        device.telemetry.updated.connect(self._on_telemetry_updated)

    @property
    def may_hold(self) -> bool:
        """Whether a channel asks for something, no current flows and nothing shows why."""
        values, currents = self._values(), self._device.telemetry.motor_currents
        return (
            bool(values) and currents is not None and not self._over and not self._device.is_joint
        )

    @Slot()
    def _on_telemetry_updated(self) -> None:
        values = self._values()
        if not values or self._has_lost_a_channel():
            self._over = False
        elif all(abs(value) <= NEARLY_NEUTRAL for value in values) or self._flows():
            self._over = True

    def _values(self) -> tuple[int, ...]:
        """What the channels that drive ask for; nothing where none does, or it is not known."""
        device = self._device
        state, remapped = device.state, device.telemetry.remapped
        if state is None or state.mode.is_serial or remapped is None:
            return ()
        first, second, third, *_ = remapped
        return (first, third) if device.is_joint else (first, second, third)

    def _flows(self) -> bool:
        state, currents = self._device.state, self._device.telemetry.motor_currents
        if state is None or currents is None:
            return False
        return max(currents) > (_NOISE_COUNTS + 0.5) * state.signature.model.current_unit

    def _has_lost_a_channel(self) -> bool:
        state, telemetry = self._device.state, self._device.telemetry
        required = self._device.parameters.stored_of(ParameterKey.REQUIRED_CHANNELS) or 0
        return (
            state is not None
            and state.mode is Mode.RC
            and telemetry.raw is not None
            and any(telemetry.raw_of(channel) is None for channel in channels_in(required))
        )
