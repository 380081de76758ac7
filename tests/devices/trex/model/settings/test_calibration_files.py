"""Only the calibrations of a settings file."""

from dataclasses import replace
from pathlib import Path

import pytest

from trex_gui.core.errors import BadRequest
from trex_gui.core.files import SettingsError, load
from trex_gui.devices.trex.model.settings.document import put_calibrations, set_calibrations
from trex_gui.devices.trex.model.settings.draft import SettingsDraft
from trex_gui.devices.trex.protocol.calibration import (
    DEFAULT_CALIBRATION,
    Calibration,
    CalibrationKey,
)
from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.devices.trex.protocol.flags import CHANNELS, InputSource
from trex_gui.devices.trex.settings.document import Settings, factory_settings
from trex_gui.devices.trex.settings.reader import read_settings
from trex_gui.devices.trex.settings.writer import write_settings

RC, ANALOG = InputSource.RC, InputSource.ANALOG
JUNIOR = device_table().model("trexjr")
RC_1 = CalibrationKey.RC_CHANNEL_1
OTHER = Calibration(2400, 3700, 5100, 60)


@pytest.fixture
def factory() -> Settings:
    settings = factory_settings(device_table().model("trex"), "1.2")
    shown = {CalibrationKey.of(RC, channel): DEFAULT_CALIBRATION[RC] for channel in CHANNELS}
    return replace(settings, calibrations=shown)


@pytest.fixture
def draft(qapp: object, factory: Settings) -> SettingsDraft:
    draft = SettingsDraft()
    draft._start(factory.product, factory.firmware)
    draft.parameters.load(factory.specs, factory.parameters, {}, power_cycled=True)
    draft.calibrations.load("trex", RC, factory.calibrations)
    return draft


def test_import_takes_only_calibrations_of_the_input_source(
    draft: SettingsDraft, factory: Settings, tmp_path: Path
) -> None:
    path = tmp_path / "other.txt"
    parameters = {**factory.parameters, "serial_timeout": 15}
    calibrations = {
        CalibrationKey.RC_CHANNEL_2: OTHER,
        CalibrationKey.RC_CHANNEL_3: DEFAULT_CALIBRATION[RC],
        CalibrationKey.ANALOG_CHANNEL_1: OTHER,
    }
    there = replace(factory, parameters=parameters, calibrations=calibrations)
    path.write_text(write_settings(there), encoding="utf-8")
    count, left_out = set_calibrations(draft, read_settings(load(path), path.name)[0], "a file")
    assert count == 1
    assert draft.calibrations.pending == ((CalibrationKey.RC_CHANNEL_2, OTHER),)
    assert draft.parameters.values.pending == ()
    assert any("analog" in words for words in left_out)
    draft.undo.undo()
    assert draft.pending == 0


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        (
            write_settings(Settings(device_table().model("trexjr"), None, {}, {RC_1: OTHER})),
            "TReX Jr",
        ),
        ("product: TReX\nserial_timeout: 15\n", "no calibrations"),
    ],
)
def test_import_rejects_files_that_do_not_fit(draft: SettingsDraft, text: str, reason: str) -> None:
    with pytest.raises(BadRequest, match=reason):
        set_calibrations(draft, read_settings(text, "a.txt")[0], "a file")
    assert draft.pending == 0


def test_export_to_new_file_writes_only_calibrations(factory: Settings, tmp_path: Path) -> None:
    path = tmp_path / "new.txt"
    put_calibrations(factory, path, "Calibrations.")
    written, _ = read_settings(path.read_bytes(), path.name)
    assert written.parameters == {}
    assert written.calibrations == factory.calibrations


def test_export_keeps_other_content_of_an_existing_file(factory: Settings, tmp_path: Path) -> None:
    path = tmp_path / "mine.txt"
    before = "\ufeffproduct: TReX\n# my robot\nserial_timeout: 15\n"
    path.write_text(before, encoding="utf-8")
    put_calibrations(factory, path, "Calibrations.")
    text = path.read_text(encoding="utf-8")
    assert text.startswith(before)
    written, _ = read_settings(text, path.name)
    assert written.parameters == {"serial_timeout": 15}
    assert written.calibrations == factory.calibrations


@pytest.mark.parametrize(
    ("before", "reason"),
    [
        ("product: TReX\n# für mich\n".encode("cp1252"), "not UTF-8"),
        (b"product: TReX Jr\n", "TReX Jr"),
    ],
)
def test_export_rejects_files_that_do_not_fit(
    factory: Settings, tmp_path: Path, before: bytes, reason: str
) -> None:
    path = tmp_path / "old.txt"
    path.write_bytes(before)
    with pytest.raises(SettingsError, match=reason):
        put_calibrations(factory, path, "Calibrations.")
    assert path.read_bytes() == before
