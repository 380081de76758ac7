"""Find, on ports that lead to a robot, to a board or to nothing."""

from PySide6.QtWidgets import QDialog, QLabel

from tests.support.pages.robot import RobotWindow
from tests.support.simulator import SimulatedDevice


def search(window: RobotWindow, url: str) -> list[str]:
    """Search a port to the end; return what was probed for, in order."""
    finder = window.program.device_manager.scanner
    texts: list[str] = []

    def note() -> None:
        texts.append(finder.text)

    finder.progressed.connect(note)
    window.trigger("find")
    finder.start([window.program.ports.add_typed(url)])
    window.wait(lambda: not finder.running, timeout=60_000)
    finder.progressed.disconnect(note)
    return [text for text in texts if text.startswith("Looking")]


def kinds(texts: list[str]) -> list[str]:
    """Return the kinds that were probed for, each once in a row."""
    names = [text.split()[2] for text in texts]
    return [name for i, name in enumerate(names) if i == 0 or names[i - 1] != name]


def test_search_finds_aracna_and_trex_and_prefers_earlier_device(
    window: RobotWindow, robot: SimulatedDevice, quick_simulator: SimulatedDevice
) -> None:
    probed = search(window, robot.url)
    assert kinds(probed) == ["TReX", "Aracna"]
    assert len(probed) <= 10
    assert window.text("findText0").startswith(f"Aracna 1 on {robot.url} at 38400 baud.")

    assert kinds(search(window, robot.url)) == [], "a robot was found there before"
    findings = window.program.device_manager.scanner.findings
    assert [finding.device for finding in findings] == ["aracna"]
    window.click("connectFound0")
    window.wait_until_up()
    window.find(QDialog, "findDialog").close()
    window.press_disconnect()

    ports = window.program.ports
    ports.lead_to(ports.add_typed(quick_simulator.url), "aracna")
    assert kinds(search(window, quick_simulator.url)) == ["Aracna", "TReX"]
    assert window.text("findText0").startswith(f"TReX 1.2 on {quick_simulator.url}")
    window.find(QDialog, "findDialog").close()


def test_silent_port_is_described_for_both_devices(
    window: RobotWindow, robot: SimulatedDevice
) -> None:
    robot.do("power off")
    assert kinds(search(window, robot.url)) == ["TReX", "Aracna", "TReX"]
    trex, aracna = window.text("findText0").split("\n\n")
    assert trex.startswith(f"No TReX responds on {robot.url} at any baud rate")
    assert aracna.startswith(f"No Aracna responds on {robot.url} at 38400 baud")
    label = window.find(QLabel, "findText0")
    window.wait(lambda: label.height() >= label.heightForWidth(label.width()) > 0)
    window.find(QDialog, "findDialog").close()


def test_search_names_the_demo(window: RobotWindow) -> None:
    window.choose_demo()
    window.press_disconnect()
    finder = window.program.device_manager.scanner
    window.trigger("find")
    finder.start([window.program.ports.demo_of("aracna")])
    window.wait(lambda: not finder.running)
    assert window.text("findText0") == "Aracna 1 on the Demo Aracna at 38400 baud."
    window.find(QDialog, "findDialog").close()
