"""The inspection desk: a dock beside the map that puts the panels together."""
from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial

from qgis.core import QgsApplication, QgsProject
from qgis.gui import QgisInterface, QgsMessageBarItem
from qgis.PyQt import sip
from qgis.PyQt.QtCore import QCoreApplication, Qt
from qgis.PyQt.QtGui import QIcon
from qgis.PyQt.QtWidgets import (
    QAction,
    QComboBox,
    QHBoxLayout,
    QMessageBox,
    QProgressBar,
    QSplitter,
    QTabWidget,
    QToolBar,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from ...imagery.errors import Message
from ...toolkit.background_tasks import BackgroundTask
from ...toolkit.desk.tool_dock import ToolDock
from ...toolkit.desk.widgets import CornerTabs, FittingToolBar, ScrollBody, allow, single_shot
from ...toolkit.resources import icon_path, show_first_page
from ...toolkit.translation import filled, sentence, tr
from ..jobs import ScanDone
from ..measure import messages
from .accept_page import AcceptPage
from .charts.curves_tab import CurvesAndProfile
from .desk_keys import DeskKeys, UndoActions
from .images.images_panel import ImagesPanel
from .inputs.inputs_panel import InputsPanel
from .judging_desk import JudgingDesk
from .map.hard_cut import Flicker
from .map.lost_detail import LossOverlay
from .map.window_tool import WindowTool
from .map.window_view import SelectedWindows, WindowView
from .mosaic_scans import MosaicScans, scan_message, uncover
from .report_writer import ReportWriter
from .session import Session
from .windows.windows_panel import WindowsPanel

_FEWEST_ROWS = 6  # of windows: fewer show no neighbours of the one that is judged
_TASK_COMPLETE = "QgisApp", "Task complete"  # in QGIS's own translation


class InspectionDock(ToolDock):
    """Owns the session, the map tool and the panels."""

    def __init__(self, iface: QgisInterface) -> None:
        super().__init__(iface, tr("Seam Inspector"), "SeamInspectorDock")
        self.session = Session(self)
        self._offer_tool(
            WindowTool(self._canvas, self.session),
            "draw_window",
            tr(
                "Click: selects the window under the mouse (Shift adds it), or makes a standard window, on the seam "
                "when one is near. Drag: a rectangle. Ctrl+click: a window on top of another."
            ),
        )
        self.inputs = InputsPanel(self.session)
        self.windows = WindowsPanel(self.session)
        self._view = WindowView(self._canvas, self.session, lambda: self.judging.model.is_blind)
        self.zoom_to = self._view.show
        self.session.selectionChanged.connect(self._view.follow)
        self._namer = single_shot(self, self._name_window)
        self.session.selectionChanged.connect(self._namer.start)
        self.session.windowsChanged.connect(self._namer.start)
        self.judging = JudgingDesk(iface, self.session, self.windows, self, self._view)
        self.judge = self.judging.bar
        self.curves = CurvesAndProfile(self.session)
        self.images = ImagesPanel(self.session, is_blind=lambda: self.judging.model.is_blind)
        self.lost = LossOverlay(self._canvas, self.session, self)
        self._selected = SelectedWindows(self._canvas, self.session)
        self.reports = ReportWriter(self.session, self)
        self.reports.notified.connect(self._show_markup)
        self._asked = 0, 0  # windows done and asked for
        self.scans = MosaicScans(self.session, self)
        self.scans.notified.connect(self._show_message)
        self.scans.changed.connect(self._enable_actions)
        self.flicker = Flicker(self._canvas, self.session, self)
        self.flicker.notified.connect(self._show_message)
        self.flicker.shown.connect(self.lost.give_way)
        self.judging.action.toggled.connect(self._begin_judging)
        self.judging.action.toggled.connect(self.flicker.hide)
        self.judging.action.toggled.connect(self.windows.show_selected)
        self._findings: QgsMessageBarItem | None = None
        iface.messageBar().widgetAdded.connect(self._drop_notice)
        self.session.lost_detail.toggled.connect(self._uncover)
        self.scans.scanned.connect(self._tell_findings)
        self.steps = UndoActions(self.session.steps, iface.mainWindow(), self)
        self._keys = DeskKeys(self, iface.mainWindow(), self._canvas, self.tool, self.steps)
        self._keys.set_actions(
            {**self.judging.key_actions(), "layout": self.judging.action.trigger,
             "lost detail": self.session.lost_detail.trigger, "flicker": self.flicker.press,
             "next place": self._view.show_next_place},
            {"flicker": self.flicker.release},
            lambda: self.judging.is_on,
        )
        self._make_actions()
        self._lay_out()
        for choice in self.findChildren(QComboBox):
            choice.setFocusPolicy(Qt.FocusPolicy.TabFocus)  # after a click letters judge; by Tab they are the choice's
        self.session.placesTaken.connect(self.windows.uncover)
        self.session.placesTaken.connect(self.judging.model.walk)
        self.session.stepped.connect(self.zoom_to)
        self.session.mosaicDoubted.connect(lambda message: self._ask(message, {
            tr("The windows are of this mosaic"): self.session.take_windows,  # nothing goes on with them before
            tr("Leave these windows as they are"): self.session.leave_windows,
        }))
        self.session.copyDoubted.connect(lambda message: self._ask(message, {
            tr("Copy them"): self.session.copy_to_file, tr("Only look at them"): lambda: None,
        }))
        self.question: QMessageBox | None = None
        self.session.progressChanged.connect(self._show_progress)
        self.session.messageRaised.connect(self._show_message)
        self.session.messageOutdated.connect(self._take_off)
        self.session.inputsChanged.connect(self._enable_actions)
        self.session.windowsChanged.connect(self._enable_actions)
        self.windows.zoomRequested.connect(self.zoom_to)
        self.judging.model.stepped.connect(self.zoom_to)
        self._is_blind = False
        self.judging.model.changed.connect(self._hide_findings)
        self._hide_findings()
        self._enable_actions()

    def close_desk(self) -> None:
        super().close_desk()
        self._forget_findings()
        self._iface.messageBar().widgetAdded.disconnect(self._drop_notice)
        self.session.selectionChanged.disconnect(self._view.follow)
        for part in (
            self._keys, self.reports, self.flicker,
            self.scans, self.judging, self.lost, self._selected, self.session, self.inputs, self.windows,
            self.curves, self.images,
        ):  # fmt: skip
            part.close()

    def judge_worst(self) -> None:
        """Take the worst places of the last scan into the windows, inspect them, and begin judging the worst."""
        if (layer := self.scans.worst_layer()) is not None:
            self._uncover()
            self.session.take_places(layer)
            self.judging.action.setChecked(True)

    def _uncover(self, is_to_be_seen: bool = True) -> None:
        """The scan's picture gives way to the mosaic, and to lost detail."""
        if is_to_be_seen:
            uncover(QgsProject.instance(), self.session.inputs.mosaic)

    def _drop_notice(self, *_: object) -> None:
        """QGIS before 3.26 says that a task is complete, over what the desk says of it."""
        bar, title = self._iface.messageBar(), QCoreApplication.translate(*_TASK_COMPLETE)
        item = bar.currentItem()
        if item is not None and item.title() == title and item.text() in BackgroundTask.described:
            bar.popWidget()  # with its countdown, which would else end the message below

    def _tell_findings(self, done: ScanDone) -> None:
        self._forget_findings()
        self._findings = scan_message(self._iface.messageBar(), done, self.scans.warnings, self.judge_worst)

    def _forget_findings(self) -> None:
        if self._findings is not None and not sip.isdeleted(self._findings):
            self._findings.dismiss()

    def _ask(self, message: Message, answers: Mapping[str, Callable[[], None]]) -> None:
        """``answers``: what is done by what the operator says; the last is what Enter and closing the question say."""
        if self.question is not None and not sip.isdeleted(self.question):
            return
        self.question = box = QMessageBox(
            QMessageBox.Icon.Warning, tr("Seam Inspector"), sentence(message), parent=self
        )
        box.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        roles = QMessageBox.ButtonRole
        for role, (text, do) in zip((roles.AcceptRole, roles.RejectRole), answers.items()):
            button = box.addButton(text, role)
            button.clicked.connect(partial(self._answer, do))
            box.setDefaultButton(button)
        QgsProject.instance().cleared.connect(box.deleteLater)
        box.open()

    def _answer(self, answer: Callable[[], None], *_: object) -> None:
        self.question = None
        answer()

    def _make_actions(self) -> None:
        self.place = self._action(
            "MultiEdit", tr("Place"), tr("Place windows along the seamlines"), self.session.place_windows
        )
        self.inspect = self._action(
            "Start", tr("Inspect"), tr("Inspect all windows that are not inspected yet or have changed"),
            self.session.inspect_pending,
        )  # fmt: skip
        self.scan = self._action(
            "", tr("Scan"), tr("Scan the whole mosaic: where it lost detail, and what each piece of its seams kept"),
            self.scans.start,
        )  # fmt: skip
        self.scan.setIcon(QIcon(icon_path("scan")))
        self.worst = self._action(
            "SelectAll", tr("Judge the worst places"), tr("Judge the worst places of the last scan, worst first"),
            self.judge_worst,
        )  # fmt: skip
        self.accept = self._action(
            "FileNew", tr("Accept..."),
            tr("Accept or reject the delivery by its scans"),
            lambda: AcceptPage(QgsProject.instance(), self.session.inputs, self, self._view.show_layer).show(),
        )  # fmt: skip
        self.inspect_selected = self._action(
            "Refresh", tr("Again"), tr("Inspect the selected windows again"),
            lambda: self.session.inspect(self.session.selected()),
        )
        self.stop = self._action("Stop", tr("Stop"), tr("Stop; what is done stays"), self._stop)
        self.report = self._action(
            "NewReport", tr("Report"), tr("Write a report of the inspected windows, one HTML page that opens anywhere"),
            self.reports.ask,
        )  # fmt: skip
        self.help = self._action(
            "HelpContents", tr("Help"), tr("How a first inspection goes, in the browser"), lambda: show_first_page()
        )

    def _action(self, icon: str, text: str, tip: str, slot: Callable[..., None]) -> QAction:
        action = QAction(QgsApplication.getThemeIcon(f"/mAction{icon}.svg"), text, self)
        action.setToolTip(tip)
        action.triggered.connect(slot)
        return action

    def _lay_out(self) -> None:
        steps = (self.steps.undo, self.steps.redo)
        judge = self.judging.action
        actions = [self.draw, self.inspect, self.scan, judge, self.place, *steps, self.report]
        toolbar = FittingToolBar(actions, worded=[judge, self.inspect, self.scan, self.draw, self.place])
        for action in (self.inspect, self.scan):
            toolbar.widgetForAction(action).setPopupMode(QToolButton.ToolButtonPopupMode.MenuButtonPopup)
        toolbar.widgetForAction(self.inspect).addAction(self.inspect_selected)
        toolbar.widgetForAction(self.scan).addActions([self.worst, self.accept])
        self._tab_widget = tabs = CornerTabs()
        for panel, title, tip in (
            (self.curves, tr("Curves"),
             tr("How the variance of the selected window spreads over the levels of detail, and how much detail is "
                "kept by the distance from the seam")),
            (self.images, tr("Images"),
             tr("The selected window at 2x, the mosaic beside its hard cut or a source, to judge the loss by eye")),
        ):  # fmt: skip
            tabs.setTabToolTip(tabs.addTab(ScrollBody(panel), title), tip)
        tabs.setDocumentMode(True)
        corner = QWidget()  # in sight whatever tab is: lost detail is for the map and the images alike
        row = QHBoxLayout(corner)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(0)
        tabs.setCornerWidget(corner)  # before the order of tabs, which is one within a window
        before: QWidget = tabs.tabBar()
        for action in (self.session.lost_detail, self.help):
            button = QToolButton()
            button.setDefaultAction(action)
            button.setAutoRaise(True)
            row.addWidget(button)
            QWidget.setTabOrder(before, button)
            before = button
        self.setWidget(self._body(toolbar, tabs))
        self.setAllowedAreas(Qt.DockWidgetArea.LeftDockWidgetArea | Qt.DockWidgetArea.RightDockWidgetArea)

    def _body(self, toolbar: QToolBar, tabs: QTabWidget) -> QWidget:
        """Inputs, toolbar, windows and tabs, which scroll on a low screen; judgement and progress, always in sight."""
        splitter = QSplitter(Qt.Orientation.Vertical)
        for widget, share in ((self.windows, 2), (tabs, 3)):
            splitter.addWidget(widget)
            splitter.setStretchFactor(splitter.count() - 1, share)
        splitter.setSizes([2000, 3000])
        splitter.setChildrenCollapsible(False)
        self.windows.table.set_fewest_rows(_FEWEST_ROWS)
        upper, body = QWidget(), QWidget()
        layout = QVBoxLayout(upper)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(3)
        layout.addWidget(self.inputs)
        layout.addWidget(toolbar)
        layout.addWidget(splitter, 1)
        whole = QVBoxLayout(body)
        whole.setContentsMargins(4, 2, 4, 4)
        whole.setSpacing(3)
        whole.addWidget(ScrollBody(upper), 1)
        whole.addWidget(self._progress_row())  # above the buttons that judge, which stay where they are
        whole.addWidget(self.judge)
        return body

    def _begin_judging(self, is_on: bool) -> None:
        """With the window that is selected, or the first to judge if any."""
        selected = self.session.selected()
        if is_on and len(selected) == 1:
            self.zoom_to(selected[0])
        elif is_on:
            self.judging.model.begin()

    def _clear_map(self, *_: object) -> None:
        super()._clear_map()
        if self.isHidden():
            self.flicker.hide()
            self.session.lost_detail.setChecked(False)

    def _hide_findings(self) -> None:
        """While the tool's verdict is hidden, so are the curves that tell it, lost detail, QGIS's words on the selected
        window, and what others did before, which is not undone."""
        is_blind = self.judging.model.is_blind
        self._tab_widget.setTabVisible(0, not is_blind)
        allow(self.session.lost_detail, tr("Results are hidden while you judge blind.") if is_blind else "")
        if is_blind and not self._is_blind:
            self.session.steps.clear()
        self._is_blind = is_blind
        self._name_window()

    def _name_window(self) -> None:
        """In the place of QGIS's words on what is selected, which are cut, and tell what was found."""
        rows = [row for row in map(self.session.row, self.session.selected()) if row is not None]
        if len(rows) == 1:
            self._iface.statusBarIface().showMessage(filled(tr("Window {number}"), number=rows[0].window_id))
        elif not rows or self.judging.model.is_blind:
            self._iface.statusBarIface().clearMessage()

    def _progress_row(self) -> QWidget:
        """How far windows or a scan are, and the button that stops them; in sight while there is something to stop."""
        self.progress = QProgressBar()
        button = QToolButton()
        button.setDefaultAction(self.stop)
        button.setAutoRaise(True)
        self._row = QWidget()
        layout = QHBoxLayout(self._row)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(3)
        layout.addWidget(self.progress)
        layout.addWidget(button)
        self._row.setVisible(False)
        return self._row

    def _stop(self) -> None:
        self.scans.stop()
        self.session.stop()

    def _enable_actions(self) -> None:
        """Grey what can't be done now, and say why."""
        problem, windows = self.session.problem(), self.session.windows()
        unset = sentence(problem) if problem is not None else ""
        is_line = bool(self.session.inputs.seamlines)
        no_windows = "" if windows else tr("There is no window yet: draw one, or place them along the seamlines.")
        allow(self.draw, unset)
        allow(self.place, unset or ("" if is_line else sentence(messages.NO_SEAMLINES())))
        allow(self.inspect, unset or no_windows)
        allow(self.inspect_selected, unset or no_windows)
        allow(self.scan, self.scans.why_not())
        uninspected = no_windows or tr("No window has been inspected yet.")
        judge = self.judging.action
        allow(judge, "" if judge.isChecked() or any(row.is_compared for row in windows) else unset or uninspected)
        unscanned = "" if self.scans.worst_layer() else tr("No scan has found such places yet: scan the mosaic first.")
        allow(self.worst, unset or unscanned)
        self._offer_stop()
        allow(self.report, "" if any(row.verdict for row in windows) else uninspected)

    def _show_progress(self, done: int, asked: int) -> None:
        self._asked = done, asked
        self._offer_stop()

    def _offer_stop(self) -> None:
        done, asked = self._asked
        is_busy = self.session.is_busy or asked > 0
        self.stop.setEnabled(is_busy or self.scans.is_at_work)
        self._row.setVisible(self.stop.isEnabled())
        if is_busy or self.scans.news is None:
            self.progress.setRange(0, max(asked, 1))
            self.progress.setValue(done)
            self.progress.setFormat(filled(tr("{done} of {asked} windows"), done=done, asked=asked))
        else:
            self.progress.setRange(0, 1000)
            self.progress.setValue(int(1000 * self.scans.news.share))
            self.progress.setFormat(self.scans.progress())
