"""Connection of the window to one device at a time."""

from collections.abc import Callable, Collection, Mapping
from functools import partial
from typing import Any

from PySide6.QtCore import QObject, QTimer, Signal, Slot

from trex_gui.core.transport.settings import PortSettings
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.devices.controller import DeviceController
from trex_gui.ui.devices.ports import Port
from trex_gui.ui.devices.scanner import DeviceScanner
from trex_gui.ui.notifier import Remedies

Controller = DeviceController[Any]


class DeviceManager(QObject):
    """Connects to one device at a time. Disconnects the previous device first."""

    changed = Signal()  # any property of `current` may have changed
    progressed = Signal(int, int, str)  # completed steps, total steps, next step
    current_changed = Signal()  # `current` is now another kind of device
    stop_reported = Signal(str)  # sentences about an automatic stop; see `stop_remedies`

    def __init__(
        self, factories: Mapping[str, Callable[[], Controller]], scanner: DeviceScanner
    ) -> None:
        """`factories`: device key → function that creates the controller on first use."""
        super().__init__()
        self.scanner = scanner
        self._factories = dict(factories)
        self._controllers: dict[str, Controller] = {}
        # Controller of the current connection. If there is none, controller of the last connection.
        self.current = self.controller(next(iter(factories)))
        self._next: Callable[[], None] | None = None  # called once `current` is disconnected
        self.user_disconnected = False  # the user has disconnected and not yet reconnected
        self.stop_remedies: Remedies = ()  # offered with `stop_reported`

    def controller(self, device: str) -> Controller:
        if device not in self._controllers:
            controller = self._factories[device]()
            controller.changed.connect(self._on_changed)
            controller.progressed.connect(self.progressed)
            controller.stop_reported.connect(partial(self._on_stop_reported, controller))
            # Replaced, because `stop_now` may iterate over the old dictionary in another thread.
            self._controllers = {**self._controllers, device: controller}
        return self._controllers[device]

    @property
    def controllers(self) -> Collection[Controller]:
        return self._controllers.values()

    @property
    def is_idle(self) -> bool:
        return self.current.link is ConnectionState.DISCONNECTED and not self.current.starting

    def select(self, port: Port) -> None:
        """Use the settings of a port, since the user may connect to it next."""
        if self.is_idle and port.device == self.current.plugin.key:
            self.current.select(port)

    def connect_to(self, port: Port) -> None:
        self.user_disconnected = False
        controller = self.controller(port.device)
        self._switch_to(controller, lambda: controller.connect_to(port))

    def connect_with(self, port: Port, settings: PortSettings) -> None:
        self.user_disconnected = False
        controller = self.controller(port.device)
        self._switch_to(controller, lambda: controller.connect_with(port, settings))

    def switch_to(self, device: str, then: Callable[[], object]) -> bool:
        """Make another kind of device current without connecting to it. Then call `then`.

        If a device is disconnecting, `then` is called later. Return False if a connected device
        prevents the switch.
        """
        controller = self.controller(device)
        if controller is self.current:
            then()
            return True
        is_closing = self.current.link is ConnectionState.DISCONNECTING and self._next is None
        is_possible = self.is_idle or is_closing
        if is_possible:
            self._switch_to(controller, then)
        return is_possible

    def _switch_to(self, controller: Controller, then: Callable[[], object]) -> None:
        self._next = None
        if controller is not self.current:
            # Even an idle controller may be waiting for the end of a scan.
            self.current.disconnect_device()
            if not self.is_idle:
                self._next = lambda: self._switch_to(controller, then)
                return
            self.current = controller
            self.current_changed.emit()
        then()

    def when_connected(self, then: Callable[[], object]) -> None:
        """Call `then` once, after the next connection is reported."""

        def run_once() -> None:
            if self.current.link is ConnectionState.CONNECTED:
                self.changed.disconnect(run_once)
                QTimer.singleShot(0, then)

        self.changed.connect(run_once)

    def disconnect_device(self) -> None:
        """Disconnect on the user's request."""
        self.user_disconnected = True
        self._next = None
        self.current.disconnect_device()

    def press_stop(self) -> None:
        for controller in self._controllers.values():
            controller.press_stop()

    def stop_because(self, reason: str, remedies: Remedies = ()) -> None:
        """Stop every device because of an event.

        `stop_reported` emits the texts of all devices, starting with the current device. If there
        are `remedies` but no texts, the signal emits the reason.
        """
        self.stop_remedies = remedies
        texts = {
            controller.plugin.key: controller.stop_because(reason)
            for controller in self._controllers.values()
        }
        texts_to_show = [texts.pop(self.current.plugin.key), *texts.values()]
        text = "\n".join(filter(None, texts_to_show)) or (f"{reason}." if remedies else "")
        if text:
            self.stop_reported.emit(text)

    def _on_stop_reported(self, controller: Controller, text: str) -> None:
        if controller is self.current:
            self.stop_reported.emit(text)

    @property
    def unconfirmed_stop(self) -> str:
        """Warning if motors may still be turning although every line is closed. Otherwise empty."""
        return "\n".join(
            filter(None, (controller.unconfirmed_stop for controller in self._controllers.values()))
        )

    @property
    def is_armed(self) -> bool:
        return any(controller.is_armed for controller in self._controllers.values())

    @property
    def may_move(self) -> bool:
        return any(controller.may_move for controller in self._controllers.values())

    @property
    def needs_stop(self) -> bool:
        return any(controller.needs_stop for controller in self._controllers.values())

    def stop_now(self, *, ending: bool = False) -> None:
        """Stop every device. Can be called from any thread. `ending`: also close the ports."""
        for controller in self._controllers.values():
            controller.stop_now(ending=ending)

    def shut_down(self) -> bool:
        """Close all lines at once and end a scan. Return whether everything ended in time."""
        self._next = None
        for controller in self._controllers.values():
            controller.start_shutdown()
        self.scanner.cancel()
        in_time = [controller.shut_down() for controller in self._controllers.values()]
        in_time.append(self.scanner.shut_down())
        return all(in_time)

    @Slot()
    def _on_changed(self) -> None:
        if self._next is not None and self.is_idle:
            self._next()
        else:
            self.changed.emit()
