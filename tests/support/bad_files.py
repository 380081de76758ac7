"""Invalid settings files of every kind, and the expected messages."""

from dataclasses import dataclass

_HEADER = b"product: TReX\nfirmware: 1.2\n"


@dataclass(frozen=True, slots=True)
class BadFile:
    """A file with an error.

    Attributes:
        line: line of the error, or `None` if the whole file is wrong.
        words: part of the expected message.
        is_text: whether the program shows the file. Other files are only rejected with a message.
    """

    name: str
    data: bytes
    line: int | None
    words: str
    is_text: bool = True


_BOMB = b"product: TReX\na: &a [x, x]\n" + b"".join(
    b"%c: &%c [*%c, *%c]\n" % (98 + n, 98 + n, 97 + n, 97 + n) for n in range(20)
)

BAD_FILES = (
    BadFile("unknown", _HEADER + b"serial_timeot: 5\n", 3, "did you mean serial_timeout"),
    BadFile("duplicate", _HEADER + b"motor_mode: 0\nmotor_mode: 1\n", 4, "already given in line 3"),
    BadFile("type", _HEADER + b"motor_mode: joint\n", 3, "not joint"),
    BadFile("list", _HEADER + b"motor_mode: [1]\n", 3, "a list"),
    BadFile("range", _HEADER + b"serial_timeout: 500\n", 3, "not 500"),
    BadFile("physical", _HEADER + b"serial_timeout: 1.5 s\n", 3, "write 15 for 1.5 s"),
    BadFile("order",
            _HEADER + b"rc_channel_1: {minimum: 9, neutral: 3, maximum: 20, deadband: 0}\n",
            3, "above neutral"),
    BadFile("cut", _HEADER + b"rc_channel_1: {minimum: 2500, neu", 3, "is incomplete"),
    BadFile("newer", b"product: TReX\nfirmware: 1.0\nuart_response_delay: 1\n", 3, "from firmware"),
    BadFile("other product", b"product: T825\ncontrol_mode: serial\n", 1, "not settings of a TReX"),
    BadFile("bomb", _BOMB, 2, "anchors"),
    BadFile("deep", _HEADER + b"motor_mode: {a: {b: {c: 1}}}\n", 3, "nested too deeply"),
    BadFile("many", _HEADER + b"x: [" + b"1," * 3000 + b"]\n", 3, "more settings here"),
    BadFile("tag", _HEADER + b"motor_mode: !!python/object:os.system 1\n", 3, "tags"),
    BadFile("latin", _HEADER + b"# f\xfcr den Rover\nmotor_mode: 0\n", 3, "not UTF-8"),
    BadFile("empty", b"", 1, "no settings here"),
    BadFile("prose", b"Dear diary, today I drove.\n", 1, "not settings of"),
    BadFile("binary", b"\x7fELF\x02\x01\x00\x00" * 40, 1, "binary file", is_text=False),
    BadFile("no mark", "product: TReX".encode("utf-16-le"), 1, "UTF-16 text", is_text=False),
    BadFile("noise", bytes(range(1, 256)) * 4, 4, "not UTF-8", is_text=False),
    BadFile("huge", _HEADER + b"#" * (1024 * 1024 + 1), None, "larger than", is_text=False),
)  # fmt: skip
