"""Dialogs that load, compare and convert a settings file."""

from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

from PySide6.QtCore import Qt, SignalInstance
from PySide6.QtWidgets import QWidget

from trex_gui.core.errors import BadRequest, StudioError
from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.settings.document import SettingsDocument
from trex_gui.devices.trex.model.settings.draft import diff_against_draft
from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.devices.trex.settings.comparison import Comparison, compare
from trex_gui.devices.trex.settings.conversion import Conversion, convert
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.edit_in_place import amend
from trex_gui.devices.trex.settings.writer import write_settings
from trex_gui.devices.trex.views.changes.dialog import Changes, ChangesDialog, Names, Rows, TickedOf
from trex_gui.ui.translations import error_sentence
from trex_gui.ui.widgets.builders import button, combo_box, label, no_mnemonic, row

_MAX_NAMES = 3  # number of settings named in a text; the others are only counted

GetSettings = Callable[[], Settings | None]
Report = Callable[[str], object]


def load_dialog(
    device: Device,
    document: SettingsDocument,
    parent: QWidget,
    *,
    on_staged: Report,
    on_ended: Report,
    side: str = "",
    edit: Callable[[], object] | None = None,
) -> ChangesDialog:
    """Create the dialog that loads a document as edits.

    `on_staged` is called with a message when the changes have become edits. `on_ended` is called
    with a message when the board has been disconnected. `side` is the heading of the document's
    values, `File` by default. `edit` is called to open the file in the editor instead.
    """
    # Read now, because the document may be edited or deleted while the dialog is open.
    name, settings, findings = document.name, document.settings, document.findings
    draft = device.draft

    def describe(ticked_of: TickedOf) -> Changes | None:
        state = device.state
        if state is None:
            on_ended(tr("{0} was not loaded: the board is no longer connected.").format(name))
            return None
        heading = tr("Load settings from {0}").format(name)
        if settings is None:
            problem = tr("This file cannot be used: it has errors. Nothing was changed.")
            return Changes(heading, remarks=findings, problem=problem)
        board = state.signature
        conversion = convert(settings, board.model, board.firmware)
        is_converted = settings.product != board.model or conversion.has_changes
        # Without a firmware version, settings of newer firmware do not count as missing.
        loaded = conversion.settings if is_converted else replace(settings, firmware=None)
        try:
            comparison = diff_against_draft(draft, loaded)
        except BadRequest as error:
            return Changes(heading, remarks=findings, problem=error_sentence(error))
        present = tuple(row for row in comparison.rows if not row.is_missing)
        rows = replace(comparison, rows=present)
        source = f"{settings.product.name} {settings.firmware or ''}".rstrip()
        caption = tr("The file is for a {0}, and the board is a {1}. Checked changes become edits.")
        changes = (str(row) for row in conversion.rows if row.reason)
        altered = [conversion.summary(), *changes] if is_converted else []
        count = len(ticked_of(rows))
        return Changes(
            heading,
            caption=caption.format(source, board),
            rows=rows,
            sides=(tr("Board, as shown"), side or tr("File")),
            remarks=(*findings, *altered, *_missing(comparison)),
            action=tr("&Load %n change(s)", "", count),
            can_act=count > 0 and device.is_writable,
        )

    def load(rows: Rows) -> None:
        try:
            draft.stage(rows, tr("Load {0}").format(name))
        except BadRequest as error:
            dialog.show_problem(error_sentence(error))
            return
        count = min(len(rows), draft.pending)  # a row may have reverted an edit
        text = tr("{0}: %n change(s) pending. Review them, then write.", "", count)
        nothing = tr("{0}: {1}").format(name, tr("Nothing to write."))
        on_staged(text.format(name) if count else nothing)
        dialog.close()

    dialog = ChangesDialog(
        device,
        parent,
        names=Names("loadSettingsDialog", "load", "takeChangesButton", "cancelLoadButton"),
        describe=describe,
        on_action=load,
        refresh_on=(draft.pending_changed, draft.loaded, device.link_changed, device.state_changed),
    )
    dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    if edit is not None:
        text = tr("&Edit the file instead")
        edit_button = button(dialog, "editFileButton", text, default=False, on_click=dialog.close)
        edit_button.clicked.connect(edit)
        dialog.add_beside_buttons(edit_button)
    return dialog


def _missing(comparison: Comparison) -> Iterator[str]:
    if missing := [row.name for row in comparison.rows if row.is_missing]:
        names = ", ".join(missing[:_MAX_NAMES])
        if len(missing) > _MAX_NAMES:
            names = tr("{0} and {1} more").format(names, len(missing) - _MAX_NAMES)
        yield tr("Not in the file and therefore unchanged: {0}.").format(names)


