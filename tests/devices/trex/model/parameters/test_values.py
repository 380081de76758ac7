"""Stored, edited and active values."""

from contextlib import suppress

from hypothesis import given
from hypothesis import strategies as st

from tests.support.matrix import examples
from trex_gui.core.errors import BadRequest
from trex_gui.devices.trex.model.parameters.values import ParameterValues
from trex_gui.devices.trex.protocol.parameters import ParameterSpec, parameters_of

SPECS = parameters_of("trex", "1.2")
TIMEOUT = SPECS["serial_timeout"]
MODE = SPECS["motor_mode"]
FACTORY = {spec.key: spec.default for spec in SPECS.readable}


def values_of_board() -> ParameterValues:
    values = ParameterValues()
    values.load(FACTORY)
    return values


def test_edit_made_while_writing_stays_pending() -> None:
    values = values_of_board()
    values.edit(TIMEOUT, 9)
    values.edit(TIMEOUT, 10)
    values.record_stored(TIMEOUT, 9)
    assert values.pending == (("serial_timeout", 10),)


def test_load_retains_edits_on_request() -> None:
    for stored in (FACTORY | {"serial_timeout": 9}, {"motor_mode": 0}):
        values = values_of_board()
        values.edit(TIMEOUT, 9)
        values.load(FACTORY, keep_edits=True)
        assert dict(values.pending) == {"serial_timeout": 9}
        values.load(stored, keep_edits=True)
        assert values.pending == ()
        values.edit(MODE, 1)
        values.load(FACTORY)
        assert values.pending == ()


# --- Stored and active ------------------------------------------------------------------


def test_active_value_stays_until_a_power_cycle() -> None:
    values = values_of_board()
    values.record_stored(MODE, 1)
    uart = SPECS["uart_settings"]
    values.record_stored(uart, 3)
    values.record_stored(uart, 4)
    stored = FACTORY | {"motor_mode": 1, "uart_settings": 4}
    assert values.stored == stored
    active = {"motor_mode": 0, "uart_settings": uart.default}
    assert values.active == active
    values.load(stored, power_cycled=False)
    assert values.active == active
    values.record_stored(MODE, 0)
    assert values.active == {"uart_settings": uart.default}
    values.load(stored, power_cycled=True)
    assert values.active == {}
    unknown = ParameterValues()
    unknown.record_stored(MODE, 1)
    assert unknown.active == {}


# --- Files with some parameters ---------------------------------------------------------


def values_of_file() -> ParameterValues:
    values = ParameterValues()
    values.load({"motor_mode": 0}, optional=FACTORY)
    return values


def test_parameters_of_a_file_are_added_removed_and_restored() -> None:
    values = values_of_file()
    assert values.can_edit("serial_timeout")
    values.edit(TIMEOUT, 9)
    assert dict(values.pending) == {"serial_timeout": 9}
    values.remove("serial_timeout")
    assert values.value_of("serial_timeout") is None
    assert not values.is_modified("serial_timeout")
    values.remove("motor_mode")
    assert values.value_of("motor_mode") is None
    assert values.is_modified("motor_mode")
    assert dict(values.pending) == {}
    values.edit(MODE, 0)
    assert not values.is_modified("motor_mode")


def test_removed_parameter_survives_a_reload_of_the_same_file() -> None:
    values = values_of_file()
    values.remove("motor_mode")
    values.edit(TIMEOUT, 9)
    values.load({"motor_mode": 0}, keep_edits=True, optional=FACTORY)
    assert values.removed == {"motor_mode"}
    assert values.pending == (("serial_timeout", 9),)
    values.load({"serial_timeout": 9}, keep_edits=True, optional=FACTORY)
    assert not values.removed
    assert not values.pending


def test_parameter_of_a_board_cannot_be_removed() -> None:
    values = values_of_board()
    values.remove("motor_mode")
    assert values.value_of("motor_mode") == MODE.default
    assert not values.is_modified("motor_mode")


# --- Random edits -----------------------------------------------------------------------

Edits = list[tuple[ParameterSpec, int | None]]

edits = st.lists(
    st.tuples(st.sampled_from(SPECS.readable), st.none() | st.integers(0, 127)), max_size=25
)


def edited(edits: Edits) -> tuple[ParameterValues, dict[str, int]]:
    """Make all valid edits. Return the values and the expected wire values."""
    values, expected = values_of_board(), dict(FACTORY)
    for spec, wire in edits:
        with suppress(BadRequest):
            values.edit(spec, wire)
            expected[spec.key] = spec.default if wire is None else wire
    return values, expected


@examples(40)
@given(edits)
def test_pending_equals_the_difference_after_any_edits(edits: Edits) -> None:
    values, expected = edited(edits)
    changed = {key: wire for key, wire in expected.items() if wire != FACTORY[key]}
    assert dict(values.pending) == changed
    assert {key: values.value_of(key) for key in expected} == expected
    assert values.stored == FACTORY


@examples(40)
@given(edits)
def test_no_edit_is_pending_after_all_are_written(edits: Edits) -> None:
    values, _ = edited(edits)
    written = dict(values.pending)
    for key, wire in written.items():
        values.record_stored(SPECS[key], wire)
    assert values.pending == ()
    assert values.stored == FACTORY | written
    assert set(values.active) == {key for key in written if SPECS[key].needs_power_cycle}
