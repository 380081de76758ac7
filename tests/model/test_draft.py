"""A working copy beside the device's."""

import random

import pytest
from hypothesis import given
from hypothesis import settings as hypothesis_settings
from hypothesis import strategies as st

from trex_gui.model.draft import Draft
from trex_gui.protocol.errors import BadRequest
from trex_gui.protocol.parameters import ParameterSpec, parameters_of

modest = hypothesis_settings(deadline=None, max_examples=40)


SPECS = parameters_of("trex", "1.2")
TIMEOUT = SPECS["serial_timeout"]
MODE = SPECS["motor_mode"]
FACTORY = {spec.key: spec.default for spec in SPECS.readable}


def loaded() -> Draft:
    draft = Draft()
    draft.load(FACTORY)
    return draft


def test_a_fresh_draft_has_nothing_to_write() -> None:
    assert loaded().pending == ()
    assert Draft().value("serial_timeout") is None


def test_an_edit_waits_to_be_written() -> None:
    draft = loaded()
    draft.edit(TIMEOUT, 9)
    assert draft.pending == (("serial_timeout", 9),)
    assert draft.value("serial_timeout") == 9
    assert draft.stored["serial_timeout"] == TIMEOUT.default


def test_editing_back_forgets_the_edit() -> None:
    draft = loaded()
    draft.edit(TIMEOUT, 9)
    draft.edit(TIMEOUT, TIMEOUT.default)
    assert draft.pending == ()


def test_an_edit_is_taken_back_by_editing_to_nothing() -> None:
    draft = loaded()
    draft.edit(TIMEOUT, 9)
    draft.edit(TIMEOUT, None)
    draft.edit(TIMEOUT, None)
    assert draft.pending == ()


def test_an_edit_outside_the_table_leaves_the_one_before() -> None:
    draft = loaded()
    draft.edit(MODE, 1)
    with pytest.raises(BadRequest, match="Motor Mode"):
        draft.edit(MODE, 7)
    assert draft.pending == (("motor_mode", 1),)


def test_what_was_read_back_is_stored_and_no_edit_any_more() -> None:
    draft = loaded()
    draft.edit(TIMEOUT, 9)
    draft.note_stored(TIMEOUT, 9)
    assert draft.stored["serial_timeout"] == 9
    assert draft.pending == ()


def test_an_edit_that_came_during_the_write_is_kept() -> None:
    draft = loaded()
    draft.edit(TIMEOUT, 9)
    draft.edit(TIMEOUT, 10)
    draft.note_stored(TIMEOUT, 9)
    assert draft.pending == (("serial_timeout", 10),)


def test_reading_again_keeps_edits_only_when_asked_to() -> None:
    draft = loaded()
    draft.edit(TIMEOUT, 9)
    draft.load(FACTORY, keep_edits=True)
    assert dict(draft.pending) == {"serial_timeout": 9}
    draft.load(FACTORY)
    assert dict(draft.pending) == {}


def test_an_edit_that_somebody_else_has_written_is_none_any_more() -> None:
    draft = loaded()
    draft.edit(TIMEOUT, 9)
    draft.load(FACTORY | {"serial_timeout": 9}, keep_edits=True)
    assert draft.pending == ()


def test_an_edit_of_what_the_board_does_not_have_is_dropped() -> None:
    draft = loaded()
    draft.edit(TIMEOUT, 9)
    draft.load({"motor_mode": 0}, keep_edits=True)
    assert draft.pending == ()


# --- Stored and active ------------------------------------------------------------------


def test_what_needs_a_power_cycle_is_stored_beside_what_is_active() -> None:
    draft = loaded()
    draft.note_stored(MODE, 1)
    assert draft.stored["motor_mode"] == 1
    assert draft.active == {"motor_mode": 0}


def test_what_acts_at_once_has_no_second_truth() -> None:
    draft = loaded()
    draft.note_stored(TIMEOUT, 9)
    assert draft.active == {}


