"""Kill a program repeatedly while it saves files, and check the files that it leaves behind.

The content of a file follows from its version number. The program prints the number of each saved
version. After the kill, the reader of TReX Studio must find the last saved version or the next
version, complete. Only a recording may be cut, if its reader reports that. The program forks, so
this does not run on Windows.

`python -m tests.support.kill_saves` runs the program. For each line with kind, folder and version
it forks a process that saves this version and all later versions. It prints the process number,
then the saved versions, then `ended`.
"""

import itertools
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass, replace
from datetime import UTC, datetime, timedelta
from pathlib import Path
from random import Random
from typing import Self, TextIO

from PySide6.QtCore import QSettings

from trex_gui.core.files import load, save
from trex_gui.core.recording.kinds import Marker
from trex_gui.core.recording.store import Recording, RecordingWriter
from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.devices.trex.protocol.flags import Mode
from trex_gui.devices.trex.recording import FORMAT, Header, Record
from trex_gui.devices.trex.settings.document import Settings, factory_settings
from trex_gui.devices.trex.settings.edit_files import BoardIdentity, EditFiles
from trex_gui.devices.trex.settings.history import SettingsHistory
from trex_gui.devices.trex.settings.reader import read_settings
from trex_gui.devices.trex.settings.writer import write_settings
from trex_gui.ui.files import write_text
from trex_gui.ui.preferences import remove_stale_files
from trex_gui.ui.workers.file_worker import ProgressCallback

ROOT = Path(__file__).parents[2]
MAX_KILL_S = 0.03  # time until the kill; saving a version takes some milliseconds
START = datetime(2026, 1, 1, tzinfo=UTC)
SNAPSHOT_LIMIT = 4
BOARD = BoardIdentity(device_table().model("trex"), "1.2", 7)
MARKERS = 300  # in a recording
LINES = 3000  # of a transcript


@dataclass(frozen=True)
class Kind:
    """Functions that save a version of a file and find its version.

    `find` returns 0 without a file, and fails if a file is unexpectedly incomplete.
    """

    save: Callable[[Path, int], object]
    find: Callable[[Path], int]


def _settings_of(version: int) -> Settings:
    settings = factory_settings(device_table().model("trex"), "1.2")
    return replace(settings, parameters={**settings.parameters, "serial_timeout": version % 100})


def _save_settings(folder: Path, version: int) -> None:
    save(folder / "a.txt", write_settings(_settings_of(version), title_lines=[f"{version}"]))


def _find_settings(folder: Path) -> int:
    path = folder / "a.txt"
    if not path.exists():
        return 0
    data = load(path)
    version = int(data.split(b"# ")[1].split()[0])
    settings, findings = read_settings(data, path.name)
    assert settings == _settings_of(version), settings
    assert not findings, findings
    return version


def _save_snapshot(folder: Path, version: int) -> None:
    history = SettingsHistory(folder / "snapshots")
    if history.limit().count != SNAPSHOT_LIMIT:
        history.set_limit(SNAPSHOT_LIMIT)
    now = START + timedelta(seconds=version)
    history.save(_settings_of(version), adapter="COM1", reason=f"version {version}", now=now)


def _find_snapshot(folder: Path) -> int:
    history = SettingsHistory(folder / "snapshots")
    snapshots = history.snapshots()
    for snapshot in snapshots:
        assert not snapshot.problem, snapshot
        version = int(snapshot.reason.split()[-1])
        assert history.load(snapshot) == _settings_of(version), snapshot
    assert not history.limit().problem, history.limit()
    newest = int(snapshots[0].reason.split()[-1]) if snapshots else 0
    assert len(snapshots) >= min(newest, SNAPSHOT_LIMIT), len(snapshots)
    return newest


def _save_limit(folder: Path, version: int) -> None:
    SettingsHistory(folder / "snapshots").set_limit(version)


def _find_limit(folder: Path) -> int:
    limit = SettingsHistory(folder / "snapshots").limit()
    assert not limit.problem, limit
    is_new = not (folder / "snapshots" / "history.txt").exists()
    return 0 if is_new else limit.count or 0


def _save_edits(folder: Path, version: int) -> None:
    high, low = divmod(version, 100)
    edits = {"serial_timeout": low, "motor1_acceleration": high}
    EditFiles(folder / "edits").save(BOARD, Settings(BOARD.product, BOARD.firmware, edits))


def _find_edits(folder: Path) -> int:
    if (found := EditFiles(folder / "edits").load(BOARD)) is None:
        return 0
    edits = found.settings.parameters
    return 100 * edits["motor1_acceleration"] + edits["serial_timeout"]


def _header(version: int) -> Header:
    model = device_table().model("trex")
    return Header(START, 10.0, model, "1.2", Mode.SERIAL_RC, f"version {version}", None)


def _markers(version: int) -> list[Record]:
    return [Marker(10.0 + n / 100, "note", f"{version} {n}") for n in range(MARKERS)]


def _save_recording(folder: Path, version: int) -> None:
    writer = RecordingWriter[Header, Record](folder / "a.trexrec", FORMAT, _header(version))
    markers = _markers(version)
    for first in range(0, MARKERS, 100):
        writer.write(markers[first : first + 100])
        writer.commit()
    writer.finish()
    writer.close()


def _find_recording(folder: Path) -> int:
    path = folder / "a.trexrec"
    if not path.exists():
        return 0
    recording = Recording[Header, Record](path, FORMAT)
    records = recording.read(1, MARKERS)
    recording.close()
    version = int(recording.header.settings.split()[-1])
    assert records == _markers(version)[: len(records)], records[-1]
    assert len(records) == MARKERS or recording.problems, "closed, but incomplete"
    return version


