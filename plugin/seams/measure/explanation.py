"""What happened to a mosaic in one window, by the sources that it was made from.

Follows the mosaic through its sources, says what it would look like if they had been cut hard there, and compares grey
values, contrast, position and detail with that (Pyka 2010, section 3, names the causes).
"""
from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from ...imagery.shifts import Shift, farthest_apart, find_shift
from ...imagery.wavelets import Curve, correlation, measure_bands
from .cause_evidence import grey_unit, measure_texture, measure_tones, misfit_of, placed_misfit, range_factor
from .causes import Cause, CauseEvidence, Misfit, Texture, find_causes
from .compared_image import Change, ComparedImage, MeasuredClip, gains_of_colours, measure_changes
from .feather_prediction import expected_ratios, feathers
from .following.boxes import enlarged, near_border
from .following.followed_source import FollowedSource
from .following.hard_cut import Composite, HardCut, cut_hard, follows_at
from .following.levelling import left_over
from .following.source_filters import filter_power
from .limits import SHARPNESS_TOLERANCE
from .profile.cell_table import CELL_PX, CellTable
from .profile.seam_profile import SeamProfile
from .profile.window_detail import LossPicture, loss_picture
from .seam_cells import UNKNOWN, is_one_of, present
from .tone import Tone, whole_squares
from .verdicts import Ratios, curve_ratios
from .visibility import window_visibility

MIN_UNMIXED_SQUARES = 64  # of 2^R px that follow one source, for the tone to be taken from them alone
MIN_PLACED_SHARE = 0.1  # of the pixels: a shift of what is followed in fewer is too rough to tell parts of a pixel
MIN_TONE_SHARE = 0.03  # of the pixels: a source that is followed in fewer says nothing of tones
MAX_SAME_SHIFT_PX = 0.02  # between sources: their composite lies where they lie
_ABOUT_PX, _EVERY = 24, 4  # ground about a seam that images are compared in; rows and columns that are looked at
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
    curves: dict[str, Curve]
    """Curves of the levelled composite, by band."""
    ratios: dict[str, Ratios]
    """The mosaic against the levelled composite, by band."""
    similarity: dict[str, float | None]
    """Correlation of the coarse components with the composite's, by band."""
    changes: tuple[dict[str, Change], ...]
    """Changes by band: against each source in turn, then against the composite."""
    expected: tuple[float | None, ...]
    """Detail variance that a 50:50 feather would leave, levels 1..R, the smallest over the pairs of sources."""
    unclear_share: float
    """Share of pixels for which no source wins clearly."""
    mixed_share: float
    """Share of pixels in which two sources are mixed."""
    shares: tuple[float, ...]
    """Share of the pixels that follow each source, in their order."""
    visibility: float | None = None
    """The loss beside the seam in just noticeable differences of contrast; None where no profile is."""
    loss: LossPicture | None = field(default=None, compare=False, repr=False)
    """Where detail was lost; None where that can't be told."""

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
        left = 1 - self.evidence.off_seam_lost
        return left if left < (1 - SHARPNESS_TOLERANCE) ** 2 else 1.0


