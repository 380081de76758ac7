"""CRC-7 as the TReX computes it.

Ref: Pololu TReX User's Guide 5.e: most significant bit first, start 0, seven zero bits
appended, default polynomial 0x89; the low seven bits of one more byte carry it.
"""

from functools import cache

from trex_gui.core.errors import BadRequest

DEFAULT_POLYNOMIAL = 0x89


@cache
def _table(polynomial: int) -> bytes:
    table = bytearray()
    for value in range(256):
        remainder = value
        for _ in range(8):
            if remainder & 0x80:
                remainder ^= polynomial
            remainder = remainder << 1 & 0xFF
        table.append(remainder)
    return bytes(table)


def check_polynomial(polynomial: int) -> int:
    """Return `polynomial` when it is one (0x80-0xFF: the top bit is always 1).

    Raises:
        BadRequest: it is not.
    """
    if not 0x80 <= polynomial <= 0xFF:
        raise BadRequest(f"a CRC-7 polynomial is 0x80 to 0xFF, not {polynomial:#x}")
    return polynomial


def crc7(data: bytes, polynomial: int = DEFAULT_POLYNOMIAL) -> int:
    """Return the CRC-7 of `data`, 0-127.

    Raises:
        BadRequest: `polynomial` is outside 0x80-0xFF.
    """
    table = _table(check_polynomial(polynomial))
    remainder = 0
    for byte in data:
        remainder = table[remainder ^ byte]
    return remainder >> 1
