import sys
from pathlib import Path

import pytest

from trex_gui.core.optional_packages import install_command


def test_package_is_added_to_the_environment_of_the_program(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("sys.prefix", str(tmp_path))
    assert install_command("mcap") == f'"{sys.executable}" -m pip install mcap'
    (tmp_path / "pipx_metadata.json").touch()
    assert install_command("mcap") == "pipx inject trex-gui mcap"
