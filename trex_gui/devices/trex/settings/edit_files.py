"""Files of unapplied edits, one per board."""

from dataclasses import dataclass
from datetime import UTC, datetime
from itertools import count
from pathlib import Path

from trex_gui.core.files import SettingsError, data_folder, explained, load, save
from trex_gui.core.translation import tr
from trex_gui.devices.trex.protocol.device_table import Model
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.reader import read_settings
from trex_gui.devices.trex.settings.writer import write_settings


@dataclass(frozen=True, slots=True)
class BoardIdentity:
    """Key that names the files of a board. Two boards may share a key."""

    product: Model
    firmware: str
    device_number: int | None
    is_simulated: bool = False

    @classmethod
    def of(cls, stored: Settings, *, is_simulated: bool = False) -> "BoardIdentity":
        firmware = stored.firmware or stored.product.firmware[-1]
        number = stored.parameters.get(ParameterKey.DEVICE_NUMBER)
        return cls(stored.product, firmware, number, is_simulated)

    def __str__(self) -> str:
        number = "" if self.device_number is None else f"-{self.device_number}"
        simulated = "demo-" if self.is_simulated else ""
        return f"{simulated}{self.product.key}-{self.firmware}{number}"


@dataclass(frozen=True, slots=True)
class SavedEdits:
    settings: Settings
    saved: datetime


class EditFiles:
    """Folder of settings files that contain only unapplied edits."""

    def __init__(self, folder: Path | None = None) -> None:
        self.folder = folder or data_folder() / "edits"

    def path(self, board: BoardIdentity) -> Path:
        return self.folder / f"{board}.txt"

    def save(self, board: BoardIdentity, edits: Settings | None) -> None:
        """Replace the saved edits of a board. `None` removes them.

        If saving raises a SettingsError, the earlier edits remain.
        """
        title = ["Edits that were not applied"]
        text = None if edits is None else write_settings(edits, title_lines=title)
        replace_file(self.path(board), text)

    def load(self, board: BoardIdentity) -> SavedEdits | None:
        """Return the saved edits of a board, or `None` if it has no edits.

        Raises:
            SettingsError: the file cannot be read, is damaged, or belongs to another model.
        """
        path = self.path(board)
        try:
            saved = datetime.fromtimestamp(path.stat().st_mtime, UTC)
        except FileNotFoundError:
            return None
        except (OSError, ValueError, OverflowError) as error:  # the file's time may be invalid
            raise SettingsError.of(path, f"{tr('it cannot be read')}: {error}") from error
        return SavedEdits(settings_of_board(load(path), path, board), saved)


def replace_file(path: Path, text: str | None) -> None:
    """Write a file, and create its folder if necessary. `None` removes the file.

    If writing raises a SettingsError, the old file is unchanged.
    """
    with explained(path, tr("it cannot be written")):
        if text is None:
            path.unlink(missing_ok=True)
        else:
            path.parent.mkdir(parents=True, exist_ok=True)
            save(path, text)


def put_aside(path: Path) -> Path | None:
    """Rename a file before another file replaces it.

    Returns the new path, or `None` if the file does not exist.
    """
    names = (path.with_name(f"{path.stem}.replaced-{number}.txt") for number in count(1))
    aside = next(name for name in names if not name.exists())
    with explained(path, tr("it cannot be written")):
        try:
            path.replace(aside)
        except FileNotFoundError:
            return None
    return aside


def settings_of_board(data: bytes, path: Path, board: BoardIdentity) -> Settings:
    """Read a board's settings. Raises SettingsError if they are damaged or for another model."""
    settings, _ = read_settings(data, str(path))
    if settings.product != board.product:
        raise SettingsError.of(
            path, tr("these are settings of a {0}").format(settings.product.name)
        )
    return settings
