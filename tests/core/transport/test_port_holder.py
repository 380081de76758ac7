"""Programs that have a port open."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from trex_gui.core.transport.linux_ports import holder_of, is_locked_elsewhere, other_user_of

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
        assert other_user_of(str(port)) == holder_of(str(port))
        program.communicate(b"")
    assert holder_of(str(port)) is None
    assert other_user_of(str(port)) is None


def test_port_opened_by_own_program_has_no_holder(tmp_path: Path) -> None:
    port = tmp_path / "port"
    with port.open("wb"):
        assert holder_of(str(port)) is None
        assert other_user_of(str(port)) is None
    assert other_user_of(str(tmp_path / "missing")) is None


@pytest.mark.parametrize("kind", ["guardian", "terminal"])
def test_guardian_and_simulator_do_not_count_as_other_program(tmp_path: Path, kind: str) -> None:
    """The guardian inherits the port. The simulator is behind a pseudo-terminal."""
    port = tmp_path / "port"
    master, slave = os.openpty()
    name, inherited = (kind, ()) if kind == "guardian" else ("sleeper", (master,))
    code, pipe = "import sys; sys.stdin.read()", subprocess.PIPE
    command = [sys.executable, "-c", code, name]
    with (
        port.open("wb") as opened,
        subprocess.Popen(command, stdin=pipe, stdout=opened, pass_fds=inherited) as program,
    ):
        assert holder_of(str(port)) is not None
        assert other_user_of(str(port)) is None
        program.communicate(b"")
    os.close(master)
    os.close(slave)


_LOCK = """
import fcntl, subprocess, sys
port = open(sys.argv[1], "wb")
fcntl.flock(port, fcntl.LOCK_EX)
child = subprocess.Popen(["cat"], stdin=int(sys.argv[2]), stdout=port)
print("locked", flush=True)
sys.stdin.readline()
"""


def test_lock_of_dead_program_does_not_count(tmp_path: Path) -> None:
    """The guardian inherits the open port, so the lock outlives the program that took it."""
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
