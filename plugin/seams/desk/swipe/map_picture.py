"""The map once more with other layers, drawn in the background just as the canvas draws its own."""
from __future__ import annotations

from collections.abc import Sequence

from qgis.core import QgsMapLayer, QgsMapRendererParallelJob, QgsMapSettings
from qgis.PyQt.QtCore import QObject, QTimer, pyqtSignal
from qgis.PyQt.QtGui import QImage, QTransform

_under_way: set[QgsMapRendererParallelJob] = set()
"""Cancelled jobs too, until they have ended: to let one go before would wait for it."""


def _job_ended() -> None:
    """It is in the midst of telling so, and must live until it has."""
    QTimer.singleShot(0, _let_go_of_ended)


def _let_go_of_ended() -> None:
    _under_way.difference_update([job for job in _under_way if not job.isActive()])


def end_drawing() -> None:
    """Cancel all jobs, and wait until they have ended, as QGIS does with its maps before it closes a project: their
    threads share the styles of layers, and crash when these go meanwhile."""
    for job in list(_under_way):
        job.cancel()


class MapPicture(QObject):
    """Keeps the last picture until the next one is drawn."""

    drawn = pyqtSignal()

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._job: QgsMapRendererParallelJob | None = None
        self._image: QImage | None = None
        self._settings = QgsMapSettings()  # that the image was drawn by

    @property
    def image(self) -> QImage | None:
        """None before the first one is drawn."""
        return self._image

    @property
    def is_drawing(self) -> bool:
        """Whether a picture is under way."""
        return self._job is not None

    def draw(self, like: QgsMapSettings, layers: Sequence[QgsMapLayer]) -> None:
        """Draw what a canvas with these settings would show of other layers, the topmost first."""
        self._cancel()
        settings = QgsMapSettings(like)
        settings.setLayers(list(layers))
        job = QgsMapRendererParallelJob(settings)
        job.finished.connect(self._finished)
        job.finished.connect(_job_ended)
        _under_way.add(job)
        self._job = job
        job.start()

    def close(self) -> None:
        """Draw no more, and forget what was drawn."""
        self._cancel()
        self._image = None

    def onto(self, now: QgsMapSettings) -> QTransform | None:
        """Where the picture lies on a map that was moved, zoomed or turned since; None where it lies nowhere."""
        before = self._settings
        if self._image is None or before.destinationCrs() != now.destinationCrs():
            return None
        width, height = before.outputSize().width(), before.outputSize().height()
        from_pixel, to_pixel = before.mapToPixel(), now.mapToPixel()
        origin, right, below = (
            to_pixel.transform(from_pixel.toMapCoordinates(x, y))
            for x, y in ((0, 0), (width, 0), (0, height))
        )
        return QTransform(
            (right.x() - origin.x()) / width, (right.y() - origin.y()) / width,
            (below.x() - origin.x()) / height, (below.y() - origin.y()) / height, origin.x(), origin.y(),
        )  # fmt: skip

    def _cancel(self) -> None:
        job, self._job = self._job, None
        if job is not None:
            job.finished.disconnect(self._finished)
            job.cancelWithoutBlocking()

    def _finished(self) -> None:
        job, self._job = self._job, None
        if job is not None:
            self._image, self._settings = job.renderedImage(), QgsMapSettings(job.mapSettings())
            self.drawn.emit()
