"""What the steps of learning share: the name of a channel, a sign, muted text."""

from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtWidgets import QLabel, QWidget

from trex_gui.devices.trex.calibration.problems import Problem
from trex_gui.devices.trex.client.explanations import CHANNEL_ROLES


def channel_label(channel: int, parent: QWidget) -> QLabel:
    """Make the label of a channel: its number, and what it does."""
    words = QCoreApplication.translate("learning", "Channel {0}").format(channel)
    label = QLabel(f"<b>{words}</b><br><small>{CHANNEL_ROLES[channel]}</small>", parent)
    label.setTextFormat(Qt.TextFormat.RichText)
    return label


def in_words(problems: tuple[Problem, ...]) -> str:
    """All that is wrong, one sentence after the other."""
    return " ".join(problem.text for problem in problems)
