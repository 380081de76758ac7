"""Recordings of an Aracna's session: what they hold, how they lie in a file, reading them back."""

from trex_gui.devices.aracna.recording.csv_format import CsvWriter, columns
from trex_gui.devices.aracna.recording.header import Header
from trex_gui.devices.aracna.recording.rows import FellSilent, Row

__all__ = ["CsvWriter", "FellSilent", "Header", "Row", "columns"]
