"""Create a disk image for macOS from PyInstaller's bundle.

    python3 packaging/bootstrap.py package frozen
    .venv/bin/python packaging/macos/make_dmg.py

Never run, because it needs macOS. The icon and `Info.plist` were written and read back on Linux.
The bundle has only the ad-hoc signature of PyInstaller. Without a developer certificate and
notarisation, macOS warns before the first start.
"""

import platform
import shutil
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path.insert(0, str(HERE.parent))

from packages import version  # noqa: E402

BUNDLE = ROOT / "build" / "packages" / "frozen" / "TReX Studio.app"


def main() -> None:
    program = BUNDLE / "Contents" / "MacOS" / "trex-gui"
    process = subprocess.run([program, "--version"], capture_output=True, text=True, check=True)
    if version() not in process.stdout:
        sys.exit(f"The version of the bundle is {process.stdout!r} instead of {version()}.")
    content = ROOT / "build" / "packages" / "dmg"
    shutil.rmtree(content, ignore_errors=True)
    shutil.copytree(BUNDLE, content / BUNDLE.name, symlinks=True)
    (content / "Applications").symlink_to("/Applications")
    shutil.copytree(BUNDLE.with_name("trex-studio") / "licences", content / "Licences")
    (ROOT / "dist").mkdir(exist_ok=True)
    file = ROOT / "dist" / f"trex-studio-{version()}-macos-{platform.machine()}.dmg"
    hdiutil = ["hdiutil", "create", "-volname", "TReX Studio", "-fs", "HFS+", "-format", "UDZO"]
    subprocess.run([*hdiutil, "-ov", "-srcfolder", content, file], check=True)


if __name__ == "__main__":
    main()