def show_comparison(
    device: Device,
    document: SettingsDocument,
    get_other: GetSettings,
    other_name: str,
    parent: QWidget,
    *,
    on_copied: Report,
    other_changed: SignalInstance | None = None,
) -> None:
    """Open a dialog that compares a document with the settings that `get_other` returns.

    `other_changed` is emitted when these settings have changed. `on_copied` is called with a
    message when the user has copied values into the document as edits.
    """
    other_settings: Settings | None = None

    def describe(ticked_of: TickedOf) -> Changes | None:
        nonlocal other_settings
        # Keep the last settings after a disconnection.
        other_settings = get_other() or other_settings
        own_settings, problem = document.settings, ""
        heading = tr("{0} and {1}").format(document.name, other_name)
        if own_settings is None or other_settings is None:
            return Changes(heading, close=tr("Close"))
        try:
            rows = diff_against_draft(document.draft, other_settings)
        except BadRequest as error:
            problem, rows = error_sentence(error), compare(own_settings, other_settings)
        count = len(ticked_of(rows))
        text = tr("%n setting(s) differ, {0} match.", "", len(rows.differing))
        action = tr("&Copy %n value(s) to {0}", "", count).format(no_mnemonic(document.name))
        return Changes(
            heading,
            rows=rows,
            sides=(document.name, other_name),
            with_ticks=not problem,
            summary=text.format(rows.equal),
            problem=problem,
            action="" if problem else action,
            can_act=count > 0,
            close=tr("Close"),
            is_close_default=True,
        )

    def copy(rows: Rows) -> None:
        try:
            document.draft.stage(rows, tr("Copy values from {0}").format(other_name))
        except BadRequest as error:
            dialog.show_problem(error_sentence(error))
        else:
            on_copied(tr("%n value(s) copied from {0}.", "", len(rows)).format(other_name))

    dialog = ChangesDialog(
        device,
        parent,
        names=Names("compareDialog", "compare", "takeValuesButton", "closeCompareButton"),
        describe=describe,
        on_action=copy,
        refresh_on=(document.changed, *([] if other_changed is None else [other_changed])),
    )
    dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    dialog.reset_and_show()


def show_conversion(
    device: Device,
    document: SettingsDocument,
    parent: QWidget,
    on_converted: Callable[[SettingsDocument], object],
) -> None:
    boards = [(m, firmware) for m in device_table().models for firmware in m.firmware[::-1]]
    text = tr("{0}, firmware {1}")
    items = [(text.format(board.name, firmware), (board, firmware)) for board, firmware in boards]
    above = QWidget(parent)
    choice = combo_box(above, "convertBoard", "", items=items)
    row(label(above, text=tr("Convert &for:"), buddy=choice), choice, 1, into=above, margins=0)
    # Preselect the connected board. If no board is connected, or if the file is for this board,
    # preselect the other model.
    before, state = document.settings, device.state if device.is_connected else None
    own = None if before is None else (before.product, before.specs.firmware)
    models = [model for model in device_table().models if own is None or model != own[0]]
    preselected = models[0], models[0].firmware[-1]
    if state is not None and (state.signature.model, state.signature.firmware) != own:
        preselected = state.signature.model, state.signature.firmware
    choice.setCurrentIndex(boards.index(preselected))

    def conversion() -> Conversion | None:
        model, firmware = choice.currentData()
        settings = document.settings
        return None if settings is None else convert(settings, model, firmware)

    def describe(_ticked_of: TickedOf) -> Changes:
        caption = tr(
            "Opens the converted settings as a new file with the same comments. {0} is not changed."
        )
        heading, action = tr("Convert {0}").format(document.name), tr("&Convert")
        converted, settings = conversion(), document.settings
        if converted is None or settings is None:
            return Changes(heading, action=action)
        return Changes(
            heading,
            caption=caption.format(document.name),
            rows=converted.compared_with(settings),
            sides=(tr("In the file"), tr("For a {0}").format(converted.board)),
            with_ticks=False,
            outcomes={row.key: row.reason for row in converted.rows if row.reason},
            summary=converted.summary(),
            action=action,
            can_act=True,
        )

    def on_convert_clicked(_rows: Rows) -> None:
        converted = conversion()
        if converted is None:
            return
        try:
            text = amend(document.text, converted.settings, document.name)
        except StudioError:  # the text cannot be edited in place
            text = write_settings(converted.settings)
        name = f"{Path(document.name).stem}_{converted.settings.product.key}.txt"
        on_converted(SettingsDocument(text, name))
        dialog.close()

    dialog = ChangesDialog(
        device,
        parent,
        names=Names("convertDialog", "convert", "convertButton", "cancelConvertButton"),
        describe=describe,
        on_action=on_convert_clicked,
        refresh_on=(document.changed,),
        above=above,
    )
    dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    choice.activated.connect(dialog.refresh)
    dialog.reset_and_show()
