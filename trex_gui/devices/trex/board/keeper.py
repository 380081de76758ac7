"""Saved records of a board and writes to it, for programs without a window."""

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

Notify = Callable[[str], None]


def read_record(
    board: BoardIdentity, warn: Notify, records: BoardRecords | None = None
) -> BoardRecord | None:
    """Return the saved record of a board. `None` if it is missing or damaged."""
    try:
        return (records or BoardRecords()).load(board)
    except SettingsError as error:
        warn(f"The settings last applied to this board are unknown. {error}")
        return None


class Keeper:
    """Snapshots, record and accepted values of a board. The files are read when first needed."""

    def __init__(self, inform: Notify, warn: Notify) -> None:
        """`inform` receives messages about saved files. `warn` receives messages about failures."""
        self._inform, self._warn = inform, warn
        self._records = BoardRecords()
        self._is_failing = False
        self._requested: BoardIdentity | None = None
        self.memory = BoardMemory(self)

    def load(self) -> None:
        board, self._requested = self._requested, None
        if board is not None:
            self.memory.handle_record(board, read_record(board, self._warn, self._records))

    def prepare(
        self,
        state: DeviceState,
        link: ConnectionSettings,
        reason: str,
        parameters: Sequence[tuple[str, int]],
        calibrations: Sequence[tuple[CalibrationKey, Calibration]] = (),
    ) -> WriteTransaction:
        """Save a snapshot, then clear the expected values.

        Raises:
            SettingsError: the snapshot cannot be saved, so nothing may be written.
        """
        self.load()
        values = tuple(parameters), tuple(calibrations)
        transaction = WriteTransaction(self.memory, state, link, values, reason=reason)
        history = SettingsHistory()
        snapshot = transaction.save_snapshot(history)
        self._inform(f"Snapshot of the previous settings: {snapshot.path}.")
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
        progress: Progress = lambda _done, _total, _next: None,
        cancelled: Callable[[], bool] = lambda: False,
    ) -> tuple[WriteResult, ...]:
        """Save a snapshot, write, and record the applied values. See `write_all`.

        Raises:
            BadRequest: another board has the device number, so nothing was written.
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
        """Save a snapshot, yield a function for trial writes, then restore the settings.

        The record expects the previous values throughout. If the program or the line fails, the
        next connection shows the differences.
        """
        before, record = settings_of(state), self.memory.record
        assert record is not None  # noqa: S101 - loaded by the caller
        self.prepare(state, client.settings, reason, ()).finish((), state, utc_now())
        try:
            yield partial(write_parameter, client.request, has_crc=client.has_crc)
        finally:
            try:
                now = read_everything(client.request, has_crc=client.has_crc)
                rows = [row for row in compare(settings_of(now), before).rows if row.changed]
                if now.signature != state.signature or len(rows) > 3:  # too many for stray writes
                    raise OtherBoard(ErrorCode.TOO_MANY_DIFFER, len(rows))
                for result in write_all(
                    client.request, state.specs, *values_to_write(rows), has_crc=client.has_crc
                ):
                    if result.error is not None:
                        raise result.error
                self.memory.restore(record)
            except StudioError as error:
                self._inform(f"The settings in the board may have changed. {error}")
                self._inform("`trexcmd diff --last` shows the differences.")
                self._inform("The snapshot contains the previous settings.")

    # --- Requests of the memory (`Files`) -----------------------------------------------

    def find(self, board: BoardIdentity) -> None:
        self._requested = board

    def find_lost(self, board: BoardIdentity, adapter: str) -> None:
        self.memory.set_lost(board, self._records.of_other_number(board, adapter))

    def save(self, board: BoardIdentity, record: BoardRecord | None) -> None:
        with self._saving("The applied settings"):
            self._records.save(board, record)

    def move(
        self, old: BoardIdentity, new: BoardIdentity, record: BoardRecord, *, keeps_old: bool
    ) -> None:
        with self._saving("The applied settings"):
            if (renamed := put_aside(self._records.path(new))) is not None:
                self._inform(
                    f"The record of another board with this device number is in {renamed}."
                )
            self._records.save(new, record)
            if not keeps_old:
                self._records.save(old, None)

    def add_accepted(self, kind: Signature, values: Mapping[str, int]) -> None:
        with self._saving("The values that the board accepted"):
            AcceptedValues().add(kind, values)
            names = ", ".join(f"{key} {wire}" for key, wire in values.items())
            self._inform(f"Recorded as accepted by a {kind}: {names}.")

    def warn_doubtful(self, record: BoardRecord) -> None:
        self._warn(DOUBTED.format(record.settings.product.name, f"{record.time:%Y-%m-%d}"))

    def show_notes(self, notes: Mapping[str, str] | None, board: BoardIdentity) -> None:
        pass

    def record_change(self) -> None:
        pass

    @contextmanager
    def _saving(self, values: str) -> Iterator[None]:
        """Warn once if files cannot be saved. The write to the board continues."""
        try:
            yield
        except SettingsError as error:
            if not self._is_failing:
                self._warn(f"{values} were not saved. {error}")
            self._is_failing = True
