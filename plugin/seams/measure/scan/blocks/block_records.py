"""A block's results as bytes, for the journal."""
from __future__ import annotations

import numpy as np

from .....imagery.records.array_records import packed, unpacked
from ...profile.cell_table import CellTable, MixtureTable
from .scan_block import BlockScan

_OWN = ("squares", "dense", "outside", "labels", "mixture", "clear", "grey")
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
    """What ``record_of`` made bytes of."""
    held = unpacked(record)
    row, column = held["key"].tolist()
    names = held["sources"].tobytes().decode()
    return BlockScan(
        (row, column), tuple(names.split("\n")) if names else (), **{name: held[name] for name in _OWN},
        cells=CellTable(*(held[f"cells {name}"] for name in _TABLES["cells"])),
        beside=MixtureTable(*(held[f"beside {name}"] for name in _TABLES["beside"])),
    )
