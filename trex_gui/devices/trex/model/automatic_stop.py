"""An automatic stop in words: what the board has confirmed of it, and never more."""

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.core.errors import NoReply, StudioError, sentence
from trex_gui.devices.trex.client.explanations import BEYOND_A_STOP
from trex_gui.devices.trex.model.device import Device
from trex_gui.ui.devices.connection_state import ConnectionState


class AutomaticStop(QObject):
    """Stops the motors because of something that happened, and follows what becomes of it.

    Of stops that come one upon the other only the newest is reported.

    Signals:
        reported: what has become of the stop, in sentences that begin with its reason.
    """

    reported = Signal(str)

    def __init__(self, device: Device, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._device = device
        self._newest = 0
        self._awaited = ""  # the reason of a stop that nothing is known of yet
        self._unconfirmed = ""  # the reason of a stop that may still be confirmed
        device.link_changed.connect(self._on_link_changed)
        device.motors.arming_changed.connect(self._on_arming_changed)

    def stop(self, reason: str) -> str:
        """Stop and disarm, because of `reason`, a clause without a full stop.

        Return what is known of it at once; empty where no board is connected and none was left
        with motors that may turn.
        """
        self._unconfirmed = ""
        self._newest += 1
        if self._device.link is ConnectionState.DISCONNECTED:
            return self._out_of_reach(reason) if self._device.may_move else ""
        number, self._awaited = self._newest, reason
        self._device.stop_motors(
            lambda error: self._on_stopped(number, reason, error), reason=f"{reason}."
        )
        return self.tr("{0}. The stop was sent, and is not confirmed yet.").format(reason)

    # --- What has become of it ----------------------------------------------------------

    def _on_stopped(self, number: int, reason: str, error: StudioError | None) -> None:
        if number != self._newest:
            return
        self._awaited = ""
        if error is None:
            self.reported.emit(self._confirmed(reason))
            return
        if self._device.may_move:
            self._unconfirmed = reason
        self.reported.emit(self._not_confirmed(reason, error))

    @Slot()
    def _on_link_changed(self) -> None:
        """A stop is repeated until it is confirmed, or the returned board has confirmed it.

        A stop that was requested of a line that had just ended gets no outcome.
        """
        if self._device.link is ConnectionState.DISCONNECTED:
            reason, self._awaited, self._unconfirmed = self._awaited, "", ""
            if reason:
                self.reported.emit(self._closed(reason))
        elif (
            self._unconfirmed
            and self._device.link is ConnectionState.CONNECTED
            and not self._device.may_move
        ):
            reason, self._unconfirmed = self._unconfirmed, ""
            self.reported.emit(self._confirmed(reason))

    @Slot()
    def _on_arming_changed(self) -> None:
        """Forget the stop once the motors are armed; the next confirmation is of another one."""
        if self._device.motors.armed:
            self._unconfirmed = ""

    # --- In words -----------------------------------------------------------------------

    def _confirmed(self, reason: str) -> str:
        """Return what the confirmation means: mostly, but not always, motors at standstill."""
        by_serial = self._device.telemetry.serial_controls
        if by_serial is None:  # not read yet, or no longer responding
            return self.tr("{0}. The board has confirmed the stop.").format(reason)
        if not by_serial:
            return f"{reason}. {BEYOND_A_STOP}"
        return self.tr("{0}, so the motors were stopped.").format(reason)

    def _not_confirmed(self, reason: str, error: StudioError) -> str:
        if isinstance(error, NoReply):  # it says what was sent, and what to do
            return f"{reason}. {sentence(error)}"
        text = self.tr("{0}. The stop is not confirmed: {1} If a motor still turns, cut its power.")
        return text.format(reason, sentence(error))

    def _closed(self, reason: str) -> str:
        if self._device.may_move:
            return self._out_of_reach(reason)
        return self.tr("{0}. The line is closed.").format(reason)

    def _out_of_reach(self, reason: str) -> str:
        text = self.tr(
            "{0}. No board is connected that could be stopped, and motors may still turn: cut "
            "their power."
        )
        return text.format(reason)
