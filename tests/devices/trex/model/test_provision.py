"""Setup of several boards without a window."""

from dataclasses import replace
from pathlib import Path

from pytestqt.qtbot import QtBot

from tests.devices.trex.model.device_setup import DeviceSetup
from tests.support.simulator import SimulatedDevice
from trex_gui.devices.trex.model.provision import Provision, ProvisionStep
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.devices.trex.settings.document import factory_settings
from trex_gui.devices.trex.settings.provision_record import ProvisionRecord


def test_board_whose_number_was_not_read_is_unsuitable(
    quick_simulator: SimulatedDevice, qtbot: QtBot, tmp_path: Path
) -> None:
    setup = DeviceSetup(qtbot, quick_simulator)
    device, provision = setup.device, Provision(setup.device)
    setup.connect()
    state = device.state
    assert state is not None
    parameters = dict(state.parameters)
    del parameters[ParameterKey.DEVICE_NUMBER]
    device.draft.set_state(replace(state, parameters=parameters), None, power_cycled=False)
    profile = factory_settings(state.signature.model, state.signature.firmware)
    provision.start(profile, ProvisionRecord(tmp_path / "record.csv"), turns_motors=False)
    assert provision.step is ProvisionStep.UNPLUG
    assert provision.problem == "Device Number: not read"
    setup.shut_down()
