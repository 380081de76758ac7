"""Motor commands of CMD10: set and accelerate for motor 1, motor 2, both and auxiliary."""

import pytest

from tests.devices.trex.conformance.trex import Trex, only

DIRECTIONS = ("brake", "reverse", "forward", "brake")
"""Direction for each value of the two direction bits. 00 and 11 brake low."""

START = ("C2 11", "CA 12", "F0 13")
"""Commands before each test. No test requests these speeds."""

SET_COMMANDS = {1: 0xC0, 2: 0xC8}
"""First of the four set commands of each motor. Four accelerate commands follow."""


@pytest.mark.parametrize("motor", [1, 2])
def test_set_command_sets_speed_and_direction_of_its_motor(trex: Trex, motor: int) -> None:
    """CMD10 0xC0 - 0xC3, 0xC8 - 0xCB: the direction bits."""
    for bits, direction in enumerate(DIRECTIONS):
        trex.send(*START)
        trex.send(f"{SET_COMMANDS[motor] | bits:02X} 5A")
        expected: list[object] = [("forward", 0x11), ("forward", 0x12), 0x13]
        expected[motor - 1] = direction, 0x5A
        assert trex.outputs() == expected


def test_set_command_sets_speed_to_data_byte(trex: Trex) -> None:
    """CMD10 0xC0 and 0xF0."""
    for data in (0, 1, 2, 63, 64, 126, 127):
        trex.send(f"C2 {data:02X}", f"C9 {data:02X}", f"F0 {data:02X}")
        assert trex.outputs() == [("forward", data), ("reverse", data), data]


def test_set_command_ignores_acceleration_and_brake_duration(trex: Trex) -> None:
    """CMD10 0xC0 and 0xF0: "immediately sets the speed"."""
    trex.set_parameters(
        motor1_acceleration=1, motor2_acceleration=1, aux_acceleration=1,
        motor1_brake_duration=50, motor2_brake_duration=50,
    )  # fmt: skip
    trex.send("D6 7F 7F", "F0 7F")
    assert trex.outputs() == [("forward", 127), ("reverse", 127), 127]
    trex.send("D9 20 30", "F0 40")
    assert trex.outputs() == [("reverse", 0x20), ("forward", 0x30), 0x40]
    trex.wait(0.03)
    assert trex.outputs() == [("reverse", 0x20), ("forward", 0x30), 0x40]


def test_set_both_sets_two_directions_and_two_speeds(trex: Trex) -> None:
    """CMD10 0xD0 - 0xDF: bits 1:0 and byte 1 are for motor 1, bits 3:2 and byte 2 for motor 2."""
    for bits in range(16):
        trex.send(*START)
        trex.send(f"{0xD0 | bits:02X} 21 43")
        first, second = DIRECTIONS[bits & 3], DIRECTIONS[bits >> 2]
        assert trex.outputs() == [(first, 0x21), (second, 0x43), 0x13]


@pytest.mark.parametrize("motor", [1, 2])
def test_accelerate_sets_target_speed_and_direction_of_its_motor(trex: Trex, motor: int) -> None:
    """CMD10 0xC4 - 0xC7, 0xCC - 0xCF: the direction bits."""
    for bits, direction in enumerate(DIRECTIONS):
        trex.send(*START)
        trex.send(f"{SET_COMMANDS[motor] | 0x04 | bits:02X} 5A")
        assert trex.target(motor) == (direction, 0x5A)
        assert trex.target(3 - motor) == ("forward", 0x11 if motor == 2 else 0x12)
        trex.wait(0.012)
        expected: list[object] = [("forward", 0x11), ("forward", 0x12), 0x13]
        expected[motor - 1] = direction, 0x5A
        assert trex.outputs() == expected


def test_accelerate_both_sets_two_target_directions_and_speeds(trex: Trex) -> None:
    """CMD10 0xE0 - 0xEF: as in heading and list. The formula has 0xD0 by mistake."""
    for bits in range(16):
        trex.send(*START)
        trex.send(f"{0xE0 | bits:02X} 21 43")
        first, second = DIRECTIONS[bits & 3], DIRECTIONS[bits >> 2]
        assert (trex.target(1), trex.target(2)) == ((first, 0x21), (second, 0x43))
    trex.wait(0.012)
    assert trex.outputs() == [(first, 0x21), (second, 0x43), 0x13]


@only(harness="parser")  # bytes take no time, so no update is between the commands
def test_accelerate_commands_act_with_next_update(trex: Trex) -> None:
    """CMD10 0xC4: the "fixed update cycle"."""
    for command in (*range(0xC4, 0xC8), *range(0xCC, 0xD0), *range(0xE0, 0xF0), 0xF1):
        trex.send(*START)
        trex.send(f"{command:02X} 5A 5B" if 0xE0 <= command < 0xF0 else f"{command:02X} 5A")
        assert trex.outputs() == [("forward", 0x11), ("forward", 0x12), 0x13], f"{command:02X}"


def test_accelerate_auxiliary_sets_its_target_speed(trex: Trex) -> None:
    """CMD10 0xF1."""
    trex.send(*START)
    trex.send("F1 7F")
    assert trex.show()["aux"]["target_speed"] == 127
    trex.wait(0.012)
    assert trex.outputs() == [("forward", 0x11), ("forward", 0x12), 127]


def test_auxiliary_gains_a_tenth_of_acceleration_every_10_ms(trex: Trex) -> None:
    """CMD10 0xF1: like "accelerate motor 1/accelerate motor 2"."""
    trex.set_parameters(aux_acceleration=20)
    trex.send("F1 7F")
    for state in trex.watch(0.1):
        speed = state["aux"]["speed"]
        assert min(127, 2 * trex.fewest_updates) <= speed <= 2 * trex.most_updates


@pytest.mark.parametrize("accelerate", [False, True], ids=["set", "accelerate"])
def test_commands_before_override_apply_when_override_begins(
    trex: Trex, *, accelerate: bool
) -> None:
    """CMD10, note before 0xC0: "set according to the most recently received"."""
    trex.start("rc")
    if accelerate:
        trex.send("C4 01", "C6 30", "CD 40", "F1 50")
    else:
        trex.send("C0 01", "C2 30", "C9 40", "F0 50")
    assert trex.outputs()[2] == 0
    trex.connect(c5="1000us")
    trex.wait(0.012)
    assert trex.outputs() == [("forward", 0x30), ("reverse", 0x40), 0x50]
