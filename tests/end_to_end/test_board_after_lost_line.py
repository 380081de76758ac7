"""Warnings about motors that may still run after a lost connection."""

from PySide6.QtWidgets import QLabel

from tests.support.simulator import SimulatedDevice, StartSimulator
from tests.support.window import WindowDriver
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.runtime import runtime


def lose_running_board(window: WindowDriver, board: SimulatedDevice) -> None:
    """Unplug a board while its motor runs."""
    device, motors = window.device, window.motors
    window.wait(lambda: motors.is_available)
    motors.arm()
    motors.set_speed(1, 60)
    window.wait(lambda: device.may_move and board.show()["motors"][0]["direction"] == "forward")
    board.do("line unplug")
    window.wait(lambda: device.link is ConnectionState.DISCONNECTED)
    assert device.may_move


def test_pages_warn_of_running_motors_after_a_lost_line(
    window: WindowDriver, start_simulator: StartSimulator
) -> None:
    """The serial timeout needs UART-Error Shutdown here, so both settings are written."""
    danger = "Motor 1 may still be turning."
    for timeout, remedy, keeps_running in (
        (0.0, "Cut the power.", True),
        (0.9, "The board should stop its motors 0.9 s after", False),
    ):
        board = start_simulator("--unpaced", "--timeout-needs-shutdown=on", "--error-shutdown=off")
        window.connect(board.url)
        if timeout:
            with window.qtbot.waitSignal(window.device.applied):
                window.device.writer.set_serial_timeout(timeout)
        page = window.open_page("motorsPage")
        lose_running_board(window, board)
        assert f"{danger} {remedy}" in page.find(QLabel, "motorsReason").accessibleName()
        assert page.text("motorsLost").startswith(f"{danger} {remedy}")
        assert page.is_enabled("reconnectAndStop")
        assert page.button("reconnectAndStop") is window.window.focusWidget()
        assert f"{danger} {remedy}" in window.text("motorStateLabel")
        page = window.open_page("boardPage")
        assert page.text("boardLost").startswith(f"{danger} {remedy}")
        assert page.is_enabled("reconnectAndStop")
        assert not page.has("startPanel")
        assert window.text("bannerText").startswith(f"{danger} {remedy}")
        window.open_page("parametersPage")
        assert not window.has("motorStateLabel"), "the message shows the warning already"
        page = window.open_page("boardPage")
        assert window.is_enabled("stopButton")
        runtime().sleep(1.0)
        assert (board.show()["motors"][0]["direction"] == "forward") is keeps_running

        with window.qtbot.waitSignal(window.device.notifier.danger) as warning:
            window.click("stopButton")
        assert warning.args is not None
        assert warning.args[0].endswith("Trying to reach the board to stop it …")
        window.wait(lambda: window.device.link is ConnectionState.DISCONNECTED)
        assert window.text("bannerText").startswith(f"{danger} {remedy}"), "not reached"
        board.do("line plug")
        page.click("reconnectAndStop")
        window.wait(lambda: not window.device.may_move)
        window.wait_for_text("bannerText", "It has confirmed the stop.")
        assert not page.has("boardLost")
        window.disconnect()
        assert not page.has("boardLost")


def test_danger_message_remains_until_stop_is_confirmed(
    window: WindowDriver, start_simulator: StartSimulator
) -> None:
    first, second = start_simulator("--unpaced"), start_simulator("--unpaced")
    window.connect(first.url)
    lose_running_board(window, first)
    notifier = window.device.notifier
    danger = "Motor 1 may still be turning."
    notifier.info.emit("Saved.")
    notifier.error.emit("Not saved.")
    notifier.cleared.emit()
    assert window.text("bannerText").startswith(danger)
    second.do("line unplug")
    window.connect_port(window.program.ports.add_typed(second.url))
    window.wait(lambda: window.device.link is ConnectionState.DISCONNECTED)
    first.do("line plug")
    window.click("stopButton")
    window.wait(lambda: not window.device.may_move)
    assert window.device.settings is not None
    assert window.device.settings.url == first.url, "not the port that was tried last"
    window.wait_for_text("bannerText", "The board is back.")


def test_bar_warns_of_lost_board_while_another_is_connected(
    window: WindowDriver, start_simulator: StartSimulator
) -> None:
    first, second = start_simulator("--unpaced"), start_simulator("--unpaced", "--model", "trexjr")
    window.connect(first.url)
    lose_running_board(window, first)
    window.connect(second.url)
    window.wait_for_text("bannerText", "Another board responds now")
    window.click("bannerDismiss")
    for page in ("boardPage", "motorsPage", "parametersPage"):
        window.open_page(page)
        assert window.has("motorStateLabel"), page
        assert "The stop may not have reached the TReX 1.2" in window.text("motorStateLabel")
