"""Support report: text files without personal data, in a zip archive."""

import getpass
import importlib.metadata
import io
import os
import platform
import re
import socket
import sys
import zipfile
from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path

from serial.tools import list_ports

from trex_gui.core.crash_detection import crash_file
from trex_gui.core.errors import StudioError
from trex_gui.core.files import open_ordinary, save
from trex_gui.core.guardian import log as guardian
from trex_gui.core.log_file import log_files
from trex_gui.version import __version__

_PACKAGES = ("PySide6-Essentials", "pyserial", "numpy", "pyqtgraph", "ruamel.yaml", "pygame-ce")
_LARGEST_GUARDIAN_LOG = 65536  # bytes from the end of the log
_LARGEST_LOG = 262144
_SHORTEST_NAME = 3  # characters; a shorter user or computer name may be an ordinary word
_SHORTEST_SERIAL = 5  # characters; many adapters share a shorter number, such as 0001
_SHARED_NAMES = frozenset({"root", "admin", "administrator", "user", "pi", "localhost"})

_FOLDERS = re.compile(
    r"((?:/home|/Users|/media|/run/media|[A-Za-z]:[\\/]+Users)[\\/]+)[^\\/\s:\"'<>|]+"
)
_SPACED_FOLDERS = re.compile(r"([A-Za-z]:\\+Users\\+)[^\\:\"<>|\n]+(?=\\)")
_SHARES = re.compile(r"(?<![\w\\:])(\\\\)[^\\\s?.]+(?=\\)")
_BY_ID = re.compile(r"((?:/dev/serial/by-id/|\busb-)\S*_)[^_\s]+?(-(?:if|port)\d+)")
_MAC_PORT = re.compile(
    r"(/dev/(?:cu|tty)\.)(?!(?:SLAB_USBtoUART|Bluetooth-Incoming-Port|debug-console)\b)"
    r"(usbserial-?|usbmodem|wchusbserial|)[^\s:,;]*[^\s:,;.]"
)
_SERIAL = re.compile(rf"\b(SE?N?R=)[^\s<\]]{{{_SHORTEST_SERIAL},}}")
_BLUETOOTH = re.compile(r"(BTHENUM\\\S*&)[0-9A-Fa-f]{12}(?=_)")
_HOST = re.compile(
    r"\b((?:socket|rfc2217|trex|hwgrep|spy)://)"
    r"(?!(?:127\.0\.0\.1|localhost|\[::1\])(?![\w-]|\.\w))"
    r"(?:[^\s/@]*@)?(?:\[[^\]\s]*\]|[^\s/:]+)"
)
_ADDRESS = re.compile(
    r"\b(?!127\.0\.0\.1\b)\d{1,3}(?:\.\d{1,3}){3}\b"
    r"|(?<![\w:.\[])(?=[0-9A-Fa-f:]*::[0-9A-Fa-f]|(?:[0-9A-Fa-f]{1,4}:){5})"
    r"[0-9A-Fa-f]{0,4}(?::[0-9A-Fa-f]{0,4}){2,7}(?![\w:])"
)
_MAIL = re.compile(r"\b[\w.+-]+@[\w-]+\.[\w.-]+\b")


@dataclass(frozen=True, slots=True)
class ReportFile:
    name: str
    text: str

    @property
    def data(self) -> bytes:
        return self.text.encode("utf-8", "backslashreplace")


