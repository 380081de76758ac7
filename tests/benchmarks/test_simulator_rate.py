"""The simulator's pace: as fast as it can, and exactly as slow as the wire.

Unpaced it must not be what a test waits for; paced it must be the wire, to the percent.
"""

import time
from pathlib import Path

import pytest
import serial

from tests.support.simulator import StartSimulator
from trex_gui.devices.trex.protocol.line_settings import LineSettings
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.line import TrexLine
from trex_gui.devices.trex.simulator.memory import Eeprom

_TRANSACTIONS = 30_000
_WANTED_RATE = 20_000
_SECONDS = 10.0
_OFF_PACE = 0.02
_TELEMETRY = [("86 1F", 10), ("87 1F", 5), ("8F", 2), ("84", 1)]
_NULL = b"\xff"


def test_unpaced_simulator_reaches_required_rate(capsys: pytest.CaptureFixture[str]) -> None:
    line = TrexLine([Board()], paced=False)
    requests = [(bytes.fromhex(packet), size) for packet, size in _TELEMETRY]
    begun = time.perf_counter()
    for _ in range(_TRANSACTIONS // len(requests)):
        for packet, size in requests:
            line.send(packet)
            assert len(line.read(size, 0)) == size
    rate = _TRANSACTIONS / (time.perf_counter() - begun)
    with capsys.disabled():
        print(f"\nunpaced, in process: {rate:,.0f} transactions/s")
    assert rate >= _WANTED_RATE


@pytest.mark.parametrize("baud", [1200, 19200, 115200])
def test_paced_bytes_take_line_time(
    baud: int,
    start_simulator: StartSimulator,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """Null bytes go out without a pause and come back as echo, each when its stop bit ends."""
    settings = LineSettings(baud)
    eeprom = Eeprom.open(tmp_path / "board.json", "trex")
    eeprom.write("uart_settings", settings.to_wire())
    simulator = start_simulator("--echo", "--eeprom", str(tmp_path / "board.json"))
    size = round(_SECONDS / settings.seconds(1))
    chunk = max(1, round(0.01 / settings.seconds(1)))  # what a port's own buffer would hold
    with serial.Serial(simulator.url, baud, timeout=2) as port:
        begun = time.perf_counter()
        sent = received = 0
        while received < size:
            while sent < size and sent - received < 4 * chunk:
                sent += port.write(_NULL * min(chunk, size - sent)) or 0
            received += len(port.read(port.in_waiting or 1))
        took = time.perf_counter() - begun
    off = took / settings.seconds(size) - 1
    with capsys.disabled():
        print(f"\n{baud} baud: {size} bytes in {took:.3f} s, {off:+.2%} off the wire's time")
    assert abs(off) <= _OFF_PACE
    assert simulator.show()["counters"]["uart_errors"] == 0


@pytest.mark.parametrize("baud", [1200, 19200, 115200])
def test_paced_transactions_take_at_least_line_time(
    baud: int,
    start_simulator: StartSimulator,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """Requests each after the last answer: the wire, and what two processes add to it."""
    settings = LineSettings(baud)
    eeprom = Eeprom.open(tmp_path / "board.json", "trex")
    eeprom.write("uart_settings", settings.to_wire())
    simulator = start_simulator("--eeprom", str(tmp_path / "board.json"))
    requests = [(bytes.fromhex(packet), size) for packet, size in _TELEMETRY]
    wire = count = 0.0
    with serial.Serial(simulator.url, baud, timeout=2) as port:
        begun = time.perf_counter()
        while time.perf_counter() < begun + _SECONDS:
            for packet, size in requests:
                port.write(packet)
                assert len(port.read(size)) == size
                wire += settings.seconds(len(packet) + size)
                count += 1
        took = time.perf_counter() - begun
    extra = (took - wire) / count
    with capsys.disabled():
        print(f"\n{baud} baud: {count / took:.1f} transactions/s, {extra * 1e6:.0f} us each added")
    assert took >= wire  # nothing comes before the wire has carried it
