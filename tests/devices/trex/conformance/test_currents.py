"""Motor currents: each sentence of CMD10 0x8D to 0x8F."""

import pytest

from tests.devices.trex.conformance.trex import Trex

SOURCES = [pytest.param(0, 0.0125, id="RC"), pytest.param(1, 0.020, id="analog")]
"""Channel input source, and its interval between two measurements in seconds."""


def set_currents(trex: Trex, first: float, second: float) -> None:
    """Set both currents in A, and wait until the board has measured them."""
    trex.control(f"current 1 {first}")
    trex.control(f"current 2 {second}")
    trex.wait(0.021)


@pytest.mark.parametrize(("query", "motor"), [("8D", 1), ("8E", 2)])
def test_motor_current_is_in_units_of_150_ma(trex: Trex, query: str, motor: int) -> None:
    """CMD10 0x8D, 0x8E: a value of 55 is roughly 8.25 A."""
    set_currents(trex, *((8.25, 0.75) if motor == 1 else (0.75, 8.25)))
    assert trex.request_byte(query) == 55


def test_motor_current_ranges_from_0_to_255(trex: Trex) -> None:
    """CMD10 0x8D, 0x8E."""
    set_currents(trex, 0, 60)
    assert (trex.request("8D"), trex.request("8E")) == ("00", "FF")
    set_currents(trex, 38.25, 0)
    assert (trex.request("8D"), trex.request("8E")) == ("FF", "00")


def test_running_motor_draws_current_of_its_load(trex: Trex) -> None:
    """CMD10 0x8D: "the approximate current drawn by the motor"."""
    trex.control("load 1 6")
    trex.send("C2 7F")
    trex.wait(0.3)
    assert trex.request_byte("8D") == pytest.approx(6 / 0.150, abs=4)
    assert trex.request_byte("8E") == 0


def test_current_reads_0_in_joint_motor_mode(trex: Trex) -> None:
    """CMD10 0x8D. Inferred: it reads 0 then."""
    trex.set_parameters(motor_mode=1)
    trex.control("load 1 6")
    set_currents(trex, 8.25, 8.25)
    trex.send("C2 7F")
    trex.wait(0.03)
    assert [trex.request(query) for query in ("8D", "8E", "8F")] == ["00", "00", "00 00"]


@pytest.mark.parametrize(("source", "period"), SOURCES)
def test_current_is_updated_at_rate_of_input_source(trex: Trex, source: int, period: float) -> None:
    """CMD10 0x8D. Readings differ while the motors accelerate."""
    trex.control("load 1 10")
    trex.control("load 2 10")
    trex.set_parameters(channel_input_source=source, motor1_acceleration=40, motor2_acceleration=40)
    trex.send("EA 7F 7F")
    trex.wait(0.03)
    begin = trex.now()
    readings = [trex.request("8F")]
    while trex.now() < begin + 0.1:
        trex.wait(0.002)
        if (reading := trex.request("8F")) != readings[-1]:
            readings.append(reading)
    updates = (trex.now() - begin) / period
    assert updates <= len(readings) <= updates + 2  # the first reading is before the first update


def test_both_currents_are_sent_motor_1_first(trex: Trex) -> None:
    """CMD10 0x8F."""
    set_currents(trex, 1.5, 15)
    assert trex.exchange("8F")[:2] == bytes([10, 100])
    assert trex.request("8F") == "0A 64"
