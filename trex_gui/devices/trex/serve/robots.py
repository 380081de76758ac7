"""Client that finds and stops served boards on a network."""

import json
from collections.abc import Iterable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from typing import Any, Self

from trex_gui.core.errors import PortUnavailable, StudioError
from trex_gui.core.translation import tr
from trex_gui.core.transport.urls import LOCAL_USER, Address, is_name, known_hosts
from trex_gui.devices.trex.serve.sessions import NEEDS_EXTRA

_SCOUTING_S = 0.7
_REPLY_TIMEOUT_S = 2.0
_REUSE_TIMEOUT_S = 1.0  # timeout on a connection that was opened earlier and may be dead
_STOP_TIMEOUT_S = 10.0  # a stop may take this long on a line that corrupts bytes
_CONNECTION_LIMIT = 100  # maximum number of simultaneous connections
ALL = "all"


class Robots:
    """Client of all served boards. Connections to the hosts stay open until `close`."""

    def __init__(self) -> None:
        self._newest: dict[Address, Any] = {}  # address without a board name → newest connection
        self._opened: list[Any] = []

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        opened, self._opened, self._newest = self._opened, [], {}
        for connection in opened:
            connection.close()

    def find(self, hosts: Iterable[str] = ()) -> list[dict[str, Any]]:
        """Return the info of each served board with its `url`, sorted by name.

        Raises:
            StudioError: a host or the secrets file is invalid, or packages for a scan are missing.
        """
        addresses = _addresses(hosts)
        with ThreadPoolExecutor(_CONNECTION_LIMIT) as pool:
            rows = {row["url"]: row for rows in pool.map(self._rows_at, addresses) for row in rows}
        return sorted(rows.values(), key=lambda row: (row["name"], row["url"]))

    def stop(self, names: Iterable[str]) -> dict[str, str]:
        """Stop served boards simultaneously.

        `names` are board names, URLs or `ALL`. The result contains a text for each URL: the error,
        or an empty text for a confirmed stop. It also contains an error for each name that was not
        found.
        """
        addresses, missing = [], set[str]()
        for name in names:
            if "://" in name:
                addresses.append(Address.of(name))
            else:
                missing.add(name)
        if missing:
            rows = [row for row in self.find() if ALL in missing or row["name"] in missing]
            addresses += [Address.of(row["url"]) for row in rows]
            missing -= {ALL, *(row["name"] for row in rows)}
        boards = list(dict.fromkeys(addresses))
        with ThreadPoolExecutor(_CONNECTION_LIMIT) as pool:
            errors = pool.map(self._stop, boards)
            results = {board.url: error for board, error in zip(boards, errors, strict=True)}
        return results | dict.fromkeys(missing, tr("It did not respond."))

    def _rows_at(self, address: Address) -> list[dict[str, Any]]:
        try:
            replies = self._get(address, "*", "info", seconds=_REPLY_TIMEOUT_S)
        except PortUnavailable:
            return []
        rows = [row for row in map(_row_of, replies) if row is not None]
        for row in rows:
            row["url"] = Address(address.host, row["name"], address.user, address.port).url
        return rows

    def _stop(self, board: Address) -> str:
        user = board.user or LOCAL_USER
        try:
            replies = self._get(board, board.name, "stop", user, seconds=_STOP_TIMEOUT_S)
        except StudioError as error:
            return str(error)
        return _error_in(replies)

    def _get(self, address: Address, *parts: str, seconds: float) -> list[bytes]:
        """Return the replies of a host. Reconnect if there is no reply over the open connection."""
        host, network = replace(address, name=""), _network()
        if connection := self._newest.get(host):
            replies: list[bytes] = network.get(connection, *parts, seconds=_REUSE_TIMEOUT_S)
            if replies:
                return replies
        connection = self._newest[host] = network.open_client(address)
        self._opened.append(connection)
        return list(network.get(connection, *parts, seconds=seconds))


def _addresses(hosts: Iterable[str]) -> list[Address]:
    addresses = [Address.of_host(text) for text in hosts]
    if addresses:
        return addresses
    network = _network()
    known = known_hosts()
    names = {address.host for address in known}
    scouted = [address for address in network.scout(_SCOUTING_S) if address.host not in names]
    return [Address("127.0.0.1"), *known, *scouted]


def _row_of(data: bytes) -> dict[str, Any] | None:
    try:
        row = json.loads(data)
        texts = row["name"], row["board"] or "", row["driver"] or "", *row["problems"]
        is_valid = is_name(row["name"]) and all(map(str.isprintable, texts))
    except (ValueError, LookupError, TypeError):
        return None
    return row if is_valid else None


def _error_in(replies: list[bytes]) -> str:
    """Return the error in the reply to a stop. An invalid reply counts as missing."""
    try:
        return str(json.loads(replies[0])["error"])
    except (ValueError, LookupError, TypeError):
        return tr("It did not respond.")


def require_network() -> None:
    _network()


def _network() -> Any:
    try:
        from trex_gui.devices.trex.serve import network  # noqa: PLC0415 - an extra
    except ImportError as error:
        raise PortUnavailable(tr(NEEDS_EXTRA)) from error
    return network
