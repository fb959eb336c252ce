"""Documents that are long in one way: the time that they take may grow with their size alone.

Each makes twice the bytes when ``Broken.scale`` is 2; the worker plays what takes its time once more so, and compares.
"""
from __future__ import annotations

import json

from fuzz.breakages.broken import RASTERS, Broken, breakage

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
    broken.path.write_text(text + _long(broken, unit), encoding="utf-8")
