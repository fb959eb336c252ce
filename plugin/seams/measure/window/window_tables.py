"""The tables of an inspection, one entry per column: its field, and how its value comes from a result; and a window's
result as bytes that are kept beside the window layer, and back.

The field names are contracts. Of a window's fields also what people call them: layers, records, aliases
and plain rows are made of these entries.
"""
from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import chain
from operator import itemgetter
from typing import Any

from ....imagery import messages as imagery_messages
from ....imagery import records
from ....imagery.errors import QT_TR_NOOP
from ....imagery.limits import DEFAULT_LEVELS, MIN_SHARE, check_type
from ....imagery.records import Column, NotUnderstoodError, Row, TableRows
from ....imagery.seam_totals import MOST_KEPT, possible
from ....imagery.statistics import JUDGING_FIELDS
from ....imagery.wavelets import DIRECTIONS
from .. import messages
from .window_result import WindowResult

MOST_RATIO = 1 / MIN_SHARE
"""Greatest ratio of detail in the mosaic to that in a source: with less in the source there is no ratio."""
MOST_VISIBLE = 1e4
"""Just noticeable differences: from black to white there are some hundred."""


def _columns(kinds: Mapping[str, str], by_level: Collection[str] = ()) -> tuple[Column[Row], ...]:
    """Columns of rows that have their values by name."""
    return tuple(Column(name, kind, itemgetter(name), name in by_level) for name, kind in kinds.items())


CURVE_COLUMNS = _columns({
    "window_id": "integer", "raster": "text", "role": "text", "band": "text", "component": "text", "level": "integer",
    "relative_variance": "real", "variance": "real",
})
"""CURVES: one row per window, raster, band and component; a constant clip has no relative variances."""

PROFILE_COLUMNS = _columns({
    "window_id": "integer", "level": "integer", "distance": "real", "kept": "real", "low": "real", "high": "real",
    "area": "real", "mixture": "real",
})
"""PROFILES: one row per window, level and distance from the seam."""

PAIR_COLUMNS = _columns({
    "window_id": "integer", "source": "text", "band": "text", "ratio": "real", "similarity": "real", "offset_x": "real",
    "offset_y": "real", "resampled": "integer", "gain": "real", "bias": "real", "gamma": "real", "contrast": "real",
    "sharpness": "real", "clipped": "real", "colour_shift": "real", "shift_x": "real", "shift_y": "real",
}, by_level=("ratio", "contrast", "sharpness"))
"""PAIRS: one row per window, source and band."""


@dataclass(frozen=True)
class WindowField(Column):  # Column[WindowResult] would be kept by typing, and with it an unloaded plugin
    """A column of OUTPUT, and of every window layer: also what it is called."""

    value: Callable[[WindowResult], Any] = lambda result: None
    attribute: str = ""
    """Attribute of a WindowRecord; empty: the name, where the record has one, else it is among its ``others``."""
    title: str = ""
    """What layers call it, with ``{level}`` where it has one; empty where all our layers call it so."""
    most: float | None = None
    """No measurement is above it, nor below 0; None where any number may be."""

    def is_possible(self, value: float | None) -> bool:
        """Whether a measurement can have given that; nothing at all always can."""
        return value is None or self.most is None or possible(value, self.most) is not None

    @property
    def read_as(self) -> str:
        """What ``WindowRecord.read`` finds it by."""
        return self.attribute or self.name


def _explained(name: str) -> Callable[[WindowResult], Any]:
    """What an explanation has by that name, where there is one."""
    return lambda result: result.explanation and getattr(result.explanation, name)


