"""The plugin's zip and the workers' wheel: the last commit and nothing else, the same bytes wherever they are made, and
nothing that the plugin repository refuses."""
from __future__ import annotations

import json
import os
import re
import subprocess
import sys
import sysconfig
import venv
import zipfile
from importlib.util import find_spec
from pathlib import Path

import pytest
from seam_inspector.plugin.toolkit.executors import measuring_modules

from tests.made_once import the_first_block
from tests.releases import built, cloned, run_tool
from tools import python_pages
from tools.check_package import check_package

pytestmark = pytest.mark.release

ELSEWHERE = {"TZ": "Pacific/Auckland", "LC_ALL": "pl_PL.UTF-8", "LANG": "pl_PL.UTF-8", "QT_HASH_SEED": "7"}
CHECKED = pytest.mark.skipif(
    not all(map(find_spec, ("bandit", "detect_secrets", "flake8"))),
    reason="bandit, detect-secrets or flake8 is missing",
)
NUMBER = re.compile(r"[0-9]+(?:[.][0-9]+)?")
TRANSLATION = "i18n/seam_inspector_pl.qm"


@pytest.fixture(scope="module")
def clone(repository: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    return cloned(repository, tmp_path_factory.mktemp("clone") / "seam-inspector")


@pytest.fixture(scope="module")
def package(clone: Path) -> Path:
    return built(clone, "make_package")


@pytest.fixture(scope="module")
def wheel(clone: Path) -> Path:
    return built(clone, "make_wheel")


def git(clone: Path, *arguments: str) -> str:
    return subprocess.run(["git", *arguments], cwd=clone, capture_output=True, text=True, check=True).stdout


def test_another_machine_at_another_time_makes_the_same_bytes(
    package: Path, wheel: Path, repository: Path, tmp_path: Path
) -> None:
    other = cloned(repository, tmp_path / "a clone with spaces")
    for setting in ("core.autocrlf=true", "core.eol=crlf", "tar.umask=0077"):
        git(other, "config", *setting.split("="))
    for path in [other, *other.rglob("*")]:
        os.utime(path, (1_000_000_000, 1_000_000_000))
    for tool, expected in (("make_package", package), ("make_wheel", wheel)):
        made = built(other, tool, environment=ELSEWHERE, umask=0o077)
        assert made.name == expected.name
        assert made.read_bytes() == expected.read_bytes()


def test_it_holds_what_is_committed_and_the_compiled_translations(clone: Path, package: Path) -> None:
    """All that git lists, but what .gitattributes keeps out."""
    names = git(clone, "ls-files").splitlines()
    attributes = git(clone, "check-attr", "export-ignore", "--", *names).splitlines()
    folders = [line.removesuffix(" export-ignore")[1:] for line in (clone / ".gitattributes").read_text().splitlines()]
    ignored = {line.split(": ")[0] for line in attributes if line.endswith(": set")}
    wanted = {name for name in names if name not in ignored and name.split("/")[0] not in folders}
    with zipfile.ZipFile(package) as archive:
        assert set(archive.namelist()) == {f"seam_inspector/{name}" for name in wanted | {TRANSLATION, "COMMIT"}}
        assert archive.read("seam_inspector/COMMIT").decode().strip() == git(clone, "rev-parse", "HEAD").strip()
        assert archive.testzip() is None
        assert {member.external_attr >> 16 for member in archive.infolist()} == {0o100644}
        for name in wanted:
            assert archive.read(f"seam_inspector/{name}") == (clone / name).read_bytes()
        assert len(archive.read(f"seam_inspector/{TRANSLATION}")) > 100_000
    assert {name.split("/")[0] for name in wanted} >= {"__init__.py", "LICENSE", "metadata.txt", "plugin", "resources"}
    assert not {"tests", "docs", "demo", "tools", "Makefile"} & {name.split("/")[0] for name in wanted}


def test_the_wheel_holds_what_a_cluster_is_given_and_its_types(clone: Path, wheel: Path) -> None:
    given = {path.relative_to(clone).as_posix() for path in measuring_modules(clone / "plugin")}
    given |= {path.relative_to(clone).as_posix() for path in (clone / "python").glob("*.py")}
    given |= {f"plugin/toolkit/{name}.py" for name in ("executors", "messages")}
    given |= {"__init__.py", "__init__.pyi", "py.typed", "metadata.txt", "plugin/__init__.py"}
    with zipfile.ZipFile(wheel) as held:
        names = {name for name in held.namelist() if ".dist-info/" not in name}
        assert names == {f"seam_inspector/{name}" for name in given}
        metadata = held.read(next(name for name in held.namelist() if name.endswith("/METADATA"))).decode()
        commands = held.read(next(name for name in held.namelist() if name.endswith("/entry_points.txt"))).decode()
    assert "seam-inspector = seam_inspector.python.start:main" in commands
    for needed in ("numpy", "scipy", "PyWavelets"):
        assert re.search(f"^Requires-Dist: {needed}", metadata, re.MULTILINE | re.IGNORECASE)
    assert "plugin/seams/measure/window/inspection.py" in given


def test_the_guides_notebook_runs_with_the_wheel_alone(
    wheel: Path, repository: Path, tmp_path: Path, tmp_path_factory: pytest.TempPathFactory
) -> None:
    """In an environment that sees the system's GDAL and numpy, and pandas where this one has it; QGIS can't be
    imported there. What the guide says that it prints is what it prints."""
    pytest.importorskip("pandas")
    venv.create(tmp_path / "venv", system_site_packages=True)
    python = tmp_path / "venv" / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
    environment = {name: value for name, value in os.environ.items() if not name.startswith("PYTHON")}
    ask = [python, "-c", "import sysconfig; print(sysconfig.get_path('purelib'))"]
    packages = Path(subprocess.run(ask, env=environment, capture_output=True, text=True, check=True).stdout.strip())
    pip = [sys.executable, "-m", "pip", "install", "--quiet", "--no-index", "--no-deps", "--target", packages, wheel]
    subprocess.run(pip, env=environment, check=True)
    (packages / "pandas.pth").write_text(sysconfig.get_path("purelib"), encoding="utf-8")
    (tmp_path / "block").symlink_to(the_first_block(tmp_path_factory).mosaic.parent)
    run = subprocess.run(
        [python, repository / "tests" / "notebook_cells.py", python_pages.NOTEBOOK], cwd=tmp_path,
        env={**environment, "MPLBACKEND": "agg"}, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert run.returncode == 0, run.stderr
    made = json.loads(run.stdout)
    assert len(made) == len(python_pages.printed())
    for output, expected in zip(made, python_pages.printed()):
        assert NUMBER.sub("", output).split() == NUMBER.sub("", expected).split()
        assert numbers(output) == pytest.approx(numbers(expected), rel=0.05, abs=0.03)


def numbers(text: str) -> list[float]:
    return [float(number) for number in NUMBER.findall(text)]


def test_what_is_not_committed_is_refused_and_never_inside(clone: Path, package: Path, tmp_path: Path) -> None:
    other = cloned(clone, tmp_path / "clone")
    for name in ("metadata.txt", "i18n/seam_inspector_pl.ts"):
        (other / name).write_text("other", encoding="utf-8")
    (other / "plugin" / "new.py").write_text("", encoding="utf-8")
    for tool in ("make_package", "make_wheel"):
        run = run_tool(other, tool)
        assert run.returncode == 1
        assert "Commit these first" in run.stderr
        assert "metadata.txt" in run.stderr
        assert "plugin/new.py" in run.stderr
        assert "Traceback" not in run.stderr
    assert not list(other.glob("build/*"))
    code = "import pathlib, tools.make_package as tool; print(tool.make_package(pathlib.Path('build')))"
    made = subprocess.run(["python3", "-c", code], cwd=other, capture_output=True, text=True, check=True).stdout
    assert (other / made.strip()).read_bytes() == package.read_bytes()


@CHECKED
def test_the_plugin_repository_has_nothing_against_it(package: Path) -> None:
    """What bandit tells and the repository takes is for reading; placeholders are for the publisher."""
    problems = check_package(package)
    assert [problem for problem in problems if problem.is_error] == []
    rules = {problem.rule.partition(":")[0].split()[0] for problem in problems}
    assert rules <= {"bandit", "metadata.txt"}, problems
    assert all("placeholder" in problem.rule for problem in problems if problem.rule.startswith("metadata.txt"))


@CHECKED
def test_a_bad_package_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "bad.zip"
    with zipfile.ZipFile(path, "w") as bad:
        bad.writestr("my-plugin/metadata.txt", "[general]\nname=a\nauthor=a/b\ntracker=nowhere\nicon=i.png\n")
        bad.writestr("my-plugin/__init__.py", "import pickle\nx = pickle.loads(b'')\nprint(undefined)\nassert x\n")
        bad.writestr("my-plugin/broken.py", "def (:\n")
        bad.writestr("my-plugin/key.txt", "aws_key = 'AKIA" + "QYLPMN5HHHFPZAM2'\n")
        bad.writestr("my-plugin/__pycache__/a.pyc", b"")
        bad.writestr("my-plugin/tests/test_a.py", "")
        bad.writestr("my-plugin/.hidden", "")
        bad.writestr("my-plugin/run.sh", "")
        bad.writestr("../outside.txt", "")
    run = run_tool(Path(__file__).parents[2], "check_package", str(path))
    assert run.returncode == 1
    for said in (
        "ERROR    more than one folder", "ERROR    the folder at the top can't be imported: my-plugin",
        "ERROR    LICENSE is missing", "ERROR    metadata.txt lacks a field: homepage",
        "ERROR    metadata.txt: not an address: tracker", "ERROR    metadata.txt: a slash in the author's name",
        "ERROR    a file that is never wanted", "ERROR    a program: my-plugin/run.sh", "ERROR    bandit B301",
        "ERROR    detect-secrets: AWS Access Key: my-plugin/key.txt:1", "ERROR    flake8 F821", "ERROR    flake8 E9",
        "ERROR    a path that leads out of the folder: ../outside.txt", "warning  a hidden file: my-plugin/.hidden",
        "warning  a test: my-plugin/tests/test_a.py", "warning  bandit B101", "warning  metadata.txt: the icon",
    ):  # fmt: skip
        assert said in run.stdout, run.stdout + run.stderr


@pytest.mark.parametrize("name", ["nothing.zip", "empty.zip", "text.zip"])
def test_what_is_no_package_is_told_in_a_sentence(tmp_path: Path, name: str) -> None:
    (tmp_path / "text.zip").write_text("text")
    zipfile.ZipFile(tmp_path / "empty.zip", "w").close()
    run = run_tool(Path(__file__).parents[2], "check_package", str(tmp_path / name))
    assert run.returncode == 1
    assert len(run.stderr.splitlines()) == 1, run.stderr
