"""Snapshots of a board's stored settings, saved before each change.

A snapshot is a settings file. Comments in its header contain the time, the reason and the board. A
text file in the same folder limits the number of snapshots for all programs. Other files in the
folder are not changed.
"""

import os
import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from datetime import UTC, datetime
from pathlib import Path

from trex_gui.core.errors import BadRequest
from trex_gui.core.files import data_folder, explained, load, open_ordinary, save, save_new
from trex_gui.core.translation import tr
from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.notes import clean_note
from trex_gui.devices.trex.settings.reader import read_settings
from trex_gui.devices.trex.settings.writer import write_settings

DEFAULT_LIMIT = 500  # snapshots; together they need one or two megabytes
_NAME = re.compile(r"(\d{8}T\d{6}Z)-(?:(\d+)-)?[a-z]+-[\d.]+\.txt")
_TIME = "%Y%m%dT%H%M%SZ"
_NO_DATE = datetime.fromtimestamp(0, UTC)
_HEADER_BYTES = 4096
_HEADER_LINES = 12
_MAX_LENGTH = {"name": 60, "note": 300}  # characters
_DETAIL = re.compile(r"# (taken|device number|adapter|reason|name|note): (.*)")
_VALUE = re.compile(r"(product|firmware): *['\"]?([^'\"#]*[^'\"# ])")

LIMIT_FILE = "history.txt"
_MAX_LIMIT_FILE = 4096  # bytes
_LIMIT = re.compile(r"kept\s*:\s*(all|[1-9][0-9]{0,6})")
_LIMIT_TEXT = """\
# How many snapshots TReX Studio and trexcmd keep in this folder: a number, or all.
# If this file is invalid, no snapshot is removed.
kept: {}
"""


Stamp = tuple[int, int]  # modification time (ns) and size of a file; (0, 0) if unknown
SnapshotFile = tuple[datetime, int, str]  # sort key: time, number within the second, file name


@dataclass(frozen=True, slots=True)
class Snapshot:
    path: Path
    taken: datetime  # in UTC
    product: str = ""  # empty if unreadable
    firmware: str = ""  # empty if unreadable or not given
    device_number: int | None = None
    adapter: str = ""  # port of the board, for the user
    reason: str = ""  # the operation that followed
    problem: str = ""  # why the header is unusable; empty if it is usable
    name: str = ""  # from the user; a snapshot with a name is never removed automatically
    note: str = ""  # from the user
    stamp: Stamp = field(default=(0, 0), compare=False)


@dataclass(frozen=True, slots=True)
class Limit:
    """Number of snapshots to keep, as read from the limit file.

    `count` is at least 1, or `None` to keep all snapshots. If the file cannot be used, `problem`
    is a sentence that explains the cause, and no snapshot is removed.
    """

    count: int | None = DEFAULT_LIMIT
    problem: str = ""


