"""The serve and robots commands, for boards on the network."""

import ipaddress
import secrets
import socket
import stat
import sys
from pathlib import Path
from typing import Any

import click

from trex_gui.core.cli import (
    CommandFailed,
    Interruption,
    json_option,
    print_json,
    reported_errors,
    say,
)
from trex_gui.core.command_io import FileName
from trex_gui.core.errors import BadRequest
from trex_gui.core.files import load, save
from trex_gui.core.host import host
from trex_gui.core.resource_files import resource
from trex_gui.core.transport.urls import PORT, Address, is_name
from trex_gui.devices.trex.cli.common import boards_option, grouped, link_options, link_settings
from trex_gui.devices.trex.library import Trex
from trex_gui.devices.trex.protocol.descriptions import STOP_UNCONFIRMED
from trex_gui.devices.trex.serve.lease import Role, User
from trex_gui.devices.trex.serve.robots import Robots, require_network

_SERVICE_FILES = (
    ("/etc/udev/rules.d/", "60-trex-serve.rules"),
    ("/etc/systemd/system/", "trex-serve.service"),
)
_INSTALL = """\
Save the two files below (the Debian package contains them). Then run as root:

  useradd --system trex
  install -d -o trex -m 700 /etc/trex
  sudo -u trex {1} serve --users /etc/trex/users --add-user YOU --role own
  udevadm control --reload
  systemctl enable trex-serve
  udevadm trigger

{0}"""
ROLES = {"watch": Role.WATCH, "drive": Role.DRIVE, "own": Role.OWN}
_SECRET_BYTES = 24
_EVERYWHERE = "0.0.0.0"  # noqa: S104 - users are checked


@click.command()
@link_options
@click.option(
    "--name", default="robot", show_default=True, help="Name under which the board is served."
)
@click.option(
    "--listen",
    metavar="HOST:PORT",
    default=None,
    help=f"Address to listen on. Default with --users: port {PORT} on every address. Default "
    f"without --users: port {PORT} on this computer only.",
)
@click.option("--users", "users_file", type=FileName(dir_okay=False), help="File with the users.")
@click.option(
    "--add-user",
    "new_user",
    metavar="NAME",
    help="Add a user to the file, print the secret, and exit.",
)
@click.option(
    "--role",
    type=click.Choice(list(ROLES)),
    default="drive",
    show_default=True,
    help="Role of the new user.",
)
@click.option(
    "--tls",
    nargs=2,
    type=FileName(exists=True, dir_okay=False),
    metavar="CERT KEY",
    help="Encrypt with the certificate and the key in these files.",
)
@boards_option
@click.option("--install", is_flag=True, help="Print how to start the server at boot, and exit.")
def serve(
    name: str,
    *,
    listen: str | None,
    users_file: str | None,
    new_user: str | None,
    role: str,
    tls: tuple[str, str] | None,
    install: bool,
    boards: str,
    **options: Any,
) -> None:
    """Serve the board to TReX Studio, trexcmd and other programs on the network.

    These programs reach the board as trex://HOST/NAME. Only one user drives the board at a time.
    Every user can watch it and stop its motors. This computer stops the motors half a second after
    the last heartbeat of the user who drives.

    Without --users, only programs on this computer can reach the board.
    """
    if install:
        click.echo(_install_text())
        return
    if new_user is not None:
        if users_file is None:
            raise click.UsageError("--add-user needs --users FILE.")
        with reported_errors():
            secret = add_user(Path(users_file), new_user, role)
        say(f"Added {new_user} with the role {role}. Secret for TREX_SECRET or the secrets file:")
        click.echo(secret)
        return
    if not is_name(name):
        raise click.UsageError(
            f"{name!r} is not a valid name: use letters, digits, hyphens, underscores and dots."
        )
    settings = grouped(link_settings(options), boards)
    with reported_errors():
        users = read_users(Path(users_file)) if users_file else ()
        address = Address.of_host(listen or (_EVERYWHERE if users else "127.0.0.1"))
        if not users and not _is_local(address.host):
            raise click.UsageError("Without --users, --listen must be a loopback address.")
        require_network()
        from trex_gui.devices.trex.serve.served_board import ServedBoard  # noqa: PLC0415 - an extra

        board = ServedBoard(
            settings,
            name,
            listen=[address.endpoint(encrypted=tls is not None)],
            users=users,
            computer=host(),
            notify=say,
            tls=(Path(tls[0]), Path(tls[1])) if tls else None,
        )
        public_host = socket.gethostname() if users else address.host
        public_url = Address(public_host, name, "USER" if users else "", address.port).url
        say(f"Serving {settings.label} as {public_url}. Ctrl-C stops the motors and the server.")
        if not users:
            say("Only programs on this computer can reach the board. --users admits network users.")
        elif not tls:
            say("Secrets are checked, but nothing is encrypted without --tls.")
        with Interruption(must_finish=True) as interrupted:
            last = board.run(lambda: bool(interrupted))
    if last.may_move:
        raise CommandFailed(STOP_UNCONFIRMED)


