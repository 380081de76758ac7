"""Simulated Aracna in virtual time."""

from typing import Any

from tests.support.transport import SimulatedTransport
from trex_gui.devices.aracna.simulator.control import control
from trex_gui.devices.aracna.simulator.line import AracnaLine

BOOT = 1.1
"""Seconds from switching on until the board listens."""


class AracnaHarness:
    """Simulated robot and its wire in virtual time.

    `options` are options of `AracnaLine`: `motors`, `positions`, `boot_loader` …
    `harness.do("servo 3 dead")` has the effect of `harness.line.servos[3].alive = False`.
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
        return tuple(round(servo.position) for servo in self.line.servos)

    @property
    def goals(self) -> tuple[int, ...]:
        """Last accepted goals of the servos."""
        return tuple(servo.goal for servo in self.line.servos)

    @property
    def speeds(self) -> tuple[int, ...]:
        return tuple(servo.speed for servo in self.line.servos)

    def do(self, *controls: str) -> str:
        """Execute control lines. Return the text after the last `ok`."""
        reply = ""
        for text in controls:
            reply = control(self.line, text)
            assert reply.startswith("ok"), f"{text}: {reply}"
        return reply.removeprefix("ok").strip()

    def request(self, data: bytes, seconds: float = 5.0) -> bytes:
        """Send bytes, let time pass, and return the received bytes."""
        self.line.send(data)
        self.line.advance(seconds)
        return self.line.receive()
