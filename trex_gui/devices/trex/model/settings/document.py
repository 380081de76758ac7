"""One settings file while it is worked on: its text, the edits of it, and what is wrong with it."""

from pathlib import Path

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.core.errors import StudioError
from trex_gui.core.files import Finding, SettingsError, decode, load, save
from trex_gui.devices.trex.model.settings.draft import SettingsDraft
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.edit_in_place import amend
from trex_gui.devices.trex.settings.reader import read_settings
from trex_gui.devices.trex.settings.writer import write_settings
from trex_gui.ui.runtime import runtime

_MARK = "\ufeff"
_LAYOUT = "\t\n\v\f\r\x1b\xa0"


class SettingsDocument(QObject):
    """The text as it was opened, and a draft of the settings that it gives.

    A text with errors gives no settings: then the text itself is edited until it can be read.
    From there on the draft is edited, and `text` follows it, comments and order kept.

    Signals:
        changed: text, findings, file or what can be edited are others now.

    Attributes:
        draft: the settings and the edits of them; empty while the text cannot be read.
    """

    changed = Signal()

    def __init__(
        self,
        text: str,
        name: str,
        parent: QObject | None = None,
        *,
        path: Path | None = None,
        doubt: Finding | None = None,
    ) -> None:
        """Start with a text; with a `doubt` the user must check it before it is read."""
        super().__init__(parent)
        self.draft = SettingsDraft(self)
        self._name = name
        self._path = path
        self._base = text
        self._saved = text
        self._text = text
        self._on_disk: bytes | None = None
        self._readable = False
        self._trouble = ""
        self._findings: tuple[Finding, ...] = ()
        self._announcing = runtime().timer(self)
        self._announcing.setSingleShot(True)
        self._announcing.setInterval(0)
        self._announcing.timeout.connect(self._look)
        self._stale = False

        if doubt is None:
            self.check()
        else:
            self._findings = (doubt,)
        self.draft.parameters.pending_changed.connect(self._on_edited)
        self.draft.calibrations.changed.connect(self._on_edited)

    @classmethod
    def open(cls, path: Path, parent: QObject | None = None) -> "SettingsDocument":
        """Open a file; one with errors opens, too, as text.

        Raises:
            SettingsError: it cannot be read, is too large, or no text at all.
        """
        data = load(path)
        text, doubt = _text_of(data, path.name)
        document = cls(text, path.name, parent, path=path, doubt=doubt)
        document._on_disk = data
        return document

    @classmethod
    def of_settings(
        cls, settings: Settings, name: str, parent: QObject | None = None, *, title: str = ""
    ) -> "SettingsDocument":
        """Begin a file with settings; what a file cannot hold becomes a comment.

        Raises:
            BadRequest: the settings hold a key that their model and firmware do not have.
        """
        return cls(write_settings(settings, title_lines=[title] if title else []), name, parent)

    @staticmethod
    def check_text(data: bytes, name: str) -> str:
        """Return the text of a file, byte order mark included.

        Raises:
            SettingsError: it is too large, or no text at all.
        """
        return _text_of(data, name)[0]

    # --- What is there ------------------------------------------------------------------

    @property
    def name(self) -> str:
        """The name shown to the user."""
        return self._name if self._path is None else self._path.name

    @property
    def path(self) -> Path | None:
        """The path of the file; `None` before it is saved."""
        return self._path

    @property
    def readable(self) -> bool:
        """Whether the text gives settings; if not, the text itself is to be edited."""
        return self._readable

    @property
    def settings(self) -> Settings | None:
        """The settings with the edits of them; `None` while the text cannot be read."""
        return self.draft.shown if self._readable else None

    @property
    def text(self) -> str:
        """What Save writes, byte order mark and line ends included."""
        self._settle()
        return self._text

    @property
    def trouble(self) -> str:
        """Why the edits cannot be put into the text in place; empty while they can."""
        self._settle()
        return self._trouble

    @property
    def findings(self) -> tuple[Finding, ...]:
        """The findings of the reader, in the order of the lines."""
        self._settle()
        return self._findings

    @property
    def modified(self) -> bool:
        """Whether Save would write something else than what was opened or saved last."""
        return bool(self.trouble) or self.text != self._saved

    def changed_on_disk(self) -> bool:
        """Whether the file holds something else now than when it was opened or saved."""
        if self._path is None or not self._path.exists():
            return False
        try:
            return load(self._path) != self._on_disk
        except SettingsError:
            return True

    # --- User actions -----------------------------------------------------------------

    def set_text(self, text: str) -> None:
        """Replace the text while it cannot be read as settings."""
        if not self._readable and text != self._base:
            self._base = self._text = text
            self.changed.emit()

    def check(self) -> bool:
        """Read the text again; once it has no errors it gives settings. Return whether it does."""
        if not self._readable:
            try:
                settings, self._findings = read_settings(self._base, self._name)
            except SettingsError as error:
                self._findings = error.findings
            else:
                self._readable = True
                self.draft.take_settings(settings)
            self.changed.emit()
        return self._readable

    def save(self, path: Path | None = None, *, fresh: bool = False) -> None:
        """Write the file, here or elsewhere; it is the file from now on.

        With `fresh`, in the program's own layout, without the user's comments.

        Raises:
            SettingsError: it cannot be written, or the edits cannot be put into its text.
        """
        target = path or self._path
        if target is None:
            raise SettingsError(self.name, [Finding(None, None, "it has no place on disk yet")])
        settings = self.settings
        if fresh and settings is not None:
            text = write_settings(settings)
        elif self.trouble:
            raise SettingsError(self.name, [Finding(None, None, self.trouble)])
        else:
            text = self.text
        save(target, text)
        self._path = target
        self._on_disk = text.encode("utf-8")
        self._saved = text
        if fresh:
            self._base = text
        if settings is not None:
            self.draft.take_settings(settings)  # no edit any more; undoing makes it one again
        self._stale = True
        self._look()

    # --- Keeping up ---------------------------------------------------------------------

    @Slot()
    def _on_edited(self) -> None:
        if self._readable:
            self._stale = True
            self._announcing.start()

    @Slot()
    def _look(self) -> None:
        self._announcing.stop()
        self._settle()
        self.changed.emit()

    def _settle(self) -> None:
        """Bring text and findings up to what the draft shows."""
        if not self._stale:
            return
        self._stale = False
        settings = self.settings
        if settings is None:
            return
        try:
            self._text, self._trouble = amend(self._base, settings, self.name), ""
            _, self._findings = read_settings(self._text, self.name)
        except SettingsError as error:
            self._trouble = error.findings[0].message
        except StudioError as error:
            self._trouble = str(error)


def _text_of(data: bytes, name: str) -> tuple[str, Finding | None]:
    """Return the text of a file, and what is to be said when it is not quite one.

    Raises:
        SettingsError: it is too large, or no text.
    """
    try:
        text = decode(data, name)
    except SettingsError as error:
        text = data.decode("cp1252", errors="replace")
        if not all(c.isprintable() or c in _LAYOUT for c in text) or "\ufffd" in text:
            raise
        found = error.findings[0]
        message = (
            f"{found.message}; it is shown as Western European text. Check the characters that "
            "are no plain letters; Save writes UTF-8"
        )
        return text, Finding(found.line, found.key, message)
    return (_MARK + text if data.startswith(_MARK.encode()) else text), None
