"""Pieces of texts that are the same in every language, and English ones of the command line."""


def counted(count: int, noun: str) -> str:
    """Return a count with its noun, whose plural ends in -s: `1 byte`, `2 bytes`."""
    return f"{count} {noun}" if count == 1 else f"{count} {noun}s"


def hex_text(data: bytes | bytearray) -> str:
    """Return bytes as `AF 07 05`."""
    return data.hex(" ").upper()


def title_of(text: str) -> str:
    """Return the text of a menu entry, button or label without its mnemonic and its end."""
    return text.replace("&", "").rstrip("…: \N{NO-BREAK SPACE}\N{NARROW NO-BREAK SPACE}")


def signed_text(number: int) -> str:
    """Return a number with its sign, `+60`, `−60`, or `0`."""
    return f"{number:+d}".replace("-", "−") if number else "0"
