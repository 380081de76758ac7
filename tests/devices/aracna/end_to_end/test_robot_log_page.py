"""The Log page shows the quality of the line to the robot."""

from tests.support.pages.robot import LOG_PAGE, RobotWindow
from trex_gui.ui.devices.connection import ConnectionState


def test_log_page_counts_requests_and_line_failures(connected_window: RobotWindow) -> None:
    window = connected_window
    window.show_page(LOG_PAGE)
    window.wait(lambda: window.text("aracnaTrafficValue").endswith("requests (100.00 %)"))
    assert window.text("aracnaQualityValue").startswith(
        "Timeouts: 0, corrupted: 0, unrecognized lines: 0"
    )
    assert window.is_enabled("aracnaTrafficValue")
    assert window.robot.state.stats.replies > 0

    window.control("line mute on")
    window.wait(lambda: window.robot.link is ConnectionState.NOT_RESPONDING)
    window.wait(lambda: not window.text("aracnaQualityValue").startswith("0 timeouts"))
    window.control("line mute off")
    window.wait_until_up()

    window.press_disconnect()
    assert window.text("aracnaTrafficValue") == "N/A"
    assert not window.is_enabled("aracnaTrafficValue")
    assert window.robot.state.stats.replies == 0, "the next line counts anew"
