"""A person learns the channels of a simulated board through the wizard's own widgets."""

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from itertools import cycle, pairwise
from typing import Any

import pytest
from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtGui import QAction
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QAbstractButton, QCheckBox, QDialog, QLabel, QSpinBox, QTabBar
from pytestqt.qtbot import QtBot

from tests.support.people import RATE, Person, Stick
from tests.support.simulator import SimulatedDevice, StartSimulator
from trex_gui.learning import neutral
from trex_gui.link.settings import LinkSettings
from trex_gui.model.device import Link
from trex_gui.protocol.flags import InputSource
from trex_gui.protocol.line_settings import LineSettings
from trex_gui.runtime import now
from trex_gui.views.pages.calibration.page import CalibrationPage
from trex_gui.views.widgets.curve_plot import CurvePlot
from trex_gui.views.widgets.scroll_box import ScrollBox
from trex_gui.window import Program

pytestmark = [
    pytest.mark.skipif(sys.platform == "win32", reason="needs pseudo-terminals"),
    # Some take six seconds of a person's time, which a computer with nine other things to do
    # makes a minute: the default limit. Every wait ends as soon as it may.
    pytest.mark.timeout(240),
]

ANALOG = InputSource.ANALOG
WORN = Stick(rest=1523, low=1090, high=1905, noise=2, lost=0.02)


UNPROVED = "not sure that the motors stand"


class Wizard:
    """The window with its wizard, the board, and somebody with a transmitter."""

    def __init__(
        self,
        program: Program,
        simulator: SimulatedDevice,
        qtbot: QtBot,
        line: LineSettings | None = None,
    ) -> None:
        self.program = program
        self.device = program.device
        self.simulator = simulator
        self.qtbot = qtbot
        self.person = Person(simulator, {})
        self.device.connect_to(LinkSettings(simulator.url, line or LineSettings()))
        self.wait(lambda: self.device.link is Link.UP)
        self.before = self.stored()

    def wait(self, condition: Callable[[], bool], timeout: int = 40_000) -> None:
        self.qtbot.waitUntil(condition, timeout=timeout)

    @property
    def dialog(self) -> QDialog:
        found = self.program.window.findChild(QDialog, "learnDialog")
        assert found is not None
        return found

    def button(self, name: str) -> QAbstractButton:
        found = self.program.window.findChild(QAbstractButton, name)
        assert found is not None, name
        return found

    def can_press(self, name: str) -> bool:
        return self.button(name).isVisible() and self.button(name).isEnabled()

    def press(self, name: str) -> None:
        try:
            self.wait(lambda: self.can_press(name))
        except self.qtbot.TimeoutError:
            pytest.fail(f"{name} cannot be pressed: {self.text('learnHead')}")
        # Buttons that come and go are laid out with the next events: nobody clicks sooner.
        QCoreApplication.sendPostedEvents()
        QTest.mouseClick(self.button(name), Qt.MouseButton.LeftButton)

    def text(self, name: str) -> str:
        label = self.dialog.findChild(QLabel, name)
        return "" if label is None else label.text()

    def until_text(self, name: str, words: str, timeout: int = 40_000) -> None:
        try:
            self.wait(lambda: words in self.text(name), timeout)
        except self.qtbot.TimeoutError:
            found = {label.objectName(): label.text() for label in self.dialog.findChildren(QLabel)}
            pytest.fail(f"{name} does not say {words!r}: {found}")

    @contextmanager
    def noting(self, *names: str) -> Iterator[list[tuple[int, list[str]]]]:
        """Note after each measurement how many there were so far, and what these labels say."""
        noted: list[tuple[int, list[str]]] = []
        telemetry = self.device.telemetry

        def note() -> None:
            noted.append((len(telemetry.inputs.times), [self.text(name) for name in names]))

        telemetry.updated.connect(note)
        yield noted
        telemetry.updated.disconnect(note)

    def stored(self) -> dict[str, Any]:
        """Everything that the board keeps, and how often it wrote any of it."""
        shown = self.simulator.show()
        found = {key: shown[key] for key in ("parameters", "calibrations", "learned")}
        return {**found, "writes": shown["counters"]["eeprom_writes"]}

    def sit_down(self, sticks: dict[int, Stick], crosstalk: float = 0.0) -> None:
        """Let somebody take their place; the window has to show what their sticks give."""
        self.person = Person(self.simulator, sticks, crosstalk)
        self.wait(lambda: self.person.rests(self.device.telemetry.raw_of))

    def choose(self, name: str) -> None:
        action = self.program.window.findChild(QAction, f"{name}Action")
        assert action is not None
        assert action.isEnabled()
        action.trigger()

    def begin(self, *channels: int) -> None:
        """Ask for learning, as the Calibration page does."""
        page = self.program.window.findChild(CalibrationPage)
        assert page is not None
        page.learn_requested.emit(channels)

    def to_rest(self, *channels: int) -> None:
        """Come to where the sticks rest; on a busy machine a stop may take more than one try."""
        self.begin(*channels)

        def is_there() -> bool:
            labels = self.dialog.findChildren(QLabel)
            unproved = any(UNPROVED in label.text() for label in labels if label.isVisible())
            if unproved and self.can_press("learnAgainButton"):
                self.press("learnAgainButton")
            return "Let go of every stick" in self.text("learnHead")

        self.wait(is_there)

    def to_travel(self, *channels: int) -> None:
        self.to_rest(*channels)
        self.press("learnNextButton")
        self.until_text("learnHead", "forward or right first")

    def hold(self) -> None:
        """Wait for as many measurements as make an end, on a busy computer too."""
        inputs = self.device.telemetry.inputs
        self.wait(lambda: len(inputs.times) > 0)
        start = float(inputs.times[-1])
        self.wait(lambda: float(inputs.times[-1]) > start + 0.4)
        before = self.device.telemetry.samples
        self.wait(lambda: self.device.telemetry.samples > before + 60)

    def push(self, *positions: float) -> None:
        """Hold every stick somewhere, one place after the other, then let go."""
        for position in positions:
            for channel in self.person.sticks:
                self.person.put(channel, position)
            self.hold()
        self.person.let_go()
        self.hold()

    def to_review(self, *channels: int) -> None:
        self.to_travel(*channels)
        self.push(1, -1)
        self.to_result()

    def to_result(self) -> None:
        self.press("learnNextButton")
        self.wait(lambda: self.button("learnTakeButton").isVisible())

    def take_and_write(self) -> None:
        self.press("learnTakeButton")
        assert not self.dialog.isVisible()
        self.press("writeButton")
        self.wait(lambda: self.device.pending == 0 and not self.device.applying)

    def assert_learned(self, channel: int) -> None:
        """The ends within 1 % of the travel and 5 deviations, the rest within 1.5 of the truth."""
        found = self.device.calibrations.stored(channel)
        assert found is not None
        stick = self.person.sticks[channel]
        low, rest, high = stick.truth()
        noise = max(1.0, stick.noise * stick.source.counts_per_unit)
        bound = 0.01 * (high - low) + 5 * noise
        assert abs(found.neutral - rest) <= 1.5 * noise
        if rest - low > bound:
            assert 0 < found.minimum - low <= bound
        else:  # it rests there: the end is as far out as the input can be
            assert found.minimum <= stick.source.lowest_count
        if high - rest > bound:
            assert 0 < high - found.maximum <= bound
        else:
            assert found.maximum >= stick.source.highest_count
        stored = self.stored()
        assert stored["calibrations"][f"{stick.source.value.lower()}_channel_{channel}"] == {
            "minimum": found.minimum,
            "neutral": found.neutral,
            "maximum": found.maximum,
            "deadband": found.deadband,
        }
        assert stored["learned"][stick.source.value.lower()] & 1 << channel - 1

    def start_in(self, mode: str) -> None:
        """Switch the board off and on with the mode jumper elsewhere, and wait for the window."""
        self.simulator.do(f"jumper mode {mode}")
        self.simulator.do("power cycle")
        self.wait(
            lambda: (
                self.device.state is not None
                and self.device.state.mode.is_serial is (mode == "serial")
            )
        )

    def assert_nothing_changed(self) -> None:
        assert self.stored() == self.before
        assert self.device.pending == 0


