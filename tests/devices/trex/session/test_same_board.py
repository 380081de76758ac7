"""A write that changes the device number is not taken for another board."""

from tests.devices.trex.session.helpers import outcomes, run_for, staged
from trex_gui.devices.trex.session.messages import Write, Written


def test_changed_device_number_is_no_other_board() -> None:
    stage, settings = staged()
    stage.script.at(1.0, Write(1, (("device_number", 9),)))
    outcome = outcomes(run_for(stage, 5.0, settings))[1]
    assert isinstance(outcome.value, Written), outcome.error
    assert outcome.value.results[0].error is None
