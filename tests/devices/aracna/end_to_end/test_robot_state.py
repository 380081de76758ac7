"""State of the robot in the window, also after an automatic halt."""

import re
from collections.abc import Callable, Iterator

import pytest
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from tests.support.causes import Causes, watched
from tests.support.pages.robot import RobotWindow
from tests.support.virtual_time import VirtualRuntime
from trex_gui.ui.devices.connection import ConnectionState

UNCERTAIN = "Unknown: the last motion may still be running."
AT_REST = "At rest: nothing is sent."
UNOBSERVED = "Nothing is sent. The robot may be moving: its state is unknown until its first move."


def start_long_motion(window: RobotWindow) -> None:
    """Start a motion of every motor for about 90 s."""
    window.robot.set_speeds((5,) * 8)
    window.robot.move((200,) * 8)
    window.wait(lambda: window.robot.state.moving is not None and window.servos_turn())


def test_positions_are_unknown_after_reset_or_silence(connected_window: RobotWindow) -> None:
    window, robot = connected_window, connected_window.robot
    assert window.text("aracnaMotionLabel") == UNOBSERVED
    robot.set_speeds((300,) * 8)
    window.wait(lambda: robot.state.speeds is not None)
    assert window.text("aracnaMotionLabel") == UNOBSERVED, "speeds do not show positions"
    window.move()

    texts: list[str] = []

    def record_text() -> None:
        texts.append(window.text("statusLabel"))

    for cause, end in (("reset", ""), ("line mute on", "line mute off")):
        assert window.is_enabled("aracnaCapture"), cause
        assert window.text("aracnaMotionLabel") == AT_REST, cause
        robot.changed.connect(record_text)
        window.wait_for_silence(lambda: window.control(cause))  # noqa: B023
        if end:
            window.control(end)
        window.wait_until_up()
        robot.changed.disconnect(record_text)
        assert robot.state.present == (None,) * 8, cause
        assert window.text("aracnaPresent0") == "–", cause
        assert window.text("aracnaMotionLabel") == UNCERTAIN, cause
        assert "are unknown" in window.text("aracnaTitle"), cause
        assert not window.is_enabled("aracnaCapture"), cause
        assert not window.action("aracna_capture").isEnabled(), cause
        assert window.text("statusLabel") == "Aracna", cause
        if cause == "reset":
            assert any("restarted" in text for text in texts)
        window.move()


def test_moves_are_disabled_while_motor_is_stuck(connected_window: RobotWindow) -> None:
    window, robot = connected_window, connected_window.robot
    window.move()
    window.block_and_lose_motor(3)
    window.wait_for_text("aracnaTitle", "is waiting for motor 3")
    assert "servo power" in window.page_text("aracnaRobotPage", "pageState")
    assert "does not stop the servos" in window.page_text("aracnaRobotPage", "pageState")
    assert "motor 3" in window.text("aracnaMotionLabel")
    assert window.text("aracnaState3") == "stuck here"
    assert not window.is_enabled("aracnaMoveButton")
    assert "is waiting for motor 3" in window.button("aracnaMoveButton").toolTip()
    assert not window.action("aracna_move").isEnabled()
    assert not window.action("aracna_play").isEnabled()
    window.click("aracnaLiveBox")
    window.drag("aracnaSlider0", 300, release=False)
    assert not robot.dragging
    window.release_slider("aracnaSlider0")
    window.click("aracnaLiveBox")
    window.control("servo 3 alive")
    window.wait(lambda: window.is_enabled("aracnaMoveButton"))
    assert "limits" in window.button("aracnaMoveButton").toolTip()
    window.wait_for_text("aracnaTitle", "has reached its goal")


def test_motion_is_shown_as_continuing_after_disconnect(connected_window: RobotWindow) -> None:
    window, robot = connected_window, connected_window.robot
    window.move()
    robot.set_speeds((25,) * 8)  # 7 s
    window.drag("aracnaSlider0", 100)
    window.click("aracnaMoveButton")
    window.wait(lambda: robot.remaining() > 1)
    window.click("aracnaLiveBox")
    window.press_disconnect()
    assert not window.button("aracnaLiveBox").isChecked(), "must be selected for each robot"
    assert "The motion ends by itself in about" in window.text("aracnaMotionLabel")
    window.wait(lambda: window.text("aracnaMotionLabel") == "No robot is connected.")

    window.press_connect()
    start_long_motion(window)
    window.press_disconnect()
    window.connect_port(window.program.ports.demo_of("aracna"))
    window.control("reset")  # like opening the port; the servos keep moving
    window.wait_until_up()
    assert window.servos_turn()
    assert window.text("aracnaMotionLabel").startswith("Unknown: a motion may continue")


