"""What a recording says of a board, and of what is asked of it."""

from datetime import UTC, datetime

from trex_gui import __version__
from trex_gui.devices.trex.client.reading import DeviceState
from trex_gui.devices.trex.driving.requests import SetAuxiliary, SetMotor
from trex_gui.devices.trex.recording.recording import (
    LONGEST_TEXT,
    AuxiliarySetpointRecord,
    Header,
    Marker,
    SetpointRecord,
    SettingsSeen,
)
from trex_gui.devices.trex.settings.from_board import settings_of
from trex_gui.devices.trex.settings.writer import write_settings


def header_of(state: DeviceState, clock: float, device_number: int | None) -> Header:
    """Return the header of a recording that begins now; `clock` is the session's, in seconds."""
    return Header(
        started=datetime.now(UTC),
        clock=clock,
        model=state.signature.model,
        firmware=state.signature.firmware,
        mode=state.mode,
        settings=settings_text(state),
        device_number=device_number,
        program=f"TReX Studio {__version__}",
    )


def settings_text(state: DeviceState) -> str:
    """Return what a board stores as the text of a settings file."""
    return write_settings(settings_of(state))[:LONGEST_TEXT]


def settings_seen(state: DeviceState, time: float) -> SettingsSeen:
    """Return that a board stores something else from now on."""
    return SettingsSeen(time, settings_text(state))


def wish_of(
    request: SetMotor | SetAuxiliary, time: float
) -> SetpointRecord | AuxiliarySetpointRecord:
    """Return what was asked of a motor."""
    if isinstance(request, SetMotor):
        return SetpointRecord(time, request.motor, request.drive, request.accelerate)
    return AuxiliarySetpointRecord(time, request.speed, request.accelerate)


def marker(time: float, kind: str, text: str) -> Marker:
    """Return that something happened, in no more words than a record may have."""
    return Marker(time, kind, text[:LONGEST_TEXT])
