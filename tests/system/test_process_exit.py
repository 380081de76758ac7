"""End of the process after a C library has called `exit`."""

import subprocess
import sys

import pytest

HANGING_HANDLER = """
import ctypes, threading
from trex_gui.system.process_exit import skip_exit_handlers
libc = ctypes.CDLL(None)
hang = ctypes.CFUNCTYPE(None, ctypes.c_int, ctypes.c_void_p)(lambda *_: threading.Event().wait())
libc.on_exit(hang, None)
skip_exit_handlers()
"""


@pytest.mark.realtime
@pytest.mark.skipif(sys.platform != "linux", reason="needs glibc")
@pytest.mark.parametrize(("ending", "code"), [("libc.exit(3)", 3), ("raise SystemExit(4)", 4)])
def test_exit_handlers_cannot_block_the_end_of_the_process(ending: str, code: int) -> None:
    command = [sys.executable, "-c", HANGING_HANDLER + ending]
    assert subprocess.run(command, timeout=50, check=False).returncode == code