@pytest.fixture
def wizard(program: Program, quick_simulator: SimulatedDevice, qtbot: QtBot) -> Wizard:
    return Wizard(program, quick_simulator, qtbot)


# --- Good cases -------------------------------------------------------------------------


@pytest.mark.parametrize(
    "stick",
    [
        Stick(),
        WORN,
        Stick(rest=1440, low=900, high=2100, noise=1),
        Stick(rest=1500, low=1300, high=1700, noise=0.5),
    ],
    ids=["clean", "worn", "trimmed", "limited"],
)
def test_a_stick_is_learned_within_its_bounds(wizard: Wizard, stick: Stick) -> None:
    wizard.sit_down({1: stick})
    wizard.to_review(1)
    assert wizard.text("learnProblem1") == ""
    wizard.assert_nothing_changed()
    wizard.take_and_write()
    wizard.assert_learned(1)
    assert wizard.stored()["parameters"]["reversed_channels"] == 0


def test_all_channels_are_learned_in_one_pass(wizard: Wizard) -> None:
    wizard.sit_down(
        {
            1: WORN,
            2: Stick(rest=1480, low=1050, high=1950, noise=1, forward_is_down=True),
            3: Stick(rest=1100, low=1100, high=1900),
            4: Stick(rest=1900, low=1100, high=1900, forward_is_down=True),
            5: Stick(rest=1100, low=1100, high=1900),
        }
    )
    wizard.choose("learn")
    wizard.until_text("learnHead", "Let go of every stick")
    wizard.press("learnNextButton")
    wizard.until_text("learnHead", "forward or right first")
    wizard.push(1, -1)
    wizard.press("learnNextButton")
    wizard.wait(lambda: wizard.button("learnTakeButton").isVisible())
    boxes = [wizard.button(f"learnReversed{channel}").isChecked() for channel in range(1, 6)]
    assert boxes == [False, True, False, False, True]
    wizard.take_and_write()
    for channel in range(1, 6):
        wizard.assert_learned(channel)
    assert wizard.stored()["parameters"]["reversed_channels"] == 0b10010
    assert len(wizard.device.history.snapshots()) == 1
    # The test follows by itself.
    wizard.until_text("learnHead", "Push every stick")
    wizard.push(1, -1)
    for channel in range(1, 6):
        wizard.until_text(f"learnTest{channel}", "Good.")
    wizard.until_text("learnHead", "Everything is as it should be")
    wizard.until_text("learnSafeStart", "would release the motors")
    wizard.press("learnCancelButton")
    assert not wizard.dialog.isVisible()
    # What was said of safe-start is what the board does.
    wizard.person.put(1, 0.5)
    wizard.start_in("rc")
    wizard.wait(lambda: wizard.device.telemetry.serial_controls is False)
    wizard.hold()
    assert wizard.simulator.show()["safe_start"] is True
    wizard.person.let_go()
    wizard.wait(lambda: wizard.simulator.show()["safe_start"] is False)
    motors = wizard.simulator.show()
    assert motors["aux"]["speed"] == 0
    # A throttle whose trim goes down is no command for full speed.
    for beyond, most in ((60, 10), (100, 25)):
        wizard.simulator.do(f"channel 3 {1100 - beyond}us")
        wizard.hold()
        assert 0 < wizard.simulator.show()["aux"]["speed"] <= most
    wizard.person.let_go()
    wizard.start_in("serial")


