"""Text formatting without translation."""


def counted(count: int, noun: str) -> str:
    """Return a count and its noun, such as `1 byte` or `2 bytes`."""
    return f"{count} {noun}" if count == 1 else f"{count} {noun}s"


def hex_text(data: bytes | bytearray) -> str:
    """Return bytes as hexadecimal text, such as `AF 07 05`."""
    return data.hex(" ").upper()


def title_of(text: str) -> str:
    """Return the text of a menu, button or label without mnemonic, colon and ellipsis."""
    return text.replace("&", "").rstrip("…: \N{NO-BREAK SPACE}\N{NARROW NO-BREAK SPACE}")


def signed_text(number: int) -> str:
    """Return a number with its sign, such as `+60`, `−60` or `0`."""
    return f"{number:+d}".replace("-", "−") if number else "0"
