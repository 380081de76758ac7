"""Settings file in an editor."""

from functools import partial
from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from tests.devices.trex.settings.samples import factory
from tests.support.bad_files import BAD_FILES, BadFile
from tests.support.documents import save_now
from trex_gui.core.errors import BadRequest
from trex_gui.core.files import SettingsError, load
from trex_gui.devices.trex.model.settings.document import SettingsDocument
from trex_gui.devices.trex.protocol.calibration import Calibration, CalibrationKey

pytestmark = pytest.mark.usefixtures("qapp")

ROVER = (
    "\ufeffproduct: TReX\r\n"
    "# my rover\r\n"
    "motor_mode: 0   # two motors\r\n"
    "serial_timeout:   5  # 0.5 s\r\n"
    "rc_channel_2: {minimum: 2600, neutral: 3700, maximum: 4900, deadband: 60}\r\n"
    "# the end"
)


def document_of(path: Path, content: str | bytes) -> SettingsDocument:
    """Write a file, and open it in a document."""
    path.write_bytes(content.encode() if isinstance(content, str) else content)
    return SettingsDocument.of_file(path, load(path))


@pytest.fixture
def rover(tmp_path: Path) -> Path:
    return tmp_path / "rover.txt"


@pytest.fixture
def document(rover: Path) -> SettingsDocument:
    """Settings document of the file `rover`."""
    return document_of(rover, ROVER)


def test_edit_changes_only_its_value_and_comment(document: SettingsDocument, rover: Path) -> None:
    document.draft.parameters.edit("serial_timeout", 15)
    assert (document.modified, document.draft.pending) == (True, 1)
    save_now(document, document.content)
    assert (document.modified, document.draft.pending) == (False, 0)
    assert rover.read_bytes().decode() == ROVER.replace("  5  # 0.5 s", "  15  # 1.5 s")


def test_value_beyond_an_inferred_limit_is_written(document: SettingsDocument, rover: Path) -> None:
    with pytest.raises(BadRequest):
        document.draft.parameters.edit("ignored_channels", 63)
    document.draft.parameters.edit("ignored_channels", 63, forced=True)
    save_now(document, document.content)
    assert "ignored_channels: 63" in rover.read_bytes().decode()
    (warning,) = [finding for finding in document.findings if finding.key == "ignored_channels"]
    assert "the board decides" in warning.message
    settings = SettingsDocument.of_file(rover, load(rover)).settings
    assert settings is not None
    assert settings.parameters["ignored_channels"] == 63


def test_undoing_all_edits_after_a_save_restores_all_bytes(
    document: SettingsDocument, rover: Path
) -> None:
    document.draft.parameters.edit("motor_mode", 1)
    document.draft.parameters.edit("aux_acceleration", 7)
    document.draft.parameters.remove("serial_timeout")
    document.draft.calibrations.remove(CalibrationKey.RC_CHANNEL_2)
    document.draft.calibrations.edit(CalibrationKey.ANALOG_CHANNEL_1, Calibration(1, 2, 3, 0))
    save_now(document, document.content)
    assert "aux_acceleration: 7" in rover.read_text(encoding="utf-8")
    assert "# rc_channel_2" in rover.read_text(encoding="utf-8")
    while document.draft.undo.canUndo():
        document.draft.undo.undo()
    assert document.modified
    save_now(document, document.content)
    assert rover.read_bytes() == ROVER.encode()


def test_several_edits_emit_changed_once(document: SettingsDocument, qtbot: QtBot) -> None:
    texts = []
    document.changed.connect(lambda: texts.append(document.text))
    with qtbot.waitSignal(document.changed):
        document.draft.parameters.edit("motor_mode", 1)
        document.draft.parameters.edit("serial_timeout", 9)
    assert len(texts) == 1
    assert "serial_timeout:   9" in texts[0]


@pytest.mark.parametrize("bad", BAD_FILES, ids=lambda bad: bad.name)
def test_file_with_errors_opens_as_text_with_findings(bad: BadFile, tmp_path: Path) -> None:
    path = tmp_path / "bad.txt"
    if not bad.is_text:
        with pytest.raises(SettingsError, match=bad.words):
            document_of(path, bad.data)
        return
    document = document_of(path, bad.data)
    assert not document.readable
    assert document.settings is None
    assert not document.modified
    findings = [finding for finding in document.findings if finding.line == bad.line]
    assert any(bad.words in finding.message for finding in findings)


def is_modified(document: SettingsDocument) -> bool:
    return document.modified


def test_text_with_errors_is_saved_and_corrected(tmp_path: Path) -> None:
    path = tmp_path / "rover.txt"
    document = document_of(path, "product: TReX\n# mine\nmotor_mode: 9\n")
    document.set_text(document.text.replace("9", "8"))
    save_now(document, document.content)
    assert path.read_text(encoding="utf-8") == "product: TReX\n# mine\nmotor_mode: 8\n"
    assert not is_modified(document)
    document.set_text(document.text.replace("8", "1"))
    assert is_modified(document)
    assert not document.readable
    assert document.check()
    assert document.settings is not None
    assert document.settings.parameters == {"motor_mode": 1}
    save_now(document, document.content)
    assert path.read_text(encoding="utf-8") == "product: TReX\n# mine\nmotor_mode: 1\n"


def test_cp1252_text_needs_a_check_and_is_saved_as_utf8(tmp_path: Path) -> None:
    path = tmp_path / "rover.txt"
    document = document_of(path, "product: TReX\n# für 5 µs\nmotor_mode: 0\n".encode("cp1252"))
    assert not document.readable
    assert "für 5 µs" in document.text
    assert document.check()
    save_now(document, document.content)
    assert path.read_bytes() == "product: TReX\n# für 5 µs\nmotor_mode: 0\n".encode()


def test_edits_made_while_saving_stay_unsaved(document: SettingsDocument, rover: Path) -> None:
    edit = document.draft.parameters.edit
    edit("motor_mode", 1)
    content = document.content()
    edit("serial_timeout", 15)
    content.record_saved(rover)
    assert is_modified(document)
    assert document.on_disk == content.text.encode()
    edit("serial_timeout", 5)
    assert not is_modified(document)

    edit("motor_mode", 0)
    content = document.content()
    document.draft.undo.undo()
    content.record_saved(rover)
    assert is_modified(document), "the saved edit was undone while saving"
    assert "motor_mode: 1" in document.text


def test_file_not_editable_in_place_is_rewritten_on_request(tmp_path: Path) -> None:
    path = tmp_path / "block.txt"
    # The YAML block ends with the file. A line after the block would add a line break to it.
    document = document_of(path, "product: TReX\nfirmware: |\n  1.2")
    assert not document.problem
    document.draft.parameters.edit("motor_mode", 1)
    assert "cannot be changed in place" in document.problem
    with pytest.raises(SettingsError):
        save_now(document, document.content)
    save_now(document, partial(document.content, fresh=True))
    assert "motor_mode: 1" in path.read_text(encoding="utf-8")
    assert not document.modified


def test_new_file_gets_a_path_when_it_is_saved(tmp_path: Path) -> None:
    document = SettingsDocument.of_settings(factory(), "new.txt", title="Factory settings")
    assert document.settings == factory()
    assert not document.modified
    assert document.path is None
    save_now(document, document.content, tmp_path / "mine.txt")
    assert document.name == "mine.txt"
    assert "Factory settings" in (tmp_path / "mine.txt").read_text(encoding="utf-8")
