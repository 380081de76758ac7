"""Installation of optional Python packages."""

import sys
from pathlib import Path


def install_command(package: str) -> str:
    if (Path(sys.prefix) / "pipx_metadata.json").exists():
        return f"pipx inject trex-gui {package}"
    return f'"{sys.executable}" -m pip install {package}'
