"""What a board holds, by what it said and what was written since."""

from dataclasses import replace

import pytest

from trex_gui.link.reading import DeviceState
from trex_gui.link.settings import LinkSettings
from trex_gui.link.writing import Written
from trex_gui.model.board_state import after_writing, in_force
from trex_gui.model.reset_order import ResetOrder
from trex_gui.protocol.calibration import DEFAULT_CALIBRATION, Calibration
from trex_gui.protocol.commands import Signature
from trex_gui.protocol.device_table import device_table
from trex_gui.protocol.errors import NoReply
from trex_gui.protocol.flags import InputSource, Mode, channel_mask
from trex_gui.protocol.line_settings import Detection, LineSettings

FACTORY = DEFAULT_CALIBRATION[InputSource.RC]
LEARNED = Calibration(2400, 3700, 5100, 80)
STATE = DeviceState(
    Signature(device_table().model("trex"), "1.2"),
    Mode.SERIAL_RC,
    True,
    {"motor_mode": 0, "serial_timeout": 0},
    dict.fromkeys(range(1, 6), FACTORY),
    calibrated=0,
)
ORDERED = (Written("factory_reset", 1),)


def test_what_was_read_back_is_what_the_board_holds() -> None:
    after = after_writing(STATE, [Written("motor_mode", 1), Written("channel 2", LEARNED)])
    assert after.parameters == {"motor_mode": 1, "serial_timeout": 0}
    assert after.calibrations[2] == LEARNED
    assert after.calibrations[1] == FACTORY
    assert after.calibrated == channel_mask({2})
    assert STATE.parameters["motor_mode"] == 0


def test_a_channel_with_the_factorys_calibration_counts_as_not_calibrated() -> None:
    learned = after_writing(STATE, [Written("channel 2", LEARNED)])
    assert after_writing(learned, [Written("channel 2", FACTORY)]).calibrated == 0


@pytest.mark.parametrize(
    "result",
    [
        Written("motor_mode", error=NoReply("x")),
        Written("channel 2", error=NoReply("x")),
        Written("factory_reset", 1),  # is no parameter that the board shows
    ],
)
def test_what_was_not_read_back_changes_nothing(result: Written) -> None:
    assert after_writing(STATE, [result]) == STATE


@pytest.mark.parametrize(("what", "channel"), [("channel 3", 3), ("channel_input_source", None)])
def test_a_result_knows_its_channel(what: str, channel: int | None) -> None:
    assert Written(what).channel == channel


def test_the_line_shows_what_is_in_force_whatever_is_stored() -> None:
    line = LineSettings(57600, Detection.CRC7)
    shown = in_force(STATE, LinkSettings("virtual", line, polynomial=0x91))
    assert shown == {
        "uart_settings": line.to_wire(),
        "crc7_polynomial": 0x11,
        "channel_input_source": 0,
    }


def test_without_crc_nobody_knows_the_polynomial_in_force() -> None:
    assert "crc7_polynomial" not in in_force(STATE, LinkSettings("virtual"))


def test_outside_serial_mode_the_jumper_decides_and_not_the_stored_source() -> None:
    assert in_force(replace(STATE, mode=Mode.ANALOG), None) == {}


# --- The order to reset -----------------------------------------------------------------


def ordered() -> ResetOrder:
    order = ResetOrder()
    order.note_written(ORDERED, STATE.parameters)
    assert order.stands
    return order


def test_a_reset_that_was_refused_does_not_stand() -> None:
    order = ResetOrder()
    order.note_written([Written("factory_reset", error=NoReply("x"))], STATE.parameters)
    order.note_written([Written("motor_mode", 1)], STATE.parameters)
    assert not order.stands


def test_a_reset_stands_while_the_board_shows_the_same() -> None:
    order = ordered()
    order.note_read(STATE.parameters, power_cycled=False)
    assert order.stands


def test_a_power_cycle_carries_out_a_reset() -> None:
    order = ordered()
    order.note_read(STATE.parameters, power_cycled=True)
    assert not order.stands


def test_a_board_that_shows_other_values_has_started_anew() -> None:
    order = ordered()
    order.note_read({**STATE.parameters, "motor_mode": 1}, power_cycled=False)
    assert not order.stands


def test_a_person_knows_that_the_power_was_off() -> None:
    order = ordered()
    order.forget()
    assert not order.stands
