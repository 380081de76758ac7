"""Write the icon as a file for Windows or macOS.

.venv/bin/python packaging/icons.py FILE.ico|FILE.icns
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
    """Return the icon as a PNG. `size`: width and height in pixels."""
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


def encode_ico() -> bytes:
    """Return the icon for Windows: a table, then a PNG of each size."""
    pictures = [draw_png(size) for size in ICO_SIZES]
    table = struct.pack("<HHH", 0, 1, len(pictures))
    offset = len(table) + 16 * len(pictures)
    for size, picture in zip(ICO_SIZES, pictures, strict=True):
        # The format encodes a side of 256 pixels as 0.
        table += struct.pack("<BBBBHHII", size % 256, size % 256, 0, 0, 1, 32, len(picture), offset)
        offset += len(picture)
    return table + b"".join(pictures)


def encode_icns() -> bytes:
    """Return the icon for macOS: type, length and PNG per size."""
    pictures = {kind: draw_png(size) for kind, size in ICNS_TYPES.items()}
    body = b"".join(
        kind + struct.pack(">I", 8 + len(data)) + data for kind, data in pictures.items()
    )
    return b"icns" + struct.pack(">I", 8 + len(body)) + body


def write_icon(path: Path) -> None:
    """Write the icon in the format of the suffix."""
    app = QGuiApplication.instance() or QGuiApplication([])
    encoders: dict[str, Callable[[], bytes]] = {".ico": encode_ico, ".icns": encode_icns}
    path.write_bytes(encoders[path.suffix]())
    del app


if __name__ == "__main__":
    write_icon(Path(sys.argv[1]))
