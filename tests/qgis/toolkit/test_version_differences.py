"""What differs between QGIS versions: field types, and enums that QGIS 4 knows by their full names only."""
from __future__ import annotations

import ast
import enum
import importlib
import warnings
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from osgeo import ogr
from qgis.core import QgsCoordinateTransformContext, QgsFeature, QgsVectorFileWriter, QgsVectorLayer
from seam_inspector.plugin.toolkit.version_differences import field


def test_fields_have_the_types_that_files_get(tmp_path: Path) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")  # QVariant's types are deprecated where there are others
        made = [field(kind, kind) for kind in ("integer", "real", "text")]
    layer = QgsVectorLayer("NoGeometry", "made", "memory")
    assert layer.dataProvider().addAttributes(made)
    layer.updateFields()
    row = QgsFeature(layer.fields())
    row.setAttributes([2**31 - 1, 1 / 3, "ż"])
    assert layer.dataProvider().addFeatures([row])[0]
    options = QgsVectorFileWriter.SaveVectorOptions()
    path = str(tmp_path / "fields.gpkg")
    QgsVectorFileWriter.writeAsVectorFormatV3(layer, path, QgsCoordinateTransformContext(), options)
    source = ogr.Open(path)
    written = source.GetLayer(0)
    definition = written.GetLayerDefn()
    kinds = [definition.GetFieldDefn(index).GetTypeName() for index in range(definition.GetFieldCount())]
    assert kinds == ["Integer", "Real", "String"]
    feature = written.GetNextFeature()
    assert [feature["integer"], feature["real"], feature["text"]] == [2**31 - 1, 1 / 3, "ż"]


def dotted(node: ast.expr) -> list[str]:
    """The names of ``a.b.c``; none for anything else."""
    if isinstance(node, ast.Name):
        return [node.id]
    if isinstance(node, ast.Attribute):
        names = dotted(node.value)
        return [*names, node.attr] if names else []
    return []


def imported(tree: ast.AST) -> dict[str, Any]:
    """Classes that a file imports from QGIS."""
    values = {}
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and node.module in ("qgis.core", "qgis.gui", "qgis.analysis"):
            module = importlib.import_module(node.module)
            for alias in node.names:
                values[alias.asname or alias.name] = getattr(module, alias.name)
    return values


def is_enum_value(value: object) -> bool:
    return isinstance(value, enum.Enum) or (isinstance(value, int) and type(value) not in (int, bool))


def faults(code: str) -> Iterator[str]:
    """Members of QGIS classes that are missing in this QGIS, and enum values that lack the name of their enum."""
    tree = ast.parse(code)
    classes = imported(tree)
    for node in ast.walk(tree):
        if not isinstance(node, ast.Attribute) or (dotted(node) or [""])[0] not in classes:
            continue
        names = dotted(node)
        owner, value = None, classes[names[0]]
        for name in names[1:]:
            owner, value = value, getattr(value, name, None)
        if value is None:
            yield f"{node.lineno} {'.'.join(names)}: not in this QGIS"
        elif is_enum_value(value) and isinstance(owner, type) and not issubclass(owner, (int, enum.Enum)):
            yield f"{node.lineno} {'.'.join(names)}: write the enum's name, {type(value).__qualname__}"


def test_enums_of_qgis_are_scoped(repository: Path) -> None:
    items = [
        f"{path.relative_to(repository)}:{fault}"
        for path in sorted((repository / "plugin").rglob("*.py"))
        for fault in faults(path.read_text(encoding="utf-8"))
    ]
    assert items == []
