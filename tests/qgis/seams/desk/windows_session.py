"""A session without layers and tasks: what the table of windows, the judge bar and the charts ask of it."""
from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from qgis.core import QgsVectorLayer
from qgis.PyQt.QtCore import QObject, pyqtSignal
from qgis.PyQt.QtWidgets import QWidget
from seam_inspector.plugin.imagery.statistics import FIRST, Operator
from seam_inspector.plugin.seams.desk.inputs.project_inputs import Inputs
from seam_inspector.plugin.seams.desk.windows.window_columns import COLUMNS
from seam_inspector.plugin.seams.desk.windows.windows_panel import WindowsPanel
from seam_inspector.plugin.seams.measure.window.explained_window import LiveWindow
from seam_inspector.plugin.seams.measure.window.window_result import WindowResult
from seam_inspector.plugin.seams.measure.window_records import WindowRecord


class WindowsSession(QObject):
    """Windows in a list. As in the real one a selection is told at once."""

    inputsChanged = pyqtSignal()
    windowsChanged = pyqtSignal()
    selectionChanged = pyqtSignal()
    liveChanged = pyqtSignal()
    curvesArrived = pyqtSignal(int)
    resultArrived = pyqtSignal(int)
    progressChanged = pyqtSignal(int, int)
    messageRaised = pyqtSignal(str, int)
    begunAnew = pyqtSignal()

    def __init__(self, rows: list[WindowRecord] | None = None) -> None:
        super().__init__()
        self.rows = list(rows or [])
        self.chosen: list[int] = []
        self.layer: QgsVectorLayer | None = None
        self.inputs = Inputs()
        self.live: LiveWindow | None = None
        self.piece = None
        self.pending: set[int] = set()
        self.results: dict[int, WindowResult] = {}
        self.calls: list[tuple[Any, ...]] = []
        """What the widgets asked for, in order."""

    def put(self, rows: list[WindowRecord]) -> None:
        """Other windows from now on."""
        self.rows = list(rows)
        self.windowsChanged.emit()

    def change(self, fid: int, **values: Any) -> None:
        """Other values of one window."""
        self.put([replace(row, **values) if row.fid == fid else row for row in self.rows])

    def window_layer(self) -> QgsVectorLayer | None:
        return self.layer

    def windows(self) -> list[WindowRecord]:
        return list(self.rows)

    def row(self, fid: int) -> WindowRecord | None:
        return next((row for row in self.rows if row.fid == fid), None)

    def numbered(self, window_id: int) -> WindowRecord | None:
        return next((row for row in self.rows if row.window_id == window_id), None)

    def result(self, fid: int) -> WindowResult | None:
        return self.results.get(fid)

    def is_pending(self, fid: int) -> bool:
        return fid in self.pending

    def selected(self) -> list[int]:
        return sorted(self.chosen)

    def select(self, fids: list[int]) -> None:
        self.calls.append(("select", sorted(fids)))
        if sorted(fids) != self.selected():
            self.chosen = list(fids)
            self.selectionChanged.emit()

    def judge(self, fids: list[int], word: str, operator: Operator = FIRST) -> None:
        self.calls.append(("judge", sorted(fids), word))
        self._write(fids, {operator.observer: word} if word else {operator.observer: "", operator.confidence: None})

    def note(self, fids: list[int], values: dict[str, Any]) -> None:
        self.calls.append(("note", sorted(fids), values))
        self._write(fids, {name: "" if value is None and "remark" in name else value for name, value in values.items()})

    def _write(self, fids: list[int], values: dict[str, Any]) -> None:
        self.put([replace(row, **values) if row.fid in fids else row for row in self.rows])

    def inspect(self, fids: list[int]) -> None:
        self.calls.append(("inspect", sorted(fids)))

    def remove(self, fids: list[int]) -> None:
        self.calls.append(("remove", sorted(fids)))
        if set(fids) & set(self.chosen):
            self.chosen = [fid for fid in self.chosen if fid not in fids]
            self.selectionChanged.emit()
        self.put([row for row in self.rows if row.fid not in fids])


def window(
    fid: int,
    verdict: str = "",
    ratios: tuple[float | None, ...] = (None, None, None),
    observer: str = "",
    reason: str = "",
    sources: int | None = None,
    stale: bool = False,
    composite_ratio: float | None = None,
    cause: str = "",
    kept: tuple[float | None, ...] = (),
    paper_verdict: str = "",
    visibility: float | None = None,
) -> WindowRecord:
    """A window whose number is its feature id."""
    return WindowRecord(
        fid, (0.0, 0.0, 1.0, 1.0), verdict, reason, sources, ratios, observer=observer,
        composite_ratios=(composite_ratio,), cause=cause, kept=kept, fid=fid,
        reference="seam" if kept else "", kept_low=kept[0] - 0.05 if kept and kept[0] is not None else None,
        kept_high=kept[0] + 0.05 if kept and kept[0] is not None else None,
        loss=100 * max(1 - kept[0], 0.0) if kept and kept[0] is not None else None,
        stale=stale, paper_verdict=paper_verdict, visibility=visibility,
    )  # fmt: skip


ROWS = [
    window(1, "reduced", (0.83, 0.95, 0.99), sources=3, kept=(0.9, 0.95, 1.0)),
    window(
        2, "significant", (0.381234, 0.52, 0.88), "visible", sources=2, composite_ratio=0.6, cause="feathering",
        kept=(0.557, 0.8, 0.97), paper_verdict="reduced", visibility=1.24,
    ),
    window(3),
    window(4, "not_comparable", reason="No source covers <window> in west_12.tif.", sources=0),
    window(10, "preserved", (1.04, 1.0, None), "invisible", sources=10, cause="none", kept=(1.02,)),
    window(12, "significant", (0.45, 0.7, 0.9), sources=1, stale=True),
]
"""Windows of all kinds, as the table of windows shows them."""

Show = Callable[[QWidget], QWidget]  # shows a widget until the test is over


def filter_to(panel: WindowsPanel, text: str = "", choice: str = "all") -> list[int]:
    panel._search.setText(text)
    panel._verdicts.setCurrentText(choice)
    return panel.ordered_fids()


def columns_of(panel: WindowsPanel) -> list[str]:
    """The names of the columns that are seen, from left to right."""
    return [column.name for place, column in enumerate(COLUMNS) if not panel.table.isColumnHidden(place)]
