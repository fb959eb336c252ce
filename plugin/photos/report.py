"""The report of an interior orientation: what was found, with a picture of each mark, in the user's language."""
from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from scipy import ndimage

from ..toolkit.pages.templates import HowMeasured, measured_raster, save_page, sentences_once, whole_path
from ..toolkit.pictures import encoded
from ..toolkit.translation import filled, formatted, sentence, shown_number, tr
from .measure import limits, messages
from .measure.camera_calibration import CameraCalibration
from .measure.mark_templates import MarkShape
from .measure.orientation import FittedTransformation, MarkResult, OrientationSettings, PhotoOrientation, parameters
from .measure.photo import Photo, PhotoView, Place

PICTURE_MAGNIFICATION = 8  # of a mark in the report
PICTURE_SIDE_PX = 900  # of such a picture: a larger mark is reduced first

_COLOURS = {limits.MEASURED: (0, 230, 130), limits.GIVEN: (255, 170, 0), limits.FAILED: (255, 70, 70)}


@dataclass(frozen=True)
class OrientationJob:
    photo: Photo
    calibration: CameraCalibration
    calibration_path: Path
    settings: OrientationSettings


def save_orientation_report(path: Path, job: OrientationJob, made: PhotoOrientation) -> None:
    """Write the report. Raises SettingsError where no file can be."""
    photo = job.photo
    how = HowMeasured(_settings(job, made), [measured_raster(tr("photo"), photo.raster)])
    save_page(
        path, "interior_orientation", how,
        name=photo.ref.name, figures=_figures(made), notices=sentences_once(made.notices),
        marks=[_row(mark) for mark in made.marks],
        pictures=[_picture(mark, made) for mark in made.marks if mark.name in made.views],
        scan=[] if made.fitted is None else _scan(job, made),
        transformation=None if made.fitted is None else _transformation(made.fitted),
        scan_orientation=made.scan_orientation,
        evidence=None if made.evidence is None else sentence(messages.WORDS[made.evidence]),
    )  # fmt: skip


def _figures(made: PhotoOrientation) -> list[tuple[str, str]]:
    words = {limits.MEASURED: tr("marks measured"), limits.GIVEN: tr("marks given"), limits.FAILED: tr("marks failed")}
    figures = [(str(made.count(status)), name) for status, name in words.items()]
    if made.fitted is not None and made.fitted.redundancy:
        rms = filled("{rms:.1f} µm", rms=made.fitted.rms)
        figures.insert(0, (rms, tr("root mean square of the residuals")))
    return figures


def _row(mark: MarkResult) -> list[str | None]:
    column, row = mark.place or (None, None)
    residual_x, residual_y = mark.residual or (None, None)
    return [
        mark.name, _number(column, 3), _number(row, 3), _number(mark.calibrated[0], 3),
        _number(mark.calibrated[1], 3), _number(residual_x, 1), _number(residual_y, 1),
        _number(mark.correlation, 3), sentence(messages.WORDS[mark.status]),
        None if mark.reason is None else sentence(mark.reason),
    ]  # fmt: skip


def _transformation(fitted: FittedTransformation) -> dict[str, object]:
    rows = 3 if fitted.to_mm.model == limits.PROJECTIVE else 2  # the others' third is 0 0 1
    return {
        "model": sentence(messages.WORDS[fitted.to_mm.model]),
        "marks": fitted.marks,
        "redundancy": fitted.redundancy,
        "elements": [
            (f"m{row + 1}{column + 1}", formatted(fitted.to_mm.matrix[row, column], ".9g"),
             formatted(fitted.to_pixels.matrix[row, column], ".9g"))
            for row in range(rows) for column in range(3)
        ],
    }


def _scan(job: OrientationJob, made: PhotoOrientation) -> list[tuple[str, str]]:
    """Facts of the scan and of the camera in it, by the transformation."""
    values = parameters(job.photo, job.calibration, made)
    facts = [
        (tr("pixel size"), filled("{x:.3f} x {y:.3f} µm", **values["pixel_size_um"])),
        (tr("rotation"), filled("{angle:.3f} deg", angle=values["rotation_deg"])),
        (tr("shear"), filled("{angle:.4f} deg", angle=values["shear_deg"])),
        (tr("principal point"), filled("{column:.2f}, {row:.2f} px", **values["principal_point_px"])),
    ]
    if values["focal_length_mm"] is not None:
        size = {"mm": values["focal_length_mm"], "px": values["focal_length_px"]}
        facts.append((tr("focal length"), filled("{mm:.3f} mm, {px:.1f} px", **size)))
    return facts


def _settings(job: OrientationJob, made: PhotoOrientation) -> list[tuple[str, str]]:
    settings, template = job.settings, made.template
    facts = [(tr("calibration"), whole_path(str(job.calibration_path)))]
    if isinstance(template, MarkShape):
        words = sentence(messages.WORDS[template.kind])
        facts.append((tr("marks drawn as"), filled("{words}, {size:.1f} px", words=words, size=template.size)))
    elif template is not None:
        rows, columns = template.pixels.shape
        facts.append((tr("template"), filled("{columns} x {rows} px", columns=columns, rows=rows)))
    largest = filled("{mm:.3f} mm", mm=limits.FILM_DEFORMATION * job.calibration.span)
    return [
        *facts,
        (tr("smallest correlation"), shown_number(settings.min_correlation, 2)),
        (tr("search"), filled("{mm:g} mm", mm=settings.search_mm)),
        (tr("surface"), sentence(messages.WORDS[settings.surface])),
        (tr("largest distance of a mark from its place"), largest),
    ]


def _picture(mark: MarkResult, made: PhotoOrientation) -> tuple[bytes, int, str]:
    """A PNG file, its columns, and its caption."""
    place = mark.place or made.expected[mark.name]
    words = f"{mark.name}: {shown_number(place[0])}; {shown_number(place[1])}"
    if mark.place is None:
        words += ", " + tr("failed; it should be here")
    elif mark.correlation is not None:
        words += ", " + filled(tr("correlation {value:.2f}"), value=mark.correlation)
    pixels = marked(mark.status, place, made.views[mark.name])
    return encoded(pixels, "PNG"), pixels.shape[1], words


def marked(status: str, place: Place, view: PhotoView) -> np.ndarray:
    """The surroundings of a mark, magnified, with a cross at its place: (rows, columns, 3) uint8."""
    times = PICTURE_MAGNIFICATION
    low, high = np.percentile(view.pixels, (0.5, 99.5))
    grey = np.clip((view.pixels - low) / max(float(high - low), 1e-9), 0, 1) * 255
    step = max(1, math.ceil(max(grey.shape) * times / PICTURE_SIDE_PX))
    shown = np.kron(ndimage.zoom(grey, 1 / step, order=1) if step > 1 else grey, np.ones((times, times)))
    picture = np.repeat(np.rint(shown)[..., np.newaxis], 3, axis=2).astype(np.uint8)
    x = round((place[0] - view.left) * times / step - 0.5)
    y = round((place[1] - view.top) * times / step - 0.5)
    arm, gap, thin = 3 * times, times // 2, slice(-1, 2)
    arms, middle = (slice(-arm, -gap), slice(gap + 1, arm + 1)), slice(0, 1)
    for rows, columns in (*((thin, arm) for arm in arms), *((arm, thin) for arm in arms), (middle, middle)):
        picture[y + rows.start : y + rows.stop, x + columns.start : x + columns.stop] = _COLOURS[status]
    return picture


def _number(value: float | None, digits: int) -> str | None:
    return None if value is None else formatted(round(value, digits) + 0.0, f".{digits}f")  # no -0.0
