"""Simulated board that the demo panel operates."""

import json
import re
from dataclasses import dataclass, fields
from typing import Any

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.core.translation import tr_noop
from trex_gui.devices.trex.protocol.flags import CHANNELS, InputSource, Mode
from trex_gui.ui.devices.simulator import DemoDevice, DemoLine, Simulator, on_or_off
from trex_gui.ui.runtime import new_timer

STICK_ENDS = {InputSource.RC: (900.0, 2100.0), InputSource.ANALOG: (0.0, 5.0)}  # µs, V

_SIGNAL = re.compile(r"([\d.]+) ?(us|V)", re.IGNORECASE)  # other text, such as noise, may follow
_SIGNAL_UNITS = {InputSource.RC: "US", InputSource.ANALOG: "V"}


BOOT_TEXTS = {  # step of a boot mode, as reported by `show` → text for the user
    "learning: ready": tr_noop("Learning: remove the Mix jumper to begin."),
    "learning: waiting for a signal": tr_noop("Learning: waiting for a signal on any input."),
    "learning: neutrals": tr_noop("Learning: leave the sticks centred for two seconds."),
    "learning: neutrals learned": tr_noop("Learning: one flash per input; green means learned."),
    "learning: extremes": tr_noop("Learning: hold each stick at both ends, ten seconds in all."),
    "learning: done": tr_noop("Learned; green means good. Remove SO–G, then power-cycle."),
    "boot loader: requested": tr_noop("Boot loader: remove Mix, then SO–G."),
    "boot loader: ready": tr_noop("Boot loader: waiting for firmware. Power-cycle to exit."),
}


@dataclass(frozen=True, slots=True)
class DemoChannel:
    signal: str  # in the format of the control line `channel`
    raw: int | None

    @property
    def has_signal(self) -> bool:
        return self.signal not in {"silent", "invalid"}

    def stick(self, source: InputSource) -> float | None:
        """Return the stick position in µs or V. `None` if unknown."""
        match = _SIGNAL.match(self.signal)
        if match and match[2].upper() == _SIGNAL_UNITS[source]:
            return float(match[1])
        return None if self.raw is None else source.physical(self.raw)


@dataclass(frozen=True, slots=True)
class DemoMotor:
    direction: str
    speed: int
    current: float  # A
    load: float  # A
    fault: bool


@dataclass(frozen=True, slots=True)
class DemoJumpers:
    """Positions of the jumpers. The board reads the mode jumper at power-up."""

    mode: str
    mix: bool
    so_ground: bool


@dataclass(frozen=True, slots=True)
class DemoLeds:
    """State of the LEDs, such as `on` or `blink 1/s`."""

    red: str
    green: str


@dataclass(frozen=True, slots=True)
class DemoSnapshot:
    power: bool
    mode: Mode  # as read at the last power-up
    jumpers: DemoJumpers
    leds: DemoLeds
    safe_start: bool
    override: bool
    serial_controls: bool
    required: int  # mask of the channels that RC mode requires
    boot_mode: str | None  # a key of `BOOT_TEXTS`; `None` in normal operation
    channels: tuple[DemoChannel, ...]
    motors: tuple[DemoMotor, ...]
    line: DemoLine
    battery: float  # V without load
    supply: float  # V at the board

    @property
    def source(self) -> InputSource:
        return self.mode.source


def read_snapshot(text: str) -> DemoSnapshot:
    state: dict[str, Any] = json.loads(text)
    names = "power", "safe_start", "override", "serial_controls", "boot_mode"
    return DemoSnapshot(
        **{name: state[name] for name in (*names, "battery", "supply")},
        mode=Mode(state["mode"]),
        jumpers=DemoJumpers(**state["jumpers"]),
        leds=DemoLeds(**state["leds"]),
        required=state["parameters"]["required_channels"],
        channels=tuple(DemoChannel(row["signal"], row["raw"]) for row in state["channels"]),
        motors=tuple(
            DemoMotor(**{field.name: row[field.name] for field in fields(DemoMotor)})
            for row in state["motors"]
        ),
        line=DemoLine(**state["line"]),
    )


_OFF_MS = 1000  # duration without power; long enough for the program to notice


