"""Arrays by name as bytes and back: numpy's own archives take longer to open than a block takes to be put together."""
from __future__ import annotations

import json
import math
import struct
import zlib
from collections.abc import Collection, Iterator, Mapping
from contextlib import contextmanager

import numpy as np

_LENGTH = struct.Struct("<I")
_QUICK = 1  # of zlib: what is worth it are runs
_MOST_BYTES = 2**29  # of all arrays of a record; the largest of ours is a tenth of it


class NotUnderstoodError(Exception):
    """A record of another version, or by somebody else."""


@contextmanager
def understanding() -> Iterator[None]:
    """Around the reading of a record: raises NotUnderstoodError whatever its bytes do."""
    try:
        yield
    except NotUnderstoodError:
        raise
    except Exception as error:
        raise NotUnderstoodError(f"{type(error).__name__}: {error}") from None


def packed(arrays: Mapping[str, np.ndarray], compressed: Collection[str] = ()) -> bytes:
    """Arrays of numbers one after the other, those named in ``compressed`` deflated."""
    parts, layout = [], []
    for name, array in arrays.items():
        held = np.ascontiguousarray(array).tobytes()
        if name in compressed:
            held = zlib.compress(held, _QUICK)
        layout.append((name, array.dtype.str, array.shape, len(held), name in compressed))
        parts.append(held)
    head = json.dumps(layout).encode()
    return b"".join([_LENGTH.pack(len(head)), head, *parts])


def unpacked(record: bytes) -> dict[str, np.ndarray]:
    """What ``packed`` made bytes of; the arrays can't be written to. To be called with ``understanding``."""
    (length,) = _LENGTH.unpack_from(record)
    place, found, left = _LENGTH.size + length, {}, _MOST_BYTES
    for name, kind, shape, size, is_compressed in json.loads(record[_LENGTH.size : place]):
        held = record[place : place + size]
        whole = math.prod(shape) * np.dtype(kind).itemsize
        left -= max(whole, size)
        if left < 0:
            raise NotUnderstoodError(f"{name}: {shape}")
        if is_compressed:
            held = zlib.decompressobj().decompress(held, max(whole, 1))
        found[name] = np.frombuffer(held, kind).reshape(shape)
        place += size
    return found
