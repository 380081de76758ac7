"""Notes on settings, stored as comments in a settings file.

Each line of a note is a separate comment, such as `# Note on serial_timeout: the radio drops out`.
The comment is usually above its setting. Other programs treat notes as ordinary comments.
"""

import re
from collections.abc import Mapping

from trex_gui.devices.trex.protocol.calibration import CALIBRATION_KEYS
from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.devices.trex.settings.yaml_subset import LINE_END

LONGEST_NOTE = 1000  # characters; a file with such notes on all settings can be read

_NOTE = re.compile(r"[ \t]*# Note on ([a-z0-9_]+): .*\S[ \t]*")


def noted_key(line: str) -> str:
    """Return the key of the setting that a note line is about. Empty for other lines."""
    key = found[1] if (found := _NOTE.fullmatch(line)) else ""
    known = key in CALIBRATION_KEYS or any(row["key"] == key for row in device_table().rows)
    return key if known else ""


def read_notes(text: str) -> dict[str, str]:
    """Return the notes in a text by key. The lines of each note are joined."""
    notes: dict[str, list[str]] = {}
    for line in LINE_END.split(text):
        key = noted_key(line)
        if key and (note := clean_note(line.partition(":")[2])):
            notes.setdefault(key, []).append(note)
    return {key: "\n".join(notes[key]) for key in sorted(notes)}


def lines_of_note(key: str, notes: Mapping[str, str]) -> list[str]:
    """Return the note on a setting as lines of a settings file. Empty if it has no note."""
    return [f"# Note on {key}: {line}" for line in clean_note(notes.get(key, "")).splitlines()]


def clean_note(text: str) -> str:
    """Remove empty lines and outer spaces, and replace unprintable characters."""
    lines = (line.expandtabs().strip() for line in text.splitlines())
    printable = ("".join(c if c.isprintable() else "?" for c in line) for line in lines)
    return "\n".join(filter(None, printable))