class DemoBoard(DemoDevice[DemoSnapshot]):
    factory_reset = Signal()  # emitted before the board is reset to its initial state

    def __init__(self, simulator: Simulator, parent: QObject | None = None) -> None:
        super().__init__(simulator, read_snapshot, parent)
        self._held: dict[int, float] = {}  # channel → position of a held stick, 0 to 1
        self._after_off: tuple[str, ...] = ()  # control lines to send after `_OFF_MS`
        self._off_timer = new_timer(self, _OFF_MS, self._on_off_timeout, single_shot=True)

    @property
    def automatic(self) -> frozenset[int]:
        """Channels whose sticks move automatically."""
        return frozenset(CHANNELS) - self._held.keys()

    # --- Power, jumpers, bytes ----------------------------------------------------------

    def power_cycle(self) -> None:
        if not self._off_timer.isActive():
            self._switch_off_then("power on")

    def set_battery(self, volts: float) -> None:
        self._send_newest("battery", f"battery {volts:.1f}")

    def set_mode_jumper(self, mode: str) -> None:
        """Set the mode jumper to `serial` (no jumper), `rc` or `analog`."""
        self._send(f"jumper mode {mode}")

    def set_mix(self, on: bool) -> None:
        self._send(f"jumper mix {on_or_off(on)}")

    def set_so_ground(self, on: bool) -> None:
        self._send(f"jumper so-ground {on_or_off(on)}")

    def corrupt(self, error: str) -> None:
        """Corrupt the next byte with a `framing`, `parity` or `overrun` error."""
        self._send(f"line error {error}")

    # --- Motors and sticks --------------------------------------------------------------

    def set_load(self, motor: int, amperes: float) -> None:
        """Set the load current of a motor at full speed."""
        self._send_newest(f"load {motor}", f"load {motor} {amperes:.1f}")

    def set_fault(self, motor: int, fault: bool) -> None:
        self._send(f"fault {motor} {on_or_off(fault)}")

    def hold_stick(self, channel: int, value: float) -> None:
        """Hold a stick at a position in µs or V."""
        if self.snapshot is not None:
            low, high = STICK_ENDS[self.snapshot.source]
            self._held[channel] = (value - low) / (high - low)
            self._send_stick(channel)
            self.changed.emit()

    def set_silent(self, channel: int, silent: bool) -> None:
        if silent:
            self._send_newest(f"channel {channel}", f"channel {channel} silent")
        else:
            self._send_stick(channel)

    def set_automatic(self, automatic: bool) -> None:
        """Move connected sticks automatically, or hold them."""
        if (snapshot := self.snapshot) is None:
            return
        low, high = STICK_ENDS[snapshot.source]
        for channel, state in zip(CHANNELS, snapshot.channels, strict=True):
            if automatic:
                self._held.pop(channel, None)
            elif channel not in self._held:
                value = state.stick(snapshot.source) if state.has_signal else None
                position = 0.5 if value is None else (value - low) / (high - low)
                self._held[channel] = min(max(position, 0.0), 1.0)
            if state.has_signal:
                self._send_stick(channel)
        self.changed.emit()

    def center_sticks(self) -> None:
        if self.snapshot is not None:
            middle = sum(STICK_ENDS[self.snapshot.source]) / 2
            for channel, state in zip(CHANNELS, self.snapshot.channels, strict=True):
                if state.has_signal:
                    self.hold_stick(channel, middle)

    def _send_stick(self, channel: int) -> None:
        text = "rest"
        if channel in self._held and self.snapshot is not None:
            low, high = STICK_ENDS[self.snapshot.source]
            value = low + self._held[channel] * (high - low)
            text = f"{value:.0f}us" if self.snapshot.source is InputSource.RC else f"{value:.2f}V"
        self._send_newest(f"channel {channel}", f"channel {channel} {text}")

    # --- Power cycles and snapshots -----------------------------------------------------

    def restore_factory(self) -> None:
        """Reset the board and its EEPROM with a power cycle."""
        self._unsent.clear()
        self._held.clear()
        self.set_mute(False)
        self.set_noise(0)
        self._switch_off_then("factory", "power on")
        self.factory_reset.emit()
        self.changed.emit()

    def _switch_off_then(self, *lines: str) -> None:
        self._after_off = lines
        self._send("power off")
        self._off_timer.start()

    @Slot()
    def _on_off_timeout(self) -> None:
        if "factory" in self._after_off:
            self._held.clear()  # the user may have moved sticks while the power was off
        for line in self._after_off:
            self._send(line)

    def _show(self, snapshot: DemoSnapshot) -> None:
        before = self.snapshot
        super()._show(snapshot)
        if before is not None and before.source is not snapshot.source:
            # The sticks stay in place, but now output voltages instead of pulses, or vice versa.
            for channel in self._held:
                if snapshot.channels[channel - 1].has_signal:
                    self._send_stick(channel)

    def _discard(self) -> None:
        super()._discard()
        self._off_timer.stop()
        self._held.clear()
