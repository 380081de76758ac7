"""What the window says when the program halts an Aracna by itself: its link has no stop."""

import re
from collections.abc import Callable, Iterator

import pytest
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from tests.support.causes import Causes, watched
from tests.support.pages.robot import RobotWindow
from tests.support.virtual_time import VirtualRuntime

LOCKED = "The screen was locked"
MISTAKE = "Internal error (ValueError)"
AGAIN = 1.5
"""Seconds after which the same mistake is reported again."""


@pytest.fixture
def causes(connected_window: RobotWindow, qtbot: QtBot, qapp: QApplication) -> Iterator[Causes]:
    with watched(connected_window.program, qtbot, qapp) as causes:
        yield causes


def reasons(causes: Causes) -> list[tuple[str, Callable[[], None]]]:
    return [(MISTAKE, causes.make_a_mistake), (LOCKED, causes.lock_the_screen)]


def creep(window: RobotWindow) -> None:
    """Send every motor on a way of some minutes."""
    window.robot.set_speeds((1,) * 8)
    window.robot.move((300,) * 8)
    window.wait(lambda: window.robot.remaining() > 0)


def test_automatic_halt_at_rest_reports_that_nothing_is_sent(
    connected_window: RobotWindow, causes: Causes, virtual_time: VirtualRuntime
) -> None:
    window = connected_window
    causes.lock_the_screen()
    goes_on = "Nothing more is sent; a running motion continues to its goal."
    window.wait(lambda: causes.banner == f"{LOCKED}. {goes_on}")  # before any answer

    window.move()
    for reason, cause in reasons(causes):
        cause()
        message = f"{reason}. Nothing more is sent to the robot."
        window.wait(lambda: causes.banner == message)  # noqa: B023

    window.press_disconnect()
    before = len(causes.reports)
    causes.lock_the_screen()
    virtual_time.advance(AGAIN)
    assert len(causes.reports) == before, "a locked screen is no news"
    causes.make_a_mistake()
    window.wait(lambda: len(causes.reports) > before)
    assert causes.reports[before:] == [f"{MISTAKE}."]


def test_automatic_halt_reports_remaining_motion_time(
    connected_window: RobotWindow, causes: Causes
) -> None:
    window, robot = connected_window, connected_window.robot
    window.move()
    creep(window)
    for reason, cause in reasons(causes):
        longest = robot.remaining()
        cause()
        window.wait(lambda: causes.banner.startswith(reason))  # noqa: B023
        message = re.fullmatch(
            rf"{re.escape(reason)}\. Nothing more is sent; the running motion continues to its "
            r"goal \(about (\d+) s\)\.",
            causes.banner,
        )
        assert message is not None, causes.banner
        assert robot.remaining() - 1 <= int(message[1]) <= longest + 1
        assert robot.state.moving is not None, "it continues, and the bar agrees"
        assert "ends by itself in about" in window.text("aracnaMotionLabel")
        assert f"{reason}." in [event.text for event in robot.events.all]
    assert len(causes.reports) == 2
    assert not [text for text in causes.reports if "stopped" in text or "confirmed" in text]
    assert window.motors.stop_reason == "", "nothing of a TReX was stopped either"

    window.press_disconnect()
    before = robot.remaining()
    window.wait(lambda: robot.remaining() < before - AGAIN)
    causes.make_a_mistake()
    window.wait(lambda: len(causes.reports) == 3)
    assert re.fullmatch(
        rf"{re.escape(MISTAKE)}\. No robot is connected; the motion continues "
        r"\(about \d+ s\)\.",
        causes.reports[2],
    )
