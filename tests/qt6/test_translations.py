"""The translation file and what is compiled of it, as Qt 6 reads them."""
from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

from qgis.PyQt.QtCore import QCoreApplication, QTranslator
from seam_inspector.plugin.toolkit.translation import tr

from tools.collect_translations import CHECKOUT, CONTEXT, known_translations, written

POLISH = CHECKOUT / "i18n" / "seam_inspector_pl.ts"


def test_pyqt6s_tool_reads_the_file_and_changes_no_entry(tmp_path: Path) -> None:
    known = known_translations(POLISH)
    source, path = tmp_path / "texts.py", tmp_path / "pl.ts"
    source.write_text("".join(f"QT_TRANSLATE_NOOP({CONTEXT!r}, {text!r})\n" for text in known), encoding="utf-8")
    path.write_text(written(dict.fromkeys(known, None), known), encoding="utf-8")
    tool = Path(sys.executable).with_name("pylupdate6")
    utf8 = {**os.environ, "PYTHONUTF8": "1"}  # the file's encoding, which the tool takes from the locale
    subprocess.run([tool, "--no-obsolete", "--ts", path, source], check=True, capture_output=True, env=utf8)
    assert known_translations(path) == known


def test_the_compiled_file_translates_under_qt_6(qgis_app: QCoreApplication) -> None:
    translator = QTranslator()
    assert translator.load(str(POLISH.with_suffix(".qm")))
    finished = {text: entry.text for text, entry in known_translations(POLISH).items() if not entry.state}
    qgis_app.installTranslator(translator)
    try:  # by QCoreApplication: PyQt6's QTranslator takes ASCII alone
        assert {text: tr(text) for text in finished} == finished
    finally:
        qgis_app.removeTranslator(translator)
    assert len(finished) > 1000
