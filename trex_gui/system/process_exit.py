"""The end of the process where a C library calls `exit`: Xlib does when the X server is gone."""

import ctypes


def skip_exit_handlers() -> None:
    """Let the `exit` of C end the process at once with its code. Call it when Qt is loaded.

    Python has ended before it calls `exit` itself. When Xlib calls it, at the end of a session, the
    handlers of Qt would wait for a thread that waits for this one: the process would keep the port
    for ever. Only glibc can do this; elsewhere nothing changes.
    """
    libc = ctypes.CDLL(None)
    if (on_exit := getattr(libc, "on_exit", None)) is not None:
        on_exit(libc._exit, None)  # noqa: SLF001 - the function of C
