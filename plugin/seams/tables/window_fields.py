"""The fields of a window layer, one entry each: what it is called, how the desk shows it and what its filter calls
it. Type and value of what is measured are those of ``WINDOW_COLUMNS``.

Layers, records, aliases, the desk's columns and its filter are made of these. The names are contracts.
"""
from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from qgis.PyQt.QtCore import QT_TRANSLATE_NOOP

from ...imagery.records import Column
from ...imagery.statistics import JUDGING_FIELDS
from ...toolkit.layer_styles import give_titles
from ..measure.window.window_result import WindowResult
from ..measure.window.window_tables import WINDOW_COLUMNS


def _nothing(result: WindowResult) -> None:
    return None


@dataclass(frozen=True)
class WindowField(Column):  # of WindowResult; said so typing would keep the plugin when it is unloaded
    """A column of OUTPUT, and of every window layer."""

    value: Callable[[WindowResult], Any] = _nothing
    attribute: str = ""
    """Of a WindowRecord; empty: the name, where the record has one, else it is among its ``others``."""
    title: str = ""
    """What layers call it, with ``{level}`` where it has one; empty where all our layers call it so."""
    heading: str = ""
    """Of its column in the desk; empty where that is written otherwise, or there is none."""
    help: str = ""
    shown: str = "number"
    """How its column shows it: ``number``, ``tenths``, ``percent`` (of a share), ``of 100``, ``metres``, ``px``,
    ``whole``, ``words``, ``observer`` or ``causes``."""
    called: tuple[str, ...] = ()
    """What else the filter calls it."""
    is_share: bool = False
    """Whether the table shows it in percent, which its filter minds."""

    @property
    def read_as(self) -> str:
        """What ``WindowRecord.read`` finds it by."""
        return self.attribute or self.name


def _measured(name: str, **words: Any) -> WindowField:
    """A field of a column that is measured, and what it is called."""
    column = _COLUMNS[name]
    return WindowField(column.name, column.kind, column.value, column.by_level, **words)


_COLUMNS = {one.name: one for one in WINDOW_COLUMNS}

MEASURED = (
    _measured("window_id", called=("id",)),
    _measured("verdict"),
    _measured("reason"),
    _measured("sources"),
    _measured("ratio", attribute="ratios", title=QT_TRANSLATE_NOOP("@default", "ratio {level}")),
    _measured("background_ratio", title=QT_TRANSLATE_NOOP("@default", "ratio of the background")),
    WindowField("observer", "text"),  # the operator's word, not ours
    _measured(
        "composite_ratio",
        attribute="composite_ratios", title=QT_TRANSLATE_NOOP("@default", "ratio {level} against the composite"),
    ),
    _measured(
        "expected_ratio",
        attribute="expected_ratios", title=QT_TRANSLATE_NOOP("@default", "ratio {level} expected of a feather"),
    ),
    _measured(
        "unclear_share",
        is_share=True, title=QT_TRANSLATE_NOOP("@default", "share where no source wins clearly"),
    ),
    _measured("cause"),
    _measured(
        "causes",
        heading=QT_TRANSLATE_NOOP("@default", "all causes"), shown="causes",
        help=QT_TRANSLATE_NOOP("@default", "All that happened to the contrast, what took most first."),
    ),
    _measured("reference"),
    _measured("paper_verdict", called=("paper",)),
    _measured("kept", is_share=True),
    _measured(
        "kept_low",
        heading=QT_TRANSLATE_NOOP("@default", "kept from"), shown="percent", is_share=True,
        help=QT_TRANSLATE_NOOP("@default", "Lower end of the 95 % interval of what is kept along the seam."),
    ),
    _measured(
        "kept_high",
        heading=QT_TRANSLATE_NOOP("@default", "kept to"), shown="percent", is_share=True,
        help=QT_TRANSLATE_NOOP("@default", "Upper end of the 95 % interval of what is kept along the seam."),
    ),
    _measured(
        "band_width",
        heading=QT_TRANSLATE_NOOP("@default", "band width"), shown="metres", called=("band",),
        help=QT_TRANSLATE_NOOP("@default", "Width of the band along the seam in which detail was lost."),
    ),
    _measured(
        "feather_width",
        heading=QT_TRANSLATE_NOOP("@default", "feather width"), shown="metres", called=("feather",),
        help=QT_TRANSLATE_NOOP(
            "@default",
            "Width of the feather, by where the mixture of the two images goes from 10 to 90 %; 0 for a hard cut."
        ),
    ),
    _measured(
        "visibility",
        heading=QT_TRANSLATE_NOOP("@default", "visibility"), shown="tenths",
        help=QT_TRANSLATE_NOOP(
            "@default",
            "How many times more was lost along the seam than an eye just sees side by side at 2x (just noticeable "
            "differences, JND)."
        ),
    ),
    _measured(
        "misfit",
        title=QT_TRANSLATE_NOOP("@default", "images apart in the mosaic (px)"),
        heading=QT_TRANSLATE_NOOP("@default", "misfit"), shown="px",
        help=QT_TRANSLATE_NOOP("@default", "How far apart the two images lie where they meet, as the mosaic has them."),
    ),
    _measured("contrast_1", attribute="contrast", called=("contrast",)),
    _measured(
        "sharpness_1",
        attribute="sharpness", heading=QT_TRANSLATE_NOOP("@default", "sharpness"), shown="percent", is_share=True,
        called=("sharpness",),
        help=QT_TRANSLATE_NOOP("@default", "Sharpness of the whole window against the composite of its sources."),
    ),
    _measured(
        "added_1",
        attribute="added", heading=QT_TRANSLATE_NOOP("@default", "added"), shown="percent", is_share=True,
        called=("added",),
        help=QT_TRANSLATE_NOOP("@default", "Share of the mosaic's finest detail that its sources don't have."),
    ),
    _measured(
        "explained",
        title=QT_TRANSLATE_NOOP("@default", "share that the sources explain"),
        heading=QT_TRANSLATE_NOOP("@default", "explained"), shown="percent", is_share=True,
        help=QT_TRANSLATE_NOOP("@default", "Share of the pixels whose detail the given sources explain."),
    ),
)  # fmt: skip
"""OUTPUT of ``inspectwindows``: one polygon per window, as measured."""

