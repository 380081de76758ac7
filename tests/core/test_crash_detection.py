"""Detection of a crash of the previous run."""

import os
import signal
import subprocess
import sys

import pytest

from trex_gui.core.crash_detection import RunFile, crash_file
from trex_gui.core.files import log_folder

pytestmark = pytest.mark.realtime

_SCRIPT = """
import faulthandler, signal, sys, time
from trex_gui.core.crash_detection import RunFile
run_file = RunFile()
print(run_file.found_crash, flush=True)
def crash_here():
    signal.raise_signal(signal.SIGSEGV)
{"crash": crash_here, "close": run_file.close, "wait": lambda: time.sleep(60)}[sys.argv[1]]()
"""


def run(action: str) -> "subprocess.Popen[str]":
    return subprocess.Popen(
        [sys.executable, "-c", _SCRIPT, action], stdout=subprocess.PIPE, text=True
    )


def found_crash(action: str = "close") -> bool:
    """Run a process to its end. Return True if it found a crash."""
    with run(action) as process:
        return process.communicate(timeout=60)[0] == "True\n"


@pytest.mark.skipif(sys.platform == "win32", reason="POSIX signals")
def test_crash_is_found_once_with_its_traceback() -> None:
    assert [found_crash(), found_crash("crash")] == [False, False]
    assert [found_crash(), found_crash()] == [True, False]
    assert list(log_folder().iterdir()) == [crash_file()]
    text = crash_file().read_text(encoding="utf-8")
    assert text.startswith("TReX Studio ")
    assert "Fatal Python error: Segmentation fault" in text
    assert "in crash_here" in text


def test_running_program_counts_as_crashed_only_after_kill() -> None:
    with run("wait") as process:
        assert process.stdout is not None
        assert process.stdout.readline() == "False\n"
        assert not found_crash()
        os.kill(process.pid, signal.SIGTERM)
    assert found_crash()


def test_unwritable_folder_does_not_count_as_crash() -> None:
    log_folder().write_text("mine", encoding="utf-8")
    run_file = RunFile()
    run_file.close()
    assert not run_file.found_crash
    assert log_folder().read_text(encoding="utf-8") == "mine"
