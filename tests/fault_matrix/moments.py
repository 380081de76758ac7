"""Actions of the user during a fault."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

from PySide6.QtWidgets import QDialog

from tests.fault_matrix.scene import Scene
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
        begin: does it and calls its second argument when the fault is to begin.
        end: brings it to an end, once the fault is over.
        longest_gap: seconds for which the event loop may not answer.
    """

    begin: Callable[[Scene, Inject], object]
    end: Callable[[Scene], object] = lambda _scene: None
    longest_gap: float = 0.2


def _connect(scene: Scene, inject: Inject) -> None:
    done = scene.at_step(3, inject)
    ports = scene.window.program.ports
    scene.window.connect_port(ports.add_typed(scene.url))
    scene.window.wait(done)


def _connect_and_edit(scene: Scene) -> None:
    scene.connect()
    scene.edit(motor1_acceleration=9)


def _read_all(scene: Scene, inject: Inject) -> None:
    _connect_and_edit(scene)
    done = scene.at_step(5, inject)
    scene.window.device.reload()
    scene.window.wait(done)


def _apply(step: int | None, scene: Scene, inject: Inject) -> None:
    """Apply the edits. The fault begins before a step, or before the snapshot."""
    scene.connect()
    scene.edit(**EDITS)
    scene.edit_calibration(CALIBRATION, LEARNED)
    review = ReviewDialog(scene.window)
    review.open()
    if step is None:
        inject()
        review.click("writeButton")
    else:
        done = scene.at_step(step, inject)
        review.click("writeButton")
        scene.window.wait(done)


def _end_apply(scene: Scene) -> None:
    scene.window.wait(lambda: not scene.window.device.writer.running)
    scene.window.find(QDialog, "reviewDialog").close()


def _channels_page(scene: Scene) -> ChannelsDriver:
    widget = scene.window.open_page("channelsPage").root
    assert isinstance(widget, ChannelsPage)
    return ChannelsDriver(widget, scene.window.device, scene.window.qtbot)


def _calibrate(scene: Scene, inject: Inject) -> None:
    _connect_and_edit(scene)
    page = _channels_page(scene)
    shown = page.shown()
    page.drag_handle(Handle.MAXIMUM, shown.maximum - 300, release=False)
    inject()


def _end_calibrating(scene: Scene) -> None:
    _channels_page(scene).release_handle()


def _learning_dialog(scene: Scene) -> LearningDialog:
    dialog = scene.window.dialog("learnDialog").root
    assert isinstance(dialog, Steps)
    return LearningDialog(dialog, scene.window.device, scene.board, scene.window.qtbot)


def _learn(scene: Scene, inject: Inject) -> None:
    _connect_and_edit(scene)
    learning = _learning_dialog(scene)
    learning.use({1: Stick(), 2: Stick()})
    learning.go_to_travel(1, 2)
    inject()


def _end_learning(scene: Scene) -> None:
    scene.window.find(QDialog, "learnDialog").close()


def _drive(scene: Scene, inject: Inject) -> None:
    _connect_and_edit(scene)
    _drive_connected(scene)
    inject()


def _drive_connected(scene: Scene) -> None:
    page = MotorsPage(scene.window, scene.board)
    page.arm()
    first, second = page.drag("motor1Slider", 60).value(), page.drag("motor2Slider", -60).value()
    assert max(abs(first - 60), abs(second + 60)) <= 2, "a low slider has no pixel for each value"
    scene.targets = [("forward", first), ("reverse", -second)]
    page.wait_for_targets(*scene.targets)


def _record(scene: Scene, inject: Inject) -> None:
    _connect_and_edit(scene)
    path = scene.folder / "a.trexrec"
    scene.recordings.record(path)
    samples = scene.window.device.telemetry.samples
    scene.window.wait(lambda: scene.window.device.telemetry.samples > samples + 100)
    scene.files.append(path)
    inject()


def _end_recording(scene: Scene) -> None:
    scene.recordings.recorder.stop()
    scene.window.wait(lambda: scene.recordings.recorder._worker is None)


def _export(scene: Scene, inject: Inject) -> None:
    _connect_and_edit(scene)
    panel = scene.window.open_page("currentsPage").find_only(TracePanel)
    scene.window.wait(lambda: panel.plot.source is not None and panel.plot.source.span is not None)
    path = scene.folder / "a.csv"
    scene.files.append(path)
    scene.listen_to(panel.notifier)
    inject()
    panel.export.save_table(path, float("-inf"), float("inf"))


def _find_dialog(scene: Scene) -> FindBoardDialog:
    dialog = scene.window.find(FindDialog, "findDialog")
    scanner = scene.window.program.device_manager.scanner
    return FindBoardDialog(dialog, scanner, scene.window.qtbot)


def _find(scene: Scene, inject: Inject) -> None:
    scene.window.click("findButton")
    find = _find_dialog(scene)
    find.search(scene.window, scene.url)
    scene.let_pass(0.2)
    inject()


def _end_finding(scene: Scene) -> None:
    find = _find_dialog(scene)
    find.wait_for_end()
    scene.hear_all(find.root)
    find.root.close()


def _close(scene: Scene, inject: Inject) -> None:
    scene.connect()  # without edits, for which the window would ask what to do
    _drive_connected(scene)
    inject()
    scene.window.window.close()


MOMENTS: dict[str, Moment] = {
    "connect": Moment(_connect),
    "read_all": Moment(_read_all),
    "apply_snapshot": Moment(partial(_apply, None), _end_apply),
    "apply_calibration": Moment(partial(_apply, 0), _end_apply),
    "apply_parameters": Moment(partial(_apply, 2), _end_apply),
    "apply_line_settings": Moment(partial(_apply, 4), _end_apply),
    "apply_verified": Moment(partial(_apply, 5), _end_apply),
    "calibration": Moment(_calibrate, _end_calibrating),
    "learning": Moment(_learn, _end_learning),
    "driving": Moment(_drive),
    "recording": Moment(_record, _end_recording),
    "export": Moment(_export),
    "find": Moment(_find, _end_finding),
    # Closing waits up to a second for the line, which stops the motors first.
    "closing": Moment(_close, longest_gap=1.2),
}

DRIVING = ["driving", "closing"]
"""Moments at which motors turn."""

APPLYING = [name for name in MOMENTS if name.startswith("apply")]
"""Moments at which edits are written."""
