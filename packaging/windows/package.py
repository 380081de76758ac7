"""Build and check of the installer for Windows."""

import shutil
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from functools import partial
from pathlib import Path, PureWindowsPath

from bootstrap import CONSTRAINTS, ROOT, BootstrapError
from checks import (
    TOUR_TIMEOUT_S,
    SimulatedBoard,
    Steps,
    check_board,
    require,
    require_gone,
    simulated_board,
    wait_until,
)
from windows.wine import Windows, WindowsError, Wine

HERE = Path(__file__).resolve().parent
ICONS = HERE.parent / "icons.py"
NAME = "TReX Studio"
PROGRAMS = ("trex-gui.exe", "trexcmd.exe", "trex-sim.exe")
NSIS_64_BIT = Path("/usr/share/nsis/Stubs/lzma_solid-amd64-unicode")
"""Stub of 64-bit installers in Debian's NSIS. A 64-bit Wine runs no other installers."""

FREEZE = """
import ctypes, sys
from pathlib import Path
# Start Wine's desktop here, because it holds the pipes of its parent process open.
ctypes.windll.user32.GetDesktopWindow()
sys.path.insert(0, "packaging")
import packages
packages.freeze(Path(sys.argv[1]))
"""
FREEZE_TIMEOUT_S = 1800.0


def freeze_in_wine(wine: Wine, wheel: Path, folder: Path, timestamp: int) -> None:
    """Freeze the program with a Windows Python.

    Args:
        wine: prefix that contains the Windows Python.
        wheel: wheel of the program, for its metadata.
        folder: new folder of the programs.
        timestamp: time of the files in the folder, in seconds since 1970.
    """
    wine.prepare()
    python = wine.python(CONSTRAINTS, wheel)
    script = f"import os; os.chdir(r'Z:{ROOT}'){FREEZE}"
    epoch = {"SOURCE_DATE_EPOCH": str(timestamp)}
    wine.run([python, "-c", script, f"Z:{folder}"], epoch, FREEZE_TIMEOUT_S)


def build_installer(frozen: Path, version: str, output: Path) -> None:
    """Build the installer of a frozen folder with NSIS."""
    makensis = shutil.which("makensis") or r"C:\Program Files (x86)\NSIS\makensis.exe"
    icon = output.with_suffix(".ico")
    subprocess.run([sys.executable, str(ICONS), str(icon)], check=True)
    values = {"VERSION": version, "SOURCE": frozen, "ICON": icon, "OUTPUT": output}
    if NSIS_64_BIT.exists():
        values["TARGET"] = "amd64-unicode"
    definitions = [f"-D{name}={value}" for name, value in values.items()]
    options = ["-V2", "-WX", "-INPUTCHARSET", "UTF8"]
    command = [makensis, *options, *definitions, str(HERE / "installer.nsi")]
    process = subprocess.run(command, capture_output=True, text=True, check=False)
    icon.unlink()
    if process.returncode != 0:
        text = f"{process.stdout}{process.stderr}"
        raise BootstrapError(f"makensis: status {process.returncode}\n{text}")


class Installation:
    """Installed programs, with menu entry and registry key."""

    def __init__(self, windows: Windows) -> None:
        self.windows = windows
        self.folder = windows.drive / "Program Files" / NAME
        menu = "ProgramData/Microsoft/Windows/Start Menu/Programs"
        self.menu_entry = windows.drive / menu / f"{NAME}.lnk"
        self.key = rf"HKLM\Software\Microsoft\Windows\CurrentVersion\Uninstall\{NAME}"

    def install(self, installer: Path) -> None:
        self.windows.run([installer, "/S"])

    def uninstall(self) -> None:
        """Remove the programs. Waits for the background process of the uninstaller."""
        self.windows.run([self.folder / "uninstall.exe", "/S"])
        wait_until(
            lambda: not (self.menu_entry.exists() or self.is_registered),
            "the uninstaller did not finish",
        )

    @property
    def is_registered(self) -> bool:
        """True if the settings of Windows list the program."""
        try:
            return "QuietUninstallString" in self.windows.run(["reg", "query", self.key, "/reg:64"])
        except WindowsError:
            return False

    def require_installed(self, version: str) -> None:
        for path in (*map(self.folder.__truediv__, PROGRAMS), self.menu_entry):
            require(path.exists(), f"{path} was not installed")
        values = self.windows.run(["reg", "query", self.key, "/reg:64"])
        require(version in values, f"the registry does not contain version {version}:\n{values}")

    def require_removed(self) -> None:
        require_gone([self.folder, self.menu_entry])
        require(not self.is_registered, "the registry key was not removed")

    def show_board_in_window(self, port: str) -> None:
        """Run the window with a port until it has logged the connection."""
        log_before = self._log()
        with self.windows.start([self.folder / "trex-gui.exe", "--port", port]) as window:
            try:
                wait_until(
                    lambda: "Connected to TReX" in self._log().removeprefix(log_before),
                    "the window did not connect",
                )
            finally:
                window.kill()

    def _log(self) -> str:
        files = self.windows.drive.glob("users/*/AppData/Local/TReX Studio/log/trex-gui.log")
        return "".join(file.read_text(encoding="utf-8") for file in files)

    def run(
        self, program: str, *arguments: str | Path, port: str = "", timeout: float = 120
    ) -> str:
        """Run a program and return its output. Paths are converted to Windows paths."""
        words = (
            str(PureWindowsPath("C:/", word.relative_to(self.windows.drive)))
            if isinstance(word, Path)
            else word
            for word in arguments
        )
        return self.windows.run([self.folder / program, *words], {"TREX_PORT": port}, timeout)

    @contextmanager
    def simulator(self) -> Iterator[tuple[str, SimulatedBoard]]:
        """Run `trex-sim` on TCP, and yield its port and board."""
        with self.windows.start([self.folder / "trex-sim.exe", "--tcp", "127.0.0.1:0"]) as process:
            try:
                yield simulated_board(process)
            finally:
                process.terminate()


def check_installer(installer: Path, version: str, windows: Windows, steps: Steps) -> None:
    """Install, use and remove the program."""
    installed = Installation(windows)
    home = windows.drive / "trial"
    pictures = home / "pictures"

    with steps.group("windows"):
        with steps.required("install"):
            windows.prepare()
            installed.install(installer)
            installed.require_installed(version)
        with steps.step("versions"):
            for program in PROGRAMS[1:]:  # trex-gui.exe has no console
                text = installed.run(program, "--version")
                require(version in text, f"{program} says {text!r}")
        with steps.step("use the simulated board"), installed.simulator() as (port, board):
            home.mkdir(exist_ok=True)
            check_board(partial(installed.run, "trexcmd.exe", port=port), home, steps, board)
        with steps.step("demonstration in the window"):
            shutil.rmtree(pictures, ignore_errors=True)
            installed.run("trex-gui.exe", "--tour", pictures, timeout=TOUR_TIMEOUT_S)
            names = {path.name for path in pictures.glob("*.png")}
            require({"motors-light.png", "aracnaRobot-dark.png"} <= names, f"only {sorted(names)}")
        with steps.step("connect over TCP in the window"), installed.simulator() as (port, _):
            installed.show_board_in_window(port)
        with steps.step("remove"):
            installed.uninstall()
            installed.require_removed()
            data = windows.drive.glob("users/*/AppData/Local/*/snapshots/*.txt")
            require(list(data), "the snapshots of the user were removed")
    windows.stop()