def _save_transcript(folder: Path, version: int) -> None:
    def write(file: TextIO, _progress: ProgressCallback) -> int:
        return file.write("".join(f"{version} {number}\n" for number in range(LINES)))

    write_text(folder / "a.tsv", write, lambda _share: None)


def _find_transcript(folder: Path) -> int:
    path = folder / "a.tsv"
    if not path.exists():
        return 0
    lines = path.read_text(encoding="utf-8").splitlines()
    version = int(lines[0].split()[0])
    assert lines == [f"{version} {number}" for number in range(LINES)], len(lines)
    return version


def _preferences(folder: Path) -> QSettings:
    return QSettings(str(folder / "a.ini"), QSettings.Format.IniFormat)


def _save_preferences(folder: Path, version: int) -> None:
    store = _preferences(folder)
    for number in range(50):
        store.setValue(f"group/{number}", f"{version}")
    store.sync()


def _find_preferences(folder: Path) -> int:
    store = _preferences(folder)
    versions = {int(str(store.value(f"group/{number}", 0))) for number in range(50)}
    assert len(versions) == 1, versions
    return versions.pop()


KINDS = {
    "settings": Kind(_save_settings, _find_settings),
    "snapshot": Kind(_save_snapshot, _find_snapshot),
    "limit": Kind(_save_limit, _find_limit),
    "edits": Kind(_save_edits, _find_edits),
    "recording": Kind(_save_recording, _find_recording),
    "transcript": Kind(_save_transcript, _find_transcript),
    "preferences": Kind(_save_preferences, _find_preferences),
}


# --- The program that saves ---------------------------------------------------------------


def _main() -> None:
    for line in sys.stdin:
        kind, folder, version = line.rstrip("\n").split("\t")
        process = os.fork()
        if process == 0:
            os.write(1, b"%d\n" % os.getpid())  # here, so that it comes before the versions
            for number in itertools.count(int(version)):
                KINDS[kind].save(Path(folder), number)
                os.write(1, b"%d\n" % number)
        os.waitpid(process, 0)
        os.write(1, b"ended\n")


class Saver:
    """Running program, which saves on request."""

    def __enter__(self) -> Self:
        self._process = subprocess.Popen(
            [sys.executable, "-m", "tests.support.kill_saves"],
            cwd=ROOT,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )
        return self

    def __exit__(self, *_: object) -> None:
        self._process.communicate()

    def save_and_be_killed(self, kind: str, folder: Path, version: int, seconds: float) -> int:
        """Save this version and later versions until the kill. Return the last saved version."""
        assert self._process.stdin is not None
        assert self._process.stdout is not None
        self._process.stdin.write(f"{kind}\t{folder}\t{version}\n")
        self._process.stdin.flush()
        number = int(self._process.stdout.readline())
        time.sleep(seconds)
        os.kill(number, signal.SIGKILL)
        saved = version - 1
        while (line := self._process.stdout.readline().strip()) != "ended":
            saved = int(line)
        return saved


# --- Attack -------------------------------------------------------------------------------


def _stray_files(folder: Path, known: set[str]) -> list[str]:
    found = (path for path in folder.rglob("*") if path.is_file())
    return sorted(path.name for path in found if path.name not in known)


def _age(folder: Path) -> None:
    """Make the files of a folder a day older."""
    for path in folder.rglob("*"):
        if path.is_file():
            os.utime(path, (time.time() - 86400,) * 2)


def attack(saver: Saver, kind: str, folder: Path, rounds: int, random: Random) -> list[str]:
    """Kill the saving program several times. Return the errors in its files."""
    version = 0
    for number in range(1, rounds + 1):
        saved = saver.save_and_be_killed(kind, folder, version + 1, random.uniform(0, MAX_KILL_S))
        try:
            version = KINDS[kind].find(folder)
        except Exception as error:  # noqa: BLE001 - a reader may raise anything
            return [f"{kind}, kill {number}, after version {saved}: {error!r}"]
        if version not in {saved, saved + 1}:
            return [f"{kind}, kill {number}: found version {version} after {saved} was saved"]
    _age(folder)
    KINDS[kind].save(folder, version + 1)
    remove_stale_files.cache_clear()
    remove_stale_files(folder / "a.ini")  # like the next start
    snapshots = {found.path.name for found in SettingsHistory(folder / "snapshots").snapshots()}
    if len(snapshots) > SNAPSHOT_LIMIT:
        return [f"{kind}: {len(snapshots)} snapshots"]
    stray = _stray_files(
        folder, snapshots | {f"{BOARD}.txt", "a.txt", "a.tsv", "a.ini", "a.trexrec", "history.txt"}
    )
    return [f"{kind}: left behind: {', '.join(stray)}"] if stray else []


def run(seconds: float, seed: int) -> list[str]:
    """Attack every kind of file in turn for some seconds. Return the errors."""
    random, end = Random(seed), time.monotonic() + seconds
    findings: list[str] = []
    with Saver() as saver:
        for kind in itertools.cycle(KINDS):
            if time.monotonic() >= end:
                return findings
            folder = Path(tempfile.mkdtemp(prefix="kill_saves."))
            try:
                findings += attack(saver, kind, folder, 50, random)
            finally:
                shutil.rmtree(folder)
    return findings


if __name__ == "__main__":
    _main()
