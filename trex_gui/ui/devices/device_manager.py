"""Which device the window is connected to: one at a time, whatever kind it is of."""

from collections.abc import Callable, Sequence
from functools import partial
from typing import Protocol

from PySide6.QtCore import QObject, Signal, SignalInstance, Slot

from trex_gui.core.transport.settings import PortSettings
from trex_gui.ui.devices.connection_state import ConnectionState
from trex_gui.ui.devices.device_kind import DeviceKind
from trex_gui.ui.devices.ports import Port


class DeviceController(Protocol):
    """How one kind of device is reached."""

    @property
    def changed(self) -> SignalInstance:
        """Told when anything of what stands below is other than it was."""
        ...

    @property
    def progressed(self) -> SignalInstance:
        """Steps done, steps in all, what comes next."""
        ...

    @property
    def stop_reported(self) -> SignalInstance:
        """What `stop_because` has come to, in sentences, where more is known by now."""
        ...

    @property
    def kind(self) -> DeviceKind:
        """The kind of device."""
        ...

    @property
    def link(self) -> ConnectionState:
        """How things stand."""
        ...

    @property
    def status(self) -> str:
        """How things stand, as a sentence."""
        ...

    @property
    def starting(self) -> bool:
        """Whether the simulated device is being started, and will be connected to."""
        ...

    @property
    def port(self) -> Port | None:
        """The port that is connected, or about to be."""
        ...

    @property
    def demo_in_use(self) -> bool:
        """Whether the simulated device was chosen last, and not given up since."""
        ...

    @property
    def has_line_settings(self) -> bool:
        """Whether a person chooses how the line is set."""
        ...

    @property
    def is_busy(self) -> bool:
        """Whether leaving now would cut something off."""
        ...

    @property
    def line_text(self) -> str:
        """How the line is set, for the next connection, in short."""
        ...

    def connect_to(self, port: Port) -> None:
        """Connect to a port that leads to a device of this kind."""
        ...

    def connect_with(self, port: Port, settings: PortSettings) -> None:
        """Connect to a port at which a device was found with these settings."""
        ...

    def leave(self) -> None:
        """Stop what moves, as far as that can be done, and close the line."""
        ...

    def press_stop(self) -> None:
        """Stop, because a person wants it."""
        ...

    def stop_because(self, reason: str) -> str:
        """Stop, as far as that can be done, because of something that nobody asked for.

        `reason` is a clause without a full stop: "The screen was locked". Return what the stop
        means for this device, no more than is known, in sentences that begin with the reason;
        empty where there is nothing that could be stopped.
        """
        ...

    @property
    def unconfirmed_stop(self) -> str:
        """What people have to know of motors that may turn though the line is closed.

        In sentences; empty where every stop that was asked for is proved.
        """
        ...

    def begin_to_shut_down(self) -> None:
        """Stop what can be stopped, and let the line end, for the end of the program.

        Waits for nobody.
        """
        ...

    def shut_down(self) -> bool:
        """Close the line for the end of the program; return whether it ended in time."""
        ...


class DeviceManager(QObject):
    """Connects to one device at a time; the one before is left first.

    Signals:
        changed: what is told of the device in use.
        progressed: steps done, steps in all, what comes next.
        current_changed: `current` is another kind of device.
        stop_told: what a stop that nobody asked for means, in sentences, for people; again where
            more is known of it.
    """

    changed = Signal()
    progressed = Signal(int, int, str)
    current_changed = Signal()
    stop_reported = Signal(str)

    def __init__(self, ways: Sequence[DeviceController], parent: QObject | None = None) -> None:
        """Choose among `ways`; the first is in use until another one is asked for."""
        super().__init__(parent)
        self._ways = {way.kind.key: way for way in ways}
        self._current = ways[0]
        self._next: Callable[[], None] | None = None
        for way in ways:
            way.changed.connect(self._on_changed)
            way.progressed.connect(self.progressed)
            way.stop_reported.connect(partial(self._on_stop_reported, way))

    @property
    def current(self) -> DeviceController:
        """The device that is connected, or was last."""
        return self._current

    @property
    def is_idle(self) -> bool:
        """Whether nothing is connected, nor about to be."""
        return self._current.link is ConnectionState.DISCONNECTED and not self._current.starting

    def connect_to(self, port: Port) -> None:
        """Connect to a port; a device of another kind is left first."""
        way = self._ways[port.device]
        self._switch_to(way, lambda: way.connect_to(port))

    def connect_with(self, port: Port, settings: PortSettings) -> None:
        """Connect to a port at which a device was found with these settings."""
        way = self._ways[port.device]
        self._switch_to(way, lambda: way.connect_with(port, settings))

    def switch_to(self, device: str) -> bool:
        """Use another kind of device from now on, and connect to none.

        Return whether it is in use: nothing that is connected is left for it.
        """
        way = self._ways[device]
        if way is not self._current and self.is_idle:
            self._switch_to(way, lambda: None)
        return way is self._current

    def _switch_to(self, way: DeviceController, then: Callable[[], None]) -> None:
        self._next = None
        if way is not self._current:
            self._current.leave()  # an idle one may be waiting for a search to end, too
            if not self.is_idle:
                self._next = lambda: self._switch_to(way, then)
                return
            self._current = way
            self.current_changed.emit()
        then()

    def leave(self) -> None:
        """Disconnect."""
        self._next = None
        self._current.leave()

    def press_stop(self) -> None:
        """Stop every device that may listen."""
        for way in self._ways.values():
            way.press_stop()

    def stop_because(self, reason: str, *, is_news: bool = False) -> None:
        """Stop every device that may listen, because of something that nobody asked for.

        What that means is for each device to say, the one in use first. Where none has anything to
        say the reason is told alone, but only where it `is_news` by itself.
        """
        texts = {way.kind.key: way.stop_because(reason) for way in self._ways.values()}
        told = [texts.pop(self._current.kind.key), *texts.values()]
        text = "\n".join(filter(None, told)) or (f"{reason}." if is_news else "")
        if text:
            self.stop_reported.emit(text)

    def _on_stop_reported(self, way: DeviceController, text: str) -> None:
        if way is self._current:
            self.stop_reported.emit(text)

    @property
    def unconfirmed_stop(self) -> str:
        """What people have to know of motors that may turn though every line is closed.

        In sentences; empty where there is nothing to know.
        """
        return "\n".join(filter(None, (way.unconfirmed_stop for way in self._ways.values())))

    def shut_down(self) -> bool:
        """Close every line; return whether all ended in time.

        None waits for another: each is told before the first is waited for.
        """
        self._next = None
        for way in self._ways.values():
            way.begin_to_shut_down()
        ends = [way.shut_down() for way in self._ways.values()]  # each, whatever the others do
        return all(ends)

    @Slot()
    def _on_changed(self) -> None:
        if self._next is not None and self.is_idle:
            self._next()
        else:
            self.changed.emit()
