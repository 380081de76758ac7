"""Channels page in a window of its own, with a simulated board."""

import math
from collections.abc import Iterator

import pytest
from PySide6.QtCore import QEvent, Qt
from PySide6.QtGui import QAccessible, QKeyEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QSpinBox
from pytestqt.qtbot import QtBot

from tests.support.pages.channels import ChannelsDriver, channels_page
from tests.support.simulator import SimulatedDevice
from trex_gui.core.texts import signed_text
from trex_gui.devices.trex.board import WriteResult
from trex_gui.devices.trex.model.calibration_moves import Handle
from trex_gui.devices.trex.protocol.calibration import (
    DEFAULT_CALIBRATION,
    Calibration,
    CalibrationKey,
)
from trex_gui.devices.trex.protocol.errors import Rejected, ResultCode
from trex_gui.devices.trex.protocol.flags import CHANNELS, InputSource
from trex_gui.devices.trex.simulator.channel_control import ChannelSetup
from trex_gui.devices.trex.views.pages.channels.strips import STRIP_SECONDS, ChannelStrip

FACTORY = DEFAULT_CALIBRATION[InputSource.RC]


@pytest.fixture
def unconnected_page(qtbot: QtBot) -> Iterator[ChannelsDriver]:
    with channels_page(qtbot) as page:
        yield page


@pytest.fixture
def page(unconnected_page: ChannelsDriver, quick_simulator: SimulatedDevice) -> ChannelsDriver:
    unconnected_page.connect(quick_simulator.url)
    return unconnected_page


# --- Fields -----------------------------------------------------------------------------


def test_steps_in_one_field_are_undone_together(page: ChannelsDriver) -> None:
    page.widget.activateWindow()
    undo = page.device.draft.undo
    deadband, maximum = (page.find(QSpinBox, f"{name}Edit") for name in ("deadband", "maximum"))
    deadband.setFocus()
    for key in (Qt.Key.Key_Up, Qt.Key.Key_Up, Qt.Key.Key_Down):
        QTest.keyClick(deadband, key)
    assert page.shown().deadband == FACTORY.deadband + 1
    QTest.keyClick(deadband, Qt.Key.Key_PageUp)
    QTest.keyPress(deadband, Qt.Key.Key_Up)  # remains pressed during the repeat below
    repeat = QKeyEvent(
        QEvent.Type.KeyPress, Qt.Key.Key_Up, Qt.KeyboardModifier.NoModifier, "", True, 5
    )
    QApplication.sendEvent(deadband, repeat)
    QTest.keyRelease(deadband, Qt.Key.Key_Up)
    assert page.shown().deadband >= FACTORY.deadband + 13
    assert undo.count() == 1

    maximum.setFocus()
    QTest.keyClick(maximum, Qt.Key.Key_Down)
    QTest.keyClick(maximum, Qt.Key.Key_Down)
    assert undo.count() == 2
    page.type_into("maximumEdit", "4990 counts")
    assert undo.count() == 3
    QTest.keyClick(maximum, Qt.Key.Key_Down)
    assert undo.count() == 4
    for value in (4990, FACTORY.maximum - 2, FACTORY.maximum):
        undo.undo()
        assert page.shown().maximum == value
    undo.undo()
    assert page.shown() == FACTORY
    assert not undo.canUndo()

    for field in (deadband, maximum, deadband):  # a focus change ends the undo step
        field.setFocus()
        QTest.keyClick(field, Qt.Key.Key_Up)
        QTest.keyClick(field, Qt.Key.Key_Up)
    assert undo.count() == 3


def test_impossible_values_are_rejected_with_a_note(page: ChannelsDriver) -> None:
    page.type_into("minimumEdit", "1600")
    reason = "minimum 1600 µs is above neutral 1500 µs"
    assert page.shown_note == f"The board would reject this: {reason}."
    assert page.find(QSpinBox, "minimumEdit").text() == "1000 µs"
    page.type_into("maximumEdit", "1.2 ms")
    assert "neutral 1500 µs is above maximum 1200 µs" in page.shown_note
    page.type_into("neutralEdit", "nonsense")
    assert "not a valid value" in page.shown_note
    page.select_channel(2)
    assert not page.shown_note
    page.select_channel(1)
    assert page.device.draft.pending == 0

    page.drag_handle(Handle.MINIMUM, 4200)
    assert page.shown().minimum == page.shown().neutral
    page.type_into("neutralEdit", "1520")
    assert "The deadband (30 µs to each side of neutral)" in page.shown_note
    assert "problem" in page.input(1)


