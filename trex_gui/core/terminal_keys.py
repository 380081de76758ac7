"""Keyboard input from a terminal, without waiting."""

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager


@contextmanager
def pressed_keys() -> Iterator[Callable[[], str]]:
    """Yield a function that returns the keys typed since its last call.

    Standard input must be a terminal. The mode of the terminal is restored at the end. Ctrl-C still
    interrupts the program.
    """
    if sys.platform == "win32":
        import msvcrt  # noqa: PLC0415 - only on Windows

        def typed() -> str:
            text = ""
            while msvcrt.kbhit():
                text += msvcrt.getwch()
            return text

        yield typed
        return

    import os  # noqa: PLC0415
    import select  # noqa: PLC0415
    import termios  # noqa: PLC0415
    import tty  # noqa: PLC0415

    terminal = sys.stdin.fileno()
    settings = termios.tcgetattr(terminal)

    def read() -> str:
        text = b""
        while select.select([terminal], [], [], 0)[0] and (more := os.read(terminal, 1024)):
            text += more
        return text.decode("utf-8", "replace")

    try:
        tty.setcbreak(terminal)
        yield read
    finally:
        termios.tcsetattr(terminal, termios.TCSADRAIN, settings)
