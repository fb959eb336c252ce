"""Documents that are long in one way: the time that they take may grow with their size alone.

Each makes twice the bytes when ``Broken.scale`` is 2; the worker plays what takes its time once more so, and compares.
"""
from __future__ import annotations

import json
import re
from xml.sax.saxutils import escape

from fuzz.breakages.broken import RASTERS, Broken, breakage
from fuzz.breakages.of_several import wrapped

_BYTES = 400_000
_MARKUP = ("<SourceFilename ", "<!--", "<a ", "&", "<![CDATA[", "]]>", "<a>", "</a>", 'a="', "<?a ", "<SourceFilename>")


def _long(broken: Broken, unit: str, most: int = _BYTES) -> str:
    return unit * (broken.scale * most // len(unit))


@breakage(*RASTERS, grows=True)
def long_vrt(broken: Broken) -> str:
    path = broken.renamed("long.vrt")
    path.write_text(f"<VRTDataset {_long(broken, broken.random.choice(_MARKUP))}")
    return str(path)


@breakage(*RASTERS, grows=True)
def long_vrt_in_a_vrt(broken: Broken) -> str:
    inner, outer = broken.renamed("long.vrt"), broken.renamed("outer.vrt")
    inner.write_text(f'<VRTDataset rasterXSize="9" rasterYSize="9">{_long(broken, broken.random.choice(_MARKUP))}')
    outer.write_text(
        '<VRTDataset rasterXSize="9" rasterYSize="9"><VRTRasterBand dataType="Byte" band="1"><SimpleSource>'
        f"<SourceFilename>{inner}</SourceFilename></SimpleSource></VRTRasterBand></VRTDataset>"
    )
    return str(outer)


@breakage(*RASTERS, grows=True)
def long_metadata_beside(broken: Broken) -> None:
    unit = broken.random.choice(_MARKUP)
    broken.renamed(broken.path.name + ".aux.xml").write_text(f"<PAMDataset>{_long(broken, unit)}")


@breakage(".xml", grows=True)
def long_attribute(broken: Broken) -> None:
    broken.path.write_text(f'<a b="{_long(broken, broken.random.choice(("x", "&amp;", " ")))}"/>')


@breakage(".xml", grows=True)
def long_markup(broken: Broken) -> None:
    broken.path.write_text(f"<a>{_long(broken, broken.random.choice(_MARKUP))}")


@breakage(".json", grows=True)
def many_keys(broken: Broken) -> None:
    count = 20_000 * broken.scale
    broken.path.write_text(json.dumps({f"key_{number}": number for number in range(count)}))


@breakage(".json", ".geojson", grows=True)
def many_brackets(broken: Broken) -> None:
    broken.path.write_text(_long(broken, broken.random.choice(("[", '{"a":', "[[],", '"'))))


@breakage(".csv", ".points", ".txt", ".rpb", ".yaml", grows=True)
def long_lines(broken: Broken) -> None:
    unit = broken.random.choice((",", "\n", '"', "1,", "a: ", "- ", "{", " ", "x\n", "1\n"))
    text = broken.path.read_text(encoding="utf-8", errors="replace")
    most = 4_000 if "," in unit else _BYTES  # QGIS itself takes minutes for a table of so many columns
    broken.path.write_text(text + _long(broken, unit, most), encoding="utf-8")


@breakage(*RASTERS, grows=True)
def long_packed(broken: Broken) -> str:
    """In archives and VRTs in each other."""
    path = broken.renamed("long.vrt")
    path.write_text(f'<VRTDataset rasterXSize="9" rasterYSize="9">{_long(broken, broken.random.choice(_MARKUP))}')
    return wrapped(broken, str(path))


@breakage(".qgs", grows=True)
def long_settings(broken: Broken) -> None:
    """Long settings of what the plugin keeps in a project."""
    count = broken.scale * 20_000
    of_one_sign = _long(broken, broken.random.choice(("[", '{"a":', "9", '"', "[[],", "1,")))
    of_many_keys = json.dumps({f"key_{number}": "x" for number in range(count)})
    of_many_sources = json.dumps({"sources": [f"layer_{number}" for number in range(count)]})
    kept = escape(broken.random.choice((of_one_sign, of_many_keys, of_many_sources)))
    text = broken.path.read_text(encoding="utf-8")
    broken.path.write_text(re.sub(r'(?<=type="QString">)\{.*?\}(?=</)', lambda _: kept, text), encoding="utf-8")
