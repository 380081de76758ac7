"""What there is of every simulated device: it is watched, switched, and its cable handled."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Generic, Protocol, TypeVar

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.ui.devices.simulator_process import Simulator
from trex_gui.ui.runtime import runtime

_INTERVAL_MS = 125


@dataclass(frozen=True, slots=True)
class DemoLine:
    """The wire to this computer; `noise` is the probability that a byte is spoilt."""

    plugged: bool
    mute: bool
    noise: float


class DeviceSnapshot(Protocol):
    """What every simulated device says of itself."""

    @property
    def power(self) -> bool:
        """Whether it is switched on."""
        ...

    @property
    def line(self) -> DemoLine:
        """The wire to this computer."""
        ...


SnapshotT = TypeVar("SnapshotT", bound=DeviceSnapshot)


class DemoDevice(QObject, Generic[SnapshotT]):
    """Does to a simulated device what hands do to a real one, and watches it.

    It is watched only while somebody looks (`watch`) and the simulator runs. Whoever drags a
    slider may ask for more than the simulator can follow: of each such thing one line is under
    way, the newest wish waits behind it, those between are dropped.

    Signals:
        changed: `snapshot` is another.
        refused: why the simulator did not do what was asked, for people.
    """

    changed = Signal()
    refused = Signal(str)

    def __init__(
        self,
        simulator: Simulator,
        read: Callable[[str], SnapshotT],
        parent: QObject | None = None,
    ) -> None:
        """Watch what runs in `simulator`; `read` reads the JSON of its line `show`."""
        super().__init__(parent)
        self._simulator = simulator
        self._read = read
        self._snapshot: SnapshotT | None = None
        self._newest: dict[str, str] = {}
        self._under_way: set[str] = set()
        self._orders = 0
        self._looking = False
        self._timer = runtime().timer(self)
        self._timer.setInterval(_INTERVAL_MS)
        self._timer.timeout.connect(self._look)
        simulator.ended.connect(self._on_simulator_ended)

    @property
    def snapshot(self) -> SnapshotT | None:
        """What was seen last; `None` before anything was, and when the simulator has ended."""
        return self._snapshot

    def watch(self, watched: bool) -> None:
        """Say whether somebody looks."""
        if watched and not self._timer.isActive():
            self._timer.start()
            self._look()
        elif not watched:
            self._timer.stop()

    # --- Power and cable ----------------------------------------------------------------

    def set_power(self, on: bool) -> None:
        """Switch its power."""
        self._order(f"power {switch(on)}")

    def set_plugged(self, plugged: bool) -> None:
        """Put the cable in, or pull it."""
        self._order("line plug" if plugged else "line unplug")

    def set_mute(self, mute: bool) -> None:
        """Cut the wire that carries its answers, or mend it."""
        self._order(f"line mute {switch(mute)}")

    def set_noise(self, probability: float) -> None:
        """Spoil this share of the bytes on the wire."""
        self._steer("noise", f"line noise {probability:.4f}")

    # --- Lines to the simulator ---------------------------------------------------------

    def _order(self, line: str, then: Callable[[], None] | None = None) -> None:
        """Send a line, and look again once it is obeyed."""

        def answered(answer: str) -> None:
            if answer.startswith("error"):
                self.refused.emit(_sentence(answer.removeprefix("error ")))
                self.changed.emit()  # whoever shows the wish already can take it back
            if then is not None:
                then()
            if self._timer.isActive():
                self._look()

        self._orders += 1
        self._simulator.send(line, answered)

    def _steer(self, what: str, line: str) -> None:
        """Send the newest wish for `what`, as soon as the one before is done."""

        def done() -> None:
            self._under_way.discard(what)
            if following := self._newest.pop(what, ""):
                self._steer(what, following)

        if what in self._under_way:
            self._newest[what] = line
        elif self._simulator.url:
            self._under_way.add(what)
            self._order(line, done)

    def _forget_wishes(self) -> None:
        """Drop what waits behind a line that is under way."""
        self._newest.clear()

    @Slot()
    def _look(self) -> None:
        """Ask for everything, unless that is under way."""
        if self._simulator.url and not self._looking:
            orders, self._looking = self._orders, True
            self._simulator.send("show", lambda answer: self._take_show(answer, orders))

    def _take_show(self, answer: str, orders: int) -> None:
        self._looking = False
        if orders != self._orders:
            if self._timer.isActive():
                self._look()  # something was asked for since: this is how things were before
        elif answer.startswith("ok "):
            self._take(self._read(answer.removeprefix("ok ")))

    def _take(self, snapshot: SnapshotT) -> None:
        before, self._snapshot = self._snapshot, snapshot
        if snapshot != before:
            self.changed.emit()

    @Slot()
    def _on_simulator_ended(self) -> None:
        self._forget()
        self.changed.emit()

    def _forget(self) -> None:
        """Know of nothing any more: there is no simulator."""
        self._snapshot = None
        self._looking = False
        self._newest.clear()
        self._under_way.clear()


def switch(on: bool) -> str:
    """Return the word of the control lines for a switch."""
    return "on" if on else "off"


def _sentence(text: str) -> str:
    return f"{text[:1].upper()}{text[1:].rstrip('. ')}."
