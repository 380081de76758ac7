"""Reply to `.c`, compared with documented travel times."""

import pytest

from tests.support.aracna import AracnaHarness

UNITS_PER_SECOND = 2.28
"""Position units per second for each unit of speed (0.1114 rpm)."""

MAX_EFFECTIVE_SPEED = 870
BUS = 0.02
"""Seconds that packets to eight servos, polls and bytes may add to a travel time."""


def line(letter: str, values: list[int]) -> bytes:
    return f".{letter}{','.join(map(str, values))}\n".encode()


def arrival_times(harness: AracnaHarness, goals: list[int]) -> tuple[list[float], bytes]:
    """Send goals. Return the time at which each motor's value was complete, and the reply."""
    request = line("c", goals)
    harness.line.send(request)
    start = harness.now + len(request) * harness.line.byte_time
    reply, times = b"", []
    while not reply.endswith(b"\n") and harness.now < start + 60:
        reply += harness.line.read(1, 1)
        if reply[-1:] in {b",", b"\r"}:
            times.append(harness.now - start)
    return times, reply


def test_reply_gives_each_value_once_motor_has_arrived() -> None:
    goals = [600, 550, 900, 512, 100, 700, 20, 1023]
    speeds = [100, 50, 200, 10, 150, 100, 300, 400]
    harness = AracnaHarness()
    harness.request(line("v", speeds))
    times, reply = arrival_times(harness, goals)

    travels = [
        abs(goal - 512) / (UNITS_PER_SECOND * speed)
        for goal, speed in zip(goals, speeds, strict=True)
    ]
    assert reply == line("c", goals).replace(b"\n", b"\r\n")
    assert len(times) == 8
    for motor, time in enumerate(times):
        slowest = max(travels[: motor + 1])
        assert slowest <= time <= slowest + BUS, f"motor {motor}"


@pytest.mark.parametrize(
    ("speed", "start", "seconds"),
    [
        (1023, 0, 1023 / (UNITS_PER_SECOND * MAX_EFFECTIVE_SPEED)),
        (0, 0, 1023 / (UNITS_PER_SECOND * MAX_EFFECTIVE_SPEED)),
        (870, 0, 1023 / (UNITS_PER_SECOND * MAX_EFFECTIVE_SPEED)),
        (530, 0, 0.85),  # top speed of an AX-12A
        (100, 0, 4.5),
        (1, 1000, 450 * 23 / 1023),  # the full travel takes 450 s
    ],
)
def test_travel_takes_documented_time(speed: int, start: int, seconds: float) -> None:
    harness = AracnaHarness(positions=[start] * 8)
    harness.request(line("v", [speed] * 8))
    times, _ = arrival_times(harness, [1023] * 8)
    assert times[-1] == pytest.approx(seconds, rel=0.01, abs=2 * BUS)


@pytest.mark.parametrize(
    ("letter", "value", "minimum", "maximum"),
    [("c", 512, 32.5, 33.5), ("c", 1023, 36.5, 37.5), ("v", 0, 42, 46), ("v", 1000, 52, 56)],
)
def test_round_trip_without_motion_takes_documented_time(
    letter: str, value: int, minimum: float, maximum: float
) -> None:
    harness = AracnaHarness(positions=[value] * 8)
    request = line(letter, [value] * 8)
    start = harness.now
    harness.line.send(request)
    assert harness.line.read(len(request) + 1, 1) == request.replace(b"\n", b"\r\n")
    assert minimum <= (harness.now - start) * 1000 <= maximum


def test_moving_servo_keeps_old_goal_when_new_one_is_rejected() -> None:
    harness = AracnaHarness()
    harness.request(line("v", [50] * 8))
    harness.line.send(line("c", [700] * 8))
    harness.line.advance(0.2)
    harness.do("reset")
    harness.line.advance(1.1)
    harness.line.receive()
    assert harness.request(line("c", [1024] * 8)) == line("c", [700] * 8).replace(b"\n", b"\r\n")


def test_load_slows_servo() -> None:
    harness = AracnaHarness()
    harness.request(line("v", [100] * 8))
    harness.do("servo 2 load 0.5")
    times, _ = arrival_times(harness, [740] * 8)
    assert times[1] == pytest.approx(1, abs=BUS)
    assert times[2] == pytest.approx(2, abs=BUS)
