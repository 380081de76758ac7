"""Make the pictures of the help: those that its pages show, of a connected demo board.

`digests.json` beside them says what each shows; `tests/test_app.py` compares it with the window.
"""

import json
import re
import sys
import tempfile
from pathlib import Path

import numpy as np
from PySide6.QtCore import QCoreApplication, QSize
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QApplication

from trex_gui import composition
from trex_gui.app import complete
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.tour import Tour
from trex_gui.ui.translations import ENGLISH, install_translations
from trex_gui.ui.workers.threads import GuiThreadCollector

HELP = Path(__file__).resolve().parent.parent / "resources" / "help"
PICTURES = HELP / "pictures"
SIZE = QSize(1060, 700)
COLOURS = 256


def wanted_pictures() -> set[str]:
    """Return the pictures that the pages and the README show, without their schemes."""
    pages = [*HELP.glob("*.md"), HELP.parent.parent / "README.md"]
    link = re.compile(r"pictures/(\S+?)-light\.png")
    return {name for page in pages for name in link.findall(page.read_text(encoding="utf-8"))}


def with_few_colours(image: QImage) -> QImage:
    """Keep the most frequent colours and give other pixels the nearest: a third of the size."""
    plain = image.convertToFormat(QImage.Format.Format_RGB32)
    pixels = np.frombuffer(plain.constBits(), np.uint32).reshape(plain.height(), plain.width())
    colours, inverse, counts = np.unique(pixels, return_inverse=True, return_counts=True)
    kept = colours[np.argsort(-counts, kind="stable")[:COLOURS]]

    def parts(values: np.ndarray) -> np.ndarray:
        return np.stack([(values >> shift & 255).astype(np.int32) for shift in (0, 8, 16)], -1)

    distance = ((parts(colours)[:, None] - parts(kept)[None]) ** 2).sum(-1)
    indices = distance.argmin(1).astype(np.uint8)[inverse].reshape(pixels.shape)
    result = QImage(
        indices.tobytes(),
        plain.width(),
        plain.height(),
        plain.width(),
        QImage.Format.Format_Indexed8,
    ).copy()
    result.setColorTable([int(colour) | 0xFF000000 for colour in kept])
    return result


def main() -> int:
    names = wanted_pictures()
    app = QApplication([])
    install_translations(app, ENGLISH)
    theme().install(app)
    collector = GuiThreadCollector(app)
    collector.setObjectName("collector")
    program = composition.build()
    program.window.show()
    complete(program, collector)
    with tempfile.TemporaryDirectory() as folder:
        tour = Tour(program, Path(folder), size=SIZE, wanted=names, shows_docks=False)
        tour.finished.connect(lambda ok: QCoreApplication.exit(0 if ok else 1))
        tour.start()
        if app.exec() != 0 or tour.digests.keys() != names:
            missing = sorted(names - tour.digests.keys())
            sys.stderr.write(f"The tour was not completed. Missing: {missing}\n")
            return 1
        PICTURES.mkdir(exist_ok=True)
        made = {path.name for path in Path(folder).glob("*.png")}
        for name in made:
            with_few_colours(QImage(str(Path(folder) / name))).save(str(PICTURES / name), "PNG", 0)
        for path in PICTURES.glob("*.png"):
            if path.name not in made:
                path.unlink()
    digests = dict(sorted(tour.digests.items()))
    (PICTURES / "digests.json").write_text(json.dumps(digests, indent=1) + "\n", encoding="utf-8")
    program.close()
    return 0


if __name__ == "__main__":
    sys.exit(main())
