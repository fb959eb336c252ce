"""What lies in folders, to tell afterwards what was made, changed or taken away."""
from __future__ import annotations

import hashlib
from collections.abc import Iterable
from pathlib import Path

_OF_SQLITE = ("-wal", "-shm", "-journal")
_HASHED = 4 * 2**20
State = dict[str, str]
_known: dict[str, tuple[tuple[int, ...], str]] = {}


def state_of(folders: Iterable[Path]) -> State:
    """A word for the content of each file below some folders."""
    return {str(path): _content(path) for folder in folders for path in folder.rglob("*") if _is_watched(path)}


def differences(before: State, after: State) -> list[str]:
    """What of it is new, changed or gone."""
    made = [f"made {path}" for path in sorted(after.keys() - before.keys())]
    gone = [f"took away {path}" for path in sorted(before.keys() - after.keys())]
    return made + gone + [f"changed {path}" for path in sorted(before.keys() & after.keys())
                          if before[path] != after[path]]


def _is_watched(path: Path) -> bool:
    return not path.is_symlink() and path.is_file() and not path.name.endswith(_OF_SQLITE)


def _content(path: Path) -> str:
    """Read again only where the disk says that it was written: its time of change is nothing a program can set."""
    stat = path.stat()
    stamp = (stat.st_ino, stat.st_size, stat.st_mtime_ns, stat.st_ctime_ns)
    before = _known.get(str(path))
    if before is None or before[0] != stamp:
        before = _known[str(path)] = (stamp, _digest(path, stat.st_size))
    return before[1]


def forget(folder: Path) -> None:
    """What was known of a folder that is gone."""
    for name in [one for one in _known if one.startswith(f"{folder}/")]:
        del _known[name]


def _digest(path: Path, size: int) -> str:
    """QGIS changes how the log of a GeoPackage is written when it opens one; that is not its content."""
    with open(path, "rb") as file:
        head = bytearray(file.read(_HASHED))
    if head.startswith(b"SQLite format 3"):
        for start, end in ((18, 20), (24, 28), (40, 44), (92, 100)):
            head[start:end] = bytes(end - start)
    return f"{size} {hashlib.md5(head, usedforsecurity=False).hexdigest()}"
