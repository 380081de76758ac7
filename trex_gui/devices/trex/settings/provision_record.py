"""CSV record of the boards that were set up."""

import csv
import hashlib
import io
from collections.abc import Collection
from dataclasses import asdict, dataclass, fields, replace
from datetime import datetime
from pathlib import Path
from typing import Any

from trex_gui.core.errors import BadRequest
from trex_gui.core.files import load, save_over
from trex_gui.core.translation import tr
from trex_gui.devices.trex.discovery import NUMBERS
from trex_gui.devices.trex.protocol.connection_settings import FACTORY_NUMBER
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.devices.trex.settings.comparison import Comparison, ComparisonRow
from trex_gui.devices.trex.settings.document import Settings

NEW, KNOWN, NUMBER_ONLY = "new", "known", "number only"  # certainty of a board's identity
BEGUN, SKIPPED = "begun", "skipped"  # results
ENDED_IN_MOTOR_TEST = "ended during the motor test"


@dataclass(frozen=True, slots=True)
class ProvisionedBoard:
    time: str  # local time, with its offset from UTC
    name: str
    number: int  # device number that the board has, or may have
    board: str  # model and firmware
    calibrations: str  # hash of the calibrations, because boards have no serial number
    differences: str  # keys of the settings to write, separated by spaces
    result: str  # ok or differs, with details; skipped; begun; or an error
    certainty: str  # `NEW`, `KNOWN`, or `NUMBER_ONLY`

    @classmethod
    def of(cls, row: dict[str, Any]) -> "ProvisionedBoard":
        return cls(**{**row, "number": int(row["number"])})


_COLUMNS = [field.name for field in fields(ProvisionedBoard)]


class ProvisionRecord:
    """Boards with their device numbers and names. No number is assigned twice."""

    def __init__(self, file: Path, *, name: str = "robot {number}", first: int = 1) -> None:
        """Open or create the file.

        A new board gets the next free number, starting at `first`. Its name is `name`, with the
        device number in place of `{number}`.

        Raises:
            StudioError: the file cannot be used.
        """
        self._file, self._name, self._first = file, name, first
        self._rows: list[ProvisionedBoard] = []
        self._saved = load(file, "records") if file.exists() else b""
        try:
            reader = csv.DictReader(io.StringIO(self._saved.decode("utf-8-sig"), newline=""))
            if self._saved and reader.fieldnames != _COLUMNS:
                text = tr("{0} is not a record of boards. Select another file.")
                raise BadRequest(text.format(file))
            self._rows = [ProvisionedBoard.of(row) for row in reader]
        except (TypeError, ValueError, csv.Error) as error:
            if isinstance(error, BadRequest):
                raise
            raise BadRequest(tr("{0} is damaged: {1}.").format(file, error)) from error
        self.save()

    def propose(
        self, stored: Settings, board: str, differing: Collection[ComparisonRow]
    ) -> ProvisionedBoard:
        """Return a row for a board. A new board gets a free number and a name.

        Raises:
            BadRequest: the device number was not read, or no number is free.
        """
        if (key := ParameterKey.DEVICE_NUMBER) not in stored.parameters:
            raise BadRequest(f"{stored.specs[key].name}: {tr('not read')}")
        number, calibrations = stored.parameters[key], fingerprint(stored)
        known = self._known(number)
        assigned = self.free_number() if known is None else number
        certainty = NEW
        if known is not None:
            certainty = KNOWN if known.calibrations == calibrations else NUMBER_ONLY
        keys = [str(row.key) for row in differing]
        if assigned != number:
            keys.append(ParameterKey.DEVICE_NUMBER)
        return ProvisionedBoard(
            datetime.now().astimezone().isoformat(timespec="seconds"),
            known.name if known else self._name.replace("{number}", str(assigned)),
            assigned,
            board,
            calibrations,
            " ".join(keys),
            BEGUN,
            certainty,
        )

    def skipped(self, board: ProvisionedBoard, stored: Settings) -> ProvisionedBoard:
        number = stored.parameters[ParameterKey.DEVICE_NUMBER]
        known = self._known(number)
        calibrations = known.calibrations if known else board.calibrations
        return replace(board, number=number, calibrations=calibrations, result=SKIPPED)

    def _known(self, number: int) -> ProvisionedBoard | None:
        """Return the newest row of the board with this number, ignoring skipped boards."""
        rows = (row for row in reversed(self._rows) if row.result != SKIPPED)
        return next((row for row in rows if row.number == number != FACTORY_NUMBER), None)

    def free_number(self) -> int:
        """Return an unassigned number. Raises BadRequest if all numbers are assigned."""
        assigned = {FACTORY_NUMBER, *(row.number for row in self._rows)}
        numbers: list[int] = [*range(self._first, NUMBERS), *range(self._first)]
        for number in numbers:
            if number not in assigned:
                return number
        text = tr("All {0} device numbers are already used in {1}.")
        raise BadRequest(text.format(NUMBERS, self._file))

    def add(self, row: ProvisionedBoard) -> None:
        """Add a row, or replace the last row if it is `BEGUN`. Does not save the file."""
        if self._rows and self._rows[-1].result == BEGUN:
            self._rows.pop()
        self._rows.append(row)

    def save(self) -> None:
        """Write the file. If this raises a StudioError, the file is unchanged."""
        table = io.StringIO(newline="")
        writer = csv.DictWriter(table, _COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(map(asdict, self._rows))
        content = table.getvalue().encode("utf-8")
        if not save_over(self._file, content, self._saved):
            text = tr(
                "Another program has changed {0}. Nothing was saved. Start again to continue "
                "this record."
            )
            raise BadRequest(text.format(self._file))
        self._saved = content


def differing(comparison: Comparison) -> tuple[ComparisonRow, ...]:
    """Return the changes without the device number, which the record assigns."""
    return tuple(
        row for row in comparison.rows if row.changed and row.key != ParameterKey.DEVICE_NUMBER
    )


def fingerprint(stored: Settings) -> str:
    """Return a hash of the calibrations that a board shows, as 8 hexadecimal digits."""
    return hashlib.sha256(repr(sorted(stored.calibrations.items())).encode()).hexdigest()[:8]


def result_text(target: Settings, stored: Settings, remaining: Collection[ComparisonRow]) -> str:
    """Return the result for a board. `remaining` contains the settings that still differ."""
    if remaining:
        return f"differs: {' '.join(row.key for row in remaining)}"
    hidden = " ".join(key for key in target.calibrations if key not in stored.calibrations)
    return f"ok, without {hidden}" if hidden else "ok"
