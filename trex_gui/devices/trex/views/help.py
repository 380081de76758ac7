"""Help topics for the pages, dialogs and messages of a TReX."""

from trex_gui.core.errors import PortFault
from trex_gui.devices.trex.board.errors import UNSEEN
from trex_gui.devices.trex.driving.blockers import DriveBlocker
from trex_gui.devices.trex.protocol.errors import ErrorCode
from trex_gui.ui.help.messages import MessageHelp, texts_of

GUIDE = "https://www.pololu.com/docs/0J1"

_FINDINGS = "messages.md#findings-about-settings"

TOPICS = {  # object name → help topic
    "boardPage": "status.md",
    "channelsPage": "channels.md",
    "motorsPage": "driving.md",
    "gamepadPanel": "driving.md#gamepad",
    "currentsPage": "currents.md",
    "parametersPage": "settings.md#parameters",
    "diagnosticsPage": "traffic.md",
    "errorsPage": "traffic.md#problems",
    "trexLogPage": "traffic.md#log",
    "transcriptPage": "traffic.md#traffic",
    "startPanel": "first_steps.md",
    "demoPanel": "simulators.md",
    "boardPanel": "connecting.md#several-boards-on-one-line",
    "calibrationFindings": _FINDINGS,
    "parameterFindings": _FINDINGS,
    # Dialogs and other windows
    "boardsFindings": _FINDINGS,
    "loadFindings": _FINDINGS,
    "reviewFindings": _FINDINGS,
    "textFindings": _FINDINGS,
    "applyToBoardsDialog": "connecting.md#several-boards-on-one-line",
    "benchDialog": "currents.md#bench-test",
    "checkDialog": "lost_settings.md",
    "compareDialog": "settings.md#settings-files",
    "convertDialog": "settings.md#settings-files",
    "gamepadDialog": "driving.md#gamepad",
    "historyDialog": "settings.md#history",
    "learnDialog": "channels.md#learn-channels",
    "lineSettingsDialog": "connecting.md#line-settings",
    "loadSettingsDialog": "settings.md#settings-files",
    "newSettingsDialog": "settings.md#settings-files",
    "numberDialog": "connecting.md#several-boards-on-one-line",
    "playbackWindow": "currents.md#recordings",
    "plotWindow": "currents.md",
    "powerCycleDialog": "settings.md#edit-review-apply",
    "robotsDialog": "remote.md#many-robots",
    "groupDialog": "connecting.md#boards-that-are-driven-together",
    "provisionDialog": "command_line.md#boards-in-turn",
    "reviewDialog": "settings.md#edit-review-apply",
    "settingsEditor": "settings.md#settings-files",
    "setupDialog": "first_steps.md#set-up-the-robot",
    "armDialog": "safety.md#does-the-serial-timeout-stop-your-motors",
    "parameterWire": "settings.md#limits-that-are-inferred",
}


def message_help() -> MessageHelp:
    texts = [*(blocker.text for blocker in DriveBlocker), *(entry.name for entry in UNSEEN)]
    return MessageHelp([*texts_of(ErrorCode), *texts_of(PortFault), *texts])
