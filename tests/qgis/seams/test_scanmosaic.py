"""``seaminspector:scanmosaic``: its contract, on a small mosaic of two orthoimages with a crooked seam."""
from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest
from osgeo import gdal
from qgis.core import (
    QgsProcessingModelAlgorithm,
    QgsProcessingModelChildAlgorithm,
    QgsProcessingModelChildParameterSource,
    QgsProcessingModelOutput,
    QgsProcessingModelParameter,
    QgsProcessingParameterRasterLayer,
    QgsRasterLayer,
)

from tests.qgis.runs import Run, run
from tests.qgis.seams.scan_scenes import (
    COLUMNS,
    ROWS,
    SEAM_METRES,
    Files,
    drawn_seam,
    points_along,
    share_within,
    write_scene,
)

pytestmark = pytest.mark.usefixtures("provider")

FEATHER_PX = 24.0


@pytest.fixture(scope="module")
def hard(tmp_path_factory: pytest.TempPathFactory) -> Files:
    return write_scene(tmp_path_factory.mktemp("hard"))


@pytest.fixture(scope="module")
def feathered(tmp_path_factory: pytest.TempPathFactory) -> Files:
    return write_scene(tmp_path_factory.mktemp("feathered"), width=FEATHER_PX)


@pytest.fixture(scope="module")
def scanned(provider: None, feathered: Files, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Run]:
    """The feathered mosaic, its seams found."""
    made = run("scanmosaic", **feathered.given(LOSS=str(tmp_path_factory.mktemp("scanned") / "loss.tif")))
    yield made
    made.close()


def test_fields_and_numbers(scanned: Run) -> None:
    assert scanned.complaint is None
    assert scanned.log.warnings == scanned.log.errors == []
    assert scanned.layer("SEAMS").fields().names() == [
        "seam_id", "station", "left_source", "right_source", "left_date", "right_date", "length", "level", "state",
        "kept_1", "kept_2", "kept_3", "kept_low", "kept_high", "band_width", "feather_width", "visibility", "profile",
        "verdict", "reason",
    ]
    assert scanned.layer("CELLS").fields().names() == ["source"]
    assert scanned.layer("WORST").fields().names() == ["window_id", "seam_id", "station"]
    pieces, numbers = scanned.rows("SEAMS"), scanned.results
    assert numbers["SEAM_METRES"] == pytest.approx(sum(piece["length"] for piece in pieces))
    assert numbers["SEAM_METRES"] == pytest.approx(SEAM_METRES, rel=0.02)
    failed = [piece["length"] for piece in pieces if piece["state"] == "failed"]
    assert {piece["level"] for piece in pieces} == {"piece"}
    assert all((piece["state"] == "failed") == (piece["kept_1"] < 0.7) for piece in pieces)
    assert numbers["FAILED_METRES"] == pytest.approx(sum(failed))
    assert numbers["WORST_KEPT"] == min(piece["kept_1"] for piece in pieces)
    assert {tuple(sorted((item["left_source"], item["right_source"]))) for item in pieces} == {("east.tif", "west.tif")}
    for item in pieces:
        assert item["verdict"] == "significant"
        assert item["kept_low"] < item["kept_1"] < item["kept_high"] < 1
        assert item["kept_1"] == pytest.approx(0.65, abs=0.08)
        assert item["band_width"] == pytest.approx(0.1 * FEATHER_PX, rel=0.5)
        assert 0.7 < item["visibility"] < 2


def test_seams_lie_where_the_images_meet(scanned: Run) -> None:
    result = points_along((feature.geometry() for feature in scanned.features("SEAMS")), 0.05)
    true = points_along((item.geometry() for item in drawn_seam().getFeatures()), 0.05)
    assert share_within(result, true, 0.3) > 0.95
    assert share_within(true, result, 0.3) > 0.95


def test_cells_say_where_each_part_came_from(scanned: Run, feathered: Files) -> None:
    parts = {feature["source"]: feature.geometry() for feature in scanned.features("CELLS")}
    assert set(parts) == {"west.tif", "east.tif"}
    whole = QgsRasterLayer(feathered.mosaic).extent()
    assert sum(part.area() for part in parts.values()) == pytest.approx(whole.width() * whole.height(), rel=0.01)
    assert parts["west.tif"].area() == pytest.approx(0.3 * whole.width() * whole.height(), rel=0.05)
    assert parts["west.tif"].intersection(parts["east.tif"]).area() == pytest.approx(0, abs=1e-6)
    assert all(part.isGeosValid() for part in parts.values())


