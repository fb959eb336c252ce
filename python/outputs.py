"""What is written: by names that can be, over no input, and over nothing that no such run made."""
from __future__ import annotations

import os
from collections.abc import Iterable, Mapping

from ..plugin.imagery.errors import SettingsError
from ..plugin.imagery.file_identity import check_can_be_written, refuse_overwriting
from ..plugin.imagery.gdal_paths import FEATURES, RASTERS, open_dataset
from ..plugin.imagery.seam_totals import TOTALS_DOMAIN
from ..plugin.seams.measure.mending.mending import MENDED_DOMAIN
from . import messages

SEAMS, CELLS, WORST = "seams", "source_cells", "worst_windows"
"""Tables of a scan: pieces of seam, polygons of what lies where, and windows of the least kept places."""
GEOPACKAGE, GEOTIFF, PAGE, TABLE, VRT = (".gpkg",), (".tif", ".tiff"), (".html", ".htm"), (".csv",), (".vrt",)
"""Endings of outputs."""
MADE_BY = "<title>Seam Inspector"
_BEGINS = {PAGE: MADE_BY, TABLE: "window_id,"}  # what is in the first bytes of such a file
_BEGIN_BYTES = 1024
_DOMAINS = {GEOTIFF: TOTALS_DOMAIN, VRT: MENDED_DOMAIN}  # metadata domain that each kind of raster has


def check_writing(outputs: Mapping[str, tuple[str, tuple[str, ...]]], inputs: Iterable[str]) -> None:
    """``refuse_overwriting`` for outputs, paths and their endings by what they are called, that can be written, too.
    Raises SettingsError before anything is measured."""
    refuse_overwriting({title: path for title, (path, _) in outputs.items()}, inputs)
    for title, (path, endings) in outputs.items():
        check_can_be_written(title, path)
        if endings and not path.lower().endswith(endings):
            raise SettingsError(messages.OTHER_ENDING(output=title, path=path, ending=endings[0]))
        if os.path.isfile(path) and os.path.getsize(path) and not _is_replaceable(path, endings):
            raise SettingsError(messages.HOLDS_OTHER_DATA(output=title, path=path))


def _is_replaceable(path: str, endings: tuple[str, ...]) -> bool:
    """Whether a file that is there was made by such a run, where that can be told."""
    if endings in _BEGINS:
        with open(path, "rb") as file:
            return _BEGINS[endings].encode() in file.read(_BEGIN_BYTES)
    if endings in _DOMAINS:
        raster = open_dataset(path, RASTERS)
        return raster is not None and bool(raster.GetMetadata(_DOMAINS[endings]))
    if endings == GEOPACKAGE:
        tables = open_dataset(path, FEATURES)
        layers = [] if tables is None else [tables.GetLayer(number) for number in range(tables.GetLayerCount())]
        is_scan = any(layer.GetName() == SEAMS and layer.GetMetadata(TOTALS_DOMAIN) for layer in layers)
        return is_scan and {layer.GetName() for layer in layers} <= {SEAMS, CELLS, WORST}
    return True
