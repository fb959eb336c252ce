"""A block's results as bytes, for the journal."""
from __future__ import annotations

import numpy as np

from .....imagery.records.array_records import packed, unpacked
from .cell_table import CellTable
from .scan_block import BlockScan

_OWN = ("squares", "dense", "outside", "labels", "mixture", "clear", "grey")
_TABLE = ("row", "column", "bin", "area", "mm", "cc", "mc")


def record_of(scan: BlockScan) -> bytes:
    """All but the notices, which are told once."""
    arrays = {name: getattr(scan, name) for name in _OWN}
    arrays |= {name: getattr(scan.cells, name) for name in _TABLE}
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
        cells=CellTable(**{name: held[name] for name in _TABLE}),
    )
