"""When the board has stopped its motors by itself, so that no wish is in force any more. Pure."""

from PySide6.QtCore import QCoreApplication

from trex_gui.devices.trex.client.telemetry import LatchedStatus
from trex_gui.devices.trex.protocol.flags import UART_MEANING, UartError
from trex_gui.devices.trex.protocol.parameter_keys import ParameterKey

SHUTDOWN = ParameterKey.UART_ERROR_SHUTDOWN
"""The parameter that lets any serial error stop the motors (0x08)."""


def why_the_board_stopped(news: LatchedStatus, *, errors_stop: bool) -> str:
    """Return why the motors are at rest after these bits, for people; empty: they are not.

    A serial timeout stops them always, every other serial error where 0x08 says so
    (`errors_stop`). The next motor command would start them again: that is a person's to give.
    """
    if news.uart & UartError.TIMEOUT:
        return QCoreApplication.translate(
            "board_stop",
            "The board heard nothing for the time of Serial Timeout and stopped its motors.",
        )
    if news.uart and errors_stop:
        names = ", ".join(name for bit, (name, _) in UART_MEANING.items() if news.uart & bit)
        text = QCoreApplication.translate(
            "board_stop",
            "The board stopped its motors because of an error on the line ({0}), as UART-Error "
            "Shutdown tells it to.",
        )
        return text.format(names.lower())
    return ""
