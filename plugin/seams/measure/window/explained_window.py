"""The second half of an inspection: why contrast was lost, what is kept along the seam, and the verdict that counts.

And what can be known many times a second of a window that is being moved, from the judged band alone.
"""
from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from ....imagery.errors import Message
from ....imagery.grids import PixelWindow
from ....imagery.raster_pool import ReadEach
from ....imagery.wavelets import Curve, correlation
from .. import messages
from ..compared_image import Change, MeasuredClip
from ..judgement.causes import Cause
from ..judgement.explanation import Explanation, explain
from ..judgement.hard_cut import JudgedGround, as_type, cut_hard, ground_of
from ..judgement.verdicts import (
    Judgement,
    Ratios,
    Verdict,
    curve_ratios,
    judge_curves,
    judge_profile,
    judge_without_profile,
)
from ..limits import MAX_SIGNIFICANT_KEPT, MAX_SIGNIFICANT_SHARPNESS_SQUARED, SHARPNESS_TOLERANCE
from ..profile.seam_profile import SeamProfile
from ..profile.window_detail import LossPicture, WindowDetail, loss_picture
from ..seam_cells import UNKNOWN, cell_labels
from ..window_records import COMPOSITE, SEAM
from ..workers import measuring
from .measured_window import MeasuredWindow, WindowRequest, in_file_values, measure_window
from .window_result import PairResult, WindowResult


@measuring()
def explain_window(measured: MeasuredWindow) -> WindowResult:
    """All that is known of a window; why it can't be compared where nothing could be explained."""
    request, mosaic, band = measured.request, measured.mosaic, measured.band
    notices, paper, judged = list(measured.notices), measured.paper, measured.judged
    result = measured.result
    if not measured.is_explicable:
        shown = (pair for source in measured.sources for pair in _pairs(mosaic, source, {}))
        return replace(result, pairs=tuple(shown))
    settings, labels = request.settings, known_labels(request, judged)
    explanation = explain(mosaic, judged, settings.wavelet, settings.levels, labels)
    notices += [
        messages.SOURCE_IN_PART(name=source.clip.raster.ref.name, share=100 * (1 - source.clip.invalid_share))
        for source in judged
        if round(100 * source.clip.invalid_share)
    ]
    explanation = _in_file_values(explanation, mosaic.grey_factor, [source.grey_factor for source in judged])
    pairs = [pair for source, changes in zip(judged, explanation.changes) for pair in _pairs(mosaic, source, changes)]
    pairs += [pair for source in measured.sources if source not in judged for pair in _pairs(mosaic, source, {})]
    judgement = _judged(paper, mosaic.curves[band], explanation, band, request)
    if Cause.MISSING_SOURCE in explanation.causes and judgement.reason is None:
        judgement = replace(judgement, reason=messages.VERDICT_OF_THE_REST(share=100 * (1 - explanation.explained)))
    if all(source.clip.resampled for source in judged) and judgement.reason is None:
        judgement = replace(judgement, reason=messages.ALL_RESAMPLED())
    return replace(
        result, judgement=judgement, pairs=tuple(pairs), explanation=explanation, notices=tuple(notices)
    )


@measuring()
def window_lost(measured: MeasuredWindow) -> LossPicture | None:
    """Picture of where a window lost its sources' detail, as its explanation has it; None where that can't be told."""
    ground, detail = _detail(measured) if measured.is_explicable else (None, None)
    return None if ground is None or detail is None else loss_picture(detail, ground.expected.labels, ground.inside)


def _detail(measured: MeasuredWindow) -> tuple[JudgedGround, WindowDetail | None]:
    """The ground of a window, and what it has of its sources' detail, None where these say too little of it."""
    settings = measured.request.settings
    ground = ground_of(measured.mosaic, measured.judged, known_labels(measured.request, measured.judged))
    return ground, None if ground.is_unclear else ground.detail(settings.wavelet, settings.levels)


def _in_file_values(explanation: Explanation, mosaic_factor: float, factors: Sequence[float]) -> Explanation:
    """What stands in grey values, for the files' own instead of those multiplied by ``mosaic_factor`` and ``factors``.

    The composite is in the mosaic's values.
    """
    if mosaic_factor == 1 and all(factor == 1 for factor in factors):
        return explanation

    def changed(change: Change, gain: float) -> Change:
        tone = change.tone and replace(change.tone, gain=change.tone.gain * gain, bias=change.tone.bias / mosaic_factor)
        return replace(
            change, tone=tone, contrast=tuple(None if ratio is None else ratio * gain for ratio in change.contrast)
        )

    changes = tuple(
        {name: changed(change, factor / mosaic_factor) for name, change in of_source.items()}
        for of_source, factor in zip(explanation.changes, (*factors, mosaic_factor))
    )
    return replace(explanation, curves=in_file_values(explanation.curves, mosaic_factor), changes=changes)


