"""The boards that are served on a network: a list of them, and a stop for all at once."""

import json
from collections.abc import Iterable, Sequence
from concurrent.futures import ThreadPoolExecutor
from typing import Any

from trex_gui.core.errors import PortUnavailable, StudioError
from trex_gui.core.translation import tr
from trex_gui.core.transport.urls import LOCAL_USER, Address, is_name, known_hosts
from trex_gui.devices.trex.serve.sessions import NEEDS_EXTRA

_SCOUTING_S = 0.7
_ANSWER_S = 2.0
_STOP_S = 10.0  # a stop is repeated for so long on a line that corrupts bytes
ALL = "all"


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
    is, by URL.
    """
    wanted = list(names)
    addresses = [Address.of(one) for one in wanted if "://" in one]
    if others := {one for one in wanted if "://" not in one}:
        rows = [row for row in find_robots(()) if ALL in others or row["name"] in others]
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
    results = {one.url: tr("It did not answer.") for one in boards}
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
