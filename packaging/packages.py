"""Build and check the packages for users.

    python3 packaging/bootstrap.py package [--check] [wheel|frozen|deb|windows ...]

The files are in `dist/`. Each kind of package is a row of `TARGETS`. A check installs and removes
the package, and uses its programs as a user does.
"""

import argparse
import gzip
import hashlib
import io
import os
import platform
import re
import shutil
import subprocess
import sys
import tarfile
import time
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from email.utils import formatdate
from functools import cache, partial
from importlib.metadata import Distribution, PackageNotFoundError, distribution
from itertools import product
from pathlib import Path

from bootstrap import CONSTRAINTS, ROOT, BootstrapError, find_debian, say
from checks import (
    TIMEOUT_S,
    TOUR_TIMEOUT_S,
    SimulatedBoard,
    Steps,
    check_board,
    require,
    require_gone,
    simulated_board,
    wait_until,
)
from windows.package import build_installer, check_installer, freeze_in_wine
from windows.wine import PROGRAMS as WINE_PROGRAMS
from windows.wine import Windows, Wine

DIST = ROOT / "dist"
BUILD = ROOT / "build" / "packages"
HERE = ROOT / "packaging"
FROZEN = BUILD / "frozen" / "trex-studio"
WINE_PREFIX = BUILD / "wine"
PROGRAMS = ("trex-gui", "trexcmd", "trex-sim")
CHECKSUMS = "SHA256SUMS"
METADATA = "local.trexstudio.TReXStudio.metainfo.xml"
EXTRAS = "[gui,gamepad,mcap,remote]"
MAX_MB, MAX_PACKAGES = 15, 6  # limits of an installation without the window
EXAMPLES = {
    "drive": ("40",),
    "explain": (),
    "list_parameters": (),
    "log_currents": ("1",),
    "read_status": (),
    "recover": (),
    "set_parameters": (),
    "wait_for_line": (),
}
"""Examples that need no user input and no file → arguments after the port."""
SYSTEM_PATH = "/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin"

Command = Sequence[str | Path]


def version() -> str:
    """Return the version of the program, read from `trex_gui/version.py`."""
    text = (ROOT / "trex_gui" / "version.py").read_text(encoding="utf-8")
    found = re.search(r'^__version__ = "([^"]+)"$', text, re.MULTILINE)
    if found is None:
        raise BootstrapError("trex_gui/version.py has no __version__.")
    return found[1]


def release_time() -> int:
    """Return the timestamp of packaged files, in seconds since 1970.

    The source is `SOURCE_DATE_EPOCH`, else the last commit, else `pyproject.toml`.
    """
    if given := os.environ.get("SOURCE_DATE_EPOCH"):
        return int(given)
    git = ["git", "-C", str(ROOT), "log", "-1", "--format=%ct"]
    process = subprocess.run(git, capture_output=True, text=True, check=False)
    if process.returncode == 0:
        return int(process.stdout)
    return int((ROOT / "pyproject.toml").stat().st_mtime)


def run(
    command: Command,
    env: Mapping[str, str] | None = None,
    timeout: float | None = None,
    cwd: Path = ROOT,
) -> str:
    """Run a command and return its standard output.

    Raises:
        BootstrapError: the command failed or timed out. Contains the last lines of its output.
    """
    words = [str(word) for word in command]
    try:
        process = subprocess.run(
            words,
            env=env,
            cwd=cwd,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            errors="replace",
            timeout=timeout,
            check=False,
        )
    except subprocess.TimeoutExpired as error:
        raise BootstrapError(f"{' '.join(words)}: did not end within {timeout:.0f} s") from error
    if process.returncode != 0:
        lines = [*process.stdout.splitlines()[-8:], *process.stderr.splitlines()[-12:]]
        raise BootstrapError("\n".join([f"{' '.join(words)}: status {process.returncode}", *lines]))
    return process.stdout


def require_programs(packages: Mapping[str, str]) -> None:
    """Install the Debian packages of missing programs, if possible.

    Args:
        packages: name of each program → Debian package that contains it.

    Raises:
        BootstrapError: a program is still missing.
    """
    debian = find_debian()
    missing = [package for name, package in packages.items() if shutil.which(name) is None]
    if debian and missing:
        debian.install_missing(missing)
    if still_missing := [name for name in packages if shutil.which(name) is None]:
        raise BootstrapError(f"Install these missing programs: {', '.join(still_missing)}")


# --- Wheel and sdist ---------------------------------------------------------------------------


