"""The pages of the algorithms, and the help that is made of them: as the dialogs say, and there without internet."""
from __future__ import annotations

import importlib.util
import re
from pathlib import Path
from types import ModuleType
from urllib.parse import unquote, urlsplit
from urllib.request import url2pathname

import pytest
from qgis.core import QgsProcessingAlgorithm, QgsProcessingProvider

from tests.qgis.guide.page_examples import NAMES, page
from tests.qgis.runs import algorithm

TITLE = re.compile(r"<title>(.+)</title>")
LINK = re.compile(r'<a href="([^"]+)"')
LINKED = re.compile(r"^\| `(\w+)\.([\w:]+)` \| `(\w+)\.(\w+)` \|", re.MULTILINE)
SECTIONS = [
    "When to use it", "Parameters", "Outputs", "Reading the results", "What it refuses",
    "Examples", "Toolbox", "Modeler", "Command line", "Python",
]  # fmt: skip
RENEW = "run `make help-pages` and commit what it changes"
TAKEN = {
    "source": {"outputVector"},
    "multilayer": {"outputVector", "outputRaster"},
    "raster": {"outputRaster"},
    "file": {"outputFile"},
    "number": {"outputNumber"},
}
"""Outputs that the modeler offers for an input, by their types."""


def tool(repository: Path, name: str) -> ModuleType:
    """A script of tools, which is no package."""
    spec = importlib.util.spec_from_file_location(name, repository / "tools" / f"{name}.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def help_file(algorithm: QgsProcessingAlgorithm) -> Path:
    address = urlsplit(algorithm.helpUrl())
    assert address.scheme == "file"
    return Path(url2pathname(unquote(address.path)))


def test_the_help_button_opens_the_page_of_its_algorithm(provider: QgsProcessingProvider) -> None:
    for job in provider.algorithms():
        for made in (job, job.create()):
            page = help_file(made).read_text("utf-8")
            match = TITLE.search(page)
            assert match is not None
            assert match[1] == job.displayName()


def test_the_tables_of_the_pages_are_those_of_the_dialogs(repository: Path, provider: QgsProcessingProvider) -> None:
    """`make help-pages` renews them."""
    tables = tool(repository, "algorithm_tables")
    for job in provider.algorithms():
        page = (tables.PAGES / f"{job.name()}.md").read_text("utf-8")
        assert page == tables.with_tables(page, job.create()), f"{job.name()}: {RENEW}"


def test_the_table_of_keys_is_that_of_the_desk(repository: Path) -> None:
    keys = tool(repository, "keys_table")
    page = keys.PAGE.read_text("utf-8")
    assert page == keys.with_keys(page), RENEW


def test_the_help_is_that_of_the_guide(repository: Path) -> None:
    """`make help-pages` renews it."""
    help_pages = tool(repository, "help_pages")
    pages = help_pages.sources()
    names = [*(f"{name}.html" for name in pages), "help.css"]
    assert sorted(path.name for path in help_pages.HELP.iterdir()) == sorted(names)
    for name in pages:
        values = (help_pages.HELP / f"{name}.html").read_text("utf-8")
        assert values == help_pages.rendered(name, pages), f"{name}: {RENEW}"


def test_links_of_the_help_lead_to_its_pages_or_to_the_homepage(repository: Path) -> None:
    help_pages = tool(repository, "help_pages")
    homepage = help_pages.metadata()["homepage"]
    for path in sorted(help_pages.HELP.glob("*.html")):
        page = path.read_text("utf-8")
        assert "<script" not in page
        assert "<img" not in page
        for link in LINK.findall(page):
            near, _, anchor = link.partition("#")
            if link.startswith(homepage):
                inside = near[len(homepage) :].strip("/")
                assert not inside or (repository / "docs" / inside).with_suffix(".md").is_file(), link
            elif "://" not in link:
                target = (path.parent / near if near else path).read_text("utf-8")
                assert not anchor or f'id="{anchor}"' in target, (path.name, link)


@pytest.mark.parametrize("name", NAMES)
def test_every_page_has_its_sections(name: str) -> None:
    assert re.findall(r"^##+ (.+)$", page(name), re.MULTILINE) == SECTIONS


@pytest.mark.usefixtures("provider")
@pytest.mark.parametrize("name", NAMES)
def test_what_the_modeler_joins_fits(name: str) -> None:
    """Outputs and inputs of the page's table are there, and of kinds that the modeler joins."""
    for giver, output, taker, wanted in LINKED.findall(page(name)):
        assert name in (giver, taker)
        first, second = algorithm(giver), algorithm(taker)  # held: definitions go with their algorithms
        made, asked = first.outputDefinition(output), second.parameterDefinition(wanted)
        assert made is not None, (giver, output)
        assert asked is not None, (taker, wanted)
        assert made.type() in TAKEN[asked.type()], (giver, output, taker, wanted)
    joined = page(name).split("### Modeler\n\n")[1].split("###")[0]
    assert joined.strip()