def test_safe_start_ends_with_the_sticks_at_rest_where_they_were_learned(wizard: Wizard) -> None:
    """Rests at which the factory's calibrations hold the motors for ever."""
    wizard.sit_down({1: Stick(rest=1600), 2: Stick(rest=1420), 3: Stick(rest=1100, low=1100)})
    wizard.start_in("rc")
    wizard.wait(lambda: wizard.device.telemetry.serial_controls is False)
    wizard.hold()
    assert wizard.simulator.show()["safe_start"] is True
    wizard.start_in("serial")
    wizard.wait(lambda: wizard.device.link is Link.UP)
    wizard.wait(lambda: wizard.person.rests(wizard.device.telemetry.raw_of))
    wizard.to_review(1, 2, 3)
    wizard.take_and_write()
    wizard.until_text("learnSafeStart", "would release the motors")
    wizard.press("learnCancelButton")
    wizard.start_in("rc")
    wizard.wait(lambda: wizard.simulator.show()["safe_start"] is False)
    wizard.start_in("serial")


def test_what_is_unticked_or_changed_is_taken_as_the_person_wants(wizard: Wizard) -> None:
    wizard.sit_down({1: Stick(), 2: WORN})
    wizard.to_review(1, 2)
    box = wizard.dialog.findChild(QCheckBox, "learnInclude1")
    assert box is not None
    box.click()
    editor = wizard.dialog.findChild(QSpinBox, "learnDeadbandEdit2")
    assert editor is not None
    editor.setValue(3)
    assert "motor would creep" in wizard.text("learnProblem2")
    editor.setValue(100)
    assert wizard.text("learnProblem2") == ""
    wizard.take_and_write()
    second = wizard.device.calibrations.stored(2)
    assert second is not None
    assert second.deadband == 100
    stored, before = wizard.stored()["calibrations"], wizard.before["calibrations"]
    assert stored["rc_channel_1"] == before["rc_channel_1"]
    assert stored["rc_channel_2"] != before["rc_channel_2"]
    assert wizard.stored()["writes"] > wizard.before["writes"]
    wizard.until_text("learnHead", "Push every stick")


def test_values_in_a_wrong_order_cannot_be_taken(wizard: Wizard) -> None:
    wizard.sit_down({1: Stick()})
    wizard.to_review(1)
    editor = wizard.dialog.findChild(QSpinBox, "learnMinimumEdit1")
    assert editor is not None
    editor.setValue(4000)
    assert "would not take this: minimum 4000 is above neutral" in wizard.text("learnProblem1")
    assert not wizard.can_press("learnTakeButton")


def test_joysticks_are_learned_in_volts(
    program: Program, start_simulator: StartSimulator, qtbot: QtBot
) -> None:
    simulator = start_simulator("--unpaced")
    wizard = Wizard(program, simulator, qtbot)
    wizard.device.parameters.edit("channel_input_source", 1)
    wizard.device.apply()
    wizard.wait(lambda: wizard.device.pending == 0 and not wizard.device.applying)
    simulator.do("power cycle")
    wizard.wait(lambda: wizard.device.calibrations.source is ANALOG)
    wizard.wait(lambda: wizard.device.link is Link.UP)
    wizard.sit_down({1: Stick(rest=2.45, low=0.6, high=4.4, noise=0.01, source=ANALOG)})
    wizard.to_review(1)
    wizard.take_and_write()
    wizard.assert_learned(1)
    wizard.until_text("learnHead", "Push every stick")


def test_at_1200_baud_ends_are_held_for_longer_and_learned_as_well(
    program: Program, simulator: SimulatedDevice, qtbot: QtBot
) -> None:
    simulator.do("eeprom uart_settings 0")
    simulator.do("power cycle")
    wizard = Wizard(program, simulator, qtbot, LineSettings(1200))
    wizard.sit_down({1: Stick(rest=1523, low=1090, high=1905, noise=1)})
    wizard.to_travel(1)
    wizard.until_text("learnHead", "over this line (1200 baud) only")
    assert "Hold each end until it is ticked" in wizard.text("learnHead")
    with wizard.noting("learnTravel1") as noted:
        wizard.person.put(1, 1)
        wizard.until_text("learnTravel1", "High end reached")
    assert any("Hold it there …" in text for _, [text] in noted)
    wizard.person.put(1, -1)
    wizard.until_text("learnTravel1", "Both ends reached")
    wizard.person.let_go()
    wizard.press("learnNextButton")
    wizard.wait(lambda: wizard.button("learnTakeButton").isVisible())
    assert wizard.text("learnProblem1") == ""
    wizard.take_and_write()
    wizard.assert_learned(1)


