"""Group of boards that are driven together on one line."""

from collections.abc import Iterable, Sequence
from contextlib import suppress
from dataclasses import replace
from urllib.parse import quote

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.core.events import Event
from trex_gui.core.transport.urls import is_served
from trex_gui.devices.trex.driving.requests import SetAuxiliary, SetpointRequest
from trex_gui.devices.trex.driving.wheels import (
    Wheel,
    both_sides_of_each,
    packed,
    setpoints_of,
    unpacked,
)
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.drive_controller import Routed
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.preferences import Preferences


class BoardGroup(QObject):
    """Boards that are driven together. Motors 1 and 2 are the left and right sides."""

    changed = Signal()  # `devices` or `wheels`

    def __init__(self, device: Device, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._device = device
        self._others: dict[int, Device] = {}
        self.wheels: tuple[Wheel, ...] = ()
        device.driving.routed = self._routed
        device.driving.undrivable_board = self._undrivable_board
        device.driving.named = device.named
        device.connection.started.connect(self._update_devices)
        device.connection.device_read.connect(self._update_devices)  # a server sends its group

    @property
    def devices(self) -> dict[int, Device]:
        """Devices by board number. Empty for a single board."""
        settings = self._device.settings
        if settings is None or not self._others or not settings.group:
            return {}
        return {settings.group[0]: self._device, **self._others}

    def proposed(self, numbers: Iterable[int]) -> tuple[Wheel, ...]:
        """Return the saved wheels of these boards, or a default."""
        boards = sorted(numbers)
        with suppress(ValueError):
            saved = unpacked(Preferences().text(self._preference_key(boards)))
            if {wheel.board for wheel in saved} == set(boards):
                return saved
        return both_sides_of_each(boards)

    def join(self, wheels: Sequence[Wheel]) -> None:
        """Reopen the line to drive the boards of these wheels together."""
        settings, numbers = self._device.settings, sorted({wheel.board for wheel in wheels})
        if settings is not None:
            Preferences().set(self._preference_key(numbers), packed(wheels))
            self._device.connect_to(settings.with_group(numbers))

    @property
    def can_change(self) -> bool:
        """True for a direct connection. A server owns its group."""
        settings = self._device.settings
        return settings is not None and not is_served(settings.url)

    def separate(self) -> None:
        """Reopen the line to drive the first board alone."""
        if (settings := self._device.settings) is not None:
            self._device.connect_to(replace(settings, group=()))

    def _preference_key(self, numbers: Sequence[int]) -> str:
        settings = self._device.settings
        url = "" if settings is None else quote(settings.url, safe="")
        return f"wheels/{url}/{'-'.join(map(str, numbers))}"

    # --- The motors -----------------------------------------------------------------------

    def _routed(self, request: SetpointRequest) -> Routed:
        if not self.wheels or isinstance(request, SetAuxiliary):
            return ((None, request),)
        return tuple(setpoints_of(self.wheels, request).items())

    def _undrivable_board(self) -> int | None:
        """Return the number of the first board that cannot be driven, or `None`."""
        for number, device in self._others.items():
            if not device.is_connected or not device.board.serial_controls:
                return number
        return None

    # --- The boards -----------------------------------------------------------------------

    @Slot()
    def _update_devices(self) -> None:
        settings = self._device.settings
        numbers = () if settings is None else settings.group
        wheels = self.proposed(numbers) if numbers else ()
        if set(self._others) == set(numbers[1:]) and self.wheels == wheels:
            return
        for number in self._others.keys() - set(numbers[1:]):
            self._others.pop(number).deleteLater()
        for number in numbers[1:]:
            if number not in self._others:
                self._others[number] = self._new_device(number)
        self.wheels = wheels
        self._device.other_devices = list(self._others.values())
        self._device.motors.are_sides = bool(numbers)
        for number, device in (self.devices or {0: self._device}).items():
            device.wheels = {wheel.motor: wheel for wheel in self.wheels if wheel.board == number}
        self.changed.emit()

    def _new_device(self, number: int) -> Device:
        device = Device(self._device.notifier, self, main=self._device, number=number)
        device.driving.named = device.named
        device.connection.ready.connect(self._device.driving.repeat_stop)
        device.events.happened.connect(lambda event: self._forward_event(device, event))
        return device

    def _forward_event(self, device: Device, event: Event) -> None:
        if device.link is not ConnectionState.DISCONNECTED:
            self._device.events.put(replace(event, text=device.named(event.text)))
