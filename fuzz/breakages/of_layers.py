"""Layers whose geometries, attributes and systems nobody would draw, and databases that want to do something."""
from __future__ import annotations

import math
import struct
from contextlib import closing, suppress
from sqlite3 import DatabaseError, connect

from osgeo import ogr, osr

from fuzz.breakages.broken import LAYERS, Broken, breakage
from fuzz.breakages.of_rasters import SYSTEMS

COORDINATES = (math.nan, math.inf, -math.inf, 0.0, 1e300, -1e300, 1e-300, 1e15, 5e5, 5e6)
SHAPES = (
    "POINT EMPTY", "POLYGON EMPTY", "LINESTRING EMPTY", "GEOMETRYCOLLECTION EMPTY", "MULTIPOLYGON EMPTY",
    "LINESTRING(500000 5000000,500000 5000000)", "POLYGON((0 0,0 0,0 0,0 0))", "POLYGON((0 0,1 1,1 0,0 1,0 0))",
    "POINT(500010 4999990)", "MULTIPOINT((1 1),(2 2))", "LINESTRING(500000 5000000,1e9 1e9)",
    "POLYGON((-1e7 -1e7,1e7 -1e7,1e7 1e7,-1e7 1e7,-1e7 -1e7))", "CIRCULARSTRING(0 0,1 1,2 0)",
    "CURVEPOLYGON(CIRCULARSTRING(500000 5000000,500010 4999990,500000 5000000))", "TIN(((0 0 0,0 0 1,0 1 0,0 0 0)))",
    "MULTIPOLYGON(((500000 5000000,500012 5000000,500012 4999988,500000 5000000)),((1 1,2 2,2 1,1 1)))",
    "GEOMETRYCOLLECTION(POINT(1 1),LINESTRING(1 1,2 2),POLYGON((0 0,1 0,1 1,0 0)))", "POLYGON((500000 5000000))",
)  # fmt: skip
VALUES = (
    None, "", "x", "nan", "-1", "1e400", "<script>alert(1)</script>", '"><img src=x onerror=alert(1)>', "'; DROP --",
    "\u202eabc", "\0", "a" * 100_000, 0, -1, 2**62, -(2**62), math.nan, math.inf, 1e308, b"\xff\xfe",
    "../../etc/passwd", "/etc/passwd", "/dev/zero", "%s%n", "{0.__class__}",
)  # fmt: skip


def _database(broken: Broken) -> str:
    """The layer as a GeoPackage."""
    if broken.path.suffix == ".gpkg":
        return str(broken.path)
    path = str(broken.renamed("made.gpkg"))
    source = ogr.Open(str(broken.path))
    made = ogr.GetDriverByName("GPKG").CreateDataSource(path)
    made.CopyLayer(source.GetLayer(0), "made")
    made = None
    return path


def _table(path: str) -> tuple[str, str]:
    """The first table and its column of geometries; empty without one."""
    with closing(connect(path)) as database:
        rows = database.execute(
            "SELECT c.table_name, coalesce(g.column_name, '') FROM gpkg_contents c LEFT JOIN gpkg_geometry_columns g "
            "ON g.table_name = c.table_name"
        ).fetchall()
    return rows[0]


def _said(path: str, *statements: tuple[str, tuple[object, ...]]) -> None:
    """Statements in the database, its triggers off: they want functions of SpatiaLite."""
    with closing(connect(path)) as database, database:
        triggers = [row[0] for row in database.execute("SELECT name FROM sqlite_master WHERE type = 'trigger'")]
        for name in triggers:
            database.execute(f'DROP TRIGGER "{name}"')
        for statement, values in statements:
            database.execute(statement, values)


