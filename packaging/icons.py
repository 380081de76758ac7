"""Draw the program's icon as a file for Windows (.ico) or macOS (.icns).

.venv/bin/python packaging/icons.py FILE
"""

import os
import struct
import sys
from collections.abc import Callable
from pathlib import Path

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

from PySide6.QtCore import QBuffer, QByteArray, QIODevice, Qt
from PySide6.QtGui import QGuiApplication, QImage, QPainter
from PySide6.QtSvg import QSvgRenderer

SOURCE = Path(__file__).resolve().parent.parent / "resources" / "icons" / "trex-studio.svg"
ICO_SIZES = (16, 24, 32, 48, 64, 128, 256)
ICNS_TYPES = {b"icp4": 16, b"icp5": 32, b"ic07": 128, b"ic08": 256, b"ic09": 512, b"ic10": 1024}


def draw_png(size: int) -> bytes:
    """Return the icon as a PNG of so many pixels."""
    image = QImage(size, size, QImage.Format.Format_ARGB32)
    image.fill(Qt.GlobalColor.transparent)
    painter = QPainter(image)
    QSvgRenderer(str(SOURCE)).render(painter)
    painter.end()
    data = QByteArray()
    buffer = QBuffer(data)
    buffer.open(QIODevice.OpenModeFlag.WriteOnly)
    image.save(buffer, "PNG")  # type: ignore[call-overload]
    return bytes(data.data())


def make_ico() -> bytes:
    """Return an icon for Windows: a table of its sizes, then a PNG for each."""
    pictures = [draw_png(size) for size in ICO_SIZES]
    table = struct.pack("<HHH", 0, 1, len(pictures))
    offset = len(table) + 16 * len(pictures)
    for size, picture in zip(ICO_SIZES, pictures, strict=True):
        # A side of 256 pixels is written as 0.
        table += struct.pack("<BBBBHHII", size % 256, size % 256, 0, 0, 1, 32, len(picture), offset)
        offset += len(picture)
    return table + b"".join(pictures)


def make_icns() -> bytes:
    """Return an icon for macOS: a PNG for each size, after its type and length."""
    pictures = {kind: draw_png(size) for kind, size in ICNS_TYPES.items()}
    body = b"".join(
        kind + struct.pack(">I", 8 + len(data)) + data for kind, data in pictures.items()
    )
    return b"icns" + struct.pack(">I", 8 + len(body)) + body


def write_icon(path: Path) -> None:
    """Write the icon in the format that the suffix names."""
    app = QGuiApplication.instance() or QGuiApplication([])
    makers: dict[str, Callable[[], bytes]] = {".ico": make_ico, ".icns": make_icns}
    path.write_bytes(makers[path.suffix]())
    del app


if __name__ == "__main__":
    write_icon(Path(sys.argv[1]))