def _is_local(name: str) -> bool:
    if name == "localhost":
        return True
    try:
        return ipaddress.ip_address(name).is_loopback
    except ValueError:
        return False


def _install_text() -> str:
    command = Path(sys.argv[0]).absolute()
    texts = [
        f"# --- {folder}{name}\n{(resource('serve') / name).read_text('utf-8')}"
        for folder, name in _SERVICE_FILES
    ]
    return _INSTALL.format("\n".join(texts), command).replace("@COMMAND@", str(command))


# --- Users: a file with lines NAME ROLE SECRET ------------------------------------------


def read_users(path: Path) -> tuple[User, ...]:
    """Return the users in a file.

    Raises:
        BadRequest: a line is invalid, or other users of this computer can read the file.
        StudioError: the file cannot be read.
    """
    text = load(path).decode("utf-8", "replace")
    if sys.platform != "win32" and path.stat().st_mode & (stat.S_IRWXG | stat.S_IRWXO):
        raise BadRequest(f"Other users can read the secrets in {path}. Run chmod 600 {path}.")
    users: dict[str, User] = {}
    for number, line in enumerate(text.splitlines(), 1):
        words = line.split()
        if not words or line.lstrip().startswith("#"):
            continue
        if len(words) != 3 or words[1] not in ROLES or not _is_user(words[0]) or ":" in words[2]:
            roles = ", ".join(ROLES)
            raise BadRequest(f"{path}: line {number}: expected NAME ROLE SECRET; roles: {roles}.")
        if words[0] in users:
            raise BadRequest(f"{path}: line {number}: {words[0]} appears twice.")
        users[words[0]] = User(words[0], ROLES[words[1]], words[2])
    if not users:
        raise BadRequest(f"{path} has no users.")
    return tuple(users.values())


def add_user(path: Path, name: str, role: str) -> str:
    """Add a user to a file and return the new secret. A missing file is created.

    Raises:
        StudioError: the name is invalid or already used, or the file cannot be written.
    """
    if not _is_user(name):
        raise BadRequest(f"{name!r} is not a valid user name: use up to 40 letters and digits.")
    before = load(path).decode("utf-8", "replace") if path.exists() else ""
    if any(line.split()[:1] == [name] for line in before.splitlines()):
        raise BadRequest(f"{path} already has a user {name}.")
    if before and not before.endswith("\n"):
        before += "\n"
    secret = secrets.token_urlsafe(_SECRET_BYTES)
    if not path.exists():
        path.touch(mode=0o600)
    save(path, f"{before}{name} {role} {secret}\n")
    return secret


def _is_user(name: str) -> bool:
    return name.isascii() and name.isalnum() and len(name) <= 40


# --- Robots -----------------------------------------------------------------------------


@click.command()
@click.argument("hosts", nargs=-1, metavar="[USER@HOST[:PORT]]...")
@click.option("--release", metavar="NAME", help="As an owner, end the current lease of this board.")
@json_option
def robots(hosts: tuple[str, ...], release: str | None, *, as_json: bool) -> None:
    """List the served boards, with their problems and the users who drive them.

    Queries the given computers. By default, queries this computer, the computers in the secrets
    file, and every server that responds on the local network.
    """
    with reported_errors():
        with Robots() as boards:
            rows = boards.find(hosts)
        if release is not None:
            rows = [row for row in rows if release in {row["name"], row["url"]}]
            for row in rows:
                with Trex(row["url"]) as trex:  # the end of the block returns the lease
                    trex.request_lease(take=True)
                row["driver"] = None
    if as_json:
        print_json(rows)
        return
    for row in rows:
        board = row["board"] or "no board"
        state = "responds" if row["responds"] else "does not respond"
        driver = f"{row['driver']} drives" if row["driver"] else "no driver"
        problems = f"; {', '.join(row['problems'])}" if row["problems"] else ""
        click.echo(f"{row['url']}  {board}, {state}, {driver}{problems}")
    if not rows:
        named = "" if release is None else f" named {release}"
        raise CommandFailed(f"No server has a board{named} for this user.")
