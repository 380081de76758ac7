"""The keys in code are those of the parameter table."""

import pytest

from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.devices.trex.protocol.parameters import MotorParameter, ParameterKey

TABLE_KEYS = {row["key"] for row in device_table().rows}


@pytest.mark.parametrize("key", ParameterKey)
def test_parameter_key_is_in_table_and_named_after_it(key: ParameterKey) -> None:
    assert key in TABLE_KEYS
    assert key.name == key.upper()


@pytest.mark.parametrize("parameter", MotorParameter)
@pytest.mark.parametrize("motor", [1, 2])
def test_motor_parameter_is_in_table_for_both_motors(parameter: MotorParameter, motor: int) -> None:
    assert parameter.of(motor) in TABLE_KEYS
