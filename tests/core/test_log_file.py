"""Log file of the program: content, size and disk errors."""

import logging
import os
import sys
import threading
from collections.abc import Callable
from pathlib import Path

import pytest

from trex_gui.core import log_file as module
from trex_gui.core.files import data_folder, log_folder
from trex_gui.core.log_file import ProgramLog, log_file, log_files

log = logging.getLogger("trex_gui.tests")


def written(*, is_verbose: bool = False, say: Callable[[], object]) -> str:
    """Return the log of a program that calls `say`."""
    program_log = ProgramLog(log_file(), is_verbose=is_verbose)
    say()
    assert program_log.close()
    return log_file().read_text(encoding="utf-8")


def say_each_level() -> None:
    for level in (logging.DEBUG, logging.INFO, logging.ERROR):
        log.log(level, "of level %d", level)


@pytest.mark.parametrize(
    ("is_verbose", "levels", "printed"),
    [(False, ["INFO", "ERROR"], ["of level 40"]), (True, ["DEBUG", "INFO", "ERROR"], None)],
)
def test_log_has_levels_and_terminal_has_problems(
    capsys: pytest.CaptureFixture[str],
    is_verbose: bool,
    levels: list[str],
    printed: list[str] | None,
) -> None:
    lines = written(is_verbose=is_verbose, say=say_each_level).splitlines()
    assert [line.split()[2] for line in lines] == levels
    assert lines[-1].endswith("ERROR trex_gui.tests: of level 40")
    assert capsys.readouterr().err.splitlines() == (lines if printed is None else printed)
    log.error("after the end")
    assert log_file().read_text(encoding="utf-8").splitlines() == lines


def test_traceback_is_in_the_log_and_printed_only_once(capsys: pytest.CaptureFixture[str]) -> None:
    def fail() -> None:
        try:
            1 / 0  # noqa: B018
        except ZeroDivisionError as error:
            log.critical("uncaught exception", exc_info=error, extra={"printed": True})

    text = written(say=fail)
    assert "CRITICAL trex_gui.tests: uncaught exception\nTraceback" in text
    assert "in fail" in text
    assert text.endswith("ZeroDivisionError: division by zero\n")
    assert not capsys.readouterr().err


def test_log_rotates_and_is_bounded(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "_MAX_SIZE", 2000)
    monkeypatch.setattr(module, "_MAX_LENGTH", 300)

    def say_much() -> None:
        for number in range(200):
            log.info("entry %d", number)
        log.info("%s", "x" * 100_000)
        log.info("the last")

    assert written(say=say_much).endswith("the last\n")
    assert set(log_folder().iterdir()) == set(log_files())
    assert all(0 < path.stat().st_size <= 2000 + 300 for path in log_files())
    text = "".join(path.read_text(encoding="utf-8") for path in log_files())
    assert "entry 199\n" in text
    assert "entry 0\n" not in text


def test_repeated_entry_is_counted_and_not_written() -> None:
    def repeat() -> None:
        for _ in range(1000):
            log.info("the same")
        for _ in range(2):
            log.info("another")
        log.info("the last")

    lines = written(say=repeat).splitlines()
    assert [line.partition(": ")[2] for line in lines] == [
        "the same",
        "the last entry was repeated 999 times",
        "another",
        "the last entry was repeated 1 time",
        "the last",
    ]


def test_repeated_entry_is_written_again_after_a_period(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "_REPEATED_S", 0.0)

    def repeat() -> None:
        for _ in range(2):
            log.info("the same")

    lines = written(say=repeat).splitlines()
    assert [line.partition(": ")[2] for line in lines] == ["the same"] * 2


def _folder_in_place() -> None:
    log_file().mkdir(parents=True)


def _file_in_place_of_folder() -> None:
    log_folder().parent.mkdir(parents=True, exist_ok=True)
    log_folder().write_text("mine", encoding="utf-8")


def _pipe_in_place() -> None:
    log_folder().mkdir(parents=True)
    os.mkfifo(log_file())


def _full_disk() -> None:
    log_folder().mkdir(parents=True)
    log_file().symlink_to("/dev/full")


@pytest.mark.skipif(sys.platform != "linux", reason="pipes and /dev/full")
@pytest.mark.parametrize(
    "prepare", [_folder_in_place, _file_in_place_of_folder, _pipe_in_place, _full_disk]
)
def test_unwritable_log_loses_only_lines(
    prepare: Callable[[], None], monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    if prepare is _full_disk:
        monkeypatch.setattr(module, "check_ordinary", lambda _: None)
    prepare()
    program_log = ProgramLog(log_file())
    say_each_level()
    assert program_log.close()
    assert capsys.readouterr().err == "of level 40\n"


def test_log_continues_once_the_folder_is_writable() -> None:
    _file_in_place_of_folder()
    program_log = ProgramLog(log_file())
    log.info("lost")
    log_folder().unlink()
    for number in range(1000):
        log.info("entry %d", number)
    assert program_log.close()
    assert "entry 999\n" in log_file().read_text(encoding="utf-8")
    assert list(data_folder().iterdir()) == [log_folder()]


def test_hanging_disk_delays_neither_the_program_nor_its_end(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    disk_responds = threading.Event()
    monkeypatch.setattr(module, "check_ordinary", lambda _: disk_responds.wait())
    monkeypatch.setattr(module, "_MAX_QUEUED", 50)
    program_log = ProgramLog(tmp_path / "log.txt")
    for number in range(1000):
        log.info("entry %d", number)
    assert not program_log.close(0.05), "the process can end only with os._exit"
    disk_responds.set()
    for thread in threading.enumerate():
        if thread is not threading.current_thread() and thread.daemon:
            thread.join(20)
    lines = (tmp_path / "log.txt").read_text(encoding="utf-8").splitlines()
    assert lines[0].endswith("entry 0")
    assert len(lines) <= 52, "the queue is bounded while the disk hangs"
