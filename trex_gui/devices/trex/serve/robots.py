"""The boards that are served on a network: a list of them, and a stop for all at once."""

import json
from collections.abc import Iterable
from concurrent.futures import ThreadPoolExecutor
from typing import Any

from trex_gui.core.errors import PortUnavailable, StudioError
from trex_gui.core.translation import tr
from trex_gui.core.transport.urls import LOCAL_USER, Address, is_name, known_hosts
from trex_gui.devices.trex.serve.sessions import NEEDS_EXTRA

_SCOUTING_S = 0.7
_ANSWER_S = 2.0
_STOP_S = 10.0  # a stop is repeated for so long on a line that corrupts bytes
_MOST_AT_ONCE = 100  # connections
ALL = "all"


def find_robots(hosts: Iterable[str]) -> list[dict[str, Any]]:
    """Return what each served board says of itself, with its `url`, by name.

    Raises:
        StudioError: no host can be asked at all.
    """
    addresses = _addresses(hosts)
    with ThreadPoolExecutor(_MOST_AT_ONCE) as pool:
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
    except PortUnavailable:
        return []
    with session:
        replies = session.get(network.key("*", "info"), timeout=_ANSWER_S)
        found = [_row_of(reply.ok.payload.to_bytes()) for reply in replies if reply.ok]
    rows = [row for row in found if row is not None]
    for row in rows:
        row["url"] = Address(address.host, row["name"], address.user, address.port).url
    return rows


def _row_of(data: bytes) -> dict[str, Any] | None:
    """Return what a server says of itself; `None` if that cannot be."""
    try:
        row = json.loads(data)
        texts = row["name"], row["board"] or "", row["driver"] or "", *row["problems"]
        is_sound = is_name(row["name"]) and all(map(str.isprintable, texts))
    except (ValueError, LookupError, TypeError):
        return None
    return row if is_sound and isinstance(row, dict) else None


def stop_robots(names: Iterable[str]) -> dict[str, str]:
    """Stop these served boards, or all, at once.

    Names are those of the list of robots, or URLs. Return why each is not confirmed, empty if it
    is, by URL, or by the name of a board that is not found.
    """
    wanted = list(names)
    addresses = [Address.of(one) for one in wanted if "://" in one]
    if others := {one for one in wanted if "://" not in one}:
        rows = [row for row in find_robots(()) if ALL in others or row["name"] in others]
        addresses += [Address.of(row["url"]) for row in rows]
        others -= {ALL, *(row["name"] for row in rows)}
    boards = list(dict.fromkeys(addresses))
    with ThreadPoolExecutor(_MOST_AT_ONCE) as pool:
        results = dict(zip((one.url for one in boards), pool.map(_stop, boards), strict=True))
    return results | dict.fromkeys(others, tr("It did not answer."))


def _stop(board: Address) -> str:
    """Stop one board; return why that is not confirmed, empty if it is."""
    network = _network()
    try:
        session = network.open_client(board)
    except StudioError as error:
        return str(error)
    with session:
        name = network.key(board.name, "stop", board.user or LOCAL_USER)
        for reply in session.get(name, timeout=_STOP_S):
            if reply.ok:
                return str(json.loads(reply.ok.payload.to_bytes())["error"])
    return tr("It did not answer.")


def require_network() -> None:
    """Raise PortUnavailable if the packages of the network are not installed."""
    _network()


def _network() -> Any:
    try:
        import zenoh  # noqa: F401, PLC0415 - an extra

        from trex_gui.devices.trex.serve import network  # noqa: PLC0415
    except ImportError as error:
        raise PortUnavailable(tr(NEEDS_EXTRA)) from error
    return network
