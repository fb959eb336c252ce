"""A dock with a map tool of its own, and the button that takes it and gives back the one before.

Its tools draw, follow the canvas's keys, and leave nothing on it. It tells messages in QGIS's bar, and many in its log.
"""
from __future__ import annotations

from collections.abc import Iterable
from html import escape

from qgis.core import Qgis, QgsMessageLog
from qgis.gui import QgisInterface, QgsDockWidget, QgsMapCanvas, QgsMapTool
from qgis.PyQt import sip
from qgis.PyQt.QtCore import QPoint, Qt, pyqtSignal
from qgis.PyQt.QtGui import QIcon, QKeyEvent
from qgis.PyQt.QtWidgets import QAction, QApplication

from ...imagery.errors import Level, Message
from ..resources import icon_path
from ..translation import sentence, tr

_LEVELS = {
    Level.INFO: Qgis.MessageLevel.Success,  # the bar is told of what was done, never of a mere fact
    Level.WARNING: Qgis.MessageLevel.Warning,
    Level.ERROR: Qgis.MessageLevel.Critical,
}


def bar_level(message: Message) -> int:
    """The Qgis.MessageLevel of a message in the message bar."""
    return int(_LEVELS[message.level])


def write_log(messages: Iterable[Message]) -> None:
    """Write a line each to the plugin's page of the log, without a notice in the message bar. The page is rich text."""
    for message in messages:
        text = escape(sentence(message), quote=False)
        QgsMessageLog.logMessage(text, tr("Seam Inspector"), _LEVELS[message.level], False)


CUT = " …"
_BUTTON = 13  # characters that it takes, by which the rest is shown


def brief_words(text: str, most: int) -> tuple[str, str]:
    """The words of a message for which a line of so many characters has room, whole sentences where they have; and the
    rest, whose button takes room, too."""
    if len(text) <= most:
        return text, ""
    room = max(most - _BUTTON, _BUTTON)
    ends = [place + 1 for place in range(room) if text[place : place + 2] in (". ", "? ", "! ")]
    end = max(ends, default=0) or max(text.rfind(" ", 0, room), 0) or room
    return text[:end] + ("" if ends else CUT), text[end:].lstrip()


class DrawingTool(QgsMapTool):
    """A cross for a cursor, and the canvas's keys for as long as the tool is in use."""

    finished = pyqtSignal()  # the operator is done; whoever set this tool restores the previous one

    def __init__(self, canvas: QgsMapCanvas) -> None:
        super().__init__(canvas)
        self._active = False
        self.previous: QgsMapTool | None = None  # the canvas's before this one; never another of ours
        self.setCursor(Qt.CursorShape.CrossCursor)

    def close(self) -> None:
        """Leave the canvas as if the tool had never been there. It can't be used afterwards."""
        self.canvas().unsetMapTool(self)
        self.deleteLater()

    def activate(self) -> None:
        super().activate()
        if not self._active:
            self._active = True
            self._listen()

    def deactivate(self) -> None:
        if self._active:
            self._active = False
            self._listen_no_more()
        self._clear()
        super().deactivate()

    def _listen(self) -> None:
        # While a button is down the canvas hands keys to nobody but the listeners of its signals.
        self.canvas().keyPressed.connect(self._key_pressed)

    def _listen_no_more(self) -> None:
        self.canvas().keyPressed.disconnect(self._key_pressed)

    def _key_pressed(self, event: QKeyEvent) -> None:
        raise NotImplementedError

    def _clear(self) -> None:
        """Give up what is being drawn and take it off the canvas."""
        raise NotImplementedError


def is_drag(start: QPoint, end: QPoint) -> bool:
    """Whether the mouse moved too far, in screen pixels, for a click."""
    return (end - start).manhattanLength() > QApplication.startDragDistance()


_MESSAGE_SECONDS = 8
_AROUND_PX = 200  # of a message, which its icon takes, the button that closes it and how many there are more


class ToolDock(QgsDockWidget):
    """A dock with a map tool; ``close_desk`` lets go of all that it owns."""

    tool: DrawingTool
    draw: QAction  # checked as long as the tool is the canvas's

    def __init__(self, iface: QgisInterface, title: str, name: str) -> None:
        super().__init__(title, iface.mainWindow())
        self.setObjectName(name)
        self._iface = iface
        self._canvas = iface.mapCanvas()

    def close_desk(self) -> None:
        """Leave nothing behind: map tool, canvas items, connections, tasks."""
        self.visibilityChanged.disconnect(self._clear_map)
        self._leave_tool()
        self.tool.close()

    def _offer_tool(self, tool: DrawingTool, icon: str, tip: str) -> None:
        """Make the button of a tool."""
        self.tool = tool
        self.draw = QAction(QIcon(icon_path(icon)), tr("Draw"), self)
        self.draw.setToolTip(tip)
        self.draw.setCheckable(True)
        self.draw.triggered.connect(self._toggle_tool)
        tool.setAction(self.draw)
        tool.finished.connect(self._leave_tool)
        self.visibilityChanged.connect(self._clear_map)

    def _clear_map(self, *_: object) -> None:
        """Clear the map when the desk goes, whose keys and buttons would take off what lies on it."""
        if self.isHidden():  # and not only behind another dock
            self._leave_tool()

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

    def _show_message(self, text: str, level: int) -> None:
        """Plain words: what others called their layers is no markup, as which the bar takes all it is given."""
        room = (self._canvas.width() - _AROUND_PX) // self.fontMetrics().averageCharWidth()
        self._take_off(text)
        brief, rest = brief_words(text, room)
        self._show_markup(escape(brief, quote=False), level, rest)

    def _show_markup(self, text: str, level: int, more: str = "") -> None:
        """``more``: the rest of it, behind a button. A title would take half of the room on a small screen."""
        bar, rank = self._iface.messageBar(), Qgis.MessageLevel(level)
        if more:
            bar.pushMessage("", text, more, rank, _MESSAGE_SECONDS)
        else:
            bar.pushMessage("", text, rank, _MESSAGE_SECONDS)

    def _take_off(self, text: str) -> None:
        """Take a message off the bar, however much of it is shown: it is not so any more, or comes again."""
        bar, whole = self._iface.messageBar(), escape(text, quote=False)
        for item in bar.items():
            brief = item.text().removesuffix(CUT)
            if brief and not item.title() and whole.startswith(brief):
                bar.popWidget(item)
