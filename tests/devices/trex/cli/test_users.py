"""User files of a served board."""

import sys
from pathlib import Path

import pytest

from trex_gui.core.errors import BadRequest
from trex_gui.devices.trex.cli.serve import add_user, read_users
from trex_gui.devices.trex.serve.lease import Role


@pytest.fixture
def file(tmp_path: Path) -> Path:
    return tmp_path / "users"


def test_added_users_have_roles_and_different_secrets(file: Path) -> None:
    secrets = [add_user(file, "alice", "drive"), add_user(file, "wanda", "watch")]
    users = read_users(file)
    assert [(user.name, user.role) for user in users] == [
        ("alice", Role.DRIVE),
        ("wanda", Role.WATCH),
    ]
    assert [user.secret for user in users] == secrets
    assert secrets[0] != secrets[1]


def test_user_is_added_after_an_unterminated_last_line(file: Path) -> None:
    file.touch(mode=0o600)
    file.write_text("alice drive secret", "utf-8")
    add_user(file, "bob", "own")
    assert [user.name for user in read_users(file)] == ["alice", "bob"]


def test_user_is_not_added_twice(file: Path) -> None:
    add_user(file, "alice", "drive")
    with pytest.raises(BadRequest, match="already has a user alice"):
        add_user(file, "alice", "own")


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has other permissions")
def test_file_readable_by_other_accounts_is_rejected(file: Path) -> None:
    add_user(file, "alice", "drive")
    file.chmod(0o644)
    with pytest.raises(BadRequest, match="chmod 600"):
        read_users(file)


@pytest.mark.parametrize(
    "text", ["alice drive\n", "alice king x\n", "a/b drive x\n", "", "a own x\na own y\n"]
)
def test_file_with_an_invalid_line_is_rejected(file: Path, text: str) -> None:
    file.touch(mode=0o600)
    file.write_text(text, "utf-8")
    with pytest.raises(BadRequest):
        read_users(file)
