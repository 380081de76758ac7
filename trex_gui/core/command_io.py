"""File-name parameters and standard streams of commands."""

import contextlib
import errno
import io
import os
import re
import sys
from collections.abc import Iterator
from typing import Any

import click

FAILURE_EXIT_CODE = "exit code"  # key in `click.Context.meta`, for the exit code of a failure

_CONTROLS = re.compile(r"[\x00-\x08\x0b\x0c\x0e-\x1f\x7f-\x84\x86-\x9f]|\r(?!\n)")

_ASCII_SUBSTITUTES = str.maketrans({"→": "->", "−": "-", "…": "...", "“": '"', "”": '"'})


class FileName(click.Path):
    """File parameter that rejects an empty name, which is usually an unset shell variable."""

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        if not str(value):
            self.fail("the name of the file is empty.", param, ctx)
        return super().convert(value, param, ctx)


class _Output:
    r"""Stream that shows control characters as escapes such as `\u001b`.

    The encoding is UTF-8 unless the stream is a terminal. The command fails if it cannot write
    data. Messages that cannot be written are lost. `below` is the original stream.
    """

    encoding = "utf-8"  # click would replace an ASCII stream

    def __init__(self, below: Any, *, is_data: bool) -> None:
        self._is_data = is_data
        self.below = below or io.TextIOWrapper(io.BufferedReader(io.BytesIO()))  # not writable
        if self.isatty():
            self.below.reconfigure(errors="replace")
        else:
            self.below.reconfigure(encoding="utf-8", errors="surrogateescape")
        self._substitutes = {} if self.below.encoding.lower() == "utf-8" else _ASCII_SUBSTITUTES

    def __getattr__(self, name: str) -> Any:
        return getattr(self.below, name)

    def fileno(self) -> int:
        raise OSError(errno.ENOTSUP, "click bypasses a stream with a file number on Windows")

    def write(self, text: str) -> int:
        escaped = _CONTROLS.sub(lambda match: f"\\u{ord(match[0]):04x}", text)
        if escaped:  # click tests a stream by writing an empty string
            self._call(self.below.write, escaped.translate(self._substitutes))
        return len(text)

    def flush(self) -> None:
        self._call(self.below.flush)

    def _call(self, function: Any, *arguments: str) -> None:
        try:
            function(*arguments)
        except OSError as error:
            if error.errno == errno.EPIPE:
                raise
            with contextlib.suppress(OSError):  # otherwise each later flush would fail
                number = self.below.fileno()
                os.dup2(os.open(os.devnull, os.O_WRONLY), number)
            if self._is_data:
                reason = error.strerror or "it is closed"
                failure = f"Standard output cannot be written: {reason}."
                raise click.ClickException(failure) from error


@contextlib.contextmanager
def standard_streams() -> Iterator[None]:
    """Replace the standard streams temporarily, even if they are closed."""
    original = sys.stdin, sys.stdout, sys.stderr
    for _ in range(original.count(None)):
        os.open(os.devnull, os.O_RDWR)  # otherwise a port could get this file number
    sys.stdin = sys.stdin or io.TextIOWrapper(io.BytesIO())
    sys.stdout = _Output(sys.stdout, is_data=True)
    sys.stderr = _Output(sys.stderr, is_data=False)
    try:
        yield
    finally:
        sys.stdin, sys.stdout, sys.stderr = original
