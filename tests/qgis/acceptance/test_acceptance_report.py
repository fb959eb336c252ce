"""The decision on paper: what stands on the page, for any delivery and any name."""
from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from seam_inspector.plugin.acceptance.measure.deciding import decide
from seam_inspector.plugin.acceptance.measure.delivery import FileDoubts, SeamCover
from seam_inspector.plugin.acceptance.paper.acceptance_report import MOST_ROWS, save_acceptance_report
from seam_inspector.plugin.acceptance.paper.defect_files import (
    CUT_PANEL,
    IMAGE_PANEL,
    MOSAIC_PANEL,
    DefectPicture,
    DefectPictures,
    ProofPanel,
)
from seam_inspector.plugin.acceptance.paper.inspection_record import InspectionRecord
from seam_inspector.plugin.imagery.seam_totals import KeptBeside

from tests.numbers.acceptance.deliveries import rules
from tests.numbers.acceptance.made_decisions import decided
from tests.pages import Outline, outline
from tests.qgis.acceptance.papers import ground, record_of, scanned_with

FAILED = [(0, 3), (0, 4), (1, 20)]


def page_of(path: Path, record: InspectionRecord) -> Outline:
    maker = DefectPictures(record.mosaics, record.decision)
    made = {defect.run.number: picture for defect in record.defects if (picture := maker.of(defect)) is not None}
    save_acceptance_report(path / "report.html", record, made)
    return outline((path / "report.html").read_text(encoding="utf-8"))


def test_the_decision_comes_first_then_rules_sheets_and_failures(tmp_path: Path) -> None:
    decision = decided(["sheet_1", "sheet_2"], failed=FAILED)
    decision = replace(decision, runs=tuple(replace(run, joined_m=80.0) for run in decision.runs))
    page = page_of(tmp_path, record_of(scanned_with(decision, "coif3")))
    text = page.words[page.words.index("Rejected") :]  # after the page's looks
    share, longest = 100 * (decision.whole.failed_share or 0), decision.longest_failure_m
    places = [text.index(words) for words in (
        "Rejected", f"{share:.2f}", "share of the seams that failed", "signature", "Where the seams failed", "Sheets",
        "Failures", "How it was measured",
    )]
    assert places == sorted(places)
    ruled = {row[0]: row[1:] for row in page.rows if len(row) == 4}
    assert ruled["share of the seams that failed"][0] == f"{share:.2f}\u00a0%"
    assert ruled["share of the seams that failed"][1].startswith("at most 2\u00a0%")
    assert ruled["share of the seams that failed"][2] == "failed"
    assert ruled["longest failure without a break"][0] == f"{longest:.1f}\u00a0m; with those that meet 80.0\u00a0m"
    assert ruled["longest failure without a break"][2] == "passed"
    row = ["sheet_1", "Rejected", "1000.0 m", "100.0 %", f"{longest:.1f} m", f"{longest / 10:.2f} %",
           f"{longest:.1f} m", "2 / 40", "0.0 m"]
    rows = [[cell.replace("\u00a0", " ") for cell in cells] for cells in page.rows]
    assert row in rows
    assert ["typical length of the pieces", "25.0 m"] in rows
    failures = [row for row in page.rows if row and row[0] in ("F1", "F2") and len(row) > 5]
    assert [row[1] for row in failures] == ["sheet_1", "sheet_2"]
    assert "0412_ortho.tif (2019-07-04)" in " ".join(failures[0][5].split())
    for words in ("coif3", "EPSG:32633", "/deliveries/sheet_2.gpkg", "Seam Inspector 0.1.0", "name and office"):
        assert words in page.words


def test_failures_that_are_unclear_or_that_no_eye_sees_are_marked(tmp_path: Path) -> None:
    """The first of two, of two pieces."""
    plain = decided(["sheet_1"], failed=[(0, 3), (0, 4), (0, 20)])
    pieces = [*plain.delivery.pieces]
    pieces[3] = replace(pieces[3], kept_high=0.8, kept_low=0.41, left_date="2019-07-04", right_date="2019-08-11")
    pieces[4] = replace(pieces[4], kept_1=0.6, kept_low=0.5, kept_high=0.69)
    pieces[20] = replace(pieces[20], visibility=0.94)
    page = page_of(tmp_path, record_of(decide(replace(plain.delivery, pieces=tuple(pieces)), plain.rules)))
    first, second = ([" ".join(cell.split()) for cell in row] for row in page.rows if row and row[0] in ("F1", "F2"))
    assert first[2] == "50.0 m25.0 m unclear"
    assert first[5] == ""  # nothing known
    assert "(2019-07-04)" in first[6]
    assert "(2019-08-11)" in first[6]
    assert (second[2], second[5]) == ("25.0 m", "0.9 JND")
    assert "A piece fails by the detail that it lost, whatever an eye sees of that." in page.words


def test_an_accepted_delivery_has_no_failures(tmp_path: Path) -> None:
    page = page_of(tmp_path, record_of(decided()))
    assert "Accepted" in page.words
    assert "No piece of seam that was measured failed." in page.words
    assert "Where the seams failed" not in page.words
    assert len(page.pictures("jpeg")) == 1


def test_pictures_stand_with_their_failures(tmp_path: Path) -> None:
    decision = decided(["sheet_1", "sheet_2"], failed=FAILED)
    page = page_of(tmp_path, record_of(decision, mosaics=(ground(tmp_path / "mosaic.tif"),)))
    # 200 m amid a zone of UTM.
    assert [caption.replace("\u00a0", " ") for caption in page.captions[1:]] == ["200.1 m across", "The mosaic"] * 2
    words = " ".join(page.words.split())
    assert f"Failure F1: {decision.longest_failure_m:.1f} m, least kept 45 % (40 - 51)" in words
    assert "kept by its pieces, from south to north: 45 %, 45 %" in words
    assert "mosaic.tif" in page.words


