"""Records of the settings last applied to each board.

A record is a settings file with the last applied parameters and the calibrations of both input
sources. A board shows only the calibrations of the active source. Comments in the header contain
the times when these values were applied or read, the result of the serial timeout trial, and the
adapter. Two boards may share a record. Only a different adapter reveals this.
"""

import re
from collections.abc import Collection, Mapping
from contextlib import suppress
from dataclasses import dataclass, field, replace
from datetime import UTC, datetime
from pathlib import Path
from typing import TypeVar

from trex_gui.core.files import SettingsError, data_folder, file_exists, load
from trex_gui.devices.trex.driving.timeout_stop import TimeoutTrial
from trex_gui.devices.trex.protocol.calibration import Calibration, CalibrationKey
from trex_gui.devices.trex.protocol.device_table import HIGHEST_WIRE
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.devices.trex.settings.comparison import Comparison, compare
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.edit_files import BoardIdentity, replace_file, settings_of_board
from trex_gui.devices.trex.settings.writer import write_settings

_TITLE = "Settings that this computer last applied to a board"
_HEADER = re.compile(
    r"^# (parameters|rc calibrations|analog calibrations): (applied|read) (\S+)$", re.MULTILINE
)
_ADAPTER = re.compile(r"^# adapter: (\S+)$", re.MULTILINE)
_TRIAL = re.compile(
    r"^# serial timeout: (stopped the motors|failed), uart_error_shutdown (on|off)\b", re.MULTILINE
)
_PARAMETERS = "parameters"
_K = TypeVar("_K")
_V = TypeVar("_V")
_NEVER = datetime.min.replace(tzinfo=UTC)


@dataclass(frozen=True, slots=True)
class Provenance:
    """Time and kind of the last operation that confirmed values."""

    time: datetime  # in UTC
    is_applied: bool  # False if the values were only read