@cache
def build_wheel() -> list[Path]:
    """Build the wheel and the sdist, in this order. Runs only once."""
    run([sys.executable, "-m", "hatchling", "build", "--directory", DIST])
    return [
        DIST / f"trex_gui-{version()}-py3-none-any.whl",
        DIST / f"trex_gui-{version()}.tar.gz",
    ]


def find_pythons() -> dict[str, Path]:
    """Return an interpreter for each Python from 3.11 on.

    The keys are versions such as "3.11". The values are the current interpreter, and others in
    the search path and in pyenv.
    """
    pyenv = Path(os.environ.get("PYENV_ROOT") or Path.home() / ".pyenv")
    found = {f"3.{sys.version_info.minor}": Path(sys.executable)}
    folders = [*map(Path, os.get_exec_path()), *sorted(pyenv.glob("versions/*/bin"))]
    for path in (path for folder in folders for path in sorted(folder.glob("python3.*"))):
        name = re.fullmatch(r"python(3\.(\d+))", path.name)
        if name and int(name[2]) >= 11 and name[1] not in found:
            command = [str(path), "-c", "import sys, venv; print(sys.executable)"]
            process = subprocess.run(command, capture_output=True, text=True, check=False)
            if process.returncode == 0:  # a shim of pyenv fails if its version is not active
                found[name[1]] = Path(process.stdout.strip())
    return found


def check_wheel(files: Sequence[Path], steps: Steps) -> None:
    """Use each file with every Python, installed by pip.

    The environments are outside the source tree.
    """
    for file, (number, python) in product(files, find_pythons().items()):
        kind = "wheel" if file.suffix == ".whl" else "sdist"
        for extras in ("", EXTRAS) if kind == "wheel" else (EXTRAS,):
            title = f"{kind}, Python {number}{'' if extras else ', no window'}"
            with steps.group(title) as folder:
                environment = folder / "venv"
                installed = Installed(environment / "bin", folder)
                pip: Command = [environment / "bin/pip", "--disable-pip-version-check", "-q"]
                with steps.required("install"):
                    run([python, "-m", "venv", environment], installed.environment)
                    run([*pip, "install", f"{file}{extras}"], installed.environment)
                if extras:
                    check_programs(installed, steps)
                else:
                    check_without_window(installed, environment, steps)
                with steps.step("remove"):
                    run([*pip, "uninstall", "--yes", "trex-gui"], installed.environment)
                    require_gone(installed.programs)
                    require_gone(environment.glob("lib/*/site-packages/trex_gui*"))


# --- The frozen application --------------------------------------------------------------------


def build_frozen() -> list[Path]:
    """Build the frozen folder, and an archive of it."""
    freeze()
    file = DIST / f"trex-studio-{version()}-{sys.platform}-{platform.machine()}.tar.gz"
    pack(FROZEN, file)
    return [file]


@cache
def freeze(folder: Path = FROZEN) -> None:
    """Build the folder of the three programs with PyInstaller. Runs only once."""
    constraints: Command = ["--constraint", CONSTRAINTS]
    run([sys.executable, "-m", "pip", "install", "-q", *constraints, "pyinstaller"])
    if sys.platform == "linux":
        require_programs({"objdump": "binutils"})
        if (debian := find_debian()) and sys.base_prefix == "/usr":
            # The package of Python does not contain the library.
            debian.install_missing([f"libpython3.{sys.version_info.minor}"])
    spec = HERE / "frozen" / "trex-studio.spec"
    folders: Command = ["--distpath", folder.parent, "--workpath", folder.parent.parent / "work"]
    # A fixed hash seed and timestamp make the result reproducible.
    fixed = {"PYTHONHASHSEED": "1", "SOURCE_DATE_EPOCH": str(release_time())}
    say("Freezing the program. This takes half a minute.")
    pyinstaller: Command = [sys.executable, "-m", "PyInstaller", "--noconfirm", "--log-level=WARN"]
    run([*pyinstaller, *folders, spec], {**os.environ, **fixed})
    if sys.platform == "linux":
        remove_debug_symbols(folder / "_internal")
    copy_licences(folder)
    size = sum(path.lstat().st_size for path in folder.rglob("*"))
    say(f"The folder has {size / 1e6:.0f} MB.")


def remove_debug_symbols(folder: Path) -> None:
    """Remove debug symbols from bundled libraries, about 30 MB."""
    files = [
        *folder.glob("libpython*"),
        *folder.glob("python3*/lib-dynload/*.so"),
        *(
            file
            for name in ("lz4", "pygame", "zstandard")
            for file in folder.glob(f"{name}/**/*.so")
        ),
    ]
    run(["strip", "--strip-unneeded", *files])


