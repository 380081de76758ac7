"""Chance has a seed: what one seed gives it gives again, and another gives something else."""

import pytest

from trex_gui.devices.trex.protocol.line_settings import LineSettings
from trex_gui.devices.trex.simulator.control import control
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.line import TrexLine


def heard(
    seed: int,
    lines: tuple[str, ...],
    packet: str,
    mode: str = "serial",
) -> bytes:
    """Ask the same question a hundred times; return all that came."""
    line = TrexLine([Board(mode=mode, seed=seed)], seed=seed)
    for text in lines:
        assert control(line, text).startswith("ok")
    line.advance(0.5)
    result = b""
    for _ in range(100):
        line.send(bytes.fromhex(packet))
        line.advance(0.021)
        result += line.receive()
    return result


@pytest.mark.parametrize(
    ("lines", "packet"),
    [
        (("channel 1 1500us noise 3us",), "86 01"),
        (("channel 1 1500us lost 0.9",), "86 01"),
        (("line noise 0.1",), "81"),
        (("load 1 8", "load 2 8"), "8F"),
    ],
    ids=["noisy pulses", "lost pulses", "a noisy wire", "noisy currents"],
)
def test_same_seed_gives_same_bytes(lines: tuple[str, ...], packet: str) -> None:
    if packet == "8F":
        packet = "DA 7F 7F 8F"
    first = heard(1, lines, packet)
    assert len(set(first)) > 2
    assert heard(1, lines, packet) == first != heard(2, lines, packet)


def test_same_seed_gives_same_voltage_noise() -> None:
    lines = ("channel 3 2.5V noise 50mV",)
    first = heard(1, lines, "86 04", mode="analog")
    assert (
        heard(1, lines, "86 04", mode="analog") == first != heard(2, lines, "86 04", mode="analog")
    )


@pytest.mark.parametrize("host", [LineSettings(stop_bits=2), LineSettings(115200)])
def test_same_seed_gives_same_garbage(host: LineSettings) -> None:
    def garbage(seed: int) -> bytes:
        line = TrexLine([Board()], seed=seed)
        result = b""
        for _ in range(50):
            line.host = None
            line.send(b"\x81")
            line.advance(0.0004)
            line.host = host
            line.advance(0.02)
            result += line.receive()
        return result

    first = garbage(1)
    assert len(first) > 50
    assert garbage(1) == first
    if host.stop_bits == 2:  # sampling knows no chance
        assert garbage(2) != first


def test_motors_of_one_board_have_independent_noise() -> None:
    readings = heard(1, ("load 1 8", "load 2 8"), "DA 7F 7F 8F")
    assert readings[::2] != readings[1::2]
