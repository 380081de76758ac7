"""Driver of the Motors page, and checks of simulated motors."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager

from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QLineEdit, QSlider, QWidget

from tests.support.simulator import SimulatedDevice
from tests.support.virtual_time import VirtualQtBot
from tests.support.window import LEFT, WindowDriver

BRAKE = ("brake", 127)

FULL = ("forward", 127)


def is_stopped(simulator: SimulatedDevice, board: str = "") -> bool:
    """Return whether both motors brake fully and the auxiliary motor is off.

    `board`: one of several on the line, such as `@9`.
    """
    shown = simulator.show(board)
    braked = {"direction": "brake", "speed": 127, "target_direction": "brake", "target_speed": 127}
    return shown["aux"] == {"speed": 0, "target_speed": 0} and all(
        {key: motor[key] for key in braked} == braked for motor in shown["motors"]
    )


def signed_speeds(simulator: SimulatedDevice, board: str = "") -> list[int]:
    """Return the signed speed of each motor. 0 while it brakes."""
    signs = {"forward": 1, "reverse": -1, "brake": 0}
    return [signs[m["direction"]] * m["speed"] for m in simulator.show(board)["motors"]]


Gesture = Callable[[], object]
"""Action with the mouse or keyboard."""


class MotorsPage(WindowDriver):
    """Window on its Motors page, connected to a simulated board.

    Attributes:
        simulator: simulated board.
    """

    def __init__(self, window: WindowDriver, simulator: SimulatedDevice) -> None:
        super().__init__(window.program, window.qtbot)
        self.simulator = simulator
        self.show_page()
        self.click("moreOptions")
        self.activate()

    def show_page(self) -> None:
        self.open_page("motorsPage")

    def let_nothing_happen(self, seconds: float) -> None:
        """Let time pass before a check that nothing has changed."""
        assert isinstance(self.qtbot, VirtualQtBot)
        self.qtbot.runtime.advance(seconds)

    # --- Arm and stop -------------------------------------------------------------------

    def arm(self) -> None:
        """Click *Arm motors* once it is enabled. Arm without a serial timeout."""
        self.motors.accept_arming_without_timeout()
        self.wait(self.button("runButton").isEnabled)
        self.click("runButton")
        self.wait(self.pad.isEnabled)

    def is_armed(self) -> bool:
        return self.motors.armed

    def press_escape(self) -> None:
        """Press Esc in the focused window."""
        window = QApplication.focusWindow()
        assert window is not None
        QTest.keyClick(window, Qt.Key.Key_Escape)

    # --- Board --------------------------------------------------------------------------

    def target(self, motor: int) -> tuple[str, int]:
        """Return the last accepted direction and speed of a motor."""
        return self.targets()[motor - 1]

    def targets(self) -> list[tuple[str, int]]:
        """Return the last accepted direction and speed of both motors."""
        motors = self.simulator.show()["motors"]
        return [(motor["target_direction"], motor["target_speed"]) for motor in motors]

    @property
    def auxiliary_target(self) -> int:
        speed: int = self.simulator.show()["aux"]["target_speed"]
        return speed

    def wait_for_targets(
        self, first: tuple[str, int] | None, second: tuple[str, int] | None, case: object = ""
    ) -> None:
        """Wait until the board accepts these setpoints. `None`: any setpoint."""

        def check() -> None:
            for motor, (target, expected) in enumerate(
                zip(self.targets(), (first, second), strict=True), 1
            ):
                labels = f"motor{motor}Setpoint", "motorsReason"
                assert expected in (None, target), (case, *map(self.text, labels))

        self.qtbot.waitUntil(check, timeout=20_000)

    def wait_for_brake(self, case: object = "") -> None:
        """Wait until the board accepts full braking of both motors."""
        self.wait_for_targets(BRAKE, BRAKE, case)

    # --- Pad ----------------------------------------------------------------------------

    @property
    def pad(self) -> QWidget:
        return self.find(QWidget, "drivePad")

    def place_in_pad(self, forward: float, turn: float) -> QPoint:
        """Return a position on the pad. At ±1 it is farther out than the knob can go."""
        middle, reach = self.pad.rect().center(), min(self.pad.width(), self.pad.height()) / 2
        return middle + QPoint(round(turn * reach), round(-forward * reach))

    def hold_pad(self, forward: float, turn: float) -> None:
        QTest.mousePress(self.pad, LEFT, pos=self.pad.rect().center())
        self.move_pad(forward, turn)

    def move_pad(self, forward: float, turn: float) -> None:
        QTest.mouseMove(self.pad, self.place_in_pad(forward, turn))

    def release_pad(self) -> None:
        QTest.mouseRelease(self.pad, LEFT, pos=self.pad.rect().center())

    # --- Sliders ------------------------------------------------------------------------

    def hold_slider(self, name: str, value: int) -> QSlider:
        """Drag the handle of a slider without releasing the mouse button."""
        return self.drag(name, value, release=False)

    def slider_value(self, name: str) -> int:
        return self.find(QSlider, name).value()

    # --- Keys ---------------------------------------------------------------------------

    def press_key(self, key: Qt.Key) -> None:
        QTest.keyPress(self.window.windowHandle(), key)

    def release_key(self, key: Qt.Key) -> None:
        QTest.keyRelease(self.window.windowHandle(), key)

    def click_key(self, key: Qt.Key) -> None:
        self.press_key(key)
        self.release_key(key)

    # --- Other windows ------------------------------------------------------------------

    @contextmanager
    def another_window(self) -> Iterator[None]:
        """Show another window in front. Return to this window at the end."""
        other = QLineEdit()
        self.qtbot.addWidget(other)
        other.show()
        other.activateWindow()
        self.wait(lambda: not self.window.isActiveWindow())
        yield
        other.close()
        self.activate()