def bundled_distributions() -> list[Distribution]:
    """Return the bundled Python packages, sorted by name."""
    found: dict[str, Distribution] = {}
    queue = ["trex-gui"]
    while queue:
        try:
            package = distribution(queue.pop())
        except PackageNotFoundError:  # required only on other systems or Pythons
            continue
        name = package.metadata["Name"]
        if name in found:
            continue
        found[name] = package
        for line in package.requires or []:
            requirement, _, marker = line.partition(";")
            if "extra" not in marker or (name == "trex-gui" and "test" not in marker):
                required = re.match(r"[\w.-]+", requirement)
                if required and (required[0] != "colorama" or sys.platform == "win32"):
                    queue.append(required[0])
    return [found[name] for name in sorted(found, key=str.lower) if name != "trex-gui"]


WITHOUT_LICENCE = {
    "mcap": "mcap.txt",
    "pyserial": "pyserial.txt",
    "pygame-ce": "LGPL-2.1.txt",
    "PySide6_Essentials": "LGPL-3.txt",
    "shiboken6": "LGPL-3.txt",
}
"""Packages that contain no licence text → file in `licences/` with the text."""


def licence_texts(package: Distribution) -> str:
    """Return the licence texts that a package contains. Empty if it contains none."""
    names = re.compile(r"(LICEN[CS]E|COPYING|NOTICE)[^/]*", re.IGNORECASE)
    files = [file for file in package.files or [] if names.fullmatch(file.name)]
    in_metadata = [file for file in files if ".dist-info" in str(file)]
    return "\n\n".join(file.read_text(encoding="utf-8") for file in in_metadata)


def copy_licences(folder: Path) -> None:
    """Copy the licences of all bundled software to `licences/`.

    Raises:
        BootstrapError: the licence of a package is not known.
    """
    licences = folder / "licences"
    shutil.copytree(HERE / "licences", licences)
    shutil.copy(ROOT / "LICENSE", licences / "TReX-Studio.txt")
    versions = [f"Python {platform.python_version()}"]
    for package in bundled_distributions():
        name = package.metadata["Name"]
        versions.append(f"{name} {package.version}")
        if text := licence_texts(package):
            (licences / f"{name}.txt").write_text(text, encoding="utf-8")
        elif name not in WITHOUT_LICENCE:
            raise BootstrapError(f"{name} contains no licence text. Add it to packaging/licences.")
    loader = distribution("pyinstaller")
    (licences / "PyInstaller.txt").write_text(licence_texts(loader), encoding="utf-8")
    (licences / "versions.txt").write_text("\n".join(versions) + "\n", encoding="utf-8")
    standard = Path(os.__file__).parent
    texts = [
        path
        for folder_of_text in (standard, *standard.parents[:2])  # its place depends on the system
        if (path := folder_of_text / "LICENSE.txt").exists()
    ]
    debian = Path(f"/usr/share/doc/python3.{sys.version_info.minor}/copyright")
    shutil.copy([*texts, debian][0], licences / "Python.txt")
    if sys.platform == "linux":
        for package_name in set(debian_libraries(folder).values()):
            text_file = Path(f"/usr/share/doc/{package_name}/copyright")
            shutil.copy(text_file, licences / f"Debian-{package_name}.txt")


def pack(folder: Path, file: Path) -> None:
    """Write an archive of a folder. Folders of equal content give identical archives."""
    timestamp = release_time()

    def normalized(member: tarfile.TarInfo) -> tarfile.TarInfo:
        member.uid = member.gid = 0
        member.uname = member.gname = "root"
        member.mtime = timestamp
        return member

    with (
        file.open("wb") as raw,
        gzip.GzipFile("", "wb", 6, raw, timestamp) as packed,
        tarfile.open(fileobj=packed, mode="w") as archive,
    ):
        archive.add(folder, f"{folder.name}-{version()}", filter=normalized)


def check_frozen(files: Sequence[Path], steps: Steps) -> None:
    """Unpack the archive in another folder, and use it."""
    for file in files:
        with steps.group("frozen") as folder:
            target = create_folder(folder / "programs")
            installed = Installed(target / f"{FROZEN.name}-{version()}", folder)
            with steps.required("unpack"):
                run(["tar", "-C", target, "-xf", file])
            check_programs(installed, steps)
            with steps.step("remove"):
                shutil.rmtree(target)


# --- The Debian package ------------------------------------------------------------------------


