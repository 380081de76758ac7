"""Resource files of the program."""

import pytest

from trex_gui.core.resource_files import resource


def test_path_is_absolute_in_any_current_folder(
    monkeypatch: pytest.MonkeyPatch, tmp_path_factory: pytest.TempPathFactory
) -> None:
    monkeypatch.chdir(tmp_path_factory.mktemp("elsewhere"))
    assert resource("trex_parameters.toml").is_absolute()
    assert resource("trex_parameters.toml").is_file()


@pytest.mark.parametrize("name", ["missing.toml", "icons/no_such_icon.svg"])
def test_missing_file_error_names_file_and_remedy(name: str) -> None:
    with pytest.raises(FileNotFoundError, match=f"{name} is missing from .*install"):
        resource(name)
