"""Immediate saving of a document."""

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
    """Save the content that `make` returns, by default in the document's own file."""
    target, content = path or document.path, make()
    assert target is not None
    save(target, content.text)
    content.record_saved(target)