def debian_packages(libraries: Iterable[str]) -> dict[str, str]:
    """Return the Debian packages of libraries, by file name.

    Libraries that Debian does not provide are absent.
    """
    if shutil.which("dpkg-query") is None:
        return {}
    patterns = [f"{folder}/*/{name}" for name in libraries for folder in ("/lib", "/usr/lib")]
    search = ["dpkg-query", "--search", *patterns]
    # The status is 1 if Debian does not provide one of the libraries.
    process = subprocess.run(search, capture_output=True, text=True, check=False)
    found = (line.rpartition(": ") for line in process.stdout.splitlines())
    in_folder = re.compile(r"(/usr)?/lib/[^/]+/([^/]+)")
    return {
        match[2]: packages.partition(":")[0]
        for packages, _, path in found
        if (match := in_folder.fullmatch(path))
    }


def debian_libraries(folder: Path) -> dict[str, str]:
    """Return the Debian packages of bundled libraries, by file name."""
    names = {path.name for path in (folder / "_internal").glob("lib*.so*") if not path.is_symlink()}
    return debian_packages(name for name in names if not name.startswith("libpython"))


def needed_packages(folder: Path) -> list[str]:
    """Return the Debian packages of required libraries that are not bundled."""
    libraries = list(folder.rglob("*.so*"))
    needed: set[str] = set()
    for path in [*libraries, *(folder / name for name in PROGRAMS)]:
        if not path.is_symlink():
            headers = run(["objdump", "-p", path])
            needed.update(re.findall(r"^\s+NEEDED\s+(\S+)$", headers, re.MULTILINE))
    return sorted(set(debian_packages(needed - {path.name for path in libraries}).values()))


def command_help(*words: str) -> str:
    """Return the help of a command, 80 columns wide.

    Args:
        words: name of the program, and of its subcommand.
    """
    program = Path(sys.executable).with_name(words[0])
    return run(
        [program, *words[1:], "--help"], {**os.environ, "COLUMNS": "80", "LC_ALL": "C.UTF-8"}
    )


SUMMARIES = {
    "trex-gui": "set up, calibrate and drive a Pololu TReX motor controller",
    "trexcmd": "inspect, set up and drive a Pololu TReX from the shell",
    "trex-sim": "simulate a Pololu TReX on a pseudo-terminal or a TCP port",
}


def manual_page(program: str) -> str:
    """Return the manual page of a program. It contains its help."""
    commands = [""]
    text = command_help(program)
    if "\nCommands:\n" in text:
        commands += re.findall(r"^  ([\w-]+)  ", text.partition("\nCommands:\n")[2], re.MULTILINE)
    date = time.strftime("%Y-%m-%d", time.gmtime(release_time()))
    others = ", ".join(f".BR {roff(name)} (1)" for name in PROGRAMS if name != program)
    lines = [
        f'.TH {program.upper()} 1 "{date}" "TReX Studio {version()}" "User Commands"',
        ".SH NAME",
        rf"{roff(program)} \- {SUMMARIES[program]}",
    ]
    for command in commands:
        words = [program, command] if command else [program]
        title = " ".join(words).upper() if command else "DESCRIPTION"
        lines += [f'.SH "{title}"', ".nf", roff(command_help(*words).strip()), ".fi"]
    lines += [".SH SEE ALSO", *others.replace(", ", ",\n").splitlines()]
    return "\n".join(lines) + "\n"


def roff(text: str) -> str:
    """Return a text with special characters escaped for roff."""
    text = text.replace("\\", r"\e").replace("-", r"\-")
    return re.sub(r"^(?=[.'])", r"\\&", text, flags=re.MULTILINE)


def write(path: Path, text: str | bytes) -> None:
    """Write a file of a package. The suffix `.gz` compresses it."""
    create_folder(path.parent)
    data = text.encode() if isinstance(text, str) else text
    if path.suffix == ".gz":
        packed = io.BytesIO()
        with gzip.GzipFile("", "wb", 9, packed, release_time()) as file:
            file.write(data)
        data = packed.getvalue()
    path.write_bytes(data)


def create_folder(folder: Path) -> Path:
    """Create a folder with its parents, and return it."""
    folder.mkdir(parents=True, exist_ok=True)
    return folder


def linux_file(name: str) -> str:
    """Return a file of `linux/` with version and date filled in."""
    date = time.strftime("%Y-%m-%d", time.gmtime(release_time()))
    text = (HERE / "linux" / name).read_text(encoding="utf-8")
    return text.replace("@VERSION@", version()).replace("@DATE@", date)


