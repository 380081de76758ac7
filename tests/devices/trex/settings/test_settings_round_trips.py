"""Round trips of any settings, and errors of truncated files."""

from hypothesis import given
from hypothesis import strategies as st

from tests.devices.trex.settings.samples import any_settings, factory, in_reverse_order
from tests.support.matrix import examples
from trex_gui.core.files import Finding, SettingsError, Severity
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.reader import read_settings
from trex_gui.devices.trex.settings.writer import write_settings

modest = examples(25)
COMPLETE = write_settings(factory(), title_lines=["bench, µ"])


def read_file(text: str | bytes) -> tuple[Settings | None, list[Finding]]:
    """Read a file. Return its settings, if any, and the errors."""
    try:
        read, findings = read_settings(text)
    except SettingsError as error:
        errors = [finding for finding in error.findings if finding.severity is Severity.ERROR]
        return None, errors if str(error).encode("utf-8") else []
    return read, [finding for finding in findings if finding.severity is Severity.ERROR]


@modest
@given(settings=any_settings(), titles=st.lists(st.text(max_size=50), max_size=3))
def test_written_settings_with_any_title_are_read_back(
    settings: Settings, titles: list[str]
) -> None:
    text = write_settings(settings, title_lines=titles)
    read, _ = read_settings(text.encode("utf-8"))
    assert read == settings
    assert write_settings(read, title_lines=titles) == text
    assert write_settings(in_reverse_order(settings), title_lines=titles) == text


@modest
@given(cut=st.integers(0, len(COMPLETE.encode("utf-8"))))
def test_truncated_file_is_read_or_rejected_with_line(cut: int) -> None:
    data = COMPLETE.encode("utf-8")[:cut]
    read, errors = read_file(data)
    last = data.count(b"\n") + 1
    assert all(finding.line is not None and finding.line <= last for finding in errors)
    assert read is not None or errors
    if read is not None and data != COMPLETE.encode("utf-8"):
        is_complete = set(read.parameters) == set(factory().parameters)
        assert (is_complete and data.endswith(b"\n")) or read_settings(data)[1]
