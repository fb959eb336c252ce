"""No text is shown that bypasses ``tr``: what windows, charts and dialogs are given is no bare literal."""
from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

ALL_SHOWN = {
    "QAction", "QCheckBox", "QGroupBox", "QLabel", "QMenu", "QPushButton", "QRadioButton", "QgsCollapsibleGroupBox",
    "addAction", "addButton", "addItem", "addItems", "addMenu", "addRow", "addTab", "addToolBar", "insertItem",
    "insertMenu", "insertTab", "about", "critical", "information", "question", "warning", "getText", "getDouble",
    "getOpenFileName", "getSaveFileName", "getExistingDirectory", "createMessage", "pushCritical", "pushInfo",
    "pushMessage", "pushSuccess", "pushWarning", "reportError", "setProgressText", "showMessage", "showText",
    "setAccessibleDescription", "setAccessibleName", "setDetailedText", "setFormat", "setHeaderLabels",
    "setHorizontalHeaderLabels", "setInformativeText", "setItemText", "setLabelText", "setPlaceholderText",
    "setPrefix", "setSpecialValueText", "setStatusTip", "setSuffix", "setTabText", "setText", "setTitle", "setToolTip",
    "setWhatsThis", "setWindowTitle", "drawText", "fromFunction",
}  # fmt: skip
"""Calls of Qt and QGIS whose texts are all for people."""
FIRST_SHOWN = {"annotate", "set_title", "set_xlabel", "set_ylabel", "supxlabel", "supylabel", "suptitle", "QgsTask"}
"""Calls of matplotlib and QGIS that take words of their own after it."""
OF_NO_LANGUAGE = {"DN", "windows.csv"}
_WORD = re.compile(r"[^\W\d_]{2}")


def bare_texts(source: str) -> Iterator[tuple[int, str]]:
    """Lines and literals with letters that are shown; what a call returns, that of ``tr`` above all, is none."""
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Call):
            called = node.func
            name = called.attr if isinstance(called, ast.Attribute) else getattr(called, "id", "")
            given = node.args if name in ALL_SHOWN else node.args[:1] if name in FIRST_SHOWN else []
            for argument in given:
                yield from ((node.lineno, text) for text in _literals(argument) if _WORD.search(text))


def _literals(node: ast.AST) -> Iterator[str]:
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        yield node.value
    elif not isinstance(node, (ast.Call, ast.Compare, ast.Subscript)):
        for part in ast.iter_child_nodes(node):
            yield from _literals(part)


def test_no_shown_text_bypasses_the_translation(repository: Path) -> None:
    bare = [
        f"{path.relative_to(repository)}, line {line}: {text}"
        for path in sorted((repository / "plugin").rglob("*.py"))
        for line, text in bare_texts(path.read_text(encoding="utf-8"))
        if text not in OF_NO_LANGUAGE
    ]
    assert bare == []
