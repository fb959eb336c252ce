"""Write the tables of parameters and outputs into the pages of docs/algorithms, as the provider has them.

Each page keeps its tables between the marks `<!-- parameters -->`, `<!-- outputs -->` and their ends; a test fails
where they differ from what the dialog shows.
"""
from __future__ import annotations

import re
import sys
from collections.abc import Iterable
from pathlib import Path

from qgis.core import (
    QgsApplication,
    QgsProcessing,
    QgsProcessingAlgorithm,
    QgsProcessingOutputDefinition,
    QgsProcessingParameterDefinition,
    QgsProcessingProvider,
)

PAGES = Path(__file__).parents[1] / "docs" / "algorithms"
MOST_CHOICES = 20  # written out in a table
SIGNIFICANT = 6  # digits of a default
FLAG = QgsProcessingParameterDefinition.Flag
KINDS = {
    "raster": "raster",
    "number": "number",
    "boolean": "yes or no",
    "string": "text",
    "crs": "reference system",
    "extent": "rectangle",
    "range": "two numbers",
    "field": "field",
    "file": "file",
    "fileDestination": "file",
    "folderDestination": "folder",
    "rasterDestination": "raster",
}
RESULTS = {"outputNumber": "number", "outputString": "text", "outputRaster": "raster"}


def tables(algorithm: QgsProcessingAlgorithm) -> dict[str, str]:
    """The tables of an algorithm's page by their marks, rows in the order of the dialog."""
    asked, made = [], []
    for definition in algorithm.parameterDefinitions():
        (made if definition.isDestination() else asked).append(definition)
    asked.sort(key=_is_advanced)
    inputs = _table(("parameter", "kind", "default", "meaning"), map(_parameter_row, asked))
    own = {one.name() for one in algorithm.destinationParameterDefinitions()}
    results = (
        _result_row(one) for one in algorithm.outputDefinitions() if one.type() in RESULTS and one.name() not in own
    )
    return {
        "parameters": inputs,
        "outputs": _table(("output", "kind", "meaning"), [*map(_destination_row, made), *results]),
    }


def with_tables(page: str, algorithm: QgsProcessingAlgorithm) -> str:
    """The page with its tables made anew; ValueError for one without their marks."""
    for mark, table in tables(algorithm).items():
        pattern = re.compile(rf"<!-- {mark} -->\n.*?<!-- end of {mark} -->", re.DOTALL)
        if not pattern.search(page):
            raise ValueError(f"The page of {algorithm.name()} has no marks for its table of {mark}.")
        block = f"<!-- {mark} -->\n\n{table}\n<!-- end of {mark} -->"
        page = pattern.sub(lambda _, block=block: block, page)  # type: ignore[misc]
    return page


def _parameter_row(one: QgsProcessingParameterDefinition) -> tuple[str, ...]:
    advanced = " (advanced)" if _is_advanced(one) else ""
    return f"{_escaped(one.description())} `{one.name()}`{advanced}", _kind(one), _default(one), _escaped(one.help())


def _destination_row(one: QgsProcessingParameterDefinition) -> tuple[str, ...]:
    optional = ", if asked for" if one.flags() & FLAG.FlagOptional else ""
    return f"{_escaped(one.description())} `{one.name()}`", _kind(one) + optional, _escaped(one.help())


def _result_row(one: QgsProcessingOutputDefinition) -> tuple[str, ...]:
    return f"`{one.name()}`", RESULTS[one.type()], _escaped(one.description())


def _is_advanced(one: QgsProcessingParameterDefinition) -> bool:
    return bool(one.flags() & FLAG.FlagAdvanced)


def _kind(one: QgsProcessingParameterDefinition) -> str:
    kind = one.type()
    if kind == "enum":
        choices = one.options()
        if len(choices) > MOST_CHOICES:
            return f"one of {len(choices)}, `{choices[0]}` to `{choices[-1]}`"
        return ", ".join(f"`{choice}`" for choice in choices)
    if kind == "multilayer":
        return "rasters" if one.layerType() == QgsProcessing.SourceType.TypeRaster else "layers"
    if kind == "source":
        return _layer_kind(one.dataTypes())
    if kind == "sink":
        return _layer_kind([one.dataType()])
    if kind == "file" and one.behavior() == one.Behavior.Folder:
        return "folder"
    return KINDS[kind]


def _layer_kind(types: Iterable[int]) -> str:
    kinds = QgsProcessing.SourceType
    words = {kinds.TypeVectorPoint: "points", kinds.TypeVectorLine: "lines", kinds.TypeVectorPolygon: "polygons",
             kinds.TypeVector: "table"}
    named = [words[one] for one in types if one in words]
    return " or ".join(named) or "layer"


def _default(one: QgsProcessingParameterDefinition) -> str:
    value = one.defaultValue()
    if value is None or value == "":
        return "" if one.flags() & FLAG.FlagOptional else "to be given"
    if one.type() == "boolean":
        return "yes" if value else "no"
    if isinstance(value, float):
        return f"{value:.{SIGNIFICANT}g}"
    return f"`{value}`" if one.type() == "enum" else str(value)


def _escaped(text: str) -> str:
    """A text without meaning to Markdown."""
    text = text.replace("&", "&amp;").replace("<", "&lt;").replace("|", r"\|").replace("*", r"\*")
    return re.sub(r"(?<!\w)_|_(?!\w)", r"\\_", text)


def _table(heads: tuple[str, ...], rows: Iterable[tuple[str, ...]]) -> str:
    lines = [heads, ("---",) * len(heads), *rows]
    return "".join(f"| {' | '.join(cells)} |\n" for cells in lines)


def renew(provider: QgsProcessingProvider) -> None:
    """Write the tables of every page."""
    for listed in provider.algorithms():
        algorithm = listed.create()  # a model knows its outputs when its steps are there
        path = PAGES / f"{algorithm.name()}.md"
        path.write_text(with_tables(path.read_text("utf-8"), algorithm), encoding="utf-8")


def main() -> int:
    from seam_inspector.plugin.provider import SeamInspectorProvider

    application = QgsApplication([], False)
    application.initQgis()
    provider = SeamInspectorProvider()
    QgsApplication.processingRegistry().addProvider(provider)
    renew(provider)
    return 0


if __name__ == "__main__":
    sys.exit(main())
