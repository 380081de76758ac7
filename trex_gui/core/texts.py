"""Pieces of texts that are the same in every language, and English ones of the command line."""


def counted(count: int, noun: str) -> str:
    """Return a count with its noun, whose plural ends in -s: `1 byte`, `2 bytes`."""
    return f"{count} {noun}" if count == 1 else f"{count} {noun}s"


def hex_text(data: bytes | bytearray) -> str:
    """Return bytes as `AF 07 05`."""
    return data.hex(" ").upper()


def name_of(text: str) -> str:
    """Return the name of a control or menu entry: its text without letter, dots and colon."""
    return text.replace("&", "").rstrip("…: \u00a0\u202f")


def signed_text(number: int) -> str:
    """Return a number with its sign, `+60`, `−60`, or `0`."""
    return f"{number:+d}".replace("-", "−") if number else "0"
