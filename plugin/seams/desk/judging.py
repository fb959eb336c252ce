"""Who judges which window, what comes next and how far it is: the model behind the judge bar and its keys."""
from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass, replace
from itertools import chain, islice
from typing import TYPE_CHECKING

from qgis.core import QgsProject
from qgis.PyQt.QtCore import QObject, pyqtSignal

from ...imagery.statistics import DECIDED, OPERATORS, Operator
from ...toolkit.connections import Connections
from ...toolkit.project_settings import load_settings, save_settings
from ...toolkit.translation import filled, tr
from ..words import observer_word
from .inputs.project_inputs import read_settings

if TYPE_CHECKING:
    from ..measure.window_records import WindowRecord
    from .session import Session

_KEY = "judging"


@dataclass(frozen=True)
class JudgingSettings:
    """Plain values, as the project keeps them."""

    operator: int = 1  # 1 or 2: who judges
    is_blind: bool = False  # whether the tool's verdict, and the other operator's, is hidden


def load_judging(project: QgsProject) -> JudgingSettings:
    """The project's; the defaults where it has none, or they are another kind of thing."""
    return read_settings(JudgingSettings, load_settings(project, _KEY))


@dataclass(frozen=True)
class JudgingProgress:
    """How far the present operator is with all windows."""

    count: int
    judged: int  # with a verdict of his
    unsure: int  # where he looked and was not sure
    to_judge: int
    """To look at yet, be there too little for a verdict. The others have no source, or are not inspected."""
    is_of_scan: bool = False  # whether the worst places of a scan are gone through, and only they are counted

    @property
    def is_done(self) -> bool:
        """Whether all were looked at that can be."""
        return self.to_judge == 0 < self.judged + self.unsure

    def words(self) -> str:
        """``21 to go: 38 of 59 judged``; before an inspection just that there is nothing to judge."""
        count = self.judged + self.unsure + self.to_judge  # so that it adds up
        if not count:
            return tr("nothing to judge yet") if self.count else ""
        text = tr("{left} to go: {judged} of {count} judged")
        if self.is_of_scan:
            text = tr("Worst places: {left} of {count} to go")
        unsure = filled(tr("{unsure} not sure"), unsure=self.unsure) if self.unsure else ""
        text = filled(text, judged=self.judged, count=count, left=self.to_judge)
        return ", ".join(filter(None, (text, unsure)))

    def rest(self) -> str:
        """How many other windows there are; empty where there are none."""
        rest = self.count - self.judged - self.unsure - self.to_judge
        return filled(tr("{count} not comparable or not inspected"), count=rest) if rest else ""


_JUDGED, _UNSURE, _LEFT, _REST = "judged", "unsure", "left", "rest"


def _kind(row: WindowRecord, operator: Operator) -> str:
    word = getattr(row, operator.observer)
    if word:
        return _JUDGED if word in DECIDED else _UNSURE
    return _LEFT if row.is_compared else _REST


