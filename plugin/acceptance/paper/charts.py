"""Charts of a decision: how many metres kept how much, and where seams failed."""
from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from itertools import chain
from typing import Callable

import numpy as np
from matplotlib import patheffects
from matplotlib.axes import Axes
from matplotlib.colors import to_hex, to_rgb
from matplotlib.figure import Figure

from ...imagery.clips import read_overview
from ...imagery.errors import RasterError, printable
from ...imagery.grids import Extent, middle_of
from ...imagery.lines import vertex_stations
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
    known = [(one.piece.kept_1, one.piece.length_m) for one in decision.pieces if one.piece.kept_1 is not None]
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
    axes.plot(*np.array([(x, one.kept) for one in steps for x in (one.near_m, one.far_m)]).reshape(-1, 2).T,
              color=PAPER.sources[0], linewidth=1.2)
    axes.plot([0, strip.far_m], [strip.kept] * 2, color=PAPER.text, linewidth=2.5, solid_capstyle="butt")
    farthest = max((one.far_m for one in steps), default=strip.far_m)
    axes.set_xscale("function", functions=(lambda x: np.sqrt(np.maximum(x, 0)), np.square))  # narrow steps matter most
    axes.set_xlim(0, farthest)
    axes.set_xticks([strip.far_m, farthest / 4, farthest])
    axes.xaxis.set_major_formatter(lambda x, _: formatted(x, ".2g"))
    axes.minorticks_off()
    axes.set_ylim(0, max(_MOST_KEPT, *(one.kept for one in piece.profile)))
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
_FINEST_PT = 0.25  # lines are thinned to it
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
_BESIDE_PT = 11.0 * np.array([(1, 1), (-1, 1), (1, -1), (-1, -1)])  # where a number may stand beside its place


def seams_figure(decision: Decision, defects: Sequence[Defect], mosaics: Sequence[Raster] = ()) -> Figure | None:
    """A sketch map: the mosaics in pale grey, sheets by their verdicts, seams by what became of them, the numbers of
    failures, coordinates along the frame. None without seams."""
    if not decision.pieces:
        return None
    outlines = decision.delivery.sheet_rings()
    xmin, ymin, xmax, ymax = extent_of([*(one.piece.vertices for one in decision.pieces), *chain(*outlines.values())])
    metres_x, metres_y = metres_per_unit(decision.delivery.wkt, middle_of((xmin, ymin, xmax, ymax)))
    margin = max((xmax - xmin) * metres_x, (ymax - ymin) * metres_y, 1.0) * _MARGIN
    across, down = (xmax - xmin) * metres_x + 2 * margin, (ymax - ymin) * metres_y + 2 * margin
    height = min(max(_WIDTH * down / across, _LEAST_HEIGHT), _MOST_HEIGHT)
    figure = Figure(figsize=(_WIDTH, height + _STRIP))
    axes = figure.add_axes((0, 0, 1, 1))
    axes.set_axis_off()
    scale = min(72 * _WIDTH / across, 72 * height / down)  # points per metre

    def placed(points: np.ndarray) -> np.ndarray:
        middle = np.array([(xmin + xmax) / 2, (ymin + ymax) / 2])
        return (points - middle) * (metres_x * scale, metres_y * scale)

    bounds = xmin - margin / metres_x, ymin - margin / metres_y, xmax + margin / metres_x, ymax + margin / metres_y
    for pixels, extent in _backdrop(mosaics, bounds, decision.delivery.wkt):
        (left, bottom), (right, top) = placed(np.array(extent).reshape(2, 2))
        axes.imshow(pixels, extent=(left, right, bottom, top), aspect="auto", zorder=0, interpolation="bilinear")
    _draw_coordinates(axes, placed, bounds)
    _draw_sheets(axes, placed, decision, outlines)
    for state, colour in STATE_COLOURS.items():
        lines = [_thinned(placed(one.piece.vertices)) for one in decision.pieces if one.state is state]
        if lines:  # one path, which is small in the page's SVG
            axes.plot(*np.concatenate(lines).T, color=colour, linewidth=_WIDTHS[state], solid_capstyle="round")
    _draw_numbers(axes, {one.run.number: placed(np.array([one.run.place]))[0] for one in defects})
    axes.set_xlim(-36 * _WIDTH, 36 * _WIDTH)
    axes.set_ylim(-36 * height - 72 * _STRIP, 36 * height)
    _draw_scale_bar(axes, scale, -36 * height - 72 * _STRIP)
    return figure


