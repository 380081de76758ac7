"""Acceleration: each sentence of CMD10 0xC4 - 0xC7 and 0xCC - 0xCF.

Speeds are compared with the fewest and the most possible updates.
"""

import pytest

from tests.devices.trex.conformance.trex import Trex

MOTORS = [
    pytest.param(1, "C2", "C6", "C5", id="motor 1"),
    pytest.param(2, "CA", "CE", "CD", id="motor 2"),
]
"""Motor, and its commands to set forward, accelerate forward and accelerate in reverse."""


@pytest.mark.parametrize(("motor", "set_", "forward", "_reverse"), MOTORS)
@pytest.mark.parametrize("acceleration", [25, 127])
def test_update_adds_a_tenth_of_acceleration_100_times_a_second(
    trex: Trex, motor: int, set_: str, forward: str, _reverse: str, acceleration: int
) -> None:
    """CMD10 0xC4: motor speed = motor speed + acceleration/10."""
    trex.set_parameters(**{f"motor{motor}_acceleration": acceleration})
    trex.send(f"{set_} 0A")
    trex.send(f"{forward} 7F")
    for state in trex.watch(0.1):
        speed = state["motors"][motor - 1]["speed"]
        assert speed >= min(127, 10 + int(trex.fewest_updates * acceleration / 10))
        assert speed <= min(127, 10 + trex.most_updates * acceleration / 10)


def test_acceleration_ends_at_target_speed(trex: Trex) -> None:
    """CMD10 0xC4: if motor speed > target speed, motor speed = target speed."""
    trex.set_parameters(motor1_acceleration=100)
    trex.send("C6 23")
    trex.wait(0.06)
    assert trex.motor(1) == ("forward", 0x23)
    trex.wait(0.03)
    assert trex.motor(1) == ("forward", 0x23)


def test_update_sets_lower_target_speed_at_once(trex: Trex) -> None:
    """CMD10 0xC4: "there is no deceleration"."""
    trex.set_parameters(motor1_acceleration=1)
    trex.send("C2 7F")
    trex.send("C6 20")
    trex.wait(0.012)
    assert trex.motor(1) == ("forward", 0x20)


@pytest.mark.parametrize(("motor", "set_", "forward", "reverse"), MOTORS)
def test_reversal_brakes_fully_for_brake_duration(
    trex: Trex, motor: int, set_: str, forward: str, reverse: str
) -> None:
    """CMD10 0xC4: "brake the motor at 100% duty cycle". The unit is 10 ms (forum thread 624)."""
    trex.set_parameters(**{f"motor{motor}_brake_duration": 8})
    trex.send(f"{set_} 40")
    trex.send(f"{reverse} 30")
    seen = set()
    for state in trex.watch(0.13):
        output = state["motors"][motor - 1]["direction"], state["motors"][motor - 1]["speed"]
        if trex.fewest_updates >= 1 and trex.most_updates <= 8:
            assert output == ("brake", 127)
        elif trex.fewest_updates >= 10:
            assert output == ("reverse", 0x30)
        else:
            assert output in {("forward", 0x40), ("brake", 127), ("reverse", 0x30)}
        seen.add(output)
    assert ("brake", 127) in seen
    assert output == ("reverse", 0x30)


def test_motor_accelerates_from_zero_after_reversal_brake(trex: Trex) -> None:
    """CMD10 0xC4: "set the motor speed to zero and accelerate from there"."""
    trex.set_parameters(motor1_acceleration=20, motor1_brake_duration=3)
    trex.send("C2 7F")
    trex.send("C5 7F")
    for state in trex.watch(0.12):
        motor = state["motors"][0]
        if motor["direction"] == "reverse":
            assert min(127, 2 * (trex.fewest_updates - 4)) <= motor["speed"]
            assert motor["speed"] <= 2 * max(1, trex.most_updates - 3 + 1)
    assert motor["direction"] == "reverse"


def test_reversal_without_brake_duration_starts_at_zero(trex: Trex) -> None:
    """CMD10 0xC4: "for the amount of time specified by its brake duration parameter"."""
    trex.set_parameters(motor1_acceleration=10, motor1_brake_duration=0)
    trex.send("C2 7F")
    trex.send("C5 7F")
    trex.wait(0.025)
    direction, speed = trex.motor(1)
    assert direction == "reverse"
    assert min(127, trex.fewest_updates - 1) <= speed <= trex.most_updates


def test_set_commands_override_current_limit_temporarily(trex: Trex) -> None:
    """CMD10 0xC4: "set the motor speed the instant they're received".

    The "fixed update cycle" of accelerate commands "also takes care of the current-limiting logic".
    """
    trex.set_parameters(motor1_current_limit=10, motor1_current_limit_p=1)
    trex.control("current 1 6")
    trex.send("C6 7F")
    trex.wait(0.15)
    limited = trex.motor(1)[1]
    assert trex.request_byte("84") & 0x20
    trex.send("C2 7F")
    assert trex.motor(1)[1] > limited
    trex.wait(0.1)
    assert trex.motor(1)[1] < 127


@pytest.mark.parametrize("brake", ["C4", "C7"])
def test_acceleration_does_not_apply_to_braking(trex: Trex, brake: str) -> None:
    """The note at CMD10 0xC4 says this."""
    trex.set_parameters(motor1_acceleration=1, motor1_brake_duration=20)
    trex.send("C2 40")
    trex.send(f"{brake} 7F")
    trex.wait(0.012)
    assert trex.motor(1) == ("brake", 127)
    trex.send(f"{brake} 20")
    trex.wait(0.012)
    assert trex.motor(1) == ("brake", 0x20)


def test_accelerate_both_handles_each_motor_independently(trex: Trex) -> None:
    """CMD10 0xE0: each motor has its own target direction and its own acceleration."""
    trex.set_parameters(motor1_acceleration=20, motor2_acceleration=10)
    trex.send("E6 40 40")
    trex.wait(0.03)
    for motor, direction, step in ((1, "forward", 2), (2, "reverse", 1)):
        found, speed = trex.motor(motor)
        assert found == direction
        assert step * trex.fewest_updates <= speed <= step * trex.most_updates < 0x40
