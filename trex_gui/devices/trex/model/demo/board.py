"""The toy board on the desk: its sticks, jumpers, power and cable, for those without hardware."""

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.devices.trex.model.demo.snapshot import (
    STICK_ENDS,
    DemoSnapshot,
    read_snapshot,
    signal_text,
)
from trex_gui.devices.trex.protocol.flags import CHANNELS
from trex_gui.ui.devices.demo_device import DemoDevice, switch
from trex_gui.ui.devices.simulator_process import Simulator
from trex_gui.ui.runtime import runtime

_OFF_MS = 1000
"""How long a power cycle leaves the power off: a hand is no faster, and whoever talks to the
board has to notice that it was gone."""


class DemoBoard(DemoDevice[DemoSnapshot]):
    """A simulated TReX, and the sticks of whoever has none.

    Signals:
        changed: `snapshot` or `automatic` is another.
        made_new: the board is going to be as it was when the simulator started.
    """

    made_new = Signal()

    def __init__(self, simulator: Simulator, parent: QObject | None = None) -> None:
        super().__init__(simulator, read_snapshot, parent)
        self._held: dict[int, float] = {}  # share of the way at which a stick is held
        self._after_off: tuple[str, ...] = ()
        self._off = runtime().timer(self)
        self._off.setSingleShot(True)
        self._off.setInterval(_OFF_MS)
        self._off.timeout.connect(self._on_off_long_enough)

    @property
    def automatic(self) -> frozenset[int]:
        """The channels whose sticks move by themselves."""
        return frozenset(CHANNELS) - self._held.keys()

    # --- Power, jumpers, bytes ----------------------------------------------------------

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
        self._order(f"jumper mix {switch(on)}")

    def set_so_ground(self, on: bool) -> None:
        """Connect SO to ground, or not."""
        self._order(f"jumper so-ground {switch(on)}")

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
        self._order(f"fault {motor} {switch(fault)}")

    def restore_factory(self) -> None:
        """Make everything as it was when the simulator started, the EEPROM as from the factory.

        It takes the second that a power cycle takes. A cable that is out stays out.
        """
        self._forget_wishes()
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

    def _show_stick(self, channel: int) -> None:
        """Put on an input what its stick gives now."""
        text = "rest"
        if channel in self._held and self._snapshot is not None:
            low, high = STICK_ENDS[self._snapshot.source]
            text = signal_text(low + self._held[channel] * (high - low), self._snapshot.source)
        self._steer(f"channel {channel}", f"channel {channel} {text}")

    # --- What is seen -------------------------------------------------------------------

    def _take(self, snapshot: DemoSnapshot) -> None:
        before = self._snapshot
        super()._take(snapshot)
        if before is not None and before.source is not snapshot.source:
            # Sticks of the other kind are plugged in, and held at the same place.
            for channel in self._held:
                if snapshot.channels[channel - 1].has_signal:
                    self._show_stick(channel)

    def _forget(self) -> None:
        super()._forget()
        self._off.stop()
        self._held.clear()
