"""Hosts in real time: disconnection, line settings and an unwritable EEPROM file."""

import shutil
import sys
from pathlib import Path
from typing import Any

import pytest
import serial

from tests.devices.trex.simulator.waiting import LONG_TIMEOUT
from tests.support.simulator import StartSimulator

needs_pty = pytest.mark.skipif(sys.platform == "win32", reason="Windows has no pseudo-terminals")

# pyserial's RFC 2217 client uses deprecated functions.
pytestmark = [
    pytest.mark.realtime,
    pytest.mark.filterwarnings("ignore:set(Daemon|Name):DeprecationWarning"),
]


def read_signature(url: str, **settings: Any) -> bytes:
    with serial.serial_for_url(
        url, timeout=LONG_TIMEOUT, **{"baudrate": 19200, **settings}
    ) as port:
        port.write(b"\x81")
        reply: bytes = port.read(7)
        return reply


@needs_pty
def test_reopened_port_discards_bytes_queued_by_slow_host(start_simulator: StartSimulator) -> None:
    simulator = start_simulator()
    with serial.Serial(simulator.url, 50) as port:
        port.write(b"\xff" * 200)  # 40 s of bytes
    assert read_signature(simulator.url) == b"TReX1.2"


@pytest.mark.parametrize("kind", ["--rfc2217", "--tcp"])
def test_bytes_queued_by_disconnected_host_are_discarded(
    start_simulator: StartSimulator, kind: str
) -> None:
    simulator = start_simulator(kind, "127.0.0.1:0")
    with serial.serial_for_url(simulator.url, baudrate=300) as port:
        port.write(b"\xff" * 20_000)
    assert read_signature(simulator.url) == b"TReX1.2"


def test_seven_data_bits_are_rejected(start_simulator: StartSimulator) -> None:
    simulator = start_simulator("--rfc2217", "127.0.0.1:0")
    with pytest.raises((serial.SerialException, ValueError)):
        read_signature(simulator.url, bytesize=serial.SEVENBITS)
    assert read_signature(simulator.url) == b"TReX1.2"


@needs_pty
def test_writes_take_effect_when_eeprom_cannot_be_saved(
    start_simulator: StartSimulator, tmp_path: Path
) -> None:
    folder = tmp_path / "gone"
    folder.mkdir()
    simulator = start_simulator("--eeprom", str(folder / "board.json"))
    shutil.rmtree(folder)
    with serial.Serial(simulator.url, 19200, timeout=LONG_TIMEOUT) as port:
        port.write(bytes.fromhex("AF 07 03 55 2A"))
        assert port.read(1) == b"\0"
        port.write(bytes.fromhex("9F 07"))
        assert port.read(1) == b"\x03"
    with pytest.raises(AssertionError, match="not saved"):
        simulator.do("eeprom serial_timeout 4")
    assert simulator.show()["parameters"]["serial_timeout"] == 4
