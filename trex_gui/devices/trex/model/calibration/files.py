"""Only the calibrations of a settings file: into edits, and out of what is shown."""

from dataclasses import replace
from pathlib import Path

from trex_gui.core.errors import BadRequest
from trex_gui.core.files import load, save
from trex_gui.devices.trex.model.settings.draft import SettingsDraft, diff_against_draft
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.edit_in_place import amend
from trex_gui.devices.trex.settings.reader import read_settings
from trex_gui.devices.trex.settings.writer import write_settings


def take_calibrations(draft: SettingsDraft, path: Path, text: str) -> tuple[int, tuple[str, ...]]:
    """Make the calibrations of a file edits, one step to undo under the name `text`.

    Returns how many differ, and what was left out and why.

    Raises:
        SettingsError: the file cannot be read.
        BadRequest: it has no calibrations, or is for another model.
    """
    settings, _ = read_settings(load(path), path.name)
    if not settings.calibrations:
        raise BadRequest("it gives no calibrations")
    comparison = diff_against_draft(draft, replace(settings, parameters={}))
    rows = [row for row in comparison.rows if row.after is not None and row.before != row.after]
    if rows:
        draft.stage(rows, text)
    return len(rows), comparison.left_out


def put_calibrations(shown: Settings, path: Path, title: str) -> None:
    """Write the calibrations shown into a file; of one that is there, the rest stays.

    Raises:
        SettingsError: the file cannot be read or written.
        BadRequest: it is for another model.
    """
    if not path.exists():
        only = replace(shown, parameters={})
        save(path, write_settings(only, title_lines=[title]))
        return
    before = load(path).decode("utf-8-sig")
    old, _ = read_settings(before, path.name)
    if old.product.key != shown.product.key:
        raise BadRequest(f"it holds settings of a {old.product.name}")
    whole = replace(old, calibrations={**old.calibrations, **shown.calibrations})
    save(path, amend(before, whole, path.name))
