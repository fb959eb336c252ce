"""What is known of one window: the curves of its clips, which come first, and all that was measured."""
from __future__ import annotations

from dataclasses import dataclass, field
from math import inf

from ....imagery.errors import Message
from ....imagery.grids import PixelWindow
from ....imagery.wavelets import Curve, Directions
from ..compared_image import Change
from ..judgement.causes import Cause
from ..judgement.explanation import Explanation
from ..judgement.loss_place import LossPlace
from ..judgement.verdicts import MAX_KEPT_LOW, Judgement, Ratios, Verdict
from ..limits import SHARPNESS_TOLERANCE
from ..profile.seam_profile import SeamProfile
from ..profile.window_detail import LossPicture
from ..window_records import COMPOSITE, REFERENCES, SEAM


@dataclass(frozen=True)
class ClipResult:
    """The curves of one raster in one window."""

    raster: str
    """File name without its folder."""
    role: str
    """``mosaic``, ``source`` or ``composite``."""
    curves: dict[str, Curve] = field(hash=False)
    """Curves by band name, ``luminance`` first where there is one."""
    directions: dict[str, Directions] = field(default_factory=dict, hash=False)
    """Relative variances by band name and direction; empty where that was not asked for."""


@dataclass(frozen=True)
class PairResult:
    """The mosaic against one source in one window and band."""

    source: str
    """File name without its folder, or ``composite``."""
    band: str
    """``luminance``, ``red``, ``green``, ``blue``, ``nir`` or ``band_N``."""
    ratios: Ratios
    """The mosaic's shares over the source's."""
    similarity: float | None
    """Correlation of the coarse components at level R; None where one of them is constant."""
    offset_x: float
    """Sub-pixel offset of the source's pixel grid to the right, px."""
    offset_y: float
    """Sub-pixel offset downwards, px."""
    resampled: bool
    """Whether the source was warped to the mosaic's grid."""
    change: Change | None = None
    """What became of its grey values in the mosaic."""


