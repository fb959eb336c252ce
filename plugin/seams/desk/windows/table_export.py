"""The windows' table as text: rows for the clipboard, and a CSV file."""
from __future__ import annotations

import csv
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from qgis.PyQt.QtCore import QLocale

from ....imagery.atomic_files import replacing
from ....imagery.errors import cell_text
from .windows_columns import TableColumn

if TYPE_CHECKING:
    from ...measure.window_records import WindowRecord


def copied_rows(columns: Sequence[TableColumn], rows: Iterable[WindowRecord]) -> str:
    """As they are read in the table, tab separated, headings first."""
    lines = [[column.title() for column in columns], *([column.text(row) for column in columns] for row in rows)]
    return "\n".join("\t".join(cell_text(" ".join(cell.split())) for cell in line) for line in lines)


def write_csv(path: Path, columns: Sequence[TableColumn], rows: Iterable[WindowRecord]) -> None:
    """All digits of the numbers, as the operator's spreadsheet reads them; fields for headings.

    Where the decimal point is a comma, columns are separated by semicolons. Raises OSError.
    """
    comma = QLocale().decimalPoint() == ","
    encoding = "utf-8-sig"  # by its mark a spreadsheet knows it
    with replacing(path) as unfinished, unfinished.open("w", encoding=encoding, newline="") as file:
        writer = csv.writer(file, delimiter=";" if comma else ",")
        writer.writerow(column.field for column in columns)
        for row in rows:
            writer.writerow(_cell(column, row, comma) for column in columns)


def _cell(column: TableColumn, row: WindowRecord, comma: bool) -> str:
    value = getattr(row, column.field, None)
    if value is None or isinstance(value, (tuple, str)):
        value = column.key(row) if not isinstance(value, str) else value
        if not isinstance(value, (int, float, str)):
            return ""
    if isinstance(value, str):
        return cell_text(value)
    return str(value).replace(".", ",") if comma and isinstance(value, float) else str(value)
