"""State of one board, and writes of its settings. No Qt, no threads."""

from trex_gui.devices.trex.client.writing import WriteResult

__all__ = ["WriteResult"]