@dataclass(frozen=True, slots=True)
class BoardRecord:
    settings: Settings
    applied: datetime | None = None  # time when parameters were last applied; `None`: never
    provenance: Mapping[InputSource, Provenance] = field(default_factory=dict)  # of calibrations
    adapter: str = ""  # key of the last adapter; empty if unknown
    trial: TimeoutTrial | None = None  # serial timeout trial; `None`: never tried

    @property
    def time(self) -> datetime | None:
        """Time when values of the record were last applied or read, or `None` for never."""
        times = [provenance.time for provenance in self.provenance.values()]
        return max([*times, self.applied] if self.applied else times, default=None)

    def calibrations(self, source: InputSource) -> dict[CalibrationKey, Calibration]:
        calibrations = self.settings.calibrations
        return {key: value for key, value in calibrations.items() if key.source is source}

    def applied_to(self, stored: Settings) -> Settings:
        """Return the applied settings, without calibrations that the board hides."""
        applied = {
            key: value
            for key, value in self.settings.calibrations.items()
            if key in stored.calibrations and self.provenance[key.source].is_applied
        }
        return replace(self.settings, firmware=stored.firmware, calibrations=applied)

    def differences(self, stored: Settings) -> Comparison:
        if self.applied is None:
            return Comparison(())
        rows = compare(stored, self.applied_to(stored)).rows
        return Comparison(tuple(row for row in rows if row.changed))

    def after_reading(self, stored: Settings, source: InputSource, now: datetime) -> "BoardRecord":
        """Add the calibrations of `source`, unless different calibrations were applied."""
        provenance = self.provenance.get(source)
        if provenance is not None and provenance.is_applied:
            if self.calibrations(source) != stored.calibrations:
                return self
            return replace(self, provenance={**self.provenance, source: Provenance(now, True)})
        calibrations = {**self.settings.calibrations, **stored.calibrations}
        return replace(
            self,
            settings=replace(self.settings, calibrations=calibrations),
            provenance={**self.provenance, source: Provenance(now, False)},
        )

    def before_writing(self, keys: Collection[str]) -> "BoardRecord":
        """Remove the values that a write may change."""
        return replace(self, settings=self.settings.without(keys))

    def after_writing(
        self, stored: Settings, source: InputSource, uncertain: Collection[str], now: datetime
    ) -> "BoardRecord":
        """Add stored values that the record lacks, and remove the `uncertain` keys.

        Applied values remain, even if the board has lost them.
        """
        was_applied = source in self.provenance and self.provenance[source].is_applied
        earlier = self.settings.calibrations if was_applied else {}
        others = {k: c for k, c in self.settings.calibrations.items() if k.source is not source}
        record = BoardRecord(
            replace(
                self.settings,
                firmware=stored.firmware,
                parameters={**stored.parameters, **self.settings.parameters},
                calibrations={**others, **stored.calibrations, **earlier},
            ),
            now,
            {**self.provenance, source: Provenance(now, True)},
            self.adapter,
            self.trial,
        )
        return record.before_writing(uncertain)

    def accepting(self, stored: Settings, source: InputSource, now: datetime) -> "BoardRecord":
        """Replace the applied values with the stored values."""
        keys = {*self.settings.parameters, *self.calibrations(source)}
        return self.before_writing(keys).after_writing(stored, source, (), now)

    def after_reset(self) -> "BoardRecord":
        """Remove the parameters, because a reset changes them."""
        return replace(self, settings=replace(self.settings, parameters={}), applied=None)

    def with_notes(self, notes: Mapping[str, str]) -> "BoardRecord":
        return replace(self, settings=replace(self.settings, notes=notes))

    def merged_with(self, earlier: "BoardRecord") -> "BoardRecord":
        """Add notes and calibrations that were recorded under an earlier device number."""
        old, new = earlier.settings, self.settings
        calibrations = {**old.calibrations, **new.calibrations}
        return replace(
            self,
            settings=replace(new, calibrations=calibrations, notes={**old.notes, **new.notes}),
            provenance={**earlier.provenance, **self.provenance},
            trial=self.trial or earlier.trial,
        )

    def with_changes(self, before: "BoardRecord", after: "BoardRecord") -> "BoardRecord":
        """Apply the changes from `before` to `after`.

        Calibrations that another program has applied are retained if `after` only read some.
        """
        mine, old, new = self.settings, before.settings, after.settings
        retained = {
            source: provenance
            for source, provenance in self.provenance.items()
            if provenance.is_applied
            and provenance != before.provenance.get(source)
            and not after.provenance.get(source, provenance).is_applied
        }
        applied = {k: c for k, c in mine.calibrations.items() if k.source in retained}
        calibrations = _merged(mine.calibrations, old.calibrations, new.calibrations)
        return BoardRecord(
            replace(
                new,
                parameters=_merged(mine.parameters, old.parameters, new.parameters),
                calibrations={**calibrations, **applied},
                notes=_merged(mine.notes, old.notes, new.notes),
            ),
            self.applied if after.applied == before.applied else after.applied,
            {**_merged(self.provenance, before.provenance, after.provenance), **retained},
            self.adapter if after.adapter == before.adapter else after.adapter,
            self.trial if after.trial == before.trial else after.trial,
        )

    def with_hidden(self, stored: Settings, source: InputSource) -> tuple[Settings, list[str]]:
        """Return `stored` with the notes, and with the calibrations that the board hides.

        Also returns header lines with the times of these calibrations.
        """
        hidden = {k: c for k, c in self.settings.calibrations.items() if k.source is not source}
        lines = [
            _header_line(_source_name(key), provenance)
            for key, provenance in self.provenance.items()
            if key is not source
        ]
        calibrations = {**stored.calibrations, **hidden}
        complete = replace(stored, calibrations=calibrations, notes=self.settings.notes)
        return complete, lines if hidden else []


def _merged(mine: Mapping[_K, _V], before: Mapping[_K, _V], after: Mapping[_K, _V]) -> dict[_K, _V]:
    retained = {key: value for key, value in mine.items() if key in after or key not in before}
    return {**retained, **{k: value for k, value in after.items() if before.get(k) != value}}