def test_at_1200_baud_an_end_that_is_let_go_at_once_is_not_learned(
    program: Program, simulator: SimulatedDevice, qtbot: QtBot
) -> None:
    simulator.do("eeprom uart_settings 0")
    simulator.do("power cycle")
    wizard = Wizard(program, simulator, qtbot, LineSettings(1200))
    wizard.sit_down({1: Stick()})
    wizard.to_travel(1)
    wizard.until_text("learnHead", "over this line (1200 baud) only")

    def longest_rest() -> float:
        """Push and pull it, each for three seconds; return for how long it stood at most."""
        moved = [now()]
        for position in (1, -1):
            for step in range(30):
                wizard.person.put(1, position * (1 - abs(step - 15) / 15))
                moved.append(now())
                wizard.qtbot.wait(100)
        return max(after - before for before, after in pairwise(moved))

    for _ in range(8):  # a computer that stands still holds the stick
        if longest_rest() < 0.3:
            break
        wizard.press("learnAgainButton")
    wizard.press("learnNextButton")
    wizard.wait(lambda: wizard.button("learnTakeButton").isVisible())
    assert "only passed, so" in wizard.text("learnProblem1")
    assert not wizard.can_press("learnTakeButton")
    wizard.assert_nothing_changed()


# --- The review -------------------------------------------------------------------------


def test_the_review_shows_the_curve_before_and_after(wizard: Wizard) -> None:
    wizard.sit_down({1: Stick(), 2: Stick(rest=1480, low=1050, high=1950, forward_is_down=True)})
    wizard.to_review(1, 2)
    plot = wizard.dialog.findChild(CurvePlot, "learnCurve")
    tabs = wizard.dialog.findChild(QTabBar, "learnChannelTabs")
    assert plot is not None
    assert tabs is not None
    first = plot.curve
    assert first is not None
    assert not first.reversed_
    tabs.setCurrentIndex(1)
    second = plot.curve
    assert second is not None
    assert second.reversed_
    assert second.calibration.neutral == 3700
    assert wizard.text("learnCurveBefore") == "as it was"
    # The live dot follows the stick.
    wizard.person.put(2, -1)
    wizard.wait(lambda: plot.dot == (4875, -127))
    assert "output proposed −127, as it was +113" in wizard.text("learnCurveLive")
    # The numbers move the curve, and the handles move the numbers.
    editor = wizard.dialog.findChild(QSpinBox, "learnMaximumEdit2")
    assert editor is not None
    editor.setValue(4700)
    assert plot.curve is not None
    assert plot.curve.calibration.maximum == 4700
    plot.wished.emit(replace(plot.curve.calibration, maximum=4600))
    assert editor.value() == 4600
    box = wizard.button("learnReversed2")
    box.click()
    assert not plot.curve.reversed_
    # What the board would not take has no curve, only what was there before.
    editor.setValue(3000)
    wizard.wait(lambda: plot.curve is None)
    wizard.until_text("learnHead", "would not take the values of channel 2")
    wizard.assert_nothing_changed()


@pytest.mark.parametrize("factor", [1.0, 2.0])
def test_every_step_fits_a_low_screen(wizard: Wizard, factor: float) -> None:
    dialog = wizard.dialog
    font = dialog.font()
    font.setPointSizeF(font.pointSizeF() * factor)
    dialog.setFont(font)
    wizard.sit_down({channel: Stick() for channel in range(1, 6)})
    reached = []
    wizard.to_review(1, 2, 3, 4, 5)
    reached.append(dialog.minimumSizeHint())
    for words in ("forward or right first", "Let go of every stick"):
        wizard.press("learnBackButton")
        wizard.until_text("learnHead", words)
        reached.append(dialog.minimumSizeHint())
    wizard.press("learnCancelButton")
    wizard.choose("test_sticks")
    wizard.until_text("learnHead", "Push every stick")
    reached.append(dialog.minimumSizeHint())
    assert max(size.width() for size in reached) <= 900
    assert max(size.height() for size in reached) <= 480
    dialog.resize(900, 480)
    wizard.push(1, -1)
    boxes = dialog.findChildren(ScrollBox)
    assert [box.isVisible() for box in boxes] == [True]


def test_what_all_channels_have_in_common_is_said_once(wizard: Wizard) -> None:
    wizard.sit_down({1: Stick(), 2: Stick(forward_is_down=True)})
    wizard.to_review(1, 2)
    assert "so that full output is surely reached" in wizard.text("learnCommonReasons")
    for channel in (1, 2):
        assert "surely reached" not in wizard.text(f"learnReasons{channel}")
        assert "very same place" not in wizard.text(f"learnReasons{channel}")
    assert wizard.text("learnReversal1") == ""
    turned = wizard.dialog.findChild(QLabel, "learnReversal2")
    assert turned is not None
    assert "reversed is suggested" in turned.text()
    assert turned.font().bold()


