"""A board that no longer stores what was applied to it: said when it is connected."""

from pathlib import Path

from tests.support.simulator import SimulatedDevice, StartSimulator
from tests.support.window import WindowDriver
from trex_gui.devices.trex.settings.history import SettingsHistory
from trex_gui.devices.trex.views.load_dialog import LoadDialog


def asked(window: WindowDriver) -> str:
    return window.window.question.text


def reconnect(window: WindowDriver, url: str) -> None:
    window.disconnect()
    window.connect(url)
    window.wait(lambda: window.device.kept.files.is_idle)


def test_settings_that_a_board_lost_are_shown_and_restored(
    window: WindowDriver, quick_simulator: SimulatedDevice, start_simulator: StartSimulator
) -> None:
    lost = start_simulator()  # the same board after it lost its settings, to all appearance
    window.connect(quick_simulator.url)
    assert not asked(window), "nothing was applied yet"
    window.apply(serial_timeout=15, motor1_acceleration=3)
    reconnect(window, quick_simulator.url)
    assert not asked(window)

    reconnect(window, lost.url)
    assert "of this TReX differ from what was applied last (20" in asked(window)
    window.click("questionCancel")
    reconnect(window, lost.url)
    window.click("showDiffering")
    dialog = window.find(LoadDialog, "loadSettingsDialog")
    assert {row.key for row in dialog._view.table.ticked} == {
        "serial_timeout",
        "motor1_acceleration",
    }
    window.click("takeChangesButton")
    window.apply()
    assert lost.show()["parameters"]["serial_timeout"] == 15
    reconnect(window, lost.url)
    assert not asked(window)


def test_snapshots_keep_the_calibrations_that_the_board_hides(
    window: WindowDriver, quick_simulator: SimulatedDevice
) -> None:
    quick_simulator.do("jumper mode analog")
    quick_simulator.do("power cycle")
    window.connect(quick_simulator.url)
    window.disconnect()
    quick_simulator.do("jumper mode serial")
    quick_simulator.do("power cycle")
    window.connect(quick_simulator.url)
    window.wait(lambda: window.device.kept.files.is_idle)
    window.apply(serial_timeout=15)
    (snapshot,) = SettingsHistory().snapshots()
    assert len(SettingsHistory().load(snapshot).calibrations) == 10
    assert "# analog calibrations: read 20" in Path(snapshot.path).read_text()
