"""The ground of the demonstration scene: parcels with their crops, a track, two roads and a pond."""
from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .canvas import BLOCK_ROWS, PIXEL, Canvas, Colour, Curve, Extent
from .trees import in_orchard, in_wood


@dataclass(frozen=True)
class Crop:
    """What grows on a parcel: colours, rows and plants along the row (m), plant radius and ridge height (m)."""

    soil: tuple[float, float, float]
    plant: tuple[float, float, float]
    row: float
    spacing: float = 9.0
    radius: float = 0.0
    ridge: float = 0.02
    grain: float = 1.0
    missing: float = 0.05
    tramlines: float = 0.0


PLOUGHED, HARROWED, GRAIN, STUBBLE = (0.49, 0.41, 0.34), (0.61, 0.54, 0.45), (0.63, 0.60, 0.40), (0.71, 0.66, 0.51)
MEADOW, FALLOW, HOED = (0.41, 0.48, 0.31), (0.46, 0.49, 0.33), (0.54, 0.46, 0.37)
CABBAGE, POTATO, LETTUCE, BUSH = (0.51, 0.62, 0.49), (0.35, 0.48, 0.26), (0.46, 0.58, 0.31), (0.37, 0.43, 0.25)
CROPS = (
    Crop(PLOUGHED, PLOUGHED, row=0.62, ridge=0.055, grain=1.1),
    Crop(HARROWED, HARROWED, row=0.90, ridge=0.030),
    Crop(HOED, CABBAGE, row=0.80, spacing=0.62, radius=0.27, grain=0.7),
    Crop(HOED, POTATO, row=0.85, spacing=0.45, radius=0.25, ridge=0.05, grain=0.7),
    Crop(HOED, LETTUCE, row=0.55, spacing=0.40, radius=0.15, grain=0.7),
    Crop(GRAIN, GRAIN, row=0.40, grain=1.2, tramlines=1.0),
    Crop(STUBBLE, STUBBLE, row=0.55, ridge=0.025, grain=1.1),
    Crop(MEADOW, MEADOW, row=2.60, grain=1.4),
    Crop(FALLOW, BUSH, row=1.90, spacing=1.70, radius=0.62, ridge=0.0, grain=1.7, missing=0.55),
)
MOWN, WILD = len(CROPS) - 2, len(CROPS) - 1


def draw_ground(canvas: Canvas, extent_m: Extent, main_road: Curve, side_road: Curve,
                rng: np.random.Generator) -> None:
    """Fields in narrow parcels, then a track and the roads over them, then the pond."""
    parcels = Parcels.drawn(rng)
    x = canvas.x()[None, :]
    for start in range(0, canvas.height.shape[0], BLOCK_ROWS):
        rows = slice(start, start + BLOCK_ROWS)
        y = canvas.y()[rows, None]
        to_main, to_side = x - main_road(y), y - side_road(x)
        draw_fields(canvas, rows, x, y, to_main, to_side, parcels, extent_m)
        draw_track(canvas, rows, x - 0.70 * extent_m[0] - 3 * np.sin(y / 37))
        on_road = np.minimum(np.abs(to_main), np.abs(to_side)) < 12
        cols = np.flatnonzero(on_road.any(axis=0))
        if cols.size:
            near = slice(cols[0], cols[-1] + 1)
            draw_roads(canvas, (rows, near), x[:, near], y, to_main[:, near], to_side[:, near])
        draw_pond(canvas, rows, x, y, extent_m)


@dataclass(frozen=True)
class Parcels:
    """Edges of the strips of land (m), each strip cut along into 64 parts with a crop and a tone."""

    edges: np.ndarray
    offsets: np.ndarray
    crops: np.ndarray
    tones: np.ndarray
    chance: np.ndarray

    @staticmethod
    def drawn(rng: np.random.Generator) -> Parcels:
        """Strips of 9 to 24 m with random crops."""
        edges = (np.cumsum(rng.uniform(9.0, 24.0, 300)) - 1000.0).astype(np.float32)
        shape = edges.size + 1, 64
        return Parcels(edges, rng.uniform(0, 64, shape[0]).astype(np.float32), rng.integers(0, len(CROPS), shape),
                       rng.normal(1.0, 0.09, shape).astype(np.float32), rng.random(1 << 16, dtype=np.float32))