def test_what_the_review_shows_as_it_was_is_what_the_board_stores(wizard: Wizard) -> None:
    device = wizard.device
    stored = device.calibrations.stored(1)
    assert stored is not None
    device.calibrations.edit(1, replace(stored, neutral=3900))
    device.parameters.edit("reversed_channels", 1)
    device.parameters.edit("serial_timeout", 9)
    device.parameters.edit("motor1_acceleration", 9)
    wizard.sit_down({1: Stick(rest=1520)})
    wizard.to_review(1)
    texts = [label.text() for label in wizard.dialog.findChildren(QLabel)]
    assert any("was 1500 µs (3750)" in text for text in texts)
    assert "was not reversed" in texts
    assert "An edit of it that waits for Apply is replaced" in wizard.text("learnReasons1")
    assert wizard.text("learnEarlierEdits") == "2 earlier edits are in the list of Apply, too."
    assert wizard.stored() == wizard.before


def test_values_that_are_stored_already_are_not_reviewed_but_tested(wizard: Wizard) -> None:
    wizard.sit_down({1: Stick()})
    wizard.to_review(1)
    wizard.take_and_write()
    wizard.until_text("learnHead", "What was learned is stored")
    wizard.press("learnCancelButton")
    wizard.to_review(1)
    writes = wizard.stored()["writes"]
    wizard.press("learnTakeButton")
    wizard.until_text("learnHead", "These values are stored already. Push every stick")
    assert not wizard.button("writeButton").isVisible()
    assert wizard.stored()["writes"] == writes


@pytest.mark.parametrize(
    ("field", "count", "words"),
    [
        ("Deadband", 3000, "there is nothing between 0 and full output"),
        ("Minimum", 3700, "reaches minimum"),
        ("Minimum", 1000, "beyond what the input can be"),
        ("Maximum", 5100, "Maximum is beyond the 2000 µs that was reached"),
    ],
)
def test_values_that_nobody_would_want_are_told(
    wizard: Wizard, field: str, count: int, words: str
) -> None:
    wizard.sit_down({1: Stick()})
    wizard.to_review(1)
    editor = wizard.dialog.findChild(QSpinBox, f"learn{field}Edit1")
    assert editor is not None
    editor.setValue(count)
    assert words in wizard.text("learnProblem1")
    wizard.press("learnCancelButton")
    wizard.assert_nothing_changed()


def test_where_a_switch_switches_is_shown(wizard: Wizard) -> None:
    wizard.sit_down({5: Stick(rest=1100, low=1100, high=1900)})
    wizard.to_review(5)
    assert "Active above 1495 µs, off at rest (inferred" in wizard.text("learnReasons5")
    assert wizard.text("learnProblem5") == ""
    wizard.button("learnReversed5").click()
    assert "It is inactive in all its positions" in wizard.text("learnProblem5")


@pytest.fixture
def sampled_for_long(monkeypatch: pytest.MonkeyPatch) -> Callable[[], None]:
    """Let rests be sampled until this is called, and then for no longer than usual.

    A second and a half is over before a test that stands still has moved a stick.
    """
    usual = neutral.SAMPLING_SECONDS
    monkeypatch.setattr(neutral, "SAMPLING_SECONDS", 60.0)
    return lambda: monkeypatch.setattr(neutral, "SAMPLING_SECONDS", usual)


# --- Bad cases --------------------------------------------------------------------------


def test_no_signal_is_said_within_a_second(wizard: Wizard) -> None:
    wizard.sit_down({2: Stick(connected=False)})
    wizard.hold()
    with wizard.noting("learnHead", "learnProblem2") as noted:
        wizard.to_rest(2)
        wizard.until_text("learnProblem2", "Is the transmitter on")
    begun = next(count for count, [head, _] in noted if "Let go of every stick" in head)
    said = next(count for count, [_, text] in noted if "Is the transmitter on" in text)
    assert said - begun <= RATE  # measurements: as many as come in a second
    wizard.press("learnNextButton")
    wizard.until_text("learnHead", "No channel rests")
    assert not wizard.can_press("learnNextButton")


def test_a_stick_that_twitches_while_it_is_sampled_is_said_and_sampled_again(
    wizard: Wizard, sampled_for_long: Callable[[], None]
) -> None:
    wizard.sit_down({1: Stick()})
    wizard.to_rest(1)
    wizard.press("learnNextButton")
    wizard.until_text("learnHead", "Sampling")
    wizard.qtbot.wait(300)
    wizard.person.put(1, 0.4)
    changed_at, positions = now(), cycle((0.0, 0.4))

    def is_said() -> bool:
        nonlocal changed_at
        if now() > changed_at + 2:  # sampling has begun anew behind a gap
            wizard.person.put(1, next(positions))
            changed_at = now()
        return "It moved while it was sampled" in wizard.text("learnProblem1")

    wizard.wait(is_said)
    sampled_for_long()
    wizard.until_text("learnHead", "No channel rests")
    assert "It moved while it was sampled" in wizard.text("learnProblem1")
    wizard.person.let_go()
    wizard.hold()
    wizard.press("learnAgainButton")
    wizard.until_text("learnHead", "forward or right first")


def test_a_stick_that_drifts_slowly_is_learned_where_it_was_meanwhile(wizard: Wizard) -> None:
    """Between where it was at the begin and at the end of the sampling, and 1 µs for rounding."""
    stick = Stick(rest=1500, drift=1.5)
    wizard.sit_down({1: stick})
    wizard.to_rest(1)
    wizard.press("learnNextButton")
    wizard.person.wait_for(2.0, wizard.qtbot.wait)
    wizard.until_text("learnHead", "forward or right first")
    wizard.push(1, -1)
    wizard.press("learnNextButton")
    wizard.wait(lambda: wizard.button("learnTakeButton").isVisible())
    assert wizard.text("learnProblem1") == ""
    wizard.take_and_write()
    found = wizard.device.calibrations.stored(1)
    assert found is not None
    assert -1 <= found.neutral / 2.5 - 1500 <= 1.5 * 2.0 + 1
    assert found.deadband == 75


