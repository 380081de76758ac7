"""The transcript of the line to a robot, apart from that of a board."""

from tests.support.pages.robot import RobotWindow


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
