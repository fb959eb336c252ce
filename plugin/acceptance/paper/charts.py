"""Charts of a decision: how many metres kept how much, and where seams failed."""
from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from itertools import chain

import numpy as np
from matplotlib import patheffects
from matplotlib.axes import Axes
from matplotlib.colors import to_hex, to_rgb
from matplotlib.figure import Figure

from ...imagery.clips import read_overview
from ...imagery.errors import RasterError, printable
from ...imagery.grids import Extent, middle_of
from ...imagery.rasters import Raster
from ...imagery.reference_systems import extent_on, metres_per_unit
from ...imagery.seam_totals import PieceState
from ...toolkit.charts.chart_style import PAPER
from ...toolkit.charts.figure_files import new_figure
from ...toolkit.charts.round_ticks import round_below
from ...toolkit.picture_stretch import cut_range
from ...toolkit.translation import filled, formatted, tr
from ..measure.decision import Decision, Defect
from ..measure.delivery import DeliveredPiece, extent_of
from .words import SHEET_COLOURS

_SIZE = (6.2, 3.4)  # inches
_MOST_KEPT = 1.3  # beyond it nothing is of interest


def kept_figure(decision: Decision) -> Figure:
    """The share of the metres that kept less than each value, with the limit."""
    figure = new_figure(*_SIZE)
    axes = figure.add_subplot()
    pieces = [decided.piece for decided in decision.pieces]
    known = [(piece.kept_1, piece.length_m) for piece in pieces if piece.kept_1 is not None]
    if known:
        kept, lengths = np.array(sorted(known)).T
        shares = 100 * np.cumsum(lengths) / lengths.sum()
        axes.step(np.minimum(kept, _MOST_KEPT), shares, where="post", color=PAPER.sources[0], linewidth=2)
    least = decision.rules.least_kept
    axes.axvline(least, color=PAPER.limit, linewidth=1.5, label=filled(tr("least: {least:g}"), least=least))
    share = decision.whole.failed_share
    if share is not None:
        words = filled(tr("failed: {share:.2f} %"), share=100 * share)
        axes.axhline(100 * share, color=PAPER.text, linewidth=1, linestyle=":", label=words)
    axes.set_xlabel(tr("share of detail kept (kept_1)"))
    axes.set_ylabel(tr("metres that kept less (%)"))
    axes.set_xlim(0, _MOST_KEPT)
    axes.set_ylim(0, 102)
    axes.grid(True, color=PAPER.grid, linewidth=0.8)
    axes.spines[["top", "right"]].set_visible(False)
    axes.legend(frameon=False, fontsize=8)
    return figure


_PROFILE_SIZE = (2.2, 1.75)  # inches: beside the pictures of a failure


def profile_figure(piece: DeliveredPiece, least_kept: float) -> Figure:
    """What a piece kept by distance from its seam, as its scan wrote it: the judged strip, the curve, the limit."""
    strip, *steps = piece.profile
    figure = new_figure(*_PROFILE_SIZE)
    axes = figure.add_subplot()
    axes.axvspan(0, strip.far_m, color=PAPER.grid, linewidth=0)
    axes.axhline(least_kept, color=PAPER.limit, linewidth=1)
    axes.plot(*np.array([(x, step.kept) for step in steps for x in (step.near_m, step.far_m)]).reshape(-1, 2).T,
              color=PAPER.sources[0], linewidth=1.2)
    axes.plot([0, strip.far_m], [strip.kept] * 2, color=PAPER.text, linewidth=2.5, solid_capstyle="butt")
    farthest = max((step.far_m for step in steps), default=strip.far_m)
    axes.set_xscale("function", functions=(lambda x: np.sqrt(np.maximum(x, 0)), np.square))  # narrow steps matter most
    axes.set_xlim(0, farthest)
    axes.set_xticks([strip.far_m, farthest / 4, farthest])
    axes.xaxis.set_major_formatter(lambda x, _: formatted(x, ".2g"))
    axes.minorticks_off()
    axes.set_ylim(0, max(_MOST_KEPT, *(step.kept for step in piece.profile)))
    axes.set_xlabel(tr("distance from the seam (m)"), fontsize=6.5)
    axes.tick_params(labelsize=6.5)
    axes.spines[["top", "right"]].set_visible(False)
    return figure


