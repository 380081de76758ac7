"""A transcript as text: a row a line, columns parted by tabs, for people and for spreadsheets."""

from collections.abc import Iterable
from dataclasses import dataclass
from datetime import datetime
from typing import TextIO


@dataclass(frozen=True, slots=True)
class TrafficRow:
    """One row: when (seconds since 1970), what went which way, how long it took, what it means.

    `sent` and `received` are bytes as a person reads them; `seconds` is `None` without an answer.
    """

    time: float
    sent: str
    received: str
    seconds: float | None
    words: str
    is_fault: bool

    def text(self) -> str:
        """Return the row as one line without its end."""
        moment = datetime.fromtimestamp(self.time).astimezone()
        took = "" if self.seconds is None else f"{self.seconds * 1e3:.1f}"
        mark = "!" if self.is_fault else ""
        when = moment.isoformat(sep=" ", timespec="milliseconds")
        return "\t".join([when, mark, self.sent, self.received, took, self.words])


HEAD = "\t".join(["time", "fault", "sent", "received", "took_ms", "meaning"])


def write_traffic(file: TextIO, about: Iterable[str], rows: Iterable[TrafficRow]) -> int:
    """Write comment lines, the names of the columns, and rows; return how many rows."""
    file.writelines(f"# {line}\n" for line in about)
    file.write(f"{HEAD}\n")
    count = 0
    for row in rows:
        file.write(f"{row.text()}\n")
        count += 1
    return count
