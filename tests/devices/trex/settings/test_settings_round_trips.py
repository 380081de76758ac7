"""Round trips of settings, and errors of arbitrary files."""

from dataclasses import replace

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
    """Read a file. Return its settings, if any, and the errors."""
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
    turned = replace(
        given_settings,
        parameters=dict(reversed([*given_settings.parameters.items()])),
        calibrations=dict(reversed([*given_settings.calibrations.items()])),
    )
    assert write_settings(turned, title_lines=titles) == text


@modest
@given(cut=st.integers(0, len(WHOLE.encode("utf-8"))))
def test_truncated_file_is_read_or_rejected_with_line(cut: int) -> None:
    data = WHOLE.encode("utf-8")[:cut]
    read, errors = outcome(data)
    last = data.count(b"\n") + 1
    assert all(found.line is not None and found.line <= last for found in errors)
    assert read is not None or errors
    if read is not None and data != WHOLE.encode("utf-8"):
        is_complete = set(read.parameters) == set(factory().parameters)
        assert (is_complete and data.endswith(b"\n")) or read_settings(data)[1]
