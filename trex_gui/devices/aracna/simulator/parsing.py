"""The firmware's parser of values in a line. It does not check for the end of the line.

It reads until it has met a comma or newline for each motor, and collects characters in an array
of four bytes without a bound. Nothing is rejected here; servos ignore invalid values.

The conversion is inferred from known values (an empty field is 10, `abc` 49, `0x1F` 721, `1e3`
633, signs and points give more than 1023): the array starts as four tens, each character stores
its distance from "0" in eight bits, trailing non-digits count as unused, and the result has
sixteen bits.
"""

_ARRAY = 4
_SMASHED = 9
"""Characters in a field that destroy the stack."""

_UNUSED = 10
_SEPARATORS = b",\n"


class Restart(Exception):  # noqa: N818 - an event, not an error
    """The firmware has read past the end of the line and restarts."""


class Hang(Exception):  # noqa: N818
    """The firmware has destroyed its stack. Real boards hang or restart; this one hangs."""


def values(line: bytes, motors: int) -> list[int]:
    """Return the value of each motor, 0-65535, from a line with or without newline.

    Characters after the last motor's value are ignored.

    Raises:
        Restart: a value is missing.
        Hang: a field has nine characters or more.
    """
    fields: list[bytes] = []
    begin = 2
    for index in range(begin, len(line)):
        if len(fields) < motors and line[index] in _SEPARATORS:
            fields.append(line[begin:index])
            begin = index + 1
    if len(fields) < motors:
        raise Restart
    if any(len(field) >= _SMASHED for field in fields):
        raise Hang
    return [_number(field) for field in fields]


def _number(field: bytes) -> int:
    digits = [(byte - ord("0")) & 0xFF for byte in field[:_ARRAY]]
    digits += [_UNUSED] * (_ARRAY - len(digits))
    while len(digits) > 1 and digits[-1] > 9:
        digits.pop()
    number = 0
    for digit in digits:
        number = number * 10 + digit
    return number & 0xFFFF
