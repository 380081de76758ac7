"""Messages from models and pages to the banner of their window."""

from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum, auto

from PySide6.QtCore import QObject, Qt, Signal, Slot

from trex_gui.core.errors import InternalError, PortUnavailable
from trex_gui.core.transport.settings import PortSettings
from trex_gui.ui.translations import error_sentence


class Remedy(Enum):
    """Action that a message offers as a button."""

    FIND = auto()  # scan for a board whose line settings are unknown
    RECONNECT = auto()  # reconnect to the last port
    PLUG_IN = auto()  # reconnect to a missing port; the message disappears when the port appears
    SET_UP_CRC = auto()  # enable error detection on the line
    CHECK_BOARD = auto()  # show the checklist for a board that does not respond
    STOP_MOTORS = auto()  # stop motors left running; the message stays until they are stopped
    REPORT = auto()  # show the support report; the message stays when a connection starts


@dataclass(frozen=True, slots=True)
class CopyCommand:
    command: str


@dataclass(frozen=True, slots=True)
class ConnectWith:
    """Button that connects to the current port with these `settings`."""

    settings: PortSettings


@dataclass(frozen=True, slots=True)
class Answer:
    name: str  # object name
    text: str
    then: Callable[[], object]


AnyRemedy = Remedy | CopyCommand | ConnectWith | Answer
Remedies = tuple[AnyRemedy, ...]


def remedies_of(error: BaseException, *, may_be_found: bool = False) -> Remedies:
    """Return the buttons for an error that closed a line.

    `may_be_found`: a scan could find the board.
    """
    if isinstance(error, InternalError):
        return (Remedy.REPORT,)
    if not isinstance(error, PortUnavailable):
        return (Remedy.FIND,) if may_be_found else ()
    if error.command:
        return CopyCommand(error.command), Remedy.RECONNECT
    return (Remedy.PLUG_IN if error.is_missing else Remedy.RECONNECT,)


def never() -> bool:
    """Return False, so that any message may replace the danger."""
    return False


class Notifier(QObject):
    info = Signal(str)  # message about a result
    error = Signal(str)  # message about a failure and its cause
    danger = Signal(str)  # message about an immediate danger and its remedy
    remedies_offered = Signal(object)  # the `Remedies` for the latest message
    resolved = Signal(object)  # an obsolete `Remedy`; clears messages that offer it
    delayed_info = Signal(str)  # like `info`, after the current event, which may clear the banner
    delayed_error = Signal(str)  # like `error`, after the current event
    delayed_report = Signal(str, object)  # arguments of `report`
    cleared = Signal()
    shown_changed = Signal()
    logged = Signal(str, bool)  # any message; true if it is an error or a danger

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.shown = ""  # message in the banner
        self.danger_lasts: Callable[[], bool] = never  # true while a danger must stay visible
        self.shows_problem = False  # True while the banner shows an error, but not a danger
        self.delayed_info.connect(self.info, Qt.ConnectionType.QueuedConnection)
        self.delayed_error.connect(self.error, Qt.ConnectionType.QueuedConnection)
        self.delayed_report.connect(self.report, Qt.ConnectionType.QueuedConnection)
        self.info.connect(lambda text: self.logged.emit(text, False))
        self.error.connect(lambda text: self.logged.emit(text, True))
        self.danger.connect(lambda text: self.logged.emit(text, True))

    def forward_log(self, other: "Notifier") -> None:
        """Forward another notifier's messages to `logged`."""
        other.logged.connect(self.logged)

    @Slot(str, object)
    def report(self, text: str, remedies: Remedies) -> None:
        self.error.emit(text)
        self.remedies_offered.emit(remedies)

    def report_error(self, error: BaseException) -> None:
        self.error.emit(error_sentence(error))

    def warn(self, text: str, remedies: Remedies = (), lasts: Callable[[], bool] = never) -> None:
        """Emit `danger` with buttons. While `lasts()` is true, only another danger replaces it."""
        self.danger.emit(text)
        self.remedies_offered.emit(remedies)
        self.danger_lasts = lasts

    def prompt(self, text: str, *answers: Answer) -> None:
        self.info.emit(text)
        self.remedies_offered.emit(answers)