@dataclass(frozen=True)
class WindowResult:
    """What was measured in one window."""

    window_id: int
    """The request's."""
    window: PixelWindow | None
    """The pixels of the mosaic that were measured."""
    judgement: Judgement
    """The verdict that counts, and the ratios of the paper."""
    paper_verdict: Verdict
    """Verdict by the paper's rule, whatever the verdict was taken by."""
    clips: tuple[ClipResult, ...] = ()
    """The mosaic first, then the sources that took part."""
    pairs: tuple[PairResult, ...] = ()
    """The mosaic against each source that covers the window, band by band."""
    explanation: Explanation | None = None
    """Why contrast was lost; None where nothing could be compared."""
    notices: tuple[Message, ...] = field(default=(), compare=False)
    """Why a source that could not be read or compared did not take part, or only in part."""
    ground_sample_distance: float = 0.0
    """The mosaic's pixel size, m."""
    reference: str = REFERENCES[0]
    """What the verdict was taken by."""

    @property
    def levels(self) -> int:
        """R."""
        return len(self.judgement.ratios.detail)

    @property
    def longer_side_m(self) -> float:
        """Longer side of the window; without end where that is not known."""
        return inf if self.window is None else max(self.window.width, self.window.height) * self.ground_sample_distance

    @property
    def profile(self) -> SeamProfile | None:
        """What is kept along the seam; None without one, or where it can't be told, or is more than any seam leaves."""
        profile = self.explanation.profile if self.explanation else None
        return None if profile is not None and profile.low > MAX_KEPT_LOW else profile

    @property
    def loss(self) -> LossPicture | None:
        """The picture of where the sources' detail was lost; None where that can't be told."""
        return self.explanation.loss if self.explanation else None

    @property
    def ground_left(self) -> float:
        """What the ground that the seam is compared with has of the sources' finest detail."""
        return self.explanation.ground_left if self.explanation else 1.0

    @property
    def lost_m2(self) -> float | None:
        """The finest detail that is missing, as so many square metres of the window hold: what the verdict was taken
        by, in one unit for all windows. 0 where no loss is sure; None without a verdict.
        """
        if self.window is None or self.judgement.verdict is Verdict.NOT_COMPARABLE:
            return None
        if self.judgement.verdict is Verdict.PRESERVED:
            return 0.0
        explanation, ratios = self.explanation, self.judgement.ratios
        if self.reference == SEAM and explanation is not None:  # along its seam, or in all of it where that is more
            along = explanation.evidence.lost if self.profile is not None and self.profile.high < 1 else 0.0
            sharpness = 1.0 if explanation.sharpness is None else explanation.sharpness
            share = max(along, 1 - sharpness**2 if sharpness < 1 - SHARPNESS_TOLERANCE else 0.0)
        else:
            if self.reference == COMPOSITE and explanation is not None:
                ratios = next(iter(explanation.ratios.values()))
            share = 1 - (ratios.detail[0] or 0.0)
        return self.window.width * self.window.height * self.ground_sample_distance**2 * max(share, 0.0)

    @property
    def band_width_m(self) -> float | None:
        """Full width of the band along the seam in which detail was lost."""
        return self.profile.band_width_px * self.ground_sample_distance if self.profile else None

    @property
    def feather_width_m(self) -> float | None:
        """Full width of the feather; 0 for a cut, None where it was not looked for."""
        width = self.profile.feather_width_px if self.profile else None
        return None if width is None else width * self.ground_sample_distance

    @property
    def misfit(self) -> float | None:
        """How far the two images that meet lie from each other as they are placed in the mosaic, px."""
        return self.explanation.misfit if self.explanation else None

    @property
    def visibility(self) -> float | None:
        """The loss beside the seam in just noticeable differences of contrast at the desk's magnification."""
        return self.explanation.visibility if self.explanation else None

    @property
    def causes(self) -> tuple[Cause, ...]:
        """All that were found: what took the detail that the verdict goes by, then the others, what took most first."""
        causes = self.explanation.causes if self.explanation else ()
        first = self.loss_place.decisive(causes) if self.reference == SEAM else causes
        return tuple(sorted(causes, key=lambda cause: cause not in first))

    @property
    def loss_place(self) -> LossPlace:
        """The place of the loss that the verdict goes by, where that was taken by the seam."""
        kept, high = (self.profile.kept[0], self.profile.high) if self.profile else (None, None)
        return LossPlace(
            self.judgement.verdict.value, kept, high, self.explanation.sharpness if self.explanation else None
        )

    @property
    def explained(self) -> float | None:
        """Share of the window whose fine detail the given sources explain."""
        return self.explanation.explained if self.explanation else None

    @property
    def is_compared(self) -> bool:
        """Whether a source took part; what is known then is shown even where it is too little for a verdict."""
        return self.judgement.verdict is not Verdict.NOT_COMPARABLE or self.explanation is not None

    @property
    def with_composite(self) -> tuple[ClipResult, ...]:
        """The clips, last the sources' composite where there is one."""
        if self.explanation is None:
            return self.clips
        return (*self.clips, ClipResult(COMPOSITE, COMPOSITE, self.explanation.curves))

    @property
    def composite_pairs(self) -> tuple[PairResult, ...]:
        """The mosaic against the composite, band by band."""
        explanation = self.explanation
        if explanation is None:
            return ()
        resampled = any(pair.resampled for pair in self.pairs)
        similarity, changes = explanation.similarity, explanation.changes[-1]
        return tuple(
            PairResult(COMPOSITE, name, ratios, similarity[name], 0.0, 0.0, resampled, changes[name])
            for name, ratios in explanation.ratios.items()
        )

    @property
    def source_count(self) -> int:
        """How many sources took part, wholly or in part."""
        if self.explanation is None:
            return sum(clip.role == "source" for clip in self.clips)
        return len(self.explanation.changes) - 1  # the last is against the composite


@dataclass(frozen=True)
class WindowClips(WindowResult):
    """What the pixels of each raster say by themselves, which is known before they are compared pixel by pixel."""

    has_sources: bool = False
    """Whether there is a source to compare with, wholly or in part."""

    @property
    def is_compared(self) -> bool:
        """The comparison is still to come."""
        return self.has_sources
