"""Pieces of seam with what they kept, and the verdict on each."""
from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from ....imagery.errors import Message
from ..following.likely_source import MIN_FIT, MIN_TEXTURE
from ..limits import MAX_SIGNIFICANT_KEPT
from ..profile.seam_profile import MIN_STRIP_PX, STRIP_PX
from ..profile.seam_sums import StripProfile
from ..verdicts import MAX_INTERVAL_FACTOR, Verdict, judge_by_seam
from . import messages
from .lines.seam_pieces import SeamPiece

LEAST_WITHOUT_VERDICT = 0.02  # of the seams: more is told


@dataclass(frozen=True, eq=False)
class JudgedPiece:
    """One feature of SEAMS."""

    piece: SeamPiece
    """Where it runs."""
    left: str | None
    """Name of the source on the left hand; None where nothing says."""
    right: str | None
    """Name of the source on the right hand."""
    kept: tuple[float | None, ...] | None
    """In the strip beside the seam, levels 1..R; None where nothing could be measured."""
    low: float | None
    """Lower end of the 95 % interval of kept_1."""
    high: float | None
    """Upper end."""
    band_width_m: float | None
    """Full width of the band in which less than 0.9 is kept."""
    verdict: Verdict
    """By what it kept beside the seam."""
    reason: Message | None = None
    """Why there is no verdict."""
    visibility: float | None = None
    """The loss in just noticeable differences of contrast at 2x; None too where no source says what there was."""
    feather_width_m: float | None = None
    """Full width of the feather; 0 for a cut, None where it was not looked for."""
    left_date: str | None = None
    """When the source on the left hand was taken, where the seams say so."""
    right_date: str | None = None
    """The same of the one on the right hand."""

    @property
    def least_kept(self) -> float | None:
        """kept_1."""
        return self.kept[0] if self.kept else None


def judge_piece(
    piece: SeamPiece, sides: tuple[str | None, str | None], found: StripProfile, ground_sample_distance: float,
    visibility: float | None = None,
) -> JudgedPiece:
    """The verdict on one piece by its profile, and how visible its loss is, JND."""
    if found.profile is None:
        needed = MIN_STRIP_PX / (2 * STRIP_PX) * ground_sample_distance
        short = messages.PIECE_TOO_SHORT(length=piece.length_m, needed=needed) if piece.length_m < needed else None
        reason = short or messages.PIECE_NOT_MEASURED()
        return JudgedPiece(piece, *sides, None, None, None, None, Verdict.NOT_COMPARABLE, reason)
    profile = found.profile
    # What little is left where detail was brushed away resembles no source.
    if found.fit < MIN_FIT and found.texture >= MIN_TEXTURE:
        return JudgedPiece(
            piece, *sides, None, None, None, None, Verdict.NOT_COMPARABLE, messages.PIECE_NOT_EXPLAINED()
        )
    verdict, why = judge_by_seam(profile, True, 1.0, MAX_SIGNIFICANT_KEPT)
    if verdict is Verdict.NOT_COMPARABLE and profile.high > MAX_INTERVAL_FACTOR * profile.low:
        why = messages.PIECE_INTERVAL_TOO_WIDE(low=100 * profile.low, high=100 * profile.high)
    width = profile.band_width_px * ground_sample_distance
    feather = None if profile.feather_width_px is None else profile.feather_width_px * ground_sample_distance
    return JudgedPiece(piece, *sides, profile.kept, profile.low, profile.high, width, verdict, why, visibility, feather)


def dated(one: JudgedPiece, dates: Mapping[str, str]) -> JudgedPiece:
    """A piece with the dates of its sources; ``dates``: by their names."""
    return replace(one, left_date=dates.get(one.left or ""), right_date=dates.get(one.right or ""))


def without_verdict(pieces: Sequence[JudgedPiece]) -> tuple[Message, ...]:
    """How much of the seams could not be judged, where that is worth telling."""
    lacking, total = metres(pieces, Verdict.NOT_COMPARABLE), metres(pieces)
    if lacking < LEAST_WITHOUT_VERDICT * total or not lacking:
        return ()
    return (messages.SEAMS_WITHOUT_VERDICT(metres=lacking, all=total),)


def metres(pieces: Sequence[JudgedPiece], *verdicts: Verdict) -> float:
    """Length of all pieces, or of those with one of some verdicts."""
    return sum((one.piece.length_m for one in pieces if not verdicts or one.verdict in verdicts), 0.0)
