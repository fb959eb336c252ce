"""A message is told by its level, in a run's log, the message bar and the log messages; the bar has room for a line."""
from __future__ import annotations

import pytest
from qgis.core import Qgis, QgsApplication, QgsProcessingContext
from seam_inspector.plugin.imagery import messages as imagery_messages
from seam_inspector.plugin.imagery.errors import Level, Message
from seam_inspector.plugin.toolkit.algorithms.base import SeamInspectorAlgorithm
from seam_inspector.plugin.toolkit.algorithms.run import Run
from seam_inspector.plugin.toolkit.desk.tool_dock import bar_level, brief_words, write_log

from tests.qgis.runs import Log

TOLD = {level: Message(f"{level.value} {{number}}.", level)(number=1) for level in Level}


def run_with(log: Log) -> Run:
    return Run(SeamInspectorAlgorithm(), {}, QgsProcessingContext(), log)


def test_a_run_is_told_by_level(qgis_app: QgsApplication) -> None:
    log = Log()
    run_with(log).tell(*TOLD.values())
    assert (log.infos, log.warnings, log.errors) == (["information 1."], ["warning 1."], ["error 1."])


def test_a_reason_is_told_at_the_level_of_the_message_around_it(qgis_app: QgsApplication) -> None:
    log = Log()
    reason = imagery_messages.ABOUT(what=3, why=TOLD[Level.ERROR])
    run_with(log).tell(reason, reason.as_warning())
    assert (log.infos, log.warnings, log.errors) == (["3: error 1."], ["3: error 1."], [])


def test_what_was_told_is_not_repeated(qgis_app: QgsApplication) -> None:
    log = Log()
    run = run_with(log)
    warning = Message("{number} is left out.", Level.WARNING)
    run.tell_once([warning(number=1), warning(number=2), warning(number=1)])
    run.tell_once([warning(number=2), warning(number=3)])
    assert log.warnings == ["1 is left out.", "2 is left out.", "3 is left out."]


def test_the_message_bar_shows_the_level(qgis_app: QgsApplication) -> None:
    levels = Qgis.MessageLevel
    assert {level: bar_level(message) for level, message in TOLD.items()} == {
        Level.INFO: int(levels.Success), Level.WARNING: int(levels.Warning), Level.ERROR: int(levels.Critical)
    }


def test_the_log_messages_show_the_level(qgis_app: QgsApplication) -> None:
    lines: list[tuple[str, int]] = []

    def hear(text: str, _page: str, level: Qgis.MessageLevel) -> None:
        lines.append((text, int(level)))

    QgsApplication.messageLog().messageReceived.connect(hear)
    write_log([TOLD[Level.WARNING], TOLD[Level.ERROR]])
    QgsApplication.messageLog().messageReceived.disconnect(hear)
    levels = Qgis.MessageLevel
    assert lines == [("warning 1.", int(levels.Warning)), ("error 1.", int(levels.Critical))]


SHORT, FIRST, SECOND = "Eleven were placed.", "It is said in one sentence.", "word " * 30
LONG = "A sentence that has no room beside a button is the first that is told."
LINE = 53  # on a screen of 1,366 px with two docks


@pytest.mark.parametrize(
    ("text", "brief"),
    [(SHORT, SHORT), (f"{FIRST} {SHORT}", f"{FIRST} {SHORT}"), (f"{FIRST} {SHORT} {FIRST}", FIRST), (SECOND, None),
     (LONG, "A sentence that has no room beside a …"), ("x" * 200, None)],
)
def test_the_bar_has_room_for_a_line_and_the_rest_comes_behind(text: str, brief: str | None) -> None:
    said, rest = brief_words(text, LINE)
    assert len(said) <= (LINE if not rest else LINE - 10)
    assert brief in (None, said)
    assert f"{said.removesuffix(' …')}{rest}".replace(" ", "") == text.replace(" ", "")
