"""The package as QGIS loads it."""
from __future__ import annotations

import importlib
import os
import subprocess
import sys
from pathlib import Path


def test_package_offers_its_factory() -> None:
    assert callable(importlib.import_module("seam_inspector").classFactory)


REMEMBERED = """
import gc, importlib, pathlib, sys, typing
root = pathlib.Path("seam_inspector").resolve()
for path in sorted((root / "plugin").rglob("*.py")):
    importlib.import_module(".".join(["seam_inspector", *path.relative_to(root).with_suffix("").parts]))
def is_ours(kind):
    if isinstance(kind, (list, tuple)):
        return any(map(is_ours, kind))
    held = isinstance(kind, type) and kind.__module__.startswith("seam_inspector")
    return held or is_ours(typing.get_args(kind))
print([str(kind) for kind in gc.get_objects() if type(kind).__module__ == "typing" and is_ours(typing.get_args(kind))])
"""


def test_typing_remembers_no_class_of_ours(repository: Path) -> None:
    """Its ``Union[...]`` and ``Callable[...]`` are kept in caches of Python's own, and with a class of ours in them all
    that QGIS unloads with the plugin. Names in quotes, and ``collections.abc.Callable``, are not.
    """
    finished = subprocess.run(
        [sys.executable, "-c", REMEMBERED], cwd=repository / "build" / "plugins", capture_output=True, text=True,
        env={**os.environ, "PYTHONPATH": "."},
    )  # fmt: skip
    assert finished.stdout.strip() == "[]", finished.stdout + finished.stderr
