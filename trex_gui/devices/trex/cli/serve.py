"""serve and robots: boards that other computers use over the network."""

import json
import socket
import sys
from collections.abc import Iterable, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import click

from trex_gui.core.cli import CommandFailed, Interruption, json_option, print_json, refusals, say
from trex_gui.core.command_io import FileName
from trex_gui.core.errors import PortUnavailable, StudioError
from trex_gui.core.host import host
from trex_gui.core.transport.urls import (
    LOCAL_USER,
    PORT,
    Address,
    is_name,
    known_hosts,
)
from trex_gui.devices.trex.cli.common import link_options, link_settings
from trex_gui.devices.trex.serve.sessions import NEEDS_EXTRA
from trex_gui.devices.trex.serve.users import ROLES, add_user, read_users

_EVERYWHERE = "0.0.0.0"  # noqa: S104 - users are checked
_SCOUTING_S = 0.7
_ANSWER_S = 2.0
_STOP_S = 10.0  # a stop is repeated for so long on a line that corrupts bytes


@click.command()
@link_options
@click.option("--name", default="robot", show_default=True, help="Name under which it is served.")
@click.option(
    "--listen",
    metavar="HOST:PORT",
    default=None,
    help=f"Where to listen; with users every address at {PORT}, else this computer only.",
)
@click.option("--users", "users_file", type=FileName(dir_okay=False), help="File of the users.")
@click.option("--add-user", metavar="NAME", help="Add a user to the file, print its secret, end.")
@click.option(
    "--role",
    type=click.Choice(list(ROLES)),
    default="drive",
    show_default=True,
    help="What the new user may do.",
)
@click.option(
    "--tls",
    nargs=2,
    type=FileName(exists=True, dir_okay=False),
    metavar="CERT KEY",
    help="Encrypt with the certificate and the key in these files.",
)
@click.option("--install", is_flag=True, help="Print how to start it with the computer, and end.")
def serve(
    name: str,
    *,
    listen: str | None,
    users_file: str | None,
    add_user: str | None,
    role: str,
    tls: tuple[str, str] | None,
    install: bool,
    **options: Any,
) -> None:
    """Serve the board to the window, trexcmd and programs of other computers.

    They reach it as trex://HOST/NAME. One of them drives at a time; every user can watch it and
    stop it. The motors are stopped here, half a second after the last heartbeat of the driver.

    Without --users only programs on this computer reach it.
    """
    if install:
        click.echo(_install_text())
        return
    if add_user is not None:
        _add_user(users_file, add_user, role)
        return
    if not is_name(name):
        raise click.UsageError(f"A name has letters, digits, and -_. between them, not {name!r}.")
    settings = link_settings(options)
    with refusals():
        users = read_users(Path(users_file)) if users_file else ()
        address = Address.of_host(listen or (_EVERYWHERE if users else "127.0.0.1"))
        if not users and not _is_local(address.host):
            raise click.UsageError("Without --users only this computer can be listened at.")
        _network()  # raises without the extra
        from trex_gui.devices.trex.serve.served_board import ServedBoard  # noqa: PLC0415 - an extra

        endpoint = f"{'tls' if tls else 'tcp'}/{address.host}:{address.port}"
        board = ServedBoard(
            settings,
            name,
            listen=[endpoint],
            users=users,
            computer=host(),
            say=say,
            tls=(Path(tls[0]), Path(tls[1])) if tls else None,
        )
        here = socket.gethostname() if users else "127.0.0.1"
        shown = Address(here, name, "USER" if users else "", address.port).url
        say(f"Serving {settings.label} as {shown}. Ctrl-C stops the motors and ends.")
        if not users:
            say("Only programs on this computer reach it; --users lets others in.")
        elif not tls:
            say("Secrets are checked, but nothing is encrypted without --tls.")
        with Interruption(precious=True) as interrupted:
            last = board.run(lambda: bool(interrupted))
    if last.may_move:
        raise CommandFailed("The stop is not confirmed. If a motor still turns, cut its power.")


def _is_local(name: str) -> bool:
    return name in {"localhost", "::1"} or name.startswith("127.")


def _add_user(file: str | None, name: str, role: str) -> None:
    if file is None:
        raise click.UsageError("--add-user needs --users FILE.")
    with refusals():
        secret = add_user(Path(file), name, role)
    say(f"{name} may {role}. The secret, for TREX_SECRET or the file of secrets:")
    click.echo(secret)


