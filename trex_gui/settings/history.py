"""Snapshots: what a board was set to before each change, kept so that nothing is lost.

A snapshot is a settings file like any other, whose head says when, why and of which board it was
taken. Files in the folder that are no snapshots are left alone.
"""

import os
import re
from collections.abc import Iterator
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path

import platformdirs

from trex_gui.settings.document import Settings
from trex_gui.settings.errors import Finding, SettingsError
from trex_gui.settings.files import load, save
from trex_gui.settings.reader import read_settings
from trex_gui.settings.writer import write_settings

KEPT = 500
"""How many snapshots are kept unless the person says otherwise: a megabyte or two."""

_NAME = re.compile(r"(\d{8}T\d{6}Z)-(?:(\d+)-)?[a-z]+-[\d.]+\.txt")
_TIME = "%Y%m%dT%H%M%SZ"
_HEAD_LINES = 12
_NOTE = re.compile(r"# (taken|device number|adapter|reason): (.*)")


@dataclass(frozen=True, slots=True)
class Snapshot:
    """One file of the history; what it holds is read by `History.load`.

    Attributes:
        path: the file.
        taken: when, in UTC; the order of the history, with `turn` within a second.
        turn: 1 for the first of a second.
        product, firmware: of which board, as the file says; empty where it cannot be read.
        device_number: the board's number then; `None` when the file does not say.
        adapter: through which port, for people.
        reason: what it was taken before.
    """

    path: Path
    taken: datetime
    turn: int
    product: str = ""
    firmware: str = ""
    device_number: int | None = None
    adapter: str = ""
    reason: str = ""


def default_folder() -> Path:
    """Return the folder of this program's data on this system; it need not exist.

    `TREX_STUDIO_DATA` in the environment names another place than the system's.
    """
    given = os.environ.get("TREX_STUDIO_DATA")
    data = given or platformdirs.user_data_dir("TReX Studio", appauthor=False)
    return Path(data).absolute() / "snapshots"


class History:
    """The snapshots in one folder, the newest `kept` of them.

    Only the bound that the person has set removes snapshots, the oldest first and never the
    one that was just taken.

    Attributes:
        folder: where they lie; made with the first one.
        kept: how many are kept, at least 1; `None` for all.
    """

    def __init__(self, folder: Path | None = None, *, kept: int | None = KEPT) -> None:
        if kept is not None and kept < 1:
            raise ValueError(f"a history keeps at least one snapshot, not {kept}")
        self.folder = folder or default_folder()
        self.kept = kept

    def take(
        self, settings: Settings, *, adapter: str, reason: str, now: datetime | None = None
    ) -> Snapshot:
        """Save what a board is set to.

        Args:
            settings: everything that is known of it.
            adapter: through which port it was read, for people.
            reason: what comes next, such as `Apply of 3 settings`.
            now: the time, if it is not the present.

        Raises:
            SettingsError: it cannot be saved; then nothing must be written to the board.
        """
        taken = (now or datetime.now(UTC)).astimezone(UTC).replace(microsecond=0)
        try:
            self.folder.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            why = f"the folder for snapshots cannot be made: {error.strerror or error}"
            raise SettingsError(str(self.folder), [Finding(None, None, why)]) from error
        firmware = settings.firmware or settings.product.firmware[-1]
        turn = 1
        while (path := self._path(taken, turn, settings.product.key, firmware)).exists():
            turn += 1
        number = settings.parameters.get("device_number")
        notes = {
            "taken": taken.isoformat(),
            "device number": "" if number is None else str(number),
            "adapter": adapter,
            "reason": reason,
        }
        lines = [f"{name}: {' '.join(text.split())}" for name, text in notes.items() if text]
        save(path, write_settings(settings, title_lines=lines))
        self._remove_oldest(but=path)
        return Snapshot(path, taken, turn, settings.product.name, firmware, number, adapter, reason)

    def snapshots(self) -> tuple[Snapshot, ...]:
        """Return all snapshots, the newest first; one that cannot be read is there too."""
        found = [_look_at(path, match) for path, match in self._files()]
        return tuple(sorted(found, key=_age, reverse=True))

    def load(self, snapshot: Snapshot) -> Settings:
        """Return what a snapshot holds.

        Raises:
            SettingsError: the file is gone or was damaged; says where.
        """
        settings, _ = read_settings(load(snapshot.path), str(snapshot.path))
        return settings

    def remove(self, snapshot: Snapshot) -> None:
        """Remove a snapshot because a person wants it; one that is gone already is no error.

        Raises:
            SettingsError: it cannot be removed.
        """
        try:
            snapshot.path.unlink(missing_ok=True)
        except OSError as error:
            why = f"it cannot be removed: {error.strerror or error}"
            raise SettingsError(str(snapshot.path), [Finding(None, None, why)]) from error

    def _path(self, taken: datetime, turn: int, model: str, firmware: str) -> Path:
        again = "" if turn == 1 else f"{turn}-"
        return self.folder / f"{taken.strftime(_TIME)}-{again}{model}-{firmware}.txt"

    def _files(self) -> Iterator[tuple[Path, re.Match[str]]]:
        try:
            paths = list(self.folder.iterdir())
        except OSError:  # not made yet, or not ours to read
            return
        for path in paths:
            if match := _NAME.fullmatch(path.name):
                yield path, match

    def _remove_oldest(self, *, but: Path) -> None:
        """Keep to the bound; a file that cannot be removed stays."""
        if self.kept is None:
            return
        others = [
            Snapshot(path, taken, turn)
            for path, match in self._files()
            if path != but and (when := _when(match))
            for taken, turn in (when,)
        ]
        others.sort(key=_age, reverse=True)
        for snapshot in others[self.kept - 1 :]:
            try:
                snapshot.path.unlink(missing_ok=True)
            except OSError:
                continue


def _age(snapshot: Snapshot) -> tuple[datetime, int]:
    return snapshot.taken, snapshot.turn


def _when(match: re.Match[str]) -> tuple[datetime, int]:
    try:
        taken = datetime.strptime(match[1], _TIME).replace(tzinfo=UTC)
    except ValueError:  # digits that are no date
        taken = datetime.fromtimestamp(0, UTC)
    return taken, int(match[2] or 1)


def _look_at(path: Path, match: re.Match[str]) -> Snapshot:
    """Read the head of a snapshot, as far as it can be read."""
    taken, turn = _when(match)
    try:
        with path.open(encoding="utf-8", errors="replace") as file:
            head = [line.rstrip("\n") for _, line in zip(range(_HEAD_LINES), file, strict=False)]
    except OSError:
        head = []
    notes = {found[1]: found[2] for line in head if (found := _NOTE.fullmatch(line))}
    values = dict(line.split(": ", 1) for line in head if re.match(r"(product|firmware): ", line))
    number = notes.get("device number", "")
    return Snapshot(
        path,
        taken,
        turn,
        values.get("product", ""),
        values.get("firmware", ""),
        int(number) if number.isascii() and number.isdigit() and len(number) <= 3 else None,
        notes.get("adapter", ""),
        notes.get("reason", ""),
    )
