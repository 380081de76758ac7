"""Boxes without a tick can be seen in every theme."""

import pytest
from PySide6.QtWidgets import QCheckBox, QStyle, QStyleOptionButton

from tests.support.colours import contrast
from tests.support.window import WindowDriver
from trex_gui.ui.theme.theme import SCHEMES, Scheme, theme


def outline_contrast(box: QCheckBox) -> float:
    """Return the contrast of a box's left edge to its inside."""
    option = QStyleOptionButton()
    option.initFrom(box)
    place = box.style().subElementRect(QStyle.SubElement.SE_CheckBoxIndicator, option, box)
    picture, centre = box.grab().toImage(), place.center()
    edge = [picture.pixelColor(place.left() + x, centre.y()) for x in range(3)]
    return max(contrast(color, picture.pixelColor(centre)) for color in edge)


@pytest.mark.parametrize("scheme", SCHEMES)
def test_unticked_boxes_have_a_visible_outline(window: WindowDriver, scheme: Scheme) -> None:
    before = theme().choice
    theme().set_scheme(scheme)
    try:
        pages = window.window.pages
        for index in range(pages.count()):
            pages.setCurrentIndex(index)
        boxes = [box for box in window.find_all(QCheckBox) if not box.isChecked()]
        assert len(boxes) > 10
        weak = {box.objectName(): outline_contrast(box) for box in boxes}
        assert {name: found for name, found in weak.items() if found < 3} == {}
    finally:
        theme().set_scheme(before)