@dataclass(frozen=True, slots=True)
class Mask:
    """Personal data that `clean` replaces with placeholders such as `<user>`."""

    home: str = ""
    user: str = ""
    computer: str = ""
    serial_numbers: Sequence[str] = ()

    @classmethod
    def of_this_computer(cls) -> "Mask":
        try:
            user = getpass.getuser()
        except (OSError, KeyError, ImportError):
            user = ""
        numbers = sorted({port.serial_number or "" for port in list_ports.comports()})
        return cls(str(Path.home()), user, socket.gethostname(), numbers)

    def clean(self, text: str) -> str:
        text = _BY_ID.sub(r"\1<serial>\2", text)
        text = _MAC_PORT.sub(r"\1\2<serial>", text)
        for number, serial in enumerate(self.serial_numbers, 1):
            if len(serial) >= _SHORTEST_SERIAL:
                text = re.sub(
                    rf"(?<![0-9A-Za-z]){re.escape(serial)}(?![0-9A-Za-z])",
                    f"<serial {number}>",
                    text,
                )
        text = _SERIAL.sub(r"\1<serial>", text)
        text = _BLUETOOTH.sub(r"\1<address>", text)
        if len(self.home) > 1:
            for home in {self.home, self.home.replace("\\", "/")}:
                text = re.sub(rf"{re.escape(home)}(?![\w.-])", "~", text)
        text = _SPACED_FOLDERS.sub(r"\1<user>", text)
        text = _FOLDERS.sub(r"\1<user>", text)
        text = _SHARES.sub(r"\1<computer>", text)
        text = _HOST.sub(r"\1<address>", text)
        text = _MAIL.sub("<mail>", text)
        text = _ADDRESS.sub("<address>", text)
        for name, mask in ((self.computer, "<computer>"), (self.user, "<user>")):
            for part in (name, name.partition(".")[0]):  # the full name first
                if len(part) >= _SHORTEST_NAME and part.lower() not in _SHARED_NAMES:
                    text = re.sub(
                        rf"(?<!\w){re.escape(part)}(?!\w)", mask, text, flags=re.IGNORECASE
                    )
        return text


def create_report(
    parts: Mapping[str, Callable[[], str]], mask: Mask | None = None
) -> tuple[ReportFile, ...]:
    """Return the non-empty files of a report: the program's own files and `parts`.

    This may take several seconds. If a part fails, its file contains the error.
    """
    mask = mask or Mask.of_this_computer()
    own: dict[str, Callable[[], str]] = {
        "versions.txt": _versions,
        "ports.txt": _ports,
        "guardian.txt": lambda: _last_bytes(_LARGEST_GUARDIAN_LOG, guardian.log_file()),
        "program.txt": lambda: _last_bytes(_LARGEST_LOG, *log_files()),
        "crash.txt": lambda: _last_bytes(_LARGEST_LOG, crash_file()),
    }
    files = (ReportFile(name, mask.clean(_text(part))) for name, part in {**own, **parts}.items())
    return tuple(file for file in files if file.text)


def save_report(path: Path, files: Iterable[ReportFile]) -> None:
    """Write the zip archive atomically. Raises SettingsError."""
    data = io.BytesIO()
    with zipfile.ZipFile(data, "w", zipfile.ZIP_DEFLATED) as archive:
        for file in files:
            archive.writestr(file.name, file.data)
    save(path, data.getvalue())


def suggested_name() -> str:
    return f"trex_report_{datetime.now(UTC).astimezone():%Y-%m-%d_%H-%M}.zip"


def _text(part: Callable[[], str]) -> str:
    try:
        return part()
    except (StudioError, OSError) as error:
        return f"Not available: {error}\n"


def _versions() -> str:
    rows = {
        "TReX Studio": __version__,
        "written": datetime.now(UTC).isoformat(timespec="seconds"),
        "system": platform.platform(),
        "machine": platform.machine(),
        "Python": sys.version.split()[0],
        "bundled": str(bool(getattr(sys, "frozen", False))),
        "desktop": os.environ.get("XDG_CURRENT_DESKTOP", ""),
        "display": os.environ.get("QT_QPA_PLATFORM") or os.environ.get("XDG_SESSION_TYPE", ""),
        "language": os.environ.get("LC_ALL") or os.environ.get("LANG", ""),
    }
    for package in _PACKAGES:
        try:
            rows[package] = importlib.metadata.version(package)
        except importlib.metadata.PackageNotFoundError:
            rows[package] = "not installed"
    return "".join(f"{name}: {value}\n" for name, value in rows.items() if value)


def _ports() -> str:
    ports = sorted(list_ports.comports(), key=lambda port: str(port.device))
    if not ports:
        return "This computer has no serial ports.\n"
    return "".join(f"{port.device}: {port.description} [{port.hwid}]\n" for port in ports)


def _last_bytes(limit: int, *paths: Path) -> str:
    """Return the last `limit` bytes of `paths`, which are sorted from old to new."""
    data = b""
    for path in reversed(paths):
        with suppress(FileNotFoundError), open_ordinary(path) as file:
            remaining = limit - len(data)
            file.seek(max(0, file.seek(0, os.SEEK_END) - remaining))
            data = file.read(remaining) + data
    return data.decode(errors="replace")
