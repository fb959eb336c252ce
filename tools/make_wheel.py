"""Make the wheel of what needs no QGIS, of the last commit; the same bytes every time.

It is the Python interface (docs/python) for notebooks and pipelines, and what the workers of a cluster need.

    python -m tools.make_wheel [FOLDER]
"""
from __future__ import annotations

import argparse
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from .committed import REPOSITORY, check_out, commit_time, refuse_what_is_not_committed


def make_wheel(folder: Path) -> Path:
    """The wheel's path. Ends the program with the build tool's words when it can't be made."""
    folder.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as temporary:
        tree, made = Path(temporary) / "tree", Path(temporary) / "made"
        check_out(tree)
        run = subprocess.run(
            [sys.executable, "-m", "hatchling", "build", "-t", "wheel", "-d", str(made)], cwd=tree,
            capture_output=True, text=True, check=False,
            env={**os.environ, "SOURCE_DATE_EPOCH": str(commit_time()), "PYTHONHASHSEED": "0"},
        )  # fmt: skip
        if run.returncode:
            sys.exit(f"The wheel is not made:\n{run.stdout}{run.stderr}".strip())
        (wheel,) = made.glob("*.whl")
        return Path(shutil.copyfile(wheel, folder / wheel.name))


def main() -> None:
    """Command line."""
    parser = argparse.ArgumentParser(description="Make the wheel for Python without QGIS of the last commit.")
    parser.add_argument("folder", type=Path, nargs="?", default=REPOSITORY / "build")
    folder = parser.parse_args().folder
    refuse_what_is_not_committed()
    print(make_wheel(folder))


if __name__ == "__main__":
    main()
