"""Commands that save or export the settings of a board."""

from pathlib import Path

import pytest
from PySide6.QtWidgets import QFileDialog, QWidget
from pytestqt.qtbot import QtBot

from tests.support.simulator import SimulatedDevice
from tests.support.window import WidgetDriver
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.views.settings_saver import SettingsSaver


@pytest.mark.parametrize(("name", "start"), [("robot.py", "#"), ("robot", "/*")])
def test_code_is_exported_if_the_dialog_reports_no_filter(
    qtbot: QtBot,
    quick_simulator: SimulatedDevice,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    name: str,
    start: str,
) -> None:
    device, window = Device(), QWidget()
    qtbot.addWidget(window)
    driver = WidgetDriver(window, qtbot)
    device.connect_to(ConnectionSettings(quick_simulator.url))
    driver.wait(lambda: device.draft.shown is not None)
    path = tmp_path / name
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(path), ""))
    SettingsSaver(device, window).prompt_and_export()
    driver.wait_for_files()
    assert path.read_text(encoding="utf-8").startswith(start)
    device.disconnect_line()
    driver.wait(device.shut_down)