def test_the_picture_of_losses(scanned: Run) -> None:
    dataset = gdal.Open(scanned.results["LOSS"])
    assert (dataset.RasterXSize, dataset.RasterYSize) == (-(-COLUMNS // 32), -(-ROWS // 32))
    bands = {dataset.GetRasterBand(i).GetDescription(): dataset.GetRasterBand(i) for i in range(1, 6)}
    assert list(bands) == ["kept_1", "contrast_1", "added_1", "source", "mixture"]
    kept, source = (bands[name].ReadAsArray() for name in ("kept_1", "source"))
    assert bands["source"].GetCategoryNames()[1:] in (["west.tif", "east.tif"], ["east.tif", "west.tif"])
    nodata = bands["kept_1"].GetNoDataValue()
    beside = np.abs((np.arange(kept.shape[1]) + 0.5) * 32 - 0.3 * COLUMNS) < 64
    far, near = kept[:, ~beside], kept[:, beside]
    assert np.median(far[far != nodata]) == pytest.approx(1, abs=0.1)
    assert (near[near != nodata] < 0.85).any()
    west = bands["source"].GetCategoryNames().index("west.tif")
    assert (source[:, 0] == west).all()
    assert (source[:, -1] == 3 - west).all()
    assert float(bands["kept_1"].GetMetadataItem("STATISTICS_MINIMUM")) < 0.85
    assert gdal.Info(dataset, format="json")["cornerCoordinates"]["upperLeft"] == [500000.0, 5000000.0]


def test_a_sound_mosaic_has_no_failed_metre(hard: Files) -> None:
    outcome = run("scanmosaic", **hard.given())
    assert outcome.results["FAILED_METRES"] == 0
    assert outcome.results["WORST_KEPT"] > 0.95
    assert set(outcome.column("verdict", "SEAMS")) == {"preserved"}


def test_worst_windows_are_ready_to_be_inspected(scanned: Run, feathered: Files) -> None:
    worst = scanned.features("WORST")
    assert [item["window_id"] for item in worst] == list(range(1, len(worst) + 1))
    least = min(scanned.features("SEAMS"), key=lambda feature: feature["kept_1"])
    assert worst[0].geometry().intersects(least.geometry())
    given = {"MOSAIC": feathered.mosaic, "SOURCES": feathered.sources, "WINDOWS": scanned.layer("WORST")}
    inspected = run("inspectwindows", **given)
    assert inspected.column("verdict")[0] == "significant"
    assert run("scanmosaic", **feathered.given(WORST_COUNT=1)).column("window_id", "WORST") == [1]
    assert run("scanmosaic", **feathered.given(WORST_COUNT=0)).column("window_id", "WORST") == []


def test_seamlines_that_are_given_are_used(feathered: Files) -> None:
    drawn = drawn_seam()
    outcome = run("scanmosaic", **feathered.given(SEAMLINES=drawn))
    ours, theirs = (points_along((item.geometry() for item in made), 0.05)
                    for made in (outcome.features("SEAMS"), drawn.getFeatures()))
    assert share_within(ours, theirs, 0.16) == share_within(theirs, ours, 0.16) == 1  # straightened by 1.5 px
    assert set(outcome.column("verdict", "SEAMS")) == {"significant"}
    assert {tuple(sorted(pair)) for pair in zip(outcome.column("left_source", "SEAMS"),
                                                outcome.column("right_source", "SEAMS"))} == {("east.tif", "west.tif")}
    corridor = run("scanmosaic", **feathered.given(SEAMLINES=drawn, CORRIDOR=3.0))
    assert corridor.column("verdict", "SEAMS") == outcome.column("verdict", "SEAMS")
    assert corridor.column("kept_1", "SEAMS") == pytest.approx(outcome.column("kept_1", "SEAMS"), abs=0.05)


def test_without_orthoimages_seamlines_are_enough(feathered: Files) -> None:
    outcome = run("scanmosaic", MOSAIC=feathered.mosaic, SEAMLINES=drawn_seam(), PIECE=60.0)
    assert outcome.complaint is None
    assert outcome.results["SEAM_METRES"] == pytest.approx(SEAM_METRES, rel=0.02)
    (piece,) = outcome.rows("SEAMS")
    assert piece["kept_low"] < piece["kept_1"] < piece["kept_high"]
    assert any("All seams together keep" in said for said in outcome.log.infos)


def test_it_is_a_step_of_a_model(hard: Files, feathered: Files) -> None:
    """Its windows of the worst places go on to ``inspectwindows``."""
    model = QgsProcessingModelAlgorithm("scan and inspect", "scan")
    model.addModelParameter(QgsProcessingParameterRasterLayer("mosaic"), QgsProcessingModelParameter("mosaic"))
    source = QgsProcessingModelChildParameterSource
    scan, inspect = (QgsProcessingModelChildAlgorithm(f"seaminspector:{name}")
                     for name in ("scanmosaic", "inspectwindows"))
    for step, name in ((scan, "scan"), (inspect, "inspect")):
        step.setChildId(name)
        step.addParameterSources("MOSAIC", [source.fromModelParameter("mosaic")])
        step.addParameterSources("SOURCES", [source.fromStaticValue(path) for path in feathered.sources])
    scan.addParameterSources("PIECE", [source.fromStaticValue(20.0)])
    inspect.addParameterSources("WINDOWS", [source.fromChildOutput("scan", "WORST")])
    for step, name in ((scan, "LOSS"), (scan, "SEAMS"), (inspect, "OUTPUT")):
        made = QgsProcessingModelOutput(name, name)
        made.setChildId(step.childId())
        made.setChildOutputName(name)
        step.setModelOutputs({**step.modelOutputs(), name: made})
    model.addChildAlgorithm(scan)
    model.addChildAlgorithm(inspect)
    model.updateDestinationParameters()
    for files, verdict in ((hard, "preserved"), (feathered, "significant")):
        outcome = run(model.create(), mosaic=files.mosaic)
        assert outcome.complaint is None
        ends = "seams", "output"  # QGIS 3.22 calls one scan:SEAMS, later ones seams
        seams, inspected = (next(key for key in outcome.results if key.lower().endswith(end)) for end in ends)
        assert set(outcome.column("verdict", seams)) == {verdict}
        assert outcome.column("verdict", inspected)[0] == verdict
