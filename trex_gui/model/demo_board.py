"""The toy board on the desk: its sticks, jumpers, power and cable, for those without hardware."""

from collections.abc import Callable

from PySide6.QtCore import QObject, QTimer, Signal, Slot

from trex_gui.model.demo_snapshot import STICK_ENDS, DemoSnapshot, read_snapshot, signal_text
from trex_gui.model.simulator import Simulator
from trex_gui.protocol.flags import CHANNELS

_INTERVAL_MS = 125
_OFF_MS = 1000
"""How long a power cycle leaves the power off: a hand is no faster, and whoever talks to the
board has to notice that it was gone."""


class DemoBoard(QObject):
    """Does to the simulated board what hands do to a real one, and watches it.

    It is watched only while somebody looks (`watch`) and the simulator runs. Whoever drags a
    slider may ask for more than the simulator can follow: of each such thing one line is under
    way, the newest wish waits behind it, those between are dropped.

    Signals:
        changed: `snapshot` or `automatic` is another.
        made_new: the board is going to be as it was when the simulator started.
        refused: why the simulator did not do what was asked, for people.
    """

    changed = Signal()
    made_new = Signal()
    refused = Signal(str)

    def __init__(self, simulator: Simulator, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._simulator = simulator
        self._snapshot: DemoSnapshot | None = None
        self._held: dict[int, float] = {}  # share of the way at which a stick is held
        self._newest: dict[str, str] = {}
        self._under_way: set[str] = set()
        self._orders = 0
        self._looking = False
        self._after_off: tuple[str, ...] = ()
        self._off = QTimer(self)
        self._off.setSingleShot(True)
        self._off.setInterval(_OFF_MS)
        self._off.timeout.connect(self._on_off_long_enough)
        self._timer = QTimer(self)
        self._timer.setInterval(_INTERVAL_MS)
        self._timer.timeout.connect(self._look)
        simulator.ended.connect(self._on_simulator_ended)

    @property
    def snapshot(self) -> DemoSnapshot | None:
        """What was seen last; `None` before anything was, and when the simulator has ended."""
        return self._snapshot

    @property
    def automatic(self) -> frozenset[int]:
        """The channels whose sticks move by themselves."""
        return frozenset(CHANNELS) - self._held.keys()

    def watch(self, watched: bool) -> None:
        """Say whether somebody looks."""
        if watched and not self._timer.isActive():
            self._timer.start()
            self._look()
        elif not watched:
            self._timer.stop()

    # --- Power, jumpers, cable ----------------------------------------------------------

    def set_power(self, on: bool) -> None:
        """Switch the board's power."""
        self._order(f"power {_switch(on)}")

    def power_cycle(self) -> None:
        """Switch the power off, and on again after a second; the jumpers are read."""
        if not self._off.isActive():
            self._switch_off_and("power on")

    def set_battery(self, volts: float) -> None:
        """Put in a battery of this voltage."""
        self._steer("battery", f"battery {volts:.1f}")

    def set_mode_jumper(self, mode: str) -> None:
        """Set the mode jumper: `serial` (none), `rc` or `analog`."""
        self._order(f"jumper mode {mode}")

    def set_mix(self, on: bool) -> None:
        """Set the mix jumper, or take it off."""
        self._order(f"jumper mix {_switch(on)}")

    def set_so_ground(self, on: bool) -> None:
        """Connect SO to ground, or not."""
        self._order(f"jumper so-ground {_switch(on)}")

    def set_plugged(self, plugged: bool) -> None:
        """Put the cable in, or pull it."""
        self._order("line plug" if plugged else "line unplug")

    def set_mute(self, mute: bool) -> None:
        """Cut the wire that carries the board's answers, or mend it."""
        self._order(f"line mute {_switch(mute)}")

    def set_noise(self, probability: float) -> None:
        """Spoil this share of the bytes on the wire."""
        self._steer("noise", f"line noise {probability:.4f}")

    def spoil(self, error: str) -> None:
        """Let the next byte reach the board with an error: `framing`, `parity`, `overrun`."""
        self._order(f"line error {error}")

    # --- Sticks and motors --------------------------------------------------------------

    def hold_stick(self, channel: int, value: float) -> None:
        """Hold a stick where it gives this many µs, or V where voltages are measured."""
        if self._snapshot is None:
            return
        low, high = STICK_ENDS[self._snapshot.source]
        self._held[channel] = (value - low) / (high - low)
        self._show_stick(channel)
        self.changed.emit()

    def set_silent(self, channel: int, silent: bool) -> None:
        """Take the signal off an input, or give it what the stick gives again."""
        if silent:
            self._steer(f"channel {channel}", f"channel {channel} silent")
        else:
            self._show_stick(channel)

    def set_automatic(self, automatic: bool) -> None:
        """Let all sticks move by themselves, or hold them where they are.

        An input without a signal stays without; this is what its stick does afterwards.
        """
        snapshot = self._snapshot
        if snapshot is None:
            return
        low, high = STICK_ENDS[snapshot.source]
        for channel, seen in zip(CHANNELS, snapshot.channels, strict=True):
            if automatic:
                self._held.pop(channel, None)
            elif channel not in self._held:
                value = seen.stick(snapshot.source) if seen.has_signal else None
                share = 0.5 if value is None else (value - low) / (high - low)
                self._held[channel] = min(max(share, 0.0), 1.0)
            if seen.has_signal:
                self._show_stick(channel)
        self.changed.emit()

    def centre_sticks(self) -> None:
        """Hold every stick in the middle."""
        if self._snapshot is not None:
            low, high = STICK_ENDS[self._snapshot.source]
            for channel, seen in zip(CHANNELS, self._snapshot.channels, strict=True):
                if seen.has_signal:
                    self.hold_stick(channel, (low + high) / 2)

    def set_load(self, motor: int, amperes: float) -> None:
        """Load motor 1 or 2 so that it draws this current at full speed."""
        self._steer(f"load {motor}", f"load {motor} {amperes:.1f}")

    def set_fault(self, motor: int, fault: bool) -> None:
        """Let the driver of motor 1 or 2 report a fault, or recover."""
        self._order(f"fault {motor} {_switch(fault)}")

    def restore_factory(self) -> None:
        """Make everything as it was when the simulator started, the EEPROM as from the factory.

        It takes the second that a power cycle takes. A cable that is out stays out.
        """
        self._newest.clear()
        self._held.clear()
        self.set_mute(False)
        self.set_noise(0)
        self._switch_off_and("factory", "power on")
        self.made_new.emit()
        self.changed.emit()

    def _switch_off_and(self, *lines: str) -> None:
        self._after_off = lines
        self._order("power off")
        self._off.start()

    @Slot()
    def _on_off_long_enough(self) -> None:
        if "factory" in self._after_off:
            self._held.clear()  # whatever was moved in the meantime
        for line in self._after_off:
            self._order(line)

    # --- Lines to the simulator ---------------------------------------------------------

    def _show_stick(self, channel: int) -> None:
        """Put on an input what its stick gives now."""
        text = "rest"
        if channel in self._held and self._snapshot is not None:
            low, high = STICK_ENDS[self._snapshot.source]
            text = signal_text(low + self._held[channel] * (high - low), self._snapshot.source)
        self._steer(f"channel {channel}", f"channel {channel} {text}")

    def _order(self, line: str, then: Callable[[], None] | None = None) -> None:
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

    @Slot()
    def _look(self) -> None:
        """Ask for everything, unless that is under way."""
        if self._simulator.url and not self._looking:
            orders, self._looking = self._orders, True
            self._simulator.send("show", lambda answer: self._take_show(answer, orders))

    def _take_show(self, answer: str, orders: int) -> None:
        self._looking = False
        if orders != self._orders:
            self._look()  # something was asked for since: this is how things were before
        elif answer.startswith("ok "):
            self._take(read_snapshot(answer.removeprefix("ok ")))

    def _take(self, snapshot: DemoSnapshot) -> None:
        before, self._snapshot = self._snapshot, snapshot
        if before is not None and before.source is not snapshot.source:
            # Sticks of the other kind are plugged in, and held at the same place.
            for channel in self._held:
                if snapshot.channels[channel - 1].has_signal:
                    self._show_stick(channel)
        if snapshot != before:
            self.changed.emit()

    @Slot()
    def _on_simulator_ended(self) -> None:
        self._snapshot = None
        self._looking = False
        self._off.stop()
        self._held.clear()
        self._newest.clear()
        self._under_way.clear()
        self.changed.emit()


def _switch(on: bool) -> str:
    return "on" if on else "off"


def _sentence(text: str) -> str:
    return f"{text[:1].upper()}{text[1:].rstrip('. ')}."
