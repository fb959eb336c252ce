"""What the guide says that `make demo` prints is what it prints."""
from __future__ import annotations

import html
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

pytestmark = pytest.mark.slow

_QUOTED = re.compile(r"(?:^> .*\n)+", re.MULTILINE)
_TABLE = re.compile(r"<!-- printed by make demo -->\n\n(.*?)\n<!-- end of print -->", re.DOTALL)


@pytest.fixture(scope="module")
def demo(repository: Path, tmp_path_factory: pytest.TempPathFactory) -> tuple[str, Path]:
    """What `make demo` prints of the whole block, and the folder with its results."""
    folder = tmp_path_factory.mktemp("demo")
    command = [sys.executable, "-m", "demo.run", "--output", str(folder)]
    environment = {**os.environ, "QT_QPA_PLATFORM": "offscreen", "PYTHONPATH": str(repository / "build" / "plugins")}
    ran = subprocess.run(
        command, cwd=repository, env=environment, capture_output=True, text=True, timeout=300, check=False
    )
    assert ran.returncode == 0, ran.stderr
    return ran.stdout, folder


@pytest.mark.release
@pytest.mark.parametrize("name", ["start/own_rasters.md", "method/curves.md"])
def test_the_tables_are_those_that_are_printed(repository: Path, demo: tuple[str, Path], name: str) -> None:
    printed, _ = demo
    (shown,) = _TABLE.findall((repository / "docs" / name).read_text("utf-8"))
    lines = printed.splitlines()
    assert [line for line in shown.splitlines() if not any(_is_same(line[4:], other) for other in lines)] == []


_NUMBER = re.compile(r"\d+(?:\.\d+)?")


def _is_same(line: str, other: str) -> bool:
    """Whether lines have the same words, and numbers that differ by the last digits at most: processors round grey
    values otherwise, of which the block is drawn."""
    numbers, others = _NUMBER.findall(line), _NUMBER.findall(other)
    if _NUMBER.sub("", line).split() != _NUMBER.sub("", other).split() or len(numbers) != len(others):
        return False
    return all(abs(float(a) - float(b)) <= 2.5 * 10.0 ** -len(a.partition(".")[2]) for a, b in zip(numbers, others))


@pytest.mark.release
def test_the_first_window_of_the_readme_is_that_of_the_report(repository: Path, demo: tuple[str, Path]) -> None:
    printed, folder = demo
    readme = (repository / "README.md").read_text("utf-8")
    (quoted,) = _QUOTED.findall(readme)
    sentence = " ".join(quoted.replace("> ", "").split())
    page = " ".join(html.unescape((folder / "report.html").read_text("utf-8")).split())
    sentence, page = (re.sub(r"(?<=\d),(?=\d{3}\b)", "", text) for text in (sentence, page))  # by the region
    like = _NUMBER.pattern.join(map(re.escape, _NUMBER.split(sentence)))
    assert any(_is_same(sentence, result) for result in re.findall(like, page)), like
    assert ("Six windows" in readme) == ("6 windows placed" in printed)
