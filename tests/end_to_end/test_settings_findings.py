"""The window warns about settings that do not fit together."""

from PySide6.QtWidgets import QPushButton

from tests.support.keyboard import check_keyboard
from tests.support.pages.settings import ReviewDialog
from tests.support.virtual_devices import VirtualSimulator
from tests.support.window import WidgetDriver, WindowDriver


def findings(window: WidgetDriver, where: str = "parameter") -> list[str]:
    """Return what a page or dialog warns about."""
    names = [f"{where}Finding{index}" for index in range(9)]
    return [window.text(name) for name in names if window.has(name)]


def test_arming_warns_about_the_serial_timeout(connected_window: WindowDriver) -> None:
    window = connected_window
    window.open_page("parametersPage")
    window.wait(lambda: window.motors.is_available)
    window.motors.arm()
    window.click("parameterAccept0")
    assert window.device.parameters.values.value_of("serial_timeout") == 5


def test_review_offers_findings_and_writes_what_is_accepted(
    connected_window: WindowDriver, quick_simulator: VirtualSimulator
) -> None:
    window, device = connected_window, connected_window.device
    window.open_page("calibrationPage")
    for key, wire in {
        "ignored_channels": 1,
        "motor1_current_limit": 10,
        "motor2_current_limit": 10,
        "motor1_acceleration": 10,
        "motor1_current_limit_p": 0,
        "motor2_current_limit_p": 0,
    }.items():
        device.parameters.edit(key, wire)
    (only,) = findings(window, "calibration")
    assert only.startswith("Both required and ignored: channel 1.")
    window.window.resize(1024, 600)
    accept = window.find(QPushButton, "calibrationAccept0")
    window.wait(lambda: accept.visibleRegion().boundingRect() == accept.rect())

    review = ReviewDialog(window)
    review.open()
    check_keyboard(review.root)
    gain1, gain2, ramp2, ignored = findings(review, "review")
    assert "Motor 1 Current Limit is 3 A" in gain1
    assert "Set Motor 2 Acceleration" in ramp2
    assert "4 finding" in review.text("reviewFindingsHead")

    def shows(*expected: str) -> bool:
        return findings(review, "review") == list(expected)

    review.click("reviewAccept0")
    review.wait(lambda: shows(gain2, ramp2, ignored))
    assert "motor1_current_limit_p" not in review.values(), "the board stores that already"
    review.click("reviewAccept1")
    assert review.values()["motor2_acceleration"] == ("no ramp", "1.3 s to full speed")
    review.toggle("Motor 2 Current Limit")
    review.wait(lambda: shows(ignored))  # what waits is not checked
    review.toggle("Motor 2 Current Limit")
    review.toggle("Motor 2 Acceleration")
    review.wait(lambda: shows(gain2, ramp2, ignored))
    review.click("reviewAccept1")
    review.wait(lambda: shows(gain2, ignored))  # its edit is to be written again

    review.click("writeButton")
    review.wait_for_text("reviewHead", "written and verified")
    parameters = quick_simulator.show()["parameters"]
    assert parameters["motor1_current_limit_p"] == 4
    assert parameters["motor2_current_limit_p"] == 0
    assert parameters["motor2_acceleration"] == 10
    review.wait(lambda: shows(gain2, ignored))
    assert review.text("reviewFindingsHead").endswith("left.")
    assert not review.is_enabled("reviewAccept0")
