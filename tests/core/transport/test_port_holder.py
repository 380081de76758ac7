"""Which program has a port open."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from trex_gui.core.transport.linux_ports import holder_of, is_locked_elsewhere

fcntl = pytest.importorskip("fcntl")

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="only Linux shows open files")


def test_program_without_lock_on_port_is_named(tmp_path: Path) -> None:
    port = tmp_path / "port"
    with (
        port.open("wb") as opened,
        subprocess.Popen(["cat"], stdin=subprocess.PIPE, stdout=opened) as program,
    ):
        opened.close()
        assert holder_of(str(port)) == f"cat (process {program.pid})"
        program.communicate(b"")
    assert holder_of(str(port)) is None


def test_port_opened_by_own_program_has_no_holder(tmp_path: Path) -> None:
    port = tmp_path / "port"
    with port.open("wb"):
        assert holder_of(str(port)) is None


_LOCK = """
import fcntl, subprocess, sys
port = open(sys.argv[1], "wb")
fcntl.flock(port, fcntl.LOCK_EX)
child = subprocess.Popen(["cat"], stdin=int(sys.argv[2]), stdout=port)
print("locked", flush=True)
sys.stdin.readline()
"""


def test_lock_left_by_dead_program_is_about_to_end(tmp_path: Path) -> None:
    """Its guardian has the port open, and with it the lock."""
    port = tmp_path / "port"
    reading, writing = os.pipe()
    command = [sys.executable, "-c", _LOCK, str(port), str(reading)]
    pipe = subprocess.PIPE
    with subprocess.Popen(command, stdin=pipe, stdout=pipe, pass_fds=[reading]) as program:
        os.close(reading)
        assert program.stdout is not None
        program.stdout.readline()
        assert is_locked_elsewhere(str(port))
        program.communicate(b"\n")
        with port.open("wb") as opened, pytest.raises(BlockingIOError):
            fcntl.flock(opened, fcntl.LOCK_EX | fcntl.LOCK_NB)
        assert not is_locked_elsewhere(str(port))
    os.close(writing)
