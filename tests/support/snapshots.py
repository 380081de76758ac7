"""Snapshots for tests, without a board."""

from dataclasses import replace
from datetime import UTC, datetime, timedelta

from tests.devices.trex.settings.samples import factory
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.settings.history import SettingsHistory, Snapshot

ADAPTER = "FT232R (ttyUSB0)"


def create_snapshot(
    history: SettingsHistory,
    ago: timedelta = timedelta(),
    *,
    model: str = "trex",
    adapter: str = ADAPTER,
    reason: str = "Apply of 2 settings",
    **values: int,
) -> Snapshot:
    """Create a snapshot of a board with factory settings, except for `values`."""
    board = factory(model)
    settings = replace(
        board,
        parameters={**board.parameters, **values},
        calibrations={k: c for k, c in board.calibrations.items() if k.source is InputSource.RC},
    )
    now = datetime.now(UTC) - ago
    return history.save(settings, adapter=adapter, reason=reason, now=now)
