"""Run the cells of a notebook as Jupyter does, in one namespace, where QGIS and Qt can't be imported.

    python notebook_cells.py NOTEBOOK [FOLDER_FOR_PICTURES]

Prints a JSON list of what each cell of code printed; figures that are shown become 1.png, 2.png, ... in the folder.
"""
from __future__ import annotations

import contextlib
import io
import json
import sys
from pathlib import Path
from typing import Any

FORBIDDEN = ("qgis", "PyQt5", "PyQt6")


def run(notebook: Path, pictures: Path | None = None) -> list[str]:
    """What each cell of code printed."""
    for name in FORBIDDEN:
        sys.modules[name] = None  # type: ignore[assignment]
    printed: list[str] = []
    names: dict[str, Any] = {"__name__": "__main__"}
    for cell in json.loads(notebook.read_text(encoding="utf-8"))["cells"]:
        if cell["cell_type"] == "code":
            with contextlib.redirect_stdout(io.StringIO()) as out:
                exec(compile("".join(cell["source"]), cell["id"], "exec"), names)
            printed.append(out.getvalue())
    if pictures is not None:
        plt = names["plt"]
        for number in plt.get_fignums():
            plt.figure(number).savefig(pictures / f"{number}.png", dpi=110)
    return printed


if __name__ == "__main__":
    sys.stdout.write(json.dumps(run(*map(Path, sys.argv[1:]))))
