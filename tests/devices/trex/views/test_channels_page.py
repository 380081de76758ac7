"""The page of the live inputs, by itself, on a simulated board."""

import math
from collections.abc import Iterator

import pytest
from pytestqt.qtbot import QtBot

from tests.support.simulator import SimulatedDevice
from tests.support.window import WidgetDriver
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.flags import CHANNELS
from trex_gui.devices.trex.views.pages.channels import STRIP_SECONDS, ChannelsPage, InputStrip
from trex_gui.ui.devices.connection import ConnectionState


class ChannelsDriver(WidgetDriver):
    """The page with a device of its own."""

    def __init__(self, qtbot: QtBot) -> None:
        self.device = Device()
        self.page = ChannelsPage(self.device)
        super().__init__(self.page, qtbot)

    def connect(self, url: str) -> None:
        self.device.connect_to(ConnectionSettings(url))
        self.wait(lambda: self.device.link is ConnectionState.CONNECTED)

    def restart(self, simulator: SimulatedDevice, *lines: str) -> None:
        """Change jumpers or stored settings, and connect to the restarted board."""
        self.device.disconnect_line()
        self.wait(lambda: self.device.link is ConnectionState.DISCONNECTED)
        simulator.do(*lines, "power cycle")
        self.connect(simulator.url)

    def functions(self) -> list[str]:
        return [self.text(f"channel{channel}Function") for channel in CHANNELS]

    def strip(self, channel: int) -> InputStrip:
        return self.find(InputStrip, f"channel{channel}Strip")


@pytest.fixture
def page(qtbot: QtBot, quick_simulator: SimulatedDevice) -> Iterator[ChannelsDriver]:
    driver = ChannelsDriver(qtbot)
    qtbot.addWidget(driver.page)
    driver.page.show()
    driver.connect(quick_simulator.url)
    yield driver
    qtbot.waitUntil(driver.device.shut_down)


def test_texts_say_what_each_channel_does_in_the_mode_of_the_board(
    page: ChannelsDriver, quick_simulator: SimulatedDevice
) -> None:
    assert page.text("channelsSummary") == (
        "Serial mode, with inputs read as RC pulses. Moving channel 1 or 2 shows whether the mix "
        "jumper is on. A count is 0.4 µs."
    )
    assert all(text.startswith("Read only; does not drive.") for text in page.functions())
    quick_simulator.do("channel 1 1800us")
    page.wait(lambda: "mix jumper is off" in page.text("channelsSummary"))
    assert "drives motor 1 (the mix jumper is off)" in page.text("channel1Function")

    page.restart(
        quick_simulator,
        "jumper mode analog",
        "eeprom ignored_channels 8",
        "eeprom reversed_channels 18",
    )
    assert "A count is 4.89 mV" in page.text("channelsSummary")
    one, two, three, four, five = page.functions()
    assert one == "Channel 1 drives motor 1; with the mix jumper on it steers."
    assert two.endswith("with the mix jumper on it drives forward and back; it is reversed.")
    assert three == "Channel 3 drives the auxiliary motor, which turns one way only."
    assert four == "Channel 4 is ignored: it is held off, whatever its input is."
    assert five.endswith("control the motors while the input is above about 3.75 V (inferred).")


def test_override_switch_changes_the_texts_at_once(
    page: ChannelsDriver, quick_simulator: SimulatedDevice
) -> None:
    page.restart(quick_simulator, "jumper mode rc")
    assert page.text("channel1Function").startswith("Channel 1 drives motor 1")
    quick_simulator.do("channel 5 1000us")
    page.wait(lambda: page.text("channel5Function").startswith("On now."))
    assert page.text("channel1Function").startswith("Does not drive now")
    quick_simulator.do("channel 5 1500us")
    page.wait(lambda: page.text("channel1Function").startswith("Channel 1 drives motor 1"))


def test_strip_shows_the_last_seconds_with_a_gap_where_the_signal_was_lost(
    page: ChannelsDriver, quick_simulator: SimulatedDevice
) -> None:
    strip = page.strip(2)
    page.wait(lambda: len(strip.lines) == 1 and strip.lines[0].count() > 20)
    quick_simulator.do("channel 2 invalid")
    page.wait(lambda: page.text("channel2Input") == "no signal")
    quick_simulator.do("channel 2 1700us")
    page.wait(lambda: len(strip.lines) == 2)
    assert strip.lines[1].last().y() == 4250
    assert len(page.strip(1).lines) == 1

    page.page.hide()
    before = strip.lines[1].count()
    page.wait(lambda: page.device.telemetry.latest > strip.lines[1].last().x() + 1)
    assert strip.lines[1].count() == before
    page.page.show()
    assert strip.lines[1].last().x() == page.device.telemetry.inputs.span[1]  # type: ignore[index]

    page.device.disconnect_line()
    page.wait(lambda: not strip.lines)


def test_strip_keeps_no_more_than_it_shows(qtbot: QtBot) -> None:
    strip = InputStrip()
    qtbot.addWidget(strip)
    for step in range(3000):
        strip.add_samples([step / 50], [math.nan if step % 500 < 10 else 3750.0])
    points = [point for line in strip.lines for point in line.toList()]
    assert min(point.x() for point in points) >= 59.98 - STRIP_SECONDS
    assert len(points) == 491
