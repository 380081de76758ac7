"""The Currents page."""

from trex_gui.views.pages.currents.page import CurrentsPage

__all__ = ["CurrentsPage"]
