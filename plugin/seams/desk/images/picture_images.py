"""Pictures as QPainter takes them."""
from __future__ import annotations

from qgis.PyQt.QtGui import QImage

from ...clip_pictures import ClipPicture


class PictureImages:
    """A picture as images on its arrays' own memory, without copies; it keeps the arrays as long as it lives."""

    def __init__(self, picture: ClipPicture) -> None:
        self.picture = picture
        arrays = (picture.pixels, *picture.reduced)
        self._arrays = [array if array.flags.c_contiguous else array.copy() for array in arrays]
        self._images = [
            QImage(array.data, array.shape[1], array.shape[0], array.strides[0], QImage.Format.Format_RGB888)
            for array in self._arrays
        ]

    def at(self, scale: float) -> tuple[QImage, int]:
        """The image to draw at a scale, and how many of the picture's pixels one of its pixels stands for a side."""
        step = 0
        while step + 1 < len(self._images) and scale * 2 ** (step + 1) <= 1:
            step += 1
        return self._images[step], 2**step
