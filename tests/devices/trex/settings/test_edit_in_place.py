"""Changes of values in settings files that users wrote or edited."""

from dataclasses import dataclass, replace

import pytest
from hypothesis import Phase, given
from hypothesis import strategies as st

from tests.devices.trex.settings.samples import (
    TREX,
    TREX_JR,
    any_calibration,
    any_settings,
    factory,
)
from tests.support.matrix import examples
from trex_gui.core.errors import BadRequest
from trex_gui.core.files import SettingsError
from trex_gui.devices.trex.protocol.calibration import CALIBRATION_KEYS, Calibration, CalibrationKey
from trex_gui.devices.trex.protocol.parameters import ParameterSpec
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.edit_in_place import amend
from trex_gui.devices.trex.settings.notes import lines_of_note
from trex_gui.devices.trex.settings.reader import read_settings
from trex_gui.devices.trex.settings.writer import calibration_text, parameter_text, write_settings

thorough = examples(12, phases=[Phase.generate])
RC_1 = CalibrationKey.RC_CHANNEL_1


def amended(text: str, **parameters: int) -> str:
    """Return a text with changed parameters."""
    read, _ = read_settings(text)
    return amend(text, replace(read, parameters={**read.parameters, **parameters}))


def recalibrated(text: str, *points: int) -> str:
    """Return a text with a changed calibration of RC channel 1."""
    read, _ = read_settings(text)
    return amend(text, replace(read, calibrations={RC_1: Calibration(*points)}))


# --- Text of the user -------------------------------------------------------------------


def test_edit_changes_only_values_and_generated_comments() -> None:
    before = (
        "# Robot no. 3\n"
        "\n"
        "product:   TReX        # the big one\n"
        "motor_mode: 0x00  # two motors!\n"
        "serial_timeout: 0               # off\n"
        "\n"
        "# slippery floor\n"
        "'motor1_acceleration' : 5  # 5 per 100 ms\n"
        "# end\n"
    )
    assert amended(before, motor_mode=1, serial_timeout=127, motor1_acceleration=12) == (
        "# Robot no. 3\n"
        "\n"
        "product:   TReX        # the big one\n"
        "motor_mode: 0x01  # two motors!\n"
        "serial_timeout: 127             # 12.7 s\n"
        "\n"
        "# slippery floor\n"
        "'motor1_acceleration' : 12  # 1.1 s to full speed\n"
        "# end\n"
    )


@pytest.mark.parametrize(
    ("old", "wire", "new"),
    [
        ("5", 127, "127"),
        ("0x05", 127, "0x7F"),
        ("0x5", 127, "0x7F"),
        ("0x7f", 11, "0x0b"),
        ("0X7F", 11, "0X0B"),
        ("0x0007", 10, "0x000A"),
        ("+5", 6, "+6"),
        ("-0", 6, "6"),
    ],
)
def test_number_keeps_its_base_and_width(old: str, wire: int, new: str) -> None:
    text = amended(f"product: TReX\ndevice_number: {old}\n", device_number=wire)
    assert text == f"product: TReX\ndevice_number: {new}\n"


@pytest.mark.parametrize(
    "comment", ["#off", "# off, for the bench", "# Off", "#", "# 0 s", "\n# off"]
)
def test_comment_of_user_is_unchanged(comment: str) -> None:
    text = amended(f"product: TReX\nserial_timeout: 0 {comment}\n", serial_timeout=5)
    assert text == f"product: TReX\nserial_timeout: 5 {comment}\n"


def test_comment_retains_its_column_if_space_allows() -> None:
    before = (
        "product: TReX\ndevice_number: 7     # a\nserial_timeout: 100  # b\n"
        "motor1_acceleration: 5 # c\nmotor2_acceleration: 5   # d\n"
    )
    after = amended(
        before,
        device_number=100,
        serial_timeout=5,
        motor1_acceleration=100,
        motor2_acceleration=100,
    )
    assert after == (
        "product: TReX\ndevice_number: 100   # a\nserial_timeout: 5    # b\n"
        "motor1_acceleration: 100 # c\nmotor2_acceleration: 100  # d\n"
    )


def test_calibration_in_braces_keeps_its_layout() -> None:
    before = (
        "product: TReX\n"
        "rc_channel_1: {deadband: 75, minimum: 0x9C4,\n"
        "  neutral: 3750,  # centre\n"
        '  "maximum": 5000}  # 1000 / 1500 / 2000 µs, deadband 30 µs\n'
    )
    assert recalibrated(before, 2600, 3750, 5000, 5) == (
        "product: TReX\n"
        "rc_channel_1: {deadband: 5, minimum: 0xA28,\n"
        "  neutral: 3750,  # centre\n"
        '  "maximum": 5000}  # 1040 / 1500 / 2000 µs, deadband 2 µs\n'
    )