def draw_fields(canvas: Canvas, rows: slice, x: np.ndarray, y: np.ndarray, to_main: np.ndarray, to_side: np.ndarray,
                parcels: Parcels, extent_m: Extent) -> None:
    """Parcels with furrows, ridges, plants in rows and grass balks between them."""
    grain, patches = canvas.grain[rows], canvas.patches[rows]
    # Three systems of parcels, each with its own direction: north-east, south-east, west of the main road.
    system = np.where(to_main < 0, 2, np.where(to_side < 0, 0, 1))
    angle = np.array([1.42, 0.55, 1.98], dtype=np.float32)
    cosine, sine = np.cos(angle)[system], np.sin(angle)[system]
    along = x * cosine + y * sine
    across = y * cosine - x * sine + np.float32(0.12) * patches + np.array([0, 900, 1800], dtype=np.float32)[system]
    strip = np.searchsorted(parcels.edges, across)
    part = np.floor(along / np.float32(120) + parcels.offsets[strip]).astype(np.int32) & 63
    crop = np.where(in_orchard(x, y, extent_m), MOWN, parcels.crops[strip, part])
    crop = np.where(in_wood(x, y, extent_m), WILD, crop)

    def table(name: str) -> np.ndarray:
        return np.array([getattr(one, name) for one in CROPS], dtype=np.float32)[crop]

    row, spacing, radius, rough = table("row"), table("spacing"), table("radius"), table("grain")
    phase, step = across / row, along / spacing
    line, cell = np.floor(phase), np.floor(step)
    key = (line.astype(np.int32) * 40503 + cell.astype(np.int32) * 30011) & 0xFFFF
    draw = parcels.chance[key]
    wobble = parcels.chance[(key * 7 + 3) & 0xFFFF] - np.float32(0.5)
    du = (step - cell - np.float32(0.5)) * spacing + radius * wobble
    dv = (phase - line - np.float32(0.5)) * row + radius * np.float32(0.6) * (draw - np.float32(0.5))
    size = radius * (np.float32(0.5) + np.float32(0.7) * np.abs(2 * wobble)) * (draw > table("missing"))
    distance = np.sqrt(du * du + dv * dv) * (1 + np.float32(0.12) * grain)
    leaf = np.clip((size - distance) / np.float32(PIXEL) + np.float32(0.5), 0, 1) * (radius > 0)
    furrow = np.cos(np.float32(2 * np.pi) * phase + np.float32(0.3) * grain)

    # A tractor leaves a pair of tracks every 12 m in the grain, and swaths some 3 m wide everywhere.
    track = np.abs(np.abs(across % np.float32(12) - 6) - np.float32(0.9)) - np.float32(0.22)
    track = np.clip(np.float32(0.5) - track / np.float32(0.15), 0, 1) * table("tramlines")
    swath = np.cos(across * np.float32(2.03) + patches)

    shade = parcels.tones[strip, part] * (1 + np.float32(0.055) * rough * grain + np.float32(0.055) * patches
                                          + np.float32(0.02) * swath)
    inside = np.minimum(across - parcels.edges[strip - 1], parcels.edges[strip] - across)
    balk = np.clip(np.float32(0.5) - (inside - np.float32(0.35) - np.float32(0.15) * patches) / np.float32(0.15), 0, 1)
    soils, plants = (np.array([getattr(one, name) for one in CROPS], dtype=np.float32) for name in ("soil", "plant"))
    tint = np.float32(0.85) + np.float32(0.3) * draw
    worn = (1 + np.float32(0.035) * furrow) * (1 - np.float32(0.22) * track)
    for band, green in enumerate((0.40, 0.46, 0.30)):
        value = soils[crop, band] * worn
        value += leaf * (plants[crop, band] * tint - value)
        value += balk * (np.float32(green) * (1 + np.float32(0.12) * grain) - value)
        canvas.reflectance[band, rows] = value * shade
    dome = np.sqrt(np.clip(1 - (distance / np.maximum(size, np.float32(0.05))) ** 2, 0, 1))
    relief = table("ridge") * furrow * (1 + np.float32(0.35) * grain) + np.float32(0.5) * radius * leaf * dome
    canvas.height[rows] = relief * (1 - balk) + (np.float32(0.016) * rough + np.float32(0.03) * balk) * grain


def draw_track(canvas: Canvas, rows: slice, to_track: np.ndarray) -> None:
    """A grassy field track with two ruts."""
    cols = np.flatnonzero((np.abs(to_track) < 4).any(axis=0))
    if not cols.size:
        return
    window = rows, slice(cols[0], cols[-1] + 1)
    grain, lateral = canvas.grain[window], to_track[:, window[1]]
    grass = np.clip(0.5 - (np.abs(lateral) - 2.0 - 0.2 * grain) / 0.4, 0, 1)
    rut = np.clip(0.5 - (np.abs(np.abs(lateral) - 0.8) - 0.28 - 0.07 * grain) / 0.2, 0, 1)
    for band, (green, sand) in enumerate(((0.42, 0.70), (0.48, 0.64), (0.31, 0.53))):
        layer = canvas.reflectance[(band, *window)]
        layer += grass * (green * (1 + 0.13 * grain) - layer)
        layer += rut * (sand * (1 + 0.07 * grain) - layer)
    canvas.height[window] += grass * (0.03 * grain - 0.05 * rut - canvas.height[window])


