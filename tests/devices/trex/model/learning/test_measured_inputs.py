"""Measurements that reach the learning of channels."""

from pytestqt.qtbot import QtBot

from trex_gui.devices.trex.client.telemetry import Newest, Raw
from trex_gui.devices.trex.model.learning.channels import MeasuredInputs
from trex_gui.devices.trex.model.telemetry import Telemetry


def test_pulse_that_is_read_in_a_burst_counts_once(qtbot: QtBot) -> None:
    telemetry = Telemetry(lambda _motor: None, Newest())
    telemetry.start(0.15)
    inputs, times = MeasuredInputs(telemetry), list[float]()
    inputs.arrived.connect(lambda measured: times.extend(time for time, _ in measured))
    inputs.start()
    for time in (1.0, 1.003, 1.006, 1.02):
        telemetry.add(Raw(time, (3750, None, 1, 2, 3)))
    telemetry.finish()
    assert times == [1.0, 1.02]
