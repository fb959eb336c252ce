"""Where detail was lost, on the map: the button and key that show it, its pictures, and the chart's distances."""
from __future__ import annotations

from typing import TYPE_CHECKING

from qgis.gui import QgisInterface
from qgis.PyQt import sip
from qgis.PyQt.QtCore import QObject, Qt
from qgis.PyQt.QtGui import QIcon, QKeySequence
from qgis.PyQt.QtWidgets import QAction

from ....toolkit.resources import icon_path
from ....toolkit.translation import tr
from .loss_overlay import LossOverlay
from .profile_on_map import ProfileOnMap

if TYPE_CHECKING:
    from ..profile.profile_panel import ProfilePanel
    from ..session import Session


class LostDetail(QObject):
    """Owns all of it until ``close``."""

    def __init__(self, iface: QgisInterface, session: Session, parent: QObject) -> None:
        super().__init__(parent)
        self._window = iface.mainWindow()
        self.overlay = LossOverlay(iface.mapCanvas(), session, self)
        self.profile = ProfileOnMap(iface.mapCanvas(), session, self)
        self.action = QAction(QIcon(icon_path("loss")), tr("Lost detail"), parent)
        self.action.setToolTip(
            tr("Show where detail was lost, over the map and the images (L). One scale for all windows")
        )
        self.action.setCheckable(True)
        self.action.setShortcut(QKeySequence(Qt.Key.Key_L))  # text fields keep their letters
        self.action.setShortcutContext(Qt.ShortcutContext.WindowShortcut)
        self.action.toggled.connect(session.loss_view.show)
        session.loss_view.changed.connect(self.action.setChecked)
        self._window.addAction(self.action)  # the map's window, also while the dock floats in one of its own

    def follow_chart(self, panel: ProfilePanel) -> None:
        """What is pointed at in the chart is marked on the map, and the other way round."""
        panel.followed.connect(self.profile.follow)
        panel.pointed.connect(self.profile.highlight)
        self.profile.distanceChanged.connect(panel.mark)

    def close(self) -> None:
        """Take all off the canvas and the window."""
        if not sip.isdeleted(self._window):
            self._window.removeAction(self.action)
        self.profile.close()
        self.overlay.close()
