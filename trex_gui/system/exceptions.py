"""A mistake of the program, in whatever thread, stops what it can before it is reported."""

import sys
import threading
from collections.abc import Callable
from types import TracebackType
from typing import Any

from PySide6.QtCore import QCoreApplication


class ExceptionWatch:
    """Stands before Python's hooks for what nobody caught, in slots of Qt too.

    The program goes on where it can: a window that still answers is of more use to a person beside
    a robot than none. `stop` gets the reason, for people, in the thread of the mistake: a clause
    without a full stop, since what the stop comes to is for each device to add.
    """

    def __init__(self, stop: Callable[[str], None]) -> None:
        self._stop = stop
        self._before = sys.excepthook, threading.excepthook, sys.unraisablehook
        sys.excepthook = self._on_exception
        threading.excepthook = self._on_thread_exception
        sys.unraisablehook = self._on_unraisable

    def close(self) -> None:
        """Put the hooks back."""
        sys.excepthook, threading.excepthook, sys.unraisablehook = self._before

    def _on_exception(
        self, kind: type[BaseException], error: BaseException, trace: TracebackType | None
    ) -> None:
        try:
            self._stop(_reason(error))
        finally:
            self._before[0](kind, error, trace)

    def _on_thread_exception(self, args: threading.ExceptHookArgs) -> None:
        try:
            self._stop(_reason(args.exc_value))
        finally:
            self._before[1](args)

    def _on_unraisable(self, args: Any) -> None:  # its type has no name at run time
        try:
            self._stop(_reason(args.exc_value))
        finally:
            self._before[2](args)


def _reason(error: BaseException | None) -> str:
    text = QCoreApplication.translate("ExceptionWatch", "The program made a mistake ({0})")
    return text.format(type(error).__name__)
