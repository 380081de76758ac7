"""Make an AppImage from the frozen folder.

    python3 packaging/bootstrap.py package frozen
    .venv/bin/python packaging/appimage/make_appimage.py build/packages/frozen/trex-studio

Run on Debian 12: everything up to the AppDir, whose AppRun was started offscreen. Not run:
`appimagetool`, which makes one file of it; no package registry has that program.
"""

import os
import shutil
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path.insert(0, str(HERE.parent))

from icons import write_icon  # noqa: E402
from packages import version  # noqa: E402

APP_RUN = """#!/bin/sh
# Starts the program that the AppImage was called as: trex-gui, or trexcmd or trex-sim by a link.
here=$(dirname "$(readlink -f "$0")")
name=$(basename "${ARGV0:-trex-gui}")
test -x "$here/usr/lib/trex-studio/$name" || name=trex-gui
exec "$here/usr/lib/trex-studio/$name" "$@"
"""


def make_app_dir(frozen: Path, folder: Path) -> None:
    """Make the folder that an AppImage holds."""
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(frozen, folder / "usr" / "lib" / "trex-studio", symlinks=True)
    shutil.copy(HERE.parent / "linux" / "trex-studio.desktop", folder)
    shutil.copy(ROOT / "resources" / "icons" / "trex-studio.svg", folder)
    write_icon(folder / "trex-studio.png", 256)
    (folder / ".DirIcon").symlink_to("trex-studio.png")
    run = folder / "AppRun"
    run.write_text(APP_RUN, encoding="utf-8")
    run.chmod(0o755)


def main() -> None:
    folder = ROOT / "build" / "packages" / "TReX_Studio.AppDir"
    make_app_dir(Path(sys.argv[1]), folder)
    tool = shutil.which("appimagetool")
    if tool is None:
        sys.exit(f"{folder} is ready; appimagetool, which makes one file of it, is not here.")
    (ROOT / "dist").mkdir(exist_ok=True)
    file = ROOT / "dist" / f"TReX_Studio-{version()}-{os.uname().machine}.AppImage"
    subprocess.run([tool, str(folder), str(file)], check=True)


if __name__ == "__main__":
    main()
