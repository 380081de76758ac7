"""What leads a newcomer to a first connection."""

from pathlib import Path

import pytest
from PySide6.QtWidgets import QPushButton, QSpinBox, QWidget
from serial.tools.list_ports_common import ListPortInfo

from tests.support.keyboard import check_keyboard
from tests.support.simulator import SimulatedDevice, StartSimulator
from tests.support.window import WindowDriver
from trex_gui.ui.devices.connection import ConnectionState


@pytest.fixture
def computer(monkeypatch: pytest.MonkeyPatch) -> list[ListPortInfo]:
    """The serial ports that this computer is taken to have."""
    present: list[ListPortInfo] = []
    monkeypatch.setattr("trex_gui.ui.devices.ports.list_ports.comports", lambda: list(present))
    return present


@pytest.mark.usefixtures("computer")
def test_panel_with_each_wiring_is_shown_while_nothing_is_connected(window: WindowDriver) -> None:
    status = window.open_page("statusPage")
    assert status.find(QWidget, "startPanel").isVisible()
    assert not status.find(QWidget, "statusMotors").isVisible()
    assert status.find(QWidget, "startNoPort").isVisible()
    window.click("startFind")
    assert window.has("findDialog")
    window.dialog("findDialog").root.close()

    window.click("startDemo")
    window.wait(lambda: window.device.link is ConnectionState.CONNECTED)
    assert not status.find(QWidget, "startPanel").isVisible()
    assert status.find(QWidget, "statusMotors").isVisible()

    window.disconnect()
    assert status.find(QWidget, "startPanel").isVisible()
    for way, (said, wires) in enumerate(
        (
            ("TTL levels", "TX of the adapter to SI"),
            ("SI and SO free", "TX of the RS-232 port (pin 3 of nine) to RX"),
            ("mode jumper on RC", "channels 1 and 2 of the receiver to channels 1 and 2"),
        ),
        start=1,
    ):
        window.click(f"startWay{way}")
        check_keyboard(window.window)
        shown = [number for number in (1, 2, 3) if window.has(f"startSteps{number}")]
        assert shown == [way]
        assert said in window.text(f"startSteps{way}")
        sketch = window.find(QWidget, f"wiringSketch{way}")
        assert sketch.isVisible()
        assert wires in sketch.accessibleName()


def test_port_that_is_plugged_in_is_offered_and_connected(
    computer: list[ListPortInfo], window: WindowDriver, simulator: SimulatedDevice
) -> None:
    adapter = ListPortInfo(simulator.url, skip_link_detection=True)
    adapter.description = "CP2102 & a very long name of a USB to UART bridge controller"
    computer.append(adapter)
    window.wait(lambda: not window.find(QWidget, "startNoPort").isVisible())
    panel = window.find(QWidget, "startPanel")
    button = next(b for b in panel.findChildren(QPushButton) if simulator.url in b.toolTip())
    assert adapter.description in button.toolTip()
    assert button.sizeHint().width() < panel.width() / 2
    button.click()
    window.wait(lambda: window.device.link is ConnectionState.CONNECTED)


def test_recent_files_are_offered_and_open(window: WindowDriver, tmp_path: Path) -> None:
    recent = window.window.files.recent
    group = window.find(QWidget, "startFiles")
    assert not group.isVisible()
    poses = tmp_path / "walk & turn.ppr"
    poses.write_text("low = [1, 2, 3, 4, 5, 6, 7, 8]\n")
    for number in range(6):
        recent.note("trex", "settings", tmp_path / f"{number}.txt")
    recent.note("aracna", "poses", poses)

    def shown() -> dict[str, QPushButton]:
        buttons = group.findChildren(QPushButton)
        return {Path(one.toolTip()).name: one for one in buttons if one.isVisible()}

    window.wait(shown)
    assert list(shown()) == ["walk & turn.ppr", "5.txt", "4.txt"]
    assert shown()["walk & turn.ppr"].text().startswith("walk && turn.ppr")

    shown()["5.txt"].click()
    window.wait_for_text("bannerText", "5.txt is no longer there")
    window.wait(lambda: "3.txt" in shown())
    shown()["walk & turn.ppr"].click()
    window.wait_for_text("bannerText", "walk & turn.ppr was opened.")

    recent.clear()
    assert not group.isVisible()


def test_panel_of_the_robot_leads_to_robots(
    computer: list[ListPortInfo], window: WindowDriver, start_simulator: StartSimulator
) -> None:
    robot = start_simulator("--aracna", "--unpaced")
    computer.append(ListPortInfo(robot.url, skip_link_detection=True))
    window.program.ports.refresh()
    window.program.device_manager.switch_to("aracna", lambda: None)
    panel = window.find(QWidget, "aracna_startPanel")
    assert panel.isVisible()
    assert "servo power" in window.text("aracna_startSteps1")
    assert not window.has("aracnaSlider1")
    window.click("aracna_start_aracna_offline")
    assert not panel.isVisible()
    assert not window.is_enabled("aracnaMoveButton")
    window.type_into("aracnaGoal1", "300")
    window.connect_to_demo("aracna")
    assert window.find(QSpinBox, "aracnaGoal1").value() == 300

    window.disconnect()
    window.click("aracna_startDemo")
    window.wait(lambda: window.robot.link is ConnectionState.CONNECTED)
    assert not panel.isVisible()
    assert window.has("aracnaMoveButton")

    window.program.device_manager.leave()
    window.wait(lambda: window.has("aracna_startPort"))
    window.click("aracna_startPort")
    window.wait(lambda: window.robot.link is ConnectionState.CONNECTED)
    port = window.program.device_manager.current.port
    assert port is not None
    assert port.url == robot.url
