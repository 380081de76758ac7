"""The window goes on while a disk takes seconds, and nothing is lost."""

from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.support.pages.settings import ReviewDialog
from tests.support.slow_disk import SECONDS, SlowDisk
from tests.support.virtual_devices import VirtualSimulator
from tests.support.window import WindowDriver
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.runtime import now


@pytest.fixture
def disk(monkeypatch: pytest.MonkeyPatch) -> Iterator[SlowDisk]:
    disk = SlowDisk(monkeypatch)
    yield disk
    assert disk.stalls == []


def stored(simulator: VirtualSimulator) -> int:
    return int(simulator.show()["parameters"]["serial_timeout"])


# --- The snapshot before Apply ----------------------------------------------------------


@pytest.fixture
def review(connected_window: WindowDriver, disk: SlowDisk) -> ReviewDialog:
    """The review, which was told to write one setting and saves the snapshot."""
    del disk
    review = ReviewDialog(connected_window)
    connected_window.device.parameters.edit("serial_timeout", 15)
    review.open()
    review.click("writeButton")
    return review


def test_apply_begins_once_the_snapshot_is_saved(
    connected_window: WindowDriver, review: ReviewDialog, quick_simulator: VirtualSimulator
) -> None:
    device, begin = connected_window.device, now()
    review.wait(lambda: now() > begin + SECONDS / 2)
    assert device.applying
    assert "Saving the board's present settings" in review.head
    assert not connected_window.is_enabled("applyButton")
    assert stored(quick_simulator) == 0
    review.wait_for_text("reviewHead", "written and verified")
    assert now() >= begin + SECONDS
    assert stored(quick_simulator) == 15
    (snapshot,) = device.history.folder.iterdir()
    assert "serial_timeout: 0 " in snapshot.read_text(encoding="utf-8")


def test_apply_is_cancelled_while_the_snapshot_is_saved(
    connected_window: WindowDriver, review: ReviewDialog, quick_simulator: VirtualSimulator
) -> None:
    device = connected_window.device
    assert review.button("reviewCloseButton").text() == "Cancel"
    review.close()
    assert not device.applying
    review.wait_for_files()
    assert stored(quick_simulator) == 0
    assert device.parameters.pending == (("serial_timeout", 15),)
    review.write()
    assert stored(quick_simulator) == 15


@pytest.mark.parametrize("fault", ["line mute on", "line unplug"])
def test_board_that_goes_away_while_the_snapshot_is_saved_gets_nothing(
    connected_window: WindowDriver,
    review: ReviewDialog,
    quick_simulator: VirtualSimulator,
    fault: str,
) -> None:
    device = connected_window.device
    quick_simulator.do(fault)
    review.wait(lambda: not device.applying)
    assert review.button("reviewCloseButton").text() == "Close"
    quick_simulator.do("line mute off" if "mute" in fault else "line plug")
    review.wait_for_files()
    assert stored(quick_simulator) == 0
    assert device.draft.pending == 1


def test_disconnecting_while_the_snapshot_is_saved_writes_nothing(
    connected_window: WindowDriver, review: ReviewDialog, quick_simulator: VirtualSimulator
) -> None:
    device = connected_window.device
    device.connect_to(ConnectionSettings(quick_simulator.url))  # closes the line first
    review.wait(lambda: device.link is ConnectionState.CONNECTED)
    review.wait_for_files()
    assert not device.applying
    assert stored(quick_simulator) == 0
    assert device.draft.pending == 1


def test_settings_that_changed_while_the_snapshot_was_saved_are_not_written_over(
    connected_window: WindowDriver, review: ReviewDialog, quick_simulator: VirtualSimulator
) -> None:
    quick_simulator.do("eeprom motor1_acceleration 9")
    connected_window.device.reload()
    review.wait_for_text("reviewHead", "other settings were read")
    review.wait_for_files()
    assert stored(quick_simulator) == 0


def test_factory_reset_keeps_edits_until_the_snapshot_is_saved(
    connected_window: WindowDriver, disk: SlowDisk, tmp_path: Path
) -> None:
    del disk
    device = connected_window.device
    (tmp_path / "taken").write_bytes(b"")
    device.history.folder = tmp_path / "taken"
    device.parameters.edit("serial_timeout", 15)
    device.reset_to_factory()
    connected_window.wait_for_text("bannerText", "Nothing was written")
    assert device.draft.pending == 1
