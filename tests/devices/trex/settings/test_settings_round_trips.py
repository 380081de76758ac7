"""Whatever is written reads back, and whatever is read ends in a sentence at worst."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.devices.trex.settings.samples import any_settings, factory
from tests.support.matrix import examples
from trex_gui.core.files import Finding, SettingsError, Severity
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.reader import read_settings
from trex_gui.devices.trex.settings.writer import write_settings

modest = examples(25)
WHOLE = write_settings(factory(), title_lines=["bench, µ"])


def outcome(text: str | bytes) -> tuple[Settings | None, list[Finding]]:
    """Read a file; return the settings, if there are any, and the errors."""
    try:
        read, findings = read_settings(text)
    except SettingsError as refusal:
        errors = [found for found in refusal.findings if found.severity is Severity.ERROR]
        return None, errors if str(refusal).encode("utf-8") else []
    return read, [found for found in findings if found.severity is Severity.ERROR]


@modest
@given(given_settings=any_settings(), titles=st.lists(st.text(max_size=50), max_size=3))
def test_written_settings_read_back_equal_whatever_the_title(
    given_settings: Settings, titles: list[str]
) -> None:
    text = write_settings(given_settings, title_lines=titles)
    read, _ = read_settings(text.encode("utf-8"))
    assert read == given_settings
    assert write_settings(read, title_lines=titles) == text


@modest
@given(cut=st.integers(0, len(WHOLE.encode("utf-8"))))
def test_truncated_file_is_read_or_rejected_with_line(cut: int) -> None:
    data = WHOLE.encode("utf-8")[:cut]
    read, errors = outcome(data)
    last = data.count(b"\n") + 1
    assert all(found.line is not None and found.line <= last for found in errors)
    assert read is not None or errors


@modest
@given(cut=st.integers(len("product: TReX"), len(WHOLE) - 1))
def test_truncated_file_is_never_read_without_finding(cut: int) -> None:
    text = WHOLE[:cut]
    read, errors = outcome(text)
    if read is None:
        assert errors
    elif set(read.parameters) != set(factory().parameters) or not text.endswith("\n"):
        assert read_settings(text)[1]


@pytest.mark.parametrize("text", ["device_number: 7\n", "motor_mode: 0 "])
def test_mistake_is_reported_with_its_line_and_key(text: str) -> None:
    line = WHOLE[: WHOLE.index(text)].count("\n") + 1
    key, value = text.split(":")
    with pytest.raises(SettingsError) as caught:
        read_settings(WHOLE.replace(text, f"{key}: 5{value.strip()}00{value[-1]}"))
    assert [(found.line, found.key) for found in caught.value.findings] == [(line, key)]
