"""Which program has a port open."""

import subprocess
import sys
from pathlib import Path

import pytest

from trex_gui.core.transport.linux_ports import holder_of

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
