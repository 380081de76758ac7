"""Files of a board for programs without a window, and writes to it over an open line."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from functools import partial

from trex_gui.core.errors import StudioError
from trex_gui.core.files import SettingsError
from trex_gui.devices.trex.board.memory import DOUBTED, BoardMemory
from trex_gui.devices.trex.board.transaction import WriteTransaction
from trex_gui.devices.trex.client.client import TrexClient
from trex_gui.devices.trex.client.reading import (
    DeviceState,
    Progress,
    read_everything,
    require_free_number,
)
from trex_gui.devices.trex.client.write_once import write_parameter
from trex_gui.devices.trex.client.writing import WriteResult, after_writing, write_all
from trex_gui.devices.trex.protocol.calibration import Calibration, CalibrationKey
from trex_gui.devices.trex.protocol.commands import Signature
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.errors import ErrorCode, OtherBoard
from trex_gui.devices.trex.protocol.parameters import ParameterKey, ParameterSpec
from trex_gui.devices.trex.settings.accepted import AcceptedValues
from trex_gui.devices.trex.settings.board_records import BoardRecord, BoardRecords, utc_now
from trex_gui.devices.trex.settings.comparison import compare, values_to_write
from trex_gui.devices.trex.settings.document import settings_of
from trex_gui.devices.trex.settings.edit_files import BoardIdentity, put_aside
from trex_gui.devices.trex.settings.history import SettingsHistory

Say = Callable[[str], None]


def read_record(board: BoardIdentity, warn: Say) -> BoardRecord | None:
    """Return the saved record of a board. `None` if it is missing, or damaged (warns)."""
    try:
        return BoardRecords().load(board)
    except SettingsError as error:
        warn(f"what was applied to this board before is not known. {error}")
        return None


class Keeper:
    """Snapshots, record and accepted values of a board. Files are read when first needed."""

    def __init__(self, say: Say, warn: Say) -> None:
        """`say` receives sentences about saved files, `warn` about files that were not saved."""
        self._say, self._warn = say, warn
        self._records = BoardRecords()
        self._is_failing = False
        self._sought: BoardIdentity | None = None
        self.memory = BoardMemory(self)

    def load(self) -> None:
        """Read the record of the board, unless it was read before."""
        board, self._sought = self._sought, None
        if board is not None:
            self.memory.handle_record(board, read_record(board, self._warn))

    def prepare(
        self,
        state: DeviceState,
        link: ConnectionSettings,
        reason: str,
        parameters: Sequence[tuple[str, int]],
        calibrations: Sequence[tuple[CalibrationKey, Calibration]] = (),
    ) -> WriteTransaction:
        """Prepare a write: save a snapshot, then expect nothing of these values.

        Raises:
            SettingsError: the snapshot cannot be saved; nothing must be written.
        """
        self.load()
        values = tuple(parameters), tuple(calibrations)
        transaction = WriteTransaction(self.memory, state, link, values, reason=reason)
        history = SettingsHistory()
        snapshot = transaction.save_snapshot(history)
        self._say(f"Snapshot of the previous settings: {snapshot.path}.")
        if problem := history.limit().problem:
            self._warn(f"{problem} Set it again with `trexcmd history keep 500`.")
        transaction.start()
        return transaction

    def write(
        self,
        client: TrexClient,
        state: DeviceState,
        reason: str,
        parameters: Sequence[tuple[str, int]],
        calibrations: Sequence[tuple[CalibrationKey, Calibration]] = (),
        *,
        progress: Progress = lambda _done, _total, _what: None,
        cancelled: Callable[[], bool] = lambda: False,
    ) -> tuple[WriteResult, ...]:
        """Save a snapshot, write, and record the applied values. See `write_all`.

        Nothing is written after a BadRequest: another board on the line has the device number.
        """
        number = dict(parameters).get(ParameterKey.DEVICE_NUMBER)
        if number is not None and number != state.parameters.get(ParameterKey.DEVICE_NUMBER):
            require_free_number(client, number)
        transaction = self.prepare(state, client.settings, reason, parameters, calibrations)
        results = write_all(
            client.request,
            state.specs,
            parameters,
            calibrations,
            progress,
            before=state,
            has_crc=client.has_crc,
            cancelled=cancelled,
        )
        transaction.finish(results, after_writing(state, results), utc_now())
        return results

    @contextmanager
    def restored_afterwards(
        self, client: TrexClient, state: DeviceState, reason: str
    ) -> Iterator[Callable[[ParameterSpec, int], int]]:
        """Save a snapshot, yield a function that tries a value, and always restore the board.

        Meanwhile the record of the board expects the previous values. If this program dies, or the
        line is gone, the next connection shows the differences.
        """
        before, record = settings_of(state), self.memory.record
        assert record is not None  # noqa: S101 - it was loaded
        self.prepare(state, client.settings, reason, ()).finish((), state, utc_now())
        try:
            yield partial(write_parameter, client.request, has_crc=client.has_crc)
        finally:
            try:
                found = read_everything(client.request, has_crc=client.has_crc)
                rows = [row for row in compare(settings_of(found), before).rows if row.changed]
                if found.signature != state.signature or len(rows) > 3:  # a value, stray writes
                    raise OtherBoard(ErrorCode.TOO_MANY_DIFFER, len(rows))
                wanted = values_to_write(rows)
                for result in write_all(
                    client.request, state.specs, *wanted, has_crc=client.has_crc
                ):
                    if result.error is not None:
                        raise result.error
                self.memory.restore(record)
            except StudioError as error:
                self._say(f"The board may store other settings than before. {error}")
                self._say("`trexcmd diff --last` shows them; the snapshot has what was stored.")

    # --- For the memory -----------------------------------------------------------------

    def find(self, board: BoardIdentity) -> None:
        self._sought = board

    def find_lost(self, board: BoardIdentity, adapter: str) -> None:
        self.memory.set_lost(board, self._records.of_other_number(board, adapter))

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

    def record_change(self) -> None:
        pass

    @contextmanager
    def _saving(self, what: str) -> Iterator[None]:
        """Warn once that files cannot be saved. The board is written all the same."""
        try:
            yield
        except SettingsError as error:
            if not self._is_failing:
                self._warn(f"{what} not remembered. {error}")
            self._is_failing = True
