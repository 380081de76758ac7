"""Names of the headers of tables and trees, which Qt gives none."""

from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtWidgets import QAbstractItemView, QHeaderView


def name_headers(view: QAbstractItemView) -> None:
    """Say of each header what it is; which table it belongs to says the table."""
    for header in view.findChildren(QHeaderView, options=Qt.FindChildOption.FindDirectChildrenOnly):
        across = header.orientation() is Qt.Orientation.Horizontal
        header.setAccessibleName(_tr("Columns") if across else _tr("Rows"))


def _tr(text: str) -> str:
    return QCoreApplication.translate("header_names", text)
