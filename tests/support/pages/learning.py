"""Driver of the dialog that learns channels and tests sticks."""

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from PySide6.QtCore import QCoreApplication
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from tests.support.simulator import SimulatedDevice
from tests.support.transmitter import Stick, Transmitter
from tests.support.window import TIMEOUT_MS, WidgetDriver
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.learning.learning import Learning
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.line_settings import LineSettings
from trex_gui.devices.trex.views.learning.flow import LearnFlow
from trex_gui.devices.trex.views.steps import Steps
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.theme.theme import theme

HOLD_SECONDS = 0.45
"""Time for which the user holds a stick, enough to measure its end or its rest."""


class LearningDialog(WidgetDriver):
    """Dialog that learns the channels of a simulated board.

    Attributes:
        transmitter: simulated sticks.
        stored_before: settings that the board stored at first.
    """

    def __init__(
        self, dialog: Steps, device: Device, simulator: SimulatedDevice, qtbot: QtBot
    ) -> None:
        super().__init__(dialog, qtbot)
        self.dialog = dialog
        assert isinstance(dialog.flow, LearnFlow)
        self.flow = dialog.flow
        self.device = device
        self.simulator = simulator
        self.transmitter = Transmitter(simulator, {})
        self.stored_before = self.stored()

    # --- Read ---------------------------------------------------------------------------

    @property
    def note(self) -> str:
        return self.text("learnNote")

    def problem(self, channel: int) -> str:
        return self.text(f"learnProblem{channel}")

    def can_click(self, name: str) -> bool:
        return self.has(name) and self.is_enabled(name)

    def stored(self) -> dict[str, Any]:
        """Return all stored settings of the board, and the number of its writes."""
        state = self.simulator.show()
        settings = {key: state[key] for key in ("parameters", "calibrations", "learned")}
        return {**settings, "writes": state["counters"]["eeprom_writes"]}

    def assert_nothing_changed(self) -> None:
        assert self.stored() == self.stored_before
        assert self.device.draft.pending == 0

    def assert_learned(self, channel: int) -> None:
        """Assert ends within 1 % of the travel and 5 deviations, and rest within 1.5 deviations."""
        found = self.device.calibrations.stored(channel)
        assert found is not None
        stick = self.transmitter.sticks[channel]
        low, rest, high = stick.truth()
        noise = max(1.0, stick.noise * stick.source.counts_per_unit)
        bound = 0.01 * (high - low) + 5 * noise
        assert abs(found.neutral - rest) <= 1.5 * noise, channel
        if rest - low > bound:
            assert 0 < found.minimum - low <= bound, channel
        else:  # the stick rests at this end, so the calibration extends to the input's limit
            assert found.minimum <= stick.source.lowest_count, channel
        if high - rest > bound:
            assert 0 < high - found.maximum <= bound, channel
        else:
            assert found.maximum >= stick.source.highest_count, channel
        stored, source = self.stored(), stick.source.value.lower()
        assert stored["calibrations"][f"{source}_channel_{channel}"] == {
            "minimum": found.minimum,
            "neutral": found.neutral,
            "maximum": found.maximum,
            "deadband": found.deadband,
        }
        assert stored["learned"][source] & 1 << channel - 1, channel

    # --- Wait and click -----------------------------------------------------------------

    def wait_for_note(self, part: str) -> None:
        self.wait_for_text("learnNote", part)

    def click(self, name: str) -> None:
        """Click a button once it is enabled."""

        def can_click() -> None:
            assert self.can_click(name), f"{name} cannot be clicked: {self.note}"

        self.qtbot.waitUntil(can_click, timeout=TIMEOUT_MS)
        QCoreApplication.sendPostedEvents()  # updates the layout after buttons appear or disappear
        super().click(name)

    def scale_font(self, factor: float) -> None:
        font = self.dialog.font()
        font.setPointSizeF(font.pointSizeF() * factor)
        self.dialog.setFont(font)

    # --- Move sticks --------------------------------------------------------------------

    def use(self, sticks: dict[int, Stick]) -> None:
        """Connect a transmitter with these sticks. Wait for its signals."""
        self.transmitter = Transmitter(self.simulator, sticks)
        self.wait(lambda: self.transmitter.is_at_rest(self.device.telemetry.raw_of))

    def hold(self) -> None:
        """Wait for enough measurements for an end."""
        inputs = self.device.telemetry.inputs
        self.wait(lambda: len(inputs.times) > 0)
        end = float(inputs.times[-1]) + HOLD_SECONDS
        self.wait(lambda: float(inputs.times[-1]) > end)

    def push(self, *positions: float) -> None:
        """Hold all sticks at each position in turn, then release them."""
        for position in positions:
            for channel in self.transmitter.sticks:
                self.transmitter.put(channel, position)
            self.hold()
        self.transmitter.release()
        self.hold()

    # --- Go from step to step -----------------------------------------------------------

    def start_learning(self, *channels: int) -> None:
        self.flow.learn(channels)
        self.wait_for_note("Release every stick")

    def sample_rest(self) -> None:
        self.click("learnNextButton")
        self.wait_for_note("forward or right first")

    def finish_travel(self) -> None:
        self.click("learnNextButton")
        self.wait(lambda: self.has("learnReviewPage"))

    def go_to_travel(self, *channels: int) -> None:
        self.start_learning(*channels)
        self.sample_rest()

    def go_to_review(self, *channels: int) -> None:
        self.go_to_travel(*channels)
        self.push(1, -1)
        self.finish_travel()

    def start_test(self, *channels: int) -> None:
        self.flow.test(channels)
        self.wait_for_note("Push every stick")

    def apply(self) -> None:
        """Write the values without a review."""
        self.device.writer.apply()
        self.wait(lambda: self.device.draft.pending == 0 and not self.device.writer.running)


@contextmanager
def learning_dialog(
    simulator: SimulatedDevice, qtbot: QtBot, line: LineSettings | None = None
) -> Iterator[LearningDialog]:
    """Connect to a simulated board. Open the dialog without the main window."""
    app = QApplication.instance()
    assert isinstance(app, QApplication)
    theme().install(app)
    device = Device()
    device.connect_to(ConnectionSettings(simulator.url, line or LineSettings()))
    qtbot.waitUntil(lambda: device.link is ConnectionState.CONNECTED, timeout=TIMEOUT_MS)
    dialog = Steps(device, LearnFlow(Learning(device, device)))
    qtbot.addWidget(dialog)
    try:
        yield LearningDialog(dialog, device, simulator, qtbot)
    finally:
        dialog.close()
        device.motors.stop()
        qtbot.waitUntil(device.shut_down, timeout=TIMEOUT_MS)