def test_typed_number_remains_when_the_line_becomes_noisy(
    page: ChannelsDriver, quick_simulator: SimulatedDevice
) -> None:
    field = page.find(QSpinBox, "minimumEdit")
    page.widget.activateWindow()
    field.setFocus()
    field.selectAll()
    QTest.keyClicks(field, "110")
    quick_simulator.do("line noise 0.01")
    page.wait(lambda: bool(page.device.board.quality.is_noisy))
    assert field.text() == "110"


def test_dragged_calibration_is_written_and_shown_as_learned(page: ChannelsDriver) -> None:
    assert page.text("learnedLabel") == "factory calibration"
    page.drag_handle(Handle.MINIMUM, 2300)
    edited = page.shown()
    assert edited != FACTORY
    assert page.find(QSpinBox, "minimumEdit").value() == edited.minimum
    assert page.device.calibrations.stored(1) == FACTORY
    page.apply()
    assert page.device.calibrations.stored(1) == edited
    assert page.text("learnedLabel") == "learned"


# --- Disconnected page ------------------------------------------------------------------


def test_disconnected_page_is_read_only(page: ChannelsDriver) -> None:
    page.type_into("minimumEdit", "1100")
    page.disconnect()
    for name in ("minimumEdit", "reversedBox", "learnButton", "learnAllButton", "changeButton"):
        assert not page.is_enabled(name), name
    assert page.text("pageState").startswith("No board responds")
    assert "not known" in page.input(1)
    assert page.plot.dot is None
    before = page.shown()
    page.drag_handle(Handle.MAXIMUM, 5200)
    assert page.shown() == before
    page.select_source(1)
    assert not page.has("otherSourceWords")


# --- Live inputs ------------------------------------------------------------------------


def test_live_dot_follows_the_stick(page: ChannelsDriver, quick_simulator: SimulatedDevice) -> None:
    quick_simulator.do("channel 1 1800us")
    page.wait(lambda: "1800 µs (4500)" in page.live)
    remapped = ChannelSetup((FACTORY,) * 5).remapped([4500] * 5)[0]
    assert page.plot.dot == (4500, remapped)
    assert f"output {signed_text(remapped)}" in page.live
    assert page.input(1).startswith(page.live)
    page.wait(lambda: "drives motor 1 (the mix jumper is off)" in page.text("channelDoes"))
    quick_simulator.do("channel 4 1000us")  # a flip channel has no output
    page.wait(lambda: "1000 µs" in page.input(4))
    assert page.input(1).startswith(page.live)
    page.click("parabolicBox")
    parabolic = ChannelSetup((FACTORY,) * 5, parabolic=1).remapped([4500] * 5)[0]
    assert page.plot.dot == (4500, parabolic)
    quick_simulator.do("channel 1 invalid")
    page.wait(lambda: "no signal" in page.input(1))
    page.wait(lambda: page.plot.dot is None)
    page.wait(lambda: "no signal" in page.live)


def test_hidden_page_is_not_updated(page: ChannelsDriver, quick_simulator: SimulatedDevice) -> None:
    page.widget.hide()
    before = page.input(1)
    quick_simulator.do("channel 1 1900us")
    page.wait(lambda: page.device.telemetry.raw_of(1) == 4750)
    samples = page.device.telemetry.samples
    page.wait(lambda: page.device.telemetry.samples > samples + 5)
    assert page.input(1) == before
    page.widget.show()
    assert "1900 µs" in page.input(1)


def test_lost_signal_leaves_a_gap_in_its_strip(
    page: ChannelsDriver, quick_simulator: SimulatedDevice
) -> None:
    strip = page.strip(2)
    page.wait(lambda: len(strip.lines) == 1 and strip.lines[0].count() > 20)
    quick_simulator.do("channel 2 invalid")
    page.wait(lambda: page.input(2).startswith("no signal"))
    quick_simulator.do("channel 2 1700us")
    page.wait(lambda: len(strip.lines) == 2)
    assert strip.lines[1].last().y() == 4250
    assert len(page.strip(1).lines) == 1
    page.disconnect()
    page.wait(lambda: not strip.lines)