def _install_text() -> str:
    command = Path(sys.argv[0]).absolute()
    return f"""\
# /etc/udev/rules.d/60-trex.rules: a name for the adapter, whatever is plugged in beside it
SUBSYSTEM=="tty", ENV{{ID_BUS}}=="usb", SYMLINK+="trex", GROUP="dialout", TAG+="systemd"

# /etc/systemd/system/trex-serve.service
[Unit]
Description=TReX motor controller for the network
BindsTo=dev-trex.device
After=dev-trex.device network-online.target
Wants=network-online.target

[Service]
ExecStart={command} serve --port /dev/trex --name robot --users /etc/trex/users
User=trex
SupplementaryGroups=dialout
Restart=always
RestartSec=1
KillSignal=SIGINT
TimeoutStopSec=10

[Install]
WantedBy=dev-trex.device

# Then, as root:
#   useradd --system trex; install -d -o trex -m 700 /etc/trex
#   sudo -u trex {command} serve --users /etc/trex/users --add-user YOU --role own
#   udevadm control --reload; systemctl enable trex-serve; udevadm trigger"""


# --- Robots -----------------------------------------------------------------------------


@click.command()
@click.argument("hosts", nargs=-1, metavar="[USER@HOST[:PORT]]...")
@json_option
def robots(hosts: tuple[str, ...], *, as_json: bool) -> None:
    """List the boards that are served: who drives each, and what is wrong with it.

    Asks these computers; without any, this one, those with a secret in the file of secrets, and
    those that answer on the local network.
    """
    with refusals():
        found = find_robots(hosts)
    if as_json:
        print_json(found)
        return
    for row in found:
        board = row["board"] or "no board"
        state = "responds" if row["responds"] else "does not respond"
        driver = f"{row['driver']} drives" if row["driver"] else "nobody drives"
        problems = f"; {', '.join(row['problems'])}" if row["problems"] else ""
        click.echo(f"{row['url']}  {board}, {state}, {driver}{problems}")
    if not found:
        raise CommandFailed("No board is served to this user there.")


def find_robots(hosts: Iterable[str]) -> list[dict[str, Any]]:
    """Return what each served board says of itself, with its `url`, by name.

    Raises:
        StudioError: no host can be asked at all.
    """
    addresses = _addresses(hosts)
    with ThreadPoolExecutor(16) as pool:
        answers = pool.map(_robots_at, addresses)
        rows = {row["url"]: row for some in answers for row in some}
    return sorted(rows.values(), key=lambda row: (row["name"], row["url"]))


def _addresses(hosts: Iterable[str]) -> list[Address]:
    given = [Address.of_host(text) for text in hosts]
    if given:
        return given
    network = _network()
    known = known_hosts()
    names = {one.host for one in known}
    scouted = [one for one in network.scout(_SCOUTING_S) if one.host not in names]
    return [Address("127.0.0.1"), *known, *scouted]


def _robots_at(address: Address) -> list[dict[str, Any]]:
    network = _network()
    try:
        session = network.open_client(address)
    except StudioError:
        return []
    with session:
        replies = session.get(network.key("*", "info"), timeout=_ANSWER_S)
        rows = [json.loads(reply.ok.payload.to_bytes()) for reply in replies if reply.ok]
    for row in rows:
        row["url"] = Address(address.host, row["name"], address.user, address.port).url
    return rows


def stop_robots(names: Iterable[str]) -> dict[str, str]:
    """Stop these served boards, or all, at once.

    Names are those of the list of robots, or URLs. Return why each is not confirmed, empty if it
    is, by URL.
    """
    wanted = list(names)
    addresses = [Address.of(one) for one in wanted if "://" in one]
    if others := {one for one in wanted if "://" not in one}:
        rows = [row for row in find_robots(()) if "all" in others or row["name"] in others]
        addresses += [Address.of(row["url"]) for row in rows]
    with ThreadPoolExecutor(16) as pool:
        results = list(pool.map(_stop, _batches(addresses)))
    return {url: error for some in results for url, error in some.items()}


def _batches(addresses: Iterable[Address]) -> list[list[Address]]:
    """Return the boards in groups: of one user each, and without two of the same name."""
    batches: list[list[Address]] = []
    for one in dict.fromkeys(addresses):
        who = one.user, one.secret
        for batch in batches:
            names = {other.name for other in batch}
            if (batch[0].user, batch[0].secret) == who and one.name not in names:
                batch.append(one)
                break
        else:
            batches.append([one])
    return batches


def _stop(boards: Sequence[Address]) -> dict[str, str]:
    network = _network()
    results = {one.url: "It did not answer." for one in boards}
    try:
        session = network.open_client(*boards)
    except StudioError as error:
        return dict.fromkeys(results, str(error))
    with session:
        queries = {
            one.url: session.get(
                network.key(one.name, "stop", one.user or LOCAL_USER), timeout=_STOP_S
            )
            for one in boards
        }
        for url, replies in queries.items():
            for reply in replies:
                if reply.ok:
                    results[url] = json.loads(reply.ok.payload.to_bytes())["error"]
    return results


def _network() -> Any:
    try:
        import zenoh  # noqa: F401, PLC0415 - an extra

        from trex_gui.devices.trex.serve import network  # noqa: PLC0415
    except ImportError as error:
        raise PortUnavailable(NEEDS_EXTRA) from error
    return network
