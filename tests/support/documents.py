"""Saving of a document in the calling thread."""

from collections.abc import Callable
from pathlib import Path
from typing import Protocol

from trex_gui.core.files import save
from trex_gui.ui.files import Content


class SavedDocument(Protocol):
    path: Path | None


def save_now(
    document: SavedDocument, get_content: Callable[[], Content], path: Path | None = None
) -> None:
    """Save the content of a document, by default in its own file."""
    target, content = path or document.path, get_content()
    assert target is not None
    save(target, content.text)
    content.record_saved(target)
