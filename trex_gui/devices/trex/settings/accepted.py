"""Values beyond inferred limits that boards have accepted."""

import json
import logging
from collections.abc import Mapping
from pathlib import Path

from trex_gui.core.files import SettingsError, data_folder, file_exists, load
from trex_gui.core.translation import tr
from trex_gui.devices.trex.protocol.commands import Signature
from trex_gui.devices.trex.protocol.device_table import HIGHEST_WIRE
from trex_gui.devices.trex.settings.edit_files import replace_file

log = logging.getLogger(__name__)

Accepted = Mapping[str, frozenset[int]]  # parameter key → wire values


class AcceptedValues:
    """File of accepted values, shared by the window and the command line."""

    def __init__(self, path: Path | None = None) -> None:
        self.path = path or data_folder() / "accepted_values.json"

    def of(self, board: Signature) -> Accepted:
        """Return the values that boards with this model and firmware have stored.

        An unusable file counts as empty, so the user must confirm these values again.
        """
        entry = self._read().get(_name(board))
        return {
            str(key): frozenset(w for w in wires if type(w) is int and 0 <= w <= HIGHEST_WIRE)
            for key, wires in (entry.items() if isinstance(entry, dict) else ())
            if isinstance(wires, list)
        }

    def add(self, board: Signature, values: Mapping[str, int]) -> Accepted:
        """Save values that a board has stored. Return all values for its model and firmware.

        If saving raises a SettingsError, the earlier values remain.
        """
        known = dict(self.of(board))
        for key, wire in values.items():
            known[key] = known.get(key, frozenset()) | {wire}
        entry = {key: sorted(wires) for key, wires in known.items()}
        document = self._read() | {_name(board): entry}
        replace_file(self.path, json.dumps(document, indent=2) + "\n")
        return known

    def _read(self) -> dict[str, object]:
        if not file_exists(self.path):
            return {}
        try:
            document = json.loads(load(self.path, tr("accepted values")))
        except (SettingsError, ValueError, RecursionError) as error:
            log.warning("Ignoring %s: %s", self.path, str(error)[:200])
            return {}
        return document if isinstance(document, dict) else {}


def _name(board: Signature) -> str:
    return f"{board.model.key} {board.firmware}"
