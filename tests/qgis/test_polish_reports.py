"""No English word and no decimal point in what a Polish user reads: reports with their charts, and the log."""
from __future__ import annotations

import base64
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from qgis.core import QgsProcessingProvider

from tests.pages import Outline
from tests.qgis import test_printed_reports as printed
from tests.qgis.runs import Run, run

ENGLISH = re.compile(
    r"\b(the|of|and|with|is|are|was|were|not|none|unknown|yes|from|at most|at least|"
    r"significant|reduced|preserved|comparable|inspected|visible|invisible|unsure|judged|blur|feathering|resampled|sharpened|"
    r"compressed|clipping|dodging|shift|narrowed|balanced|unclear|missing|mosaic|source|sources|composite|orthoimage|"
    r"luminance|luminosity|red|green|blue|near|infrared|band|level|detail|background|window|windows|seam|low|moderate|"
    r"strong|uncertain|grain|along|across|flight|resolved|group|bars|control|check|blunder|residual|mean|largest|accepted|"
    r"rejected|undecided|passed|failed|normal|tightened|higher|lower|measured|given|similarity|affine|projective|"
    r"correlation|cross|dot|ring|wedge|temporary|layer|file|image|size|bands|limit|threshold)\b",
    re.IGNORECASE,
)
NAMES = re.compile(
    r"[\w/.\-]*\.(tif|gpkg|csv|json|xml|html|jpg|dat)|/tmp/\S+|„[^”]*”|QGIS [\d.]+\S*|"
    r"Seam Inspector [\d.]+|\b\w+_\w+\b|EPSG:\d+|WGS 84[^<|]*|JRC, Orthoimage[^:]*:|Arrêté.*\)|delimitedtext\S*|"
    r"\b(LOSS|PLAN|ROBUST|GEOID)\b",
)
"""What no language changes: files, fields, words that parameters take, titles of papers, versions."""
DECIMAL_POINT = re.compile(r"(?<![\w.])\d+\.\d+(?![\w.])")
REPORTS = [report for report in printed.REPORTS if report is not printed.many_groups]


@pytest.mark.parametrize("report", REPORTS, ids=lambda report: report.__name__)
def test_a_report_and_its_log_are_polish(
    report: printed.Report, polish: None, commas: None, provider: QgsProcessingProvider, given: dict[str, Any],
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch,
) -> None:  # fmt: skip
    said: list[str] = []

    def heard(algorithm: str, **parameters: Any) -> Run:
        outcome = run(algorithm, **parameters)
        said.extend([*outcome.log.warnings, *outcome.log.infos])
        return outcome

    monkeypatch.setattr(printed, "run", heard)
    path = tmp_path / "report.html"
    report(given, tmp_path, path)
    page = Outline()
    page.feed(re.sub(r"<style>.*?</style>", "", path.read_text(encoding="utf-8"), flags=re.DOTALL))
    texts = [page.words, *page.captions, *said]
    for address in page.addresses:
        if address.startswith("data:image/svg"):
            drawing = base64.b64decode(address.partition(",")[2]).decode()
            texts += re.findall(r"<text[^>]*>([^<]*)<", drawing)
    known = [NAMES.sub(" ", text) for text in texts]
    assert {word: text[max(0, at - 50) : at + 50] for text in known for word, at in _found(ENGLISH, text)} == {}
    assert {word: text[max(0, at - 50) : at + 50] for text in known for word, at in _found(DECIMAL_POINT, text)} == {}


def _found(pattern: re.Pattern[str], text: str) -> Iterator[tuple[str, int]]:
    for result in pattern.finditer(text):
        yield result.group().lower(), result.start()
