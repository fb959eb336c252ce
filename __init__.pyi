"""The Python interface: each name, and the module that it comes from, which is loaded when the name is asked for."""

# A mosaic with its orthoimages
from .plugin.seams.measure.window.inspection import open_block as open_block
from .plugin.seams.measure.window.inspection import Block as Block
from .plugin.seams.measure.source_images import Source as Source

# Windows
from .plugin.seams.measure.window.inspection import inspect_window as inspect_window
from .plugin.seams.measure.window.inspection import inspect_windows as inspect_windows
from .plugin.seams.measure.window.window_request import InspectionSettings as InspectionSettings
from .plugin.seams.measure.window.window_request import WindowRequest as WindowRequest
from .plugin.seams.measure.window.window_result import WindowResult as WindowResult
from .plugin.seams.measure.profile.seam_profile import SeamProfile as SeamProfile
from .plugin.seams.measure.profile.seam_profile import ProfileBin as ProfileBin
from .plugin.seams.measure.profile.window_detail import LossPicture as LossPicture
from .plugin.seams.measure.judgement.verdicts import Verdict as Verdict
from .plugin.seams.measure.judgement.causes import Cause as Cause
from .plugin.seams.measure.judgement.verdicts import Judgement as Judgement
from .plugin.seams.measure.judgement.verdicts import Ratios as Ratios
from .plugin.seams.measure.judgement.explanation import Explanation as Explanation
from .plugin.seams.measure.window.window_result import ClipResult as ClipResult
from .plugin.seams.measure.window.window_result import PairResult as PairResult

# A whole mosaic
from .plugin.seams.measure.scan.whole_scan import scan as scan
from .plugin.seams.measure.scan.whole_scan import ScanRun as ScanRun
from .plugin.seams.measure.blocks.scan_settings import ScanSettings as ScanSettings
from .plugin.seams.measure.scan.scan_result import ScanResult as ScanResult
from .plugin.seams.measure.scan.scan_result import JudgedPiece as JudgedPiece
from .plugin.seams.measure.seamlines.seam_pieces import SeamPiece as SeamPiece
from .plugin.seams.measure.planning.window_placing import PlacedWindow as PlacedWindow

# Tables
from .plugin.seams.measure.window.window_tables import window_rows as window_rows
from .plugin.seams.measure.window.window_tables import profile_rows as profile_rows
from .plugin.seams.measure.window.window_tables import curve_rows as curve_rows
from .plugin.seams.measure.window.window_tables import pair_rows as pair_rows
from .plugin.seams.measure.scan.scan_result import seam_rows as seam_rows

# The decision on a delivery
from .plugin.acceptance.measure.delivered_rows import make_delivery as make_delivery
from .plugin.acceptance.measure.acceptance_rules import limit_rules as limit_rules
from .plugin.acceptance.measure.acceptance_rules import load_acceptance_rules as load_acceptance_rules
from .plugin.acceptance.measure.deciding import decide as decide
from .plugin.acceptance.measure.acceptance_rules import AcceptanceRules as AcceptanceRules
from .plugin.acceptance.measure.delivery import Delivery as Delivery
from .plugin.acceptance.measure.decision import Decision as Decision
from .plugin.acceptance.measure.decision import AcceptanceOutcome as AcceptanceOutcome
from .plugin.acceptance.measure.decision import DecidedPiece as DecidedPiece
from .plugin.acceptance.measure.decision import FailureRun as FailureRun
from .plugin.acceptance.measure.decision import MetreFigures as MetreFigures
from .plugin.acceptance.measure.decision import RuleOutcome as RuleOutcome
from .plugin.imagery.seam_totals import PieceState as PieceState

# Pixels
from .plugin.imagery.open_raster import OpenRaster as OpenRaster
from .plugin.imagery.rasters import RasterRef as RasterRef
from .plugin.imagery.rasters import Raster as Raster
from .plugin.imagery.grids import PixelWindow as PixelWindow
from .plugin.imagery.wavelets import clip_curves as clip_curves
from .plugin.imagery.wavelets import Curve as Curve

# Random noise
from .plugin.noise.measure.band_noise import measure_noise as measure_noise
from .plugin.noise.measure.band_noise import BandNoise as BandNoise
from .plugin.noise.measure.band_noise import NoiseVerdict as NoiseVerdict
from .plugin.noise.measure.noise_amount import NoiseAmount as NoiseAmount

# Ground resolved distance
from .plugin.resolution.measure.bars import measure_line as measure_line
from .plugin.resolution.measure.bar_groups import judge_lines as judge_lines
from .plugin.resolution.measure.bars import BarLine as BarLine
from .plugin.resolution.measure.profiles import Segment as Segment
from .plugin.resolution.measure.target import Target as Target
from .plugin.resolution.measure.bar_groups import TargetResolution as TargetResolution

# Interior orientation
from .plugin.photos.measure.photo import scanned_photo as scanned_photo
from .plugin.photos.measure.camera_calibration import read_calibration as read_calibration
from .plugin.photos.measure.interior_orientation import orient_photo as orient_photo
from .plugin.photos.measure.orientation import OrientationSettings as OrientationSettings
from .plugin.photos.measure.orientation import PhotoOrientation as PhotoOrientation

# Sensor models and orthorectification
from .plugin.sensors.measure.points import Points as Points
from .plugin.sensors.measure.registry import sensor_model as sensor_model
from .plugin.sensors.measure.adjustment import adjust as adjust
from .plugin.sensors.measure.adjustment import Adjustment as Adjustment
from .plugin.sensors.measure.rpc import Domain as Domain
from .plugin.sensors.measure.orthorectification import OrthoRequest as OrthoRequest
from .plugin.sensors.measure.orthorectification import orthorectify as orthorectify
from .plugin.sensors.measure.orthorectification import Ortho as Ortho

# What is told, and what goes wrong
from .plugin.imagery.errors import Message as Message
from .plugin.imagery.errors import SeamInspectorError as SeamInspectorError
from .plugin.imagery.errors import SeamInspectorWarning as SeamInspectorWarning

__version__: str
"""As metadata.txt has it."""

def classFactory(iface: object) -> object: ...
