"""State of the mix jumper, inferred from reported outputs."""

from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st
from pytestqt.qtbot import QtBot

from tests.devices.trex.settings.samples import factory
from trex_gui.devices.trex.calibration.channel_curve import is_mixed
from trex_gui.devices.trex.client.telemetry import Newest, Raw, Remapped
from trex_gui.devices.trex.model.motors import Motors
from trex_gui.devices.trex.model.settings.draft import SettingsDraft
from trex_gui.devices.trex.model.telemetry import MixJumper, Telemetry
from trex_gui.devices.trex.simulator.channel_control import motor_values

outputs = st.integers(-127, 127)


@given(turn=outputs, forward=outputs, mix=st.booleans(), skew=st.integers(-10, 10))
def test_inferred_mix_jumper_is_never_wrong(turn: int, forward: int, mix: bool, skew: int) -> None:
    first, second = motor_values([turn, forward], mix=mix, flip=False, joint=False)
    assert is_mixed((turn, forward), (first + skew, second)) in {mix, None}


@pytest.mark.parametrize("pushed", [(80, 0), (-80, 0), (0, 80), (60, 60), (127, 127)])
@pytest.mark.parametrize("mix", [True, False])
def test_pushed_stick_reveals_the_mix_jumper(pushed: tuple[int, int], mix: bool) -> None:
    speeds = motor_values(pushed, mix=mix, flip=False, joint=False)
    assert is_mixed(pushed, speeds) is mix


def test_neutral_or_inconsistent_outputs_give_no_result() -> None:
    assert is_mixed((0, 0), (0, 0)) is None
    assert is_mixed((80, 0), (-40, 90)) is None


@pytest.mark.parametrize(
    ("motor_mode", "flip", "expected"), [(0, 3750, True), (1, 3750, None), (0, 2500, None)]
)
def test_mix_jumper_is_unknown_in_joint_mode_and_while_flipped(
    qtbot: QtBot, motor_mode: int, flip: int, expected: bool | None
) -> None:
    settings = factory()
    parameters = {**settings.parameters, "motor_mode": motor_mode}
    draft, telemetry = SettingsDraft(), Telemetry(Motors().drive, Newest())
    draft.load_settings(replace(settings, parameters=parameters))
    jumper = MixJumper(draft, telemetry)
    telemetry.newest.update(Raw(1.0, (5000, 3750, 3750, flip, 3750)))
    telemetry.newest.update(Remapped(1.0, (127, -127, 0, 0, 0)))
    for _ in range(3):
        telemetry.text_due.emit()
    assert jumper.is_on is expected


def test_mix_jumper_needs_several_samples_and_ignores_neutral(qtbot: QtBot) -> None:
    jumper, states = MixJumper(SettingsDraft(), Telemetry(Motors().drive, Newest())), []
    for times, outputs, speeds in (
        (1, (80, 0), (80, -80)),
        (3, (80, 0), (80, -80)),
        (1, (80, 0), (80, 0)),
        (9, (0, 0), (0, 0)),
        (3, (80, 0), (80, 0)),
    ):
        for _ in range(times):
            jumper.feed(outputs, speeds)
        states.append(jumper.is_on)
    with qtbot.waitSignal(jumper.changed):
        jumper.clear()
    assert [*states, jumper.is_on] == [None, True, True, True, False, None]
