"""The decision on a delivery as one page of HTML that needs nothing else."""
from __future__ import annotations

from collections.abc import Iterable
from html import escape
from pathlib import Path

from ..plugin.acceptance.measure.decision import Decision
from ..plugin.imagery.atomic_files import save_text
from .outputs import MADE_BY

_STYLE = "body{font:16px/1.5 sans-serif;max-width:60em;margin:2em auto}td,th{padding:.2em 1em .2em 0;text-align:left}"


def save_report(path: Path, decision: Decision) -> None:
    """Write the page, whole or not at all. Raises SettingsError where it can't be written."""
    sheets = [
        (sheet.name, *(f"{metres:.1f}" for metres in (sheet.total_m, sheet.measured_m, sheet.failed_m)),
         outcome.value if outcome else "")
        for sheet, outcome in zip(decision.sheets, decision.sheet_outcomes)
    ]
    failed = [
        (piece.sheet, piece.seam_id, *("" if value is None else f"{value:.2f}" for value in (
            piece.station_m, piece.length_m, piece.kept_1, piece.kept_low, piece.kept_high
        ))) for piece in (failure.piece for failure in decision.failed)
    ]  # fmt: skip
    parts = [
        f"<h1>{escape(decision.outcome.value.capitalize())}</h1>",
        *(f"<p>{escape(str(sentence))}</p>" for sentence in decision.sentences),
        "<h2>Sheets</h2>", _table(("sheet", "seams (m)", "measured (m)", "failed (m)", "by itself"), sheets),
        "<h2>Failed pieces</h2>",
        _table(("sheet", "seam", "station (m)", "length (m)", "kept", "low", "high"), failed),
    ]
    head = f'<meta charset="utf-8">{MADE_BY}: {decision.outcome.value}</title><style>{_STYLE}</style>'
    save_text(f"<!DOCTYPE html><html lang=en><head>{head}</head><body>{''.join(parts)}</body></html>\n", path)


def _table(head: Iterable[str], rows: Iterable[Iterable[str]]) -> str:
    lines = ["".join(f"<th>{escape(name)}</th>" for name in head)]
    lines += ["".join(f"<td>{escape(value)}</td>" for value in row) for row in rows]
    return f"<table>{''.join(f'<tr>{line}</tr>' for line in lines)}</table>"
