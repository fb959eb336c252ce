"""The Python interface: each name, and the module that it comes from, which is loaded when the name is asked for.

After ``#:`` those of its members that the reference tells of, where it is not all of them.
"""

# A mosaic with its orthoimages
from .plugin.seams.measure.window.inspection import open_block as open_block
from .plugin.seams.measure.window.inspection import Block as Block
from .plugin.imagery.rasters import Raster as Raster
#: ref columns rows band_names data_type wkt extent grid ground_sample_distance
from .plugin.imagery.grids import Grid as Grid
#: columns rows pixel_width pixel_height extent ground_sample_distance window_extent to_map
from .plugin.seams.measure.source_images import Source as Source
from .plugin.imagery.rasters import RasterRef as RasterRef
#: path name

# Windows
from .plugin.seams.measure.window.inspection import inspect_window as inspect_window
from .python.measuring import inspect_windows as inspect_windows
from .plugin.seams.measure.window.measured_window import InspectionSettings as InspectionSettings
from .plugin.seams.measure.window.measured_window import WindowRequest as WindowRequest
from .plugin.seams.measure.window.window_result import WindowResult as WindowResult
from .plugin.seams.measure.judgement.verdicts import Judgement as Judgement
#: verdict reason
from .plugin.seams.measure.judgement.verdicts import Verdict as Verdict
from .plugin.seams.measure.judgement.causes import Cause as Cause
from .plugin.seams.measure.profile.seam_profile import SeamProfile as SeamProfile
from .plugin.seams.measure.profile.seam_profile import ProfileBin as ProfileBin
from .plugin.imagery.errors import Message as Message
#: template values

# Arrays
from .python.arrays import seam_profile as seam_profile
from .python.arrays import inspect_arrays as inspect_arrays
from .python.arrays import clip_curves as clip_curves
from .plugin.imagery.wavelets import Curve as Curve
from .python.arrays import measure_noise as measure_noise
from .plugin.noise.measure.band_noise import BandNoise as BandNoise
from .plugin.noise.measure.band_noise import NoiseVerdict as NoiseVerdict
from .plugin.imagery.open_raster import OpenRaster as OpenRaster
#: raster nodata read thinned is_valid blocks
from .plugin.imagery.open_raster import PixelBlock as PixelBlock
from .plugin.imagery.grids import PixelWindow as PixelWindow

# A whole mosaic
from .python.measuring import scan as scan
from .plugin.seams.measure.blocks.block_grid import ScanSettings as ScanSettings
from .plugin.seams.measure.scan.scan_result import ScanResult as ScanResult
from .plugin.seams.measure.scan.scan_result import JudgedPiece as JudgedPiece
#: piece left right kept low high band_width_m feather_width_m visibility verdict reason left_date right_date is_stretch
from .plugin.seams.measure.seamlines.seam_pieces import SeamPiece as SeamPiece
#: seam_id station_m length_m vertices
from .plugin.seams.measure.seamlines.seam_tracing import SourcePolygon as SourcePolygon
from .plugin.seams.measure.planning.window_placing import PlacedWindow as PlacedWindow
from .python.measuring import mend as mend
from .plugin.seams.measure.mending.mend_run import MendSettings as MendSettings
from .plugin.seams.measure.mending.mending import MendedSeam as MendedSeam
from .plugin.seams.measure.mending.failed_runs import SeamRun as SeamRun
#: piece kept is_wanted width_m

# Tables
from .plugin.seams.measure.window.window_tables import window_rows as window_rows
from .plugin.seams.measure.window.window_tables import profile_rows as profile_rows
from .plugin.seams.measure.window.window_tables import curve_rows as curve_rows
from .plugin.seams.measure.window.window_tables import pair_rows as pair_rows
from .plugin.seams.measure.scan.scan_result import seam_rows as seam_rows
from .plugin.imagery.records import TableRows as TableRows
from .python.scan_files import write_scan as write_scan

# The decision on a delivery
from .python.deciding import decide as decide
from .plugin.acceptance.measure.acceptance_rules import limit_rules as limit_rules
from .plugin.acceptance.measure.acceptance_rules import load_acceptance_rules as load_acceptance_rules
from .plugin.acceptance.measure.acceptance_rules import AcceptanceRules as AcceptanceRules
from .plugin.acceptance.measure.decision import Decision as Decision
from .plugin.acceptance.measure.decision import AcceptanceOutcome as AcceptanceOutcome
from .plugin.acceptance.measure.decision import MetreFigures as MetreFigures

# What goes wrong
from .plugin.imagery.errors import SeamInspectorError as SeamInspectorError
from .plugin.imagery.errors import SettingsError as SettingsError
from .plugin.imagery.errors import RasterError as RasterError
from .plugin.imagery.errors import SeamlineError as SeamlineError
from .plugin.imagery.errors import CancelledError as CancelledError
from .plugin.imagery.errors import WorkersLostError as WorkersLostError
from .plugin.imagery.errors import SeamInspectorWarning as SeamInspectorWarning

__version__: str
"""As metadata.txt has it."""

def classFactory(iface: object) -> object: ...
