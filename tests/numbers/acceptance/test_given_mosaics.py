"""The mosaic that each layer of seams is of, beside those that are given."""
from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal
from seam_inspector.plugin.acceptance.measure.deciding import decide
from seam_inspector.plugin.acceptance.measure.decision import AcceptanceOutcome, Unmeasured
from seam_inspector.plugin.acceptance.measure.delivery import DeliveredLayer, Seal
from seam_inspector.plugin.acceptance.measure.scanned_files import file_doubts
from seam_inspector.plugin.imagery.file_identity import local_states, states_text
from seam_inspector.plugin.imagery.seam_totals import MOSAIC_FILES, SOURCE_FILES

from tests.numbers.acceptance.deliveries import delivery, rules, seam
from tests.numbers.acceptance.made_decisions import BOTTOM, LEFT, UTM
from tests.numbers.synthetic import write_raster


@pytest.fixture
def sheets(tmp_path: Path) -> list[str]:
    """Two sheets side by side, and a mosaic of another delivery."""
    paths = [str(tmp_path / f"{name}.tif") for name in ("east", "west", "other")]
    for number, path in enumerate(paths):
        write_raster(path, np.full((1, 40, 40), 50 + number, np.uint8), 0.5, (500000.0 + 20 * number, 5500000.0))
    return paths


def vrt(*paths: str) -> str:
    path = f"{paths[0]}.vrt"
    gdal.BuildVRT(path, list(paths)).FlushCache()
    return path


def layer_of(name: str, mosaic: str) -> DeliveredLayer:
    files = {MOSAIC_FILES: states_text(local_states([mosaic]).items()), "unexplained": "0.0"}
    return DeliveredLayer(name, Seal.WHOLE, 0.0, files)


@pytest.mark.parametrize(
    ("scanned", "given", "named"),
    [
        (lambda a, b, c: [a, c], lambda a, b, c: [a], "seams 1"),
        (lambda a, b, c: [a, b, c], lambda a, b, c: [vrt(a, b)], "seams 2"),
        (lambda a, b, c: [vrt(a, c)], lambda a, b, c: [a], "seams 0"),
        (lambda a, b, c: [a, b], lambda a, b, c: [vrt(a, b)], ""),
        (lambda a, b, c: [a, b], lambda a, b, c: [a, b, c][:2], ""),
        (lambda a, b, c: [vrt(a, b)], lambda a, b, c: [vrt(a, b)], ""),
        (lambda a, b, c: [vrt(a, b)], lambda a, b, c: [a, b], ""),
    ],
)
def test_a_layer_of_another_mosaic_than_the_given_decides_nothing(
    sheets: list[str], scanned: Callable[..., list[str]], given: Callable[..., list[str]], named: str
) -> None:
    layers = [layer_of(f"seams {number}", mosaic) for number, mosaic in enumerate(scanned(*sheets))]
    made = replace(delivery(seam([0.95] * 40)), layers=tuple(layers))
    decision = decide(replace(made, files=file_doubts(made, given(*sheets), [])), rules())
    words = f"layers of seams whose mosaics are not given: 1 ({named})"
    assert decision.outcome is (AcceptanceOutcome.UNDECIDED if named else AcceptanceOutcome.ACCEPTED)
    assert (words in str(decision.sentences[0])) is bool(named)
    assert any("leave the layers of others out" in str(sentence) for sentence in decision.sentences) is bool(named)


@pytest.mark.parametrize("count", [1, 2, 3])
def test_of_how_many_mosaics_layers_are_is_said_where_none_is_given(sheets: list[str], count: int) -> None:
    layers = [layer_of(path, path) for path in [*sheets[:count], sheets[0]]]
    made = replace(delivery(seam([0.95] * 40)), layers=tuple(layers))
    decision = decide(replace(made, files=file_doubts(made, [], [])), rules())
    assert decision.accepted
    words = f"The layers of seams are of {count} mosaics"
    assert any(str(sentence).startswith(words) for sentence in decision.sentences) is (count > 1)


GIVE = "complete and unchanged. Along 30 m, such as at 500045.0, 5500000.0, pixels are missing"


@pytest.mark.parametrize(("hole_px", "name", "lacks", "words"), [
    (12, "folder/B.TIF", "", GIVE), (12, "", "", GIVE), (0, "c.tif", "c.tif", "that are missing"),
    (12, "folder/B.TIF", "mosaic.tif", "the files that were scanned"), (3, "folder/B.TIF", "", ""), (2, "", "", ""),
])  # fmt: skip
def test_orthoimages_without_pixels_beside_a_seam_are_to_be_given(
    tmp_path: Path, hole_px: int, name: str, lacks: str, words: str
) -> None:
    """30 of 1000 m were not measured, where the second orthoimage has a hole around the seam, or was not given, and
    20 m may fail. It may end a few pixels from the seam, where the mosaic shows the first one."""
    paths = []
    for file in ("mosaic", "a", "b"):
        pixels = np.full((1, 200, 2000), 90, np.uint8)
        pixels[:, 100 - hole_px : 100 + hole_px, 80:140] = 0 if file == "b" else 90
        paths.append(write_raster(tmp_path / f"{file}.tif", pixels, 0.5, (LEFT, BOTTOM + 50), nodata=0))
    layer = layer_of("scan", paths[0])
    files = {**layer.settings, SOURCE_FILES: states_text(local_states(paths[1:]).items())}
    files.update({"not_given": lacks} if lacks == name else {})
    row = seam([0.95] * 4 + [None] * 3 + [0.95] * 93, start=(LEFT, BOTTOM))
    pieces = [replace(piece, left_source="a", right_source=name) for piece in row]
    if lacks == "mosaic.tif":
        (tmp_path / "mosaic.tif").unlink()
    made = replace(delivery(pieces), layers=(replace(layer, settings=files),), wkt=UTM)
    decision = decide(replace(made, files=file_doubts(made, (), ())), rules())
    kinds = {decided.unmeasured for decided in decision.pieces} - {None}
    assert kinds == {Unmeasured.UNCOVERED if words else Unmeasured.SHORT}
    assert decision.outcome is (AcceptanceOutcome.UNDECIDED if words else AcceptanceOutcome.ACCEPTED)
    assert words in str(decision.sentences[1])
