"""The files of a board for programs without a window: each is read and saved at once."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager

from trex_gui.core.files import SettingsError
from trex_gui.core.transport.adapters import adapter_key
from trex_gui.devices.trex.board.memory import DOUBTED, BoardMemory
from trex_gui.devices.trex.board.transaction import WriteTransaction
from trex_gui.devices.trex.client.reading import DeviceState
from trex_gui.devices.trex.protocol.calibration import Calibration, CalibrationKey
from trex_gui.devices.trex.protocol.commands import Signature
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.settings.accepted import AcceptedValues
from trex_gui.devices.trex.settings.board_records import BoardRecord, BoardRecords, utc_now
from trex_gui.devices.trex.settings.document import settings_of
from trex_gui.devices.trex.settings.edit_files import BoardIdentity, put_aside
from trex_gui.devices.trex.settings.history import SettingsHistory


class Keeper:
    """Snapshots, record and accepted values of a board that was read."""

    def __init__(
        self,
        state: DeviceState,
        link: ConnectionSettings,
        say: Callable[[str], None],
        warn: Callable[[str], None],
    ) -> None:
        """`say` takes sentences about what was kept, `warn` those about what was not."""
        self._state, self._link = state, link
        self._say, self._warn = say, warn
        self._records = BoardRecords()
        self._is_failing = False
        self.memory = BoardMemory(self)
        self.memory.take_board(
            settings_of(state), state.source, utc_now(), opened=True, adapter=adapter_key(link.url)
        )

    def begin(
        self,
        reason: str,
        parameters: Sequence[tuple[str, int]],
        calibrations: Sequence[tuple[CalibrationKey, Calibration]] = (),
    ) -> WriteTransaction:
        """Prepare a write: take the snapshot, then expect nothing of these values.

        Raises:
            SettingsError: the snapshot cannot be saved; nothing must be written.
        """
        values = tuple(parameters), tuple(calibrations)
        transaction = WriteTransaction(self.memory, self._state, self._link, values, reason=reason)
        history = SettingsHistory()
        snapshot = transaction.take_snapshot(history)
        self._say(f"Snapshot of the previous settings: {snapshot.path}.")
        if problem := history.bound().problem:
            self._warn(f"{problem} Set it again with `trexcmd history keep 500`.")
        transaction.begin()
        return transaction

    # --- For the memory -----------------------------------------------------------------

    def find(self, board: BoardIdentity) -> None:
        found = None
        try:
            found = self._records.load(board)
        except SettingsError as error:
            self._warn(f"what was applied to this board before is not known. {error}")
        self.memory.take_record(board, found)

    def find_lost(self, board: BoardIdentity, adapter: str) -> None:
        self.memory.take_lost(board, self._records.of_other_number(board, adapter))

    def save(self, board: BoardIdentity, record: BoardRecord | None) -> None:
        with self._saving("what was applied is"):
            self._records.save(board, record)

    def move(
        self, old: BoardIdentity, new: BoardIdentity, record: BoardRecord, *, keeps_old: bool
    ) -> None:
        with self._saving("what was applied is"):
            if (aside := put_aside(self._records.path(new))) is not None:
                text = "What was kept for another board with this device number is in {0} now."
                self._say(text.format(aside))
            self._records.save(new, record)
            if not keeps_old:
                self._records.save(old, None)

    def add_accepted(self, kind: Signature, values: Mapping[str, int]) -> None:
        with self._saving("what the board accepted was"):
            AcceptedValues().add(kind, values)
            names = ", ".join(f"{key} {wire}" for key, wire in values.items())
            self._say(f"Remembered as accepted by a {kind}: {names}.")

    def doubt(self, record: BoardRecord) -> None:
        self._warn(DOUBTED.format(record.settings.product.name, f"{record.time:%Y-%m-%d}"))

    def show_notes(self, notes: Mapping[str, str] | None, board: BoardIdentity) -> None:
        pass

    def note_change(self) -> None:
        pass

    @contextmanager
    def _saving(self, what: str) -> Iterator[None]:
        """Say once that files cannot be saved: the board is written all the same."""
        try:
            yield
        except SettingsError as error:
            if not self._is_failing:
                self._warn(f"{what} not remembered. {error}")
            self._is_failing = True
