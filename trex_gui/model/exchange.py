"""Between the models and a settings file: what is shown, and what a file would change."""

from dataclasses import dataclass, replace

from trex_gui.link.reading import DeviceState
from trex_gui.model.device import Device
from trex_gui.protocol.errors import BadRequest
from trex_gui.settings.document import Settings
from trex_gui.settings.snapshot import settings_of


@dataclass(frozen=True, slots=True)
class Staged:
    """What became of a file: how much of it differs and waits for Apply, how much is equal.

    `left_out` names what could not be taken, and why.
    """

    changed: int
    equal: int
    left_out: tuple[str, ...] = ()

    def text(self) -> str:
        """One sentence for people, and one for what was left out."""
        total = self.changed + self.equal
        sentence = f"{total} settings: {self.changed} will change, {self.equal} match."
        if self.changed:
            sentence += " Apply settings writes them."
        return " ".join((sentence, *self.left_out))


def shown_settings(device: Device, state: DeviceState) -> Settings:
    """Return what the window shows: stored values, with the edits that wait in their place."""
    parameters = {
        key: value
        for key in state.parameters
        if (value := device.parameters.value_of(key)) is not None
    }
    stored = settings_of(state)
    edited = {(state.source, channel): c for channel, c in device.calibrations.pending}
    return replace(stored, parameters=parameters, calibrations={**stored.calibrations, **edited})


def stage(device: Device, state: DeviceState, settings: Settings) -> Staged:
    """Make a file's values edits that wait for Apply; nothing is written.

    Raises:
        BadRequest: the file is for another model; nothing was taken.
    """
    model = state.signature.model
    if settings.product.key != model.key:
        message = f"the file is for a {settings.product.name}, and this board is a {model.name}"
        raise BadRequest(message)
    with device.one_edit("Open settings file"):
        return _stage(device, state, settings)


def _stage(device: Device, state: DeviceState, settings: Settings) -> Staged:
    changed, equal, left_out = 0, 0, []
    for key, wire in settings.parameters.items():
        index = device.parameters.index_of(key)
        if not index.isValid():
            left_out.append(f"This board's firmware has no {key}.")
            continue
        if not device.parameters.setData(index, wire):
            left_out.append(f"{key} could not be read from the board.")
            continue
        differs = device.parameters.stored_of(key) != wire
        changed, equal = changed + differs, equal + (not differs)
    for (source, channel), wanted in sorted(
        settings.calibrations.items(), key=lambda item: (item[0][0].value, item[0][1])
    ):
        if source is not state.source:
            continue
        differs = device.calibrations.stored(channel) != wanted
        device.calibrations.edit(channel, wanted)
        changed, equal = changed + differs, equal + (not differs)
    others = sorted({s.value for s, _ in settings.calibrations if s is not state.source})
    left_out += [
        f"The {name} calibrations of the file are left out: the board takes them only while its "
        f"inputs are read as {name}."
        for name in others
    ]
    return Staged(changed, equal, tuple(left_out))
