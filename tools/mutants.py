"""Changes random operators, comparisons and constants of the measuring code, one at a time: do the tests see it?

    python -m tools.mutants [--count 40] [--seed 1]

Each change is made in a copy of the checkout, so the files here are never touched. The tests nearest to the changed
file run first, then those of its subject; what no test sees has survived, and is worth a test.
"""
from __future__ import annotations

import argparse
import ast
import os
import random
import re
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from textwrap import shorten
from typing import NamedTuple

CHECKOUT = Path(__file__).parents[1]
LEAST_LIMIT_S = 120.0
"""For the tests of one change; more where they take long unchanged."""
_NOT_RUN = {"annotation", "returns", "decorator_list"}
_COMPARISONS: dict[type, type] = {
    ast.Lt: ast.LtE, ast.LtE: ast.Lt, ast.Gt: ast.GtE, ast.GtE: ast.Gt, ast.Eq: ast.NotEq, ast.NotEq: ast.Eq,
    ast.Is: ast.IsNot, ast.IsNot: ast.Is, ast.In: ast.NotIn, ast.NotIn: ast.In,
}  # fmt: skip
_OPERATORS: dict[type, type] = {
    ast.Add: ast.Sub, ast.Sub: ast.Add, ast.Mult: ast.Div, ast.Div: ast.Mult, ast.FloorDiv: ast.Div,
    ast.Mod: ast.Mult, ast.Pow: ast.Mult, ast.BitAnd: ast.BitOr, ast.BitOr: ast.BitAnd,
    ast.And: ast.Or, ast.Or: ast.And, ast.USub: ast.UAdd, ast.Invert: ast.UAdd,
}  # fmt: skip


class Mutant(NamedTuple):
    """One change of one file, and the whole file with it."""

    path: Path
    """In the checkout."""
    line: int
    words: str
    source: str


def parts(node: ast.AST) -> Iterator[ast.AST]:
    """All that runs within a node, in the order of the file; the same each time."""
    for name, value in ast.iter_fields(node):
        for part in value if isinstance(value, list) else [value]:
            if isinstance(part, ast.AST) and name not in _NOT_RUN:
                yield part
                yield from parts(part)


def change(node: ast.AST) -> bool:
    """Change a node itself; False when there is nothing in it to change."""
    if isinstance(node, ast.Compare):
        node.ops[0] = _COMPARISONS[type(node.ops[0])]()
    elif isinstance(node, (ast.BinOp, ast.BoolOp, ast.UnaryOp, ast.AugAssign)) and type(node.op) in _OPERATORS:
        node.op = _OPERATORS[type(node.op)]()
    elif isinstance(node, ast.Constant) and isinstance(node.value, (bool, int, float)):
        node.value = not node.value if isinstance(node.value, bool) else node.value + 1
    else:
        return False
    return True


def mutant(path: Path, source: str, place: int) -> Mutant | None:
    """A file with its so manieth part changed."""
    tree = ast.parse(source)
    node = list(parts(tree))[place]
    before = ast.unparse(node)
    if not change(node):
        return None
    return Mutant(path, getattr(node, "lineno", 0), f"{before} -> {ast.unparse(node)}", ast.unparse(tree))


def drawn(count: int, seed: int) -> list[Mutant]:
    """So many different changes of the files that measure, the same for the same seed."""
    sources = {path: path.read_text(encoding="utf-8") for path in sorted(CHECKOUT.glob("plugin/*/measure/**/*.py"))}
    places = [(path, place) for path, text in sources.items() for place, _ in enumerate(parts(ast.parse(text)))]
    random.Random(seed).shuffle(places)
    made = (mutant(path, sources[path], place) for path, place in places)
    return [one for one, _ in zip(filter(None, made), range(count))]


def imported(test: Path) -> set[str]:
    """Full names of all that a test imports, and of where it imports it from."""
    names = set()
    for node in ast.walk(ast.parse(test.read_text(encoding="utf-8"))):
        if isinstance(node, ast.ImportFrom) and node.module:
            names |= {node.module, *(f"{node.module}.{alias.name}" for alias in node.names)}
    return names


