"""The installer for Windows: made from the frozen folder, and tried under Wine."""

import shutil
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from functools import partial
from pathlib import Path, PureWindowsPath

from bootstrap import CONSTRAINTS, ROOT, BootstrapError
from checks import (
    TOUR_S,
    SimulatedBoard,
    Steps,
    require,
    require_gone,
    simulated_board,
    use_board,
    wait_until,
)
from windows.wine import Windows, WindowsError, Wine

HERE = Path(__file__).resolve().parent
ICONS = HERE.parent / "icons.py"
NAME = "TReX Studio"
PROGRAMS = ("trex-gui.exe", "trexcmd.exe", "trex-sim.exe")
NSIS_64_BIT = Path("/usr/share/nsis/Stubs/lzma_solid-amd64-unicode")
"""Debian's NSIS makes 64-bit installers, too: the only ones that a 64-bit Wine runs."""

FREEZE = """
import ctypes, sys
from pathlib import Path
# Start Wine's desktop from here: it keeps the pipes of the program that starts it.
ctypes.windll.user32.GetDesktopWindow()
sys.path.insert(0, "packaging")
import packages
packages.freeze(Path(sys.argv[1]))
"""
FREEZE_S = 1800.0


def freeze_in_wine(wine: Wine, wheel: Path, folder: Path, when: int) -> None:
    """Freeze the program with a Windows Python.

    Args:
        wine: where that Python is.
        wheel: the program, for its metadata.
        folder: is made, and takes the programs.
        when: seconds since 1970 that files in the result have.
    """
    wine.prepare()
    python = wine.python(CONSTRAINTS, wheel)
    script = f"import os; os.chdir(r'Z:{ROOT}'){FREEZE}"
    epoch = {"SOURCE_DATE_EPOCH": str(when)}
    wine.run([python, "-c", script, f"Z:{folder}"], epoch, FREEZE_S)


def make_installer(frozen: Path, version: str, output: Path) -> None:
    """Pack a folder with NSIS."""
    makensis = shutil.which("makensis") or r"C:\Program Files (x86)\NSIS\makensis.exe"
    icon = output.with_suffix(".ico")
    subprocess.run([sys.executable, str(ICONS), str(icon)], check=True)
    values = {"VERSION": version, "SOURCE": frozen, "ICON": icon, "OUTPUT": output}
    if NSIS_64_BIT.exists():
        values["TARGET"] = "amd64-unicode"
    definitions = [f"-D{name}={value}" for name, value in values.items()]
    options = ["-V2", "-WX", "-INPUTCHARSET", "UTF8"]
    command = [makensis, *options, *definitions, str(HERE / "installer.nsi")]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    icon.unlink()
    if done.returncode != 0:
        raise BootstrapError(f"makensis: status {done.returncode}\n{done.stdout}{done.stderr}")


class Installation:
    """What the installer makes, and removes."""

    def __init__(self, windows: Windows) -> None:
        self.windows = windows
        self.folder = windows.drive / "Program Files" / NAME
        menu = "ProgramData/Microsoft/Windows/Start Menu/Programs"
        self.menu_entry = windows.drive / menu / f"{NAME}.lnk"
        self.key = rf"HKLM\Software\Microsoft\Windows\CurrentVersion\Uninstall\{NAME}"

    def install(self, installer: Path) -> None:
        self.windows.run([installer, "/S"])

    def uninstall(self) -> None:
        """Remove the programs; what NSIS starts goes on for a moment."""
        self.windows.run([self.folder / "uninstall.exe", "/S"])
        wait_until(
            lambda: not (self.menu_entry.exists() or self.is_registered),
            "the uninstaller does not end",
        )

    @property
    def is_registered(self) -> bool:
        """Whether the settings of Windows list the program."""
        try:
            return "QuietUninstallString" in self.windows.run(["reg", "query", self.key, "/reg:64"])
        except WindowsError:
            return False

    def require_installed(self, version: str) -> None:
        for path in (*map(self.folder.__truediv__, PROGRAMS), self.menu_entry):
            require(path.exists(), f"{path} was not installed")
        listing = self.windows.run(["reg", "query", self.key, "/reg:64"])
        require(version in listing, f"the registry lists no version {version}:\n{listing}")

    def require_removed(self) -> None:
        require_gone([self.folder, self.menu_entry])
        require(not self.is_registered, "left behind in the registry")

    def show_board_in_window(self, port: str) -> None:
        """Start the window with a port, and kill it as soon as its log says what is there."""
        log_before = self._log()
        with self.windows.start([self.folder / "trex-gui.exe", "--port", port]) as window:
            try:
                wait_until(
                    lambda: "Connected to TReX" in self._log().removeprefix(log_before),
                    "the window does not connect",
                )
            finally:
                window.kill()

    def _log(self) -> str:
        files = self.windows.drive.glob("users/*/AppData/Local/TReX Studio/log/trex-gui.log")
        return "".join(file.read_text(encoding="utf-8") for file in files)

    def run(
        self, program: str, *arguments: str | Path, port: str = "", timeout: float = 120
    ) -> str:
        """Run a program; paths are written as it sees them."""
        words = (
            str(PureWindowsPath("C:/", word.relative_to(self.windows.drive)))
            if isinstance(word, Path)
            else word
            for word in arguments
        )
        return self.windows.run([self.folder / program, *words], {"TREX_PORT": port}, timeout)

    @contextmanager
    def simulator(self) -> Iterator[tuple[str, SimulatedBoard]]:
        """Run `trex-sim` on a TCP port; gives the port and the board."""
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

    with steps.place("windows"):
        with steps.required("install"):
            windows.prepare()
            installed.install(installer)
            installed.require_installed(version)
        with steps.step("versions"):
            for program in PROGRAMS[1:]:  # the window's program has no console to write to
                text = installed.run(program, "--version")
                require(version in text, f"{program} says {text!r}")
        with steps.step("use the simulated board"), installed.simulator() as (port, board):
            home.mkdir(exist_ok=True)
            use_board(partial(installed.run, "trexcmd.exe", port=port), home, steps, board)
        with steps.step("demonstration in the window"):
            shutil.rmtree(pictures, ignore_errors=True)
            installed.run("trex-gui.exe", "--tour", pictures, timeout=TOUR_S)
            names = {path.name for path in pictures.glob("*.png")}
            require({"motors-light.png", "aracnaRobot-dark.png"} <= names, f"only {sorted(names)}")
        with steps.step("connect over TCP in the window"), installed.simulator() as (port, _):
            installed.show_board_in_window(port)
        with steps.step("remove"):
            installed.uninstall()
            installed.require_removed()
            data = windows.drive.glob("users/*/AppData/Local/*/snapshots/*.txt")
            require(list(data), "the user's snapshots are gone")
    windows.stop()