SAID = (
    WindowField(
        "observer_2", JUDGING_FIELDS["observer_2"], title=QT_TRANSLATE_NOOP("@default", "observer 2"),
        heading=QT_TRANSLATE_NOOP("@default", "observer 2"), shown="observer",
        help=QT_TRANSLATE_NOOP("@default", "What the second operator saw at 2x magnification."),
    ),
    WindowField(
        "confidence", JUDGING_FIELDS["confidence"], title=QT_TRANSLATE_NOOP("@default", "sure (%)"),
        heading=QT_TRANSLATE_NOOP("@default", "sure"), shown="of 100", called=("sure",),
        help=QT_TRANSLATE_NOOP("@default", "How sure the observer is, 0 to 100 %."),
    ),
    WindowField(
        "confidence_2", JUDGING_FIELDS["confidence_2"], title=QT_TRANSLATE_NOOP("@default", "sure 2 (%)"),
        heading=QT_TRANSLATE_NOOP("@default", "sure 2"), shown="of 100",
        help=QT_TRANSLATE_NOOP("@default", "How sure the second operator is, 0 to 100 %."),
    ),
    WindowField(
        "remark", JUDGING_FIELDS["remark"], heading=QT_TRANSLATE_NOOP("@default", "remark"), shown="words",
        title=QT_TRANSLATE_NOOP("@default", "remark"), help=QT_TRANSLATE_NOOP("@default", "The observer's remark."),
    ),
    WindowField(
        "remark_2", JUDGING_FIELDS["remark_2"], title=QT_TRANSLATE_NOOP("@default", "remark 2"),
        heading=QT_TRANSLATE_NOOP("@default", "remark 2"), shown="words",
        help=QT_TRANSLATE_NOOP("@default", "The second operator's remark."),
    ),
)  # fmt: skip
"""What operators say, there as soon as one of them does."""

PLACED = (
    WindowField(
        "seam_id", "integer", heading=QT_TRANSLATE_NOOP("@default", "seam"), shown="whole", called=("seam",),
        help=QT_TRANSLATE_NOOP("@default", "Number of the seam that the window was placed on."),
    ),
    WindowField(
        "station", "real", heading=QT_TRANSLATE_NOOP("@default", "station"), shown="metres",
        help=QT_TRANSLATE_NOOP("@default", "How far along its seam the window lies."),
    ),
)  # fmt: skip
"""Where ``placewindows`` put it."""

WINDOW_FIELDS: tuple[WindowField, ...] = (*MEASURED, *SAID, *PLACED)
give_titles({one.name: one.title for one in WINDOW_FIELDS if one.title})


def in_filter(fields: Sequence[WindowField] = WINDOW_FIELDS) -> dict[str, WindowField]:
    """Fields by all names that a filter may call them, those by level without it."""
    return {name: one for one in fields for name in (one.name, *one.called)}
