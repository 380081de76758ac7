"""Create the pictures of the help, with a connected demo board.

Also writes `digests.json`: picture name without colour scheme → digest of its constant texts.
`tests/test_app.py` compares these digests with the window.
"""

import hashlib
import json
import re
import sys
import tempfile
from collections.abc import Collection, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

import numpy as np
from PySide6.QtCore import QCoreApplication, QSize, Qt
from PySide6.QtGui import QImage
from PySide6.QtWidgets import (
    QAbstractButton,
    QApplication,
    QDialog,
    QDockWidget,
    QGroupBox,
    QHeaderView,
    QLabel,
    QStackedWidget,
    QTabBar,
    QWidget,
)

from trex_gui import composition
from trex_gui.app import load_hidden_parts
from trex_gui.ui.devices.demo_panel import DemoDock
from trex_gui.ui.program import Program
from trex_gui.ui.theme.theme import Scheme, theme
from trex_gui.ui.tour import Tour
from trex_gui.ui.translations import ENGLISH, install_translations
from trex_gui.ui.workers.threads import GuiThreadCollector

HELP = Path(__file__).resolve().parent.parent / "resources" / "help"
PICTURES = HELP / "pictures"
SIZE = QSize(1060, 700)


def fixed_texts(widget: QWidget) -> Iterator[str]:
    """Yield the constant names and texts of a widget.

    Omits measurements: digits, and labels of a page that have an object name. Also omits hidden
    pages of stacks, docks, and child windows.
    """
    if widget.objectName() and not widget.objectName().startswith("qt_"):
        yield f"{type(widget).__name__} {widget.objectName()}"
    yield from filter(None, (re.sub(r"[^\w ]|\d", "", text).strip() for text in _texts(widget)))
    # `children` would invalidate the Python wrappers of actions.
    direct = Qt.FindChildOption.FindDirectChildrenOnly
    for child in widget.findChildren(QWidget, options=direct):
        if child.isWindow() or isinstance(child, QDockWidget) or child.objectName() == "focusFrame":
            continue
        if isinstance(widget, QStackedWidget) and child is not widget.currentWidget():
            continue
        yield from fixed_texts(child)


def _texts(widget: QWidget) -> Iterator[str]:
    match widget:
        case QLabel() if not widget.objectName() or isinstance(widget.window(), QDialog):
            yield widget.text()
        case QAbstractButton():
            yield widget.text()
        case QGroupBox():
            yield widget.title()
        case QTabBar():
            yield from map(widget.tabText, range(widget.count()))
        case QHeaderView() if (model := widget.model()) is not None:
            for section in range(widget.count()):
                if widget.orientation() is Qt.Orientation.Horizontal:
                    yield str(model.headerData(section, widget.orientation()) or "")


class HelpTour(Tour):
    """Writes the wanted pictures, or all pictures.

    `digests`: picture name without colour scheme → digest of its content.
    """

    def __init__(
        self,
        program: Program,
        folder: Path,
        schemes: Sequence[Scheme] = ("light", "dark"),
        *,
        size: QSize = SIZE,
        wanted: Collection[str] | None = None,
    ) -> None:
        super().__init__(program, folder, schemes, size=size)
        self.digests: dict[str, str] = {}
        self._wanted = wanted

    def write(self, widget: QWidget, name: str, scheme: Scheme) -> bool:
        if self._wanted is not None and name not in self._wanted:
            return True
        text = "\n".join(sorted(fixed_texts(widget)))
        self.digests[name] = hashlib.sha256(text.encode()).hexdigest()[:16]
        return super().write(widget, name, scheme)


def wanted_pictures() -> set[str]:
    """Return the names of linked pictures, without colour scheme."""
    pages = [*HELP.glob("*.md"), HELP.parent.parent / "README.md"]
    link = re.compile(r"pictures/(\S+?)-light\.png")
    return {name for page in pages for name in link.findall(page.read_text(encoding="utf-8"))}


def pixels(image: QImage) -> np.ndarray:
    """Return the pixels of an image as rows of 0xFFRRGGBB."""
    plain = image.convertToFormat(QImage.Format.Format_RGB32)
    return np.frombuffer(plain.constBits(), np.uint32).reshape(plain.height(), plain.width()).copy()


def common_colours(image: np.ndarray, count: int) -> np.ndarray:
    """Return the `count` most frequent colours of an image."""
    colours, counts = np.unique(image, return_counts=True)
    return colours[np.argsort(-counts, kind="stable")[:count]]


def indexed(image: np.ndarray, table: np.ndarray) -> np.ndarray:
    """Return the index of each pixel's nearest colour in `table`."""
    colours, inverse = np.unique(image, return_inverse=True)

    def parts(values: np.ndarray) -> np.ndarray:
        return np.stack([(values >> shift & 255).astype(np.int32) for shift in (0, 8, 16)], -1)

    distance = ((parts(colours)[:, None] - parts(table)[None]) ** 2).sum(-1)
    return distance.argmin(1).astype(np.uint8)[inverse].reshape(image.shape)


def with_few_colours(image: QImage) -> QImage:
    """Return an image with at most 256 colours. Its file has a third of the size."""
    image_pixels = pixels(image)
    table = common_colours(image_pixels, 256)
    size = (image.width(), image.height(), image.width())
    indices = indexed(image_pixels, table).tobytes()
    result = QImage(indices, *size, QImage.Format.Format_Indexed8).copy()
    result.setColorTable([int(colour) for colour in table])
    return result


@contextmanager
def demonstration() -> Iterator[tuple[QApplication, Program]]:
    """Open the window in English, without the panels of the demos."""
    application = QApplication([])
    install_translations(application, ENGLISH)
    theme().install(application)
    collector = GuiThreadCollector(application)
    collector.setObjectName("collector")
    program = composition.build()
    program.window.show()
    load_hidden_parts(program, collector)
    for dock in program.window.findChildren(DemoDock):
        dock.set_wanted(False)
    yield application, program
    program.close()


def main() -> int:
    names = wanted_pictures()
    with demonstration() as (application, program), tempfile.TemporaryDirectory() as folder:
        tour = HelpTour(program, Path(folder), wanted=names)
        tour.finished.connect(lambda ok: QCoreApplication.exit(0 if ok else 1))
        tour.start()
        if application.exec() != 0 or tour.digests.keys() != names:
            missing = sorted(names - tour.digests.keys())
            sys.stderr.write(f"The tour is not complete. Missing pictures: {missing}\n")
            return 1
        PICTURES.mkdir(exist_ok=True)
        written = {path.name for path in Path(folder).glob("*.png")}
        for name in written:
            with_few_colours(QImage(str(Path(folder) / name))).save(str(PICTURES / name), "PNG", 0)
        for path in PICTURES.glob("*.png"):
            if path.name not in written:
                path.unlink()
    digests = dict(sorted(tour.digests.items()))
    (PICTURES / "digests.json").write_text(json.dumps(digests, indent=1) + "\n", encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
