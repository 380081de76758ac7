"""Saving a document at once."""

from collections.abc import Callable
from pathlib import Path
from typing import Protocol

from trex_gui.core.files import save
from trex_gui.ui.files import Content


class SavedDocument(Protocol):
    path: Path | None


def save_now(
    document: SavedDocument, make: Callable[[], Content], path: Path | None = None
) -> None:
    """Save what `make` returns for a document, in its own file or another one."""
    target, content = path or document.path, make()
    assert target is not None
    save(target, content.text)
    content.record_saved(target)