def test_strip_stores_only_visible_samples(qtbot: QtBot) -> None:
    strip = ChannelStrip(1)
    qtbot.addWidget(strip)
    for step in range(3000):
        strip.add_samples([step / 50], [math.nan if step % 500 < 10 else 3750.0])
    points = [point for line in strip.lines for point in line.toList()]
    assert min(point.x() for point in points) >= 59.98 - STRIP_SECONDS
    assert len(points) == 491  # ten seconds at 50 Hz, both ends included, without a gap of ten


def test_arrow_keys_select_a_strip_for_screen_readers(page: ChannelsDriver) -> None:
    page.strip(1).setFocus()
    for key in (Qt.Key.Key_Down, Qt.Key.Key_Down, Qt.Key.Key_Up):
        QTest.keyClick(page.strip(page.widget.channel), key)
    assert page.widget.channel == 2
    assert page.text("channelTitle").startswith("2")
    for channel in CHANNELS:
        interface = QAccessible.queryAccessibleInterface(page.strip(channel))
        assert interface.text(QAccessible.Text.Name).startswith(f"Channel {channel}: ")
        assert bool(interface.state().checked) is (channel == 2)


# --- Effects of a channel ---------------------------------------------------------------


def test_override_switch_changes_the_texts_at_once(
    page: ChannelsDriver, quick_simulator: SimulatedDevice
) -> None:
    page.restart(quick_simulator, "jumper mode rc")
    assert page.text("channelDoes").startswith("Channel 1 drives motor 1")
    quick_simulator.do("channel 5 1000us")
    page.wait(lambda: page.text("channelDoes").startswith("Has no effect now"))
    assert "override them now" in page.text("pageState")
    quick_simulator.do("channel 5 1500us")
    page.wait(lambda: page.text("channelDoes").startswith("Channel 1 drives motor 1"))


# --- Check boxes and menu ---------------------------------------------------------------


def test_check_boxes_edit_parameter_bits(page: ChannelsDriver) -> None:
    page.select_channel(3)
    for name in ("reversed", "parabolic", "ignored", "required"):
        box = page.button(f"{name}Box")
        assert not box.isChecked()
        box.click()
        assert page.device.parameters.values.value_of(f"{name}_channels") in {4, 5}
        page.device.draft.undo.undo()
        assert not box.isChecked()
        page.device.draft.undo.redo()
        assert box.isChecked()
    assert "edited" in page.input(3)
    assert "ignored" in page.text("channelDoes")
    page.select_channel(1)
    assert not page.button("reversedBox").isChecked()
    assert page.button("requiredBox").isChecked()


def test_calibration_is_copied_and_reset(page: ChannelsDriver) -> None:
    undo = page.device.draft.undo
    page.type_into("minimumEdit", "1100")
    edited = page.shown()
    steps = undo.count()
    page.action("copyTo3").trigger()
    assert page.shown(3) == edited
    page.action("copyToAll").trigger()
    assert all(page.shown(channel) == edited for channel in CHANNELS)
    assert undo.count() == steps + 2
    undo.undo()
    assert page.shown(2) == FACTORY
    page.action("resetCalibration").trigger()
    assert page.shown() == FACTORY
    undo.undo()

    page.button("reversedBox").click()
    page.action("discardChannel").trigger()
    assert page.shown() == FACTORY
    assert not page.button("reversedBox").isChecked()
    assert page.shown(3) == edited
    assert not page.action("discardChannel").isEnabled()
    undo.undo()
    assert page.shown() == edited
    assert page.button("reversedBox").isChecked()


# --- Sources and modes ------------------------------------------------------------------


