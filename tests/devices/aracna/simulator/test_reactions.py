"""Reactions of the firmware to a line, as in the tables of the protocol document.

Eight servos are at 300 and have the highest speed. A row contains a name, the sent bytes and the
expected reply.
"""

import pytest

from tests.support.aracna import AracnaHarness

HELLO = b".h\r\n"
SILENCE = b""
VERSION = b".q1,8\r\n"
START = 300
REJECTED = START


def values(first: object, rest: object = START) -> str:
    return ",".join(map(str, [first, *[rest] * 7]))


def row_of(first: int, rest: int) -> tuple[int, ...]:
    return (first, *[rest] * 7)


QUERIES = [
    ("query", b".q\n", VERSION),
    ("query followed by other characters", b".qxyz\n", VERSION),
    ("query with a carriage return", b".q\r\n", VERSION),
    ("query in a query", b".q.q\n", VERSION),
    ("query without its dot", b"xq\n", VERSION),
    ("query of two letters", b"qq\n", VERSION),
    ("query after a blank", b" q\n", VERSION),
    ("query after a byte that is not a character", b"\xffq\n", VERSION),
    ("query after an empty line", b"\n.q\n", VERSION),
    ("two queries without a pause", b".q\n.q\n", VERSION * 2),
    ("query with a capital letter", b".Q\n", SILENCE),
    ("query of one letter", b"q\n", SILENCE),
    ("query after two dots", b"..q\n", SILENCE),
    ("query without a line end", b".q", SILENCE),
    ("query ended by a carriage return alone", b".q\r", SILENCE),
]

SILENT = [
    ("empty line", b"\n", SILENCE),
    ("empty line with a carriage return", b"\r\n", SILENCE),
    ("dot alone", b".\n", SILENCE),
    ("hello from the host", b".h\n", SILENCE),
    ("torque, which is not implemented", b".t1\n", SILENCE),
    ("read pins, which is only planned", b".r\n", SILENCE),
    ("capital C", b".C" + values(500).encode() + b"\n", SILENCE),
    ("a word", b"hello\n", SILENCE),
    ("zero bytes", b"\x00\x00\x00\n", SILENCE),
    ("bytes of a TReX packet", bytes.fromhex("80 07 2f 7b 0a"), SILENCE),
]

LED = [
    ("LED on", b".l1\n", b".l1\r\n"),
    ("LED off", b".l0\n", b".l0\r\n"),
    ("LED queried", b".l\n", b".l0\r\n"),
    ("LED set to an invalid value", b".l2\n", b".l0\r\n"),
    ("LED without its dot", b"xl1\n", b".l1\r\n"),
    ("LED on, then queried", b".l1\n.l\n", b".l1\r\n.l1\r\n"),
]

CUT = [
    ("59 characters with the newline", b".q" + b"x" * 56 + b"\n", VERSION),
    ("59 characters, then the newline", b".q" + b"x" * 57 + b"\n", VERSION),
    ("59 characters without a line end", b".q" + b"x" * 57, VERSION),
    ("58 characters without a line end", b".q" + b"x" * 56, SILENCE),
    ("cut, the rest is a query", b".q" + b"x" * 57 + b"xq\n", VERSION * 2),
    ("cut, the rest is not a query", b".q" + b"x" * 57 + b"qx\n", VERSION),
    ("cut twice", b"x" * 118 + b".q\n", VERSION),
]


@pytest.fixture
def harness() -> AracnaHarness:
    return AracnaHarness(positions=[START] * 8)


@pytest.mark.parametrize(
    ("line", "reply"),
    [pytest.param(line, reply, id=name) for name, line, reply in [*QUERIES, *SILENT, *LED, *CUT]],
)
def test_line_gets_reply_without_changing_servos(
    harness: AracnaHarness, line: bytes, reply: bytes
) -> None:
    assert harness.request(line) == reply
    assert harness.goals == (START,) * 8
    assert harness.speeds == (0,) * 8
    assert not any(servo.torque for servo in harness.line.servos)


RESTARTING = [
    ("positions without values", b".c\n"),
    ("speeds without values", b".v\n"),
    ("positions with seven values", b".c300,300,300,300,300,300,300\n"),
    ("six commas", b".c,,,,,,\n"),
    ("letters without commas", b".cabc\n"),
    ("positions cut before the eighth comma", b".c" + b"0000300," * 8 + b"\n"),
    ("values separated by blanks", b".c300 300 300 300 300 300 300 300\n"),
    ("field of eleven digits", f".c{values('12345678901')}\n".encode()),
    ("speed of eleven zeros", f".v{values('00000000000')}\n".encode()),
    ("field of ten blanks before a number", f".c{values('          5')}\n".encode()),
]


