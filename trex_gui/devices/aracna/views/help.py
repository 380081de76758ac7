"""Help topics for the pages and messages of an Aracna."""

from trex_gui.core.errors import PortFault
from trex_gui.devices.aracna.session.errors import ErrorCode
from trex_gui.ui.help.messages import MessageHelp, texts_of

TOPICS = {  # object name → help topic
    "aracna_startPanel": "aracna.md",
    "aracnaRobotPage": "aracna.md#robot",
    "aracnaPosesPage": "aracna.md#poses",
    "aracnaDiagnosticsPage": "traffic.md",
    "aracnaErrorsPage": "traffic.md#problems",
    "aracnaLogPage": "traffic.md#log",
    "aracnaTranscriptPage": "traffic.md#traffic",
    "aracnaDemoPanel": "simulators.md#the-simulated-aracna",
    "aracnaPlaybackWindow": "aracna.md#recordings",
}


def message_help() -> MessageHelp:
    return MessageHelp([*texts_of(ErrorCode), *texts_of(PortFault)])
