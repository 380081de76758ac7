"""Stored, edited and active values."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.support.matrix import examples
from trex_gui.core.errors import BadRequest
from trex_gui.devices.trex.model.parameters.values import ParameterValues
from trex_gui.devices.trex.protocol.parameters import ParameterSpec, parameters_of

modest = examples(40)


SPECS = parameters_of("trex", "1.2")
TIMEOUT = SPECS["serial_timeout"]
MODE = SPECS["motor_mode"]
FACTORY = {spec.key: spec.default for spec in SPECS.readable}


def loaded() -> ParameterValues:
    draft = ParameterValues()
    draft.load(FACTORY)
    return draft


def test_invalid_edit_keeps_the_previous_edit() -> None:
    draft = loaded()
    draft.edit(MODE, 1)
    with pytest.raises(BadRequest, match="Motor Mode"):
        draft.edit(MODE, 7)
    assert draft.pending == (("motor_mode", 1),)


def test_edit_made_during_the_write_stays_pending() -> None:
    draft = loaded()
    draft.edit(TIMEOUT, 9)
    draft.edit(TIMEOUT, 10)
    draft.record_stored(TIMEOUT, 9)
    assert draft.pending == (("serial_timeout", 10),)


def test_load_retains_edits_on_request() -> None:
    for stored in (FACTORY | {"serial_timeout": 9}, {"motor_mode": 0}):
        draft = loaded()
        draft.edit(TIMEOUT, 9)
        draft.load(FACTORY, keep_edits=True)
        assert dict(draft.pending) == {"serial_timeout": 9}
        draft.load(stored, keep_edits=True)
        assert draft.pending == ()
        draft.edit(MODE, 1)
        draft.load(FACTORY)
        assert draft.pending == ()


# --- Stored and active ------------------------------------------------------------------


def test_active_value_stays_until_a_power_cycle() -> None:
    draft = loaded()
    draft.record_stored(MODE, 1)
    uart = SPECS["uart_settings"]
    draft.record_stored(uart, 3)
    draft.record_stored(uart, 4)
    stored = FACTORY | {"motor_mode": 1, "uart_settings": 4}
    assert draft.stored == stored
    active = {"motor_mode": 0, "uart_settings": uart.default}
    assert draft.active == active
    draft.load(stored, power_cycled=False)
    assert draft.active == active
    draft.record_stored(MODE, 0)
    assert draft.active == {"uart_settings": uart.default}
    draft.load(stored, power_cycled=True)
    assert draft.active == {}
    unknown = ParameterValues()
    unknown.record_stored(MODE, 1)
    assert unknown.active == {}


# --- Files with few values ------------------------------------------------------------------


def of_a_file() -> ParameterValues:
    draft = ParameterValues()
    draft.load({"motor_mode": 0}, optional=FACTORY)
    return draft


def test_parameters_of_a_file_are_added_left_out_and_restored() -> None:
    draft = of_a_file()
    assert draft.can_edit("serial_timeout")
    draft.edit(TIMEOUT, 9)
    assert dict(draft.pending) == {"serial_timeout": 9}
    draft.remove("serial_timeout")
    assert draft.value_of("serial_timeout") is None
    assert not draft.is_modified("serial_timeout")
    draft.remove("motor_mode")
    assert draft.value_of("motor_mode") is None
    assert draft.is_modified("motor_mode")
    assert dict(draft.pending) == {}
    draft.edit(MODE, 0)
    assert not draft.is_modified("motor_mode")


def test_left_out_parameter_survives_reload_of_the_same_file() -> None:
    draft = of_a_file()
    draft.remove("motor_mode")
    draft.edit(TIMEOUT, 9)
    draft.load({"motor_mode": 0}, keep_edits=True, optional=FACTORY)
    assert draft.removed == {"motor_mode"}
    assert draft.pending == (("serial_timeout", 9),)
    draft.load({"serial_timeout": 9}, keep_edits=True, optional=FACTORY)
    assert not draft.removed
    assert not draft.pending


def test_parameter_of_a_board_cannot_be_left_out() -> None:
    draft = loaded()
    draft.remove("motor_mode")
    assert draft.value_of("motor_mode") == MODE.default
    assert not draft.is_modified("motor_mode")


# --- Always -----------------------------------------------------------------------------

edits = st.lists(
    st.tuples(st.sampled_from(SPECS.readable), st.none() | st.integers(0, 127)), max_size=25
)


@modest
@given(edits)
def test_pending_equals_the_difference_after_any_edits(
    steps: list[tuple[ParameterSpec, int | None]],
) -> None:
    draft = loaded()
    wanted = dict(FACTORY)
    for spec, wire in steps:
        try:
            draft.edit(spec, wire)
        except BadRequest:
            continue
        wanted[spec.key] = FACTORY[spec.key] if wire is None else wire
    changed = {key: wire for key, wire in wanted.items() if wire != FACTORY[key]}
    assert dict(draft.pending) == changed
    assert {key: draft.value_of(key) for key in wanted} == wanted
    assert draft.stored == FACTORY


@modest
@given(edits)
def test_writing_all_pending_edits_leaves_none(
    steps: list[tuple[ParameterSpec, int | None]],
) -> None:
    draft = loaded()
    for spec, wire in steps:
        try:
            draft.edit(spec, wire)
        except BadRequest:
            continue
    written = dict(draft.pending)
    for key, wire in written.items():
        draft.record_stored(SPECS[key], wire)
    assert draft.pending == ()
    assert draft.stored == FACTORY | written
    assert set(draft.active) == {key for key in written if SPECS[key].needs_power_cycle}