MEASURED = (
    WindowField("window_id", "integer", lambda result: result.window_id),
    WindowField("verdict", "text", lambda result: result.judgement.verdict.value),
    WindowField("reason", "text", lambda result: result.judgement.reason),
    WindowField("sources", "integer", lambda result: result.source_count),
    WindowField(
        "ratio", "real", lambda result: result.judgement.ratios.detail, by_level=True,
        attribute="ratios", title=QT_TR_NOOP("ratio {level}"), most=MOST_RATIO,
    ),
    WindowField(
        "background_ratio", "real", lambda result: result.judgement.ratios.background,
        title=QT_TR_NOOP("ratio of the background"),
    ),
    WindowField("observer", "text"),
    WindowField(
        "composite_ratio", "real",
        lambda result: result.explanation and next(iter(result.explanation.ratios.values())).detail, by_level=True,
        attribute="composite_ratios", title=QT_TR_NOOP("ratio {level} against the composite"), most=MOST_RATIO,
    ),
    WindowField(
        "expected_ratio", "real", _explained("expected"), by_level=True, attribute="expected_ratios",
        title=QT_TR_NOOP("ratio {level} expected of a feather"),
    ),
    WindowField(
        "unclear_share", "real", _explained("unclear_share"), title=QT_TR_NOOP("share where no source wins clearly")
    ),
    WindowField("cause", "text", lambda result: result.causes[0].value if result.causes else None),
    WindowField("causes", "text", lambda result: "; ".join(cause.value for cause in result.causes) or None),
    WindowField("reference", "text", lambda result: result.reference),
    WindowField("paper_verdict", "text", lambda result: result.paper_verdict.value),
    WindowField("kept", "real", lambda result: result.profile and result.profile.kept, by_level=True, most=MOST_KEPT),
    WindowField("kept_low", "real", lambda result: result.profile and result.profile.low),
    WindowField("kept_high", "real", lambda result: result.profile and result.profile.high),
    WindowField("band_width", "real", lambda result: result.band_width_m),
    WindowField("feather_width", "real", lambda result: result.feather_width_m),
    WindowField("visibility", "real", lambda result: result.visibility, most=MOST_VISIBLE),
    WindowField("misfit", "real", lambda result: result.misfit, title=QT_TR_NOOP("images apart in the mosaic (px)")),
    WindowField("contrast_1", "real", _explained("contrast"), attribute="contrast", most=MOST_RATIO),
    WindowField("sharpness_1", "real", _explained("sharpness"), attribute="sharpness"),
    WindowField("added_1", "real", _explained("added"), attribute="added"),
    WindowField("explained", "real", _explained("explained"), title=QT_TR_NOOP("share that the sources explain")),
    WindowField("loss", "real", lambda result: result.lost_m2, title=QT_TR_NOOP("loss (m2)")),
    WindowField(
        "reason_code", "text", lambda result: result.judgement.reason_code or None,
        title=QT_TR_NOOP("code of the reason"),
    ),
)  # fmt: skip
"""OUTPUT of ``inspectwindows``: one polygon per window, as measured; ``observer`` is the operator's word, not ours."""

SAID = (
    WindowField("observer_2", JUDGING_FIELDS["observer_2"], title=QT_TR_NOOP("observer 2")),
    WindowField("confidence", JUDGING_FIELDS["confidence"], title=QT_TR_NOOP("sure (%)")),
    WindowField("confidence_2", JUDGING_FIELDS["confidence_2"], title=QT_TR_NOOP("sure 2 (%)")),
    WindowField("remark", JUDGING_FIELDS["remark"], title=QT_TR_NOOP("remark")),
    WindowField("remark_2", JUDGING_FIELDS["remark_2"], title=QT_TR_NOOP("remark 2")),
)  # fmt: skip
"""What operators say, there as soon as one of them does."""

PLACED = (
    WindowField("seam_id", "integer"),
    WindowField("station", "real"),
    WindowField("origin", "text", title=QT_TR_NOOP("origin")),
)  # fmt: skip
"""Origin of a window: of one that was placed, where; ``drawn``, ``placed`` or ``scan``."""

WINDOW_FIELDS: tuple[WindowField, ...] = (*MEASURED, *SAID, *PLACED)
_ROW_COLUMNS = tuple(column for column in MEASURED if column.name != "observer")


def window_rows(results: Iterable[WindowResult]) -> TableRows:
    """One row per window: verdict, ratios, kept along the seam with its interval, widths, causes.

    The fields are those of the table OUTPUT (docs/reference/tables.md); lengths in metres, shares of 1, DN for grey
    values. Raises SettingsError for what are no results, such as one alone.
    """
    listed = _checked(results)
    return _table(_ROW_COLUMNS, listed, _most_levels(listed))


