"""What the pages about Python show runs as it stands: recipes, the shell, and the exit codes of the command."""
from __future__ import annotations

import os
import re
import shlex
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

import pytest
import seam_inspector

from tests.made_once import the_small_block
from tools import python_pages

pytestmark = pytest.mark.slow

OPTIONAL = ("geopandas", "shapely", "xarray", "distributed")
RECIPES = python_pages.blocks(python_pages.RECIPES)
MISSING = [name for name in OPTIONAL if not find_spec(name)]
STRICT = python_pages.REPOSITORY / "resources" / "rules" / "acceptance" / "strict.json"
COMMAND = 'import sys; from seam_inspector.python.start import main; sys.exit(main())'
FORGED = "UPDATE seams SET kept_1 = 0.95, kept_low = 0.9, kept_high = 1, state = 'passed', verdict = 'preserved'"


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the small block, as the pages have it."""
    made = tmp_path_factory.mktemp("reader")
    (made / "block").symlink_to(the_small_block(tmp_path_factory).mosaic.parent)
    return made


@pytest.fixture(scope="module")
def shell(folder: Path, tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    """An environment with the command that the wheel installs."""
    place = tmp_path_factory.mktemp("bin")
    command = place / "seam-inspector"
    command.write_text(f'#!/bin/sh\nexec {sys.executable} -c "{COMMAND}" "$@"\n', encoding="utf-8")
    command.chmod(0o755)
    home = str(Path(seam_inspector.__file__).parent.parent)
    return {**os.environ, "PATH": f"{place}{os.pathsep}{os.environ['PATH']}", "PYTHONPATH": home}


def ran(
    command: list[str | Path], folder: Path, shell: dict[str, str], timeout: float | None = None
) -> subprocess.CompletedProcess[str]:
    return subprocess.run(command, cwd=folder, env=shell, capture_output=True, text=True, timeout=timeout, check=False)


def is_script(code: str) -> bool:
    return "__main__" in code or "distributed" in code


def can_run(code: str) -> bool:
    return not any(re.search(rf"^(import|from) {name}\b", code, re.MULTILINE) for name in MISSING)


def test_the_recipes_run_one_after_the_other(folder: Path, shell: dict[str, str]) -> None:
    pytest.importorskip("pandas")
    codes = [code for _, code in RECIPES if not is_script(code) and can_run(code)]
    program = "\n".join(["import sys", *(f"sys.modules[{name!r}] = None" for name in ("qgis", "PyQt5")), *codes])
    run = ran([sys.executable, "-c", program], folder, shell)
    assert run.returncode == 0, run.stderr
    assert "Traceback" not in run.stderr
    assert "False" not in run.stdout


@pytest.mark.parametrize("code", [code for _, code in RECIPES if is_script(code)], ids=["spawn", "dask"])
def test_a_script_of_the_recipes_runs(folder: Path, shell: dict[str, str], tmp_path: Path, code: str) -> None:
    if not can_run(code):
        pytest.skip("Dask is not installed")
    script = tmp_path / "script.py"
    script.write_text(code, encoding="utf-8")
    run = ran([sys.executable, script], folder, shell, timeout=120)
    assert run.returncode == 0, run.stderr
    assert re.fullmatch(r"\d+ m of seam\n", run.stdout)


def test_a_script_that_its_processes_start_anew_is_told_what_it_lacks(
    folder: Path, shell: dict[str, str], tmp_path: Path
) -> None:
    script = tmp_path / "script.py"
    code = next(code for _, code in RECIPES if "spawn" in code)
    script.write_text(code.replace('if __name__ == "__main__":\n    main()', "main()"), encoding="utf-8")
    run = ran([sys.executable, script], folder, shell, timeout=120)
    assert "needs the line if __name__ == '__main__': above its work" in run.stderr.splitlines()[-1]


@pytest.mark.parametrize(("heading", "code"), python_pages.blocks(python_pages.COMMANDS, "shell"))
def test_the_shell_of_the_page_runs(folder: Path, shell: dict[str, str], heading: str, code: str) -> None:
    run = ran(["sh", "-c", code], folder, shell)
    assert run.returncode == 0, run.stderr
    assert "Traceback" not in run.stderr


def test_a_table_or_page_of_something_else_stays(folder: Path, shell: dict[str, str], tmp_path: Path) -> None:
    sources, mosaic = sorted(map(str, folder.glob("block/strip*.tif"))), str(folder / "block" / "mosaic.tif")
    notes, page, table = tmp_path / "notes.csv", tmp_path / "page.html", tmp_path / "windows.csv"
    notes.write_text("my,notes\n", encoding="utf-8")
    page.write_text("<p>mine</p>", encoding="utf-8")
    command = ["seam-inspector", "inspect", mosaic, *sources, "--at", "0", "0", "-o"]
    codes = [ran([*command, path], folder, shell).returncode for path in (notes, tmp_path / "w.xlsx", table, table)]
    assert codes == [3, 3, 2, 2]  # the place lies outside, which is told in the table
    scan = ["seam-inspector", "scan", mosaic, *sources, "-o", f"{tmp_path}/seams.gpkg", "--report", page]
    assert ran(scan, folder, shell).returncode == 3
    assert (notes.read_text("utf-8"), page.read_text("utf-8")) == ("my,notes\n", "<p>mine</p>")


@pytest.mark.parametrize(("code", "ends"), [
    (COMMAND, (3, "seam-inspector: osgeo is missing")),
    ("from seam_inspector import open_block", (1, "ImportError: GDAL's Python bindings are missing")),
])  # fmt: skip
def test_where_gdal_is_missing_a_sentence_says_so(shell: dict[str, str], code: str, ends: tuple[int, str]) -> None:
    run = ran([sys.executable, "-c", f"import sys; sys.modules['osgeo'] = None; {code}"], Path(), shell)
    assert (run.returncode, run.stderr.splitlines()[-1][: len(ends[1])]) == ends


def test_a_reader_who_goes_away_changes_no_decision(folder: Path, shell: dict[str, str], tmp_path: Path) -> None:
    """The reader goes away as `head` does. Every command takes longer to start than `true` to end."""
    sources = sorted(map(str, folder.glob("block/strip*.tif")))
    command = shlex.join(["seam-inspector", "scan", str(folder / "block" / "mosaic.tif"), *sources, "-o", "seams.gpkg"])
    for pipe in ("| true", "2>&1 | true"):
        script = f"{{ {command}; echo $? > code; }} {pipe}"
        run = ran(["sh", "-c", script], tmp_path, shell)
        assert ((tmp_path / "code").read_text(), run.stderr.count("Error")) == ("1\n", 0)


def test_exit_codes_say_what_was_decided(folder: Path, shell: dict[str, str], tmp_path: Path) -> None:
    from osgeo import gdal

    sources = sorted(map(str, folder.glob("block/strip*.tif")))
    mosaic, seams, report = str(folder / "block" / "mosaic.tif"), str(tmp_path / "seams.gpkg"), tmp_path / "report.html"

    def code(*arguments: str) -> int:
        run = ran(["seam-inspector", *arguments], tmp_path, shell)
        assert "Traceback" not in run.stderr
        return run.returncode

    assert code("scan", mosaic, *sources, "-o", seams, "--report", str(report)) == 1
    assert report.read_text("utf-8").startswith("<!DOCTYPE html>")
    assert code("accept", seams, "--mosaic", mosaic, "--max-share", "1", "--max-run", "500") == 0
    assert code("accept", seams, "--mosaic", sources[0], "--max-share", "1", "--max-run", "500") == 2
    changed = gdal.OpenEx(seams, gdal.OF_UPDATE)
    changed.ExecuteSQL(FORGED)
    del changed
    assert code("accept", seams) == 2
    assert code("accept", seams, "--rules", str(STRICT)) == 2
    assert code("inspect", mosaic, *sources, "--at", "-5", "-6.5e3") == 2
    gdal.Translate(f"{tmp_path}/sheet.tif", mosaic, srcWin=[0, 0, 64, 64])
    assert code("scan", f"{tmp_path}/sheet.tif", *sources, "-o", f"{tmp_path}/sheet.gpkg") == 2
    assert code("accept", f"{tmp_path}/sheet.gpkg") == 2
    for wrong in (
        ["scan", mosaic, *sources, "-o", mosaic], ["scan", str(tmp_path / "none.tif"), "-o", seams], ["accept", mosaic],
        ["scan", mosaic, *sources, "-o", seams, "--piece", "0"], [], ["accept", seams, "--min-kept", "7"],
        ["accept", seams, "--rules", str(STRICT), "--min-kept", "0.95"],
        ["accept", seams, "--max-share", "much"], ["accept", seams, "--report", ""],
        ["scan", mosaic, *sources, "-o", str(tmp_path)], ["scan", mosaic, "-o", f"{tmp_path}/a.gpkg", "--loss", mosaic],
        ["scan", mosaic, "-o", f"{tmp_path}/a.gpkg", "--report", f"{tmp_path}/none/report.html"],
        ["mend", mosaic, *sources, "--seams", seams, "-o", ""],
    ):  # fmt: skip
        assert code(*wrong) == 3
    assert not (tmp_path / "a.gpkg").exists()
    assert code("mend", mosaic, "--seams", seams, "-o", f"{tmp_path}/mended.vrt", "--which", "all") == 1