def test_calibration_in_lines_keeps_its_layout() -> None:
    before = (
        "product: TReX\n"
        "rc_channel_1:  # 1000 / 1500 / 2000 µs, deadband 30 µs\n"
        "    maximum: 5000\n\n    minimum: 2500  # left\n    neutral: 3750\n    deadband: 75\n"
    )
    assert recalibrated(before, 2500, 3750, 5100, 0) == (
        "product: TReX\n"
        "rc_channel_1:  # 1000 / 1500 / 2040 µs, deadband 0 µs\n"
        "    maximum: 5100\n\n    minimum: 2500  # left\n    neutral: 3750\n    deadband: 0\n"
    )


@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
@pytest.mark.parametrize("mark", ["", "\ufeff"])
@pytest.mark.parametrize("last", [True, False])
def test_line_endings_and_byte_order_mark_are_unchanged(end: str, mark: str, last: bool) -> None:
    before = mark + end.join(["product: TReX", "# µ", "serial_timeout: 0  # off"]) + end * last
    after = amended(before, serial_timeout=5, motor_mode=1)
    lines = ["product: TReX", "# µ", "serial_timeout: 5  # 0.5 s"]
    new = "motor_mode: 1                   # joint"
    assert after == mark + end.join([*lines, new]) + end * last


# --- Product, firmware, added and removed settings --------------------------------------


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("product: TReX\n", "product: TReX Jr\n"),
        ("'product': 'TReX'  # mine\n", "'product': 'TReX Jr'  # mine\n"),
        ('product:\n  "TReX"\n', 'product:\n  "TReX Jr"\n'),
        ("product: |-  # mine\n  TReX\n\n# end\n", "product: |-  # mine\n  TReX Jr\n\n# end\n"),
        ("{product: TReX}", "{product: TReX Jr}"),
    ],
)
def test_product_changes_and_keeps_its_quoting(before: str, after: str) -> None:
    assert amend(before, Settings(TREX_JR)) == after


def test_generated_comment_follows_changed_product() -> None:
    before = "product: TReX\nmotor1_current_limit: 10  # 3 A\n"
    after = "product: TReX Jr\nmotor1_current_limit: 10  # 0.8 A\n"
    assert amend(before, Settings(TREX_JR, None, {"motor1_current_limit": 10})) == after


def test_firmware_is_added_changed_and_commented_out() -> None:
    bare = "product: TReX  # mine\n"
    added = amend(bare, Settings(TREX, "1.1"))
    assert added == "product: TReX  # mine\nfirmware: 1.1\n"
    assert amend(added, Settings(TREX, "1.3")) == added.replace("1.1", "1.3")
    assert amend(added, Settings(TREX)) == "product: TReX  # mine\n# firmware: 1.1\n"


def test_missing_settings_are_appended_in_table_order() -> None:
    before = "  product: TReX\n  motor_mode: 0\n...\n# the end\n"
    settings = Settings(
        TREX,
        None,
        {"uart_settings": 5, "motor_mode": 0, "device_number": 9},
        {RC_1: Calibration(2500, 3750, 5000, 75)},
    )
    assert amend(before, settings) == (
        "  product: TReX\n  motor_mode: 0\n"
        "  device_number: 9\n"
        "  uart_settings: 5                # 19200 baud, no error detection, 1 stop bit\n"
        "  rc_channel_1: {minimum: 2500, neutral: 3750, maximum: 5000, deadband: 75}"
        "  # 1000 / 1500 / 2000 µs, deadband 30 µs\n"
        "...\n# the end\n"
    )


def test_removed_settings_become_comments() -> None:
    before = (
        "product: TReX\nserial_timeout: 5  # why\n"
        "rc_channel_1:\n  # ends\n  minimum: 1\n\n  neutral: 2\n  maximum: 3\n  deadband: 0\n"
    )
    assert amend(before, Settings(TREX)) == (
        "product: TReX\n# serial_timeout: 5  # why\n"
        "# rc_channel_1:\n  # ends\n#   minimum: 1\n\n#   neutral: 2\n#   maximum: 3\n"
        "#   deadband: 0\n"
    )


def test_file_in_braces_accepts_only_changed_values() -> None:
    before = "{product: TReX, serial_timeout: 0,  # off\n device_number: 7\n} # e\n"
    assert amended(before, serial_timeout=12, device_number=8) == (
        "{product: TReX, serial_timeout: 12,  # 1.2 s\n device_number: 8\n} # e\n"
    )
    with pytest.raises(SettingsError, match="cannot be changed in place"):
        amended(before, motor_mode=1)


