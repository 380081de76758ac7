"""Between a draft and other settings: what a file or a snapshot would change of it."""

from dataclasses import replace

from trex_gui.core.errors import BadRequest
from trex_gui.devices.trex.model.settings.draft import SettingsDraft
from trex_gui.devices.trex.settings.comparison import Comparison, compare
from trex_gui.devices.trex.settings.document import Settings


def diff_against_draft(draft: SettingsDraft, settings: Settings) -> Comparison:
    """Compare what a draft shows with what it would show after taking other settings in.

    What the board does not take now, or does not have, is left out and named.

    Raises:
        BadRequest: the settings are for another model, or nothing is there to compare with.
    """
    shown = draft.shown
    if shown is None:
        raise BadRequest("no settings are there to compare with")
    if settings.product.key != shown.product.key:
        message = (
            f"these are settings of a {settings.product.name}, and here is a {shown.product.name}"
        )
        raise BadRequest(message)
    known = {spec.key for spec in shown.specs.readable}
    unread = [key for key in settings.parameters if key in known and not draft.knows(key)]
    hidden = [key for key in settings.calibrations if not draft.knows(key)]
    fitted = replace(
        settings,
        parameters={k: w for k, w in settings.parameters.items() if k not in unread},
        calibrations={
            key: calibration
            for key, calibration in settings.calibrations.items()
            if key not in hidden
        },
    )
    notes = [f"{key} is left out: it could not be read from the board." for key in unread]
    notes += [
        f"The {name} calibrations are left out: the board takes them only while its inputs are "
        f"read as {name}."
        for name in sorted({key.source.value for key in hidden})
    ]
    result = compare(shown, fitted)
    return replace(result, left_out=(*result.left_out, *notes))
