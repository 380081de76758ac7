"""Preferences, with valid and damaged configuration files."""

import logging
import os
import sys
from pathlib import Path

import pytest
from hypothesis import HealthCheck, example, given, settings
from hypothesis import strategies as st
from PySide6.QtCore import QByteArray, QSettings

from trex_gui.ui.preferences import Preferences

posix = pytest.mark.skipif(sys.platform == "win32", reason="Windows has no named pipes in folders")
VALUES = (
    "99999999999999999999", "-1", "1, 2, 3", "@Invalid()", "@Size(1 2)", "nan", "1e999",
    "@ByteArray(abc)", "@Rect(1 2 3 4)", "\\x0", "9" * 5000, "true, false",
)  # fmt: skip


def store_file() -> Path:
    path = Path(QSettings().fileName())
    path.parent.mkdir(exist_ok=True)
    return path


def test_values_are_read_back_unchanged() -> None:
    for _ in range(2):
        store = Preferences()
        store.set("flag", value=True)
        store.set("number", 7)
        store.set("real", 2.5)
        store.set("text", "a, b; ü")
        store.set("data", QByteArray(b"\0\1"))
        QSettings().sync()
        assert store.flag("flag", default=False)
        assert store.integer("number", 0, 0, 7) == 7
        assert store.real("real", 0.0, 0.0, 3.0) == 2.5
        assert store.text("text") == "a, b; ü"
        assert store.path("text", "") == Path("a, b; ü")
        assert bytes(store.data("data").data()) == b"\0\1"


@pytest.mark.parametrize("value", [*VALUES, "8", "text"])
def test_unusable_value_counts_as_missing_and_is_logged(
    value: str, caplog: pytest.LogCaptureFixture
) -> None:
    store_file().write_text(f"[General]\nkey={value}\n")
    store = Preferences()
    with caplog.at_level(logging.WARNING):
        assert store.integer("key", 3, 0, 7) == 3
        assert store.flag("key", default=True)
        assert store.real("key", 3.0, 0.0, 7.0) == 3.0
    is_missing = value == "@Invalid()"
    assert ("the preference key is ignored" in caplog.text) is not is_missing


@settings(suppress_health_check=[HealthCheck.function_scoped_fixture], max_examples=50)
@given(content=st.binary(max_size=300))
@example(content=b"[General]\nkey=@Variant(\0\0\0\x04\0")
def test_any_content_is_read(content: bytes) -> None:
    path = store_file()
    path.write_bytes(b"[General]\nkey=" + content)
    store = QSettings()
    store.sync()
    reader = Preferences()
    for read in (reader.text, reader.data):
        read("key")
    reader.integer("key", 0, 0, 1)
    reader.flag("key", default=False)


@posix
@pytest.mark.parametrize("name", ["file", "lock", "organization"])
def test_pipe_in_place_of_a_configuration_file_is_not_opened(
    name: str, caplog: pytest.LogCaptureFixture
) -> None:
    path = store_file()
    pipe = {
        "file": path,
        "lock": path.with_name(f"{path.name}.lock"),
        "organization": path.parent.with_suffix(path.suffix),
    }[name]
    os.mkfifo(pipe)
    with caplog.at_level(logging.WARNING):
        store = Preferences()
    assert f"{pipe} is not an ordinary file" in caplog.text
    store.set("key", 5)
    assert Preferences().integer("key", 0, 0, 9) == 5, "the value remains in memory"
    assert pipe.is_fifo()


def test_folder_in_place_of_the_configuration_remains_empty() -> None:
    path = store_file()
    path.mkdir()
    Preferences().set("key", 5)
    assert not list(path.iterdir())


def test_huge_configuration_is_not_read() -> None:
    path = store_file()
    path.write_text("[General]\nkey=5\n" + "#" * 5_000_000)
    assert Preferences().integer("key", 3, 0, 9) == 3