def _draw_numbers(axes: Axes, places: Mapping[int, np.ndarray]) -> None:
    """Draw the numbers of failures, each beside its place; those without room are left out."""
    taken = np.zeros((0, 2))
    for number, place in places.items():
        beside = next((at for at in place + _BESIDE_PT if (np.abs(at - taken) > _CROWDED_PT).any(axis=1).all()), None)
        if beside is not None:
            taken = np.append(taken, beside[np.newaxis], axis=0)
            axes.annotate(
                str(number), place, beside, fontsize=7, fontweight="bold", color=PAPER.text, path_effects=_HALO,
                zorder=4, ha="center", va="center",
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
            found = read_overview(mosaic, bounds, size) if is_same else None
            if found is not None:
                block, extent = found
                bands = block.bands[: 3 if mosaic.has_luminance else 1].astype(np.float32)
                grey = bands.mean(axis=0)
                low, high = cut_range([grey[block.valid]])
                share = np.clip((grey - low) / (high - low), 0, 1)
                shown = np.rint((_PALEST + (1 - _PALEST) * share) * _GREYS) * (255 / _GREYS)
                shown[~block.valid] = 255
                yield np.repeat(shown.astype(np.uint8)[..., np.newaxis], 3, axis=2), extent


def _draw_sheets(
    axes: Axes, placed: Callable[[np.ndarray], np.ndarray], decision: Decision, outlines: Mapping[str, list[np.ndarray]]
) -> None:
    """Outlines in the colours of the verdicts, and as many names as have room."""
    states = {one.name: outcome for one, outcome in zip(decision.sheets, decision.sheet_outcomes)}
    named: list[np.ndarray] = []
    for name, rings in outlines.items():
        colour = SHEET_COLOURS[states.get(name)] if len(outlines) > 1 else PAPER.quiet
        for ring in rings:
            axes.fill(*placed(ring).T, facecolor=(*to_rgb(colour), _SHEET_ALPHA), edgecolor=_SHEET_EDGE, linewidth=0.8)
        left, _, right, top = extent_of(map(placed, rings))
        corner = np.array([left, top])
        is_free = all((abs(corner - other) > _CROWDED_NAMES_PT).any() for other in named)
        if 1 < len(outlines) <= _MOST_SHEET_NAMES and is_free:
            named.append(corner)
            axes.text(left + 2, top - 2, _short(printable(name), (right - left - 4) / _LETTER_PT), color=_NAME_COLOUR,
                      fontsize=_NAME_PT, ha="left", va="top", parse_math=False, path_effects=_HALO, zorder=3)


def _draw_coordinates(axes: Axes, placed: Callable[[np.ndarray], np.ndarray], bounds: Extent) -> None:
    """A frame with round coordinates along its lower and left edges."""
    left, bottom, right, top = bounds
    corners = placed(np.array([(left, bottom), (right, bottom), (right, top), (left, top), (left, bottom)]))
    axes.plot(*corners.T, color=PAPER.quiet, linewidth=0.6)
    step = round_below(max(right - left, top - bottom) / _TICKS)
    style = {"fontsize": _COORDINATE_PT, "color": PAPER.quiet, "path_effects": _HALO, "zorder": 3}
    (most_left, least), (most_right, most) = placed(np.array([(left, bottom), (right, top)]))
    for x in np.arange(np.ceil(left / step), np.floor(right / step) + 1) * step:
        (across, foot), = placed(np.array([(x, bottom)]))
        if not most_left + _CORNER_PT < across < most_right - _CORNER_PT:
            continue
        axes.plot([across, across], [foot, foot + _TICK_PT], color=PAPER.quiet, linewidth=0.6)
        axes.text(across, foot + _TICK_PT, formatted(x, ".0f"), ha="center", va="bottom", **style)
    for y in np.arange(np.ceil(bottom / step), np.floor(top / step) + 1) * step:
        (edge, up), = placed(np.array([(left, y)]))
        if not least + _CORNER_PT < up < most - _CORNER_PT:
            continue
        axes.plot([edge, edge + _TICK_PT], [up, up], color=PAPER.quiet, linewidth=0.6)
        axes.text(edge + _TICK_PT, up, formatted(y, ".0f"), ha="left", va="center", rotation=90, **style)


def _short(name: str, most: float) -> str:
    """A name in so many letters, though not fewer than tell it from others."""
    letters = max(int(most), _LEAST_LETTERS)
    if len(name) <= letters:
        return name
    begin = (letters - 1) // 2
    return name[:begin] + "…" + name[begin + 1 - letters :]


def _thinned(points: np.ndarray) -> np.ndarray:
    """A line of which each vertex but the last lies a little farther on; (n, 2) points on paper, at the end NaN."""
    cells = np.floor(vertex_stations(points) / _FINEST_PT)
    return np.append(points[np.append(np.diff(cells, prepend=-1)[:-1] > 0, True)], [[np.nan, np.nan]], axis=0)


def _draw_scale_bar(axes: Axes, scale: float, foot: float) -> None:
    """A round length in the lower left corner, north up in the lower right one; ``foot``: of the strip for them."""
    metres = round_below(0.25 * 72 * _WIDTH / scale)
    left, bottom = -36 * _WIDTH + 6, foot + 6
    axes.plot([left, left + metres * scale], [bottom, bottom], color=PAPER.text, linewidth=2.5, solid_capstyle="butt")
    words = formatted(metres / 1000, "g") + " km" if metres >= 1000 else formatted(metres, "g") + " m"
    axes.text(left, bottom + 4, words, fontsize=7, color=PAPER.text)
    right = 36 * _WIDTH - 10
    axes.annotate(tr("N"), (right, bottom + 22), (right, bottom - 4), ha="center", fontsize=8, color=PAPER.text,
                  arrowprops={"arrowstyle": "-|>", "color": PAPER.text, "linewidth": 1})
