"""A dock with a map tool of its own, and the button that takes it and gives back the one before."""
from __future__ import annotations

from html import escape

from qgis.core import Qgis
from qgis.gui import QgisInterface, QgsDockWidget, QgsMapTool
from qgis.PyQt import sip
from qgis.PyQt.QtGui import QIcon
from qgis.PyQt.QtWidgets import QAction

from ..resources import icon_path
from ..translation import tr
from .drawing_tool import DrawingTool

_MESSAGE_SECONDS = 8


class ToolDock(QgsDockWidget):
    """``close_desk`` lets go of all that a dock owns."""

    tool: DrawingTool
    draw: QAction
    """Checked as long as the tool is the canvas's."""

    def __init__(self, iface: QgisInterface, title: str, name: str) -> None:
        super().__init__(title, iface.mainWindow())
        self.setObjectName(name)
        self._iface = iface
        self._canvas = iface.mapCanvas()

    @property
    def standard_width(self) -> int:
        """Pixels at which nothing is cut off on the right of the map."""
        return max(420, 46 * self.fontMetrics().averageCharWidth())

    @property
    def is_wide(self) -> bool:
        """Whether its parts stand better side by side than one above the other."""
        return bool(self.width() > 1.4 * self.height())

    def close_desk(self) -> None:
        """Leave nothing behind: map tool, canvas items, connections, tasks."""
        self._canvas.mapToolSet.disconnect(self._tool_set)
        self._leave_tool()
        self.tool.close()

    def _offer_tool(self, tool: DrawingTool, icon: str, tip: str) -> None:
        """Make the button of a tool."""
        self.tool = tool
        self.draw = QAction(QIcon(icon_path(icon)), tr("Draw"), self)
        self.draw.setToolTip(tip)
        self.draw.setCheckable(True)
        self.draw.triggered.connect(self._toggle_tool)
        tool.finished.connect(self._leave_tool)
        self._canvas.mapToolSet.connect(self._tool_set)

    def _toggle_tool(self, checked: bool) -> None:
        if checked:
            current = self._canvas.mapTool()
            self.tool.previous = current.previous if isinstance(current, DrawingTool) else current
            self._canvas.setMapTool(self.tool)
        else:
            self._leave_tool()

    def _leave_tool(self) -> None:
        """The tool of before, where ours is the canvas's; another plugin may have deleted it since."""
        if self._canvas.mapTool() is not self.tool:
            return
        previous = self.tool.previous
        if previous is not None and not sip.isdeleted(previous):
            self._canvas.setMapTool(previous)
        else:
            self._canvas.unsetMapTool(self.tool)

    def _tool_set(self, tool: QgsMapTool, _old: QgsMapTool | None = None) -> None:
        self.draw.setChecked(tool is self.tool)

    def _show_message(self, text: str, level: int) -> None:
        """Plain words: what others called their layers is no markup, as which the bar takes all it is given."""
        self._show_markup(escape(text, quote=False), level)

    def _show_markup(self, text: str, level: int) -> None:
        self._iface.messageBar().pushMessage(tr("Seam Inspector"), text, Qgis.MessageLevel(level), _MESSAGE_SECONDS)
