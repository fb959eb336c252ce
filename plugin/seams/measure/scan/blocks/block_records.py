"""A block's results as bytes, for the journal."""
from __future__ import annotations

import numpy as np

from .....imagery.records import NotUnderstoodError, packed, understanding, unpacked
from ...profile.cell_table import CellTable, MixtureTable
from .block_grid import LABELS, SQUARES, UNITS
from .scan_block import CELLS, BlockScan

_OWN = {
    "squares": SQUARES, "dense": UNITS, "outside": UNITS, "labels": LABELS, "mixture": CELLS, "clear": CELLS,
    "grey": CELLS,
}
"""And how many samples each has along a side."""
_TABLES = {"cells": CellTable.names(), "beside": MixtureTable.names()}


def record_of(scan: BlockScan) -> bytes:
    """All but the notices, which are told once."""
    arrays = {name: getattr(scan, name) for name in _OWN}
    for table, names in _TABLES.items():
        arrays |= {f"{table} {name}": getattr(getattr(scan, table), name) for name in names}
    arrays["key"] = np.array(scan.key)
    arrays["sources"] = np.frombuffer("\n".join(scan.sources).encode(), np.uint8)
    return packed(arrays, compressed=_OWN)


def scan_of(record: bytes) -> BlockScan:
    """What ``record_of`` made bytes of. Raises NotUnderstoodError for anything else."""
    with understanding():
        held = unpacked(record)
        row, column = held["key"].tolist()
        names = held["sources"].tobytes().decode()
        cells = CellTable(*(held[f"cells {name}"] for name in _TABLES["cells"]))
        beside = MixtureTable(*(held[f"beside {name}"] for name in _TABLES["beside"]))
        if any(held[name].shape != (side, side) for name, side in _OWN.items()):
            raise NotUnderstoodError("of another size")
        if any(column.shape[-1] != len(table.row) for table in (cells, beside) for column in vars(table).values()):
            raise NotUnderstoodError("a table with holes")
        own = {name: held[name] for name in _OWN}
        return BlockScan(
            (row, column), tuple(names.split("\n")) if names else (), **own, cells=cells, beside=beside
        )
