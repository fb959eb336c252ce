"""The report of an interior orientation: what was found, with a picture of each mark, in the user's language."""
from __future__ import annotations

import math

import numpy as np
from scipy import ndimage

from ..imagery.photos import Photo
from ..toolkit.pages import html_page
from ..toolkit.translation import sentence, tr
from .measure.measuring_marks import Window
from .measure.orientation import Mark, Orientation, Status

PICTURE_MAGNIFICATION = 8  # of a mark in the report
PICTURE_SIDE_PX = 900  # of such a picture: a larger mark is reduced first

_COLOURS = {Status.MEASURED: (0, 230, 130), Status.GIVEN: (255, 170, 0)}


def orientation_page(photo: Photo, made: Orientation) -> str:
    """One HTML page."""
    parts = [_summary(photo, made)]
    parts += [html_page.paragraph(sentence(notice), "warning") for notice in made.notices]
    parts += [html_page.heading(tr("Marks")), _table(made)]
    pictures = [_picture(mark, made.views[mark.name]) for mark in made.marks if mark.name in made.views]
    if pictures:
        parts += [html_page.heading(tr("Pictures")), _legend(), html_page.row(pictures)]
    if made.fitted is not None:
        parts += [html_page.heading(tr("Transformation")), _transformation(made)]
    return html_page.page(tr("Interior orientation of {name}").format(name=photo.ref.name), parts)


def _summary(photo: Photo, made: Orientation) -> html_page.Html:
    measured, given = made.count(Status.MEASURED), made.count(Status.GIVEN)
    words = tr("{columns} x {rows} px. Marks measured: {measured}, given: {given}, failed: {failed}.").format(
        columns=photo.columns, rows=photo.rows, measured=measured, given=given, failed=made.count(Status.FAILED)
    )
    if made.fitted is not None and made.fitted.redundancy:
        words += " " + tr("Root mean square of the residuals: {rms:.1f} um.").format(rms=made.fitted.rms)
    return html_page.paragraph(words)


def _table(made: Orientation) -> html_page.Html:
    headings = [
        tr("Mark"), tr("Column, px"), tr("Row, px"), tr("x, mm"), tr("y, mm"), tr("Residual x, um"),
        tr("Residual y, um"), tr("Correlation"), tr("Status"), tr("Reason"),
    ]
    rows = []
    for mark in made.marks:
        column, row = mark.place or (None, None)
        residual_x, residual_y = mark.residual or (None, None)
        rows.append([
            mark.name, _number(column, 3), _number(row, 3), _number(mark.calibrated[0], 3),
            _number(mark.calibrated[1], 3), _number(residual_x, 1), _number(residual_y, 1),
            _number(mark.correlation, 3), mark.status.value,
            None if mark.reason is None else sentence(mark.reason),
        ])
    note = tr("Pixel centres are at .5: the first pixel reaches from 0 to 1. Millimetres: x to the right, y upwards.")
    return html_page.Html(html_page.table(headings, rows) + html_page.paragraph(note, "small"))


def _transformation(made: Orientation) -> html_page.Html:
    assert made.fitted is not None
    rows = [
        [name, *(f"{value:.9g}" for value in matrix.ravel())]
        for name, matrix in (
            (tr("to millimetres"), made.fitted.to_mm.matrix), (tr("to pixels"), made.fitted.to_pixels.matrix)
        )
    ]
    words = tr("Model: {model}, marks: {marks}, degrees of freedom: {redundancy}.").format(
        model=made.fitted.to_mm.model.value, marks=made.fitted.marks, redundancy=made.fitted.redundancy
    )
    if made.lying is not None and made.evidence is not None:
        words += " " + tr(
            "The photo lies turned by {turned} degrees clockwise{mirrored}, as known by: {evidence}."
        ).format(
            turned=made.lying.turned, mirrored=tr(" and mirrored") if made.lying.mirrored else "",
            evidence=made.evidence.value,
        )
    headings = ["", *(f"m{row}{column}" for row in "123" for column in "123")]
    return html_page.Html(html_page.paragraph(words) + html_page.table(headings, rows))


def _legend() -> html_page.Html:
    return html_page.paragraph(
        tr("Each pixel is shown {times} times as wide; the cross stands where the mark was found.").format(
            times=PICTURE_MAGNIFICATION
        ),
        "small",
    )


def _picture(mark: Mark, view: Window) -> html_page.Html:
    assert mark.place is not None
    words = f"{mark.name}: {mark.place[0]:.2f}, {mark.place[1]:.2f}"
    if mark.correlation is not None:
        words += ", " + tr("correlation {value:.2f}").format(value=mark.correlation)
    return html_page.picture(marked(mark, view), words, lossless=True)


def marked(mark: Mark, view: Window) -> np.ndarray:
    """The surroundings of a mark, magnified, with a cross at its place: (rows, columns, 3) uint8."""
    assert mark.place is not None
    times = PICTURE_MAGNIFICATION
    low, high = np.percentile(view.pixels, (0.5, 99.5))
    grey = np.clip((view.pixels - low) / max(float(high - low), 1e-9), 0, 1) * 255
    step = max(1, math.ceil(max(grey.shape) * times / PICTURE_SIDE_PX))
    shown = np.kron(ndimage.zoom(grey, 1 / step, order=1) if step > 1 else grey, np.ones((times, times)))
    picture = np.repeat(np.rint(shown)[..., np.newaxis], 3, axis=2).astype(np.uint8)
    x = round((mark.place[0] - view.left) * times / step - 0.5)
    y = round((mark.place[1] - view.top) * times / step - 0.5)
    arm, gap, thin = 3 * times, times // 2, slice(-1, 2)
    for rows, columns in (
        (thin, slice(-arm, -gap)), (thin, slice(gap + 1, arm + 1)), (slice(-arm, -gap), thin),
        (slice(gap + 1, arm + 1), thin), (slice(0, 1), slice(0, 1)),
    ):
        picture[y + rows.start : y + rows.stop, x + columns.start : x + columns.stop] = _COLOURS[mark.status]
    return picture


def _number(value: float | None, digits: int) -> str | None:
    return None if value is None else f"{value:.{digits}f}"
