"""Algorithms one after the other with Python's collector off, in a process of their own: `python -m tests.qgis.chains`.

Each first call imports what it needs while it runs, as a user's first call does. Prints how many features each layer
holds at the moment its algorithm has ended: of a file, what a copy of it holds.
"""
from __future__ import annotations

import gc

gc.disable()

import csv  # noqa: E402
import json  # noqa: E402
import shutil  # noqa: E402
import sys  # noqa: E402
from pathlib import Path  # noqa: E402
from typing import Any, Callable  # noqa: E402

from qgis.core import (  # noqa: E402
    QgsApplication,
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsProcessingUtils,
    QgsVectorLayer,
)
from seam_inspector.plugin.provider import SeamInspectorProvider  # noqa: E402

MEMORY = "TEMPORARY_OUTPUT"
KINDS = {"gpkg": (".gpkg", ".gpkg"), "csv": (".gpkg", ".csv"), "memory": (MEMORY, MEMORY)}
"""Endings of layers with geometry and of tables."""
Results = dict[str, Any]


class Log(QgsProcessingFeedback):
    """What went wrong, for whoever reads why a chain broke."""

    def reportError(self, error: str, fatalError: bool = False) -> None:
        sys.stderr.write(error + "\n")


class Runner:
    """Runs algorithms whose layers go to one kind of output, and counts what they left."""

    def __init__(self, folder: Path, kind: str) -> None:
        self.folder, self.counts = folder, dict[str, int]()
        self._endings = KINDS[kind]
        self._context = QgsProcessingContext()
        folder.mkdir()

    def __call__(self, name: str, **parameters: Any) -> Results:
        algorithm = QgsApplication.processingRegistry().createAlgorithmById(f"seaminspector:{name}")
        sinks = [output for output in algorithm.destinationParameterDefinitions() if output.type() == "sink"]
        for sink in sinks:
            ending = self._endings[not sink.hasGeometry()]
            path = str(self.folder / f"{len(self.counts)}_{name}_{sink.name().replace(':', '_')}{ending}")
            parameters[sink.name()] = MEMORY if ending == MEMORY else path
        results, succeeded = algorithm.run(parameters, self._context, Log())
        assert succeeded, name
        for sink in sinks:
            self.counts[f"{name} {sink.name()}"] = self._count(results[sink.name()])
        return dict(results)

    def _count(self, result: str) -> int:
        if not Path(result).is_file():
            return int(QgsProcessingUtils.mapLayerFromString(result, self._context).featureCount())
        copy = shutil.copy(result, self.folder / f"copy{len(self.counts)}{Path(result).suffix}")
        return len(list(QgsVectorLayer(str(copy), "copy", "ogr").getFeatures()))

    def layer(self, result: str) -> QgsVectorLayer:
        return QgsProcessingUtils.mapLayerFromString(result, self._context)


def seams(run: Runner, given: Results) -> None:
    images = {"MOSAIC": given["mosaic"], "SOURCES": given["sources"]}
    placed = run("placewindows", SEAMLINES=given["seams"], MOSAIC=given["mosaic"], SIDE=6.4, SPACING=6.4)
    inspected = run("inspectwindows", WINDOWS=placed["OUTPUT"], **images)
    tables = {"WINDOWS": inspected["OUTPUT"], "PAIRS": inspected["PAIRS"]}
    run("report", CURVES=inspected["CURVES"], OUTPUT=str(run.folder / "report.html"), **tables, **images)
    run("calibratethreshold", **tables)
    run("predictloss", WINDOWS=placed["OUTPUT"], SOURCES=given["sources"])
    run("checknoise", WINDOWS=placed["OUTPUT"], RASTERS=given["sources"], LEVELS=2)
    run("checkradiometry", WINDOWS=placed["OUTPUT"], RASTERS=given["sources"])


def model(run: Runner, given: Results) -> None:
    layers = {"seamlines": given["seams"], "mosaic": given["mosaic"], "sources": given["sources"]}
    made = run("inspect_mosaic", **layers, side=6.4, spacing=6.4)
    run("calibratethreshold", WINDOWS=made["inspect:windows"], PAIRS=made["inspect:pairs"])


def resolution(run: Runner, given: Results) -> None:
    measured = run("measureresolution", RASTER=given["target"], GROUPS=given["bars"], REFERENCE_GRD=100)
    observations = run.folder / "observations.csv"
    with open(observations, "w", newline="", encoding="utf-8") as file:
        rows = csv.writer(file)
        rows.writerow(["height", "grd"])
        rows.writerows([3000, row["grd"]] for row in run.layer(measured["OUTPUT"]).getFeatures())
    run("minimumheight", OBSERVATIONS=str(observations))


def photos(run: Runner, given: Results) -> None:
    photo = {"PHOTO": given["photo"], "CALIBRATION": given["calibration"], "TEMPLATE_KIND": "ring with cross"}
    first = run("interiororientation", **photo)["OUTPUT"]
    second = run("interiororientation", MODEL="similarity", **photo)["OUTPUT"]
    run("comparemarks", FIRST=first, SECOND=second)


def sensors(run: Runner, given: Results) -> None:
    model_file = str(run.folder / "model.json")
    fit = {"MODEL": "polynomial_3d", "HEIGHTS": "ellipsoid", "CHECK_SHARE": 0.2}
    residuals = run("fitsensormodel", GCPS=given["gcps"], MODEL_FILE=model_file, **fit)["OUTPUT"]
    run("comparesensormodels", GCPS=residuals, HEIGHTS="ellipsoid")
    ortho = str(run.folder / "ortho.tif")
    run("orthorectify", IMAGE=given["image"], MODEL_FILE=model_file, HEIGHT=0, CRS="EPSG:32633", OUTPUT=ortho)
    assert Path(ortho).is_file()


CHAINS: dict[str, Callable[[Runner, Results], None]] = {
    chain.__name__: chain for chain in (seams, model, resolution, photos, sensors)
}


def main() -> None:
    chain, given, folder = sys.argv[1], json.loads(sys.argv[2]), Path(sys.argv[3])
    application = QgsApplication([], False)
    application.initQgis()
    provider = SeamInspectorProvider()
    QgsApplication.processingRegistry().addProvider(provider)
    counts = {}
    for kind in KINDS:
        run = Runner(folder / kind, kind)
        CHAINS[chain](run, given)
        counts[kind] = run.counts
    sys.stdout.write(json.dumps(counts))


if __name__ == "__main__":
    main()
