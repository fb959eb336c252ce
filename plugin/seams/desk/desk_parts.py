"""What the desk's model is made of: block, windows, results, pictures, and the tasks behind them."""
from __future__ import annotations

from qgis.core import QgsProject
from qgis.PyQt.QtCore import QObject

from ...toolkit.background_tasks import BackgroundTasks
from .images.window_pictures import WindowPictures
from .inputs.block_cache import BlockCache
from .keeping.keeping import Keeping
from .live.live_windows import LiveWindows
from .map.seam_finder import SeamFinder
from .map.window_coverage import WindowCoverage
from .windows.new_windows import NewWindows
from .windows.window_results import WindowResults
from .windows.window_watch import WindowWatch


class DeskParts:
    """The parts, each with those it needs. The session asks them; the project's follower leads them."""

    def __init__(self, project: QgsProject, watch: WindowWatch, parent: QObject) -> None:
        self.project = project
        self.watch = watch
        self.inputs_background = BackgroundTasks(parent)  # apart, since another window layer does not matter to it
        self.background = BackgroundTasks(parent)
        self.block = BlockCache(project, self.inputs_background, parent)
        self.seams = SeamFinder(self.block, self.inputs_background)
        self.coverage = WindowCoverage(parent)
        self.keeping = Keeping(watch, parent)
        self.live = LiveWindows(self.block, parent)
        self.results = WindowResults(self.block, watch, self.background, self.keeping, parent, self.live.measure)
        self.results.curvesArrived.connect(self.live.stay_open)
        self.new = NewWindows(project, self.block, watch, self.background, parent)
        self.pictures = WindowPictures(self.block, watch, self.background, parent)

    def forget_windows(self) -> None:
        """What is of the window layer so far; nothing of it may reach another one."""
        self.new.abandon()
        self.background.abandon()
        self.watch.watch(None)
        self.pictures.forget()
        self.results.forget()

    def close(self) -> None:
        """Stop all work, keep what is done, and let go of the window layer."""
        self.new.abandon()
        self.live.close()
        self.coverage.close()
        self.inputs_background.close()
        self.background.close()
        self.results.close()
        self.keeping.close()
        self.watch.close()