@pytest.mark.parametrize(("drift", "way"), [(12, "up"), (-12, "down")])
def test_a_stick_that_drifts_away_is_said(
    wizard: Wizard, drift: float, way: str, sampled_for_long: Callable[[], None]
) -> None:
    wizard.sit_down({1: Stick(drift=drift)})
    wizard.to_rest(1)
    wizard.press("learnNextButton")
    drifted, moved_at = 0.0, now()

    def says(name: str, words: str) -> bool:
        """Let it drift on meanwhile, but not by leaps."""
        nonlocal drifted, moved_at
        moment = now()
        drifted, moved_at = drifted + min(moment - moved_at, 0.05), moment
        wizard.person.put(1, 0.0, drifted)
        return words in wizard.text(name)

    wizard.wait(lambda: says("learnProblem1", f"It drifted {way} by"))
    sampled_for_long()
    wizard.wait(lambda: says("learnHead", "No channel rests"))
    assert f"It drifted {way} by" in wizard.text("learnProblem1")
    assert not wizard.can_press("learnNextButton")


def test_lost_pulses_are_said(wizard: Wizard) -> None:
    wizard.sit_down({1: Stick(lost=0.75)})
    wizard.to_rest(1)
    wizard.press("learnNextButton")
    wizard.wait(lambda: wizard.can_press("learnAgainButton"))
    assert "valid pulse" in wizard.text("learnProblem1")


def test_noise_above_every_deadband_is_said(wizard: Wizard) -> None:
    wizard.sit_down({1: Stick(noise=60)})
    wizard.to_rest(1)
    wizard.press("learnNextButton")
    wizard.until_text("learnHead", "No channel rests")
    assert "a deadband that holds it still" in wizard.text("learnProblem1")


@pytest.mark.parametrize(
    ("stick", "positions", "words"),
    [
        (Stick(), (0,), "It never moved"),
        (Stick(low=1450, high=1550), (1, -1), "It went only 50 µs from its rest"),
        (Stick(), (1,), "It went one way only, never below its rest"),
        (Stick(low=1440), (1, -1), "The end below is only 60 µs from its rest"),
    ],
    ids=["never moves", "too little", "one direction", "end too near"],
)
def test_a_travel_that_is_no_good_is_said(
    wizard: Wizard, stick: Stick, positions: tuple[float, ...], words: str
) -> None:
    wizard.sit_down({1: stick})
    wizard.to_travel(1)
    wizard.push(*positions)
    wizard.press("learnNextButton")
    wizard.until_text("learnProblem1", words)
    assert not wizard.can_press("learnTakeButton")
    wizard.press("learnCancelButton")
    wizard.assert_nothing_changed()


def test_an_analog_input_on_which_nothing_moves_may_not_be_connected(
    program: Program, start_simulator: StartSimulator, qtbot: QtBot
) -> None:
    simulator = start_simulator("--unpaced")
    simulator.do("eeprom channel_input_source 1")
    simulator.do("power cycle")
    wizard = Wizard(program, simulator, qtbot)
    wizard.wait(lambda: wizard.device.calibrations.source is ANALOG)
    simulator.do("channel 1 silent")
    wizard.hold()
    wizard.to_travel(1)
    wizard.press("learnNextButton")
    wizard.until_text("learnProblem1", "Nothing moves on this input: it stays at 0.00 V")
    assert "Either nothing is connected to it" in wizard.text("learnProblem1")
    assert "or what is connected was not moved" in wizard.text("learnProblem1")
    assert not wizard.can_press("learnTakeButton")


def test_a_hand_on_the_stick_while_it_is_sampled_is_said_and_mended(wizard: Wizard) -> None:
    wizard.sit_down({1: Stick()})
    wizard.person.put(1, 0.2)
    wizard.wait(lambda: wizard.device.telemetry.raw_of(1) == 4000)
    wizard.to_travel(1)
    wizard.push(1, -1)
    wizard.to_result()
    words = "After letting go it rests at 1500 µs, not at 1600 µs"
    assert words in wizard.text("learnProblem1")
    assert wizard.button("learnTakeRest1").text() == "Take 1500 µs as neutral"
    wizard.press("learnTakeRest1")
    assert wizard.text("learnProblem1") == ""
    assert not wizard.button("learnTakeRest1").isVisible()
    wizard.take_and_write()
    wizard.assert_learned(1)


def test_a_trim_that_is_moved_after_sampling_is_said(wizard: Wizard) -> None:
    wizard.sit_down({1: Stick()})
    wizard.to_travel(1)
    wizard.sit_down({1: Stick(rest=1550)})
    wizard.push(1, -1)
    wizard.to_result()
    words = "After letting go it rests at 1550 µs, not at 1500 µs"
    assert words in wizard.text("learnProblem1")