@pytest.mark.parametrize("sheets", [1, 40])
@pytest.mark.parametrize("each", [0, 8])
def test_every_size_of_delivery_fits(tmp_path: Path, sheets: int, each: int) -> None:
    names = [f"ortho_2026_sheet_{number:02d}_of_the_delivery_of_november" for number in range(sheets)]
    failed = [(number, 2 + 4 * place) for number in range(sheets) for place in range(each)]
    decision = decided(names, failed=failed)
    page = page_of(tmp_path, record_of(decision))
    assert len(decision.runs) == sheets * each
    shown = [row for row in page.rows if len(row) > 5 and row[0].startswith("F")]
    assert len(shown) == min(sheets * each, MOST_ROWS)
    assert ("The longest 300 of 320" in page.words) == (sheets * each > MOST_ROWS)
    assert (tmp_path / "report.html").stat().st_size < 2_000_000


def test_a_rule_that_can_not_be_told_says_why(tmp_path: Path) -> None:
    """Three pieces without a break failed, and may have passed together; three failed apart from each other."""
    plain = decided(failed=[(0, place) for place in (3, 4, 5, 10, 14, 18)])
    pieces = [*plain.delivery.pieces]
    pieces[3:6] = [replace(piece, kept_1=0.69, kept_low=0.6, kept_high=0.79) for piece in pieces[3:6]]
    page = page_of(tmp_path, record_of(decide(replace(plain.delivery, pieces=tuple(pieces)), plain.rules)))
    rows = zip(page.rows, page.rows[1:])
    below = {row[0]: after for row, after in rows if len(row) == 4 and row[3] == "open"}
    assert [*below] == ["longest failure without a break"]
    (why,) = below["longest failure without a break"]
    assert why.endswith("but it may be 25.0 to 75.0 m by the intervals of its pieces.")


def test_why_pieces_were_not_measured_is_told_by_kinds(tmp_path: Path) -> None:
    plain = decided()
    covers = SeamCover(0.5, 0), SeamCover(1, 0.5), SeamCover(1, 1), SeamCover(1, 1, is_short=True)
    blank = [replace(piece, kept_1=None, kept_low=None, kept_high=None) for piece in plain.delivery.pieces[:5]]
    made = replace(
        plain.delivery, pieces=(*blank, *plain.delivery.pieces[5:]), files=FileDoubts(cover=dict(enumerate(covers)))
    )
    page = page_of(tmp_path, record_of(decide(made, plain.rules)))
    row = next(row for row in page.rows if row[0] == "seams that were not measured")
    assert row[2].replace("\u00a0", " ").startswith(
        "50.0 m: an orthoimage ends there, or was not given; 25.0 m: the orthoimages do not explain the mosaic: "
        "changed, others, or too little texture; 25.0 m: too short to be measured; 25.0 m: not enough to measure it"
    )


def test_the_cover_says_what_was_judged_and_what_was_not(tmp_path: Path) -> None:
    mosaic = ground(tmp_path / "mosaic.tif")
    page = page_of(tmp_path, record_of(decided(), mosaics=(mosaic,)))
    assert "Judged in the luminance of the bands red, green, blue." in page.words
    assert "sharpness of the mosaic as a whole" in page.words
    assert "damage in one colour alone" in page.words


def test_what_has_no_limit_stands_among_the_rules(tmp_path: Path) -> None:
    """An eighth of the seams failed, without a rule on that."""
    lenient = decide(decided(failed=[(0, place) for place in range(0, 40, 8)]).delivery, rules(share=None, run=50.0))
    page = page_of(tmp_path, record_of(lenient))
    assert "Seams: Accepted" in page.words
    assert ["share of the seams that failed", "12.50\u00a0%", "no limit", "does not decide"] in page.rows


def test_a_band_wider_than_its_curve_is_known_and_panels_that_lack_are_told(tmp_path: Path) -> None:
    """The first failure's curve does not come back to 90 %, the second one's does, the third one's feather goes on."""
    plain = decided(failed=[(0, 3), (0, 20), (0, 30)])
    pieces = [*plain.delivery.pieces]
    for number, farthest, feather in ((3, 0.8, 0.0), (20, 1.0, 0.0), (30, 1.0, 40.0)):
        steps = (KeptBeside(0, 1, 0.45), KeptBeside(0, 1, 0.45), KeptBeside(1, 9, farthest))
        pieces[number] = replace(pieces[number], profile=steps, band_width_m=10.0, feather_width_m=feather)
    record = record_of(
        decide(replace(plain.delivery, pieces=tuple(pieces)), plain.rules), mosaics=(ground(tmp_path / "mosaic.tif"),)
    )
    pixels = np.zeros((8, 8, 3), np.uint8)
    mosaic, cut, image = (ProofPanel(kind, "a.tif", pixels) for kind in (MOSAIC_PANEL, CUT_PANEL, IMAGE_PANEL))
    seen = ((mosaic, cut, image, image), (mosaic, cut, image), (mosaic, image, image))
    pictures = {number: DefectPicture(pixels, 10.0, True, panels) for number, panels in enumerate(seen, 1)}
    save_acceptance_report(tmp_path / "report.html", record, pictures)
    words = outline((tmp_path / "report.html").read_text(encoding="utf-8")).words.replace("\u00a0", " ")
    first, second, third = words.split("least kept")[-3:]
    assert "band width at least 10.0 m" in first
    assert "band width 10.0 m" in second
    assert "band width at least 10.0 m" in third
    lacking = ["an orthoimage is not shown" in words for words in (first, second, third)]
    assert (lacking, "since pixels of the mosaic are missing around the place" in third) == ([False, True, False], True)
