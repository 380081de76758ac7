"""Loading of recordings."""

from typing import Any, TypeVar

from trex_gui.ui.playback.player import RecordingPlayer

PlayerT = TypeVar("PlayerT", bound=RecordingPlayer[Any, Any, Any])


def loading(player: PlayerT) -> PlayerT:
    """Start loading a recording like its window does. Return the player."""
    player.start_loading()
    return player
