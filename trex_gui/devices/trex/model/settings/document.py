"""Settings file in an editor: text, edits and findings."""

from functools import partial
from pathlib import Path

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.core.errors import StudioError
from trex_gui.core.files import Finding, SettingsError, decode
from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.settings.draft import SettingsDraft
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.edit_in_place import amend
from trex_gui.devices.trex.settings.reader import BYTE_ORDER_MARK, read_settings
from trex_gui.devices.trex.settings.writer import write_settings
from trex_gui.ui.files import Content
from trex_gui.ui.runtime import new_timer

_LAYOUT = "\t\n\v\f\r\x1b\xa0"  # unprintable characters that a text may contain


class SettingsDocument(QObject):
    """Text of a file, and a draft of its settings.

    While the text has errors, the user edits the text. Once it is readable, the user edits the
    draft. Edits retain the comments and the order of the text.
    """

    changed = Signal()  # `text`, `findings`, `path` or `readable`

    def __init__(
        self, text: str, name: str, *, path: Path | None = None, doubt: Finding | None = None
    ) -> None:
        """`doubt`: finding about a guessed encoding."""
        super().__init__()
        self.draft = SettingsDraft(self)  # empty while the text is not readable
        self._name = name
        self.path = path  # `None` before the file is saved
        self._base = text  # text before the edits of the draft
        self._saved = text
        self._text = text
        self.on_disk: bytes | None = None  # content of the file when it was last opened or saved
        self.readable = False  # the settings were read from the text
        self._problem = ""
        self._findings: tuple[Finding, ...] = ()
        self._timer = new_timer(self, 0, self._publish, single_shot=True)
        self._stale = False  # `_text` and `_findings` lack the newest edits

        if doubt is None:
            self.check()
        else:
            self._findings = (doubt,)
        self.draft.parameters.pending_changed.connect(self._on_edited)
        self.draft.calibrations.changed.connect(self._on_edited)
        self.draft.notes.edited.connect(self._on_edited)

    @classmethod
    def of_file(cls, path: Path, data: bytes) -> "SettingsDocument":
        """Create a document from a file.

        Raises:
            SettingsError: the file is too large, or is not text.
        """
        text, doubt = text_of(data, path.name)
        document = cls(text, path.name, path=path, doubt=doubt)
        document.on_disk = data
        return document

    @classmethod
    def of_settings(cls, settings: Settings, name: str, title: str) -> "SettingsDocument":
        """Create a new file from settings. Invalid values become comments.

        Raises:
            BadRequest: the settings have a key that the model or firmware lacks.
        """
        return cls(write_settings(settings, title_lines=[title]), name)

    @property
    def name(self) -> str:
        return self._name if self.path is None else self.path.name

    @property
    def settings(self) -> Settings | None:
        """Settings with their edits. `None` if the text is unreadable."""
        return self.draft.shown if self.readable else None

    @property
    def text(self) -> str:
        """Text that Save writes."""
        self._update_text()
        return self._text

    @property
    def problem(self) -> str:
        """Reason why edits do not fit into the text, or an empty string."""
        self._update_text()
        return self._problem

    @property
    def findings(self) -> tuple[Finding, ...]:
        self._update_text()
        return self._findings

    @property
    def modified(self) -> bool:
        return bool(self.problem) or self.text != self._saved

    def set_text(self, text: str) -> None:
        if not self.readable and text != self._base:
            self._base = self._text = text
            self.changed.emit()

    def check(self) -> bool:
        """Read the text again. Return whether it is readable."""
        if not self.readable:
            try:
                settings, self._findings = read_settings(self._base, self._name)
            except SettingsError as error:
                self._findings = error.findings
            else:
                self.readable = True
                self.draft.load_settings(settings)
            self.changed.emit()
        return self.readable

    def content(self, *, fresh: bool = False) -> Content:
        """Return the content to save. Later edits stay unsaved.

        `fresh` uses the program's own layout, without the user's comments.

        Raises:
            SettingsError: the edits do not fit into the text.
        """
        settings = self.settings
        if fresh and settings is not None:
            text = write_settings(settings)
        elif self.problem:
            raise SettingsError.of(self.name, self.problem)
        else:
            text = self.text
        return Content(text, partial(self._record_saved, text, settings, fresh))

    def _record_saved(self, text: str, settings: Settings | None, fresh: bool, path: Path) -> None:
        self.path = path
        self.on_disk = text.encode("utf-8")
        self._saved = text
        if fresh:
            self._base = text
        if settings is not None and settings == self.settings:
            self.draft.load_settings(settings)  # from now on, undo creates a new edit
        self._stale = True
        self._publish()

    @Slot()
    def _on_edited(self) -> None:
        if self.readable:
            self._stale = True
            self._timer.start()

    @Slot()
    def _publish(self) -> None:
        self._timer.stop()
        self._update_text()
        self.changed.emit()

    def _update_text(self) -> None:
        settings = self.settings
        if not self._stale or settings is None:
            return
        self._stale = False
        try:
            self._text, self._problem = amend(self._base, settings, self.name), ""
            _, self._findings = read_settings(self._text, self.name)
        except SettingsError as error:
            self._problem = error.findings[0].message
        except StudioError as error:
            self._problem = str(error)


def text_of(data: bytes, name: str) -> tuple[str, Finding | None]:
    """Return the text of a file, including a byte order mark.

    Also return a finding if the encoding was guessed.

    Raises:
        SettingsError: the file is too large, or is not text.
    """
    try:
        text = decode(data, name)
    except SettingsError as error:
        text = data.decode("cp1252", errors="replace")
        if not all(c.isprintable() or c in _LAYOUT for c in text) or "\ufffd" in text:
            raise
        finding = error.findings[0]
        message = tr(
            "{0}; it is shown as Western European text. Check the characters that are not plain "
            "letters; Save writes UTF-8"
        ).format(finding.message)
        return text, Finding(finding.line, finding.key, message)
    return (BYTE_ORDER_MARK + text if data.startswith(BYTE_ORDER_MARK.encode()) else text), None
