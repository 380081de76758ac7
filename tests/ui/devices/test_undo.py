"""Undo of edits on all pages. Values that the board sends are not edits."""

from dataclasses import replace

import pytest
from hypothesis import HealthCheck, given
from hypothesis import strategies as st
from PySide6.QtCore import QLocale
from PySide6.QtGui import QUndoStack
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from tests.support.catalogs import in_language
from tests.support.matrix import examples
from trex_gui.core.errors import BadRequest
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.parameters.parameters import ParameterModel
from trex_gui.devices.trex.protocol.calibration import Calibration, CalibrationKey
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.protocol.parameters import parameters_of
from trex_gui.ui.devices.undo import undo_titles

SPECS = parameters_of("trex", "1.2")
FACTORY = {spec.key: spec.default for spec in SPECS.readable}
OLD = Calibration(2500, 3750, 5000, 75)
NEW = Calibration(2600, 3700, 4900, 60)


@pytest.fixture
def device(qtbot: QtBot) -> Device:
    device = Device()
    device.parameters.load(SPECS, FACTORY, {}, power_cycled=True)
    device.calibrations.load("trex", InputSource.RC, dict.fromkeys(range(1, 6), OLD))
    return device


def test_undo_order_spans_parameters_and_calibrations(device: Device) -> None:
    device.parameters.edit("serial_timeout", 5)
    device.calibrations.edit(CalibrationKey.RC_CHANNEL_2, NEW)
    device.parameters.edit("motor_mode", 1)
    assert device.draft.undo.undoText() == "Motor Mode"
    device.draft.undo.undo()
    assert device.draft.undo.undoText() == "Calibration of channel 2"
    device.draft.undo.undo()
    assert not device.calibrations.pending
    assert device.parameters.values.pending == (("serial_timeout", 5),)
    device.draft.undo.redo()
    assert device.calibrations.pending == ((CalibrationKey.RC_CHANNEL_2, NEW),)


def test_edits_of_one_run_are_one_step(device: Device) -> None:
    run = object()
    for minimum in (2501, 2502, 2503):
        device.calibrations.edit(
            CalibrationKey.RC_CHANNEL_1, replace(OLD, minimum=minimum), run=run
        )
    assert device.draft.undo.count() == 1
    device.draft.undo.undo()
    assert not device.calibrations.pending
    device.draft.undo.redo()
    assert device.calibrations.pending == (
        (CalibrationKey.RC_CHANNEL_1, replace(OLD, minimum=2503)),
    )


@pytest.mark.parametrize(
    "intervening", ["another run", "another channel", "another kind", "no run"]
)
def test_intervening_edit_splits_a_run(device: Device, intervening: str) -> None:
    run = object()
    device.calibrations.edit(CalibrationKey.RC_CHANNEL_1, NEW, run=run)
    match intervening:
        case "another run":
            run = object()
        case "another channel":
            device.calibrations.edit(CalibrationKey.RC_CHANNEL_2, NEW, run=run)
        case "another kind":
            device.parameters.edit("serial_timeout", 5)
        case _:
            device.calibrations.edit(CalibrationKey.RC_CHANNEL_1, replace(NEW, deadband=61))
    steps = device.draft.undo.count()
    device.calibrations.edit(CalibrationKey.RC_CHANNEL_1, replace(NEW, deadband=62), run=run)
    assert device.draft.undo.count() == steps + 1


def test_run_that_returns_to_the_old_value_leaves_no_step(device: Device) -> None:
    run = object()
    device.parameters.edit("serial_timeout", 5)
    device.calibrations.edit(CalibrationKey.RC_CHANNEL_1, NEW, run=run)
    device.calibrations.edit(1, OLD, run=run)
    assert not device.calibrations.pending
    assert device.draft.undo.undoText() == "Serial Timeout"
    assert device.draft.undo.count() == 1


def test_discarded_edits_are_restored_by_one_undo(device: Device) -> None:
    device.parameters.edit("serial_timeout", 5)
    device.calibrations.edit(CalibrationKey.RC_CHANNEL_1, NEW)
    device.draft.discard_edits()
    assert device.draft.pending == 0
    device.draft.undo.undo()
    assert device.draft.pending == 2


def test_step_without_change_is_dropped(device: Device) -> None:
    device.parameters.edit("motor_mode", 1)
    with device.draft.one_edit("Open settings file"):
        device.parameters.edit("serial_timeout", FACTORY["serial_timeout"])
    assert device.draft.undo.undoText() == "Motor Mode"
    assert device.draft.undo.count() == 1
    assert device.parameters.values.pending == (("motor_mode", 1),)


def test_edit_that_changes_nothing_leaves_no_step(device: Device) -> None:
    device.parameters.edit("serial_timeout", FACTORY["serial_timeout"])
    device.calibrations.edit(1, OLD)
    device.draft.discard_edits()
    with pytest.raises(BadRequest):
        device.parameters.edit("serial_timeout", 128)
    with pytest.raises(BadRequest):
        device.calibrations.edit(CalibrationKey.RC_CHANNEL_1, Calibration(5000, 3750, 2500, 0))
    device.parameters.load(SPECS, {**FACTORY, "serial_timeout": 9}, {}, power_cycled=True)
    assert not device.draft.undo.canUndo()


def test_undo_after_apply_makes_the_old_value_pending(device: Device) -> None:
    device.parameters.edit("serial_timeout", 5)
    device.parameters.record_stored({"serial_timeout": 5})
    assert device.draft.pending == 0
    device.draft.undo.undo()
    assert device.parameters.values.pending == (("serial_timeout", FACTORY["serial_timeout"]),)


def test_undo_does_not_change_the_other_input_source(device: Device) -> None:
    device.calibrations.edit(CalibrationKey.RC_CHANNEL_1, NEW)
    analog = Calibration(0, 512, 1023, 20)
    device.calibrations.load("trex", InputSource.ANALOG, dict.fromkeys(range(1, 6), analog))
    device.draft.undo.undo()
    assert device.calibrations.pending == ()
    assert device.calibrations.stored(1) == analog


def test_undo_ignores_a_parameter_that_the_firmware_lacks(device: Device) -> None:
    device.parameters.edit("uart_response_delay", 1)
    older = parameters_of("trex", "1.0")
    stored = {spec.key: spec.default for spec in older.readable}
    device.parameters.load(older, stored, {}, power_cycled=True)
    device.draft.undo.undo()
    assert device.draft.pending == 0


@examples(40, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(data=st.data())
def test_undo_and_redo_pass_through_every_state(qtbot: QtBot, data: st.DataObject) -> None:
    undo = QUndoStack()
    model = ParameterModel(undo=undo)
    model.load(SPECS, FACTORY, {}, power_cycled=True)
    states = [model.values.pending]
    for _ in range(data.draw(st.integers(1, 12))):
        spec = data.draw(st.sampled_from(SPECS.readable))
        wire = data.draw(st.sampled_from(sorted(spec.valid)))
        count = undo.count()
        model.edit(spec.key, wire)
        if undo.count() > count:
            states.append(model.values.pending)
    for state in reversed(states[:-1]):
        undo.undo()
        assert dict(model.values.pending) == dict(state)
    for state in states[1:]:
        undo.redo()
        assert dict(model.values.pending) == dict(state)


def test_menu_entry_without_a_name_has_no_colon(qapp: QApplication) -> None:
    assert undo_titles("Motor Mode", "") == ("&Undo Motor Mode", "&Redo")
    with in_language(qapp, QLocale("de")):
        assert undo_titles("", "Motormodus") == ("&Rückgängig", "&Wiederherstellen: Motormodus")