def test_pushing_one_axis_of_a_stick_does_not_turn_the_other(wizard: Wizard) -> None:
    wizard.sit_down({1: Stick(), 2: Stick()}, crosstalk=-0.3)
    wizard.to_travel(1, 2)
    for channel in (2, 1):
        for position in (1.0, -1.0):
            wizard.person.put(channel, position)
            wizard.hold()
        wizard.person.put(channel, 0.0)
        wizard.hold()
    wizard.to_result()
    for channel in (1, 2):
        assert not wizard.button(f"learnReversed{channel}").isChecked()
        assert wizard.text(f"learnReversal{channel}") == ""


def test_pulses_that_are_lost_by_half_are_said(wizard: Wizard) -> None:
    wizard.sit_down({1: Stick(lost=0.5, noise=1)})
    wizard.to_rest(1)
    wizard.press("learnNextButton")
    # So many may be lacking one after the other that it is no rest; else the review tells it.
    wizard.wait(
        lambda: any(
            words in wizard.text("learnHead")
            for words in ("No channel rests", "forward or right first")
        )
    )
    if "No channel rests" not in wizard.text("learnHead"):
        wizard.push(1, -1)
        wizard.to_result()
    assert "pulse" in wizard.text("learnProblem1")


def test_a_rest_beside_the_ends_is_said(wizard: Wizard) -> None:
    wizard.sit_down({1: Stick()})
    wizard.to_rest(1)
    wizard.press("learnNextButton")
    wizard.until_text("learnHead", "forward or right first")
    wizard.sit_down({1: Stick(rest=1700, low=1650, high=2000)})
    wizard.hold()
    wizard.press("learnAgainButton")
    wizard.push(1, -1)
    wizard.press("learnNextButton")
    wizard.until_text("learnProblem1", "is not between the ends")


# --- Cancelled, and interrupted ---------------------------------------------------------

STEPS = ("to_rest", "to_travel", "to_review")


@pytest.mark.parametrize("step", STEPS)
@pytest.mark.parametrize("by", ["button", "esc", "window"])
def test_cancel_leaves_the_board_as_it_was(wizard: Wizard, step: str, by: str) -> None:
    wizard.sit_down({1: WORN})
    getattr(wizard, step)(1)
    if by == "button":
        wizard.press("learnCancelButton")
    elif by == "esc":
        QTest.keyClick(wizard.dialog, Qt.Key.Key_Escape)
    else:
        wizard.dialog.close()
    assert not wizard.dialog.isVisible()
    wizard.assert_nothing_changed()
    assert wizard.device.history.snapshots() == ()


@pytest.mark.parametrize("step", STEPS)
def test_a_plug_that_is_pulled_is_said_and_nothing_was_changed(
    program: Program, start_simulator: StartSimulator, qtbot: QtBot, step: str
) -> None:
    simulator = start_simulator("--unpaced")
    wizard = Wizard(program, simulator, qtbot)
    wizard.sit_down({1: WORN})
    getattr(wizard, step)(1)
    simulator.do("line unplug")
    wizard.until_text("learnHead", "Nothing was changed")
    assert not wizard.can_press("learnTakeButton")
    assert not wizard.can_press("learnNextButton")
    wizard.assert_nothing_changed()


def test_a_plug_that_is_pulled_ends_the_test_in_plain_words(
    program: Program, start_simulator: StartSimulator, qtbot: QtBot
) -> None:
    simulator = start_simulator("--unpaced")
    wizard = Wizard(program, simulator, qtbot)
    wizard.sit_down({1: Stick(), 2: Stick()})
    wizard.choose("test_sticks")
    wizard.until_text("learnHead", "Push every stick")
    simulator.do("line unplug")
    wizard.until_text("learnHead", "The line to the board is gone. The test has ended")
    wizard.press("learnAgainButton")
    wizard.until_text("learnHead", "Connect to a board first")
    wizard.assert_nothing_changed()
    wizard.press("learnCancelButton")
    assert not wizard.dialog.isVisible()


def test_power_that_fails_while_sticks_are_tested_is_said_and_it_goes_on_afterwards(
    wizard: Wizard,
) -> None:
    wizard.sit_down({1: Stick(), 2: Stick(), 3: Stick()})
    wizard.choose("test_sticks")
    wizard.until_text("learnHead", "Push every stick")
    wizard.simulator.do("power off")
    wizard.until_text("learnHead", "has stopped answering: its power or its cable was cut")
    assert "it changes nothing in the board" in wizard.text("learnHead")
    wizard.simulator.do("power on")
    wizard.wait(lambda: wizard.device.link is Link.UP)
    wizard.press("learnAgainButton")
    wizard.until_text("learnHead", "Push every stick")
    wizard.push(1, -1)
    for channel in (1, 2, 3):
        wizard.until_text(f"learnTest{channel}", "Good.")
    wizard.assert_nothing_changed()


def test_a_short_power_cycle_while_sticks_are_tested_leaves_nothing_hanging(
    wizard: Wizard,
) -> None:
    wizard.sit_down({1: Stick(), 2: Stick(), 3: Stick()})
    wizard.choose("test_sticks")
    wizard.until_text("learnHead", "Push every stick")
    wizard.simulator.do("power cycle")  # shorter than it takes to miss the board, or not
    wizard.wait(
        lambda: wizard.device.link is Link.UP and wizard.device.telemetry.raw_of(1) is not None
    )
    if wizard.can_press("learnAgainButton") and "stopped answering" in wizard.text("learnHead"):
        wizard.press("learnAgainButton")
        wizard.until_text("learnHead", "Push every stick")
    wizard.push(1, -1)
    for channel in (1, 2, 3):
        wizard.until_text(f"learnTest{channel}", "Good.")


