"""Simulated Aracna in virtual time."""

from typing import Any

from tests.support.transport import SimulatedTransport
from trex_gui.devices.aracna.simulator.control import control
from trex_gui.devices.aracna.simulator.line import AracnaLine

BOOT = 1.1
"""Seconds after which a switched-on board listens."""


class AracnaHarness:
    """Robot and its wire in virtual time.

    `options` are `AracnaLine`'s: `motors`, `positions`, `boot_loader` …
    `stage.line.servos[3].alive = False` and `stage.do("servo 3 dead")` do the same.
    """

    def __init__(
        self,
        *,
        booted: bool = True,
        keeps_last: bool = True,
        reports_motors: bool = True,
        **options: Any,
    ) -> None:
        self.line = AracnaLine(**options)
        self.line.station.keeps_last = keeps_last
        self.line.station.firmware.reports_motors = reports_motors
        self.transport = SimulatedTransport(self.line)
        if booted:
            self.line.advance(BOOT + options.get("boot_loader", 0.0))
            self.line.receive()

    @property
    def now(self) -> float:
        """Virtual seconds since the robot was switched on."""
        return self.line.now

    @property
    def positions(self) -> tuple[int, ...]:
        """Positions of the servos."""
        return tuple(round(servo.position) for servo in self.line.servos)

    @property
    def goals(self) -> tuple[int, ...]:
        """Last accepted goals of the servos."""
        return tuple(servo.goal for servo in self.line.servos)

    @property
    def speeds(self) -> tuple[int, ...]:
        """Speeds that the servos hold."""
        return tuple(servo.speed for servo in self.line.servos)

    def do(self, *lines: str) -> str:
        """Execute control lines. Return the text after the last `ok`."""
        answer = ""
        for line in lines:
            answer = control(self.line, line)
            assert answer.startswith("ok"), f"{line}: {answer}"
        return answer.removeprefix("ok").strip()

    def request(self, line: bytes, seconds: float = 5.0) -> bytes:
        """Send bytes, let time pass, and return the received bytes."""
        self.line.send(line)
        self.line.advance(seconds)
        return self.line.receive()