@breakage(*LAYERS)
def shapes(broken: Broken) -> str:
    """Some or all geometries are others, whatever the layer says they are."""
    path = _database(broken)
    table, column = _table(path)
    if not column:
        return path
    every = broken.random.random() < 0.5
    if broken.random.random() < 0.5:
        wkb = ogr.CreateGeometryFromWkt(broken.random.choice(SHAPES)).ExportToIsoWkb()
    else:
        pairs = [broken.random.choice(COORDINATES) for _ in range(2 * broken.random.choice((2, 4, 9)))]
        kind = broken.random.choice((2, 3))
        head = struct.pack("<BI", 1, kind) + (struct.pack("<I", 1) if kind == 3 else b"")
        wkb = head + struct.pack("<I", len(pairs) // 2) + struct.pack(f"<{len(pairs)}d", *pairs)
    blob = b"GP\0\1" + struct.pack("<i", 32633) + bytes(wkb)
    condition = "" if every else " WHERE rowid = (SELECT min(rowid) FROM " + f'"{table}")'
    _said(path, (f'UPDATE "{table}" SET "{column}" = ?{condition}', (blob,)))
    return path


@breakage(*LAYERS)
def geometry_bytes(broken: Broken) -> str:
    path = _database(broken)
    table, column = _table(path)
    if not column:
        return path
    with closing(connect(path)) as database:
        blob = bytearray(database.execute(f'SELECT "{column}" FROM "{table}" LIMIT 1').fetchone()[0] or b"GP\0\0")
    for _ in range(broken.random.choice((1, 3))):
        blob[broken.random.randrange(len(blob))] = broken.random.choice((0, 1, 127, 128, 255))
    value = broken.random.choice((bytes(blob), bytes(blob), None, b"", b"GP", bytes(blob[: len(blob) // 2]), "text"))
    _said(path, (f'UPDATE "{table}" SET "{column}" = ?', (value,)))
    return path


@breakage(*LAYERS)
def attributes(broken: Broken) -> str:
    """Values that a field does not hold, or nobody expects."""
    path = _database(broken)
    table, geometry = _table(path)
    with closing(connect(path)) as database:
        columns = [row[1] for row in database.execute(f'PRAGMA table_info("{table}")')][1:]
    columns = [column for column in columns if column != geometry]
    if not columns:
        return path
    every = broken.random.random() < 0.5
    condition = "" if every else f' WHERE rowid = (SELECT min(rowid) FROM "{table}")'
    chosen = broken.random.sample(columns, min(len(columns), broken.random.choice((1, 1, 2, 99))))
    _said(path, *(
        (f'UPDATE "{table}" SET "{column}" = ?{condition}', (broken.random.choice(VALUES),)) for column in chosen
    ))  # fmt: skip
    return path


@breakage(*LAYERS)
def fields(broken: Broken) -> str:
    """A field is gone, or called otherwise."""
    path = _database(broken)
    table, geometry = _table(path)
    with closing(connect(path)) as database:
        columns = [row[1] for row in database.execute(f'PRAGMA table_info("{table}")')][1:]
    columns = [column for column in columns if column != geometry]
    if columns:
        name = broken.random.choice(("x y", "<b>", '""', "select", "a" * 300, "\u202ex"))
        old = broken.random.choice(columns)
        _said(path, (f'ALTER TABLE "{table}" RENAME COLUMN "{old}" TO "{name}"', ()))
    return path


@breakage(*LAYERS)
def no_features(broken: Broken) -> str:
    path = _database(broken)
    _said(path, (f'DELETE FROM "{_table(path)[0]}"', ()))
    return path


@breakage(*LAYERS)
def very_many_features(broken: Broken) -> str:
    path = _database(broken)
    table, _ = _table(path)
    with closing(connect(path)) as database:
        columns = [f'"{row[1]}"' for row in database.execute(f'PRAGMA table_info("{table}")')][1:]
    names = ", ".join(columns)
    doubled = (f'INSERT INTO "{table}" ({names}) SELECT {names} FROM "{table}"', ())
    _said(path, *[doubled] * broken.random.choice((6, 9)))
    return path


@breakage(*LAYERS)
def layer_system(broken: Broken) -> str:
    path = _database(broken)
    reference, text = osr.SpatialReference(), broken.random.choice(SYSTEMS)
    try:
        known = text and reference.SetFromUserInput(text) == 0
    except RuntimeError:
        known = False
    wkt = reference.ExportToWkt() if known else text
    if broken.random.random() < 0.2:
        number = broken.random.choice((-1, 0, 4326, 999999))
        _said(path, ("UPDATE gpkg_geometry_columns SET srs_id = ?", (number,)),
              ("UPDATE gpkg_contents SET srs_id = ?", (number,)))
    else:
        other = "UPDATE gpkg_spatial_ref_sys SET definition = ?, organization = 'x' WHERE srs_id NOT IN (-1, 0, 4326)"
        _said(path, (other, (wkt,)))
    return path


@breakage(*LAYERS)
def database_tricks(broken: Broken) -> str:
    """Views and tables that are not there, or are something else. A view that never ends hangs QGIS itself."""
    path = _database(broken)
    table, _ = _table(path)
    statements = broken.random.choice((
        [f'DROP TABLE "{table}"'],
        ["DROP TABLE gpkg_geometry_columns"],
        ["DELETE FROM gpkg_contents"],
        ["UPDATE gpkg_contents SET table_name = 'nowhere'"],
        [f'ALTER TABLE "{table}" RENAME TO kept',
         f'CREATE VIEW "{table}" AS SELECT load_extension(\'x\'), * FROM kept'],
        [f'ALTER TABLE "{table}" RENAME TO kept', f'CREATE VIEW "{table}" AS SELECT * FROM "{table}"'],
        ["PRAGMA application_id = 0", "PRAGMA user_version = 99999999"],
    ))  # fmt: skip
    with suppress(DatabaseError):
        _said(path, *((statement, ()) for statement in statements))
    return path


@breakage(*LAYERS)
def style(broken: Broken) -> str:
    """A broken style beside the layer, which QGIS reads with it."""
    content = broken.random.choice((
        "", "<qgis", "<qgis><renderer-v2 type='x'/></qgis>",
        "<!DOCTYPE qgis [<!ENTITY a SYSTEM '/etc/passwd'>]><qgis>&a;</qgis>",
        "<qgis>" + "<a>" * 50_000, "\0\0\0",
    ))  # fmt: skip
    broken.renamed(broken.path.stem + ".qml").write_text(content)
    return str(broken.path)
