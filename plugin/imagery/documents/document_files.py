"""Documents that others wrote, read with care: a file of moderate size, and JSON that is not nested without an end."""
from __future__ import annotations

import errno
import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any, Callable, Optional

from ..plain_files import is_endless

MOST_BYTES = 100_000_000  # a hundred times the largest table of points or rules anybody has

_PairsHook = Optional[Callable[[Sequence[tuple[str, Any]]], Any]]


def document_bytes(path: Path) -> bytes:
    """The content of a file. Raises OSError for one that can't be read, is none (a device, a pipe), or is too large."""
    if is_endless(str(path)):
        raise OSError(errno.EINVAL, "a device or a pipe")
    with open(path, "rb") as file:
        content = file.read(MOST_BYTES + 1)
    if len(content) > MOST_BYTES:
        raise OSError(errno.EFBIG, f"larger than {MOST_BYTES // 1_000_000} MB")
    return content


def json_document(text: str | bytes, pairs: _PairsHook = None) -> Any:
    """What a JSON text says; ``pairs`` makes the objects. Raises ValueError for what is none, or nested too deeply."""
    try:
        return json.loads(text, object_pairs_hook=pairs)
    except RecursionError:
        raise json.JSONDecodeError("nested too deeply", "", 0) from None
