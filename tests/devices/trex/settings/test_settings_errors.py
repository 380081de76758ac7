"""What is wrong with a settings file is a sentence that survives the way elsewhere."""

import copy
import pickle

from trex_gui.core.errors import StudioError
from trex_gui.core.files import Finding, SettingsError, Severity

FINDING = Finding(12, "serial_timeout", "0 to 127 (off to 12.7 s), not 300")
WARNING = Finding(None, None, "1 of 28 parameters is missing", Severity.WARNING)


def test_finding_text_names_line_and_key() -> None:
    assert str(FINDING) == "line 12: serial_timeout: 0 to 127 (off to 12.7 s), not 300"


def test_warning_text_starts_with_warning() -> None:
    assert str(WARNING) == "warning: 1 of 28 parameters is missing"


def test_single_finding_follows_file_name_on_same_line() -> None:
    assert str(SettingsError("bench.txt", [FINDING])) == f"bench.txt: {FINDING}"


def test_several_findings_have_one_line_each() -> None:
    error = SettingsError("bench.txt", [FINDING, WARNING])
    assert str(error).splitlines() == ["bench.txt:", str(FINDING), str(WARNING)]


def test_settings_error_is_trex_error() -> None:
    assert isinstance(SettingsError("bench.txt", [FINDING]), StudioError)


def test_settings_error_pickles_with_its_findings() -> None:
    error = SettingsError("bench.txt", [FINDING, WARNING])
    arrived = pickle.loads(pickle.dumps(error))
    assert isinstance(arrived, SettingsError)
    assert (arrived.name, arrived.findings) == ("bench.txt", (FINDING, WARNING))
    assert str(arrived) == str(error) == str(copy.deepcopy(error))