def test_motion_is_shown_as_continuing_after_reset(connected_window: RobotWindow) -> None:
    window, robot = connected_window, connected_window.robot
    start_long_motion(window)
    texts: list[tuple[ConnectionState, str]] = []

    def record_text() -> None:
        texts.append((robot.link, window.text("aracnaMotionLabel")))

    robot.changed.connect(record_text)
    window.wait_for_silence(lambda: window.control("reset"))
    window.wait_until_up()
    robot.changed.disconnect(record_text)
    *_, last = [text for link, text in texts if link is ConnectionState.NOT_RESPONDING]
    assert last.startswith("Unknown: a motion may continue")
    assert window.servos_turn()
    assert window.text("aracnaMotionLabel").startswith("Unknown: a motion may continue")
    window.press_disconnect()
    assert "The motion ends by itself in about" in window.text("aracnaMotionLabel")
    assert robot.remaining() > 5


LOCKED = "The screen was locked"
ERROR = "Internal error (ValueError)"
REPORT_INTERVAL = 1.5  # seconds after which the same error is reported again


@pytest.fixture
def causes(connected_window: RobotWindow, qtbot: QtBot, qapp: QApplication) -> Iterator[Causes]:
    with watched(connected_window.program, qtbot, qapp) as causes:
        yield causes


def reasons(causes: Causes) -> list[tuple[str, Callable[[], None]]]:
    return [(ERROR, causes.raise_in_slot), (LOCKED, causes.lock_the_screen)]


def test_automatic_halt_at_rest_reports_that_nothing_is_sent(
    connected_window: RobotWindow, causes: Causes, virtual_time: VirtualRuntime
) -> None:
    window = connected_window
    causes.lock_the_screen()
    effect = "Nothing more is sent. A running motion continues to its goal."
    window.wait(lambda: causes.banner == f"{LOCKED}. {effect}")  # before any reply

    window.move()
    for reason, cause in reasons(causes):
        cause()
        message = f"{reason}. Nothing more is sent."
        window.wait(lambda: causes.banner == message)  # noqa: B023

    window.press_disconnect()
    before = len(causes.reports)
    causes.lock_the_screen()
    virtual_time.advance(REPORT_INTERVAL)
    assert len(causes.reports) == before, "without a robot, a locked screen is not reported"
    causes.raise_in_slot()
    window.wait(lambda: len(causes.reports) > before)
    assert causes.reports[before:] == [f"{ERROR}."]


def test_automatic_halt_reports_remaining_motion_time(
    connected_window: RobotWindow, causes: Causes
) -> None:
    window, robot = connected_window, connected_window.robot
    window.move()
    start_long_motion(window)
    for reason, cause in reasons(causes):
        remaining = robot.remaining()
        cause()
        window.wait(lambda: causes.banner.startswith(reason))  # noqa: B023
        message = re.fullmatch(
            rf"{re.escape(reason)}\. Nothing more is sent\. "
            r"The motion ends by itself in about ([\d.]+) s\.",
            causes.banner,
        )
        assert message is not None, causes.banner
        assert robot.remaining() - 1 <= float(message[1]) <= remaining + 1
        assert robot.state.moving is not None, "the motion continues"
        assert "ends by itself in about" in window.text("aracnaMotionLabel")
        assert f"{reason}." in [event.text for event in robot.events.all]
    assert len(causes.reports) == 2
    assert not [text for text in causes.reports if "stopped" in text or "confirmed" in text]
    assert window.motors.stop_reason == "", "no motor of a TReX was stopped"

    window.press_disconnect()
    before = robot.remaining()
    window.wait(lambda: robot.remaining() < before - REPORT_INTERVAL)
    causes.raise_in_slot()
    window.wait(lambda: len(causes.reports) == 3)
    assert re.fullmatch(
        rf"{re.escape(ERROR)}\. No robot is connected\. "
        r"The motion ends by itself in about [\d.]+ s\.",
        causes.reports[2],
    )
