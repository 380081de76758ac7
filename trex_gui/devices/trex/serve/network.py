"""Zenoh network of servers and clients, with users and encryption.

Each user has separate key expressions. The Zenoh engine lets no other user send to these
expressions, so a message at `from/alice/…` is from Alice.
"""

import json
import os
import threading
import time
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from pathlib import Path
from typing import Any

import zenoh

from trex_gui.core.errors import BadRequest, PortUnavailable
from trex_gui.core.translation import tr
from trex_gui.core.transport.urls import LOCAL_USER, Address
from trex_gui.devices.trex.serve.lease import User

_ADDRESS_LIMIT = 32  # maximum number of addresses that a scan returns
_SILENCE_TIMEOUT_MS = 4000  # milliseconds until a silent connection is closed
_ROOT = "trex/v1"


def key(name: str, *parts: str) -> str:
    return "/".join((_ROOT, name, *parts))


def open_client(address: Address) -> zenoh.Session:
    """Connect to a server.

    Raises:
        PortUnavailable: no server responds, or it does not accept the user.
    """
    config: dict[str, Any] = {
        "mode": "client",
        "connect/endpoints": [address.endpoint(encrypted="TREX_TLS_CA" in os.environ)],
        "connect/timeout_ms": 2000,
        "transport/link/tx/lease": _SILENCE_TIMEOUT_MS,
        "scouting/multicast/enabled": False,
        "scouting/gossip/enabled": False,
    }
    if address.user:
        config["transport/auth/usrpwd"] = {"user": address.user, "password": address.secret}
    if authority := os.environ.get("TREX_TLS_CA"):
        config["transport/link/tls/root_ca_certificate"] = authority
    try:
        return zenoh.open(_config(config))
    except zenoh.ZError as error:
        text = tr(
            "No board is served to this user at {0}:{1}. Check that `trexcmd serve` is "
            "running there. Also check the user in the address (trex://USER@…) and the "
            "secret (TREX_SECRET)."
        )
        raise PortUnavailable(text.format(address.host, address.port)) from error


def get(session: zenoh.Session, *parts: str, seconds: float) -> list[bytes]:
    """Query a key. Return the replies that arrive within `seconds`."""
    try:
        replies = session.get(key(*parts), timeout=seconds)
    except zenoh.ZError:  # the session was closed
        return []
    return [reply.ok.payload.to_bytes() for reply in replies if reply.ok]


def scout(seconds: float) -> tuple[Address, ...]:
    """Scan the local network. Return the addresses of the servers that reply."""
    addresses: dict[Address, None] = {}
    config = _config({"scouting/multicast/enabled": True})
    try:
        scouting = zenoh.scout(what="peer", config=config)
    except zenoh.ZError:  # no network
        return ()
    try:
        deadline = time.monotonic() + seconds
        while time.monotonic() < deadline:
            hello = scouting.try_recv()
            if hello is None:
                time.sleep(0.02)
                continue
            for locator in hello.locators:
                kind, _, endpoint = str(locator).partition("/")
                with suppress(BadRequest):  # any computer on the network may reply
                    if kind in {"tcp", "tls"} and len(addresses) < _ADDRESS_LIMIT:
                        addresses[Address.of_host(endpoint.split("?")[0])] = None
    finally:
        scouting.stop()  # type: ignore[no-untyped-call]
    return tuple(addresses)


class ClientLink:
    """Connection of a client to a server, with a second connection for stops.

    A lost network packet delays later packets of the same connection. Therefore, a stop is sent
    over both connections.

    Args:
        address: address of the board.
        receive: called with each message from the server, in a thread of the link.
    """

    def __init__(self, address: Address, receive: Callable[[bytes], None]) -> None:
        self._session = open_client(address)
        self._standby = open_client(address)
        user, client = address.user or LOCAL_USER, os.urandom(8).hex()

        def name(part: str) -> str:
            return key(address.name, part, user, client)

        subscriber = self._session.declare_subscriber(name("to"))
        # The engine ends a token that has no reference.
        self._token = self._session.liveliness().declare_token(name("client"))
        self._publisher = declare_publisher(self._session, name("from"))
        self._stops = declare_publisher(self._standby, name("from"))

        def forward_messages() -> None:
            for sample in subscriber:
                receive(bytes(sample.payload))

        self._thread = threading.Thread(target=forward_messages, daemon=True)
        self._thread.start()

    def send(self, message: bytes, *, is_stop: bool = False) -> None:
        if is_stop:
            self._stops.put(message)
        self._publisher.put(message)

    def close(self) -> None:
        for session in (self._standby, self._session):
            session.close()  # type: ignore[no-untyped-call]
        self._thread.join()  # a thread inside the engine at exit would crash the process