class BoardRecords:
    """Folder of board records, created when the first record is saved.

    Another program may save the same record. Therefore, `save` writes only the changes since the
    last `load` or `save` of this object.
    """

    def __init__(self, folder: Path | None = None) -> None:
        self.folder = folder or data_folder() / "boards"
        self._last: dict[BoardIdentity, BoardRecord | None] = {}  # last loaded or saved

    def path(self, board: BoardIdentity) -> Path:
        return self.folder / f"{board}.txt"

    def save(self, board: BoardIdentity, record: BoardRecord | None) -> None:
        """Save the changes of a board's record. `None` removes it.

        If saving raises a SettingsError, the old record remains.
        """
        merged, before, now = record, self._last.get(board), None
        if record is not None:
            with suppress(SettingsError):
                now = self._read(board)
            if now is not None and now != before:
                before = before or BoardRecord(Settings(board.product, board.firmware))
                merged = now.with_changes(before, record)
        replace_file(self.path(board), None if merged is None else _text(merged))
        self._last[board] = record

    def load(self, board: BoardIdentity) -> BoardRecord | None:
        """Return the record of a board, or `None` if it has no record.

        A damaged file is renamed to `….damaged`, so its notes survive the next `save`.

        Raises:
            SettingsError: the file cannot be read, is damaged, or belongs to another model.
        """
        self._last[board] = None
        self._last[board] = record = self._read(board)
        return record

    def _read(self, board: BoardIdentity) -> BoardRecord | None:
        path = self.path(board)
        if not file_exists(path):
            return None
        data = load(path)
        try:
            return _record(settings_of_board(data, path, board), data.decode("utf-8-sig"))
        except SettingsError:
            with suppress(OSError):
                path.replace(path.with_name(f"{path.name}.damaged"))
            raise

    def of_other_number(self, board: BoardIdentity, adapter: str) -> BoardRecord | None:
        """Return the newest record with this adapter and another device number."""
        records: list[BoardRecord] = []
        for number in range(HIGHEST_WIRE + 1):
            if number == board.device_number:
                continue
            with suppress(SettingsError):
                record = self._read(replace(board, device_number=number))
                if record is not None and record.applied is not None and record.adapter == adapter:
                    records.append(record)
        return max(records, key=lambda record: record.applied or _NEVER, default=None)


def has_factory_line(stored: Settings) -> bool:
    """Return True if the device number and the UART settings have their defaults."""
    keys = ParameterKey.DEVICE_NUMBER, ParameterKey.UART_SETTINGS
    return all(stored.parameters.get(key) == stored.specs[key].default for key in keys)


def _header_line(name: str, provenance: Provenance) -> str:
    verb = "applied" if provenance.is_applied else "read"
    return f"{name}: {verb} {provenance.time.isoformat()}"


def _text(record: BoardRecord) -> str:
    lines = [_TITLE]
    if record.applied is not None:
        lines.append(_header_line(_PARAMETERS, Provenance(record.applied, True)))
    lines += [_header_line(_source_name(key), value) for key, value in record.provenance.items()]
    if (trial := record.trial) is not None:
        result = "stopped the motors" if trial.stopped else "failed"
        shutdown = "on" if trial.shutdown else "off"
        lines.append(f"serial timeout: {result}, uart_error_shutdown {shutdown}")
    if record.adapter:
        lines.append(f"adapter: {record.adapter}")
    return write_settings(record.settings, title_lines=lines)


def _source_name(source: InputSource) -> str:
    return f"{source.value.casefold()} calibrations"


def _record(settings: Settings, text: str) -> BoardRecord:
    """Create a record. Values without a valid header line count as unknown."""
    times: dict[str, Provenance] = {}
    for name, verb, stamp in _HEADER.findall(text):
        with suppress(ValueError, OverflowError):
            time = datetime.fromisoformat(stamp).astimezone(UTC)
            if 1970 < time.year < 9999:  # other years cannot be shown in every time zone
                times[name] = Provenance(time, verb == "applied")
    names = {source: _source_name(source) for source in InputSource}
    provenance = {source: times[name] for source, name in names.items() if name in times}
    calibrations = {key: c for key, c in settings.calibrations.items() if key.source in provenance}
    applied, adapter, trial = times.get(_PARAMETERS), _ADAPTER.search(text), _TRIAL.search(text)
    parameters = {} if applied is None else settings.parameters
    return BoardRecord(
        replace(settings, parameters=parameters, calibrations=calibrations),
        None if applied is None else applied.time,
        provenance,
        "" if adapter is None else adapter[1],
        None if trial is None else TimeoutTrial(trial[1] != "failed", trial[2] == "on"),
    )


def utc_now() -> datetime:
    return datetime.now(UTC).replace(microsecond=0)
