"""Setup of several boards without a window."""

from dataclasses import replace
from pathlib import Path

from pytestqt.qtbot import QtBot

from tests.support.simulator import SimulatedDevice
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.provision import Provision, ProvisionStep
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.devices.trex.settings.document import factory_settings
from trex_gui.devices.trex.settings.provision_record import ProvisionRecord


def test_board_whose_number_was_not_read_is_unsuitable(
    quick_simulator: SimulatedDevice, qtbot: QtBot, tmp_path: Path
) -> None:
    device = Device()
    provision = Provision(device)
    device.connect_to(ConnectionSettings(quick_simulator.url))
    qtbot.waitUntil(lambda: device.is_connected)
    state = device.state
    assert state is not None
    parameters = dict(state.parameters)
    del parameters[ParameterKey.DEVICE_NUMBER]
    device.draft.set_state(replace(state, parameters=parameters), None, power_cycled=False)
    profile = factory_settings(state.signature.model, state.signature.firmware)
    provision.start(profile, ProvisionRecord(tmp_path / "record.csv"), turns_motors=False)
    assert provision.step is ProvisionStep.UNPLUG
    assert provision.problem == "Device Number: not read"
    qtbot.waitUntil(device.shut_down)
