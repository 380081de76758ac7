"""The test of the sticks, in the dialog that learns channels, on a simulated board."""

from collections.abc import Iterator

import pytest
from pytestqt.qtbot import QtBot

from tests.support.pages.learning import LearningDialog, learning_dialog
from tests.support.simulator import SimulatedDevice
from tests.support.transmitter import Stick
from trex_gui.devices.trex.views.bars import ChannelBar
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets.labels import Note


@pytest.fixture
def learning(quick_simulator: SimulatedDevice, qtbot: QtBot) -> Iterator[LearningDialog]:
    with learning_dialog(quick_simulator, qtbot) as dialog:
        yield dialog


def test_stick_test_says_what_holds_the_motors(learning: LearningDialog) -> None:
    learning.use({1: Stick()})
    learning.simulator.do("channel 2 1600us")
    learning.start_test(1)
    learning.push(1, -1)
    learning.wait_for_text("learnTest1", "Good.")
    learning.wait_for_head("The tested channels are good. But in RC mode the motors would not")
    assert "Channel 2 is " in learning.head
    note = learning.find(Note, "learnSafeStart")
    assert "would hold the motors now. Channel 2 is " in note.text()
    assert note.palette().color(note.foregroundRole()) == theme().color("warning")

    learning.simulator.do("channel 2 1500us")
    learning.wait_for_head("Everything is as it should be.")
    assert "would release the motors" in note.text()
    assert note.palette().color(note.foregroundRole()) == theme().color("window_text")

    learning.transmitter.put(1, 0.3)
    learning.wait_for_text("learnTest1", "Release it: at rest the output must be 0")
    learning.wait_for_head("Push every stick")
    learning.simulator.do("channel 1 silent")
    learning.wait_for_text("learnTest1", "No signal.")
    assert "Everything" not in learning.head
    learning.assert_nothing_changed()


def test_channel_failing_the_test_can_be_learned_again(learning: LearningDialog) -> None:
    learning.use({1: Stick(rest=1600), 2: Stick(low=1050, high=2010)})
    learning.start_test(1, 2)
    learning.push(1, -1)
    learning.wait_for_text("learnTest1", "at rest the output must be 0")
    learning.wait_for_text("learnSafeStart", "Channel 1 is ")
    assert learning.text("learnTest2") == "Full output not reached yet: reverse (−127)."

    learning.use({1: Stick(), 2: Stick(low=1050, high=2010)})
    learning.push(1, -1)
    learning.wait_for_text("learnTest1", "Good.")
    assert learning.button("learnChannelAgainButton").text() == "&Learn channel 2 again"
    learning.click("learnChannelAgainButton")
    learning.wait_for_head("Release every stick")
    bars = learning.find_all(ChannelBar)
    assert [bar.accessibleName()[-1] for bar in bars] == ["2"]


def test_stick_test_does_not_start_while_motors_are_armed(learning: LearningDialog) -> None:
    motors = learning.device.motors
    learning.use({1: Stick()})
    for deadband in (80, 90):
        learning.go_to_review(1)
        learning.set_value("Deadband", 1, deadband)
        learning.click("learnUseButton")
        motors.arm()
        motors.set_speed(1, 40)
        learning.apply()
        learning.wait_for_head("The test does not start by itself")
        assert learning.dialog.isVisible()
        assert not learning.can_click("learnAgainButton")
        assert motors.armed
        if deadband == 80:
            learning.click("learnCancelButton")
            assert not learning.dialog.isVisible()
            assert motors.armed

    learning.click("learnTestButton")
    learning.wait_for_head("Push every stick")
    assert not motors.armed


def test_stick_test_continues_after_a_short_power_cycle(learning: LearningDialog) -> None:
    """The cycle is too short for the program to miss the board."""
    sticks = {1: Stick(), 2: Stick(), 3: Stick()}
    learning.use(sticks)
    learning.start_test(*sticks)
    learning.simulator.do("power cycle")
    learning.push(1, -1)
    for channel in sticks:
        learning.wait_for_text(f"learnTest{channel}", "Good.")
    assert learning.device.link is ConnectionState.CONNECTED
    learning.assert_nothing_changed()
