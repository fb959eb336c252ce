"""What happened to a mosaic in one window, by the sources that it was made from.

Follows the mosaic through its sources, says what it would look like if they had been cut hard there, and compares grey
values, contrast, position and detail with that (Pyka 2010, section 3, names the causes).
"""
from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from ....imagery.shifts import Shift, farthest_apart, find_shift
from ....imagery.wavelets import Curve, correlation, measure_bands
from ..compared_image import Change, MeasuredClip, gains_of_colours, measure_changes
from ..following.boxes import enlarged, near_border
from ..following.levelling import left_over
from ..following.source_filters import filter_power
from ..limits import SHARPNESS_TOLERANCE
from ..profile.cell_table import CELL_PX
from ..profile.seam_profile import SeamProfile
from ..profile.window_detail import LossPicture, loss_picture
from ..seam_cells import UNKNOWN, is_one_of, present
from ..tone import whole_squares
from .cause_evidence import grey_unit, measure_texture, misfit_of, placed_misfit, range_factor
from .causes import Cause, CauseEvidence, Misfit, SourceTone, Texture, find_causes
from .feather_prediction import feathers, smallest
from .hard_cut import HardCut, cut_hard, follows_at
from .verdicts import Ratios, curve_ratios
from .visibility import window_visibility

MIN_UNMIXED_SQUARES = 64  # of 2^R px that follow one source, for the tone to be taken from them alone
MIN_PLACED_SHARE = 0.1  # of the pixels: a shift of what is followed in fewer is too rough to tell parts of a pixel
MIN_TONE_SHARE = 0.03  # of the pixels: a source that is followed in fewer says nothing of tones
MAX_SAME_SHIFT_PX = 0.02  # between sources: their composite lies where they lie
_ABOUT_PX = 24  # ground about a seam that images are compared in
MIN_UNEVEN_RANGE = 0.003  # of the range of values: what differs by less in all bands is no dodging


@dataclass(frozen=True)
class Explanation:
    """What the sources say about one window of the mosaic."""

    causes: tuple[Cause, ...]
    """All that took part, what took most first."""
    evidence: CauseEvidence
    """The figures that the causes were found by."""
    profile: SeamProfile | None
    """None without a seam, or with too little ground around it."""
    has_seam: bool
    """Whether the window follows two sources, so that they meet in it."""
    explained: float
    """Share of the pixels whose fine detail the given sources explain."""
    contrast: float | None
    """Standard deviation of the finest detail over the composite's, each by its own range of values; None where the
    ranges can't be compared."""
    sharpness: float | None
    """Sharpness of the whole window: its finest detail against the composite in the mosaic's tones, as an amplitude."""
    added: float | None
    """Share of the mosaic's finest detail that its sources don't have."""
    curves: dict[str, Curve] = field(hash=False)
    """Curves of the levelled composite, by band."""
    ratios: dict[str, Ratios] = field(hash=False)
    """The mosaic against the levelled composite, by band."""
    similarity: dict[str, float | None] = field(hash=False)
    """Correlation of the coarse components with the composite's, by band."""
    changes: tuple[dict[str, Change], ...] = field(hash=False)
    """Changes by band: against each source in turn, then against the composite."""
    expected: tuple[float | None, ...]
    """Detail variance that a 50:50 feather would leave, levels 1..R, the smallest over the pairs of sources."""
    unclear_share: float
    """Share of pixels for which no source wins clearly."""
    mixed_share: float
    """Share of pixels in which two sources are mixed."""
    visibility: float | None = None
    """The loss beside the seam in just noticeable differences of contrast; None where no profile is."""
    loss: LossPicture | None = field(default=None, compare=False, repr=False)
    """Picture of where detail was lost; None where that can't be told."""

    @property
    def cause(self) -> Cause:
        """The main one."""
        return self.causes[0]

    @property
    def is_unclear(self) -> bool:
        """Whether nothing can be told of it, so that the sources' composite is none to be compared with."""
        return self.cause is Cause.UNCLEAR and self.profile is None

    @property
    def misfit(self) -> float | None:
        """How far the two images that the mosaic follows most lie from each other as they are placed in it, px; None
        where there are none, or nothing in common shows it."""
        return None if self.evidence.misfit is None else self.evidence.misfit.px

    @property
    def ground_left(self) -> float:
        """Share of the sources' finest detail that is left in the ground which the seam is compared with; 1 where it
        is as sharp as they are."""
        left_over = 1 - self.evidence.off_seam_lost
        return left_over if left_over < (1 - SHARPNESS_TOLERANCE) ** 2 else 1.0


