"""Windows judged with one constant of the measurement changed, by a process of its own: see ``constants``.

    python -m benchmarks.changed_constant FOLDER [MODULE NAME VALUE]

Nothing of the plugin may be imported before the constant is changed: others take their values from it.
"""
from __future__ import annotations

import ast
import json
import sys
from importlib.machinery import SourceFileLoader
from pathlib import Path
from types import CodeType


def names_of(statement: ast.Assign) -> list[str]:
    """The names that are assigned together."""
    target = statement.targets[0]
    return [ast.unparse(each) for each in (target.elts if isinstance(target, ast.Tuple) else [target])]


def change(module: str, name: str, value: float) -> None:
    """Have a module that was not imported yet begin with another value of a constant."""
    get_code = SourceFileLoader.get_code

    def changed_code(self: SourceFileLoader, fullname: str) -> CodeType | None:
        if fullname != module:
            return get_code(self, fullname)
        tree = ast.parse(self.get_source(fullname) or "")
        assignments = (each for each in tree.body if isinstance(each, ast.Assign))
        statement = next(each for each in assignments if name in names_of(each))
        constant, names = ast.copy_location(ast.Constant(value), statement.value), names_of(statement)
        if len(names) > 1 and isinstance(statement.value, ast.Tuple):
            statement.value.elts[names.index(name)] = constant
        else:
            statement.value = constant
        return compile(tree, self.path, "exec")

    SourceFileLoader.get_code = changed_code  # type: ignore[method-assign, assignment]


def judged(folder: Path) -> list[list]:
    """Verdict, main cause, kept_1 and its interval, null where there is none, of all windows of a folder."""
    from osgeo import gdal
    from seam_inspector.plugin.imagery.grids import PixelWindow
    from seam_inspector.plugin.seams.measure.window.measured_window import InspectionSettings

    from .readings import inspected_files, reading_of

    gdal.UseExceptions()
    judgements = []
    for window in sorted(folder.iterdir()):
        side, margin = json.loads((window / "window.json").read_text())
        place = PixelWindow(margin, margin, side, side)
        reading = reading_of(inspected_files(window.as_posix(), place, InspectionSettings()))
        figures = (value if value == value else None for value in (reading.kept, reading.low, reading.high))
        judgements.append([reading.verdict, reading.cause, *figures])
    return judgements


if __name__ == "__main__":
    if len(sys.argv) > 2:
        change(sys.argv[2], sys.argv[3], float(sys.argv[4]))
    print(json.dumps(judged(Path(sys.argv[1]))))