def test_storing_the_active_value_again_ends_the_waiting() -> None:
    draft = loaded()
    draft.note_stored(MODE, 1)
    draft.note_stored(MODE, 0)
    assert draft.active == {}


def test_the_active_value_stays_through_several_writes() -> None:
    draft = loaded()
    uart = SPECS["uart_settings"]
    draft.note_stored(uart, 3)
    draft.note_stored(uart, 4)
    assert draft.active == {"uart_settings": uart.default}


def test_a_power_cycle_makes_everything_active() -> None:
    draft = loaded()
    draft.note_stored(MODE, 1)
    draft.load(FACTORY | {"motor_mode": 1}, power_cycled=True)
    assert draft.active == {}


def test_reading_again_without_a_power_cycle_changes_nothing_about_what_is_active() -> None:
    draft = loaded()
    draft.note_stored(MODE, 1)
    draft.load(FACTORY | {"motor_mode": 1}, power_cycled=False)
    assert draft.active == {"motor_mode": 0}


def test_a_value_that_was_not_known_before_has_no_active_one() -> None:
    draft = Draft()
    draft.note_stored(MODE, 1)
    assert draft.active == {}


# --- A file, which need not give everything -------------------------------------------------


def of_a_file() -> Draft:
    draft = Draft()
    draft.load({"motor_mode": 0}, open_to=FACTORY)
    return draft


def test_what_a_file_does_not_give_can_be_given_and_taken_back() -> None:
    draft = of_a_file()
    assert draft.takes("serial_timeout")
    draft.edit(TIMEOUT, 9)
    assert draft.pending == (("serial_timeout", 9),)
    draft.leave_out("serial_timeout")
    assert draft.value("serial_timeout") is None
    assert not draft.is_modified("serial_timeout")


def test_what_a_file_gives_can_be_left_out_and_given_again() -> None:
    draft = of_a_file()
    draft.leave_out("motor_mode")
    assert draft.value("motor_mode") is None
    assert draft.is_modified("motor_mode")
    assert draft.pending == ()
    draft.edit(MODE, 0)
    assert not draft.is_modified("motor_mode")


def test_what_is_left_out_stays_so_when_the_same_is_read_again() -> None:
    draft = of_a_file()
    draft.leave_out("motor_mode")
    draft.edit(TIMEOUT, 9)
    draft.load({"motor_mode": 0}, keep_edits=True, open_to=FACTORY)
    assert draft.removed == {"motor_mode"}
    assert draft.pending == (("serial_timeout", 9),)
    draft.load({"serial_timeout": 9}, keep_edits=True, open_to=FACTORY)
    assert not draft.removed
    assert not draft.pending


def test_nothing_can_be_left_out_of_a_board() -> None:
    draft = loaded()
    draft.leave_out("motor_mode")
    assert draft.value("motor_mode") == MODE.default
    assert not draft.is_modified("motor_mode")


# --- Always -----------------------------------------------------------------------------

edits = st.lists(
    st.tuples(st.sampled_from(SPECS.readable), st.none() | st.integers(0, 127)), max_size=25
)


@modest
@given(edits)
def test_dirty_is_the_difference_whatever_was_edited(
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
    assert {key: draft.value(key) for key in wanted} == wanted
    assert draft.stored == FACTORY


@modest
@given(edits, st.randoms(use_true_random=False))
def test_taking_back_every_edit_in_any_order_leaves_nothing(
    steps: list[tuple[ParameterSpec, int | None]], chance: random.Random
) -> None:
    draft = loaded()
    edited = []
    for spec, wire in steps:
        try:
            draft.edit(spec, wire)
        except BadRequest:
            continue
        edited.append(spec)
    chance.shuffle(edited)
    for spec in edited:
        draft.edit(spec, None)
    assert draft.pending == ()


@modest
@given(edits)
def test_writing_everything_that_waits_leaves_nothing(
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
        draft.note_stored(SPECS[key], wire)
    assert draft.pending == ()
    assert draft.stored == FACTORY | written
    assert set(draft.active) == {key for key in written if SPECS[key].needs_power_cycle}
