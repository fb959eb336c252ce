"""What a noise check measures: images in groups, and windows on them, in plain data."""
from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from ...imagery import messages as imagery_messages
from ...imagery.errors import Message, RasterError
from ...imagery.grids import PixelWindow
from ...imagery.open_raster import describe
from ...imagery.rasters import Raster, RasterRef


@dataclass(frozen=True)
class GroupedImage:
    """An image and the group that it belongs to."""

    image: Raster
    group: int
    """1 or 2."""
    group_name: str = ""

    @property
    def ground_sample_distance(self) -> float | None:
        """Metres on the ground per pixel, the shorter side; None when the image has no place on the map."""
        return self.image.ground_sample_distance if self.image.has_place else None


@dataclass(frozen=True)
class Part:
    """One image in a window."""

    member: GroupedImage
    window: PixelWindow


@dataclass(frozen=True)
class NoiseRequest:
    """One window and the images that are measured in it. With both groups among them, their masks are joined."""

    window_id: int
    parts: tuple[Part, ...]
    window_class: str | None = None
    """What windows are grouped by, as land use or scale; None where they are not, or this one has no value."""

    @property
    def paired(self) -> bool:
        """Whether both groups take part."""
        return len({part.member.group for part in self.parts}) > 1


@dataclass(frozen=True)
class Plan:
    """What will be measured."""

    requests: tuple[NoiseRequest, ...]
    notices: tuple[Message, ...]


def describe_images(
    refs: Iterable[RasterRef], group: int, group_name: str = ""
) -> tuple[list[GroupedImage], list[Message]]:
    """The images of a group, and notices about those that can't be opened."""
    images, notices = [], []
    for ref in dict.fromkeys(refs):
        try:
            images.append(GroupedImage(describe(ref), group, group_name))
        except RasterError as error:
            notices.append(imagery_messages.SOURCE_LEFT_OUT(name=ref.name, why=error.message))
    return images, notices