def create_debian_tree(tree: Path) -> None:
    """Create the file tree that the Debian package installs."""
    shutil.copytree(FROZEN, tree / "usr/lib/trex-studio", symlinks=True)
    program_folder = tree / "usr/lib/trex-studio"
    for name in debian_libraries(program_folder):
        (program_folder / "_internal" / name).unlink()
    for path in program_folder.glob("licences/Debian-*"):
        path.unlink()  # licence of a removed library
    for name in PROGRAMS:
        create_folder(tree / "usr/bin").joinpath(name).symlink_to(f"../lib/trex-studio/{name}")
        write(tree / f"usr/share/man/man1/{name}.1.gz", manual_page(name))
    share = tree / "usr/share"
    write(share / "applications/trex-studio.desktop", linux_file("trex-studio.desktop"))
    write(share / "metainfo" / METADATA, linux_file(METADATA))
    icon = (ROOT / "resources/icons/trex-studio.svg").read_bytes()
    write(share / "icons/hicolor/scalable/apps/trex-studio.svg", icon)
    write(tree / "lib/udev/rules.d/60-trex-studio.rules", linux_file("60-trex-studio.rules"))
    unit = (ROOT / "resources/serve/trex-serve.service").read_text(encoding="utf-8")
    unit = unit.replace("@COMMAND@", "/usr/bin/trexcmd")
    write(tree / "usr/lib/systemd/system/trex-serve.service", unit)
    rule = (ROOT / "resources/serve/60-trex-serve.rules").read_bytes()
    write(tree / "lib/udev/rules.d/60-trex-serve.rules", rule)
    write(share / "lintian/overrides/trex-studio", linux_file("lintian-overrides"))
    documents = share / "doc/trex-studio"
    write(documents / "copyright", linux_file("copyright"))
    write(documents / "changelog.gz", (ROOT / "CHANGELOG.md").read_bytes())
    maintainer = re.search(r"^Maintainer: (.+)$", linux_file("control"), re.MULTILINE)
    entry = f"trex-studio ({version()}-1) unstable; urgency=medium\n\n  * See changelog.gz.\n\n"
    entry += f" -- {maintainer[1] if maintainer else ''}  {formatdate(release_time())}\n"
    write(documents / "changelog.Debian.gz", entry)


