"""Render the help that comes with the plugin: resources/help/NAME.html of the algorithms and first steps.

A machine without internet shows them as well as any: no script, no picture, one help.css for all. Links among them stay
among them, others lead to the guide at the homepage of metadata.txt.
"""
from __future__ import annotations

import configparser
import html
import posixpath
import re
from collections.abc import Sequence
from pathlib import Path

from markdown_it import MarkdownIt
from markdown_it.token import Token

REPOSITORY = Path(__file__).parents[1]
DOCS = REPOSITORY / "docs"
HELP = REPOSITORY / "resources" / "help"
FOLDERS = ("algorithms", "start")  # of the guide, that a user may need where there is no internet
_LINE_OF_PICTURES = re.compile(r"^!\[[^]]*\]\([^)]*\)\n", re.MULTILINE)
_COMMENT = re.compile(r"^<!--.*?-->\n", re.MULTILINE)

PAGE = """\
<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{title}</title>
<link rel="stylesheet" href="help.css">
</head>
<body>
<nav>Seam Inspector {version}{trail} · <a href="{homepage}">more on the internet</a></nav>
<main>
{body}</main>
</body>
</html>
"""


def sources() -> dict[str, Path]:
    """The pages that become help, by the names of their files without ending."""
    return {path.stem: path for folder in FOLDERS for path in sorted((DOCS / folder).glob("*.md"))}


def rendered(name: str, pages: dict[str, Path]) -> str:
    """A page as HTML."""
    known = metadata()
    text = _LINE_OF_PICTURES.sub("", _COMMENT.sub("", pages[name].read_text("utf-8")))
    markdown = MarkdownIt("commonmark").enable("table")
    tokens = markdown.parse(text)
    _give_anchors(tokens)
    for token in tokens:
        for child in token.children or ():
            if child.type == "link_open":
                target = _target(str(child.attrs["href"]), pages[name].parent, pages, known["homepage"])
                child.attrs["href"] = target
    body = markdown.renderer.render(tokens, markdown.options, {})
    body = body.replace("<table>", '<div class="table"><table>').replace("</table>", "</table></div>")
    trail = "".join(
        f' · <a href="{page}.html">{words}</a>'
        for page, words in (("first_inspection", "first inspection"), ("index", "all algorithms"))
        if page != name
    )
    return PAGE.format(title=html.escape(title(tokens)), version=known["version"], trail=trail,
                       homepage=html.escape(known["homepage"]), body=body)


def title(tokens: Sequence[Token]) -> str:
    """The first heading in plain words."""
    place = next(index for index, token in enumerate(tokens) if token.type == "heading_open")
    return "".join(child.content for child in tokens[place + 1].children or ())


def metadata() -> configparser.SectionProxy:
    """Metadata of the plugin."""
    parser = configparser.ConfigParser(interpolation=None)
    parser.read(REPOSITORY / "metadata.txt", encoding="utf-8")
    return parser["general"]


def _give_anchors(tokens: Sequence[Token]) -> None:
    """To headings, as GitHub and Sphinx do."""
    for heading, words in zip(tokens, tokens[1:]):
        if heading.type == "heading_open":
            plain = re.sub(r"[^\w\s-]", "", words.content).strip().lower()
            heading.attrSet("id", plain.replace(" ", "-"))


def _target(link: str, folder: Path, pages: dict[str, Path], homepage: str) -> str:
    """Where a link of the guide leads from a page of the help."""
    address, sharp, anchor = link.partition("#")
    if not address or ":" in address:
        return link
    place = (folder / address).resolve()
    near = next((name for name, path in pages.items() if path.resolve() == place), None)
    if near is not None:
        return f"{near}.html{sharp}{anchor}"
    inside = posixpath.splitext(place.relative_to(DOCS.resolve()).as_posix())
    ending = ".html" if inside[1] == ".md" else inside[1]
    return f"{homepage.rstrip('/')}/{inside[0]}{ending}{sharp}{anchor}"


def main() -> None:
    pages = sources()
    HELP.mkdir(exist_ok=True)
    for path in HELP.glob("*.html"):
        if path.stem not in pages:
            path.unlink()
    for name in pages:
        (HELP / f"{name}.html").write_text(rendered(name, pages), encoding="utf-8", newline="\n")


if __name__ == "__main__":
    main()