def profile_rows(results: Iterable[WindowResult]) -> TableRows:
    """One row per window, level and distance from the seam (m): what is kept there, with its 95 % interval.

    The fields are those of the table PROFILES; a window without a seam has no rows.
    """
    return _table(PROFILE_COLUMNS, chain.from_iterable(map(bins_of, _checked(results))))


def curve_rows(results: Iterable[WindowResult]) -> TableRows:
    """One row per window, raster, band, component and level: its relative variance, and its variance (DN squared).

    The fields are those of the table CURVES.
    """
    return _table(CURVE_COLUMNS, chain.from_iterable(map(curves_of, _checked(results))))


def pair_rows(results: Iterable[WindowResult]) -> TableRows:
    """One row per window, source and band: ratios, tones and shifts (px) of the mosaic against that source.

    The fields are those of the table PAIRS; the sources' composite comes last.
    """
    listed = _checked(results)
    return _table(PAIR_COLUMNS, chain.from_iterable(map(pairs_of, listed)), _most_levels(listed))


def _checked(results: Iterable[WindowResult]) -> list[WindowResult]:
    check_type("results", results, Iterable)
    listed = list(results)
    for number, result in enumerate(listed):
        check_type(f"results[{number}]", result, WindowResult)
    return listed


def _table(columns: Sequence[Column[Any]], results: Iterable[object], levels: int = 0) -> TableRows:
    return TableRows(records.rows_of(columns, results, levels), kinds=records.kinds_of(columns, levels))


def bins_of(result: WindowResult) -> Iterator[Row]:
    """The rows of PROFILES for a result; none without a seam."""
    pixel_m = result.ground_sample_distance
    for bin_ in result.profile.bins if result.profile else ():
        yield {
            **vars(bin_), "window_id": result.window_id, "distance": pixel_m * bin_.middle_px,
            "area": pixel_m**2 * bin_.area_px,
        }


def pairs_of(result: WindowResult) -> Iterator[Row]:
    """The rows of PAIRS for a result: each source, then their composite. What became of a source's grey values is None
    where that is not known."""
    for pair in (*result.pairs, *result.composite_pairs):
        change = pair.change
        tone, shift = (change.tone, change.shift) if change else (None, None)
        yield {
            **vars(pair), "window_id": result.window_id, "ratio": pair.ratios.detail, "resampled": int(pair.resampled),
            "gain": tone and tone.gain, "bias": tone and tone.bias, "gamma": tone and tone.gamma,
            "contrast": change and change.contrast, "sharpness": change and change.sharpness,
            "clipped": change and change.clipped, "colour_shift": change and change.colour_shift,
            "shift_x": shift and shift.x, "shift_y": shift and shift.y,
        }


def curves_of(result: WindowResult) -> Iterator[Row]:
    """The rows of CURVES for a result."""
    for clip in result.with_composite:
        for band, curve in clip.curves.items():
            shares = [*(("detail", level, share) for level, share in enumerate(curve.detail, 1)),
                      ("background", len(curve.detail), curve.background)]
            for level, directions in enumerate(clip.directions.get(band, ()), 1):
                shares += [(component, level, share) for component, share in zip(DIRECTIONS, directions)]
            has_variance = curve.variance > 0
            for component, level, share in shares:
                yield {
                    "window_id": result.window_id, "raster": clip.raster, "role": clip.role, "band": band,
                    "component": component, "level": level, "relative_variance": share if has_variance else None,
                    "variance": share * curve.variance if has_variance else 0.0,
                }


def _most_levels(results: Iterable[WindowResult]) -> int:
    return max((result.levels for result in results), default=DEFAULT_LEVELS)


def result_of(record: bytes) -> WindowResult | None:
    """None for what can't be read, or is of another version."""
    try:
        return records.value_of(WindowResult, record, records.sentences_of(imagery_messages, messages))
    except NotUnderstoodError:
        return None
