"""Record the animation of the README, as an animated PNG.

The script connects a demo board in the real window, shows its channels, drives its motors and
stops them. A mouse pointer is drawn over the frames.
"""

import struct
import sys
import zlib
from collections.abc import Iterator
from itertools import count
from pathlib import Path

import numpy as np
from bootstrap import ROOT
from pictures import common_colours, demonstration, indexed, pixels
from PySide6.QtCore import QCoreApplication, QObject, QPoint, QPointF, QSize, Qt, QTimer, Signal
from PySide6.QtGui import QColor, QImage, QPainter, QPolygonF
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QWidget

from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.program import Program

FILE = ROOT / "packaging" / "docs" / "demo.png"
SIZE = QSize(1060, 660)
RATE = 8  # frames per second
COLOURS = 250
MAX_SIZE = 1_500_000  # bytes
GLIDE_FRAMES = 5  # duration of a movement of the pointer
LEFT = Qt.MouseButton.LeftButton
ARROW = [(0, 0), (0, 17), (4, 13), (7, 20), (10, 19), (7, 12), (13, 12)]  # corners


class Film(QObject):
    """Plays the script and records a frame per step."""

    finished = Signal()

    def __init__(self, program: Program) -> None:
        super().__init__()
        self.frames: list[QImage] = []
        self._program = program
        self._window = program.window
        self._pointer = QPointF(600, 420)
        self._script = self._scenes()
        self._timer = QTimer(self)
        self._timer.timeout.connect(self._step)

    def start(self) -> None:
        self._window.resize(SIZE)
        self._timer.start(1000 // RATE)

    def _step(self) -> None:
        try:
            next(self._script)
        except StopIteration:
            self._timer.stop()
            self.finished.emit()
            return
        except Exception:
            QCoreApplication.exit(1)
            raise
        image = self._window.grab().toImage()
        with QPainter(image) as painter:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            painter.setPen(QColor("white"))
            painter.setBrush(QColor("black"))
            painter.drawPolygon(QPolygonF([self._pointer + QPointF(*point) for point in ARROW]))
        self.frames.append(image)

    def _scenes(self) -> Iterator[None]:
        manager = self._program.device_manager
        yield from self._wait(1.0)
        yield from self._click("startDemo")
        while manager.current.link is not ConnectionState.CONNECTED:
            yield
        yield from self._wait(2.0)
        yield from self._show_page(1)
        yield from self._wait(2.5)
        yield from self._show_page(2)
        yield from self._wait(0.5)
        yield from self._click("runButton")
        yield from self._wait(0.5)
        yield from self._drive()
        yield from self._click("stopButton")
        yield from self._wait(1.5)
        yield from self._show_page(0)
        yield from self._wait(1.5)

    def _drive(self) -> Iterator[None]:
        """Drag the pad forward, then to the right."""
        pad = self._find("drivePad")
        middle = pad.rect().center()
        yield from self._glide(pad, middle)
        QTest.mousePress(pad, LEFT, Qt.KeyboardModifier.NoModifier, middle)
        for x, y in [(0, -30), (0, -60), (0, -60), (25, -55), (45, -40), (45, -40), (20, -55)]:
            for _ in range(RATE // 2):
                self._point(pad, middle + QPoint(x, y))
                QTest.mouseMove(pad, middle + QPoint(x, y))
                yield
        QTest.mouseRelease(pad, LEFT, Qt.KeyboardModifier.NoModifier, middle)

    @staticmethod
    def _wait(seconds: float) -> Iterator[None]:
        yield from [None] * round(seconds * RATE)

    def _find(self, name: str) -> QWidget:
        children = self._window.findChildren(QWidget, name)
        return next(child for child in children if child.isVisible())

    def _point(self, widget: QWidget, position: QPoint) -> None:
        self._pointer = QPointF(widget.mapTo(self._window, position))

    def _glide(self, widget: QWidget, position: QPoint) -> Iterator[None]:
        start = self._pointer
        end = QPointF(widget.mapTo(self._window, position))
        for frame in range(1, GLIDE_FRAMES + 1):
            self._pointer = start + (end - start) * frame / GLIDE_FRAMES
            yield

    def _click(self, name: str) -> Iterator[None]:
        button = self._find(name)
        yield from self._glide(button, button.rect().center())
        QTest.mouseClick(button, LEFT)
        yield

    def _show_page(self, number: int) -> Iterator[None]:
        """Click a page in the bar at the left. Numbers start at 0."""
        bar = self._program.workspace("trex").pages.bar
        position = bar.tabRect(number).center()
        yield from self._glide(bar, position)
        QTest.mouseClick(bar, LEFT, Qt.KeyboardModifier.NoModifier, position)
        yield


def save(frames: list[QImage], path: Path) -> None:
    """Save frames as an animated PNG. Unchanged pixels of a frame are transparent.

    Ref: PNG specification, third edition, 11.3.6 (animation).
    """
    images = [pixels(frame) for frame in frames]
    table = common_colours(np.vstack(images[:: len(images) // 8]), COLOURS)
    indices = [indexed(image, table) for image in images]
    height, width = indices[0].shape
    png = [
        b"\x89PNG\r\n\x1a\n",
        _chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 3, 0, 0, 0)),
        _chunk(b"acTL", struct.pack(">II", len(indices), 0)),
        _chunk(
            b"PLTE",
            b"".join(bytes([c >> 16 & 255, c >> 8 & 255, c & 255]) for c in [*table.tolist(), 0]),
        ),
        _chunk(b"tRNS", bytes([255] * len(table) + [0])),
    ]
    sequence_numbers = count()
    for number, frame in enumerate(indices):
        changed = frame != indices[number - 1] if number else np.full(frame.shape, True)
        rows, columns = np.flatnonzero(changed.any(1)), np.flatnonzero(changed.any(0))
        top, bottom = (rows[0], rows[-1] + 1) if rows.size else (0, 1)
        left, right = (columns[0], columns[-1] + 1) if columns.size else (0, 1)
        part = np.where(changed, frame, len(table)).astype(np.uint8)[top:bottom, left:right]
        size = (right - left, bottom - top, left, top)
        control = struct.pack(
            ">IIIIIHHBB", next(sequence_numbers), *size, 1, RATE, 0, int(number > 0)
        )
        data = zlib.compress(np.pad(part, ((0, 0), (1, 0))).tobytes(), 9)
        png.append(_chunk(b"fcTL", control))
        if number:
            png.append(_chunk(b"fdAT", struct.pack(">I", next(sequence_numbers)) + data))
        else:
            png.append(_chunk(b"IDAT", data))
    path.write_bytes(b"".join([*png, _chunk(b"IEND", b"")]))


def _chunk(kind: bytes, data: bytes) -> bytes:
    checksum = zlib.crc32(kind + data)
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", checksum)


def main() -> int:
    with demonstration() as (application, program):
        film = Film(program)
        film.finished.connect(QCoreApplication.quit)
        film.start()
        if application.exec():
            return 1
        save(film.frames, FILE)
    seconds, size = len(film.frames) / RATE, FILE.stat().st_size
    print(f"{FILE}: {seconds:.1f} s, {size / 1e6:.2f} of at most {MAX_SIZE / 1e6:.2f} MB")
    return 0 if size <= MAX_SIZE else 1


if __name__ == "__main__":
    sys.exit(main())
