"""Pieces of English texts that are not translated: those of the command line and simulators."""


def counted(count: int, noun: str) -> str:
    """Return a count with its noun, whose plural ends in -s: `1 byte`, `2 bytes`."""
    return f"{count} {noun}" if count == 1 else f"{count} {noun}s"
