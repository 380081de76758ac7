"""Of what a recording is, told from its head."""

import json
from pathlib import Path

import pytest

from tests.devices.trex.recording.samples import an_hour, write, write_an_hour_of_csv
from trex_gui.core.recording.errors import RecordingError
from trex_gui.devices.trex.recording.columns import joined
from trex_gui.devices.trex.recording.files import open_recording
from trex_gui.devices.trex.recording.identify import recorded_device, wrong_device_message


def write_of(path: Path, about: object) -> None:
    """Write the head of the recording of some other device."""
    head = ("time_s,legs,text", joined(["0.0", "", json.dumps(about)]))
    path.write_text("\n".join(head) + "\n", encoding="utf-8")


def test_trex_recording_is_identified_with_firmware(tmp_path: Path) -> None:
    write(tmp_path / "a.trexrec", list(an_hour(1)))
    write_an_hour_of_csv(tmp_path / "a.csv", 1)
    assert (
        recorded_device(tmp_path / "a.trexrec") == recorded_device(tmp_path / "a.csv") == "TReX 1.2"
    )


def test_other_device_is_named_from_header_and_rejected(tmp_path: Path) -> None:
    path = tmp_path / "mule.csv"
    write_of(path, {"robot": "Mule, the 2nd"})
    assert recorded_device(path) == "Mule, the 2nd"
    with pytest.raises(RecordingError) as refused:
        open_recording(path)
    said = str(refused.value)
    assert "mule.csv: This is a recording of another device: Mule, the 2nd." in said
    assert "choose its port or its demo in the list of ports" in said


@pytest.mark.parametrize("about", [{}, {"robot": 7}, [], "robot", None])
def test_file_without_device_is_not_a_recording(tmp_path: Path, about: object) -> None:
    path = tmp_path / "table.csv"
    write_of(path, about)
    assert wrong_device_message(path) == ""
    with pytest.raises(RecordingError, match="This is no recording of TReX Studio"):
        open_recording(path)


@pytest.mark.parametrize("data", [b"", b"time_s,", b"time_s,\n", b"\x89TREXREC", b"\xff" * 99])
def test_damaged_header_identifies_no_device(tmp_path: Path, data: bytes) -> None:
    path = tmp_path / "a.csv"
    path.write_bytes(data)
    assert recorded_device(path) == ""
    assert recorded_device(tmp_path / "none") == ""
