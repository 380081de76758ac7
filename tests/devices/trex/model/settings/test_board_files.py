"""Files of boards that are read in the background."""

import pytest
from pytestqt.qtbot import QtBot

from trex_gui.devices.trex.model.settings.board_files import RecordFiles
from trex_gui.devices.trex.model.settings.draft import SettingsDraft
from trex_gui.devices.trex.protocol.commands import Signature
from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.devices.trex.settings.accepted import AcceptedValues
from trex_gui.ui.files import background

TREX, JUNIOR = (Signature(model, "1.2") for model in device_table().models)


@pytest.mark.parametrize("simulated", [TREX, JUNIOR], ids=str)
def test_late_values_of_the_previous_board_are_not_accepted(
    qtbot: QtBot, simulated: Signature
) -> None:
    AcceptedValues().add(TREX, {"ignored_channels": 63})
    draft = SettingsDraft()
    records = RecordFiles(draft)
    records.set_kind(TREX, opened=True, is_simulated=False)
    qtbot.waitUntil(lambda: bool(draft.parameters.values.accepted))
    records.set_kind(TREX, opened=True, is_simulated=False)
    records.set_kind(simulated, opened=True, is_simulated=True)
    qtbot.waitUntil(lambda: not background)
    assert draft.parameters.values.accepted == {}