class Judging(QObject):
    """Writes what the present operator says and goes on to the next window that is to be judged."""

    changed = pyqtSignal()  # the operator, or what is hidden
    stepped = pyqtSignal(int)  # feature id of the window that the operator went on to

    def __init__(
        self,
        session: Session,
        shown: Callable[[], Sequence[int]] | None = None,
        confirm: Callable[[str], bool] = lambda question: True,
        parent: QObject | None = None,
        is_in_view: Callable[[int], bool] = lambda fid: True,
    ) -> None:
        """``shown``: the windows as the operator sees them, by default the layer's, the same list while they are the
        same; ``confirm`` asks him; ``is_in_view``: whether he has a window before his eyes.
        """
        super().__init__(parent)
        self._session = session
        self._shown = shown
        self._confirm = confirm
        self._is_in_view = is_in_view
        self._project = QgsProject.instance()
        self.settings = load_judging(self._project)  # which the project keeps
        self._judged: list[int] = []  # numbers, the last one judged at the end
        self._went_to: list[int] | None = None  # what the last judgement selected, by number; None once one left it
        self._is_sure_said = False  # of the selected window, before its judgement
        self.just_sure: tuple[int, int] | None = None
        """Number of the window judged before this one, and how sure the operator said then that he was, percent."""
        self._counted: object = None
        self._kinds: dict[int, str] = {}  # what the present operator has done with each window, by feature id
        self._fids: Sequence[int] = []
        self._places: dict[int, int] = {}
        self._place = -1
        self._last_place = -1
        self._walk: list[int] = []  # numbers of the windows that are gone through before all others
        self._connections = Connections(
            (session.begunAnew, self._load), (session.selectionChanged, self._leave_judged),
        )

    def close(self) -> None:
        """Let go of the project; once is enough."""
        self._connections.close()

    # What the project keeps

    @property
    def operator(self) -> Operator:
        """Who judges: the fields that his words go to."""
        return OPERATORS[1] if self.settings.operator == 2 else OPERATORS[0]

    @property
    def is_blind(self) -> bool:
        """Whether the tool's verdict and the other operator's are hidden."""
        return self.settings.is_blind

    def change(self, **settings: object) -> None:
        """Change some of the settings."""
        changed = replace(self.settings, **settings)  # type: ignore[arg-type]
        if changed != self.settings:
            self.settings = changed
            save_settings(self._project, _KEY, asdict(changed))
            self._went_to = self.just_sure = None
            self.changed.emit()

    def _load(self, *_: object) -> None:
        self.settings = load_judging(self._project)
        self._judged, self._walk = [], []
        self._went_to = self.just_sure = None
        self.changed.emit()

    # Judging

    def word(self, row: WindowRecord) -> str:
        """What the operator says of a window."""
        return str(getattr(row, self.operator.observer))

    def judge(self, word: str) -> bool:
        """Write the operator's word on the selected window, and go on. Of several at once he is asked first; to one
        that is not in view he goes instead.

        After the last one no window is selected, so that keys which come too late judge nothing again.
        Whether there was anything to do.
        """
        fids = self._session.selected()
        if not fids:
            return False
        if len(fids) > 1:
            if self._may_judge_all(word, len(fids)):
                self._session.judge(fids, word, self.operator)
            return True
        self.follow()
        if not self._is_in_view(fids[0]):
            self._go_to(fids[0])
            return True
        row = self._session.row(fids[0])
        after = None if row is None else self._after(row)
        following_row = None if after is None else self._session.row(after)
        following = None if following_row is None else following_row.window_id  # numbers stay when a layer is saved
        self._session.judge(fids, word, self.operator)
        row = self._session.numbered(row.window_id) if row is not None else None
        if row is not None and self.word(row) == word:  # what could not be written is no reason to go on
            self._judged = [number for number in self._judged if number != row.window_id] + [row.window_id]
            was_sure_said, self.just_sure = self._is_sure_said, None
            self._went_to = None if was_sure_said else [] if following is None else [following]
            if following is not None:
                self._go_to_number(following)
            else:
                self._session.select([])
        return True

    def take_back(self) -> bool:
        """Take back what was said of the selected windows; where nothing was, of the window judged last."""
        rows = [row for row in map(self._session.row, self._session.selected()) if row is not None and self.word(row)]
        if len(rows) > 1 and not self._may_judge_all("", len(rows)):
            return True
        if not rows:
            last = self._last_judged()
            if last is None:
                return False
            self._judged.pop()
            self._go_to_number(last.window_id)
            rows = [last]
        self._session.judge([row.fid for row in rows], "", self.operator)
        self._is_sure_said = False
        return True

    def say_sure(self, percent: int) -> bool:
        """Write how sure the operator is: of the window that he just judged, until he leaves where that led him.

        Where he said it before he judged, or judged nothing just now, it is of the selected windows.
        """
        row = self.just_judged()
        if row is None:
            self._is_sure_said = True
            return self.note(confidence=percent)
        self.just_sure = row.window_id, percent
        self._session.note([row.fid], {self.operator.confidence: percent})
        return True

    def just_judged(self) -> WindowRecord | None:
        """The window that the operator just judged, until he leaves where that led him."""
        row = self._last_judged()
        return row if self._selected_numbers() == self._went_to else None

    def note(self, judged: WindowRecord | None = None, **values: object) -> bool:
        """Write ``confidence`` or ``remark`` of the selected windows, or of the one that was just judged."""
        fids = self._session.selected() if judged is None else [judged.fid]
        if len(fids) > 1 and not self._confirm(filled(tr("Write this into {count} windows?"), count=len(fids))):
            return True
        if fids:
            self._session.note(fids, {getattr(self.operator, name): value for name, value in values.items()})
        return bool(fids)

    def _may_judge_all(self, word: str, count: int) -> bool:
        if word:
            question = filled(tr("Judge {count} windows as {word}?"), count=count, word=observer_word(word))
        else:
            question = filled(tr("Take back the verdicts on {count} windows?"), count=count)
        return self._confirm(question)

    def _last_judged(self) -> WindowRecord | None:
        while self._judged:
            row = self._session.numbered(self._judged[-1])
            if row is not None and self.word(row):
                return row
            self._judged.pop()
        return None

    def _leave_judged(self) -> None:
        """Somebody went elsewhere: what is said now is said of the window that is selected."""
        selected = self._selected_numbers()
        if selected != self._went_to:
            self._went_to = self.just_sure = None
        if not set(selected) <= set(self._walk):
            self._walk = []
        self._is_sure_said = False

    # Where the selected window stands

    def follow(self) -> None:
        """Take the windows in the order that they are shown in now, and the place of the selected one."""
        windows = self._session.windows()
        if (self.operator, windows) != self._counted:  # each key asks of thousands
            self._counted = self.operator, windows
            self._kinds = {row.fid: _kind(row, self.operator) for row in windows}
        shown: Sequence[int] = self._walked()
        if not shown:
            shown = self._shown() if self._shown is not None else [row.fid for row in windows]
        if shown is not self._fids:
            self._fids, self._places = shown, {fid: place for place, fid in enumerate(shown)}
        places = (self._places[fid] for fid in self._session.selected() if fid in self._places)
        self._place = max(places, default=-1)
        if self._place >= 0:
            self._last_place = self._place

    def progress(self) -> JudgingProgress:
        """What the operator has done."""
        walk = self._walked()
        counts = Counter(map(self._kinds.get, walk or self._kinds))
        judged, unsure = counts[_JUDGED], counts[_UNSURE]
        if walk:
            return JudgingProgress(len(walk), judged, unsure, len(walk) - judged - unsure, is_of_scan=True)
        return JudgingProgress(len(self._kinds), judged, unsure, counts[_LEFT])

    def neighbour(self, by: int) -> int | None:
        """The window before or after. One that the filter took away once it was judged still has its place."""
        if self._place >= 0:
            place = self._place + by
        else:
            place = max(self._last_place, 0) + min(by, 0) if self._last_place >= 0 else 0
        while 0 <= place < len(self._fids):
            if self._session.row(self._fids[place]) is not None:
                return self._fids[place]
            place += by  # it is gone, and the table has not been told yet
        return None

    def next_to_judge(self) -> int | None:
        """The next compared window without the operator's word; after the last one the first. Where none is selected,
        the first in the chosen order; one that the filter took away once it was judged still has its place."""
        start = self._place + 1 if self._place >= 0 else max(self._last_place, 0) if self._session.selected() else 0
        current = self._fids[self._place] if self._place >= 0 else None
        around = chain(islice(self._fids, start, None), islice(self._fids, start))
        wanted = (_LEFT, _REST) if self._walked() else (_LEFT,)
        return next((fid for fid in around if self._kinds.get(fid) in wanted and fid != current), None)

    # Places of a scan

    def walk(self, fids: Sequence[int]) -> None:
        """Go through these windows in their order and leave none out, until another one is selected.

        To the first without the operator's word, or from such a one to the next; in a review to any of them.
        """
        rows = [row for row in map(self._session.row, dict.fromkeys(fids)) if row is not None]
        places = [row.fid for row in rows if not self.word(row)] or [row.fid for row in rows]
        self._walk = [row.window_id for row in rows]
        if places:
            current = self._session.selected()
            following = places.index(current[0]) + 1 if current and current[0] in places else 0
            self._go_to(places[following % len(places)])

    def is_walked(self) -> bool:
        """Whether all windows that were to be gone through are judged, and no other one is selected since."""
        return bool(self._walk) and not self._walked()

    def _walked(self) -> list[int]:
        """Windows that are gone through before all others, while one is not judged."""
        rows = [row for row in map(self._session.numbered, self._walk) if row is not None]
        fids = [row.fid for row in rows]
        return fids if not all(map(self.word, rows)) else []

    def _following(self) -> int | None:
        """The next one to judge; where all are judged, as in a review, the one after this. None where none was yet."""
        following = self.next_to_judge()
        if following is None and any(map(self.word, self._session.windows())):
            return self.neighbour(1)
        return following

    def _after(self, row: WindowRecord) -> int | None:
        """The window that a verdict on the selected one leads to; in a review, of a window judged before, the next."""
        following = self.next_to_judge()
        return self.neighbour(1) if following is None and self.word(row) else following

    def can_go_on(self) -> bool:
        """Whether there is another window to go on to."""
        return self._following() is not None

    def begin(self) -> None:
        """To the first window that is to be judged; to none where all are, which a key would judge once more."""
        self.follow()
        self._go_to(self.next_to_judge())

    def go_on(self) -> bool:
        """Without judging, to the next window that is to be judged, or the next one where all are."""
        self.follow()
        self._go_to(self._following())
        return bool(self._fids)

    def step(self, by: int) -> bool:
        """To the window before or after."""
        self.follow()
        self._go_to(self.neighbour(by))
        return bool(self._fids)

    def _go_to(self, fid: int | None) -> None:
        row = None if fid is None else self._session.row(fid)
        if row is not None:
            self._session.select([row.fid])
            self.follow()  # the next key may come before the selection is told
            self.stepped.emit(row.fid)

    def _go_to_number(self, number: int | None) -> None:
        row = None if number is None else self._session.numbered(number)
        if row is not None:
            self._go_to(row.fid)

    def _selected_numbers(self) -> list[int]:
        return [row.window_id for row in map(self._session.row, self._session.selected()) if row is not None]
