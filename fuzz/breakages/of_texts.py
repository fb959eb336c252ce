"""Documents and tables that are texts: JSON, XML, YAML, CSV, points, RPC."""
from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any
from xml.sax.saxutils import escape

from fuzz.breakages.broken import TEXTS, Broken, breakage

NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?")
WORDS = (
    "nan", "inf", "-inf", "NaN", "Infinity", "1e400", "1e300", "-1e300", "1e-320", "0", "-1", "99999999999999999999",
    "", "x", "null", "true", "1,5", "--1", "0x10", "1" * 400, "\0", "\u202e12", "<script>alert(1)</script>", "'; --",
    "=1+1", "9" * 5000,
)  # fmt: skip
DEPTH = 100_000
OTHERS: tuple[Any, ...] = (
    None, [], {}, "", "x", -1, 0, 1e300, float("nan"), float("inf"), True, 10**400, [[]], {"a": {}}, "<b>", [1] * 99
)


def _text(broken: Broken) -> str:
    return broken.path.read_text(encoding="utf-8", errors="surrogateescape")


def _write(broken: Broken, text: str) -> None:
    broken.path.write_text(text, encoding="utf-8", errors="surrogateescape")


@breakage(*TEXTS)
def numbers(broken: Broken) -> None:
    """Some numbers become others, or none."""
    text = _text(broken)
    for _ in range(broken.random.choice((1, 1, 3, 20))):
        places = list(NUMBER.finditer(text))
        if not places:
            return
        one = broken.random.choice(places)
        text = text[: one.start()] + broken.random.choice(WORDS) + text[one.end() :]
    _write(broken, text)


@breakage(*TEXTS)
def all_numbers(broken: Broken) -> None:
    word = broken.random.choice(WORDS[:12])
    _write(broken, NUMBER.sub(word, _text(broken)))


@breakage(*TEXTS)
def lines(broken: Broken) -> None:
    """Lines left out, twice, or in another order."""
    found = _text(broken).splitlines(keepends=True)
    for _ in range(broken.random.choice((1, 2, 5))):
        if not found:
            break
        at = broken.random.randrange(len(found))
        how = broken.random.random()
        if how < 0.4:
            del found[at]
        elif how < 0.7:
            found.insert(at, broken.random.choice(found))
        else:
            found.insert(broken.random.randrange(len(found)), found.pop(at))
    _write(broken, "".join(found))


@breakage(*TEXTS)
def very_many_lines(broken: Broken) -> None:
    found = _text(broken).splitlines(keepends=True)
    if found:
        _write(broken, "".join(found[:2]) + found[-1] * broken.random.choice((2000, 20000)))


@breakage(*TEXTS)
def one_endless_line(broken: Broken) -> None:
    _write(broken, _text(broken).replace("\n", " ") + broken.random.choice("x,1[{<&") * 3_000_000)


@breakage(*TEXTS)
def encoding(broken: Broken) -> None:
    name = broken.random.choice(("utf-16", "utf-32", "utf-8-sig", "cp037", "utf-7"))
    broken.path.write_bytes(_text(broken).encode(name, errors="replace"))


@breakage(*(ending for ending in TEXTS if ending != ".qgs"))
def deep(broken: Broken) -> None:
    """Nested far deeper than any reader goes. QGIS itself dies of such a project, before anything of it is ours."""
    opening, closing = broken.random.choice((("[", "]"), ('{"a":', "}"), ("<a>", "</a>"), ("(", ")"), ("- ", "")))
    _write(broken, opening * DEPTH + ("1" if opening == '{"a":' else "") + closing * DEPTH)


_KEPT = re.compile(r'(?<=type="QString">)\{.*?\}(?=</)')
"""What the plugin keeps in a project: JSON, its quotes written as a project has them."""


@breakage(".qgs")
def settings(broken: Broken) -> None:
    """Parts of what a project keeps become other things, or none of it is JSON."""
    def other(found: re.Match[str]) -> str:
        if broken.random.random() < 0.2:
            return broken.random.choice(("[" * DEPTH, "{", "null", "9" * 5000, "NaN", *WORDS[:10]))
        document = json.loads(found[0].replace("&quot;", '"'))
        for key in broken.random.sample(sorted(document), len(document) // 2):
            document[key] = broken.random.choice(OTHERS)
        return escape(json.dumps(document))

    _write(broken, _KEPT.sub(other, _text(broken)))


@breakage(".qgs")
def layer_properties(broken: Broken) -> None:
    """Numbers of windows that are none."""
    words = ("--5", "\u00b2", "9" * 5000, "", "[[", "1e9", "-1", *WORDS[:10])
    numbers = re.compile(r'(?<= type="QString" value=")\d+')
    _write(broken, numbers.sub(lambda _: escape(broken.random.choice(words)).replace("\0", ""), _text(broken)))


@breakage(".json", ".geojson", ".yaml")
def structure(broken: Broken) -> None:
    """Parts of a JSON document become other things."""
    try:
        document = json.loads(_text(broken))
    except ValueError:
        return numbers(broken)
    for _ in range(broken.random.choice((1, 1, 2, 4))):
        _replace(document, broken)
    _write(broken, json.dumps(document))
    return None


def _replace(document: Any, broken: Broken) -> None:
    places = [(document, key) for key in _keys(document)]
    for holder, key in places:
        places += [(holder[key], inner) for inner in _keys(holder[key])]
        if len(places) > 2000:
            break
    if not places:
        return
    holder, key = broken.random.choice(places)
    if isinstance(holder, dict) and broken.random.random() < 0.2:
        del holder[key]
    else:
        holder[key] = broken.random.choice(OTHERS)


def _keys(value: Any) -> list[Any]:
    return list(value) if isinstance(value, dict) else list(range(len(value))) if isinstance(value, list) else []


def _entities(path: Path, inside: str) -> str:
    return f'<?xml version="1.0"?>\n<!DOCTYPE a [{inside}]>\n'


@breakage(".xml", ".yaml", ".csv", ".rpb", ".txt")
def xml_bomb(broken: Broken) -> None:
    """Entities that grow to gigabytes."""
    inside = '<!ENTITY a0 "aaaaaaaaaa">' + "".join(
        f'<!ENTITY a{number} "{f"&a{number - 1};" * 10}">' for number in range(1, 10)
    )
    _write(broken, _entities(broken.path, inside) + "<a>&a9;</a>")


@breakage(".xml", ".yaml", ".csv", ".rpb", ".txt")
def xml_outside(broken: Broken) -> None:
    """An entity that is another file."""
    text = re.sub(r"<\?xml.*?\?>", "", _text(broken))
    source = broken.random.choice((str(broken.outside), "/dev/zero", "http://127.0.0.1:9/"))
    text = NUMBER.sub("&a;", text, count=1) if text.lstrip().startswith("<") else "<a>&a;</a>"
    _write(broken, _entities(broken.path, f'<!ENTITY a SYSTEM "{source}">') + text)


@breakage(".yaml", ".json")
def yaml_bomb(broken: Broken) -> None:
    """Aliases of aliases, or objects of Python."""
    if broken.random.random() < 0.5:
        where = broken.renamed("RAN")
        _write(broken, f"cam: !!python/object/apply:os.system ['touch {where}']\n")
        return
    rows = ['a0: &a0 ["x","x","x","x","x","x","x","x","x"]']
    rows += [f"a{number}: &a{number} [{','.join([f'*a{number - 1}'] * 9)}]" for number in range(1, 9)]
    _write(broken, "\n".join(rows) + "\ncam: {im_size: *a8, type: pinhole, focal_len: *a8}\n")