def test_inactive_source_is_shown_and_can_be_activated(
    page: ChannelsDriver, quick_simulator: SimulatedDevice
) -> None:
    page.select_source(1)
    assert "have not been read yet" in page.text("otherSourceWords")
    for name in ("minimumEdit", "neutralEdit", "maximumEdit", "deadbandEdit", "changeButton"):
        assert not page.is_enabled(name), name
    for name in ("learnButton", "reversedBox", "ignoredBox"):
        button = page.button(name)
        assert not button.isEnabled(), name
        assert button.toolTip().startswith("The board now reads RC pulses,"), name
        assert "To see the calibrations for analog voltages" in button.toolTip(), name
    assert page.is_enabled("learnAllButton")
    assert not page.has("requiredBox")

    page.click("switchSourceButton")
    assert page.device.parameters.values.pending == (("channel_input_source", 1),)
    assert "apply the change, then power-cycle" in page.text("otherSourceWords")
    page.apply()
    assert "after the next power cycle" in page.text("otherSourceWords")
    assert page.widget.source is InputSource.ANALOG
    with page.qtbot.waitSignal(page.widget.power_cycle_requested):
        page.click("switchSourceCycleButton")

    quick_simulator.do("power cycle")
    page.wait(lambda: "read as analog voltages" in page.text("pageState"))
    for name in ("minimumEdit", "learnButton", "reversedBox"):
        assert page.is_enabled(name), name
    assert page.find(QSpinBox, "maximumEdit").text() == "5.000 V"
    assert not page.button("learnButton").toolTip()
    assert "forward and reverse" in page.button("reversedBox").toolTip()
    assert not page.has("requiredBox")
    quick_simulator.do("channel 1 2.5V")
    page.wait(lambda: "2.50 V" in page.live)
    page.type_into("minimumEdit", "500 mV")
    assert page.shown().minimum == 102

    page.select_source(0)
    assert "The values below were applied 20" in page.text("otherSourceWords")
    assert page.find(QSpinBox, "neutralEdit").text() == "1500 µs"
    assert not page.is_enabled("neutralEdit")
    assert page.device.draft.pending == 1


def test_rc_mode_disables_rejected_settings_with_one_note(
    unconnected_page: ChannelsDriver, quick_simulator: SimulatedDevice
) -> None:
    page, board = unconnected_page, quick_simulator
    board.do("jumper mode rc", "power cycle")
    page.connect(board.url)
    page.device.calibrations.edit(1, Calibration(2400, 3700, 3800, 60))
    assert page.text("channelDoes").startswith("Channel 1 drives motor 1")
    assert page.shown_note == page.device.writer.blocker
    assert "serial mode only" in page.shown_note
    for name in ("minimumEdit", "reversedBox", "learnButton", "learnAllButton"):
        assert not page.is_enabled(name), name
    assert page.action("discardChannel").isEnabled()
    before = page.shown()
    page.drag_handle(Handle.MINIMUM, 2300)
    assert page.shown() == before
    assert not page.action("resetCalibration").isEnabled()
    page.select_source(1)
    assert "mode jumper to analog" in page.text("otherSourceWords")
    assert not page.has("switchSourceButton")

    page.select_source(0)
    board.do("jumper mode serial", "power cycle")
    page.wait(lambda: page.is_enabled("minimumEdit"))
    assert page.is_enabled("learnButton")
    assert "serial mode only" not in page.shown_note
    assert page.action("resetCalibration").isEnabled()


def test_value_rejected_by_the_board_is_explained(page: ChannelsDriver) -> None:
    page.device.calibrations.edit(2, Calibration(2400, 3700, 5100, 60))
    error = Rejected("Calibration of channel 2", ResultCode.BAD_VALUE)
    page.device.applied.emit((WriteResult(CalibrationKey.RC_CHANNEL_2, error=error),))
    assert "problem" in page.input(2)
    assert "problem" not in page.input(1)
    assert "code 2" not in page.shown_note
    page.select_channel(2)
    assert "code 2" in page.shown_note
    assert "minimum is not above neutral" in page.shown_note
    page.device.draft.undo.undo()
    assert "problem" not in page.input(2)


# --- Buttons and keys -------------------------------------------------------------------


def test_buttons_request_learning_and_the_stick_test(page: ChannelsDriver) -> None:
    requested: list[object] = []
    page.widget.learn_requested.connect(requested.append)
    page.select_channel(2)
    page.click("learnButton")
    page.click("learnAllButton")
    assert requested == [(2,), CHANNELS]
    with page.qtbot.waitSignal(page.widget.test_requested):
        page.click("testSticksButton")
