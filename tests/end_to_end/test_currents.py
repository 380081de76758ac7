"""The Currents page on a simulated board in a process of its own."""

import csv
import sys
from pathlib import Path

import pytest
from PySide6.QtWidgets import QListView, QTableView
from pytestqt.qtbot import QtBot

from tests.support.simulator import SimulatedDevice
from trex_gui.link.settings import LinkSettings
from trex_gui.model.device import Link
from trex_gui.model.events import EventKind
from trex_gui.views.pages.currents import CurrentsPage
from trex_gui.window import Program

pytestmark = [
    pytest.mark.skipif(sys.platform == "win32", reason="needs pseudo-terminals"),
    pytest.mark.timeout(120),
]


class Scene:
    """The window connected to a board, on the Currents page."""

    def __init__(self, program: Program, simulator: SimulatedDevice, qtbot: QtBot) -> None:
        self.device = program.device
        self.simulator = simulator
        self.qtbot = qtbot
        self.device.connect_to(LinkSettings(simulator.url))
        qtbot.waitUntil(lambda: self.device.link is Link.UP, timeout=20_000)
        tabs = program.window.pages
        page = program.window.findChild(CurrentsPage)
        assert page is not None
        self.page = page
        for index in range(tabs.count()):
            tabs.setCurrentIndex(index)
            if page.isVisible():
                break
        assert page._panel is not None
        self.panel = page._panel

    def until_event(self, kind: EventKind, text: str) -> None:
        self.qtbot.waitUntil(
            lambda: any(
                event.kind is kind and text in event.text for event in self.device.events.all
            ),
            timeout=20_000,
        )

    def until_cell(self, row: int, column: int, text: str) -> None:
        view = self.panel.findChild(QTableView, "traceTable")
        assert view is not None
        self.qtbot.waitUntil(
            lambda: str(view.model().index(row, column).data()) == text, timeout=20_000
        )


@pytest.fixture
def scene(program: Program, quick_simulator: SimulatedDevice, qtbot: QtBot) -> Scene:
    return Scene(program, quick_simulator, qtbot)


def test_a_current_that_flows_is_seen_within_a_moment(scene: Scene) -> None:
    scene.simulator.do("current 1 6")
    scene.simulator.do("current 2 3")
    scene.until_cell(0, 1, "6.00 A")
    scene.until_cell(1, 1, "3.00 A")
    scene.simulator.do("current 1 auto")
    scene.simulator.do("current 2 auto")


def test_stop_apply_and_fault_become_marks(scene: Scene) -> None:
    scene.device.motors.press_stop()
    scene.until_event(EventKind.STOP, "Stop")
    scene.device.parameters.edit("motor1_acceleration", 40)
    scene.device.apply()
    scene.until_event(EventKind.APPLY, "Motor 1 Acceleration")
    scene.simulator.do("fault 1 on")
    scene.until_event(EventKind.FAULT, "Motor 1 fault")
    scene.simulator.do("fault 1 off")
    listed = scene.panel.findChild(QListView, "eventList")
    assert listed is not None
    scene.qtbot.waitUntil(lambda: listed.model().rowCount() >= 3, timeout=20_000)
    scene.qtbot.waitUntil(lambda: len(scene.panel.plot._strip.marks) >= 3, timeout=20_000)
    newest = scene.device.telemetry.latest
    for event in scene.device.events.all:
        assert newest - 60 < event.time < newest + 5  # the clock of the samples


def test_a_board_that_falls_silent_leaves_a_gap_and_two_events(scene: Scene) -> None:
    history = scene.device.telemetry.currents
    scene.qtbot.waitUntil(lambda: len(history) > 20, timeout=20_000)
    scene.simulator.do("line mute on")
    scene.until_event(EventKind.LINK, "stopped answering")
    scene.simulator.do("line mute off")
    scene.until_event(EventKind.LINK, "answers again")
    before = len(history)
    scene.qtbot.waitUntil(lambda: len(history) > before + 20, timeout=20_000)
    start, end = history.span or (0.0, 0.0)
    assert history.statistics(0, start, end).seconds < end - start - 0.5


def test_the_limit_that_the_board_stores_is_the_line(scene: Scene) -> None:
    scene.device.parameters.edit("motor1_current_limit", 20)
    scene.device.apply()
    source = scene.panel.plot.source
    assert source is not None
    scene.qtbot.waitUntil(
        lambda: source.limit("motor1_current") == pytest.approx(20 * 0.3), timeout=20_000
    )


def test_what_was_seen_is_exported(scene: Scene, tmp_path: Path) -> None:
    scene.simulator.do("current 1 6")
    scene.until_cell(0, 1, "6.00 A")
    with scene.qtbot.waitSignal(scene.panel.export.told, timeout=20_000):
        scene.panel.export.save_table(tmp_path / "all.csv", float("-inf"), float("inf"))
    scene.simulator.do("current 1 auto")
    with (tmp_path / "all.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert rows[0]["time (s)"] == "0.0000"
    assert float(rows[-1]["motor1_current (A)"]) == pytest.approx(6, abs=0.08)
    assert rows[-1]["motor1_wish"] == "0"
