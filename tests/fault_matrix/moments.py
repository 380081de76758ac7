"""Actions of the user during a fault."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

from PySide6.QtWidgets import QDialog

from tests.fault_matrix.harness import FaultHarness
from tests.support.pages.channels import ChannelsDriver
from tests.support.pages.find_dialog import FindBoardDialog
from tests.support.pages.learning import LearningDialog
from tests.support.pages.motors import MotorsPage
from tests.support.pages.settings import ReviewDialog
from tests.support.transmitter import Stick
from trex_gui.devices.trex.model.calibration_moves import Handle
from trex_gui.devices.trex.protocol.calibration import Calibration, CalibrationKey
from trex_gui.devices.trex.protocol.line_settings import LineSettings
from trex_gui.devices.trex.views.pages.channels.page import ChannelsPage
from trex_gui.devices.trex.views.steps import Steps
from trex_gui.ui.frame.find_dialog import FindDialog
from trex_gui.ui.plotting.panel import TracePanel

Inject = Callable[[], object]

LEARNED = Calibration(2400, 3700, 5100, 80)
CALIBRATION = CalibrationKey.RC_CHANNEL_2

EDITS = {
    "motor1_acceleration": 9,
    "serial_timeout": 20,
    "crc7_polynomial": 0x15,
    "uart_settings": LineSettings(57600, stop_bits=2).to_wire(),
}
"""Parameters that Apply writes after the calibration of a channel, in this order."""


@dataclass(frozen=True, slots=True)
class Moment:
    """Action of the user.

    Attributes:
        start: function that begins the action and calls its second argument to inject the fault.
        end: function that ends the action after the fault.
        longest_gap: longest time in seconds in which the event loop may not respond.
    """

    start: Callable[[FaultHarness, Inject], object]
    end: Callable[[FaultHarness], object] = lambda _harness: None
    longest_gap: float = 0.2


def _connect(harness: FaultHarness, inject: Inject) -> None:
    done = harness.at_step(3, inject)
    ports = harness.window.program.ports
    harness.window.connect_port(ports.add_typed(harness.url))
    harness.window.wait(done)


def _connect_and_edit(harness: FaultHarness) -> None:
    harness.connect()
    harness.edit(motor1_acceleration=9)


def _read_all(harness: FaultHarness, inject: Inject) -> None:
    _connect_and_edit(harness)
    done = harness.at_step(5, inject)
    harness.window.device.reload()
    harness.window.wait(done)


def _apply(step: int | None, harness: FaultHarness, inject: Inject) -> None:
    """Apply the edits. The fault begins before a step, or before the snapshot without a step."""
    harness.connect()
    harness.edit(**EDITS)
    harness.edit_calibration(CALIBRATION, LEARNED)
    review = ReviewDialog(harness.window)
    review.open()
    if step is None:
        inject()
        review.click("writeButton")
    else:
        done = harness.at_step(step, inject)
        review.click("writeButton")
        harness.window.wait(done)


def _end_apply(harness: FaultHarness) -> None:
    harness.window.wait(lambda: not harness.window.device.writer.running)
    _close_dialog("reviewDialog", harness)


def _close_dialog(name: str, harness: FaultHarness) -> None:
    harness.window.find(QDialog, name).close()


def _channels_page(harness: FaultHarness) -> ChannelsDriver:
    widget = harness.window.open_page("channelsPage").root
    assert isinstance(widget, ChannelsPage)
    return ChannelsDriver(widget, harness.window.device, harness.window.qtbot)


def _calibrate(harness: FaultHarness, inject: Inject) -> None:
    _connect_and_edit(harness)
    page = _channels_page(harness)
    calibration = page.shown()
    page.drag_handle(Handle.MAXIMUM, calibration.maximum - 300, release=False)
    inject()


def _learn(harness: FaultHarness, inject: Inject) -> None:
    _connect_and_edit(harness)
    dialog = harness.window.dialog("learnDialog").root
    assert isinstance(dialog, Steps)
    learning = LearningDialog(dialog, harness.window.device, harness.board, harness.window.qtbot)
    learning.use({1: Stick(), 2: Stick()})
    learning.go_to_travel(1, 2)
    inject()


def _drive(harness: FaultHarness, inject: Inject) -> None:
    _connect_and_edit(harness)
    _drive_connected(harness)
    inject()


def _drive_connected(harness: FaultHarness) -> None:
    page = MotorsPage(harness.window, harness.board)
    page.arm()
    first, second = page.drag("motor1Slider", 60).value(), page.drag("motor2Slider", -60).value()
    assert max(abs(first - 60), abs(second + 60)) <= 2, "not every value has its own pixel"
    harness.targets = [("forward", first), ("reverse", -second)]
    page.wait_for_targets(*harness.targets)


def _record(harness: FaultHarness, inject: Inject) -> None:
    _connect_and_edit(harness)
    path = harness.folder / "a.trexrec"
    harness.recordings.record(path)
    samples = harness.window.device.telemetry.samples
    harness.window.wait(lambda: harness.window.device.telemetry.samples > samples + 100)
    harness.files.append(path)
    inject()


def _end_recording(harness: FaultHarness) -> None:
    harness.recordings.recorder.stop()
    harness.window.wait(lambda: harness.recordings.recorder._worker is None)


def _export(harness: FaultHarness, inject: Inject) -> None:
    _connect_and_edit(harness)
    panel = harness.window.open_page("currentsPage").find_only(TracePanel)
    harness.window.wait(lambda: panel.plot.source is not None and panel.plot.source.span)
    path = harness.folder / "a.csv"
    harness.files.append(path)
    harness.listen_to(panel.notifier)
    inject()
    panel.export.save_table(path, float("-inf"), float("inf"))


def _find_dialog(harness: FaultHarness) -> FindBoardDialog:
    dialog = harness.window.find(FindDialog, "findDialog")
    scanner = harness.window.program.device_manager.scanner
    return FindBoardDialog(dialog, scanner, harness.window.qtbot)


def _find(harness: FaultHarness, inject: Inject) -> None:
    harness.window.click("findButton")
    find = _find_dialog(harness)
    find.search(harness.window, harness.url)
    harness.window.wait_seconds(0.2)
    inject()


def _end_finding(harness: FaultHarness) -> None:
    find = _find_dialog(harness)
    find.wait_for_end()
    harness.record_labels(find.root)
    find.root.close()


def _close(harness: FaultHarness, inject: Inject) -> None:
    harness.connect()  # without edits, because the window would ask about them
    _drive_connected(harness)
    inject()
    harness.window.window.close()


MOMENTS: dict[str, Moment] = {
    "connect": Moment(_connect),
    "read_all": Moment(_read_all),
    "apply_snapshot": Moment(partial(_apply, None), _end_apply),
    "apply_calibration": Moment(partial(_apply, 0), _end_apply),
    "apply_parameters": Moment(partial(_apply, 2), _end_apply),
    "apply_line_settings": Moment(partial(_apply, 4), _end_apply),
    "apply_verified": Moment(partial(_apply, 5), _end_apply),
    "calibration": Moment(_calibrate, lambda harness: _channels_page(harness).release_handle()),
    "learning": Moment(_learn, partial(_close_dialog, "learnDialog")),
    "driving": Moment(_drive),
    "recording": Moment(_record, _end_recording),
    "export": Moment(_export),
    "find": Moment(_find, _end_finding),
    # Closing waits up to a second until the line has stopped the motors.
    "closing": Moment(_close, longest_gap=1.2),
}

DRIVING = ["driving", "closing"]
"""Moments at which motors run."""

APPLYING = [name for name in MOMENTS if name.startswith("apply")]
"""Moments at which edits are written."""
