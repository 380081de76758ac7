"""The record of the boards that were set up: a CSV file with a line for each."""

import csv
import io
from dataclasses import asdict, dataclass, fields
from pathlib import Path
from typing import Any

from trex_gui.core.errors import BadRequest
from trex_gui.core.files import load, save_over
from trex_gui.devices.trex.discovery import NUMBERS

FACTORY_NUMBER = 7  # given to no board, so that one that has it is new
BEGUN, SKIPPED = "begun", "skipped"  # results


@dataclass(frozen=True, slots=True)
class ProvisionedBoard:
    """A line of the record."""

    time: str  # local, with the offset to UTC
    name: str
    number: int  # that the board has, or may have
    board: str  # model and firmware
    calibrations: str  # a hash of them: boards have no serial number
    differences: str  # keys of what was to be written
    result: str  # begins with ok, or is skipped, begun, or what went wrong
    certainty: str  # new, known, or number only

    @classmethod
    def of(cls, row: dict[str, Any]) -> "ProvisionedBoard":
        return cls(**{**row, "number": int(row["number"])})


_COLUMNS = [field.name for field in fields(ProvisionedBoard)]


class ProvisionRecord:
    """Every change is saved at once. A number that was given is never given again."""

    def __init__(self, file: Path) -> None:
        """Raise a StudioError if the file cannot be used."""
        self._file = file
        self._rows: list[ProvisionedBoard] = []
        self._saved = load(file, "records") if file.exists() else b""
        try:
            reader = csv.DictReader(io.StringIO(self._saved.decode("utf-8-sig"), newline=""))
            if self._saved and reader.fieldnames != _COLUMNS:
                raise BadRequest(f"{file} is no record of this command; name another one.")
            self._rows = [ProvisionedBoard.of(row) for row in reader]
        except (TypeError, ValueError, csv.Error) as error:
            if isinstance(error, BadRequest):
                raise
            raise BadRequest(f"{file} is damaged: {error}.") from error
        self.save()

    def known(self, number: int) -> ProvisionedBoard | None:
        """Return the newest line of the board that was given this number."""
        given = (row for row in reversed(self._rows) if row.result != SKIPPED)
        return next((row for row in given if row.number == number != FACTORY_NUMBER), None)

    def free_number(self, first: int) -> int:
        taken = {FACTORY_NUMBER, *(row.number for row in self._rows)}
        numbers: list[int] = [*range(first, NUMBERS), *range(first)]
        for number in numbers:
            if number not in taken:
                return number
        raise BadRequest(f"All {NUMBERS} device numbers are in {self._file}.")

    def put(self, row: ProvisionedBoard) -> None:
        """Add a line, in place of the last one if that has begun. Call `save` then."""
        if self._rows and self._rows[-1].result == BEGUN:
            self._rows.pop()
        self._rows.append(row)

    def save(self) -> None:
        """Write the file. After a StudioError it is as before."""
        text = io.StringIO(newline="")
        writer = csv.DictWriter(text, _COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(map(asdict, self._rows))
        content = text.getvalue().encode("utf-8")
        if not save_over(self._file, content, self._saved):
            raise BadRequest(f"Another program has changed {self._file}: end this one, look at it.")
        self._saved = content
