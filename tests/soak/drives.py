"""Drives in virtual time on a noisy line.

    python -m tests.soak.drives [DRIVES]    prints the time in which motors turned against commands

The soak test also counts unrequested stops.
"""

import random
import sys
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from operator import itemgetter

from tests.devices.trex.session.helpers import create_harness, of_type, run_for
from tests.support.virtual import SessionHarness
from trex_gui.core.transport.serial_port import latency_of
from trex_gui.devices.trex.driving.requests import Arm, Heartbeat, MotorsStopped, SetMotor
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.devices.trex.simulator.motors import MotorDirection

BEGIN = 3.0
"""Seconds from the start of the line to arming."""

LONGEST_TURN = 0.06
"""Seconds for which a motor may turn against its commands, at 19200 baud."""

_SETTLED = BEGIN + 0.2  # end of the first motion
_SPEEDS = (38, -38, 80, -80, 0)


@dataclass
class DriveResult:
    """Result of a drive at changing speeds."""

    turned: list[float] = field(default_factory=list)  # seconds of each wrong turn
    stopped: list[MotorsStopped] = field(default_factory=list)  # unrequested stops


def drive(
    seed: int, seconds: float, *, noise: float = 0.01, baud: int = 19200, shutdown: bool = False
) -> DriveResult:
    """Drive both motors on a line that corrupts bytes. `shutdown`: errors stop the board."""
    harness, settings = create_harness(baud)
    harness.board.eeprom.write("uart_error_shutdown", int(shutdown))
    harness.board.power_cycle()
    harness.transport.latency = latency_of("/dev/ttyUSB0")
    harness.line.faults._random.seed(seed)
    result = DriveResult()
    record_setpoint = _record_wrong_turns(harness, result.turned)
    generator = random.Random(seed)
    steps: list[tuple[float, Arm | Heartbeat | SetMotor | Callable[[], object]]] = [
        (0.9, lambda: setattr(harness.line.faults, "noise", noise)),
        (BEGIN, Arm()),
    ]
    moment = BEGIN
    while moment < BEGIN + seconds:
        motor, speed = generator.choice((1, 2)), generator.choice(_SPEEDS)
        setpoint = SetMotor(motor, Drive.at(speed) if speed else Drive.brake())
        steps += [(moment, lambda setpoint=setpoint: record_setpoint(setpoint)), (moment, setpoint)]  # type: ignore[misc]
        moment += generator.uniform(0.3, 2.0)
    steps += [(BEGIN + beat * 0.1, Heartbeat()) for beat in range(round(seconds * 10))]
    for at, step in sorted(steps, key=itemgetter(0)):
        harness.script.at(at, step)
    reports = run_for(harness, BEGIN + seconds, settings)
    result.stopped = of_type(reports, MotorsStopped)
    return result


def _record_wrong_turns(harness: SessionHarness, turned: list[float]) -> Callable[[SetMotor], None]:
    """Record the time in which motors follow neither of the two newest setpoints."""
    control = harness.board.serial
    execute, shut_down = control.drive, control._shut_down
    newest: dict[int, list[int]] = {1: [0, 0], 2: [0, 0]}
    since: dict[int, float] = {}

    def end(number: int) -> None:
        start = since.pop(number, harness.line.now)
        if harness.line.now > start >= _SETTLED:
            turned.append(harness.line.now - start)

    def record_drive(
        number: int, direction: MotorDirection, speed: int, *, accelerate: bool = False
    ) -> None:
        sign = {MotorDirection.FORWARD: 1, MotorDirection.REVERSE: -1}.get(direction, 0)
        if sign and sign * speed not in newest[number][-2:]:
            since.setdefault(number, harness.line.now)
        else:
            end(number)
        execute(number, direction, speed, accelerate=accelerate)

    def record_shutdown() -> None:
        end(1)
        end(2)
        shut_down()

    control.drive = record_drive  # type: ignore[method-assign]
    control._shut_down = record_shutdown  # type: ignore[method-assign]
    return lambda setpoint: newest[setpoint.motor].append(setpoint.drive.signed)


def run(seconds: float, seed: int) -> list[str]:
    """Repeat drives of one virtual minute. Return false stops and long wrong turns."""
    end = time.monotonic() + seconds
    failures: list[str] = []
    minutes = 0
    while time.monotonic() < end:
        result = drive(seed + minutes, 60.0)
        minutes += 1
        failures += [f"minute {minutes}: {report}" for report in result.stopped]
        long_turns = [turn for turn in result.turned if turn > LONGEST_TURN]
        failures += [f"minute {minutes}: {turn:.3f} s" for turn in long_turns]
        print(f"{minutes} minutes driven, {len(failures)} failed", flush=True)
    return failures


def main(drives: int) -> None:
    for shutdown in (False, True):
        results = [drive(seed, 10.0, shutdown=shutdown) for seed in range(drives)]
        turned = sorted(1000 * turn for result in results for turn in result.turned)
        median, high = (turned[int(len(turned) * part)] for part in (0.5, 0.99))
        print(
            f"{drives} drives of 10 s at 19200 baud, 1 % noise, UART-Error Shutdown {shutdown}: "
            f"{len(turned)} wrong turns, {sum(turned):.0f} ms in all, median {median:.0f} ms, "
            f"99 % {high:.0f} ms, longest {turned[-1]:.0f} ms"
        )


if __name__ == "__main__":
    main(int(sys.argv[1]) if sys.argv[1:] else 30)
