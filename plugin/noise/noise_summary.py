"""What was found about random noise, in plain words. Knows no matplotlib."""
from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping

from qgis.PyQt.QtCore import QT_TRANSLATE_NOOP, QLocale

from ..imagery.band_names import judged_band
from ..toolkit.band_titles import band_title
from ..toolkit.translation import sentence, tr
from .measure.band_noise import BandNoise, NoiseVerdict
from .measure.group_noise import ClipNoise

VERDICT_WORDS = {
    NoiseVerdict.LOW: QT_TRANSLATE_NOOP("@default", "low"),
    NoiseVerdict.MODERATE: QT_TRANSLATE_NOOP("@default", "moderate"),
    NoiseVerdict.STRONG: QT_TRANSLATE_NOOP("@default", "strong"),
    NoiseVerdict.NOT_MEASURABLE: QT_TRANSLATE_NOOP("@default", "not measurable"),
}


def verdict_counts(results: Iterable[ClipNoise]) -> Counter[NoiseVerdict]:
    """How many windows of rasters have each verdict."""
    return Counter(verdict_of(result) for result in results)


def verdict_of(result: ClipNoise) -> NoiseVerdict:
    """The verdict of the judged band."""
    judged = judged_noise(result)
    return judged.verdict if judged else NoiseVerdict.NOT_MEASURABLE


def judged_noise(result: ClipNoise) -> BandNoise | None:
    """The noise of the judged band; None where nothing could be measured."""
    return result.bands[judged_band(result.bands)] if result.bands else None


def noise_sentence(bands: Mapping[str, BandNoise]) -> str:
    """The judged band of a clip: how much noise, and its numbers; why not, where it can't be measured."""
    judged = bands[judged_band(bands)]
    note = sentence(judged.note) if judged.note else ""
    if judged.sigma is None:
        return note
    words = tr("{finding}; sigma {sigma} DN, kurtosis of level 1: {kurtosis} (Gaussian noise: 3).").format(
        finding=_curve_clause(judged), sigma=_number(judged.sigma, 2), kurtosis=_number(judged.kurtosis[0], 1)
    )
    return f"{words} {note}".strip()


def band_lines(bands: Mapping[str, BandNoise]) -> list[str]:
    """The verdict and the numbers of every band, a line each."""
    lines = []
    for name, noise in bands.items():
        line = f"{band_title(name)}: {tr(VERDICT_WORDS[noise.verdict])}"
        if noise.sigma is not None:
            numbers = tr("sigma {sigma} DN, kurtosis by level {kurtosis}").format(
                sigma=_number(noise.sigma, 2), kurtosis=" / ".join(_number(value, 1) for value in noise.kurtosis)
            )
            line = f"{line}, {numbers}"
        lines.append(line)
    return lines


def _curve_clause(noise: BandNoise) -> str:
    if noise.verdict is NoiseVerdict.LOW:
        return tr("Low noise: the curve rises at every level")
    if noise.verdict is NoiseVerdict.STRONG:
        return tr("Strong noise: the curve falls from level 1 to 2 and from 2 to 3")
    if noise.note is None:
        return tr("Moderate noise: the curve falls from level 1 to 2, then rises")
    return tr("Moderate noise")  # the note says why


def _number(value: float | None, decimals: int) -> str:
    return "-" if value is None else QLocale().toString(value, "f", decimals)
