"""The guide in docs: it builds without a warning, and no link, anchor or picture leads nowhere."""
from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

OUTSIDE = sorted(path.name for path in Path(__file__).parents[2].glob("*.md"))  # Sphinx sees docs alone
LINK = re.compile(r"\]\((?![a-z]+:)([^)#\s]*)(?:#([^)\s]+))?\)")
HEADING = re.compile(r"^#+ (.+)$", re.MULTILINE)


def anchors(page: Path) -> set[str]:
    """Anchors as GitHub makes them of headings."""
    titles = (re.sub(r"[^\w\s-]", "", title).strip().lower() for title in HEADING.findall(page.read_text("utf-8")))
    return {title.replace(" ", "-") for title in titles}


@pytest.mark.slow
def test_the_guide_builds_without_a_warning(repository: Path, tmp_path: Path) -> None:
    """Sphinx follows every link, anchor and picture of its pages, and wants each page in the tree."""
    command = [sys.executable, "-m", "sphinx", "-W", "--keep-going", "-q", "-b", "dummy", "docs", str(tmp_path)]
    built = subprocess.run(command, cwd=repository, capture_output=True, text=True, timeout=120)
    assert (built.returncode, built.stderr) == (0, "")


@pytest.mark.parametrize("name", OUTSIDE)
def test_links_into_the_guide_lead_somewhere(repository: Path, name: str) -> None:
    lost = []
    for target, anchor in LINK.findall((repository / name).read_text("utf-8")):
        page = repository / (target or name)
        if not page.exists() or (anchor and anchor not in anchors(page)):
            lost.append((target, anchor))
    assert lost == []


def test_every_picture_is_shown(repository: Path) -> None:
    pages = [*(repository / "docs").rglob("*.md"), repository / "README.md"]
    shown = {Path(target).name for page in pages for target, _ in LINK.findall(page.read_text("utf-8"))}
    pictures = {path.name for path in (repository / "docs" / "pictures").iterdir()}
    assert pictures - shown == set()


@pytest.mark.parametrize(
    ("section", "figure", "page"),
    [
        ("What it costs", r"\d+ s\b", "docs/reference/speed.md"),
        ("How good it is", r"\d\.\d+|(?<=None of )\d+", "docs/appendix/detection.md"),
    ],
)
def test_the_readmes_figures_are_those_of_the_page_that_it_names(
    repository: Path, section: str, figure: str, page: str
) -> None:
    readme = (repository / "README.md").read_text("utf-8")
    said = re.findall(figure, readme.partition(f"## {section}")[2].partition("\n## ")[0])
    assert len(said) > 1
    page_text = (repository / page).read_text("utf-8")
    assert [figure for figure in said if not re.search(rf"(?<![\d.]){re.escape(figure)}(?![\d.]\d)", page_text)] == []
