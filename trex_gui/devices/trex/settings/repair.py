"""Repair invalid values in settings files, and settings that do not fit together."""

from collections.abc import Collection, Mapping
from dataclasses import replace

from trex_gui.core.files import decode
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.edit_in_place import BYTE_ORDER_MARK
from trex_gui.devices.trex.settings.reader import text_fixes
from trex_gui.devices.trex.settings.rules import RULES, Context, LintFinding, lint

_NO_CONTEXT = Context()


def repair_values(data: bytes, name: str) -> tuple[str, tuple[str, ...]]:
    """Repair invalid values in a text if their meaning is clear.

    Return the text and one line for each repair.

    Raises:
        SettingsError: `data` is not the text of a settings file.
    """
    body = decode(data, name)
    fixes = text_fixes(body, name)
    for fix in reversed(fixes):
        body = body[: fix.start] + fix.text + body[fix.end :]
    mark = BYTE_ORDER_MARK if data.startswith(BYTE_ORDER_MARK.encode()) else ""
    return mark + body, tuple(f"line {fix.line}: {fix.message}" for fix in fixes)


def accept_proposals(
    settings: Settings, context: Context = _NO_CONTEXT, *, kept: Collection[str] = ()
) -> tuple[Settings, tuple[LintFinding, ...]]:
    """Apply the changes that the rules propose. Return settings and accepted findings.

    Proposals that change a parameter in `kept` are not accepted.

    A change can cause a new finding, so the rules run again. Each rule changes a setting only once.
    """
    accepted: dict[tuple[str, tuple[str, ...]], LintFinding] = {}
    for _ in RULES:
        new = {
            (found.rule, found.keys): found
            for found in lint(settings, context)
            if found.change
            and found.change.keys().isdisjoint(kept)
            and (found.rule, found.keys) not in accepted
        }
        if not new:
            break
        accepted |= new
        changes: Mapping[str, int] = {
            k: w for found in new.values() for k, w in found.change.items()
        }
        settings = replace(settings, parameters={**settings.parameters, **changes})
    return settings, tuple(accepted.values())


def repair_text(found: LintFinding) -> str:
    return f"{found.proposal}: {found.message}"
