"""The transcript of the line to a robot, apart from that of a board."""

from tests.support.pages.robot import RobotWindow
from tests.support.program import aracna
from trex_gui.ui.traffic.table import RECEIVED, SENT, WORDS, TrafficView


def column(window: RobotWindow, column: int) -> list[str]:
    model = window.find(TrafficView, "aracnaTranscriptView").model()
    return [str(model.index(row, column).data()) for row in range(model.rowCount())]


def wait_for_row(window: RobotWindow, text: str) -> None:
    window.wait(lambda: any(text in words for words in column(window, WORDS)))


def test_traffic_log_shows_motions_in_words(connected_window: RobotWindow) -> None:
    window = connected_window
    pages = aracna(window.program).workspace.pages
    pages.setCurrentIndex(pages.count() - 1)
    board = window.device.connection.traffic
    assert board.everything.count == 0
    wait_for_row(window, "Opened the Demo Aracna")
    assert window.robot.move((300,) * 8)
    wait_for_row(window, "go to 300, 300, 300, 300, 300, 300, 300, 300 → at ")
    row = column(window, SENT).index(".c300,300,300,300,300,300,300,300\\n")
    assert column(window, RECEIVED)[row].startswith(".c")
    assert any(text.startswith("set speeds") for text in column(window, WORDS)[:row])
    assert "faults: 0" in window.text("aracnaTranscriptSummary")


def test_aracna_and_trex_traffic_logs_are_separate(connected_window: RobotWindow) -> None:
    window = connected_window
    window.choose_demo("trex")
    board = window.device.connection.traffic
    board.pull()
    assert any(row.sent == b"\x81" for row in board.everything.rows)
    window.robot.traffic.pull()
    rows = window.robot.traffic.everything.rows
    assert rows[-1].note == "Closed."
    assert {row.sent for row in rows} <= {b"", b".q\n", b"\n"}
