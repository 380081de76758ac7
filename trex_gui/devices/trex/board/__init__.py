"""The mirror of one board, and the one transaction for writes: no Qt, no threads."""

from trex_gui.devices.trex.client.writing import WriteResult

__all__ = ["WriteResult"]