def draw_roads(canvas: Canvas, window: tuple[slice, slice], x: np.ndarray, y: np.ndarray, to_main: np.ndarray,
               to_side: np.ndarray) -> None:
    """Asphalt, kerbs, pavements of slabs, markings, drain grates and manholes of the crossing roads."""
    grain, patches, height = canvas.grain[window], canvas.patches[window], canvas.height[window]
    main, side = np.abs(to_main) - 3.5, np.abs(to_side) - 3.0
    # The smooth minimum rounds the corners of the crossing.
    blend = np.clip(0.5 + (side - main) / 8.0, 0, 1)
    edge = side + (main - side) * blend - 4.0 * blend * (1 - blend)

    def cover(distance: np.ndarray) -> np.ndarray:
        return np.clip(0.5 - distance / PIXEL, 0, 1)

    def stripe(value: np.ndarray, half_width: float) -> np.ndarray:
        return cover(np.abs(value) - half_width)

    def paint(amount: np.ndarray, colour: Colour, shade: np.ndarray) -> None:
        for band in range(3):
            layer = canvas.reflectance[(band, *window)]
            layer += amount * (colour[band] * shade - layer)

    on_main = main < side
    along = np.where(on_main, y + 0 * x, x + 0 * y)
    lateral = np.where(on_main, to_main, to_side)
    half = np.where(on_main, 3.5, 3.0).astype(np.float32)
    verge = cover(edge - 2.7 - 0.3 * patches)
    paint(verge, (0.46, 0.49, 0.35), 1 + 0.12 * grain)
    joints = np.maximum(stripe((along % 0.5) - 0.25, 0.03), stripe((np.abs(lateral) % 0.5) - 0.25, 0.03))
    paint(cover(edge - 1.9), (0.66, 0.64, 0.61), (1 + 0.05 * grain + 0.04 * patches) * (1 - 0.22 * joints))
    paint(cover(edge - 0.17), (0.80, 0.79, 0.77), 1 + 0.04 * grain - 0.3 * stripe((along % 1.0) - 0.5, 0.03))
    asphalt = cover(edge)
    wheels = np.exp(-((np.abs(np.abs(lateral) - 1.75) - 0.8) / 0.35) ** 2)
    repair = (np.sin(along * 0.11 + 2 * patches) > 0.93) & (lateral > 0.3)
    cracks = np.clip(1 - np.abs(patches * 9 % 2 - 1 + 0.25 * grain) / 0.012, 0, 1)
    paint(asphalt, (0.49, 0.49, 0.49),
          (1 + 0.075 * grain + 0.04 * patches) * (1 - 0.06 * wheels - 0.16 * repair - 0.2 * cracks))

    clear = np.maximum(np.abs(to_main), np.abs(to_side)) > 12.0  # no lane lines on the crossing
    dash = stripe((along % 6.0) - 3.0, 1.5) * stripe(lateral, 0.07) * clear
    gutter = stripe(np.abs(lateral) - half + 0.3, 0.06) * clear * on_main
    zebra = stripe((lateral % 1.0) - 0.5, 0.25) * stripe(np.where(on_main, np.abs(to_side), np.abs(to_main)) - 9.5, 1.6)
    paint(asphalt * np.maximum(np.maximum(dash, gutter), zebra), (0.86, 0.86, 0.84), 1 - 0.1 * np.abs(grain))
    from_grate = (along % 17.0) - 8.0
    grate = stripe(from_grate, 0.35) * stripe(np.abs(lateral) - half + 0.35, 0.27) * clear
    paint(grate, (0.26, 0.25, 0.24), np.where(np.cos(2 * np.pi * from_grate / 0.22) > 0, 1.0, 0.45))
    from_manhole = np.hypot((along % 41.0) - 20.0, lateral - 1.1)
    paint(cover(from_manhole - 0.42) * clear, (0.33, 0.31, 0.30), np.where(from_manhole > 0.3, 0.7, 1.25))
    height *= 1 - verge
    height += 0.11 * (verge - asphalt) + 0.006 * grain * asphalt


def draw_pond(canvas: Canvas, rows: slice, x: np.ndarray, y: np.ndarray, extent_m: Extent) -> None:
    """Still water with a belt of reeds, south-east."""
    width, depth = extent_m
    grain, patches = canvas.grain[rows], canvas.patches[rows]
    shore = np.hypot((x - 0.845 * width) / 1.5, y - 0.80 * depth) - 0.035 * width - 1.6 * patches - 0.15 * grain
    reeds = np.clip(0.5 - (shore - 2.2) / 0.5, 0, 1)
    water = np.clip(0.5 - shore / 0.15, 0, 1)
    for band, (reed, deep) in enumerate(((0.43, 0.20), (0.47, 0.27), (0.27, 0.27))):
        layer = canvas.reflectance[band, rows]
        layer += reeds * (reed * (1 + 0.2 * grain) - layer)
        layer += water * (deep * (1 + 0.015 * grain + 0.05 * patches) - layer)
    canvas.height[rows] += reeds * (0.5 + 0.25 * grain)
    canvas.height[rows] *= 1 - water
