"""What the firmware makes of the values in a line: a parser that never looks for its end.

It walks on until it has met a comma or newline for each motor, and collects characters in an
array of four bytes without a bound. Nothing is refused here; what the numbers are worth is the
servos' affair.

How characters become numbers is inferred from the values that are known (an empty field is 10,
`abc` 49, `0x1F` 721, `1e3` 633, signs and points give more than 1023): the array begins as four
tens, each character leaves its distance from "0" in eight bits, at the end whatever is not 0-9
is taken for unused, and the rest is added up in sixteen bits.
"""

_ARRAY = 4
_SMASHED = 9
"""Characters in a field that destroy more of the stack than the firmware survives."""

_UNUSED = 10
_SEPARATORS = b",\n"


class Restart(Exception):  # noqa: N818 - what the processor does, no mistake of ours
    """The firmware has run past the line and starts anew."""


class Hang(Exception):  # noqa: N818
    """The firmware has destroyed its stack and does nothing any more.

    Real ones hang or restart, as their compiler had it; this one hangs.
    """


def values(line: bytes, motors: int) -> list[int]:
    """Return what each motor gets, 0-65535, from a line with its newline, if it has one.

    What stands behind the last motor's value is not looked at.

    Raises:
        Restart: the line ends before each motor has a value.
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
