"""Recordings that are being loaded."""

from typing import Any, TypeVar

from trex_gui.ui.playback.player import RecordingPlayer

PlayerT = TypeVar("PlayerT", bound=RecordingPlayer[Any, Any, Any])


def loading(player: PlayerT) -> PlayerT:
    """Start loading a recording, as its window does, and return it."""
    player.start_loading()
    return player
