"""Controller of a TReX: line settings and automatic stops."""

from contextlib import suppress
from dataclasses import replace

from PySide6.QtCore import Signal, Slot

from trex_gui.core.errors import BadReply, BadRequest, NoReply, StudioError
from trex_gui.core.plugin import DevicePlugin
from trex_gui.core.timing import Timeouts
from trex_gui.core.translation import Number, tr
from trex_gui.core.transport.settings import PortSettings
from trex_gui.devices.trex.driving.board_reasons import NOISE_COUNTS
from trex_gui.devices.trex.model.demo import DemoBoard
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.group import BoardGroup
from trex_gui.devices.trex.model.loss_while_driven import LossWhileDriven
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings, numbers_in
from trex_gui.devices.trex.protocol.descriptions import STOP_UNCONFIRMED, STOP_WITHOUT_EFFECT
from trex_gui.devices.trex.protocol.errors import ErrorCode, TrexError
from trex_gui.devices.trex.protocol.framing import check_polynomial
from trex_gui.devices.trex.protocol.line_settings import LineSettings
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.devices.controller import DeviceController, QualityReport
from trex_gui.ui.devices.ports import Port, PortKind, Ports
from trex_gui.ui.devices.scanner import DeviceScanner
from trex_gui.ui.notifier import Notifier, Remedy
from trex_gui.ui.preferences import Preferences
from trex_gui.ui.translations import error_sentence

_LINE = "line/settings"
_NUMBER = "line/device_number"
_POLYNOMIAL = "line/polynomial"
_RESERVED = "line/reserved"