STATE_COLOURS = {
    PieceState.NO_DETAIL: "#b9bec4", PieceState.PASSED: "#57606a", PieceState.NOT_MEASURED: "#56b4e9",
    PieceState.FAILED: "#d55e00",
}  # fmt: skip
"""In the order in which they are drawn."""
_WIDTHS = {PieceState.NO_DETAIL: 0.5, PieceState.PASSED: 0.7, PieceState.NOT_MEASURED: 1.0, PieceState.FAILED: 2.2}
_WIDTH, _MOST_HEIGHT, _LEAST_HEIGHT = 6.7, 6.2, 1.6  # inches on paper
_STRIP = 0.35  # inches: below the map, for scale bar and north
_MARGIN = 0.04  # of the longer side
_MOST_SHEET_NAMES = 60
_BACKDROP_PX, _LEAST_BACKDROP_PX = 640, 16  # the longer side of the mosaics on the map, and of one of many
_PALEST, _GREYS = 0.55, 31  # the darkest grey of that, and how many: more make the file larger, and nothing clearer
_SHEET_ALPHA, _SHEET_EDGE = 0.2, "#57606a"
_LEGEND_ALPHA = 0.35
_TICKS, _TICK_PT, _COORDINATE_PT = 4, 3.0, 5.5  # coordinates along the longer side, their marks and letters
_CORNER_PT = 24.0  # a coordinate's length, about: none lies on another at a corner, or is cut off there
_NAME_PT, _LETTER_PT = 6.0, 3.6  # a sheet's name, and how wide a letter of it is about
_HALO = [patheffects.withStroke(linewidth=1.6, foreground="white")]
_NAME_COLOUR, _LEAST_LETTERS = "#57606a", 12
_CROWDED_NAMES_PT = (45.0, 9.0)  # likewise of sheets
_CROWDED_PT = (18.0, 9.0)  # across and up: numbers of failures are not nearer to each other than that
_BESIDE_PT = 11.0 * np.array([(1, 1), (-1, 1), (1, -1), (-1, -1)])
"""Offsets at which a number may stand beside its place."""


def seams_figure(decision: Decision, defects: Sequence[Defect], mosaics: Sequence[Raster] = ()) -> Figure | None:
    """A sketch map: the mosaics in pale grey, sheets by their verdicts, seams by what became of them, the numbers of
    failures, coordinates along the frame. None without seams."""
    if not decision.pieces:
        return None
    wkt, outlines = decision.delivery.wkt, decision.delivery.sheet_rings()
    seams = [decided.piece.vertices for decided in decision.pieces]
    corners = np.reshape(extent_of([*seams, *chain(*outlines.values())]), (2, 2))
    metres = np.array(metres_per_unit(wkt, middle_of((*corners[0], *corners[1]))))
    margin = max(*(np.diff(corners, axis=0)[0] * metres), 1.0) * _MARGIN / metres
    corners += np.outer((-1, 1), margin)
    across, down = np.diff(corners, axis=0)[0] * metres
    height = float(np.clip(_WIDTH * down / across, _LEAST_HEIGHT, _MOST_HEIGHT))
    scale = min(72 * _WIDTH / across, 72 * height / down) * metres  # points a unit
    figure = Figure(figsize=(_WIDTH, height + _STRIP))
    axes = figure.add_axes((0, _STRIP / (height + _STRIP), 1, height / (height + _STRIP)))
    axes.set(xlim=corners[:, 0], ylim=corners[:, 1], aspect=metres[1] / metres[0])
    _draw_coordinates(axes, scale)
    bounds = (*corners[0].tolist(), *corners[1].tolist())
    for pixels, (left, bottom, right, top) in _backdrop(mosaics, bounds, wkt):
        where = left, right, bottom, top
        axes.imshow(pixels, extent=where, aspect=axes.get_aspect(), zorder=0, interpolation="bilinear")
    _draw_sheets(axes, scale, decision, outlines)
    for state, colour in STATE_COLOURS.items():
        lines = [np.append(decided.piece.vertices, [[np.nan, np.nan]], axis=0) for decided in decision.pieces
                 if decided.state is state]
        if lines:  # one path, which is small in the page's SVG
            axes.plot(*np.concatenate(lines).T, color=colour, linewidth=_WIDTHS[state], solid_capstyle="round")
    _draw_numbers(axes, scale, {defect.run.number: np.array(defect.run.place) for defect in defects})
    axes.set(xlim=corners[:, 0], ylim=corners[:, 1])
    _draw_scale_bar(figure, float(scale[0] / metres[0]))
    return figure


def _draw_coordinates(axes: Axes, scale: np.ndarray) -> None:
    """Round coordinates within the frame, along its lower and left edges."""
    limits = np.array([axes.get_xlim(), axes.get_ylim()])
    step = round_below(float(np.ptp(limits, axis=1).max()) / _TICKS)
    within = limits + np.outer(_CORNER_PT / scale, (1, -1))
    for axis, (low, high), beside in zip((axes.xaxis, axes.yaxis), within, ("top", "center")):
        places = np.arange(np.ceil(low / step), np.floor(high / step) + 1) * step
        axis.set_ticks(places, [formatted(place, ".0f") for place in places], path_effects=_HALO, va=beside)
    inwards = {"direction": "in", "length": _TICK_PT, "labelsize": _COORDINATE_PT, "colors": PAPER.quiet}
    axes.tick_params(width=0.6, pad=-_TICK_PT - _COORDINATE_PT - 1, **inwards)
    axes.tick_params(axis="y", labelrotation=90)
    axes.spines[:].set_color(PAPER.quiet)
    axes.spines[:].set_linewidth(0.6)