def build_deb() -> list[Path]:
    """Build the Debian package from the frozen folder.

    Depends on Debian's packages instead of containing the libraries that Debian provides.
    """
    require_programs({"dpkg-deb": "dpkg", "objdump": "binutils"})
    freeze()
    tree = BUILD / "deb"
    shutil.rmtree(tree, ignore_errors=True)
    create_debian_tree(tree)
    files = [path for path in tree.rglob("*") if path.is_file() and not path.is_symlink()]
    for path in tree.rglob("*"):
        if not path.is_symlink():
            program = path.parent.name == "trex-studio" and path.name in PROGRAMS
            path.chmod(0o755 if path.is_dir() or program else 0o644)
    architecture = run(["dpkg", "--print-architecture"]).strip()
    control = linux_file("control").replace("@ARCHITECTURE@", architecture)
    control = control.replace("@SIZE@", str(sum(path.stat().st_size for path in files) // 1024))
    depends = ", ".join(needed_packages(tree / "usr/lib/trex-studio"))
    write(tree / "DEBIAN/control", control.replace("@DEPENDS@", depends))
    sums = [
        f"{hashlib.md5(path.read_bytes(), usedforsecurity=False).hexdigest()}  {name}\n"
        for name, path in sorted((str(path.relative_to(tree)), path) for path in files)
    ]
    write(tree / "DEBIAN/md5sums", "".join(sums))
    write(tree / "DEBIAN/postinst", linux_file("postinst"))
    (tree / "DEBIAN/postinst").chmod(0o755)
    file = DIST / f"trex-studio_{version()}-1_{architecture}.deb"
    fixed = {"SOURCE_DATE_EPOCH": str(release_time())}
    say("Packing the Debian package.")
    run(
        ["dpkg-deb", "--root-owner-group", "-Zxz", "-z3", "--build", tree, file],
        {**os.environ, **fixed},
    )
    return [file]


CHROOT = """
mount -t proc proc "$0/proc" && mount --bind /dev "$0/dev" && mount --bind /dev/pts "$0/dev/pts" &&
exec chroot "$0" "$@"
"""
"""Shell script that runs a command in the root folder $0.

`unshare --mount` runs the script in its own namespace. The mounts end with the command.
"""


def check_deb(files: Sequence[Path], steps: Steps) -> None:
    """Validate the package, and use it in a minimal Debian.

    Raises:
        BootstrapError: the system is not Debian, or the user is not root.
    """
    require_programs(
        {
            "lintian": "lintian",
            "desktop-file-validate": "desktop-file-utils",
            "appstreamcli": "appstream",
            "debootstrap": "debootstrap",
            "man": "man-db",
        }
    )
    system = Path("/etc/os-release").read_text(encoding="utf-8")
    release = re.search(r"^VERSION_CODENAME=(\S+)$", system, re.MULTILINE)
    if os.geteuid() != 0 or release is None:
        raise BootstrapError("Run this check as root on Debian: it creates a minimal Debian.")
    for file in files:
        with steps.group("deb") as folder:
            tree, root = BUILD / "deb", folder / "root"
            desktop_file = tree / "usr/share/applications/trex-studio.desktop"
            with steps.step("lintian"):
                run(["lintian", "--fail-on=error,warning", "--allow-root", file])
            with steps.step("desktop-file-validate"):
                run(["desktop-file-validate", desktop_file])
            with steps.step("appstreamcli"):
                run(["appstreamcli", "validate-tree", "--no-net", tree])
            with steps.required("create a minimal Debian"):
                run(["debootstrap", "--variant=minbase", release[1], root])
            prefix = ("unshare", "--mount", "sh", "-c", CHROOT, str(root))
            installed = Installed(root / "usr/bin", root / "root", root, prefix)
            environment = {**installed.environment, "DEBIAN_FRONTEND": "noninteractive"}
            apt = [*prefix, "apt-get", "--quiet", "--yes", "--no-install-recommends"]
            with steps.required("install"):
                shutil.copy(file, root)
                run([*apt, "install", f"/{file.name}"], environment)
            check_programs(installed, steps)
            with steps.step("remove"):
                run([*apt, "purge", "trex-studio"], environment)
                files_and_own_folders = (
                    path.relative_to(tree)
                    for path in tree.rglob("*")
                    if path.name == "trex-studio" or not path.is_dir()
                )
                require_gone(
                    root / path for path in files_and_own_folders if path.parts[0] != "DEBIAN"
                )


# --- The installer for Windows -----------------------------------------------------------------


def build_windows() -> list[Path]:
    """Build the installer. The program is frozen on Windows, or under Wine."""
    frozen = FROZEN
    if sys.platform == "win32":
        freeze()
    else:
        require_programs(WINE_PROGRAMS)
        frozen = BUILD / "windows" / "frozen" / FROZEN.name
        say("Freezing the program for Windows under Wine. This takes some minutes.")
        freeze_in_wine(Wine(WINE_PREFIX), build_wheel()[0], frozen, release_time())
    file = DIST / f"trex-studio-{version()}-windows-x64.exe"
    build_installer(frozen, version(), file)
    return [file]


def check_windows(files: Sequence[Path], steps: Steps) -> None:
    """Check the installer on Windows or under Wine."""
    windows = Windows() if sys.platform == "win32" else Wine(WINE_PREFIX)
    for file in files:
        check_installer(file, version(), windows, steps)


# --- What a user does --------------------------------------------------------------------------


@dataclass(frozen=True)
class Installed:
    """Installed programs and how to run them.

    Attributes:
        folder: contains the programs.
        home: home folder of the programs, initially empty.
        root: root folder of the programs, below which all their files are.
        prefix: start of a command that runs in `root`.
    """

    folder: Path
    home: Path
    root: Path = Path("/")
    prefix: tuple[str, ...] = ()

    @property
    def environment(self) -> dict[str, str]:
        """Environment of the programs. Contains no variable of the current process."""
        return {
            "HOME": self.path_inside(self.home),
            "LANG": "C.UTF-8",
            "PATH": SYSTEM_PATH,
            "QT_QPA_PLATFORM": "offscreen",
        }

    def path_inside(self, path: Path) -> str:
        return str(Path("/") / path.relative_to(self.root))

    @property
    def programs(self) -> list[Path]:
        return [self.folder / name for name in PROGRAMS]

    def command(self, program: str, *arguments: str | Path) -> list[str]:
        """Return the command that runs a program.

        Paths among the arguments are converted to paths below `root`.
        """
        words = [self.folder / program, *arguments]
        return [
            *self.prefix,
            *(self.path_inside(word) if isinstance(word, Path) else word for word in words),
        ]

    def run(
        self, program: str, *arguments: str | Path, port: str = "", timeout: float = TIMEOUT_S
    ) -> str:
        environment = {**self.environment, "TREX_PORT": port} if port else self.environment
        return run(self.command(program, *arguments), environment, timeout, cwd=self.home)

    @contextmanager
    def start(self, program: str, *arguments: str | Path) -> Iterator["subprocess.Popen[bytes]"]:
        """Run a program during the block, then kill it."""
        pipe = subprocess.PIPE
        with subprocess.Popen(
            self.command(program, *arguments),
            env=self.environment,
            stdin=pipe,
            stdout=pipe,
            stderr=subprocess.DEVNULL,
        ) as process:
            try:
                yield process
            finally:
                process.kill()


@contextmanager
def simulator(installed: Installed, *arguments: str) -> Iterator[tuple[str, SimulatedBoard]]:
    """Run `trex-sim`, and yield its port and board."""
    with installed.start("trex-sim", *arguments) as process:
        yield simulated_board(process)


def check_programs(installed: Installed, steps: Steps) -> None:
    """Use every program with the simulated board."""
    check_command_line(installed, steps)
    with steps.step("demonstration in the window"):
        pictures = installed.home / "pictures"
        installed.run("trex-gui", "--tour", pictures, timeout=TOUR_TIMEOUT_S)
        names = {path.name for path in pictures.glob("*.png")}
        require({"motors-light.png", "aracnaRobot-dark.png"} <= names, f"only {sorted(names)}")
    with steps.step("a stop in the window is recorded"):
        recordings = [path.read_bytes() for path in installed.home.rglob("*_stop.trexrec")]
        require(recordings, "there is no recording")
        for recording in recordings:
            require(recording.startswith(b"SQLite format 3"), "a recording is not a database")
    with steps.step("the window is killed: the motors stop"):
        kill_window(installed, installed.home / "other_pictures")


def check_command_line(installed: Installed, steps: Steps) -> None:
    """Use the command line with the simulated board."""
    with steps.step("versions and help"):
        for program in PROGRAMS:
            require(
                version() in installed.run(program, "--version"), f"{program} has another version"
            )
            installed.run(program, "--help")
    with steps.step("use the simulated board"), simulator(installed) as (port, board):
        check_board(partial(installed.run, "trexcmd", port=port), installed.home, steps, board)
        with steps.step("trexcmd is killed: the motors stop"):
            kill_command(installed, port, board)
    for name, option in (("TCP", "--tcp"), ("RFC 2217", "--rfc2217")):
        with (
            steps.step(f"connect over {name}"),
            simulator(installed, option, "127.0.0.1:0") as (port, _),
        ):
            require("TReX" in installed.run("trexcmd", "status", port=port), "no TReX found")


def check_without_window(installed: Installed, environment: Path, steps: Steps) -> None:
    """Use an installation without the window, as on a robot."""
    (packages,) = environment.glob("lib/*/site-packages")
    with steps.step("size"):
        top = [path for path in packages.iterdir() if not path.name.startswith(("pip", "setup"))]
        files = [file for path in top for file in (path, *path.rglob("*")) if file.is_file()]
        size = sum(file.stat().st_size for file in files if file.suffix != ".pyc") / 1e6
        count = sum(path.suffix == ".dist-info" for path in top) - 1
        say(f"  {size:.1f} MB without compiled files, and {count} packages besides ours")
        is_small = size <= MAX_MB and count <= MAX_PACKAGES
        require(is_small, f"more than {MAX_MB} MB, or more than {MAX_PACKAGES} packages")
    with steps.step("trex-gui names the missing extra"):
        process = subprocess.run(
            installed.command("trex-gui"),
            env=installed.environment,
            capture_output=True,
            text=True,
            timeout=TIMEOUT_S,
            check=False,
        )
        require(process.returncode and "trex-gui[gui]" in process.stderr, process.stderr)
    check_command_line(installed, steps)
    with steps.step("survey"), simulator(installed) as (port, _):
        installed.run("trexcmd", "survey", installed.home / "survey.txt", port=port)
    examples = packages / "trex_gui/_resources/examples"
    for name, words in EXAMPLES.items():
        with steps.step(f"example {name}"), simulator(installed) as (port, _):
            example: Command = [environment / "bin/python", examples / f"{name}.py", port, *words]
            run(example, installed.environment)


def kill_command(installed: Installed, port: str, board: SimulatedBoard) -> None:
    """Require that the motor stops after `trexcmd` is killed."""
    with installed.start("trexcmd", "motor", "--port", port, "1", "40") as process:
        wait_until(lambda: not board.is_at_rest, "motor 1 did not run")
        process.kill()
        wait_until(lambda: board.is_at_rest, "motor 1 was not stopped")


def kill_window(installed: Installed, pictures: Path) -> None:
    """Require that motors stop after the window is killed.

    The simulator ends when its pipes are closed. This function holds its pipes open.
    """
    log_before = guardian_log(installed)
    with installed.start("trex-gui", "--tour", pictures) as window:
        wait_until(lambda: list(pictures.glob("*.png")), "no picture was written", TOUR_TIMEOUT_S)
        found = [pid for pid in child_processes(window.pid) if "simulator" in command_line(pid)]
        require(found, "the window has not started a simulator")
        files = Path("/proc") / str(found[0]) / "fd"
        with (files / "0").open("wb") as writing, (files / "1").open("rb") as reading:
            window.kill()
            board = SimulatedBoard(writing, reading)
            wait_until(lambda: board.is_at_rest, "the motors were not stopped")
            wait_until(
                lambda: " confirmed:" in guardian_log(installed).removeprefix(log_before),
                "the guardian did not confirm a stop",
            )


def guardian_log(installed: Installed) -> str:
    """Return the logs of all guardian processes. Their lines name the stopped motors."""
    return "".join(path.read_text() for path in installed.home.rglob("guardian.log"))


def child_processes(parent: int) -> list[int]:
    """Return the IDs of the child processes of a process."""
    task = Path(f"/proc/{parent}/task")
    return [int(word) for path in task.glob("*/children") for word in path.read_text().split()]


def command_line(pid: int) -> str:
    return Path(f"/proc/{pid}/cmdline").read_bytes().replace(b"\0", b" ").decode()


# --- The command -------------------------------------------------------------------------------


@dataclass(frozen=True)
class Target:
    """Kind of package.

    Attributes:
        build: builds the files in `dist/` and returns their paths.
        check: installs, uses and removes the files, step by step.
        system: systems that can build the files, by the start of `sys.platform`.
        checked_on: systems that can check the files, in the same form.
        is_default: returns whether to build the files if the user names no kind.
    """

    build: Callable[[], list[Path]]
    check: Callable[[Sequence[Path], Steps], None]
    system: str | tuple[str, ...] = ""
    checked_on: str | tuple[str, ...] = "linux"
    is_default: Callable[[], object] = lambda: True


TARGETS = {
    "wheel": Target(build_wheel, check_wheel),
    "frozen": Target(build_frozen, check_frozen),
    "deb": Target(build_deb, check_deb, "linux", is_default=find_debian),
    "windows": Target(
        build_windows,
        check_windows,
        ("linux", "win32"),
        ("linux", "win32"),
        lambda: sys.platform == "win32",  # on Linux the build installs Wine
    ),
}


def write_checksums() -> None:
    """Write the SHA-256 sums of this version's files."""
    files = sorted(path for path in DIST.iterdir() if version() in path.name)
    lines = [f"{hashlib.sha256(path.read_bytes()).hexdigest()}  {path.name}\n" for path in files]
    (DIST / CHECKSUMS).write_text("".join(lines), encoding="ascii")


def main(arguments: Sequence[str] | None = None) -> int:
    """Build the packages and return the exit status."""
    parser = argparse.ArgumentParser(description="Build the packages for users in dist/.")
    parser.add_argument("--check", action="store_true", help="use them as a user does")
    parser.add_argument(
        "targets", nargs="*", metavar="|".join(TARGETS), help="default: all of this system"
    )
    options = parser.parse_args(arguments)
    if unknown := set(options.targets) - TARGETS.keys():
        parser.error(f"no such package: {', '.join(sorted(unknown))}")
    here = [name for name, target in TARGETS.items() if sys.platform.startswith(target.system)]
    if foreign := set(options.targets) - set(here):
        parser.error(f"cannot be built on this system: {', '.join(sorted(foreign))}")
    wanted = options.targets or [name for name in here if TARGETS[name].is_default()]
    DIST.mkdir(exist_ok=True)
    steps, built = Steps(), dict[str, list[Path]]()
    for name in here:
        if name in wanted:
            with steps.step(f"build {name}"):
                built[name] = TARGETS[name].build()
    write_checksums()
    for file in [file for files in built.values() for file in files]:
        say(f"{file.relative_to(ROOT)}: {file.stat().st_size / 1e6:.1f} MB")
    for name, files in built.items() if options.check else ():
        if sys.platform.startswith(TARGETS[name].checked_on):
            with steps.step(f"check {name}"):
                TARGETS[name].check(files, steps)
        else:
            say(f"{name} cannot be checked on this system.")
    if steps.failed:
        say("\nFailed:\n" + "\n".join(f"  {name}" for name in steps.failed))
    return 1 if steps.failed else 0


if __name__ == "__main__":
    sys.exit(main())
