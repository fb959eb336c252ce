"""Control and check points."""
from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

CONTROL, CHECK = "control", "check"
SIGMAS_PX = 1e-7, 1e7  # smaller and larger ones say nothing more, and squares of theirs are no numbers


@dataclass(frozen=True)
class Points:
    """Places known on the ground and in the image."""

    ids: tuple[str, ...]
    """n names."""
    image: np.ndarray
    """(n, 2) column, row in px."""
    ground: np.ndarray
    """(n, 3) x, y in the units of ``wkt`` and height in m above the ellipsoid; NaN where no height is known."""
    wkt: str
    """Reference system of x and y."""
    sigma_px: np.ndarray
    """(n,) standard deviation of a coordinate in the image; NaN where none is given."""
    check: np.ndarray
    """(n,) bool: whether a point only judges the fit."""
    heights_wkt: str = ""
    """Reference system that says what heights refer to, where ``wkt`` does not."""

    def __len__(self) -> int:
        return len(self.ids)

    def only(self, mask: np.ndarray) -> Points:
        """The points of a mask (n,)."""
        ids = tuple(name for name, kept in zip(self.ids, mask) if kept)
        parts = {name: getattr(self, name)[mask] for name in ("image", "ground", "sigma_px", "check")}
        return replace(self, ids=ids, **parts)

    @property
    def weights(self) -> np.ndarray:
        """(n,) 1 / standard deviation; where some points have none they get the median of the others, or 1."""
        known = np.isfinite(self.sigma_px) & (self.sigma_px > 0)
        usual = float(np.median(self.sigma_px[known])) if known.any() else 1.0
        return 1 / np.clip(np.where(known, self.sigma_px, usual), *SIGMAS_PX)

    @property
    def sigma_known(self) -> bool:
        """Whether any point comes with its standard deviation."""
        return bool((self.sigma_px > 0).any())


def choose_check_points(points: Points, share: float) -> Points:
    """The points with a share of them made check points, evenly spread over the image and away from its outline.

    The same points give the same choice.
    """
    wanted = round(share * len(points))
    check = np.zeros(len(points), bool)
    extent = np.ptp(points.image, axis=0)
    places = (points.image - points.image.min(axis=0)) / np.where(extent > 0, extent, 1)
    middle = np.abs(places - 0.5).max(axis=1)
    distance = 1 - middle  # the first one lies in the middle, then the one farthest from all chosen and the border
    nearest = np.full(len(points), np.inf)
    for _ in range(wanted):
        index = int(np.argmax(np.where(check, -1.0, distance)))
        check[index] = True
        nearest = np.minimum(nearest, np.linalg.norm(places - places[index], axis=1))
        distance = np.minimum(nearest, 2 * (0.5 - middle) + 0.1)
    return replace(points, check=check)