def open_server(
    name: str,
    listen: Sequence[str],
    users: Sequence[User],
    folder: Path,
    *,
    tls: tuple[Path, Path] | None = None,
) -> zenoh.Session:
    """Listen for clients. `tls` contains the paths of the certificate and key files.

    The engine reads the secrets from a file in `folder`, so the folder must be private.

    Raises:
        PortUnavailable: the engine cannot listen at an address.
    """
    is_public = bool(users)
    config: dict[str, Any] = {
        "mode": "peer",
        "listen/endpoints": list(listen),
        "listen/exit_on_failure": True,
        # Reply to clients that scan, but do not scan for other servers.
        "scouting/multicast/enabled": is_public,
        "scouting/multicast/autoconnect": [],
        "scouting/gossip/enabled": False,
        # Clients that connect but never log in must not block other clients for long.
        "transport/unicast/accept_pending": 1000,
        "transport/link/tx/lease": _SILENCE_TIMEOUT_MS,
        "transport/unicast/accept_timeout": 3000,
        "transport/link/rx/max_message_size": 65536,
    }
    if tls is not None:
        config["transport/link/tls/listen_certificate"] = str(tls[0])
        config["transport/link/tls/listen_private_key"] = str(tls[1])
    if users:
        secrets = folder / "users"
        secrets.touch(mode=0o600)
        lines = [f"{user.name}:{user.secret}\n" for user in users]
        secrets.write_text("".join(lines), "utf-8")
        # The engine itself needs a user and a password. No client can know the password.
        config["transport/auth/usrpwd"] = {
            "user": "-",
            "password": os.urandom(16).hex(),
            "dictionary_file": str(secrets),
        }
        config["access_control"] = _access(name, users)
    try:
        return zenoh.open(_config(config))
    except zenoh.ZError as error:
        text = tr("The server cannot listen at {0}: {1}")
        raise PortUnavailable(text.format(", ".join(listen), error)) from error


def declare_publisher(session: zenoh.Session, name: str) -> zenoh.Publisher:
    """Declare a publisher that neither drops nor batches messages."""
    block = zenoh.CongestionControl.BLOCK
    return session.declare_publisher(name, congestion_control=block, express=True)


_MESSAGES = {  # kind of key → (engine messages from clients, engine messages to clients)
    "send": (["put"], ["declare_subscriber"]),
    "data": (["declare_subscriber"], ["put"]),
    "query": (["query"], ["reply", "declare_queryable"]),
    "token": (["liveliness_token"], ["liveliness_query", "declare_liveliness_subscriber"]),
}


def _access(name: str, users: Sequence[User]) -> dict[str, Any]:
    def rules(prefix: str, keys: Mapping[str, str]) -> list[dict[str, Any]]:
        return [
            {
                "id": f"{prefix}-{kind}-{flow}",
                "permission": "allow",
                "flows": [flow],
                "messages": list(messages),
                "key_exprs": [expression],
            }
            for kind, expression in keys.items()
            for flow, messages in zip(("ingress", "egress"), _MESSAGES[kind], strict=True)
        ]

    public = rules("-", {"query": key("*", "info"), "data": key(name, "data", "**")})
    private = {
        user.name: rules(
            user.name,
            {
                "send": key(name, "from", user.name, "*"),
                "data": key(name, "to", user.name, "*"),
                "token": key(name, "client", user.name, "*"),
                "query": key(name, "stop", user.name),
            },
        )
        for user in users
    }
    return {
        "enabled": True,
        "default_permission": "deny",
        "rules": [*public, *(rule for user_rules in private.values() for rule in user_rules)],
        "subjects": [{"id": user, "usernames": [user]} for user in private],
        "policies": [
            {"rules": [rule["id"] for rule in (*public, *user_rules)], "subjects": [user]}
            for user, user_rules in private.items()
        ],
    }


def _config(settings: dict[str, Any]) -> zenoh.Config:
    config = zenoh.Config()
    for name, value in settings.items():
        config.insert_json5(name, json.dumps(value))
    return config