def test_a_board_that_falls_silent_is_said_and_can_be_begun_again(wizard: Wizard) -> None:
    wizard.sit_down({1: WORN})
    wizard.to_travel(1)
    wizard.simulator.do("line mute on")
    wizard.until_text("learnHead", "has stopped answering")
    wizard.simulator.do("line mute off")
    wizard.wait(lambda: wizard.device.link is Link.UP)
    wizard.press("learnAgainButton")
    wizard.until_text("learnHead", "Let go of every stick")


def test_motors_that_run_are_braked_first(wizard: Wizard) -> None:
    wizard.device.motors.arm()
    wizard.device.motors.set_speed(1, 60)
    wizard.wait(lambda: wizard.simulator.show()["motors"][0]["speed"] == 60)
    wizard.to_rest(1)
    motors = wizard.simulator.show()["motors"]
    assert [motor["target_direction"] for motor in motors] == ["brake", "brake"]
    assert not wizard.device.motors.armed


def test_without_a_proved_stop_it_goes_no_further(wizard: Wizard) -> None:
    wizard.device.motors.arm()
    wizard.device.motors.set_speed(1, 60)
    wizard.wait(lambda: wizard.simulator.show()["motors"][0]["speed"] == 60)
    wizard.simulator.do("line mute on")
    wizard.begin(1)
    wizard.wait(lambda: wizard.button("learnAgainButton").isVisible())
    assert wizard.text("learnHead") not in {"", "Stopping the motors."}
    assert not wizard.can_press("learnNextButton")
    assert not wizard.can_press("learnTakeButton")
    wizard.simulator.do("line mute off")
    wizard.wait(lambda: wizard.device.link is Link.UP)


def test_a_stop_that_noise_leaves_unproved_goes_no_further(wizard: Wizard) -> None:
    wizard.device.motors.arm()
    wizard.device.motors.set_speed(1, 60)
    wizard.wait(lambda: wizard.simulator.show()["motors"][0]["speed"] == 60)
    wizard.simulator.do("line noise 0.5")
    wizard.begin(1)
    wizard.wait(lambda: wizard.can_press("learnAgainButton"))
    why = wizard.text("learnHead")
    assert "not sure that the motors stand" in why or "has stopped answering" in why
    assert not wizard.can_press("learnNextButton")
    wizard.simulator.do("line noise 0")
    wizard.wait(lambda: wizard.device.link is Link.UP)
    wizard.press("learnAgainButton")
    wizard.until_text("learnHead", "Let go of every stick")
    motors = wizard.simulator.show()["motors"]
    assert [motor["target_direction"] for motor in motors] == ["brake", "brake"]


def test_a_motor_that_goes_on_though_the_line_works_has_to_be_looked_at(wizard: Wizard) -> None:
    wizard.sit_down({1: Stick()})
    wizard.simulator.do("current 1 4.5")  # as another controller on the line would have it
    wizard.begin(1)
    wizard.until_text("learnHead", "and yet motor 1 draws 4.5 A. Look at the motors")
    assert wizard.button("learnNextButton").text() == "The motors stand: go on"
    assert not wizard.can_press("learnTakeButton")
    wizard.press("learnAgainButton")
    assert "Stopping the motors" in wizard.text("learnHead")
    wizard.simulator.do("current 1 auto")

    def stands() -> bool:
        """It may have been too late for the first time."""
        if "and yet motor 1 draws" in wizard.text("learnHead"):
            wizard.press("learnAgainButton")
        return "Let go of every stick" in wizard.text("learnHead")

    wizard.wait(stands)
    assert wizard.button("learnNextButton").text() == "Next"


def test_the_red_button_can_be_pressed_meanwhile(wizard: Wizard) -> None:
    wizard.to_rest(1)
    assert not wizard.dialog.isModal()
    wizard.press("stopButton")
    wizard.until_text("learnHead", "Let go of every stick")


@pytest.mark.parametrize("mode", ["rc", "analog"])
@pytest.mark.parametrize("action", ["learn", "test_sticks"])
def test_where_sticks_drive_motors_it_does_not_begin(
    wizard: Wizard, action: str, mode: str
) -> None:
    wizard.simulator.do(f"jumper mode {mode}")
    wizard.simulator.do("power cycle")
    wizard.wait(lambda: wizard.device.state is not None and not wizard.device.state.mode.is_serial)
    wizard.choose(action)
    wizard.until_text("learnHead", "take the mode jumper off")
    wizard.simulator.do("jumper mode serial")
    wizard.simulator.do("power cycle")
    wizard.wait(lambda: wizard.device.state is not None and wizard.device.state.mode.is_serial)


def test_a_stick_that_does_not_reach_its_end_is_said_by_the_test(wizard: Wizard) -> None:
    wizard.sit_down({1: Stick(low=1050, high=2010), 2: Stick(rest=1600)})
    wizard.choose("test_sticks")
    wizard.until_text("learnHead", "Push every stick")
    wizard.push(1, -1)
    assert wizard.text("learnTest1") == "Full output not reached yet: reverse (−127)."
    wizard.until_text("learnTest2", "at rest it must give 0")
    wizard.until_text("learnSafeStart", "channel 2 gives +")