def _draw_numbers(axes: Axes, scale: np.ndarray, places: Mapping[int, np.ndarray]) -> None:
    """Draw the numbers of failures, each beside its place; those without room are left out."""
    taken = np.zeros((0, 2))
    for number, place in places.items():
        free = (by for by in _BESIDE_PT if (np.abs(place * scale + by - taken) > _CROWDED_PT).any(axis=1).all())
        if (beside := next(free, None)) is not None:
            taken = np.append(taken, [place * scale + beside], axis=0)
            axes.annotate(
                str(number), place, beside, textcoords="offset points", fontsize=7, fontweight="bold",
                color=PAPER.text, path_effects=_HALO, zorder=4, ha="center", va="center",
                arrowprops={"arrowstyle": "-", "color": PAPER.text, "linewidth": 0.5, "shrinkA": 3},
            )


def pale(colour: str) -> str:
    """A sheet's colour as it looks on the map, for the legend."""
    return to_hex([1 - _LEGEND_ALPHA * (1 - part) for part in to_rgb(colour)])


def _backdrop(mosaics: Sequence[Raster], bounds: Extent, wkt: str) -> Iterator[tuple[np.ndarray, Extent]]:
    """Pale grey pictures, (rows, columns, 3) uint8, and where they lie; none of a mosaic in another system, nor where
    too many pixels would have to be read."""
    for mosaic in mosaics:
        with suppress(RasterError):
            across = (mosaic.extent[2] - mosaic.extent[0]) / (bounds[2] - bounds[0])
            size = max(int(_BACKDROP_PX * min(across, 1.0)), _LEAST_BACKDROP_PX)
            is_same = np.allclose(extent_on(bounds, wkt, mosaic.wkt), bounds, atol=mosaic.grid.pixel_width)
            overview = read_overview(mosaic, bounds, size) if is_same else None
            if overview is not None:
                block, extent = overview
                bands = block.bands[: 3 if mosaic.has_luminance else 1].astype(np.float32)
                grey = bands.mean(axis=0)
                low, high = cut_range([grey[block.valid]])
                share = np.clip((grey - low) / (high - low), 0, 1)
                shown = np.rint((_PALEST + (1 - _PALEST) * share) * _GREYS) * (255 / _GREYS)
                shown[~block.valid] = 255
                yield np.repeat(shown.astype(np.uint8)[..., np.newaxis], 3, axis=2), extent


def _draw_sheets(axes: Axes, scale: np.ndarray, decision: Decision, outlines: Mapping[str, list[np.ndarray]]) -> None:
    """Outlines in the colours of the verdicts, and as many names as have room."""
    states = {sheet.name: outcome for sheet, outcome in zip(decision.sheets, decision.sheet_outcomes)}
    named: list[np.ndarray] = []
    for name, rings in outlines.items():
        colour = SHEET_COLOURS[states.get(name)] if len(outlines) > 1 else PAPER.quiet
        for ring in rings:
            axes.fill(*ring.T, facecolor=(*to_rgb(colour), _SHEET_ALPHA), edgecolor=_SHEET_EDGE, linewidth=0.8)
        left, _, right, top = extent_of(rings)
        is_free = all((np.abs((left, top) - other) * scale > _CROWDED_NAMES_PT).any() for other in named)
        if 1 < len(outlines) <= _MOST_SHEET_NAMES and is_free:
            named.append(np.array([left, top]))
            words = _short(printable(name), ((right - left) * scale[0] - 4) / _LETTER_PT)
            axes.annotate(words, (left, top), (2, -2), textcoords="offset points", color=_NAME_COLOUR, zorder=3,
                          fontsize=_NAME_PT, ha="left", va="top", parse_math=False, path_effects=_HALO)


def _short(name: str, most: float) -> str:
    """A name in so many letters, though not fewer than tell it from others."""
    letters = max(int(most), _LEAST_LETTERS)
    if len(name) <= letters:
        return name
    begin = (letters - 1) // 2
    return name[:begin] + "…" + name[begin + 1 - letters :]


def _draw_scale_bar(figure: Figure, scale: float) -> None:
    """A round length in the lower left corner of the page, north up in the lower right one; ``scale``: points a
    metre."""
    width, height = 72 * figure.get_size_inches()
    axes = figure.add_axes((0, 0, 1, 72 * _STRIP / height), xlim=(0, width), ylim=(0, 72 * _STRIP))
    axes.set_axis_off()
    metres = round_below(0.25 * width / scale)
    axes.plot([6, 6 + metres * scale], [6, 6], color=PAPER.text, linewidth=2.5, solid_capstyle="butt")
    words = formatted(metres / 1000, "g") + " km" if metres >= 1000 else formatted(metres, "g") + " m"
    axes.text(6, 10, words, fontsize=7, color=PAPER.text)
    axes.annotate(tr("N"), (width - 10, 24), (width - 10, 2), ha="center", fontsize=8, color=PAPER.text,
                  arrowprops={"arrowstyle": "-|>", "color": PAPER.text, "linewidth": 1})
