"""Files as disks, networks and strangers leave them, whatever is in them."""
from __future__ import annotations

import os
from typing import Any

from seam_inspector.plugin.imagery.records import RecordFiles

from fuzz.breakages.broken import FILES, LAYERS, RASTERS, RECORDS, Broken, breakage


def _part(broken: Broken) -> Any:
    """One of the files that belong together, mostly the file itself."""
    return broken.path if broken.random.random() < 0.6 else broken.random.choice(broken.beside())


@breakage(*FILES)
def bytes_flipped(broken: Broken) -> None:
    path = _part(broken)
    content = bytearray(path.read_bytes())
    for _ in range(broken.random.choice((1, 1, 4, 32, 256))):
        if content:
            content[broken.random.randrange(len(content))] ^= 1 << broken.random.randrange(8)
    path.write_bytes(content)


@breakage(*FILES)
def head_flipped(broken: Broken) -> None:
    """In the first 400 bytes, where headers are."""
    path = _part(broken)
    content = bytearray(path.read_bytes())
    for _ in range(broken.random.choice((1, 2, 8))):
        if content:
            content[broken.random.randrange(min(len(content), 400))] = broken.random.choice((0, 1, 127, 128, 255, 32))
    path.write_bytes(content)


@breakage(*FILES)
def cut(broken: Broken) -> None:
    path = _part(broken)
    content = path.read_bytes()
    path.write_bytes(content[: broken.random.randrange(len(content) + 1)])


@breakage(*FILES)
def zeroed(broken: Broken) -> None:
    path = _part(broken)
    content = bytearray(path.read_bytes())
    start = broken.random.randrange(len(content) + 1)
    length = min(len(content) - start, broken.random.choice((1, 16, 512, 4096, len(content))))
    content[start : start + length] = bytes(length)
    path.write_bytes(content)


@breakage(*FILES)
def inserted(broken: Broken) -> None:
    path = _part(broken)
    content = path.read_bytes()
    start = broken.random.randrange(len(content) + 1)
    added = broken.random.randbytes(broken.random.choice((1, 2, 7, 512)))
    path.write_bytes(content[:start] + added + content[start:])


@breakage(*FILES)
def moved(broken: Broken) -> None:
    """A piece of the file stands where another should."""
    path = _part(broken)
    content = bytearray(path.read_bytes())
    if len(content) > 8:
        length = broken.random.randrange(1, len(content) // 2)
        start, end = (broken.random.randrange(len(content) - length) for _ in range(2))
        content[end : end + length] = content[start : start + length]
    path.write_bytes(content)


@breakage(*FILES)
def emptied(broken: Broken) -> None:
    _part(broken).write_bytes(b"")


@breakage(*FILES)
def noise(broken: Broken) -> None:
    _part(broken).write_bytes(broken.random.randbytes(broken.random.choice((1, 100, 5000))))


@breakage(*FILES)
def missing(broken: Broken) -> None:
    broken.random.choice(broken.beside()).unlink()


@breakage(*FILES)
def another_file(broken: Broken) -> str:
    """A sound file of some other kind."""
    return str(broken.other(FILES))


@breakage(*FILES)
def another_file_by_its_name(broken: Broken) -> None:
    broken.path.write_bytes(broken.other(FILES).read_bytes())


@breakage(*FILES)
def a_folder(broken: Broken) -> None:
    broken.path.unlink()
    broken.path.mkdir()


@breakage(*FILES)
def a_pipe(broken: Broken) -> None:
    """Which whoever opens it waits for, for ever."""
    broken.path.unlink()
    os.mkfifo(broken.path)


@breakage(*FILES)
def a_device(broken: Broken) -> str:
    return broken.random.choice(("/dev/zero", "/dev/urandom", "/dev/null", "/proc/self/mem", "/proc/self/maps"))


@breakage(*FILES)
def a_link_to_itself(broken: Broken) -> None:
    broken.path.unlink()
    broken.path.symlink_to(broken.path)


@breakage(*RASTERS, *LAYERS)
def an_address(broken: Broken) -> str:
    """Something that GDAL or QGIS may take for one."""
    name = str(broken.path)
    return broken.random.choice((
        f"/vsizip/{name}", f"/vsigzip/{name}", f"/vsitar/{name}", f"/vsisubfile/10,{name}", f"/vsisubfile/0_,{name}",
        "/vsicurl/http://127.0.0.1:9/a.tif", "http://127.0.0.1:9/a.tif", "/vsis3/no/such.tif", "/vsistdin/",
        "MEM:::DATAPOINTER=1,PIXELS=100,LINES=100", "GTIFF_DIR:1:" + name, "GTIFF_DIR:99:" + name,
        f"NETCDF:{name}:a", f"vrt://{name}?bands=99", f"vrt://{name}?bands=1,1,1,1", "WMS:http://127.0.0.1:9/",
        "PG:dbname=no", f"{name}|layername=no", f"{name}|layerid=99", f"{name}|subset=1=1; DROP TABLE x", "memory:",
        f"ogr:dbname='{name}' table=\"no\"", "virtual:?query=SELECT 1", f"file://{name}", "", " ", "." , "/", "\n",
        "x" * 5000, f"{name}\0.tif", "<VRTDataset/>", "{}", f"delimitedtext://file://{name}", "%s%s%n", "$(id)",
    ))  # fmt: skip


def _spoilt(broken: Broken, payload: bytes) -> bytes:
    content = bytearray(payload)
    for _ in range(broken.random.choice((1, 1, 4, 32))):
        place = broken.random.randrange(len(content) + 1)
        way = broken.random.random()
        if way < 0.7 and place < len(content):
            content[place] = broken.random.choice((0, 1, 127, 128, 255, broken.random.randrange(256)))
        elif way < 0.85:
            del content[place : place + broken.random.choice((1, 8, 1000))]
        else:
            content[place:place] = bytes(broken.random.choice((1, 8, 1000)))
    return bytes(content)


@breakage(*RECORDS)
def payload(broken: Broken) -> None:
    """A record that says something else, its checksum right."""
    RecordFiles(broken.folder).save(broken.path.name, _spoilt(broken, broken.path.read_bytes()[:-4]))
