"""What the simulated board says of itself, as its control line `show` tells it."""

import json
import re
from dataclasses import dataclass, fields
from typing import Any

from trex_gui.devices.trex.protocol.flags import InputSource, Mode
from trex_gui.ui.devices.demo_device import DemoLine

STICK_ENDS = {InputSource.RC: (900.0, 2100.0), InputSource.ANALOG: (0.0, 5.0)}
"""Where the sticks of the simulated board end: in µs, or in V."""

_SIGNAL = re.compile(r"([\d.]+) ?(us|V)", re.IGNORECASE)  # noise may be told after it
_SIGNAL_UNITS = {InputSource.RC: "US", InputSource.ANALOG: "V"}
_JUMPERS_OF_MODE = {Mode.RC: "rc", Mode.ANALOG: "analog"}


@dataclass(frozen=True, slots=True)
class DemoChannel:
    """One input: what is connected to it, in the words of `channel`, and what is measured."""

    signal: str
    raw: int | None

    @property
    def has_signal(self) -> bool:
        """Whether anything arrives."""
        return self.signal not in {"silent", "invalid"}

    def stick(self, source: InputSource) -> float | None:
        """Return where its stick is, in µs or V; `None` when there is no telling.

        The signal tells it at once, a measurement only with the next pulse.
        """
        found = _SIGNAL.match(self.signal)
        if found and found[2].upper() == _SIGNAL_UNITS[source]:
            return float(found[1])
        return None if self.raw is None else source.physical(self.raw)


@dataclass(frozen=True, slots=True)
class DemoMotor:
    """One output and the motor on it; current, load and the current when stalled in A."""

    direction: str
    speed: int
    current: float
    load: float
    stall: float
    fault: bool


@dataclass(frozen=True, slots=True)
class DemoJumpers:
    """The jumpers as they are set now, whatever the board has read at power-up."""

    mode: str
    mix: bool
    so_ground: bool


@dataclass(frozen=True, slots=True)
class DemoLeds:
    """`on`, `off` or the name of a pattern, such as `fast flash` or `blink 1/s`."""

    red: str
    green: str


@dataclass(frozen=True, slots=True)
class DemoSnapshot:
    """Everything that the panel shows, at one moment.

    Attributes:
        mode: as read at the last power-up.
        required: mask of the channels that RC mode cannot do without.
        special_start: what it does instead of its normal work; empty for nothing.
        battery, supply: V of the battery, and what is left of it at the board under load.
    """

    power: bool
    mode: Mode
    jumpers: DemoJumpers
    leds: DemoLeds
    safe_start: bool
    override: bool
    serial_controls: bool
    required: int
    special_start: str
    channels: tuple[DemoChannel, ...]
    motors: tuple[DemoMotor, ...]
    line: DemoLine
    battery: float
    supply: float

    @property
    def source(self) -> InputSource:
        """How the inputs are measured."""
        return self.mode.source

    @property
    def mode_jumper_in_force(self) -> str:
        """The mode jumper that was read at the last power-up."""
        return _JUMPERS_OF_MODE.get(self.mode, "serial")


def read_snapshot(text: str) -> DemoSnapshot:
    """Read the JSON of `show`."""
    shown: dict[str, Any] = json.loads(text)
    return DemoSnapshot(
        power=shown["power"],
        mode=Mode(shown["mode"]),
        jumpers=DemoJumpers(**shown["jumpers"]),
        leds=DemoLeds(**shown["leds"]),
        safe_start=shown["safe_start"],
        override=shown["override"],
        serial_controls=shown["serial_controls"],
        required=shown["parameters"]["required_channels"],
        special_start=shown["special_start"] or "",
        channels=tuple(DemoChannel(row["signal"], row["raw"]) for row in shown["channels"]),
        motors=tuple(_motor(row) for row in shown["motors"]),
        line=DemoLine(**shown["line"]),
        battery=float(shown["battery"]),
        supply=float(shown["supply"]),
    )


def _motor(shown: dict[str, Any]) -> DemoMotor:
    return DemoMotor(**{field.name: shown[field.name] for field in fields(DemoMotor)})


def signal_text(value: float, source: InputSource) -> str:
    """Return µs or V in the words of the control line `channel`."""
    return f"{value:.0f}us" if source is InputSource.RC else f"{value:.2f}V"