def explain(
    mosaic: MeasuredClip, sources: Sequence[MeasuredClip], wavelet: str, levels: int, labels: np.ndarray | None = None
) -> Explanation:
    """Explain one window by at least one source.

    ``labels``, (rows, columns) uint8, says which source each pixel was taken from where that is known, else
    ``seam_cells.UNKNOWN``.
    """
    cut = cut_hard(mosaic, sources, levels, labels)
    image, images, ground, following = cut.mosaic, cut.sources, cut.ground, cut.ground.following
    tones, composite = cut.tones, cut.composite
    shifts = [_shift(image, other, following, i) for i, other in enumerate(images)]
    curves, coarse = measure_bands(composite.levelled, image.names, wavelet, levels)
    is_level = composite.levelled is composite.bands
    plain = curves if is_level else measure_bands(composite.bands, image.names, wavelet, levels)[0]
    on_pixels = _on_pixels(shifts, images, following)
    against_composite = _composite_changes(image, composite, plain, following, _main_shift(on_pixels), levels)
    detail = ground.detail(wavelet, levels)
    finest = detail.finest[(..., *(slice(part.start // 2, part.stop // 2) for part in ground.inside))]
    profile = detail.profile
    unmixed = _on_pixels_of(detail.unmixed(), ground.labels)
    sharpness = _sharpness(finest, ground.labels)
    unit = grey_unit(image.raster, next(iter(image.coarse.values())))
    total = float(np.einsum("dij,dij->", finest[:, -1], finest[:, -1], dtype=np.float64))
    evidence = CauseEvidence(
        missing=1 - ground.explained,
        profile=profile,
        lost=_seam_loss(profile, sharpness, total),
        mixed=following.mixed_share,
        sharpness=sharpness,
        clipped=next(iter(against_composite.values())).clipped,
        clipped_lost=_clipped_loss(image, finest, total),
        tones=_source_tones(image, images, following, tones),
        unevenness=_unevenness(image, images, following, levels),
        misfit=_misfit(cut, shifts, wavelet),
        off_pixel=_off_pixel(on_pixels),
        texture=_texture(finest, cut, unmixed, unit),
        fit=following.fit,
        unit_dn=unit,
        lossy_file=image.raster.is_lossy,
        lossy_sources=any(images[i].raster.is_lossy for i in following.followed),
        filter_power=_filter_power(cut),
    )
    found = Explanation(
        causes=_causes(evidence, detail.has_seam and profile is None),
        evidence=evidence,
        profile=profile,
        has_seam=detail.has_seam or len(present(ground.labels)) > 1,  # be it under ground that no source explains
        explained=ground.explained,
        contrast=_contrast(image, images, next(iter(against_composite.values()))),
        sharpness=sharpness,
        added=_added(detail.judged),
        curves=curves,
        ratios={name: curve_ratios(mosaic.curves[name], curve) for name, curve in curves.items()},
        similarity={name: correlation(mosaic.coarse[name], own) for name, own in coarse.items()},
        changes=(*(measure_changes(image, *compared) for compared in zip(images, tones, shifts)), against_composite),
        expected=expected_ratios(feathers([one.plane for one in images if one.valid is None], wavelet, levels), levels),
        unclear_share=following.unclear_share,
        mixed_share=following.mixed_share,
        shares=following.shares,
        visibility=window_visibility(profile, detail.judged, image.plane, ground.inside, image.raster),
        loss=loss_picture(detail, ground.expected.labels, ground.inside),
    )
    return _unclear(found) if ground.is_unclear else found


def _unclear(found: Explanation) -> Explanation:
    """Without what can't be told of a mosaic that the sources say too little of."""
    return replace(
        found, causes=(Cause.UNCLEAR,), profile=None, explained=0.0, sharpness=None, added=None, visibility=None,
        loss=None,
    )  # fmt: skip


def _shift(image: ComparedImage, other: ComparedImage, following: FollowedSource, source: int) -> Shift | None:
    """On the ground: where the source's pixel grid lies beside the mosaic's, that is taken into account."""
    where = following.labels == source if source in following.followed else other.valid
    shift = find_shift(image.spectra, other.spectra, where)
    return shift and replace(shift, x=shift.x + other.offset[0], y=shift.y + other.offset[1])


def _main_shift(shifts: Sequence[Shift]) -> Shift | None:
    """Shift of the composite, on the mosaic's own grid: that of its sources on their pixels, if they have the same."""
    return shifts[0] if shifts and farthest_apart(shifts) <= MAX_SAME_SHIFT_PX else None


def _on_pixels_of(cells: np.ndarray, labels: np.ndarray) -> np.ndarray:
    """What cells say, for the pixels that a source explains, (rows, columns) bool."""
    found = np.zeros(labels.shape, bool)
    large = enlarged(cells, CELL_PX)[: labels.shape[0], : labels.shape[1]]
    found[: large.shape[0], : large.shape[1]] = large
    return found & (labels != UNKNOWN)


def _texture(finest: np.ndarray, cut: HardCut, unmixed: np.ndarray, unit: float) -> Texture | None:
    """Where one source is followed for sure; where that is too little, where one is followed at all."""
    unfiltered = cut.ground.expected.unfiltered[cut.ground.inside]
    found = (
        measure_texture(finest, cut.ground.labels, sure, cut.mosaic.plane, unfiltered, unit)
        for sure in (unmixed & cut.ground.following.clear, unmixed)
    )
    return next((one for one in found if one is not None), None)


def _on_pixels(
    shifts: Sequence[Shift | None], images: Sequence[ComparedImage], following: FollowedSource
) -> list[Shift]:
    """How the mosaic lies on the pixels of the sources that it follows, those with most pixels first."""
    return [
        replace(shift, x=shift.x - images[i].offset[0], y=shift.y - images[i].offset[1])
        for i in following.followed
        if (shift := shifts[i]) is not None and following.shares[i] >= MIN_PLACED_SHARE
    ]


def _off_pixel(shifts: Sequence[Shift]) -> float:
    """How far the mosaic's pixels lie off those of a source that it follows, px."""
    return max((float(np.hypot(one.x - round(one.x), one.y - round(one.y))) for one in shifts), default=0.0)


def _source_tones(
    image: ComparedImage,
    images: Sequence[ComparedImage],
    following: FollowedSource,
    tones: Sequence[Mapping[str, Tone | None]],
) -> tuple:
    judged = next(iter(image.coarse))
    numbers = [i for i in following.followed if following.shares[i] >= MIN_TONE_SHARE]
    return measure_tones(
        image.raster,
        [
            (images[i].raster, following.shares[i], float(images[i].coarse[judged].mean()), tones[i][judged],
             gains_of_colours(tones[i]))
            for i in numbers
        ],
        image.coarse[judged],
    )


def _unevenness(
    image: ComparedImage, images: Sequence[ComparedImage], following: FollowedSource, levels: int
) -> float:
    """Share of what one curve of tones leaves over that a tone which changes from place to place explains.

    The smallest over the bands, since colours that were corrected one by one move the luminance from place to place;
    of the source with most pixels.
    """
    main = following.followed[:1]
    if not main:
        return 0.0
    where = follows_at(following, main[0], levels)
    names = image.names[:3]
    bands = [(image.coarse[name], images[main[0]].coarse[name]) for name in names]
    least = [MIN_UNEVEN_RANGE * float(np.ptp(own)) + 0.5 for own, _ in bands]
    left = [left_over(*band, where) for band in bands]
    if all(curve <= most for (curve, _), most in zip(left, least)):
        return 0.0
    return min(1 - local / curve if curve > 0 else 0.0 for curve, local in left)


def _composite_changes(
    image: ComparedImage,
    composite: Composite,
    curves: Mapping[str, Curve],
    following: FollowedSource,
    shift: Shift | None,
    levels: int,
) -> dict[str, Change]:
    """Against the sources' pixels as they are; tones from where one source is followed, if there is enough of that."""
    reference = image.with_bands(composite.bands, curves, levels)
    unmixed = whole_squares(following.clear & (following.labels != UNKNOWN), levels)
    where = unmixed if unmixed.sum() >= MIN_UNMIXED_SQUARES else np.ones_like(unmixed)
    if shift is None:
        shift = find_shift(image.spectra, reference.spectra)
    return measure_changes(image, reference, image.tones_of(reference, where), shift)


def _contrast(image: ComparedImage, images: Sequence[ComparedImage], change: Change) -> float | None:
    factors = {range_factor(image.raster, other.raster) for other in images}
    factor = next(iter(factors)) if len(factors) == 1 else None
    return None if factor is None or change.contrast[0] is None else factor * change.contrast[0]


def _sharpness(details: np.ndarray, labels: np.ndarray) -> float | None:
    """Amplitude of the finest detail against that of the hard cut unfiltered, where sources explain the mosaic."""
    known = labels[::2, ::2] != UNKNOWN
    own, plain = (float(np.einsum("dij,dij,ij->i", one, one, known, dtype=np.float32).sum(dtype=np.float64))
                  for one in (details[:, 0], details[:, -1]))
    return float(np.sqrt(own / plain)) if plain > 0 else None


def _filter_power(cut: HardCut) -> float | None:
    """Power of the filter that came over the sources that are followed."""
    source_of, taps = cut.ground.followed.source_of, cut.ground.expected.filters.taps
    return filter_power(
        taps[plane] for plane, source in enumerate(source_of)
        if plane in taps and cut.ground.following.shares[source] >= MIN_PLACED_SHARE
    )


def _added(cells: CellTable) -> float | None:
    mm, cc, mc = (float(sums[0].sum()) for sums in (cells.mm, cells.cc, cells.mc))
    return 1 - mc**2 / (mm * cc) if mm > 0 and cc > 0 else None


def _causes(evidence: CauseEvidence, lacks_profile: bool) -> tuple[Cause, ...]:
    """Where nothing could be measured along a seam, finding nothing says nothing."""
    found = find_causes(evidence)
    return (Cause.UNCLEAR,) if lacks_profile and found == (Cause.NONE,) else found


def _seam_loss(profile: SeamProfile | None, sharpness: float | None, total: float) -> float:
    """Share of the finest detail energy of the window's sources, ``total`` DN squared, that its seams took."""
    if profile is not None:
        return min(profile.lost / total, 1.0) if total > 0 else 0.0
    return max(1 - sharpness**2, 0.0) if sharpness is not None else 0.0


def _clipped_loss(image: ComparedImage, finest: np.ndarray, total: float) -> float:
    """Share of the sources' finest detail energy, ``total``, gone where the mosaic is at an end of its scale."""
    ends = np.zeros(image.bands.shape[1:], bool)
    for band in image.bands:
        ends |= (band == band.min()) | (band == band.max())
    at = ends[::2, ::2]
    if not at.any():
        return 0.0
    own, plain = (float(np.einsum("dij,dij,ij->", one, one, at)) for one in (finest[:, 0], finest[:, -1]))
    return max(plain - own, 0.0) / total if total > 0 else 0.0


def _misfit(cut: HardCut, shifts: Sequence[Shift | None], wavelet: str) -> Misfit | None:
    """Misfit of the two sources that the mosaic follows most, as they are placed in it."""
    pair = cut.ground.following.followed[:2]
    if len(pair) < 2:
        return None
    first, second = (shifts[i] for i in pair)
    between = find_shift(*(cut.sources[i].spectra for i in pair))
    if first is None or second is None or between is None:
        return None
    offsets = [cut.sources[i].offset for i in pair]
    first, second = (replace(one, x=one.x - by[0], y=one.y - by[1]) for one, by in zip((first, second), offsets))
    shown, labels = cut.ground.expected.shown, cut.ground.expected.labels
    if any(i not in shown for i in pair):
        return None
    coarse = labels[::_EVERY, ::_EVERY]
    coarse = np.where(is_one_of(coarse, pair), coarse, np.uint8(UNKNOWN))
    seam = enlarged(near_border(coarse, _ABOUT_PX // _EVERY) & (coarse != UNKNOWN), _EVERY)
    seam = seam[: labels.shape[0], : labels.shape[1]]
    return misfit_of(placed_misfit(between, first, second), shown, (pair[0], pair[1]), seam, wavelet)
