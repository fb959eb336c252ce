"""What of the selected windows can be drawn, and words for it."""
from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from ....toolkit.translation import band_title, filled, sentence, tr

if TYPE_CHECKING:
    from ...measure.live_window import LiveWindow
    from ...measure.window.window_result import WindowCurves
    from ..session import Session


def selected_windows(session: Session) -> tuple[list[WindowCurves], str]:
    """What there is of the selected windows that can be compared; without any, why not."""
    selected = session.selected()
    found = [result for result in map(session.clips, selected) if result is not None]
    usable = [result for result in found if result.is_compared and result.clips]
    return usable, "" if usable else _why_nothing(session, selected)


def title(session: Session, results: Sequence[WindowCurves]) -> str:
    """Which windows are drawn."""
    selected = session.selected()
    if len(results) > 1 and len(results) < len(selected):
        template = tr("{count} of the {selected} selected windows: mean and range")
        return filled(template, count=len(results), selected=len(selected))
    if len(results) > 1:
        return filled(tr("{count} windows: mean and range"), count=len(results))
    text = filled(tr("Window {number}"), number=results[0].window_id)
    row = session.row(selected[0]) if len(selected) == 1 else None
    if row is not None and row.stale:
        text += tr(", out of date: inspect it again")
    return text


def live_title(live: LiveWindow) -> str:
    """Which window is drawn while it is being moved."""
    template = tr("Live, {band}: {columns} x {rows} px under the mouse")
    band = band_title(next(iter(live.clips.clips[0].curves)))
    return filled(template, band=band, columns=live.window.width, rows=live.window.height)


def _why_nothing(session: Session, selected: Sequence[int]) -> str:
    if not selected:
        return tr("Select a window in the table or on the map, or draw one.")
    found = [result for result in map(session.result, selected) if result is not None]
    if found and len(selected) > 1:
        return tr("None of the selected windows can be compared.")
    if found:
        reason = found[0].judgement.reason
        return sentence(reason) if reason else tr("This window can't be compared.")
    if any(map(session.is_pending, selected)):
        return tr("Measuring ...")
    rows = [row for row in map(session.row, selected) if row is not None]
    if len(rows) == 1 and rows[0].verdict and not rows[0].is_compared and rows[0].reason and not rows[0].stale:
        return rows[0].reason
    if any(row.verdict for row in rows):
        return tr("The curves are not kept with the project. Inspect again to see them.")
    return tr("Not inspected yet")
