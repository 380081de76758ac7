"""Exit of the process when a C library calls `exit`, as Xlib does without an X server."""

import ctypes


def skip_exit_handlers() -> None:
    """Make C's `exit` end the process at once. Call this after Qt is loaded.

    Xlib calls `exit` at the end of a session. Qt's exit handlers would then wait for a thread that
    waits for the calling thread, and the process would keep the port open forever. Python itself
    calls `exit` only after its own shutdown. Without glibc, this function does nothing.
    """
    libc = ctypes.CDLL(None)
    if (on_exit := getattr(libc, "on_exit", None)) is not None:
        on_exit(libc._exit, None)  # noqa: SLF001 - a C function
