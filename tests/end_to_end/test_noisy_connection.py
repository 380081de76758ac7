"""A noisy line is named beside the port, with the way to CRC."""

from PySide6.QtCore import QPoint
from PySide6.QtWidgets import QDialog

from tests.support.simulator import SimulatedDevice
from tests.support.window import WindowDriver
from trex_gui.ui.devices.connection import ConnectionState

CRC = 0x25  # 19200 baud with CRC-7


def test_noisy_line_is_named_and_crc_is_set_up(
    window: WindowDriver, quick_simulator: SimulatedDevice
) -> None:
    device = window.device
    window.program.complete()  # the size of each page counts
    window.connect(quick_simulator.url)
    assert window.text("qualityLabel") == ""

    def top_of_page() -> int:
        return window.window.pages.mapTo(window.window, QPoint()).y()

    window.window.resize(window.window.minimumSizeHint())
    window.wait_for_files()
    top = top_of_page()
    window.wait(lambda: window.text("qualityLabel") == "Line: good", 10_000)
    assert not window.has("setUpCrcButton")

    quick_simulator.do("line noise 0.01")
    window.wait(lambda: "use CRC" in window.text("qualityLabel"), 20_000)
    assert "% lost: noisy; shorten cable, check ground" in window.text("qualityLabel")
    window.wait(lambda: window.has("setUpCrcButton"))
    assert top_of_page() == top, "nothing moves under the pointer"
    window.motors.arm()
    window.wait(lambda: not window.has("setUpCrcButton"))
    assert window.text("qualityLabel")
    window.motors.stop()
    quick_simulator.do("line noise 0")

    window.click("setUpCrcButton")
    review = window.dialog("reviewDialog")
    assert review.root.isVisible()
    assert [device.draft.pending, device.parameters.values.value_of("uart_settings")] == [1, CRC]
    assert "Other programs on this line have to use CRC-7" in window.text("bannerText")
    review.click("writeButton")
    window.wait(lambda: device.parameters.values.stored.get("uart_settings") == CRC)
    review.root.close()
    window.click("setUpCrcButton")
    assert window.find(QDialog, "powerCycleDialog").isVisible(), "what is left to do"
    quick_simulator.do("power off")
    window.wait(lambda: device.link is ConnectionState.NOT_RESPONDING)
    assert window.text("qualityLabel") == ""
    quick_simulator.do("power on")
    window.wait(lambda: device.link is ConnectionState.CONNECTED)
    assert device.settings is not None
    assert device.settings.line.to_wire() == CRC
    assert device.parameters.values.waiting_for_power == ()

    quick_simulator.do("line noise 0.01")
    window.wait(lambda: "lost: noisy" in window.text("qualityLabel"), 20_000)
    assert "CRC" not in window.text("qualityLabel")
    assert not window.has("setUpCrcButton")
    log = [entry.text for entry in window.program.workspace("trex").log.entries]
    assert sum(text.startswith("The line is noisy: ") for text in log) == 2
