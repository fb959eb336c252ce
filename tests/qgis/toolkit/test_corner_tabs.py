"""Buttons in the corner of tabs are whole, however low the tabs are."""
from __future__ import annotations

from qgis.PyQt.QtCore import QSize
from qgis.PyQt.QtGui import QIcon, QPixmap
from qgis.PyQt.QtWidgets import QTabWidget, QToolButton, QWidget
from seam_inspector.plugin.toolkit.desk.widgets import CornerTabs


def height_of_the_corner(tabs: QTabWidget) -> tuple[int, int]:
    button = QToolButton()
    button.setIcon(QIcon(QPixmap(60, 60)))
    button.setIconSize(QSize(60, 60))
    tabs.setCornerWidget(button)
    tabs.addTab(QWidget(), "one")
    tabs.setDocumentMode(True)
    tabs.resize(300, 200)
    tabs.show()
    tabs.hide()
    return button.height(), button.sizeHint().height()


def test_the_corner_is_not_cut(qgis_app: object) -> None:
    tabs = CornerTabs()
    height, asked = height_of_the_corner(tabs)
    assert height >= asked
    assert height_of_the_corner(QTabWidget())[0] < asked


def test_tabs_without_a_corner_are_qts_own(qgis_app: object) -> None:
    ours, plain = CornerTabs(), QTabWidget()
    for tabs in (ours, plain):
        tabs.addTab(QWidget(), "one")
    assert ours.tabBar().sizeHint() == plain.tabBar().sizeHint()
