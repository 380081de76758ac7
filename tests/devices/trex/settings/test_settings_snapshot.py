"""Settings files from the state of a board."""

import pytest

from tests.devices.trex.settings.samples import factory
from trex_gui.devices.trex.client.reading import DeviceState
from trex_gui.devices.trex.protocol.calibration import DEFAULT_CALIBRATION, CalibrationKey
from trex_gui.devices.trex.protocol.commands import Signature
from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.devices.trex.protocol.flags import CHANNELS, InputSource, Mode
from trex_gui.devices.trex.settings.document import settings_of
from trex_gui.devices.trex.settings.reader import read_settings
from trex_gui.devices.trex.settings.writer import write_settings


def state_of(mode: Mode = Mode.SERIAL_RC, **changes: int) -> DeviceState:
    """Return the state of a new TReX Jr with changed values."""
    return DeviceState(
        signature=Signature(device_table().model("trexjr"), "1.2"),
        mode=mode,
        serial_controls=True,
        parameters=dict(reversed({**factory("trexjr").parameters, **changes}.items())),
        calibrations=dict.fromkeys(reversed(CHANNELS), DEFAULT_CALIBRATION[mode.source]),
        calibrated=0,
    )


@pytest.mark.parametrize(
    ("mode", "source"), [(Mode.SERIAL_RC, InputSource.RC), (Mode.SERIAL_ANALOG, InputSource.ANALOG)]
)
def test_calibrations_belong_to_active_input_source(mode: Mode, source: InputSource) -> None:
    settings = settings_of(state_of(mode))
    assert list(settings.calibrations) == [
        CalibrationKey.of(source, channel) for channel in CHANNELS
    ]


def test_device_state_is_saved_and_read_back() -> None:
    settings = settings_of(state_of(serial_timeout=15))
    assert settings.product.key == "trexjr"
    assert settings.firmware == "1.2"
    assert settings.parameters == {**factory("trexjr").parameters, "serial_timeout": 15}
    assert read_settings(write_settings(settings)) == (settings, ())


def test_invalid_value_of_board_is_retained() -> None:
    assert settings_of(state_of(uart_settings=15)).parameters["uart_settings"] == 15