def test_invalid_value_becomes_comment_only_once() -> None:
    broken = Calibration(9, 9, 9, 9)
    invalid = Settings(TREX, None, {"uart_settings": 12, "motor_mode": 1}, {RC_1: broken})
    after = amend("product: TReX\nuart_settings: 5\nmotor_mode: 0\n", invalid)
    lines = after.splitlines()
    assert lines[:3] == ["product: TReX", "# uart_settings: 5", "motor_mode: 1"]
    assert lines[3].startswith("# uart_settings: 12  # left out: ")
    assert lines[4].startswith("# rc_channel_1: {minimum: 9, ")
    assert amend(after, invalid) == after


# --- Rejected edits ---------------------------------------------------------------------


@pytest.mark.parametrize(
    "text",
    ["", "product: Tic\n", "product: TReX\nserial_timeout: 300\n", "product: >-\n\n\n  TReX\n"],
)
def test_unreadable_text_is_not_edited(text: str) -> None:
    with pytest.raises(SettingsError) as caught:
        amend(text, factory(), "bench.txt")
    assert caught.value.name == "bench.txt"


def test_unknown_key_is_rejected() -> None:
    with pytest.raises(BadRequest, match="a TReX has no speed"):
        amend("product: TReX\n", Settings(TREX, None, {"speed": 1}))


def test_edit_that_would_read_back_differently_is_rejected() -> None:
    # The text block ends with the file. A line after the block would add a line break to the text.
    before = "product: TReX\nfirmware: |\n  1.2"
    with pytest.raises(SettingsError, match="cannot be changed in place"):
        amended(before, motor_mode=1)


def test_product_on_two_lines_cannot_be_changed() -> None:
    before = "product: TReX\n  Jr\nserial_timeout: 5\n"
    junior = Settings(TREX_JR, None, {"serial_timeout": 7})
    assert amend(before, junior) == before.replace("5", "7")
    with pytest.raises(SettingsError, match="cannot be changed in place"):
        amend(before, replace(junior, product=TREX, parameters={"serial_timeout": 5}))


# --- Any file in any style --------------------------------------------------------------


@dataclass(frozen=True)
class UserFile:
    """Settings file in the style of a user, with its parts by key."""

    text: str
    parts: dict[str, str]
    comments: list[str]


words = st.text(st.sampled_from("abc#:{}'\"µ, -"), max_size=8)


@st.composite
def any_number(draw: st.DrawFn, value: int) -> str:
    spellings = [str(value), f"{value:#x}", f"0x{value:02X}", f"0X{value:04x}", f"+{value}"]
    return draw(st.sampled_from(spellings))


@st.composite
def any_key(draw: st.DrawFn, key: str) -> str:
    return draw(st.sampled_from([key, f"'{key}'", f'"{key}"'])) + draw(st.sampled_from(["", " "]))


@st.composite
def any_trailing_comment(draw: st.DrawFn, generated: str) -> str:
    """Comment after a value: from the program, from the user or missing."""
    gap = draw(st.sampled_from([" ", "  ", "      "]))
    kinds = ["", f"{gap}# {generated}", f"{gap}#{draw(words)}", f"{gap}# {draw(words)}", gap]
    return draw(st.sampled_from(kinds))


@st.composite
def any_calibration_lines(draw: st.DrawFn, key: str, calibration: Calibration) -> list[str]:
    source = CALIBRATION_KEYS[key].source
    names = draw(st.permutations(["minimum", "neutral", "maximum", "deadband"]))
    fields = [
        f"{draw(any_key(name))}: {draw(any_number(getattr(calibration, name)))}" for name in names
    ]
    comment = draw(any_trailing_comment(calibration_text(source, calibration)))
    match draw(st.sampled_from(["flow", "lines in braces", "block"])):
        case "flow":
            return [f"{draw(any_key(key))}: {{{', '.join(fields)}}}{comment}"]
        case "block":
            margin = " " * draw(st.integers(1, 4))
            lines = [f"{margin}{field}{draw(any_trailing_comment('x'))}" for field in fields]
            if draw(st.booleans()):
                lines.insert(draw(st.integers(0, 4)), f"{margin}# {draw(words)}")
            return [f"{draw(any_key(key))}:{comment}", *lines]
    lines = [f"  {field},{draw(any_trailing_comment('x'))}" for field in fields]
    return [f"{draw(any_key(key))}: {{", *lines, f" }}{comment}"]