def suites(path: Path) -> list[list[str]]:
    """What to run for a changed file: the tests of its name or that import it, then all of its subject."""
    inside = path.relative_to(CHECKOUT).with_suffix("")
    module, folder = ".".join(("seam_inspector", *inside.parts)), CHECKOUT / "tests" / "numbers"
    near = [test for test in sorted(folder.rglob("test_*.py"))
            if test.stem == f"test_{path.stem}" or module in imported(test)]  # fmt: skip
    both = near, [folder / inside.parts[1]]
    return [[str(test.relative_to(CHECKOUT)) for test in tests] for tests in both if tests]


def copy_checkout(folder: Path) -> None:
    """All files of the checkout that git lists or would, and the package under its name."""
    command = ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"]
    listed = subprocess.run(command, cwd=CHECKOUT, capture_output=True, text=True, check=True).stdout
    for name in filter(None, listed.split("\0")):
        if (CHECKOUT / name).is_file():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(CHECKOUT / name, folder / name)
    (folder / "build" / "plugins").mkdir(parents=True)
    (folder / "build" / "plugins" / "seam_inspector").symlink_to("../..", target_is_directory=True)


def failure(folder: Path, tests: list[str], limit_s: float) -> str:
    """The first of these tests that fails in a copy of the checkout; empty when all pass."""
    command = [sys.executable, "-m", "pytest", "-p", "no:pytest_qgis", "-p", "no:cacheprovider", "--quick", "-qx"]
    environment = {**os.environ, "PYTHONPATH": str(folder / "build" / "plugins")}
    try:
        run = subprocess.run([*command, "--tb=no", *tests], cwd=folder, env=environment, capture_output=True, text=True,
                             timeout=limit_s)  # fmt: skip
    except subprocess.TimeoutExpired:
        return f"{' '.join(tests)}: out of time"
    found = re.search(r"^(?:FAILED|ERROR) (\S+)", run.stdout, re.MULTILINE)
    return found[1] if found else "" if run.returncode in (0, 5) else run.stdout + run.stderr  # 5: all are slow


def killer(one: Mutant, limit_s: float) -> str:
    """The test that sees a change; empty when none does."""
    with tempfile.TemporaryDirectory() as folder:
        copy_checkout(Path(folder))
        (Path(folder) / one.path.relative_to(CHECKOUT)).write_text(one.source, encoding="utf-8")
        return next(filter(None, (failure(Path(folder), tests, limit_s) for tests in suites(one.path))), "")


def limit(mutants: list[Mutant]) -> float:
    """How long the tests of a change may take. Ends the program when they fail without one."""
    tests = sorted({suites(mutant.path)[-1][0] for mutant in mutants})
    started = time.monotonic()
    with tempfile.TemporaryDirectory() as folder:
        copy_checkout(Path(folder))
        failed = failure(Path(folder), tests, 3600)
    if failed:
        sys.exit(f"The tests fail without a change: {failed}")
    return max(LEAST_LIMIT_S, 3 * (time.monotonic() - started))


def main() -> None:
    """Command line."""
    parser = argparse.ArgumentParser(description="Change the measuring code at random: do the tests see it?")
    parser.add_argument("--count", type=int, default=40, help="how many changes")
    parser.add_argument("--seed", type=int, default=1, help="another one draws others")
    options = parser.parse_args()
    mutants = drawn(options.count, options.seed)
    limit_s, survived = limit(mutants), 0
    executor = ThreadPoolExecutor(os.cpu_count())
    try:
        for one, seen in zip(mutants, executor.map(lambda one: killer(one, limit_s), mutants)):
            survived += not seen
            place, words = f"{one.path.relative_to(CHECKOUT)}:{one.line}", shorten(one.words, 60)
            print(f"{place:<65}{words:<62}{'killed by ' + seen if seen else 'SURVIVED'}", flush=True)
    finally:
        executor.shutdown(cancel_futures=True)
    print(f"{survived} of {len(mutants)} survived")


if __name__ == "__main__":
    main()
