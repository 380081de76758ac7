"""Boards that share a line: scan, presence and selection."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from enum import Enum, auto
from urllib.parse import quote

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.core.errors import BadReply, StudioError
from trex_gui.core.session import Outcome
from trex_gui.core.translation import tr
from trex_gui.devices.trex.discovery import NUMBERS
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.protocol.commands import Signature
from trex_gui.devices.trex.protocol.errors import ErrorCode, TrexError
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.devices.trex.session.messages import ProbeNumber
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.preferences import Preferences
from trex_gui.ui.runtime import new_timer
from trex_gui.ui.translations import error_text

_PRESENCE_MS = 2000  # interval of presence queries; they use at most 4 % of the line time


class Presence(Enum):
    SELECTED = auto()
    RESPONDING = auto()
    SILENT = auto()
    UNREADABLE = auto()  # unreadable reply: several boards may share the number
    UNKNOWN = auto()  # not queried since the line was opened


@dataclass(frozen=True, slots=True)
class LineBoard:
    number: int
    signature: Signature | None  # `None` while unknown
    presence: Presence

    @property
    def name(self) -> str:
        """Number and model: `7 · TReX 1.2`."""
        return f"{self.number} · {self.signature}" if self.signature else str(self.number)


Done = Callable[[StudioError | None], None]  # called with the error, or `None` on success


class BoardList(QObject):
    """Boards found on the line of a device.

    Device numbers distinguish the boards. A scan probes every number. Probing moves no motor and
    clears no error. Once several boards are known, commands carry the number of the selected board.
    Without a number, commands would reach every board.
    """

    changed = Signal()  # any attribute or property

    def __init__(self, device: Device, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._device = device
        # Sorted by number; may be from an earlier scan of this port
        self.boards: tuple[LineBoard, ...] = ()
        self.scanned: int | None = None  # count of probed numbers; `None` while no scan runs
        self.is_selecting = False
        self._url = ""
        self.is_probing = False  # a probe was sent, and its outcome is not known yet
        self._queried = 0  # index of the last queried board in the list of unselected boards
        self._presence = new_timer(self, _PRESENCE_MS, self._on_presence_due)
        device.link_changed.connect(self._on_link_changed)
        device.connection.line_closed.connect(self._on_line_closed)
        device.state_changed.connect(self._on_state_changed)
        device.motors.arming_changed.connect(self._on_link_changed)

    @property
    def selected(self) -> int | None:
        """Number of the selected board. `None` if unknown."""
        device = self._device
        if device.settings is not None and device.settings.device_number is not None:
            return device.settings.device_number
        return device.parameters.values.stored.get(ParameterKey.DEVICE_NUMBER)

    @property
    def has_several(self) -> bool:
        return len(self.boards) > 1

    @property
    def unselected_numbers(self) -> set[int]:
        return {board.number for board in self.boards} - {self.selected}

    @property
    def can_scan(self) -> bool:
        return self._may_probe and self.scanned is None

    @property
    def can_select(self) -> bool:
        device = self._device
        return (
            device.link in {ConnectionState.CONNECTED, ConnectionState.NOT_RESPONDING}
            and not device.writer.running
            and not self.is_selecting
            and not device.driving.is_group
        )

    @property
    def can_change_number(self) -> bool:
        return self._may_probe and not self._device.writer.is_rejected

    @property
    def _may_probe(self) -> bool:
        device = self._device
        is_driven = device.motors.armed or device.may_move or device.driving.is_group
        return device.is_writable and not (is_driven or self.is_selecting)

    # --- Scanning -----------------------------------------------------------------------

    def scan(self) -> None:
        """Probe every device number. Arming the motors ends the scan."""
        if self.can_scan:
            self.scanned = 0
            self.changed.emit()
            self._probe_next()

    def cancel_scan(self) -> None:
        if self.scanned is not None:
            self.scanned = None
            self.changed.emit()

    def _probe_next(self) -> None:
        number = self.scanned
        if number is None or self.is_probing:
            return
        if not self._may_probe:
            self.cancel_scan()
            return
        if number == NUMBERS:
            self.scanned = None
            self._finish_scan()
            return
        settings = self._device.settings
        if settings is not None and number == settings.device_number:
            self._record(number, self._device.signature, Presence.SELECTED)
            self._continue_scan(number)
        else:
            self._probe(number)

    def _continue_scan(self, number: int) -> None:
        """Continue the scan after a reply. A reply to a presence query does not advance it."""
        if number == self.scanned:
            self.scanned += 1
            self.changed.emit()
        self._probe_next()

    def _finish_scan(self) -> None:
        missing = {Presence.SILENT, Presence.UNKNOWN}
        present = [board for board in self.boards if board.presence not in missing]
        self.boards = tuple(present)
        self._save_numbers()
        text = tr(
            "No other board replies on this line. Every board needs power, the same serial "
            "settings as the connected board, and a unique device number."
        )
        if len(present) > 1:
            text = tr("%n board(s) on this line.", "", len(present))
        self._device.notifier.info.emit(text)
        self._on_state_changed()
        settings = self._device.settings
        readable = [board.number for board in present if board.presence is not Presence.UNREADABLE]
        if len(present) > 1 and readable and settings and settings.device_number is None:
            selected = self.selected
            self._select(selected if selected in readable else readable[0])

    def _probe(self, number: int) -> None:
        def on_probed(outcome: Outcome) -> None:
            self.is_probing = False
            match outcome.value, outcome.error:
                case Signature() as signature, _:
                    self._record(number, signature, Presence.RESPONDING)
                case _, BadReply():
                    self._record(number, None, Presence.UNREADABLE)
                case None, None if self._board(number) is not None:
                    self._record(number, None, Presence.SILENT)
            self._continue_scan(number)

        self.is_probing = self._device.connection.request(
            lambda request: ProbeNumber(request, number), on_probed
        )

    def _board(self, number: int) -> LineBoard | None:
        return next((board for board in self.boards if board.number == number), None)

    def _record(self, number: int, signature: Signature | None, presence: Presence) -> None:
        before = self._board(number)
        if number == self.selected and self.is_addressed:
            presence = Presence.SELECTED
        if signature is None and before is not None:
            signature = before.signature
        board = LineBoard(number, signature, presence)
        if board != before:
            others = [board for board in self.boards if board.number != number]
            self.boards = tuple(sorted([*others, board], key=lambda board: board.number))
            self._update_reach()
            self.changed.emit()

    def _update_reach(self) -> None:
        reaches_several = self.has_several and not self.is_addressed
        self._device.driving.set_reaching_several(reaches_several)

    @property
    def is_addressed(self) -> bool:
        """True if commands carry the number of one board."""
        settings = self._device.settings
        return settings is not None and settings.device_number is not None

    # --- Selection ----------------------------------------------------------------------

    def select(self, number: int, then: Done = lambda _error: None) -> None:
        """Stop the current board, then select another board.

        The current board stays selected if its stop is not confirmed, or if the other board does
        not respond. `then` is not called if `number` is selected already, or if `can_select` is
        false.
        """
        if self.can_select and (number != self.selected or not self.is_addressed):
            self.cancel_scan()
            self._select(number, then)

    def _select(self, number: int, then: Done = lambda _error: None) -> None:
        device = self._device
        self.is_selecting = True
        self.changed.emit()

        def finish(error: StudioError | None) -> None:
            self.is_selecting = False
            if isinstance(error, TrexError) and error.code is ErrorCode.NOT_SELECTED_MOVING:
                device.driving.record_unconfirmed()
            elif isinstance(error, TrexError) and error.code is ErrorCode.NOT_SELECTED_SILENT:
                self._record(number, None, Presence.SILENT)
            if error is not None:
                device.notifier.delayed_error.emit(error_text(error))
            self._on_state_changed()
            then(error)

        def on_stopped(error: StudioError | None) -> None:
            if not device.connection.is_open:
                finish(TrexError(ErrorCode.CLOSED))
            elif error is not None or device.may_move:
                finish(TrexError(ErrorCode.NOT_SELECTED_MOVING, number))
            else:
                known = tuple(board.number for board in self.boards)
                device.connection.select(number, known, lambda outcome: finish(outcome.error))

        if device.motors.armed or device.may_move:
            device.driving.stop(on_stopped, tr("Another board was selected."))
        else:
            on_stopped(None)

    # --- Reports from the device --------------------------------------------------------

    @Slot()
    def _on_link_changed(self) -> None:
        if not self._may_probe:
            self.cancel_scan()
        self.changed.emit()

    @Slot()
    def _on_line_closed(self) -> None:
        self.scanned = None
        self.is_selecting = self.is_probing = False
        self._presence.stop()
        self.boards = tuple(replace(board, presence=Presence.UNKNOWN) for board in self.boards)
        self.changed.emit()

    @Slot()
    def _on_state_changed(self) -> None:
        device = self._device
        if device.state is None or device.settings is None:
            return
        if device.settings.url != self._url:
            self._url = device.settings.url
            self.boards = self._known_boards()
        known = [board for board in self.boards if board.presence is not Presence.UNKNOWN]
        if not self.is_addressed and not known:
            self.boards = ()  # a single board is expected
        numbers = {board.number for board in self.boards}
        joined = [number for number in device.settings.group if number not in numbers]
        self.boards += tuple(LineBoard(number, None, Presence.UNKNOWN) for number in joined)
        selected, before = self.selected, self.boards
        if before and selected is not None and self.is_addressed:
            others = [board for board in before if board.number != selected]
            boards = [board for board in others if board.presence is not Presence.SELECTED]
            if self.is_selecting:  # otherwise the number of the board was changed
                former = (board for board in others if board.presence is Presence.SELECTED)
                boards += (replace(board, presence=Presence.RESPONDING) for board in former)
            boards.append(LineBoard(selected, self._device.signature, Presence.SELECTED))
            self.boards = tuple(sorted(boards, key=lambda board: board.number))
            if {board.number for board in self.boards} != {board.number for board in before}:
                self._save_numbers()
        if self.has_several and not self._presence.isActive():
            self._presence.start()
        self._update_reach()
        self.changed.emit()

    @property
    def _known_key(self) -> str:
        return f"boards/{quote(self._url, safe='')}"

    def _save_numbers(self) -> None:
        numbers = ",".join(str(board.number) for board in self.boards)
        Preferences().set(self._known_key, numbers)

    def _known_boards(self) -> tuple[LineBoard, ...]:
        words = Preferences().text(self._known_key).split(",")
        known = {int(word) for word in words if word.isascii() and word.isdigit()}
        numbers = sorted(number for number in known if number < NUMBERS)
        return tuple(LineBoard(number, None, Presence.UNKNOWN) for number in numbers)

    @Slot()
    def _on_presence_due(self) -> None:
        others = [board for board in self.boards if board.presence is not Presence.SELECTED]
        if others and self._may_probe and self.scanned is None and not self.is_probing:
            self._queried = (self._queried + 1) % len(others)
            self._probe(others[self._queried].number)
