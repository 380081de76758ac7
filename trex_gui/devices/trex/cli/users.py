"""Users of a served board: a text file with a line `NAME ROLE SECRET` per user."""

import secrets
import stat
import sys
from pathlib import Path

from trex_gui.core.errors import BadRequest
from trex_gui.core.files import load, save
from trex_gui.devices.trex.serve.lease import Role, User

ROLES = {"watch": Role.WATCH, "drive": Role.DRIVE, "own": Role.OWN}
_SECRET_BYTES = 24


def read_users(path: Path) -> tuple[User, ...]:
    """Return the users in a file.

    Raises:
        BadRequest: a line is invalid, or other users of this computer can read the file.
        StudioError: the file cannot be read.
    """
    text = load(path).decode("utf-8", "replace")
    if sys.platform != "win32" and path.stat().st_mode & (stat.S_IRWXG | stat.S_IRWXO):
        raise BadRequest(f"Others can read the secrets in {path}: chmod 600 {path}.")
    users: dict[str, User] = {}
    for number, line in enumerate(text.splitlines(), 1):
        words = line.split()
        if not words or line.lstrip().startswith("#"):
            continue
        if len(words) != 3 or words[1] not in ROLES or not _is_user(words[0]) or ":" in words[2]:
            roles = ", ".join(ROLES)
            raise BadRequest(f"{path}: line {number}: expected NAME ROLE SECRET; roles: {roles}.")
        if words[0] in users:
            raise BadRequest(f"{path}: line {number}: {words[0]} is there twice.")
        users[words[0]] = User(words[0], ROLES[words[1]], words[2])
    if not users:
        raise BadRequest(f"{path} has no users.")
    return tuple(users.values())


def add_user(path: Path, name: str, role: str) -> str:
    """Add a user to a file, and return the new secret. A missing file is created.

    Raises:
        StudioError: the name cannot be used, or the file cannot be written.
    """
    if not _is_user(name):
        raise BadRequest(f"A user has a name of letters and digits, not {name!r}.")
    before = load(path).decode("utf-8", "replace") if path.exists() else ""
    if any(line.split()[:1] == [name] for line in before.splitlines()):
        raise BadRequest(f"{path} has a user {name} already.")
    if before and not before.endswith("\n"):
        before += "\n"
    secret = secrets.token_urlsafe(_SECRET_BYTES)
    if not path.exists():
        path.touch(mode=0o600)
    save(path, f"{before}{name} {role} {secret}\n")
    return secret


def _is_user(name: str) -> bool:
    return name.isascii() and name.isalnum() and len(name) <= 40
