"""What draws itself can be read, whatever the theme leaves in its palette."""
from __future__ import annotations

from collections.abc import Iterator

import pytest
from qgis.PyQt.QtCore import QRect
from qgis.PyQt.QtGui import QColor, QPalette
from qgis.PyQt.QtWidgets import QApplication, QTabWidget, QWidget
from seam_inspector.plugin.toolkit.desk.theme import contrast, readable_palette
from seam_inspector.plugin.toolkit.desk.widgets import ClippedLabel

READABLE = 3.0
# as Night Mapping has it: colours for QGIS's kinds of widgets, dark on nothing for all others
SHEET = """
QWidget { background: transparent; }
QLabel { color: #aaaaaa; }
QTabWidget, QAbstractScrollArea { color: #aaaaaa; background-color: #323232; }
"""


@pytest.fixture
def night(qgis_app: QApplication) -> Iterator[None]:
    before, sheet = QApplication.palette(), qgis_app.styleSheet()
    dark = QPalette(before)
    for role in (QPalette.ColorRole.WindowText, QPalette.ColorRole.Text):
        dark.setColor(role, QColor("#111111"))
    dark.setColor(QPalette.ColorRole.Base, QColor("#222222"))
    QApplication.setPalette(dark)
    qgis_app.setStyleSheet(SHEET)
    yield
    qgis_app.setStyleSheet(sheet)
    QApplication.setPalette(before)


def ink(widget: QWidget, box: QRect) -> float:
    """The strongest contrast in a part of a widget with its lower right corner, where nothing is written."""
    image = widget.grab(box).toImage()
    back = image.pixelColor(image.width() - 1, image.height() - 1)
    colours = {image.pixel(x, y) for x in range(image.width()) for y in range(image.height())}
    return max(contrast(QColor(colour), back) for colour in colours)


@pytest.mark.parametrize(
    ("colour", "other", "ratio"), [("#000000", "#ffffff", 21), ("#777777", "#ffffff", 4.48), ("#123456", "#123456", 1)]
)
def test_contrast_is_that_of_wcag(colour: str, other: str, ratio: float) -> None:
    assert contrast(QColor(colour), QColor(other)) == pytest.approx(ratio, abs=0.01)
    assert contrast(QColor(other), QColor(colour)) == pytest.approx(ratio, abs=0.01)


def test_without_a_readable_palette_around_it_is_the_widget_s_own(qgis_app: QApplication) -> None:
    widget = QWidget()
    assert readable_palette(widget) == widget.palette()


@pytest.mark.usefixtures("night")
def test_sentences_in_a_theme_of_style_sheets() -> None:
    """Also those that come long after the theme."""
    tabs, label = QTabWidget(), ClippedLabel(1)
    label.setText("Detail at level 1 is 83 %")
    tabs.resize(600, 400)
    tabs.show()
    QApplication.processEvents()
    tabs.addTab(label, "sentence")
    tabs.setCurrentWidget(label)
    QApplication.processEvents()
    assert ink(label, label.rect()) > READABLE
    tabs.deleteLater()


@pytest.mark.usefixtures("night")
def test_a_theme_that_changes_is_followed(qgis_app: QApplication) -> None:
    tabs, label = QTabWidget(), ClippedLabel(1)
    tabs.addTab(label, "sentence")
    tabs.show()
    assert readable_palette(label).color(QPalette.ColorRole.Text).name() == "#aaaaaa"
    qgis_app.setStyleSheet(SHEET.replace("#aaaaaa", "#112233").replace("#323232", "#eeeeee"))
    assert readable_palette(label).color(QPalette.ColorRole.Text).name() == "#112233"
    tabs.deleteLater()
