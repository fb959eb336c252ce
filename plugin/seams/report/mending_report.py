"""The report of seams that were cut anew, one HTML page."""
from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress
from pathlib import Path

from ...imagery.clips import read_clip
from ...imagery.errors import RasterError
from ...imagery.grids import standard_window
from ...imagery.lines import points_at, vertex_stations
from ...imagery.raster_pool import open_raster, rasters_kept
from ...imagery.rasters import RasterRef
from ...toolkit.pages.templates import HowMeasured, each_raster, measured_raster, save_page
from ...toolkit.pictures import encoded
from ...toolkit.translation import filled, formatted, sentence, shown_number, tr
from ..clip_pictures import stretched
from ..measure.limits import JUDGED_MAGNIFICATION
from ..measure.mending.mending import IMPROVED, LEFT, MENDED, MendedSeam, MendRequest, metres
from .clip_parts import REPORT_CLIP_PX

MOST_PICTURED = 100  # runs, those that keep least first; the others stand in the table


def save_mending_report(path: Path, request: MendRequest, mended: str, seams: Sequence[MendedSeam]) -> None:
    """Write the report. ``mended``: the mended mosaic. Raises SettingsError where no file can be."""
    words = {MENDED: tr("mended"), IMPROVED: tr("improved"), LEFT: tr("left")}
    shown = sorted((seam for seam in seams if seam.outcome != LEFT), key=lambda seam: seam.kept or 0.0)[:MOST_PICTURED]
    with rasters_kept():
        save_page(
            path, "mending",
            HowMeasured(
                [(tr("corridor on either side (m)"), shown_number(request.settings.width_m)),
                 (tr("blend (px)"), str(request.settings.blend_px))],
                [measured_raster(tr("mosaic"), request.mosaic),
                 *each_raster(tr("orthoimage"), (source.ref for source in request.sources))],
            ),
            is_whole=not metres(seams, LEFT, IMPROVED),
            lengths=[
                (formatted(metres(seams, outcome), ".0f"), filled(tr("metres {outcome}"), outcome=word))
                for outcome, word in words.items()
            ],
            rows=[
                [
                    _name(seam), formatted(seam.run.piece.length_m, ".1f"),
                    *(None if value is None else shown_number(value)
                      for value in (seam.run.kept, seam.kept, *seam.cut.steps, seam.cut.misfit)),
                    words[seam.outcome] if seam.reason is None else f"{words[seam.outcome]}: {sentence(seam.reason)}",
                ]
                for seam in seams
            ],
            sections=((_name(seam), list(_pictures(seam, request, mended))) for seam in shown),
            magnification=JUDGED_MAGNIFICATION,
        )


def _name(seam: MendedSeam) -> str:
    piece = seam.run.piece
    return filled(tr("{seam}, from {station} m"), seam=piece.seam_id, station=formatted(piece.station_m, ".0f"))


def _pictures(seam: MendedSeam, request: MendRequest, mended: str) -> Iterator[tuple[bytes, int, str]]:
    """The mosaic and the mended one at the old seam and at the new cut: JPEG, columns, and what it shows."""
    mosaic = request.mosaic
    old_seam = seam.run.piece.vertices
    for vertices, place in ((old_seam, tr("where the seam was")), (seam.vertices, tr("where it is now"))):
        along = vertex_stations(vertices)
        x, y = points_at(vertices, along, along[-1:] / 2)[0].tolist()
        window = standard_window(mosaic.grid, x, y, REPORT_CLIP_PX).moved_into(mosaic.columns, mosaic.rows)
        with suppress(RasterError):  # then there are none of this place
            clips = [
                read_clip(open_raster(ref), mosaic, window, partly=True, holes=True)
                for ref in (mosaic.ref, RasterRef(mended, mosaic.ref.wkt))
            ]
            for pixels, state in zip(stretched(clips), (tr("before"), tr("after"))):
                yield encoded(pixels, "JPEG"), window.width, f"{place}: {state}"
