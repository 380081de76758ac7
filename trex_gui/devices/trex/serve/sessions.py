"""Creation of sessions for local and served boards."""

from collections.abc import Callable
from typing import Protocol

from trex_gui.core.errors import PortUnavailable
from trex_gui.core.session import Inbox
from trex_gui.core.translation import tr, tr_noop
from trex_gui.core.transport.serial_port import Transport
from trex_gui.core.transport.urls import is_served
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.session.messages import Report, Request
from trex_gui.devices.trex.session.session import TrexSession

NEEDS_EXTRA = tr_noop(
    "Boards on the network need additional packages: install trex-gui[remote] with pip or pipx."
)


class BoardSession(Protocol):
    def run(self) -> None: ...


def _refuse(_settings: ConnectionSettings) -> Transport:
    raise PortUnavailable(tr(NEEDS_EXTRA))


def session_at(
    settings: ConnectionSettings,
    inbox: Inbox[Request],
    emit: Callable[[Report], None],
    open_transport: Callable[[ConnectionSettings], Transport],
    clock: Callable[[], float],
    *,
    may_move: bool = False,
) -> BoardSession:
    """Create a local or remote session for `settings`. `TrexSession` explains the arguments."""
    if not is_served(settings.url):
        return TrexSession(settings, inbox, emit, open_transport, may_move=may_move)
    try:
        from trex_gui.devices.trex.serve.remote_session import (  # noqa: PLC0415 - an extra
            RemoteSession,
        )
    except ImportError:
        return TrexSession(settings, inbox, emit, _refuse, may_move=may_move)
    return RemoteSession(settings, inbox, emit, clock, may_move=may_move)
