"""Newest samples, and the history of the last hour."""

import math

import pytest
from pytestqt.qtbot import QtBot

from trex_gui.core.timing import TEXT_INTERVAL
from trex_gui.devices.trex.client.telemetry import (
    Control,
    Currents,
    LatchedStatus,
    ModeSample,
    Newest,
    Raw,
    Remapped,
    Sample,
)
from trex_gui.devices.trex.model.motors import Motors
from trex_gui.devices.trex.model.telemetry import Series, Telemetry
from trex_gui.devices.trex.protocol.flags import Mode, Status, UartError


@pytest.fixture
def motors(qtbot: QtBot) -> Motors:
    return Motors()


@pytest.fixture
def telemetry(motors: Motors) -> Telemetry:
    telemetry = Telemetry(motors.drive, Newest())
    telemetry.start(0.15)
    return telemetry


def feed(telemetry: Telemetry, *samples: Sample) -> None:
    for sample in samples:
        telemetry.newest.update(sample)
        telemetry.add(sample)
    telemetry.finish()


def test_newest_sample_of_each_kind_is_retained(telemetry: Telemetry) -> None:
    feed(
        telemetry,
        Raw(1.0, (1, 2, 3, 4, 5)),
        Remapped(1.1, (1, 2, 3, 4, 5)),
        Raw(1.2, (9, None, 3, 4, 5)),
        Control(1.3, by_serial=False),
        Remapped(1.4, (-127, 0, 3, 4, 5)),
    )
    assert telemetry.raw_of(1) == 9
    assert telemetry.raw_of(2) is None
    assert telemetry.raw_of(5) == 5
    assert telemetry.remapped_of(1) == -127
    assert telemetry.latest == 1.4
    assert telemetry.samples == 5
    raw = telemetry.raw
    feed(
        telemetry,
        LatchedStatus(2.0, Status.MOTOR1_FAULT, UartError(0)),
        ModeSample(3.0, Mode.ANALOG),
    )
    assert telemetry.raw == raw
    assert telemetry.latest == 3.0


def test_currents_are_stored_in_amperes_with_times(telemetry: Telemetry) -> None:
    feed(telemetry, Currents(1.0, (0, 10)), Currents(1.0125, (20, 255)))
    assert telemetry.motor_currents == pytest.approx((3.0, 38.25))
    assert list(telemetry.currents.times) == [1.0, 1.0125]
    assert list(telemetry.currents.values(0)) == pytest.approx([0.0, 3.0])
    assert list(telemetry.currents.values(1)) == pytest.approx([1.5, 38.25])
    telemetry.start(0.04)
    assert len(telemetry.currents) == 0
    feed(telemetry, Currents(2.0, (100, 0)))
    assert telemetry.motor_currents == pytest.approx((4.0, 0.0))


def test_batch_emits_one_update(telemetry: Telemetry) -> None:
    updates: list[None] = []
    telemetry.updated.connect(lambda: updates.append(None))
    feed(telemetry, *(Raw(float(time), (1, 2, 3, 4, 5)) for time in range(20)))
    assert len(updates) == 1


def test_text_is_updated_less_often_than_a_frame(telemetry: Telemetry) -> None:
    times: list[float] = []
    telemetry.text_due.connect(lambda: times.append(telemetry.latest))
    for frame in range(100):
        feed(telemetry, Raw(frame / 64, (1, 2, 3, 4, 5)))
    frames = range(0, 100, math.ceil(64 * TEXT_INTERVAL))
    assert times == [frame / 64 for frame in frames]


def test_text_is_updated_at_once_after_values_are_cleared(
    telemetry: Telemetry, qtbot: QtBot
) -> None:
    feed(telemetry, Raw(1.0, (1, 2, 3, 4, 5)))
    with qtbot.waitSignal(telemetry.text_due):
        telemetry.report_cleared()
    with qtbot.waitSignal(telemetry.text_due):
        feed(telemetry, Raw(1.01, (1, 2, 3, 4, 5)))


def test_views_are_updated_only_while_a_window_is_visible(telemetry: Telemetry) -> None:
    emitted: list[str] = []
    telemetry.updated.connect(lambda: emitted.append("updated"))
    telemetry.frame_due.connect(lambda: emitted.append("frame"))
    telemetry.text_due.connect(lambda: emitted.append("text"))
    telemetry.set_visible(False)
    feed(telemetry, Raw(1.0, (1, 2, 3, 4, 5)))
    telemetry.report_cleared()
    assert emitted == ["updated", "updated"]
    telemetry.set_visible(True)
    assert emitted[2:] == ["frame", "text"]
    feed(telemetry, Raw(1.01, (1, 2, 3, 4, 5)))
    assert emitted[4:] == ["updated", "frame", "text"]


def test_clear_retains_the_history(telemetry: Telemetry, qtbot: QtBot) -> None:
    feed(telemetry, Currents(1.0, (1, 2)), Raw(1.0, (1, 2, 3, 4, 5)), Control(1.0, by_serial=True))
    with qtbot.waitSignal(telemetry.updated):
        telemetry.newest.samples.clear()
        telemetry.report_cleared()
    assert telemetry.raw is None
    assert telemetry.motor_currents is None
    assert len(telemetry.currents) == 1


def test_setpoints_and_channels_are_stored_with_the_currents(
    telemetry: Telemetry, motors: Motors
) -> None:
    feed(telemetry, Currents(1.0, (0, 0)))
    assert telemetry.currents.values(Series.SETPOINT1)[0] == 0
    assert math.isnan(telemetry.currents.values(Series.CHANNEL5)[0])
    motors.set_available(available=True)
    motors.arm()
    motors.set_speed(1, -30)
    motors.set_brake(2, 127)
    feed(telemetry, Remapped(1.0, (10, 20, 30, 40, -50)), Currents(1.0125, (0, 0)))
    assert telemetry.currents.values(Series.SETPOINT1)[1] == -30
    assert telemetry.currents.values(Series.SETPOINT2)[1] == 0
    assert telemetry.currents.values(Series.CHANNEL1)[1] == 10
    assert telemetry.currents.values(Series.CHANNEL5)[1] == -50
    motors.stop()
    feed(telemetry, Currents(1.025, (0, 0)))
    assert telemetry.currents.values(Series.SETPOINT1)[2] == 0


def test_inputs_are_stored_with_times_and_gaps(telemetry: Telemetry) -> None:
    feed(telemetry, Raw(1.0, (1, None, 3, 4, 5)), Raw(1.02, (7, 8, 3, 4, 5)))
    assert list(telemetry.inputs.times) == [1.0, 1.02]
    assert list(telemetry.inputs.values(0)) == [1, 7]
    assert math.isnan(telemetry.inputs.values(1)[0])
    assert telemetry.inputs.values(1)[1] == 8
    telemetry.report_cleared()
    assert len(telemetry.inputs) == 2
    telemetry.start(0.04)
    assert len(telemetry.inputs) == 0