@pytest.mark.parametrize("line", [pytest.param(line, id=name) for name, line in RESTARTING])
def test_too_few_values_or_long_field_restart_firmware(harness: AracnaHarness, line: bytes) -> None:
    assert harness.request(line) == HELLO
    assert harness.goals == (START,) * 8
    assert harness.speeds == (0,) * 8
    assert harness.line.station.firmware.boots == 2
    assert harness.request(b"\n.q\n") == VERSION  # the newline ends the rest of a cut line


FIELDS = [
    ("plain", "520", 520),
    ("zero", "0", 0),
    ("highest value", "1023", 1023),
    ("leading zero", "0520", 520),
    ("empty", "", 10),
    ("one too high", "1024", REJECTED),
    ("five characters, first four used", "00520", 52),
    ("ten characters, first four used", "0520000000", 520),
    ("leading blank", " 520", REJECTED),
    ("plus", "+520", REJECTED),
    ("minus", "-154", REJECTED),
    ("minus zero", "-0", REJECTED),
    ("leading point", ".5", REJECTED),
    ("point", "5.5", REJECTED),
    ("trailing blank", "520 ", 520),
    ("letters", "abc", 49),
    ("hexadecimal", "0x1F", 721),
    ("exponent", "1e3", 633),
]


@pytest.mark.parametrize(
    ("field", "goal"), [pytest.param(field, goal, id=name) for name, field, goal in FIELDS]
)
def test_field_sets_goal_and_speed_or_is_rejected(
    harness: AracnaHarness, field: str, goal: int
) -> None:
    harness.request(f".v{values(START)}\n".encode())
    assert harness.request(f".v{values(field)}\n".encode()) == f".v{values(goal)}\r\n".encode()
    assert harness.speeds == row_of(goal, START)
    harness.request(f".v{values(0, 0)}\n".encode())
    assert harness.request(f".c{values(field)}\n".encode()) == f".c{values(goal)}\r\n".encode()
    assert harness.goals == row_of(goal, START)
    last = harness.request(f".c{values(START)[:-3]}{field}\n".encode())
    assert last == f".c{values(START)[:-3]}{goal}\r\n".encode()


WHOLE = [
    ("nine values", f".c{values(520)},7\n", values(520)),
    ("twelve values", f".c{values(520)},7,7,7,7\n", values(520)),
    ("trailing comma", f".c{values(520)},\n", values(520)),
    ("seven values and a comma", ".c" + "300," * 7 + "\n", "300," * 7 + "10"),
    ("seven commas", ".c,,,,,,,\n", values(10, 10)),
    ("a word after the last value", f".c{values(520)},nonsense\n", values(520)),
    ("carriage return after three digits", f".c{values(300, 520)}\r\n", values(300, 520)),
    ("carriage return after four digits", f".c{values(300, 1023)}\r\n", values(300, 1023)),
    ("no dot", f"xc{values(520)}\n", values(520)),
    ("twenty values, cut at 59", ".c" + ",".join(["520"] * 20) + "\n", values(520, 520)),
]


@pytest.mark.parametrize(
    ("line", "reply"), [pytest.param(line, reply, id=name) for name, line, reply in WHOLE]
)
def test_only_first_eight_values_count(harness: AracnaHarness, line: str, reply: str) -> None:
    assert harness.request(line.encode()) == f".c{reply}\r\n".encode()
    assert harness.goals == tuple(map(int, reply.split(",")))
    assert harness.line.station.firmware.boots == 1


def test_first_accepted_goal_enables_torque(harness: AracnaHarness) -> None:
    harness.request(f".v{values(100)}\n".encode())
    assert not harness.line.servos[0].torque
    harness.request(f".c{values(1024)}\n".encode())
    assert [servo.torque for servo in harness.line.servos] == [False] + [True] * 7


TWO_MOTORS = [
    ("query", b".q\n", b".q0,2\r\n"),
    ("two positions", b".c520,300\n", b".c520,300\r\n"),
    ("two speeds", b".v7,1023\n", b".v7,1023\r\n"),
    ("eight positions", b".c520,300,1,2,3,4,5,6\n", b".c520,300\r\n"),
    ("one position", b".c520\n", HELLO),
    ("LED", b".l1\n", b".l1\r\n"),
]


@pytest.mark.parametrize(
    ("line", "reply"), [pytest.param(line, reply, id=name) for name, line, reply in TWO_MOTORS]
)
def test_version_0_has_two_motors(line: bytes, reply: bytes) -> None:
    harness = AracnaHarness(motors=2, positions=[START] * 2)
    assert harness.request(line) == reply


def test_old_builds_omit_motor_count() -> None:
    assert AracnaHarness(motors=2, reports_motors=False).request(b".q\n") == b".q0\r\n"