class TrexController(DeviceController[ConnectionSettings]):
    """Saves line settings, and reports the outcome of automatic stops."""

    has_line_settings = True

    settings_changed = Signal(object)  # the new `ConnectionSettings`

    def __init__(
        self,
        plugin: DevicePlugin,
        notifier: Notifier,
        ports: Ports,
        scanner: DeviceScanner,
        timeouts: Timeouts,
    ) -> None:
        self.device = device = Device(notifier)
        self._default = ConnectionSettings("", timeouts=timeouts)
        super().__init__(plugin, device, ports, scanner, self._default)
        device.setParent(self)
        self.group = BoardGroup(device, self)
        self.show_searches_in(device.connection.traffic)
        self._store = Preferences()
        self.settings = self._read_settings()
        scanner.next_connection = plugin.key, self.settings.packed
        self.demo_board = DemoBoard(self.simulator, self)
        # Port of the last connection attempt. Not updated while its motors may be turning
        self._last_port: Port | None = None
        LossWhileDriven(device, self)
        self._stops = 0  # number of automatic stops so far
        self._unconfirmed = ""  # reason for the unconfirmed stop, or empty

        self.simulator.ended.connect(self._reset_demo_settings)
        self.demo_board.factory_reset.connect(self._reset_demo_settings)
        device.stop_pressed_offline.connect(self._on_stop_pressed_offline)
        device.connection.started.connect(self._set_adapter)
        device.connection.failed.connect(self._on_failed)
        device.link_changed.connect(self._record_settings)
        device.quality_changed.connect(self.changed)
        device.motors.arming_changed.connect(self.changed)
        for signal in (device.link_changed, device.motors.arming_changed):
            signal.connect(self._report_late_confirmation)
        device.connection.progressed.connect(self.progressed)

    @property
    def line_text(self) -> str:
        settings = self._demo_settings if self.demo_in_use else self.settings
        number = settings.device_number
        return settings.short if number is None else f"{settings.short} #{number}"

    def set_settings(self, settings: ConnectionSettings) -> None:
        self.settings = replace(settings, url="", name="")
        self._store.set(_LINE, settings.line.to_wire())
        number = settings.device_number
        self._store.set(_NUMBER, -1 if number is None else number)
        self._store.set(_POLYNOMIAL, settings.polynomial)
        self._store.set(_RESERVED, settings.reserved_text)
        self._scanner.next_connection = self.plugin.key, settings.packed
        self.settings_changed.emit(self.settings)
        self.changed.emit()

    def connect_to(self, port: Port) -> None:
        if not self.may_move:
            self._last_port = port
        super().connect_to(port)

    @Slot()
    def _set_adapter(self) -> None:
        # Not set earlier, because the previous line may be lost before this line is opened.
        if self.port is not None:
            self.device.motors.adapter = "" if self.port.adapter is None else self.port.adapter.key

    def select(self, port: Port) -> None:
        if self._selected is not None and not self._selected.is_same(port) and not self.may_move:
            self._clear_group()
        super().select(port)

    def _clear_group(self) -> None:
        self.settings = replace(self.settings, group=())

    @Slot(object)
    def _on_failed(self, error: StudioError) -> None:
        if isinstance(error, NoReply | BadReply) and not self.may_move:
            self._clear_group()  # one missing board would prevent every connection to the group

    def connect_with(self, port: Port, settings: PortSettings) -> None:
        self.select(port)
        connection = ConnectionSettings.on(settings)
        if port.kind is PortKind.DEMO:
            self._demo_settings = connection
        else:
            self.set_settings(connection)
        self.connect_to(port)

    def set_packed(self, settings: str) -> None:
        with suppress(BadRequest):  # an edited preferences file may contain invalid settings
            self.set_settings(self.settings.unpacked(settings))

    @Slot()
    def _record_settings(self) -> None:
        used, port = self.device.settings, self.port
        if self.link is not ConnectionState.CONNECTED or used is None or port is None:
            return
        settings = replace(used, url="", name="")
        if port.kind is PortKind.DEMO:
            self._demo_settings = settings
            self.changed.emit()
        elif settings != self.settings:
            self.set_settings(settings)

    @Slot()
    def _reset_demo_settings(self) -> None:
        """Expect factory line settings from a new or reset simulated board."""
        self._demo_settings = self._default
        if self.demo_in_use:
            self.device.connection.expect((ConnectionSettings(""),))

    def _read_settings(self) -> ConnectionSettings:
        store = self._store
        wire = store.integer(_LINE, self._default.line.to_wire(), 0, 127)
        number = store.integer(_NUMBER, -1, -1, 127)
        polynomial = store.integer(_POLYNOMIAL, self._default.polynomial, 0, 255)
        try:
            return replace(
                self._default,
                line=LineSettings.from_wire(wire),
                device_number=None if number < 0 else number,
                polynomial=check_polynomial(polynomial),
                reserved=numbers_in(store.text(_RESERVED)),
            )
        except ValueError:
            return self._default

    @property
    def quality(self) -> QualityReport:
        device, quality = self.device, self.device.board.quality
        if quality.is_noisy is None or not device.is_connected:
            return QualityReport()
        if not quality.is_noisy:
            return QualityReport(tr("Line: good"))
        lost = tr("{0:.1f} % lost").format(Number(100 * quality.lost))
        if device.settings is not None and device.settings.line.has_crc:
            text = tr("{0}: noisy; shorten cable, check ground")
            return QualityReport(text.format(lost), is_bad=True)
        text = tr("{0}: noisy; shorten cable, check ground, use CRC").format(lost)
        can_set_up = device.is_writable and not device.writer.is_rejected and not self.is_armed
        return QualityReport(text, is_bad=True, remedy=Remedy.SET_UP_CRC if can_set_up else None)

    @property
    def is_busy(self) -> bool:
        return self.device.writer.running

    @property
    def is_armed(self) -> bool:
        return self.device.motors.armed

    @property
    def may_move(self) -> bool:
        return self.device.may_move

    @property
    def unconfirmed_stop(self) -> str:
        if self.link is not ConnectionState.DISCONNECTED:
            return ""
        texts = [self.device.driving.lost_board]
        if self.may_move:
            texts.append(tr(STOP_UNCONFIRMED))
        return "\n".join(filter(None, texts))

    @property
    def needs_stop(self) -> bool:
        device = self.device
        if self.link is ConnectionState.DISCONNECTED:
            return bool(self.unconfirmed_stop)
        noise = NOISE_COUNTS * device.telemetry.ampere
        return (
            self.link is not ConnectionState.CONNECTED
            or self.is_armed
            or self.may_move
            # Another program or a stick may be driving.
            or any(amps > noise for amps in device.telemetry.motor_currents or ())
        )

    def press_stop(self) -> None:
        self.device.press_stop()

    @Slot()
    def _on_stop_pressed_offline(self) -> None:
        """Reconnect if motors may still be turning. A new session sends a stop first."""
        device = self.device
        if not self.may_move or self._last_port is None:
            # `lost_board` comes first, because `loss_text` may use the timeout of another board.
            text = device.driving.lost_board or device.loss_text
            device.notifier.warn(text, lasts=lambda: device.stop_may_matter)
            return
        device.warn(tr("Trying to reach the board to stop it …"))
        self.connect_to(self.ports.current_entry(self._last_port) or self._last_port)

    def stop_now(self, *, ending: bool = False) -> None:
        self.device.connection.stop_now(ending=ending)

    # --- Automatic stops: only the newest stop is reported --------------------------------

    def stop_because(self, reason: str) -> str:
        self._unconfirmed = ""
        self._stops += 1
        if self.device.link is ConnectionState.DISCONNECTED:
            return self._unreachable_text(reason) if self.device.may_move else ""
        number = self._stops
        self.device.driving.stop(
            lambda error: self._on_stopped(number, reason, error), reason=f"{reason}."
        )
        return tr("{0} A stop was sent but is not confirmed yet.").format(f"{reason}.")

    def _on_stopped(self, number: int, reason: str, error: StudioError | None) -> None:
        if number != self._stops:
            return
        if error is None:
            text = self._confirmation_text(reason)
        elif isinstance(error, TrexError) and error.code is ErrorCode.CLOSED:
            text = tr("{0}. The connection is closed.").format(reason)
            if self.may_move:
                text = self._unreachable_text(reason)
        else:
            self._unconfirmed = reason if self.may_move else ""
            text = tr(
                "{0}. The stop is not confirmed: {1} If a motor is still turning, cut its power."
            )
            if isinstance(error, NoReply):  # the error names the cause and the remedy
                text = "{0}. {1}"
            text = text.format(reason, error_sentence(error))
        self.stop_reported.emit(text)

    @Slot()
    def _report_late_confirmation(self) -> None:
        if self.is_armed or self.link is ConnectionState.DISCONNECTED:
            self._unconfirmed = ""
        elif self._unconfirmed and self.device.is_connected and not self.may_move:
            reason, self._unconfirmed = self._unconfirmed, ""
            self.stop_reported.emit(self._confirmation_text(reason))

    def _confirmation_text(self, reason: str) -> str:
        serial_controls = self.device.board.serial_controls
        if serial_controls is None:  # the mode has not been read yet, or the board does not respond
            return tr("{0}. The board has confirmed the stop.").format(reason)
        if not serial_controls:
            return f"{reason}. {tr(STOP_WITHOUT_EFFECT)}"
        return tr("{0}, so the motors were stopped.").format(reason)

    def _unreachable_text(self, reason: str) -> str:
        return tr(
            "{0}. Motors may still be turning: cut their power. No board is connected, so no "
            "stop can be sent."
        ).format(reason)
