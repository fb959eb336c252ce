"""What becomes of verdicts when a constant that judges is halved or doubled: `make benchmark-constants`.

Windows are those that were held back while limits were set: of mosaics made by known operations, and compressed ones.
A constant is a number with a fraction at the top of a module that tells what is followed, what is kept and why. What
can be halved and doubled without any effect here is not tuned: it guards against what none of these windows shows.
"""
from __future__ import annotations

import argparse
import ast
import json
import os
import re
import subprocess
import sys
import tempfile
from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from itertools import islice
from pathlib import Path

import numpy as np
from osgeo import gdal

from . import compressed
from .changed_constant import names_of
from .detection import grounds
from .known_windows import KnownWindow, WindowFacts
from .operations import OPERATIONS
from .production import HALVES, Made
from .readings import write_files

MEASURE = Path(__file__).parent.parent / "plugin" / "seams" / "measure"
PACKAGE = "seam_inspector.plugin.seams.measure"
FOLDERS = ("following", "profile", "judgement")
SIDE_PX = 256
FACTORS = (0.5, 2.0)
HEAD = """# Constants that judge

Appendix to [Why contrast was lost](../method/causes.md), by `make benchmark-constants`.

{doc}

{count} windows of {side} px; *changed* are those with another verdict or another main cause, *error* is the median
error of kept_1 ({error:.3f} as it is).

| constant | value | what it is, and where it is from | halved: changed, error | doubled: changed, error |
|---|---|---|---|---|
"""


@dataclass(frozen=True)
class Constant:
    """A number at the top of a module."""

    folder: str
    module: str
    name: str
    value: float
    origin: str
    """What the code says of it."""

    @property
    def dotted(self) -> str:
        return f"{PACKAGE}.{self.folder}.{self.module}"


def constants() -> Iterator[Constant]:
    """All numbers with a fraction at the top of modules that judge."""
    for path in (path for folder in FOLDERS for path in sorted((MEASURE / folder).glob("*.py"))):
        source = path.read_text(encoding="utf-8")
        body, lines = ast.parse(source).body, source.splitlines()
        for statement, after in zip(body, [*body[1:], ast.Pass()]):
            if not isinstance(statement, ast.Assign):
                continue
            names, values = names_of(statement), statement.value
            numbers = values.elts if isinstance(values, ast.Tuple) and len(names) > 1 else [values]
            _, _, comment = lines[(statement.end_lineno or 1) - 1].partition("  # ")
            below = after.value if isinstance(after, ast.Expr) else None
            words = below.value if isinstance(below, ast.Constant) and isinstance(below.value, str) else comment
            for name, number in zip(names, numbers):
                try:
                    value = ast.literal_eval(number)
                except ValueError:
                    continue
                if isinstance(value, float):
                    yield Constant(path.parent.name, path.stem, name, value, " ".join(words.split()))


def mosaics(count: int) -> Iterator[tuple[KnownWindow, Made]]:
    """Mosaics of windows that were held back, in turn without loss and compressed."""
    data = os.environ.get("SEAM_INSPECTOR_DATA")
    imageries = [ground.imagery for ground in grounds(Path(data) if data else None, "")]
    windows = [
        [window for window in imagery.windows(SIDE_PX, count, True) if WindowFacts.of(window).has_texture]
        for imagery in imageries
    ]
    windows = [of_ground for of_ground in windows if of_ground]
    operations = [operation for operation in OPERATIONS if operation.in_half(HALVES[1])]
    stored = compressed.tasks(HALVES[1], SIDE_PX, "", 1)
    for turn in range(count):
        if turn % 2:
            case, window = next(stored)
            made = case.made(window)
            if made is not None:
                yield window, made
            continue
        of_ground = windows[turn // 2 % len(windows)]
        window, operation = of_ground[turn % len(of_ground)], operations[turn * len(operations) // count]
        if operation.fits(window):
            yield window, operation.make(window)


def judged(folder: Path, constant: Constant | None = None, factor: float = 1.0) -> list[list]:
    """What is said of all windows."""
    changed = [constant.dotted, constant.name, repr(constant.value * factor)] if constant else []
    command = [sys.executable, "-m", "benchmarks.changed_constant", str(folder), *changed]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    return json.loads(run.stdout) if run.returncode == 0 else []


def error_of(judgements: Sequence[Sequence], truth: Sequence[float]) -> float:
    """Median error of kept_1."""
    kept = np.array([np.nan if kept is None else kept for _, _, kept, _, _ in judgements], float)
    return float(np.nanmedian(np.abs(kept - np.array(truth))))


def effect(judgements: Sequence[Sequence], before: Sequence[Sequence], truth: Sequence[float]) -> str:
    """How many windows changed, and the error; nothing where nothing did."""
    if not judgements:
        return "fails"
    changed = sum(after[:2] != as_it_is[:2] for after, as_it_is in zip(judgements, before))
    error = error_of(judgements, truth)
    return f"{changed}, {error:.3f}" if changed or round(error - error_of(before, truth), 3) else "-"


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.constants", description=__doc__.split("\n")[0])
    parser.add_argument("--windows", type=int, default=60)
    parser.add_argument("--only", default="", help="constants whose module and name hold this")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--write", type=Path, help="the page")
    arguments = parser.parse_args()
    gdal.UseExceptions()
    chosen = [each for each in constants() if re.search(arguments.only, f"{each.dotted}.{each.name}")]
    with tempfile.TemporaryDirectory(prefix="seam_inspector_") as name:
        folder, truth = Path(name), []
        for number, (window, made) in enumerate(islice(mosaics(arguments.windows), arguments.windows)):
            place = folder / f"{number:03d}"
            place.mkdir()
            write_files(made, place.as_posix(), window.pixel_m)
            (place / "window.json").write_text(json.dumps([window.side, window.middle[0].start]))
            truth.append(made.truth)
        before = judged(folder)
        with ThreadPoolExecutor(arguments.jobs) as pool:
            tried = [[pool.submit(judged, folder, each, factor) for factor in FACTORS] for each in chosen]
            rows = []
            for each, futures in zip(chosen, tried):
                effects = (effect(future.result(), before, truth) for future in futures)
                rows.append(f"| `{each.module}.{each.name}` | {each.value:g} | {each.origin} | {' | '.join(effects)} |")
                print(rows[-1], flush=True)
    if arguments.write:
        head = HEAD.format(doc=__doc__.split("\n\n", 1)[1].strip(), count=len(truth), side=SIDE_PX,
                           error=error_of(before, truth))
        arguments.write.write_text(head + "\n".join(rows) + "\n", encoding="utf-8")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
