"""Boot modes that jumpers select: learning mode and boot loader.

Ref: Pololu TReX manual pages 10-11; forum threads 1769 (boot loader) and 4631 (recovery).
"""

from collections import deque
from collections.abc import Sequence
from enum import Enum
from typing import Protocol

from trex_gui.devices.trex.protocol.calibration import DEFAULT_CALIBRATION, Calibration
from trex_gui.devices.trex.protocol.flags import CHANNELS, InputSource, Mode
from trex_gui.devices.trex.simulator.channels import Channels
from trex_gui.devices.trex.simulator.memory import Memory

_NEUTRALS_S = 2.0  # seconds for measuring the neutral positions
_SETTLING_S = 0.1  # seconds until each channel has a pulse, inferred
_EXTREMES_S = 10.0  # seconds for measuring the extremes
_HOLD_UPDATES = 50  # updates (0.5 s) for which an extreme must be held
_FLASH_S = 0.4  # seconds for which the LEDs show each channel's result, inferred
# Maximum range of a steady channel in counts, inferred
_STEADY_RANGE = {InputSource.RC: 100, InputSource.ANALOG: 40}


class BootHost(Protocol):
    mix: bool
    so_ground: bool
    mode: Mode
    channels: Channels
    memory: Memory


class BootLoader:
    """Boot loader. It restores the default serial settings (inferred), then waits for firmware.

    `leds` contains the patterns of the red and green LEDs. `update` is called 100 times a second.
    """

    is_over = False

    def __init__(self, board: BootHost) -> None:
        self._board = board
        self._confirmed = False
        self._ready = False

    @property
    def name(self) -> str:
        return "boot loader: ready" if self._ready else "boot loader: requested"

    @property
    def leds(self) -> tuple[str, str]:
        if self._ready:
            return "off", "short flash 1/s"
        return ("alternate 4/s",) * 2 if self._confirmed else ("alternate 1/s",) * 2

    def update(self, seconds: float) -> None:  # noqa: ARG002 - waits for jumpers, not for time
        if self._ready:
            return
        if not self._confirmed:
            self._confirmed = not self._board.mix
        elif not self._board.so_ground:
            self._ready = True
            self._board.memory.restore_line_settings()

    def reply(self, byte: int) -> bytes:
        """Reply to a byte that is not firmware (forum thread 5011).

        The reply is the byte and a question mark. Inferred: the reply is sent at the active baud
        rate, and the boot loader accepts no byte as firmware.
        """
        return bytes([byte]) + b"?" if self._ready else b""


class _Step(Enum):
    READY = "learning: ready"
    WAITING = "learning: waiting for a signal"
    NEUTRALS = "learning: neutrals"
    NEUTRALS_SHOWN = "learning: neutrals learned"
    EXTREMES = "learning: extremes"
    DONE = "learning: done"


_LEDS = {
    _Step.READY: ("blink 1/s", "blink 1/s"),
    _Step.WAITING: ("blink 4/s", "blink 4/s"),
    _Step.NEUTRALS: ("on", "off"),
    _Step.EXTREMES: ("on", "on"),
}


class LearningMode:
    """Learning mode. It measures the neutral position and the extremes of each channel.

    When `is_over` is true, normal operation starts without a power cycle. Inferred: the maximum
    range of a steady channel, and the deadband (the larger of the default and the noise). Also
    inferred: a channel that fails retains its calibration.
    """

    def __init__(self, board: BootHost) -> None:
        self.is_over = False
        self._board = board
        self._step = _Step.READY
        self._time = 0.0
        self._measurements = {channel: _Measurement() for channel in CHANNELS}
        self._learned: set[int] = set()

    @property
    def name(self) -> str:
        return self._step.value

    @property
    def leds(self) -> tuple[str, str]:
        if self._step in _LEDS:
            return _LEDS[self._step]
        channel = 1 + int(self._time / _FLASH_S) % len(CHANNELS)
        if self._time % _FLASH_S > _FLASH_S / 2:
            return "off", "off"
        return ("off", "on") if channel in self._learned else ("on", "off")

    def update(self, seconds: float) -> None:
        raw = self._board.channels.raw
        self._time += seconds
        match self._step:
            case _Step.READY if not self._board.mix:
                self._start(_Step.WAITING)
            case _Step.WAITING:
                self._wait(raw)
            case _Step.NEUTRALS:
                if self._time > _SETTLING_S:
                    self._measure(raw)
                if self._time >= _NEUTRALS_S:
                    self._learn_neutrals()
            case _Step.NEUTRALS_SHOWN:
                if self._time >= _FLASH_S * len(CHANNELS):
                    self._start(_Step.EXTREMES if self._learned else _Step.DONE)
            case _Step.EXTREMES:
                self._measure(raw)
                if self._time >= _EXTREMES_S:
                    self._learn_extremes()

    def reply(self, byte: int) -> bytes:  # noqa: ARG002 - inferred: no reply
        return b""

    def _start(self, step: _Step) -> None:
        self._step = step
        self._time = 0.0

    def _wait(self, raw: Sequence[int | None]) -> None:
        if not self._board.so_ground:
            self.is_over = True
        elif self._board.mode is Mode.ANALOG or any(value is not None for value in raw):
            self._start(_Step.NEUTRALS)

    def _measure(self, raw: Sequence[int | None]) -> None:
        for channel, value in zip(CHANNELS, raw, strict=True):
            self._measurements[channel].update(value)

    def _learn_neutrals(self) -> None:
        limit = _STEADY_RANGE[self._board.mode.source]
        self._learned = {
            channel
            for channel, measurement in self._measurements.items()
            if measurement.learn_neutral(limit)
        }
        self._start(_Step.NEUTRALS_SHOWN)

    def _learn_extremes(self) -> None:
        source = self._board.mode.source
        for channel in sorted(self._learned):
            deadband = DEFAULT_CALIBRATION[source].deadband
            calibration = self._measurements[channel].calibration(deadband)
            if calibration is None:
                self._learned.discard(channel)
            else:
                self._board.memory.store_calibration(source, channel, calibration)
        self._start(_Step.DONE)


class _Measurement:
    def __init__(self) -> None:
        self._values: list[int] = []
        self._is_bad = False
        self._neutral = 0
        self._noise = 0
        self._recent: deque[int] = deque(maxlen=_HOLD_UPDATES)
        self._lows: list[int] = []  # maximum of the recent values, at each update
        self._highs: list[int] = []  # minimum of the recent values, at each update

    def update(self, value: int | None) -> None:
        if value is None:
            self._is_bad = True
            return
        self._values.append(value)
        self._recent.append(value)
        if len(self._recent) == _HOLD_UPDATES:
            self._lows.append(max(self._recent))
            self._highs.append(min(self._recent))

    def learn_neutral(self, limit: int) -> bool:
        if self._is_bad or not self._values:
            return False
        self._noise = max(self._values) - min(self._values)
        self._neutral = round(sum(self._values) / len(self._values))
        self._values.clear()
        return self._noise <= limit

    def calibration(self, deadband: int) -> Calibration | None:
        if self._is_bad or not self._lows:
            return None
        lowest = min(self._neutral, *self._lows)
        highest = max(self._neutral, *self._highs)
        deadband = max(deadband, self._noise)
        if highest - lowest <= 2 * deadband:
            return None
        return Calibration(lowest, self._neutral, highest, deadband)


BootMode = BootLoader | LearningMode


def boot_mode(board: BootHost) -> BootMode | None:
    if not (board.mix and board.so_ground):
        return None
    return BootLoader(board) if board.mode.is_serial else LearningMode(board)
