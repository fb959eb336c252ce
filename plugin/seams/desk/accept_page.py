"""From a scan to a signed decision, on one page: what is decided on and by which limits, then the verdict.

What is decided lies in a temporary folder until it is saved, so that trying other limits replaces no document.
"""
from __future__ import annotations

import os
import shutil
import tempfile
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from itertools import chain, count
from pathlib import Path
from typing import Any

from qgis.core import (
    QgsApplication,
    QgsProcessingAlgorithm,
    QgsProcessingAlgRunnerTask,
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsProcessingUtils,
    QgsProject,
    QgsRasterLayer,
    QgsVectorLayer,
)
from qgis.PyQt.QtCore import Qt, QUrl
from qgis.PyQt.QtGui import QDesktopServices, QFont
from qgis.PyQt.QtWidgets import (
    QDialog,
    QDoubleSpinBox,
    QFileDialog,
    QFormLayout,
    QGroupBox,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QListWidget,
    QListWidgetItem,
    QProgressBar,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from ...imagery.errors import SettingsError
from ...imagery.messages import system_reason
from ...toolkit.desk.widgets import plain_tip
from ...toolkit.layer_styles import load_style
from ...toolkit.layers import layer_path
from ...toolkit.project_settings import load_settings, save_settings
from ...toolkit.translation import filled, sentence, tr
from ..tables.scan_layers import SEAMS
from ..words import verdict_colour
from . import messages
from .inputs.project_inputs import Inputs
from .mosaic_scans import output_stem, worst_layer
from .window_home import FAILURES, MADE_FOR, pictures_beside

DECISION = "seaminspector:acceptmosaic"
_FILES = {"REPORT": "report.html", "DEFECTS": "defects.gpkg", "QUALITY": "quality.xml"}
"""What a decision makes; failures have notes and pictures beside them, which not every format of features takes."""


@dataclass(frozen=True)
class DeliveredScan:
    """The last scan of a mosaic of the project."""

    words: str  # what its mosaic is called, and in brackets its file, as the report calls the sheet
    mosaic: str  # id of the mosaic's layer
    seams: str  # its pieces of seam, as QGIS opens them


def delivered_scans(project: QgsProject, first: str) -> list[DeliveredScan]:
    """Scans of the project's mosaics, that of the mosaic ``first`` first."""
    scans = []
    rasters = [layer for layer in project.mapLayers().values() if isinstance(layer, QgsRasterLayer) and layer.isValid()]
    for mosaic in sorted(rasters, key=lambda raster: (raster.id() != first, raster.name())):
        worst = worst_layer(project, mosaic.id())
        if worst is not None and layer_path(worst):
            file = Path(layer_path(worst))
            words, seams = f"{mosaic.name()} ({file.stem})", f"{file}|layername={SEAMS.name}"
            scans.append(DeliveredScan(words, mosaic.id(), seams))
    return scans


def decision_values(inputs: Inputs, scans: Sequence[DeliveredScan]) -> dict[str, Any]:
    """What a decision on scans begins with, but for its outputs."""
    return {
        "SEAMS": [scan.seams for scan in scans], "MOSAIC": [scan.mosaic for scan in scans],
        "SOURCES": list(inputs.sources), "SOURCE_INDEX": inputs.source_index or None, "WINDOWS": inputs.windows or None,
    }


def suggested_files(project: QgsProject, inputs: Inputs) -> dict[str, Path]:
    """Files for what a decision makes, beside the project.

    All have the first number by which none of them is there, nor its pictures: ``report_2.html``.
    """
    mosaic, folder = project.mapLayer(inputs.mosaic), Path(project.homePath() or Path.home())
    stem = output_stem(project.baseName() or "delivery" if mosaic is None else mosaic.source())
    for ending in chain([""], (f"_{number}" for number in count(2))):
        files = {name: folder / f"{stem}_{Path(file).stem}{ending}{Path(file).suffix}" for name, file in _FILES.items()}
        if not any(os.path.lexists(path) for file in files.values() for path in (file, pictures_beside(file))):
            break
    return files


_KEY = "acceptance"  # of what the project keeps of the page
_HEAD = ("TITLE", "CONTRACT", "PRODUCER", "CLIENT")
_LIMITS = ("MAX_SHARE", "MAX_RUN", "MIN_MEASURED")
"""Parameters of the algorithm, which has their words and defaults."""
_COLOURS = {"accepted": "preserved", "rejected": "significant", "undecided": "not_comparable"}  # those of verdicts
_LARGE = 2.0  # times the font


class AcceptPage(QDialog):
    """Decides in the background; goes with its dock."""

    def __init__(
        self, project: QgsProject, inputs: Inputs, parent: QWidget, zoom_to: Callable[[QgsVectorLayer], None]
    ) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle(tr("Accept or reject a delivery"))
        self._project, self._inputs, self._zoom_to = project, inputs, zoom_to
        self._algorithm: QgsProcessingAlgorithm = (
            QgsApplication.processingRegistry().createAlgorithmById(DECISION)
        )
        self._scans = delivered_scans(project, inputs.mosaic)
        self._task: DecisionTask | None = None
        self.files: dict[str, Path] = {}  # what the last decision made, by the outputs' names
        self._shown = ""  # id of the layer of its failures
        self._lay_out()
        self._show_state()
        project.cleared.connect(self.close)

    def values(self) -> dict[str, Any]:
        """The algorithm's parameters as the page has them, without outputs."""
        moved = {scan.mosaic: scan for scan in delivered_scans(self._project, "")}  # since the page was opened
        chosen = [moved.get(scan.mosaic, scan) for row, scan in enumerate(self._scans) if self._is_chosen(row)]
        return {**decision_values(self._inputs, chosen), **self._given()}

    def _given(self) -> dict[str, Any]:
        said = {name: field.text().strip() for name, field in self.head.items()}
        return {**said, **{name: box.value() for name, box in self.limits.items()}}

    def decide(self, *_: object) -> None:
        """In the background, into a folder of its own."""
        save_settings(self._project, _KEY, self._given())
        folder = Path(tempfile.mkdtemp(dir=QgsProcessingUtils.tempFolder()))
        beside = suggested_files(self._project, self._inputs)
        self._made = {name: folder / file.name for name, file in beside.items()}
        values = {**self.values(), **{name: str(file) for name, file in self._made.items()}}
        context, self._feedback = QgsProcessingContext(), _FailureHeard()
        context.setProject(self._project)
        self._feedback.progressChanged.connect(self._show_progress)
        is_sound, why = self._algorithm.checkParameterValues(values, context)
        if not is_sound:
            self._say("", why)
            return
        self._task = DecisionTask(self._algorithm, values, context, self._feedback)
        self._task.executed.connect(self._decided)
        self._say("", "")
        self._show_state()
        QgsApplication.taskManager().addTask(self._task)

    def save(self, folder: Path) -> None:
        """Copy what was decided into a folder, in which none of it may be. Raises SettingsError."""
        pictures = map(pictures_beside, self.files.values())
        there = [file for file in (*self.files.values(), *pictures) if file.exists()]
        if taken := next((folder / file.name for file in there if (folder / file.name).exists()), None):
            raise SettingsError(messages.DECISION_THERE_ALREADY(path=taken))
        try:
            for made in there:
                (shutil.copytree if made.is_dir() else shutil.copyfile)(made, folder / made.name)
        except OSError as error:
            raise SettingsError(messages.DECISION_NOT_SAVED(folder=folder, error=system_reason(error))) from None
        shown, defects = self._shown_failures(), self.files.get("DEFECTS")
        self.files = {name: folder / file.name for name, file in self.files.items()}
        if shown is not None and shown.source() == str(defects):  # which is gone with QGIS
            shown.setDataSource(str(self.files["DEFECTS"]), shown.name(), "ogr")
        self._saved.setText(filled(tr("Saved in {folder}."), folder=folder))

    def show_failures(self, *_: object) -> None:
        """On top of the map, once, which goes there."""
        layer = self._shown_failures() or QgsVectorLayer(str(self.files["DEFECTS"]), tr("Failures"), "ogr")
        if layer.isValid() and layer.id() not in self._project.mapLayers():
            load_style(layer, "defects")
            layer.setCustomProperty(FAILURES, True)
            layer.setCustomProperty(MADE_FOR, self._inputs.mosaic)
            self._shown = layer.id()
            self._project.addMapLayer(layer, False)
            self._project.layerTreeRoot().insertLayer(0, layer)
        if layer.isValid() and layer.featureCount():
            self._zoom_to(layer)

    def done(self, result: int) -> None:
        """Stop what is under way; the project keeps what was given."""
        if self._given() != self._before:
            save_settings(self._project, _KEY, self._given())
        if self._task is not None:
            self._feedback.cancel()
        super().done(result)

    def _show_progress(self, share: float) -> None:
        self._progress.setValue(int(share))

    # What was decided

    def _decided(self, is_successful: bool, results: Mapping[str, Any]) -> None:
        self._task = None
        if is_successful and (shown := self._shown_failures()) is not None:  # of the decision before
            self._project.removeMapLayer(shown.id())
        self.files = {name: file for name, file in self._made.items() if is_successful and file.is_file()}
        if is_successful:
            self._say(str(results["DECISION"]), f"{results['REASONS']}.")
            self._saved.setText(tr("Not saved yet."))
        elif not self._feedback.isCanceled():
            self._say("", self._feedback.error)
        self._show_state()

    def _say(self, outcome: str, why: str) -> None:
        """The verdict, large, and its reason."""
        words = {"accepted": tr("Accepted"), "rejected": tr("Rejected"), "undecided": tr("Undecided")}
        self.verdict.setText(words.get(outcome, outcome))
        self.verdict.setVisible(bool(outcome))
        self.verdict.setStyleSheet(f"color: {verdict_colour(_COLOURS.get(outcome, ''))}")  # themes have their own, too
        self.reason.setText(why)
        self.reason.setVisible(bool(why))
        self._saved.setText("")

    def _let_go(self, *_: object) -> None:
        """Drop a verdict by other limits, on something else, or under another title."""
        self.files = {}
        self._say("", "")
        self._show_state()

    def _shown_failures(self) -> QgsVectorLayer | None:
        layer = self._project.mapLayer(self._shown)
        return layer if isinstance(layer, QgsVectorLayer) else None

    def _show_state(self, *_: object) -> None:
        is_busy = self._task is not None
        has_scan = any(map(self._is_chosen, range(len(self._scans))))
        self.decider.setEnabled(has_scan and not is_busy)
        self._progress.setVisible(is_busy)
        for box in self.findChildren(QGroupBox):
            box.setEnabled(not is_busy)
        for button, name in ((self._report, "REPORT"), (self._failures, "DEFECTS"), (self.saver, "REPORT")):
            button.setVisible(bool(self.files))
            button.setEnabled(name in self.files and not is_busy)
        layout = self.layout()
        layout.activate()
        self.resize(self.width(), max(self.height(), layout.totalHeightForWidth(self.width())))  # Qt squeezes fields

    def _is_chosen(self, row: int) -> bool:
        return bool(self._list.item(row).checkState() == Qt.CheckState.Checked)

    # What the operator presses

    def _open_report(self, *_: object) -> None:
        QDesktopServices.openUrl(QUrl.fromLocalFile(str(self.files["REPORT"])))

    def _ask_for_folder(self, *_: object) -> None:
        home = self._project.homePath() or str(Path.home())
        folder = QFileDialog.getExistingDirectory(self, tr("Save the decision"), home)
        if folder:
            try:
                self.save(Path(folder))
            except SettingsError as error:
                self._saved.setText(sentence(error.message))

    # Widgets

    def _lay_out(self) -> None:
        self.head = {name: QLineEdit(self) for name in _HEAD}
        self.limits = {name: QDoubleSpinBox(self) for name in _LIMITS}
        head, limits, kept = QFormLayout(), QFormLayout(), load_settings(self._project, _KEY)
        for form, fields in ((head, self.head), (limits, self.limits)):
            for name, field in fields.items():
                definition = self._algorithm.parameterDefinition(name)
                field.setToolTip(plain_tip(definition.help()))
                form.addRow(definition.description(), field)
                kind = str if isinstance(field, QLineEdit) else float
                given = kept[name] if isinstance(kept.get(name), kind) else definition.defaultValue()
                if isinstance(field, QLineEdit):
                    field.setText(str(given or ""))
                    field.textChanged.connect(self._let_go)
                else:
                    field.setRange(0, 100 if name != "MAX_RUN" else 1e6)
                    field.setDecimals(1)
                    field.setValue(float(given))
                    field.valueChanged.connect(self._let_go)
        self._before = self._given()
        self._list = QListWidget(self)
        self._list.setMaximumHeight(5 * self.fontMetrics().height())
        for scan in self._scans:
            entry = QListWidgetItem(scan.words, self._list)
            entry.setToolTip(plain_tip(scan.seams))
            is_own = scan.mosaic == self._inputs.mosaic
            entry.setCheckState(Qt.CheckState.Checked if is_own else Qt.CheckState.Unchecked)
        self._list.itemChanged.connect(self._let_go)
        decided_on = QVBoxLayout()
        decided_on.addWidget(self._list)
        if not self._scans:
            hint = QLabel(tr("No mosaic is scanned yet: scan it, or run Accept delivery in the toolbox, which does."))
            hint.setWordWrap(True)
            decided_on.addWidget(hint)
        layout = QVBoxLayout(self)
        for title, part in (
            (tr("Delivery"), head), (tr("Limits"), limits), (tr("Scans and their sheets"), decided_on)
        ):
            box = QGroupBox(title, self)
            box.setLayout(part)
            layout.addWidget(box)
        self.decider = self._button(tr("Decide"), tr("Decides in the background, by these limits."), self.decide)
        self.decider.setDefault(True)
        self._progress = QProgressBar(self)
        layout.addLayout(_row(self.decider, self._progress))
        self.verdict, self.reason, self._saved = QLabel(self), QLabel(self), QLabel(self)
        large = QFont(self.font())
        large.setPointSizeF(_LARGE * large.pointSizeF())
        large.setBold(True)
        self.verdict.setFont(large)
        for label in (self.verdict, self.reason, self._saved):
            label.setTextFormat(Qt.TextFormat.PlainText)
            label.setWordWrap(True)
            layout.addWidget(label)
        self.reason.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self._report = self._button(tr("Open report"), tr("The page to sign, in the browser."), self._open_report)
        self._failures = self._button(
            tr("Failures on the map"), tr("A line for each failure without a break."), self.show_failures
        )
        self.saver = self._button(
            tr("Save as ..."), tr("Report, failures with their pictures and quality record, into a folder."),
            self._ask_for_folder,
        )
        layout.addLayout(_row(self._report, self._failures, self.saver))
        layout.addStretch()
        self._say("", "")
        self.resize(46 * self.fontMetrics().averageCharWidth(), self.sizeHint().height())

    def _button(self, text: str, tip: str, slot: Any) -> QPushButton:
        button = QPushButton(text, self)
        button.setToolTip(tip)
        button.setAutoDefault(False)
        button.clicked.connect(slot)
        return button


class DecisionTask(QgsProcessingAlgRunnerTask):
    """Holds what it uses to its end, whether or not the page is there."""

    def __init__(
        self, algorithm: QgsProcessingAlgorithm, values: Mapping[str, Any], context: QgsProcessingContext,
        feedback: QgsProcessingFeedback,
    ) -> None:
        super().__init__(algorithm, dict(values), context, feedback)
        self._held = context, feedback


class _FailureHeard(QgsProcessingFeedback):
    """Keeps why a run failed."""

    def __init__(self) -> None:
        super().__init__(False)
        self.error = ""

    def reportError(self, error: str, fatalError: bool = False) -> None:
        self.error = error
        super().reportError(error, fatalError)


def _row(*widgets: QWidget) -> QHBoxLayout:
    row = QHBoxLayout()
    for widget in widgets:
        row.addWidget(widget)
    return row
