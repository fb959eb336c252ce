"""What stands on paper beside a decision: what it was made of, by whom and when."""
from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from datetime import datetime, timezone

from ...imagery.open_raster import OpenRaster
from ...imagery.rasters import Raster, RasterRef
from ..measure.decision import Decision, Defect, defects_of

_SETTINGS_DOMAIN = "SEAM_INSPECTOR"  # as the scan writes it


@dataclass(frozen=True, eq=False)
class InspectionRecord:
    """A decision with what it was made of."""

    decision: Decision
    seams: tuple[tuple[str, str], ...] = ()
    """Sheets and what their layers of seams were read from."""
    windows: str = ""
    """What the layer of inspected windows was read from; empty without."""
    rules: str = ""
    """The file of rules; empty for ready ones."""
    mosaics: tuple[Raster, ...] = ()
    """What the pictures of failures are cut from."""
    loss: Raster | None = None
    """The picture of losses of the scan."""
    scan: Mapping[str, str] = field(default_factory=dict)
    """How the seams were measured: ``scan_settings`` of the picture of losses."""
    loss_bands: tuple[str, ...] = ()
    """What the picture of losses holds: ``described_bands`` of it."""
    report: str = ""
    """The page that is written beside the XML; empty for none."""
    made_at: datetime = field(default_factory=lambda: datetime.now(timezone.utc).replace(microsecond=0))

    @property
    def defects(self) -> tuple[Defect, ...]:
        """The longest failure first."""
        return defects_of(self.decision)


def scan_settings(loss: RasterRef) -> dict[str, str]:
    """What a scan wrote into its picture of losses: ``wavelet``, ``levels``, ``density``, ``piece_m``, ``corridor_m``,
    as ``seams`` whether these were ``given`` or ``found``, and as ``unexplained`` the
    share of the mosaic that follows no orthoimage.

    Empty where it is another raster's. Raises RasterError when it can't be opened.
    """
    return dict(OpenRaster(loss).dataset.GetMetadata(_SETTINGS_DOMAIN))


def described_bands(raster: RasterRef) -> tuple[str, ...]:
    """What a raster's bands are called in its file, not by their colours; those without a name by their number.

    Raises RasterError when it can't be opened.
    """
    dataset = OpenRaster(raster).dataset
    return tuple(dataset.GetRasterBand(one).GetDescription() or str(one) for one in range(1, dataset.RasterCount + 1))