@st.composite
def any_parameter_lines(
    draw: st.DrawFn, spec: ParameterSpec, wire: int, settings: Settings
) -> list[str]:
    number = draw(any_number(wire))
    comment = draw(any_trailing_comment(parameter_text(spec, wire, settings)))
    if draw(st.sampled_from([True, True, True, False])):
        return [f"{draw(any_key(spec.key))}: {number}{comment}"]
    return [f"{draw(any_key(spec.key))}:", f"   {number}{comment}"]


@st.composite
def any_user_file(draw: st.DrawFn, settings: Settings) -> UserFile:
    """File with these settings in the style of a user."""
    groups = {"firmware": [f"firmware: {settings.firmware}"]}
    if settings.firmware is None:
        groups = {}
    for spec in settings.specs.readable:
        if spec.key in settings.parameters:
            wire = settings.parameters[spec.key]
            groups[spec.key] = draw(any_parameter_lines(spec, wire, settings))
    for name, channel in CALIBRATION_KEYS.items():
        if channel in settings.calibrations:
            groups[name] = draw(any_calibration_lines(name, settings.calibrations[channel]))
    margin = " " * draw(st.sampled_from([0, 0, 2]))
    end = draw(st.sampled_from(["\n", "\r\n", "\r"]))
    quote = draw(st.sampled_from(["", "'", '"']))
    head = draw(st.sampled_from([[], ["# head"], ["---"], ["%YAML 1.1", "---"], [""]]))
    order = draw(st.permutations(list(groups)))
    lines = [*head, f"{margin}product: {quote}{settings.product.name}{quote}"]
    notes = {key: lines_of_note(key, settings.notes) for key in settings.notes}
    for key in [*order, *(key for key in notes if key not in groups)]:
        lines += draw(st.lists(st.just("") | words.map("# {}".format), max_size=2))
        lines += [margin + line for line in notes.get(key, [])]
        lines += [margin + line for line in groups.get(key, [])]
    lines += draw(st.sampled_from([[], [""], ["# end"], ["..."], ["...", "# end"]]))
    text = draw(st.sampled_from(["", "\ufeff"])) + end.join(lines)
    parts = {key: end.join(margin + line for line in group) for key, group in groups.items()}
    comments = [line for line in lines if line.lstrip().startswith("#") and "Note" not in line]
    return UserFile(text + draw(st.sampled_from(["", end])), parts, comments)


@st.composite
def any_amendment(draw: st.DrawFn) -> tuple[Settings, UserFile, Settings]:
    """Settings, a file with these settings, and new settings with some equal values."""
    old, new = draw(any_settings()), draw(any_settings())
    known = {spec.key for spec in new.specs.readable}
    common = {key: wire for key, wire in old.parameters.items() if key in known}
    equal = draw(st.sets(st.sampled_from(sorted(common)))) if common else set()
    parameters = {**new.parameters, **{key: common[key] for key in sorted(equal)}}
    changed = {key: draw(any_calibration()) for key in old.calibrations}
    calibrations = draw(st.sampled_from([old.calibrations, new.calibrations, changed]))
    new = replace(new, parameters=parameters, calibrations=calibrations)
    return old, draw(any_user_file(old)), new


@thorough
@given(amendment=any_amendment())
def test_edited_file_reads_as_new_settings_with_same_comments(
    amendment: tuple[Settings, UserFile, Settings],
) -> None:
    old, file, new = amendment
    assert amend(file.text, old) == file.text
    after = amend(file.text, new)
    assert read_settings(after)[0] == new
    assert amend(after, new) == after
    plain = after.removeprefix("\ufeff").replace("\r\n", "\n")
    lines = iter(plain.replace("\r", "\n").split("\n"))
    assert all(any(comment == line for line in lines) for comment in file.comments)
    new = replace(new, product=old.product)
    after = amend(file.text, new)
    for key, part in file.parts.items():
        if key in CALIBRATION_KEYS:
            calibration = CALIBRATION_KEYS[key]
            is_same = old.calibrations[calibration] == new.calibrations.get(calibration)
        elif key == "firmware":
            is_same = old.firmware == new.firmware
        else:
            wire = old.parameters[key]
            # The comment of a PWM contains its frequency, which depends on another parameter.
            is_same = wire == new.parameters.get(key) and (
                parameter_text(old.specs[key], wire, old)
                == parameter_text(new.specs[key], wire, new)
            )
        assert not is_same or part in after


@thorough
@given(old=any_settings(), data=st.data())
def test_edited_generated_file_equals_a_new_file(old: Settings, data: st.DataObject) -> None:
    specs = [spec for spec in old.specs.readable if spec.key in old.parameters]
    wires = {spec.key: data.draw(st.sampled_from(sorted(spec.valid))) for spec in specs}
    new = replace(old, parameters=wires)
    assert amend(write_settings(old), new) == write_settings(new)
