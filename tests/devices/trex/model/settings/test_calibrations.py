"""Stored and edited calibrations."""

import pytest
from PySide6.QtGui import QUndoStack
from pytestqt.qtbot import QtBot

from trex_gui.core.errors import BadRequest
from trex_gui.devices.trex.model.settings.calibrations import Calibrations
from trex_gui.devices.trex.protocol.calibration import (
    DEFAULT_CALIBRATION,
    Calibration,
    CalibrationKey,
)
from trex_gui.devices.trex.protocol.flags import CHANNELS, InputSource

LEARNED = Calibration(2400, 3700, 5100, 80)
OTHER = Calibration(2300, 3800, 5200, 90)


def stored(source: InputSource) -> dict[int, Calibration]:
    return dict.fromkeys(CHANNELS, DEFAULT_CALIBRATION[source])


@pytest.fixture
def model(qtbot: QtBot) -> Calibrations:
    model = Calibrations()
    model.load("trex", InputSource.RC, stored(InputSource.RC))
    return model


def test_edit_is_pending_and_emits_signals(model: Calibrations, qtbot: QtBot) -> None:
    with qtbot.waitSignal(model.changed):
        model.edit(CalibrationKey.RC_CHANNEL_2, LEARNED)
    model.edit(CalibrationKey.RC_CHANNEL_1, OTHER)
    assert model.pending == (
        (CalibrationKey.RC_CHANNEL_1, OTHER),
        (CalibrationKey.RC_CHANNEL_2, LEARNED),
    )
    assert model.stored(2) == DEFAULT_CALIBRATION[InputSource.RC]
    model.edit(CalibrationKey.RC_CHANNEL_2, DEFAULT_CALIBRATION[InputSource.RC])
    assert dict(model.pending) == {CalibrationKey.RC_CHANNEL_1: OTHER}


def test_inconsistent_calibration_is_rejected(model: Calibrations) -> None:
    with pytest.raises(BadRequest, match="calibration of channel 4: minimum 9 is above neutral 5"):
        model.edit(CalibrationKey.RC_CHANNEL_4, Calibration(9, 5, 10, 0))
    assert model.pending == ()


def test_written_edit_is_stored_and_failed_edit_stays_pending(model: Calibrations) -> None:
    model.edit(1, LEARNED)
    model.edit(2, LEARNED)
    model.record_stored(stored(InputSource.RC) | {1: LEARNED})
    assert model.stored(1) == LEARNED
    assert model.pending == ((CalibrationKey.RC_CHANNEL_2, LEARNED),)
    model.edit(2, OTHER)  # during the write
    model.record_stored({2: LEARNED})
    assert model.pending == ((CalibrationKey.RC_CHANNEL_2, OTHER),)


def test_edit_survives_reload_until_it_is_stored(model: Calibrations) -> None:
    model.edit(CalibrationKey.RC_CHANNEL_1, LEARNED)
    model.load("trex", InputSource.RC, stored(InputSource.RC))
    assert dict(model.pending) == {CalibrationKey.RC_CHANNEL_1: LEARNED}
    model.load("trex", InputSource.RC, stored(InputSource.RC) | {1: LEARNED})
    assert model.pending == ()


def test_edit_is_retained_while_the_other_source_is_active(model: Calibrations) -> None:
    model.edit(CalibrationKey.RC_CHANNEL_1, LEARNED)
    model.load("trex", InputSource.ANALOG, stored(InputSource.ANALOG))
    states = [(model.pending, model.out_of_reach)]
    assert model.all_shown == model.all_stored
    model.load("trex", InputSource.RC, stored(InputSource.RC))
    states.append((model.pending, model.out_of_reach))
    assert states == [
        ((), [CalibrationKey.RC_CHANNEL_1]),
        (((CalibrationKey.RC_CHANNEL_1, LEARNED),), []),
    ]


def test_edit_is_discarded_for_another_model(model: Calibrations) -> None:
    model.edit(CalibrationKey.RC_CHANNEL_1, LEARNED)
    model.load("trexjr", InputSource.RC, stored(InputSource.RC))
    assert model.edited == {}


@pytest.fixture
def file(qtbot: QtBot) -> Calibrations:
    """Calibrations of a file with one calibration of each source."""
    model = Calibrations()
    content = {CalibrationKey.RC_CHANNEL_2: LEARNED, CalibrationKey.ANALOG_CHANNEL_3: OTHER}
    model.load("trex", InputSource.RC, content, open_ended=True)
    return model


def test_file_accepts_calibrations_of_both_sources(file: Calibrations) -> None:
    file.edit(CalibrationKey.ANALOG_CHANNEL_1, LEARNED)
    assert file.all_shown[CalibrationKey.ANALOG_CHANNEL_1] == LEARNED
    assert CalibrationKey.ANALOG_CHANNEL_1 not in file.all_stored
    file.remove(CalibrationKey.ANALOG_CHANNEL_1)
    assert not file.edited
    assert not file.removed


def test_calibration_is_removed_from_a_file_and_restored(file: Calibrations) -> None:
    file.remove(2)
    assert file.shown(2) is None
    assert file.removed == {CalibrationKey.RC_CHANNEL_2}
    assert file.all_shown == {CalibrationKey.ANALOG_CHANNEL_3: OTHER}
    file.edit(CalibrationKey.RC_CHANNEL_2, LEARNED)
    assert not file.removed
    assert not file.edited
    file.remove(2)
    file.edit(CalibrationKey.RC_CHANNEL_1, LEARNED)
    file.discard_edits()
    assert file.all_shown == file.all_stored


def test_calibration_of_a_board_cannot_be_removed(model: Calibrations) -> None:
    model.remove(2)
    assert model.shown(2) is not None
    assert not model.removed


def test_calibration_of_the_other_source_cannot_be_edited(model: Calibrations) -> None:
    model.load("trex", InputSource.ANALOG, dict.fromkeys(CHANNELS, OTHER))
    assert model.stored(CalibrationKey.RC_CHANNEL_2) is None
    assert not model.can_edit(CalibrationKey.RC_CHANNEL_2)


def test_restoring_one_channel_can_be_undone(qtbot: QtBot) -> None:
    undo = QUndoStack()
    model = Calibrations(undo=undo)
    model.load("trex", InputSource.RC, stored(InputSource.RC))
    model.edit(CalibrationKey.RC_CHANNEL_1, LEARNED)
    model.edit(CalibrationKey.RC_CHANNEL_2, OTHER)
    model.restore(1)
    assert dict(model.pending) == {CalibrationKey.RC_CHANNEL_2: OTHER}
    undo.undo()
    assert dict(model.pending) == {
        CalibrationKey.RC_CHANNEL_1: LEARNED,
        CalibrationKey.RC_CHANNEL_2: OTHER,
    }
    model.restore(3)  # adds no undo step, because it was not edited
    assert undo.canRedo()