def known_labels(request: WindowRequest, sources: Sequence[MeasuredClip]) -> np.ndarray | None:
    """The source of each pixel that is read by the seam cells, else ``UNKNOWN``; None where no cell says any."""
    if not request.cells or request.window is None:
        return None
    images = [source.clip.raster.ref.paths for source in sources]
    known = cell_labels(request.cells, images, request.mosaic.grid, request.around)
    return known if (known != UNKNOWN).any() else None


def judge_by_seam(explanation: Explanation, min_kept: float = MAX_SIGNIFICANT_KEPT) -> tuple[Verdict, Message | None]:
    """The verdict on a window by its seams and the sharpness of the whole, and why there is none: ``significant`` too
    where the square of the sharpness is at most its limit. Without a seam the sharpness alone judges."""
    if explanation.sharpness is None:
        return Verdict.NOT_COMPARABLE, messages.COMPOSITE_UNCLEAR()
    if explanation.sharpness**2 <= MAX_SIGNIFICANT_SHARPNESS_SQUARED:
        return Verdict.SIGNIFICANT, None
    is_blurred = explanation.sharpness < 1 - SHARPNESS_TOLERANCE
    if explanation.profile is None:
        return judge_without_profile(explanation.has_seam, is_blurred, explanation.explained, explanation.mixed_share)
    return judge_profile(explanation.profile, min_kept, is_blurred, explanation.explained)


def _judged(paper: Judgement, mosaic: Curve, explanation: Explanation, band: str, request: WindowRequest) -> Judgement:
    """The verdict by what the settings say; the ratios stay those against the sources."""
    settings = request.settings
    if settings.reference == SEAM:
        verdict, reason = judge_by_seam(explanation, settings.min_kept)
        return replace(paper, verdict=verdict, reason=reason)
    if settings.reference == COMPOSITE:
        # What the mosaic does not follow is cut at random, unless the cells say how.
        if explanation.is_unclear and not request.cells:
            return replace(paper, verdict=Verdict.NOT_COMPARABLE, reason=messages.COMPOSITE_UNCLEAR())
        against = judge_curves(mosaic, [explanation.curves[band]], settings.max_ratio)
        return replace(paper, verdict=against.verdict, reason=against.reason)
    return paper


def _pairs(mosaic: MeasuredClip, source: MeasuredClip, changes: Mapping[str, Change]) -> list[PairResult]:
    levels = len(next(iter(mosaic.curves.values())).detail)
    nothing = Ratios((None,) * levels, None)
    is_part = source.clip.valid is not None
    return [
        PairResult(
            source.clip.raster.ref.name,
            name,
            nothing if is_part else curve_ratios(mosaic.curves[name], source.curves[name]),
            None if is_part else correlation(mosaic.coarse[name], source.coarse[name]),
            source.clip.offset_x,
            source.clip.offset_y,
            source.clip.resampled,
            changes.get(name),
        )
        for name in (changes if is_part else source.curves)
        if name in mosaic.curves
    ]


def window_composite(request: WindowRequest) -> tuple[tuple[str, ...], np.ndarray] | Message:
    """The cut that the inspection compares the mosaic with: each pixel from the source that the mosaic follows there,
    its own where none explains it; why there is no cut where none does.

    The names of the bands that the mosaic and all its sources have, and (bands, rows, columns) in the mosaic's grey
    values and data type.
    """
    measured = measure_window(request)
    if measured is None or isinstance(measured, Message):
        return measured or messages.COMPOSITE_UNCLEAR()
    if not measured.is_explicable:
        return measured.paper.reason or messages.COMPOSITE_UNCLEAR()
    cut = cut_hard(measured.mosaic, measured.judged, request.settings.levels, known_labels(request, measured.judged))
    if cut.ground.is_unclear:
        return messages.COMPOSITE_UNCLEAR()
    levelled = cut.levelled / measured.mosaic.grey_factor
    return cut.mosaic.names, as_type(levelled, cut.mosaic.bands.dtype)


@dataclass(frozen=True)
class LiveWindow:
    """What is known of the window that is being moved."""

    window: PixelWindow
    clips: WindowResult
    """With the curves of the judged band alone."""
    profile: SeamProfile | None = None
    """What is kept along the seam, a moment ago: it takes longer than the curves."""


def read_live(request: WindowRequest, read_each: ReadEach) -> MeasuredWindow | None:
    """Read and measure the judged band of a window; None where the mosaic has no pixels there."""
    plain = replace(request, settings=replace(request.settings, directions=False))
    measured = measure_window(plain, read_each, judged_only=True)
    return measured if isinstance(measured, MeasuredWindow) else None


@measuring()
def live_profile(measured: MeasuredWindow) -> SeamProfile | None:
    """What is kept along the seam, as a whole inspection has it; None without a seam or where it can't be told."""
    detail = _detail(measured)[1] if measured.judged else None
    return None if detail is None else detail.profile
