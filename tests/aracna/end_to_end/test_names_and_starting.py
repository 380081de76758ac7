"""What a screen reader finds on the robot's pages, and how the program is told to begin there."""

import sys

import pytest
from PySide6.QtWidgets import QAbstractButton, QWidget
from pytestqt.qtbot import QtBot

from tests.aracna.end_to_end.person import Person
from tests.end_to_end.test_names_for_a_screen_reader import assert_named
from trex_gui import app
from trex_gui.window import Program

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="needs pseudo-terminals")


def test_everything_of_the_robot_has_a_name(program: Program, qtbot: QtBot) -> None:
    person = Person(program, qtbot)
    person.connect_to_demo()
    person.click("aracnaLimitsBox")
    for page in range(program.window.pages.count()):
        program.window.pages.setCurrentIndex(page)
        assert_named(program.window)


def test_every_control_of_the_robot_can_be_found_by_its_name(program: Program) -> None:
    page = program.window.findChild(QWidget, "aracnaRobotPage")
    assert page is not None
    buttons = page.findChildren(QAbstractButton)
    assert buttons
    assert all(button.objectName().startswith("aracna") for button in buttons)


@pytest.mark.parametrize(
    ("words", "device"),
    [(["--demo"], None), (["--demo", "--device", "aracna"], "aracna")],
)
def test_the_command_line_says_which_device(words: list[str], device: str | None) -> None:
    assert app._arguments(words).device == device


def test_a_port_goes_on_leading_to_what_was_found_there(program: Program, qtbot: QtBot) -> None:
    ports, url = program.ports, "/dev/ttyNothing8"
    ports.lead_to(ports.add_typed(url), "aracna")
    program.connect_to_port(url)
    assert program.switchboard.current.kind.key == "aracna"
    program.connect_to_port(url, "trex")
    qtbot.waitUntil(lambda: program.switchboard.current.kind.key == "trex", timeout=15_000)
    found = ports.find(url)
    assert found is not None
    assert found.device == "trex"


def test_a_device_that_nobody_knows_is_refused(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        app._arguments(["--demo", "--device", "toaster"])
    assert "toaster" in capsys.readouterr().err
