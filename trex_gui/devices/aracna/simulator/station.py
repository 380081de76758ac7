"""The board in time: its program, its power, and its UART, which is read only now and then."""

from collections.abc import Callable
from functools import partial
from typing import Protocol

from trex_gui.devices.aracna.simulator.firmware import (
    Firmware,
    Pause,
    Program,
    Receive,
    State,
    Transmit,
)
from trex_gui.devices.aracna.simulator.uart import Holding


class Surroundings(Protocol):
    """What the board needs of the wire it hangs on."""

    @property
    def now(self) -> float:
        """Seconds since the wire was made."""

    @property
    def byte_time(self) -> float:
        """Seconds that a byte of the board takes."""

    def at(self, moment: float, action: Callable[[], None]) -> None:
        """Do something at a moment that is not over."""

    def carry(self, byte: int, is_whole: Callable[[], bool]) -> None:
        """Let a byte to the host begin now; it arrives if `is_whole` at its end."""


class RobotOnWire:
    """One board with its firmware.

    Polled, without interrupt or buffer: only while the program waits for a byte does it read
    one; else three are held.

    Attributes:
        firmware: its program and what that remembers.
        holding: bytes that have come while the program was busy.
        powered: whether the board has power.
    """

    def __init__(
        self, firmware: Firmware, surroundings: Surroundings, *, keeps_last: bool = True
    ) -> None:
        self.firmware = firmware
        self.holding = Holding(keeps_last=keeps_last)
        self.powered = False
        self._around = surroundings
        self._program: Program | None = None
        self._waits = False

    def power_on(self) -> None:
        """Let the firmware start, if the board had no power."""
        if not self.powered:
            self.powered = True
            self._start()

    def power_off(self) -> None:
        """Take its power: what it was doing is over in mid-byte."""
        self.powered = False
        self._program = None
        self._waits = False
        self.holding.clear()
        self.firmware.state = State.OFF
        self.firmware.led = False

    def reset(self) -> None:
        """Pull the reset line of a board that has power; the servos do not notice."""
        self.power_off()
        self.power_on()

    def hear(self, byte: int) -> None:
        """Take a byte that has come."""
        if not self.powered:
            return
        self.holding.put(byte)
        if self._waits:
            self._go_on(self.holding.take())

    def _start(self) -> None:
        self._program = self.firmware.program()
        self._do(next(self._program))

    def _go_on(self, byte: int = 0) -> None:
        """Let the program run on, and see to what it waits for next."""
        self._waits = False
        if self._program is not None:
            self._do(self._program.send(byte))

    def _do(self, wish: Pause | Transmit | Receive) -> None:
        now = self._around.now
        match wish:
            case Pause(seconds):
                self._around.at(now + seconds, self._if_still_running(self._go_on))
            case Transmit(byte):
                self._around.carry(byte, self._still_runs())
                end = now + self._around.byte_time
                self._around.at(end, self._if_still_running(self._go_on))
            case Receive() if self.holding:
                self._around.at(now, self._if_still_running(self._take_held))
            case Receive():
                self._waits = True

    def _take_held(self) -> None:
        self._go_on(self.holding.take())

    def _still_runs(self) -> Callable[[], bool]:
        """Return whether the board will not have been reset since now."""
        return partial(self._runs, self._program)

    def _runs(self, program: Program | None) -> bool:
        return self._program is program

    def _if_still_running(self, action: Callable[[], None]) -> Callable[[], None]:
        runs = self._still_runs()

        def act() -> None:
            if runs():
                action()

        return act
