"""What ``qgis --code`` runs: plays the scenario that SEAM_INSPECTOR_JOB names, notes how it went, ends QGIS.

A script that raises would open a modal dialog and hang, and the exit code would say nothing about it.
"""
import faulthandler
import importlib.machinery
import importlib.util
import json
import os
import sys
import time
import traceback

from qgis.PyQt.QtCore import QThread, QTimer
from qgis.PyQt.QtWidgets import QApplication, QLabel

with open(os.environ["SEAM_INSPECTOR_JOB"]) as _file:
    _JOB = json.load(_file)
_raised: list = []
_MOST_WAITS = 600  # of 0.1 s


def _note_error(kind, error, trace):  # type: ignore[no-untyped-def]
    _raised.append("".join(traceback.format_exception(kind, error, trace)))


def _tell_dialog():  # type: ignore[no-untyped-def]
    dialog = QApplication.activeModalWidget()
    if dialog is not None:
        texts = [label.text() for label in dialog.findChildren(QLabel)]
        print(f"A dialog keeps QGIS: {dialog.windowTitle()!r} {texts}", file=sys.stderr, flush=True)


def _play():  # type: ignore[no-untyped-def]
    if QThread.currentThread().loopLevel() < 1:  # QGIS still starts: it could not be ended from here
        QTimer.singleShot(200, _play)
        return
    status, report = "failed", {}
    try:
        sys.path.insert(0, _JOB["repository"])
        sys.excepthook = _note_error
        from demo.desk import Desk

        specification = importlib.util.spec_from_file_location("scenario", _JOB["scenario"])
        assert specification is not None
        assert specification.loader is not None
        scenario = importlib.util.module_from_spec(specification)
        specification.loader.exec_module(scenario)
        desk = Desk(_JOB, _raised)
        report = desk.report
        scenario.play(desk)
        status = "passed"
        desk.drop_changes()
    except BaseException:
        status = traceback.format_exc()
    from qgis.utils import iface

    with open(_JOB["status"], "w") as file:
        json.dump({"status": status, "report": report, "raised": _raised, "ended": time.time()}, file)
    if status != "passed":
        iface.mainWindow().grab().save(os.path.join(_JOB["folder"], "failure.png"))
        # whatever it left behind, such as a button held down, must not keep QGIS
        os._exit(1)
    _quit(waits=0 if report.get("busy_at_exit") else _MOST_WAITS)


def _quit(waits):  # type: ignore[no-untyped-def]
    """Once no task is left, about which QGIS would ask; a scenario that is busy at its end answers for itself."""
    from qgis.core import QgsApplication
    from qgis.utils import iface

    if waits and QgsApplication.taskManager().countActiveTasks():
        QTimer.singleShot(100, lambda: _quit(waits - 1))
        return
    QTimer.singleShot(3000, _tell_dialog)
    faulthandler.dump_traceback_later(15, file=2)
    iface.actionExit().trigger()


QTimer.singleShot(1000, _play)