def explain(
    mosaic: MeasuredClip, sources: Sequence[MeasuredClip], wavelet: str, levels: int, labels: np.ndarray | None = None
) -> Explanation:
    """Explain one window by at least one source.

    ``labels``, (rows, columns) uint8, says which source each pixel was taken from where that is known, else
    ``seam_cells.UNKNOWN``.
    """
    cut = cut_hard(mosaic, sources, levels, labels)
    image, images, ground = cut.mosaic, cut.sources, cut.ground
    following = ground.following
    judged = next(iter(image.coarse))
    shifts = [_shift_on_pixels(cut, i) for i in range(len(images))]
    placed = [
        shift for i in following.followed
        if (shift := shifts[i]) is not None and following.shares[i] >= MIN_PLACED_SHARE
    ]
    curves, coarse = measure_bands(cut.levelled, image.names, wavelet, levels)
    is_level = cut.levelled is cut.plain
    plain = curves if is_level else measure_bands(cut.plain, image.names, wavelet, levels)[0]
    against_composite = _composite_changes(cut, plain, placed, levels)
    detail = ground.detail(wavelet, levels)
    profile, unit = detail.profile, grey_unit(image.raster, image.coarse[judged])
    finest = detail.finest[(..., *(slice(part.start // 2, part.stop // 2) for part in ground.inside))]
    mosaic_energy, of_sources = (np.einsum("dij,dij->ij", detail, detail) for detail in (finest[:, 0], finest[:, -1]))
    total, known = max(float(of_sources.sum(dtype=np.float64)), 1e-9), ground.labels[::2, ::2] != UNKNOWN
    explained = float(of_sources[known].sum(dtype=np.float64))
    sharpness = float(np.sqrt(mosaic_energy[known].sum(dtype=np.float64) / explained)) if explained > 0 else None
    lost = max(1 - (1.0 if sharpness is None else sharpness) ** 2, 0.0)
    evidence = CauseEvidence(
        missing=1 - ground.explained,
        profile=profile,
        lost=lost if profile is None else min(profile.lost / total, 1.0),
        mixed=following.mixed_share,
        sharpness=sharpness,
        clipped=against_composite[judged].clipped,
        clipped_lost=_clipped_energy(image.bands, of_sources - mosaic_energy) / total,
        tones=_source_tones(cut, judged, unit),
        unevenness=_unevenness(cut, levels),
        misfit=_misfit(cut, shifts, wavelet),
        off_pixel=max((float(np.hypot(at.x - round(at.x), at.y - round(at.y))) for at in placed), default=0.0),
        texture=_texture(finest, cut, detail.unmixed(), unit),
        fit=following.fit,
        mid_scale_gain=_amplitude(image.curves[judged], curves[judged]) / sharpness if sharpness else 1.0,
        unit_dn=unit,
        seams=detail.by_pair() if profile is not None and profile.high < 1 else (),
        lossy_file=image.raster.is_lossy,
        lossy_sources=any(images[i].raster.is_lossy for i in following.followed),
        filter_power=_filter_power(cut),
    )
    causes = find_causes(evidence)
    if causes == (Cause.NONE,) and detail.has_seam and profile is None:
        causes = (Cause.UNCLEAR,)  # where nothing could be measured along a seam, finding nothing says nothing
    factors = {range_factor(image.raster, other.raster) for other in images}
    factor, contrast = factors.pop() if len(factors) == 1 else None, against_composite[judged].contrast[0]
    grounds = (replace(shift, x=shift.x + other.offset[0], y=shift.y + other.offset[1]) if shift else None
               for shift, other in zip(shifts, images))
    mm, cc, mc = (float(sums[0].sum()) for sums in (detail.judged.mm, detail.judged.cc, detail.judged.mc))
    pairs = feathers([image.plane for image in images if image.valid is None], wavelet, levels)
    explanation = Explanation(
        causes=causes,
        evidence=evidence,
        profile=profile,
        has_seam=detail.has_seam or len(present(ground.labels)) > 1,  # be it under ground that no source explains
        explained=ground.explained,
        contrast=None if factor is None or contrast is None else factor * contrast,
        sharpness=sharpness,
        added=1 - mc**2 / (mm * cc) if mm > 0 and cc > 0 else None,
        curves=curves,
        ratios={name: curve_ratios(mosaic.curves[name], curve) for name, curve in curves.items()},
        similarity={name: correlation(mosaic.coarse[name], means) for name, means in coarse.items()},
        changes=(*(measure_changes(image, *compared) for compared in zip(images, cut.tones, grounds)),
                 against_composite),
        expected=smallest(feather.ratios for feather in pairs) or (None,) * levels,
        unclear_share=following.unclear_share,
        mixed_share=following.mixed_share,
        visibility=window_visibility(profile, detail.judged, image.plane, ground.inside, image.raster),
        loss=loss_picture(detail, ground.expected.labels, ground.inside),
    )
    if ground.is_unclear:  # the sources say too little of the mosaic
        return replace(
            explanation, causes=(Cause.UNCLEAR,), profile=None, explained=0.0, sharpness=None, added=None,
            visibility=None, loss=None,
        )
    return explanation


def _shift_on_pixels(cut: HardCut, source: int) -> Shift | None:
    """How the mosaic lies on the pixels of a source, where it follows that."""
    other, following = cut.sources[source], cut.ground.following
    where = following.labels == source if source in following.followed else other.valid
    return find_shift(cut.mosaic.spectra, other.spectra, where)


def _amplitude(curve: Curve, other: Curve) -> float:
    """Amplitude of the finest detail over that of another clip."""
    return float(np.sqrt(curve.detail[0] * curve.variance / max(other.detail[0] * other.variance, 1e-9)))


def _clipped_energy(bands: np.ndarray, gone: np.ndarray) -> float:
    """The part of ``gone``, energy that the mosaic lacks (rows / 2, columns / 2), where one of its bands (bands, rows,
    columns) is at an end of its scale."""
    ends = np.zeros(gone.shape, bool)
    for band in bands:
        ends |= ((band == band.min()) | (band == band.max()))[::2, ::2]
    return max(float(gone[ends].sum(dtype=np.float64)), 0.0)


def _texture(finest: np.ndarray, cut: HardCut, unmixed: np.ndarray, unit: float) -> Texture | None:
    """Texture where one source is followed for sure; where that is too little, where one is followed at all.
    ``unmixed``: cells beyond what seams mix."""
    followed = cut.ground.labels
    large = enlarged(unmixed, CELL_PX)[: followed.shape[0], : followed.shape[1]]
    rows, columns = large.shape
    labels = np.full(followed.shape, UNKNOWN, np.uint8)
    np.copyto(labels[:rows, :columns], followed[:rows, :columns], where=large)
    sure = np.where(cut.ground.following.clear, labels, np.uint8(UNKNOWN))
    planes = cut.mosaic.plane, cut.ground.expected.unfiltered[cut.ground.inside]
    textures = (measure_texture(finest, where, *planes, unit) for where in (sure, labels))
    return next((texture for texture in textures if texture is not None), None)


def _source_tones(cut: HardCut, judged: str, unit: float) -> tuple[SourceTone, ...]:
    """Tones of the sources that are followed; offsets are told at their middle grey value."""
    followed = [i for i in cut.ground.following.followed if cut.ground.following.shares[i] >= MIN_TONE_SHARE]
    known = [(i, tone) for i in followed if (tone := cut.tones[i][judged]) is not None]
    middle = float(np.mean([cut.sources[i].coarse[judged].mean() for i, _ in known])) if known else 0.0
    return tuple(
        SourceTone(
            None if (factor := range_factor(cut.mosaic.raster, cut.sources[i].raster)) is None else tone.gain * factor,
            (tone.gain * middle + tone.bias) / (255 * unit), tone.gamma, gains_of_colours(cut.tones[i]),
        ) for i, tone in known
    )


def _unevenness(cut: HardCut, levels: int) -> float:
    """Share of what one curve of tones leaves over that a tone which changes from place to place explains.

    The smallest over the bands, since colours that were corrected one by one move the luminance from place to place;
    of the source with most pixels.
    """
    if not cut.ground.following.followed:
        return 0.0
    main, image = cut.ground.following.followed[0], cut.mosaic
    where = follows_at(cut.ground.following, main, levels)
    bands = [(image.coarse[name], cut.sources[main].coarse[name]) for name in image.names[:3]]
    scales = [left_over(*band, where) for band in bands]
    least = [MIN_UNEVEN_RANGE * float(np.ptp(mosaic_means)) + 0.5 for mosaic_means, _ in bands]
    if all(curve <= most for (curve, _), most in zip(scales, least)):
        return 0.0
    return min(1 - local / curve if curve > 0 else 0.0 for curve, local in scales)


def _composite_changes(
    cut: HardCut, curves: Mapping[str, Curve], placed: Sequence[Shift], levels: int
) -> dict[str, Change]:
    """Against the sources' pixels as they are; tones from where one source is followed, if there is enough of that."""
    image, following = cut.mosaic, cut.ground.following
    reference = image.with_bands(cut.plain, curves, levels)
    unmixed = whole_squares(following.clear & (following.labels != UNKNOWN), levels)
    where = unmixed if unmixed.sum() >= MIN_UNMIXED_SQUARES else np.ones_like(unmixed)
    # It lies where its sources lie, if all lie alike.
    is_one_place = placed and farthest_apart(placed) <= MAX_SAME_SHIFT_PX
    shift = placed[0] if is_one_place else find_shift(image.spectra, reference.spectra)
    return measure_changes(image, reference, image.tones_of(reference, where), shift)


def _filter_power(cut: HardCut) -> float | None:
    """Power of the filter that came over the sources that are followed."""
    source_of, taps = cut.ground.followed.source_of, cut.ground.expected.filters.taps
    return filter_power(
        taps[plane] for plane, source in enumerate(source_of)
        if plane in taps and cut.ground.following.shares[source] >= MIN_PLACED_SHARE
    )


def _misfit(cut: HardCut, shifts: Sequence[Shift | None], wavelet: str) -> Misfit | None:
    """Misfit of the two sources that the mosaic follows most, as they are placed in it."""
    pair, shown = cut.ground.following.followed[:2], cut.ground.expected.shown
    if len(pair) < 2 or any(i not in shown for i in pair):
        return None
    first, second = (shifts[i] for i in pair)
    between = find_shift(*(cut.sources[i].spectra for i in pair))
    if first is None or second is None or between is None:
        return None
    labels = cut.ground.expected.labels[::2, ::2]
    labels = np.where(is_one_of(labels, pair), labels, np.uint8(UNKNOWN))
    seam = near_border(labels, _ABOUT_PX // 2) & (labels != UNKNOWN)
    return misfit_of(placed_misfit(between, first, second), shown[pair[0]], shown[pair[1]], seam, wavelet)