class SettingsHistory:
    """Folder of snapshots, created when the first snapshot is saved.

    If there are more snapshots than the user's limit, the oldest are removed. Snapshots with a name
    are removed only on request.
    """

    def __init__(self, folder: Path | None = None) -> None:
        self.folder = folder or data_folder() / "snapshots"

    def save(
        self,
        settings: Settings,
        *,
        adapter: str,
        reason: str,
        remarks: Sequence[str] = (),
        now: datetime | None = None,
    ) -> Snapshot:
        """Save the settings of a board before an operation.

        `reason` names the operation, such as `Apply of 3 settings`. `remarks` are additional
        comments for the header.

        Raises:
            SettingsError: saving failed. The caller must not write to the board.
        """
        taken = (now or datetime.now(UTC)).astimezone(UTC).replace(microsecond=0)
        self._create_folder()
        firmware = settings.firmware or settings.product.firmware[-1]
        number = settings.parameters.get(ParameterKey.DEVICE_NUMBER)
        details = {
            "taken": taken.isoformat(),
            "device number": "" if number is None else str(number),
            "adapter": adapter,
            "reason": reason,
        }
        lines = [f"{name}: {' '.join(text.split())}" for name, text in details.items() if text]
        text = write_settings(settings, title_lines=[*lines, *remarks])
        index = 1
        while not save_new(path := self._path(taken, index, settings.product.key, firmware), text):
            index += 1
        self._remove_oldest(path)
        return Snapshot(path, taken, settings.product.name, firmware, number, adapter, reason)

    def snapshots(self) -> tuple[Snapshot, ...]:
        """Return all snapshots, newest first, including unreadable ones."""
        return tuple(self.read_header(file) for file in self.files())

    def files(self) -> list[SnapshotFile]:
        """Return the files of all snapshots, newest first, without opening them."""
        try:
            with os.scandir(self.folder) as entries:
                names = [entry.name for entry in entries]
        except OSError:  # not created yet, or not readable
            return []
        return sorted(map(_snapshot_file, filter(None, map(_NAME.fullmatch, names))), reverse=True)

    def read_header(self, file: SnapshotFile, known: Snapshot | None = None) -> Snapshot:
        """Read the header of a snapshot. Return `known` if its file has not changed."""
        taken, _, name = file
        path = self.folder / name
        problem, stamp, header = "", _stamp(path), list[str]()
        if known is not None and known.stamp == stamp:
            return known
        try:
            with open_ordinary(path) as opened:
                text = opened.read(_HEADER_BYTES).decode("utf-8-sig", "replace")
            header = [line.rstrip("\r") for line in text.split("\n")[:_HEADER_LINES] if text]
        except OSError as error:
            problem = tr("The file cannot be read: {0}.").format(error.strerror or error)
        details = {found[1]: found[2] for line in header if (found := _DETAIL.fullmatch(line))}
        values = {found[1]: found[2] for line in header if (found := _VALUE.match(line))}
        number, product = details.get("device number", ""), values.get("product", "")
        if not problem and product not in {model.name for model in device_table().models}:
            problem = tr("It does not name its board.") if header else tr("It is empty.")
        return Snapshot(
            path,
            taken,
            product,
            values.get("firmware", ""),
            int(number) if re.fullmatch("[0-9]{1,3}", number) else None,
            details.get("adapter", ""),
            details.get("reason", ""),
            problem,
            details.get("name", ""),
            details.get("note", ""),
            stamp,
        )

    def load(self, snapshot: Snapshot) -> Settings:
        """Return the settings in a snapshot. Raises SettingsError if it is missing or damaged."""
        settings, _ = read_settings(load(snapshot.path), str(snapshot.path))
        return settings

    def label(self, snapshot: Snapshot, **texts: str) -> None:
        """Set the `name`, the `note` or both. An empty text removes the old text.

        Raises:
            BadRequest: the name is a number or is used by another snapshot, or a text is too long.
            SettingsError: the file is missing, or cannot be written.
        """
        cleaned = {kind: " ".join(clean_note(text).split()) for kind, text in texts.items()}
        for kind, text in cleaned.items():
            if len(text) > _MAX_LENGTH[kind]:
                raise BadRequest(
                    tr("At most {0} characters are allowed.").format(_MAX_LENGTH[kind])
                )
        name = cleaned.get("name", "")
        if name.isdecimal():
            raise BadRequest(
                tr(
                    "A name cannot be a number like {0}, because numbers already identify "
                    "snapshots."
                ).format(name)
            )
        if name and any(other.name == name != snapshot.name for other in self.snapshots()):
            raise BadRequest(tr("Another snapshot has the name {0}.").format(name))
        lines = load(snapshot.path).split(b"\n")  # all other lines are retained
        for kind, text in cleaned.items():
            prefix = f"# {kind}: ".encode()
            first, *rest = (line for line in lines[:_HEADER_LINES] if not line.startswith(prefix))
            lines[:_HEADER_LINES] = [first, *([prefix + text.encode()] if text else []), *rest]
        save(snapshot.path, b"\n".join(lines))

    def remove(self, snapshot: Snapshot) -> None:
        """Remove a snapshot. Raises SettingsError if its file exists and cannot be removed."""
        with explained(snapshot.path, tr("it cannot be removed")):
            snapshot.path.unlink(missing_ok=True)

    def limit(self) -> Limit:
        path = self.folder / LIMIT_FILE
        try:
            with open_ordinary(path) as file:
                data = file.read(_MAX_LIMIT_FILE + 1)
        except FileNotFoundError:
            return _unknown_limit(path, tr("is missing")) if path.is_symlink() else Limit()
        except OSError as error:
            return _unknown_limit(path, tr("cannot be read ({0})").format(error.strerror or error))
        lines = [
            line.split("#")[0].strip() for line in data.decode("utf-8-sig", "replace").splitlines()
        ]
        words = [line for line in lines if line]
        match = _LIMIT.fullmatch(words[0]) if len(words) == 1 else None
        if match is None or len(data) > _MAX_LIMIT_FILE:
            return _unknown_limit(path, tr("is damaged"))
        return Limit(None if match[1] == "all" else int(match[1]))

    def excess(self, count: int | None) -> tuple[Snapshot, ...]:
        """Return the unnamed snapshots that a limit of `count` snapshots would remove."""
        older = () if count is None else map(self.read_header, self.files()[count:])
        return tuple(snapshot for snapshot in older if not snapshot.name)

    def set_limit(self, count: int | None) -> tuple[Snapshot, ...]:
        """Set the limit for all programs. Remove the excess snapshots and return them.

        If saving raises a SettingsError, no snapshot is removed.
        """
        if count is not None and not 1 <= count < 10**7:
            raise ValueError(tr("the limit must be 1 to 9999999 snapshots, not {0}").format(count))
        self._create_folder()
        save(self.folder / LIMIT_FILE, _LIMIT_TEXT.format("all" if count is None else count))
        return tuple(old for old in self.excess(count) if _try_to_remove(old.path))

    def _remove_oldest(self, own: Path) -> None:
        """Remove the oldest snapshots if there are more than the limit.

        `own` is the newest snapshot of this program. Snapshots saved after it are kept, so two
        programs never remove each other's snapshots.
        """
        limit = self.limit()
        if limit.problem or limit.count is None:
            return
        # The file system's clock decides which snapshot is older. For equal times, the name does.
        own_key = _stamp(own)[0], own.name
        others = [file for file in self.files() if file[2] != own.name]
        for file in others[limit.count - 1 :]:
            snapshot = self.read_header(file)
            if (snapshot.stamp[0], snapshot.path.name) < own_key and not snapshot.name:
                _try_to_remove(snapshot.path)

    def _create_folder(self) -> None:
        with explained(self.folder, tr("it cannot be written")):
            self.folder.mkdir(parents=True, exist_ok=True)

    def _path(self, taken: datetime, index: int, model: str, firmware: str) -> Path:
        suffix = "" if index == 1 else f"{index}-"
        return self.folder / f"{taken.strftime(_TIME)}-{suffix}{model}-{firmware}.txt"


def _snapshot_file(match: re.Match[str]) -> SnapshotFile:
    try:
        taken = datetime.fromisoformat(match[1])
    except ValueError:  # the digits are not a date
        taken = _NO_DATE
    return taken, int(match[2] or 1), match[0]


def _stamp(path: Path) -> Stamp:
    try:
        status = path.stat()
    except OSError:
        return 0, 0
    return status.st_mtime_ns, status.st_size


def _try_to_remove(path: Path) -> bool:
    try:
        path.unlink(missing_ok=True)
    except OSError:
        return False
    return True


def _unknown_limit(path: Path, reason: str) -> Limit:
    text = tr("{0} {1}: the number of snapshots to keep is unknown, so none is removed.")
    return Limit(None, text.format(path, reason))
