"""Standard streams of a command."""

import io
import os
import sys

import click
import pytest

from trex_gui.core.command_io import standard_streams


class Stream(io.TextIOWrapper):
    def __init__(self, encoding: str, *, is_terminal: bool = False, fails: bool = False) -> None:
        self.bytes = io.BytesIO()
        super().__init__(self.bytes, encoding=encoding)
        self._is_terminal = is_terminal
        self._fails = fails

    def isatty(self) -> bool:
        return self._is_terminal

    def write(self, text: str) -> int:
        if self._fails:
            raise OSError(28, "No space left on device")
        return super().write(text)


def written(stream: Stream, text: str, monkeypatch: pytest.MonkeyPatch) -> bytes:
    monkeypatch.setattr(sys, "stdout", stream)
    with standard_streams():
        click.echo(text)
    assert sys.stdout is stream
    return stream.bytes.getvalue()


@pytest.mark.parametrize("encoding", ["ascii", "cp1252", "cp437", "cp850", "cp932", "utf-16"])
def test_redirected_output_is_utf_8(encoding: str, monkeypatch: pytest.MonkeyPatch) -> None:
    assert written(Stream(encoding), "5 → 7 µs …", monkeypatch) == "5 → 7 µs …\n".encode()


@pytest.mark.parametrize("encoding", ["ascii", "cp437", "cp932"])
def test_terminal_replaces_unsupported_characters(
    encoding: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    shown = written(Stream(encoding, is_terminal=True), "5 → 7 ⇥", monkeypatch).decode(encoding)
    assert shown == "5 -> 7 ?\n"


@pytest.mark.parametrize("is_terminal", [False, True])
def test_control_characters_are_shown_as_escapes(
    is_terminal: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    stream = Stream("utf-8", is_terminal=is_terminal)
    shown = written(stream, "a\x1b]0;b\x07\x9bc\rd\te\r\nf", monkeypatch)
    assert shown == rb"a\u001b]0;b\u0007\u009bc\u000dd" + b"\te\r\nf\n"


def test_name_in_another_encoding_keeps_its_bytes(monkeypatch: pytest.MonkeyPatch) -> None:
    assert written(Stream("cp1252"), os.fsdecode(b"\xe9t"), monkeypatch) == b"\xe9t\n"


def test_full_disk_ends_the_command_with_a_message(monkeypatch: pytest.MonkeyPatch) -> None:
    with pytest.raises(click.ClickException, match="cannot be written: No space left") as caught:
        written(Stream("utf-8", fails=True), "text", monkeypatch)
    assert caught.value.exit_code == 1


def test_failing_stderr_does_not_end_the_command(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "stderr", Stream("utf-8", fails=True))
    with standard_streams():
        click.echo("message", err=True)


def test_closed_streams_fail_when_used(monkeypatch: pytest.MonkeyPatch) -> None:
    opened: list[str] = []

    def record_open(path: str, _flags: int) -> int:
        opened.append(path)
        return -1

    monkeypatch.setattr(os, "open", record_open)
    for name in ("stdin", "stdout", "stderr"):
        monkeypatch.setattr(sys, name, None)
    with standard_streams():
        assert opened == [os.devnull] * 3, "a port must not get the descriptor of a closed stream"
        click.echo("message", err=True)
        assert sys.stdin.read() == ""
        with pytest.raises(click.ClickException, match="it is closed"):
            click.echo("data")
    assert len(opened) == 3, "a failed write opens nothing"
