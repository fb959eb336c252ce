"""The report that the desk writes: of the windows as they are, in the background."""
from __future__ import annotations

from pathlib import Path

import pytest
from qgis.PyQt.QtWidgets import QWidget
from seam_inspector.plugin.seams.desk.report_writer import ReportWriter

from tests.qgis.scenes import BLURRED, SHARP, windows
from tests.qgis.seams.desk.session_desk import BLURRED_WINDOW, SHARP_WINDOW, Desk, wait_for_tasks


class Writer:
    """A writer, and what it said."""

    def __init__(self, desk: Desk) -> None:
        self.window = QWidget()
        self.writer = ReportWriter(desk.session, self.window)
        self.told: list[str] = []
        self.writer.notified.connect(self._hear)

    def _hear(self, text: str, _level: int) -> None:
        self.told.append(text)

    def write(self, path: Path) -> str:
        self.writer.write(path)
        wait_for_tasks()
        (said,) = self.told
        self.told.clear()
        return said


@pytest.fixture
def writer(desk: Desk) -> Writer:
    return Writer(desk)


def test_the_report_tells_windows_curves_and_cause(desk: Desk, writer: Writer, tmp_path: Path) -> None:
    for window in (BLURRED_WINDOW, SHARP_WINDOW):
        desk.add(window)
    desk.session.judge([desk.rows()[1].fid], "visible")
    path = tmp_path / "a & b.html"
    said = writer.write(path)
    assert said.startswith("Report of 2 windows: <a href=")
    assert "a &amp; b.html</a>" in said
    assert "no curves" not in said
    page = path.read_text(encoding="utf-8")
    for words in ("significant", "visible", "blur", "data:image/svg+xml", "mosaic.tif"):
        assert words in page, words


def test_windows_that_were_measured_elsewhere_have_no_curves(
    desk: Desk, writer: Writer, tmp_path: Path
) -> None:
    """Inspecting one again that can't be compared would give none."""
    verdicts = ["preserved", "not_comparable"]
    desk.use(windows(SHARP, BLURRED, window_id=("integer", [1, 2]), verdict=("string", verdicts)))
    said = writer.write(tmp_path / "report.html")
    assert "1 have no curves" in said
    assert (tmp_path / "report.html").exists()
