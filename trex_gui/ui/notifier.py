"""Messages to the user, from models and pages to the banner of their window."""

from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum, auto

from PySide6.QtCore import QObject, Qt, Signal, Slot

from trex_gui.core.errors import InternalError, PortUnavailable
from trex_gui.core.transport.settings import PortSettings
from trex_gui.ui.translations import error_sentence


class Remedy(Enum):
    """An action that a button in a message offers."""

    FIND = auto()  # look for a board whose line settings are unknown
    RECONNECT = auto()  # connect again to the port that was used last
    PLUG_IN = auto()
    """Connect again to a missing port. The message ends as soon as the port appears."""
    SET_UP_CRC = auto()  # let the board detect errors on the line
    CHECK_BOARD = auto()  # show what to look at on a board that does not respond
    STOP_THEM = auto()
    """Stop the motors that another program has left running. The message stays until then."""
    REPORT = auto()
    """Show the report for support. The message is about the program and outlives connections."""


@dataclass(frozen=True, slots=True)
class CopyCommand:
    """A button that copies a command for a shell."""

    command: str


@dataclass(frozen=True, slots=True)
class ConnectWith:
    """A button that connects to the same port with other settings."""

    settings: PortSettings


@dataclass(frozen=True, slots=True)
class Answer:
    """A button that answers a question: its object name, its text, and what it does."""

    name: str
    text: str
    then: Callable[[], object]


AnyRemedy = Remedy | CopyCommand | ConnectWith | Answer
Remedies = tuple[AnyRemedy, ...]


def remedies_of(error: BaseException, *, may_be_found: bool = False) -> Remedies:
    """Return the buttons for an error that closed a line.

    `may_be_found`: a scan may find a board at other settings.
    """
    if isinstance(error, InternalError):
        return (Remedy.REPORT,)
    if not isinstance(error, PortUnavailable):
        return (Remedy.FIND,) if may_be_found else ()
    if error.command:
        return CopyCommand(error.command), Remedy.RECONNECT
    return (Remedy.PLUG_IN if error.is_missing else Remedy.RECONNECT,)


def never() -> bool:
    """Return false. For a danger message that the next message may replace."""
    return False


class Notifier(QObject):
    """Carries messages to one window, which shows the newest."""

    info = Signal(str)  # what was done, in sentences for the user
    error = Signal(str)  # what failed, and why
    danger = Signal(str)  # an immediate danger, and what to do about it
    remedies_offered = Signal(object)  # the `Remedies` for the message that came just before
    resolved = Signal(object)  # a `Remedy` that is no longer needed; ends messages that offer it
    # Queued until the present event is handled, for messages that come with a report whose
    # handling clears the banner.
    delayed_info = Signal(str)
    delayed_error = Signal(str)
    delayed_report = Signal(str, object)  # see `report`
    cleared = Signal()
    shown_changed = Signal()  # `shown`
    logged = Signal(str, bool)  # every message, and whether it is an error; see `log_also`

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        # State of the banner: its message, how long a danger lasts, and whether it shows an error.
        self.shown = ""
        self.danger_lasts: Callable[[], bool] = never
        self.shows_problem = False
        self.delayed_info.connect(self.info, Qt.ConnectionType.QueuedConnection)
        self.delayed_error.connect(self.error, Qt.ConnectionType.QueuedConnection)
        self.delayed_report.connect(self.report, Qt.ConnectionType.QueuedConnection)
        self.info.connect(lambda text: self.logged.emit(text, False))
        self.error.connect(lambda text: self.logged.emit(text, True))
        self.danger.connect(lambda text: self.logged.emit(text, True))

    def log_also(self, other: "Notifier") -> None:
        """Log the messages of another notifier, too."""
        other.logged.connect(self.logged)

    @Slot(str, object)
    def report(self, text: str, remedies: Remedies) -> None:
        self.error.emit(text)
        self.remedies_offered.emit(remedies)

    def report_error(self, error: BaseException) -> None:
        self.error.emit(error_sentence(error))

    def warn(self, text: str, remedies: Remedies = (), lasts: Callable[[], bool] = never) -> None:
        """Emit a `danger` with buttons. No other message replaces it while it `lasts`."""
        self.danger.emit(text)
        self.remedies_offered.emit(remedies)
        self.danger_lasts = lasts

    def prompt(self, text: str, *answers: Answer) -> None:
        self.info.emit(text)
        self.remedies_offered.emit(answers)
