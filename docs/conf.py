"""How Sphinx makes the guide: plain Markdown in, build/guide/index.html out (`make guide`).

They are read on GitHub as well, so they hold no directive but what Markdown knows. What Sphinx wants besides,
the tree of pages, comes from the lists and tables of `index.md`: a page that is linked there is a page of the guide.
"""
from __future__ import annotations

import configparser
import re
from pathlib import Path

from sphinx.application import Sphinx

HERE = Path(__file__).parent
_HEADING = re.compile(r"^## (.+)$")
_ENTRY = re.compile(r"^(?:- |[0-9]+\. |\| )\[[^]]+\]\((?![a-z]+:|\.\.)([\w/]+)\.md\)")  # it begins with a link


def _metadata() -> configparser.SectionProxy:
    parser = configparser.ConfigParser(interpolation=None)
    parser.read(HERE.parent / "metadata.txt", encoding="utf-8")
    return parser["general"]


project = _metadata()["name"]
author = _metadata()["author"]
version = release = _metadata()["version"]
html_title = f"{project} {version}"
html_short_title = project
html_theme = "furo"
html_favicon = "../resources/icons/seam_inspector.svg"
html_logo = "../resources/icons/seam_inspector.svg"
html_static_path = ["static"]
html_css_files = ["guide.css"]
html_js_files = ["guide.js"]
html_show_sphinx = False
html_copy_source = False
html_show_copyright = False

extensions = ["myst_parser"]
exclude_patterns = ["static"]
highlight_language = "none"  # formulas and commands stand in indented blocks
myst_heading_anchors = 4  # the anchors that GitHub makes
myst_enable_extensions = ["strikethrough"]
nitpicky = True

linkcheck_anchors = False
linkcheck_allowed_redirects = {r"https://doi\.org/.*": r"https://.*"}  # that is what these are for
linkcheck_allow_unauthorized = True  # publishers that want a browser
linkcheck_timeout = 20
linkcheck_ignore = [r"https://example\.org/"]  # placeholders of metadata.txt, until there is an address


def chapters(page: str) -> dict[str, list[str]]:
    """The pages that an index lists, in its order, under the heading that they stand under ("" before the first)."""
    chapter, found, seen = "", {"": []}, set()  # type: str, dict[str, list[str]], set[str]
    for line in page.splitlines():
        heading, entry = _HEADING.match(line), _ENTRY.match(line)
        if heading:
            chapter = heading[1]
            found.setdefault(chapter, [])
        if entry and entry[1] not in seen:
            seen.add(entry[1])
            found[chapter].append(entry[1])
    return {title: pages for title, pages in found.items() if pages}


def _toctree(caption: str, pages: list[str]) -> str:
    head = ["```{toctree}", ":hidden:"] + ([f":caption: {caption}"] if caption else [])
    return "\n".join([*head, "", *pages, "```", ""])


def _add_the_tree(_: Sphinx, name: str, source: list[str]) -> None:
    """An index brings the pages that it lists into the side bar: the first page by chapters, others without."""
    if name == "index":
        source[0] += "\n\n" + "\n".join(_toctree(title, pages) for title, pages in chapters(source[0]).items())
    elif name.endswith("/index"):
        listed = [page for pages in chapters(source[0]).values() for page in pages]
        source[0] += "\n\n" + (_toctree("", listed) if listed else "")


def setup(app: Sphinx) -> None:
    """What Sphinx calls."""
    app.connect("source-read", _add_the_tree)
