"""A simulated device as its panel handles it: snapshots, power, cable, control lines."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Generic, Protocol, TypeVar

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.ui.devices.simulator_process import Simulator
from trex_gui.ui.runtime import runtime

_INTERVAL_MS = 125


@dataclass(frozen=True, slots=True)
class DemoLine:
    """The wire to this computer; `noise` is the probability that a byte is corrupted."""

    plugged: bool
    mute: bool
    noise: float


class DeviceSnapshot(Protocol):
    """State that every simulated device reports."""

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
    """Operates a simulated device by control lines, and polls its state.

    It is polled only while watched and while the simulator runs. A slider may move faster than
    the simulator answers: one control line for each key is under way, and of those that follow
    only the newest is kept.

    Signals:
        changed: `snapshot` has changed.
        rejected: why the simulator rejected a control line, for the user.
    """

    changed = Signal()
    rejected = Signal(str)

    def __init__(
        self,
        simulator: Simulator,
        read: Callable[[str], SnapshotT],
        parent: QObject | None = None,
    ) -> None:
        """Operate the device in `simulator`; `read` parses the JSON that `show` reports."""
        super().__init__(parent)
        self._simulator = simulator
        self._read = read
        self._snapshot: SnapshotT | None = None
        self._unsent: dict[str, str] = {}
        self._under_way: set[str] = set()
        self._sent = 0
        self._polling = False
        self._timer = runtime().timer(self)
        self._timer.setInterval(_INTERVAL_MS)
        self._timer.timeout.connect(self._poll)
        simulator.ended.connect(self._on_simulator_ended)

    @property
    def snapshot(self) -> SnapshotT | None:
        """The last state; `None` before the first one, and when the simulator has ended."""
        return self._snapshot

    def watch(self, watched: bool) -> None:
        """Start or stop polling."""
        if watched and not self._timer.isActive():
            self._timer.start()
            self._poll()
        elif not watched:
            self._timer.stop()

    # --- Power and cable ----------------------------------------------------------------

    def set_power(self, on: bool) -> None:
        self._send(f"power {switch(on)}")

    def set_plugged(self, plugged: bool) -> None:
        """Plug or unplug the cable."""
        self._send("line plug" if plugged else "line unplug")

    def set_mute(self, mute: bool) -> None:
        """Cut or connect the wire that carries replies."""
        self._send(f"line mute {switch(mute)}")

    def set_noise(self, probability: float) -> None:
        """Corrupt this share of the bytes on the wire."""
        self._send_newest("noise", f"line noise {probability:.4f}")

    # --- Lines to the simulator ---------------------------------------------------------

    def _send(self, line: str, then: Callable[[], None] | None = None) -> None:
        """Send a control line, and poll once it is executed."""

        def answered(answer: str) -> None:
            if answer.startswith("error"):
                self.rejected.emit(_sentence(answer.removeprefix("error ")))
                self.changed.emit()  # the panel shows the previous state again
            if then is not None:
                then()
            if self._timer.isActive():
                self._poll()

        self._sent += 1
        self._simulator.send(line, answered)

    def _send_newest(self, key: str, line: str) -> None:
        """Send a control line for a key as soon as the previous one is executed."""

        def done() -> None:
            self._under_way.discard(key)
            if following := self._unsent.pop(key, ""):
                self._send_newest(key, following)

        if key in self._under_way:
            self._unsent[key] = line
        elif self._simulator.url:
            self._under_way.add(key)
            self._send(line, done)

    def _discard_unsent(self) -> None:
        """Discard control lines that are not sent yet."""
        self._unsent.clear()

    @Slot()
    def _poll(self) -> None:
        """Request the state, unless that is pending."""
        if self._simulator.url and not self._polling:
            sent, self._polling = self._sent, True
            self._simulator.send("show", lambda answer: self._take_reply(answer, sent))

    def _take_reply(self, answer: str, sent: int) -> None:
        self._polling = False
        if sent != self._sent:
            if self._timer.isActive():
                self._poll()  # the state is older than a control line sent since
        elif answer.startswith("ok "):
            self._take(self._read(answer.removeprefix("ok ")))

    def _take(self, snapshot: SnapshotT) -> None:
        before, self._snapshot = self._snapshot, snapshot
        if snapshot != before:
            self.changed.emit()

    @Slot()
    def _on_simulator_ended(self) -> None:
        self._discard()
        self.changed.emit()

    def _discard(self) -> None:
        """Discard all state: the simulator has ended."""
        self._snapshot = None
        self._polling = False
        self._unsent.clear()
        self._under_way.clear()


def switch(on: bool) -> str:
    """Return the word for a switch in control lines."""
    return "on" if on else "off"


def _sentence(text: str) -> str:
    return f"{text[:1].upper()}{text[1:].rstrip('. ')}."
