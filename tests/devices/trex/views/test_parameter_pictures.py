"""Pictures that show the effects of parameters."""

import pytest

from trex_gui.devices.trex.model.parameters.values import ParameterValues
from trex_gui.devices.trex.protocol.parameters import parameters_of
from trex_gui.devices.trex.views.pages.parameters.parameter_pictures import picture_of

SPECS = {spec.key: spec for spec in parameters_of("trex", "1.2").readable}


@pytest.mark.parametrize(
    ("key", "stored", "text", "end"),
    [
        ("motor1_acceleration", [10], "1.3 s to full speed", (1, 0)),
        ("motor1_brake_duration", [10], "100 ms", (0.2 + 0.8 / 6, 0.4)),  # the ramp is unknown
        ("motor1_brake_duration motor1_acceleration", [10, 0], "100 ms", (1, 0)),
        ("motor2_current_limit", [127], "38.1 A", (1, 0.34)),
        ("motor2_current_limit", [1], "0.3 A", (1, 0.8 / 127)),
        ("serial_timeout", [0], "keep running", (1, 0.8)),
        ("serial_timeout uart_error_shutdown", [5, 0], "may not stop", (1, 0.2)),
        ("serial_timeout uart_error_shutdown", [5, 1], "0.5 s: the motors stop", (1, 0.2)),
    ],
)
def test_picture_shows_the_effect_of_the_values(
    key: str, stored: list[int], text: str, end: tuple[float, float]
) -> None:
    keys = key.split()
    picture = picture_of(keys[0], ParameterValues(SPECS, dict(zip(keys, stored, strict=True))))
    assert picture is not None
    assert text in picture.text
    points = [point for line in picture.lines for point in line.points]
    assert all(0 <= x <= 1 and 0 <= y <= 1 for x, y in points)
    assert picture.lines[-1].points[-1] == pytest.approx(end)


def test_unknown_effects_and_values_have_no_picture() -> None:
    values = ParameterValues(SPECS, dict.fromkeys(SPECS, 0))
    for key in ("motor1_current_limit_p", "motor_mode"):
        assert picture_of(key, values) is None
    assert picture_of("motor1_acceleration", ParameterValues(SPECS)) is None
