"""Loading of recordings."""

from typing import Any, TypeVar

from trex_gui.ui.playback.player import RecordingPlayer

PlayerT = TypeVar("PlayerT", bound=RecordingPlayer[Any, Any, Any])


def loading(player: PlayerT) -> PlayerT:
    """Start loading a recording, as its window does. Return the recording."""
    player.start_loading()
    return player
