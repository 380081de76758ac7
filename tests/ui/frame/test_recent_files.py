"""List of recent files."""

from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from tests.support.program import trex
from tests.support.window import WindowDriver
from trex_gui.core.resource_files import resource
from trex_gui.ui.frame.files import RecentFile, RecentFiles
from trex_gui.ui.preferences import Preferences

pytestmark = pytest.mark.usefixtures("qapp")
FOLDER = Path("/my files").absolute()


def names(recent: RecentFiles) -> list[str]:
    return [file.path.name for file in recent.entries]


def test_newest_file_is_listed_first_and_once(qtbot: QtBot) -> None:
    recent = RecentFiles()
    for name in ("a.txt", "b.trexrec", "a.txt"):
        with qtbot.waitSignal(recent.changed):
            recent.add("trex", "settings", FOLDER / name)
    assert names(recent) == ["a.txt", "b.trexrec"]
    first = RecentFiles().entries[0]
    assert (first.device, first.kind, first.path) == ("trex", "settings", FOLDER / "a.txt")
    for number in range(20):
        recent.add("trex", "settings", FOLDER / f"{number}.txt")
    assert names(recent) == [f"{number}.txt" for number in range(19, 11, -1)]


def test_file_is_removed_from_the_list() -> None:
    recent = RecentFiles()
    for name in ("a & b.txt", "c.txt"):
        recent.add("aracna", "poses", FOLDER / name)
    assert recent.entries[1].title == "a & b.txt  (my files)"
    recent.remove(recent.entries[0])
    assert names(recent) == ["a & b.txt"]


@pytest.mark.parametrize("stored", ["", "trex", "trex settings", "\n\n", "@Invalid()"])
def test_invalid_lines_and_paths_are_ignored(stored: str) -> None:
    Preferences().set("files/recent", f"{stored}\ntrex settings /a b.txt")
    assert names(RecentFiles()) == ["a b.txt"]
    RecentFiles().add("trex", "settings", FOLDER / "two\nlines.txt")
    assert names(RecentFiles()) == ["a b.txt"]


def test_file_whose_folder_cannot_be_read_is_not_removed(
    window: WindowDriver, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "rover.txt"
    path.write_bytes((resource("samples") / "trex_factory_defaults.txt").read_bytes())

    def is_file(_path: Path) -> bool:
        raise PermissionError

    monkeypatch.setattr(Path, "is_file", is_file)
    window.window.files.open_recent(RecentFile("trex", "settings", path))
    window.wait_for_files()
    assert [e.document.path for e in trex(window.program).workspace.files.editors] == [path]
