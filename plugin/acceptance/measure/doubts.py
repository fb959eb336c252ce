"""What of a delivery can't be decided on, or not be accepted, as it is given, and what its layers rest on.

A scan of other files than those that are there or given decides nothing. Layers that are not as their scan left them,
or lack seams that it had, can't be accepted, nor sheets that nobody has looked at.
"""
from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Callable

from ...imagery.errors import Message
from ...imagery.file_identity import states_in
from ...imagery.seam_totals import MOSAIC_FILES, NEIGHBOURS, SOURCE_FILES
from . import messages
from .acceptance_rules import LONGEST_FAILURE, MEASURED_SHARE, AcceptanceRules
from .decision import AcceptanceOutcome, MetreFigures
from .delivery import Delivery, Seal, SheetState
from .seen_ground import SeenGround, numbers_in, unseen_seams

_NAMED = 3  # layers that a sentence names
COMPARED_SETTINGS = ("wavelet", "levels", "density", "piece_m", "corridor_m", "seams", "version")
"""What makes figures of one layer differ from those of another."""

Doubt = tuple[Message, Message]  # why a delivery can't be accepted as it is given, and what would decide it
_Named = tuple[Sequence[str], "Callable[..., Message]", Message]


def against_any(delivery: Delivery) -> Iterator[Doubt]:
    """Why nothing is decided: what was measured is not, or not only, what is given."""
    files = delivery.files
    for layer in delivery.layers:
        if shift := numbers_in(layer.settings.get("mosaic_shift", "")):
            yield messages.MOSAIC_DISPLACED(name=layer.name, east=shift[0], north=shift[1]), messages.WOULD_PLACE
    yield from _doubts(
        (files.not_scanned, messages.DOUBT_NOT_SCANNED, messages.WOULD_SCAN_AGAIN),
        (files.changed, messages.DOUBT_FILES_CHANGED, messages.WOULD_SCAN_AGAIN),
        (files.layers_of_others, messages.DOUBT_OF_OTHERS, messages.WOULD_GIVE_MOSAICS),
        (() if delivery.is_part else files.twice, messages.DOUBT_SCANNED_TWICE, messages.WOULD_LEAVE_OUT),
    )


def unsealed(delivery: Delivery) -> Iterator[Doubt]:
    """Layers that are not as their scan left them."""
    changed, missing = (
        [layer.name for layer in delivery.layers if layer.seal is seal] for seal in (Seal.BROKEN, Seal.MISSING)
    )
    yield from _doubts(
        (changed, messages.DOUBT_LAYERS_CHANGED, messages.WOULD_GIVE_LAYER),
        (missing, messages.DOUBT_WITHOUT_SEAL, messages.WOULD_GIVE_LAYER),
    )


def lacking(
    delivery: Delivery, whole: MetreFigures, sheets: Sequence[MetreFigures], rules: AcceptanceRules,
    by_rules: AcceptanceOutcome,
) -> Iterator[Doubt]:
    """What is missing of the delivery, or nobody has looked at, so that it can't be accepted; ``sheets``: that were to
    be measured; ``by_rules``: what the rules alone say."""
    yield from _doubts((delivery.files.gone, messages.DOUBT_FILES_GONE, messages.WOULD_SCAN_AGAIN))
    if delivery.lacking_m:
        yield messages.SEAMS_LACK(metres=delivery.lacking_m), messages.WOULD_GIVE_LAYER
    for layer in delivery.layers:
        if names := layer.settings.get("may_be_copies"):
            yield messages.SOURCES_ARE_MOSAIC(names=names), messages.WOULD_GIVE_ORIGINALS
        if metres := SeenGround((layer.settings,)).total("mixed_metres"):
            names = _first_names(layer.settings.get("mixed_sources", "").split(", "))
            yield messages.SOURCES_HOLD_MOSAIC(metres=metres, names=names), messages.WOULD_GIVE_ORIGINALS
    is_open = by_rules is AcceptanceOutcome.UNDECIDED
    yield from _without_orthoimages(delivery, whole, rules.limit(MEASURED_SHARE) or 0.0, is_open)
    yield from ((reason, messages.WOULD_GIVE_SEAMS) for reason in unseen_seams(delivery, whole, rules))
    yield from _not_looked_at(delivery, sheets, rules)
    for layer in delivery.layers:
        if unread := SeenGround((layer.settings,)).most("unread"):
            place = layer.settings.get("unread_at", "")
            yield messages.MOSAIC_PARTLY_READ(name=layer.name, share=unread, place=place), messages.WOULD_SEE_SHEETS


def _without_orthoimages(
    delivery: Delivery, whole: MetreFigures, least: float, is_open: bool
) -> Iterator[Doubt]:
    """Why too little was measured where orthoimages lack; those that are named come first."""
    border = SeenGround.of_delivery(delivery).total("unexplained_border")
    seen, advice = whole.measured_m / ((whole.judged_m + border) or 1.0), messages.WOULD_GIVE_ORTHOIMAGES
    if delivery.not_given and (is_open or seen < least):
        yield messages.SOURCES_LACK(names=_first_names(delivery.not_given)), advice
    for layer in delivery.layers:
        ground = SeenGround((layer.settings,))
        if (share := ground.most("unexplained")) > 1 - least:
            place = ground.place("unexplained_at", "unexplained") or "-"
            yield messages.MOSAIC_LACKS(name=layer.name, share=share, limit=1 - least, place=place), advice
    if border and seen < least:
        yield messages.SEAMS_UNSEEN(metres=border, value=seen, limit=least), advice


def _not_looked_at(
    delivery: Delivery, sheets: Sequence[MetreFigures], rules: AcceptanceRules
) -> Iterator[Doubt]:
    """Sheets that were not measured, or are not in the mosaic that was."""
    # One scan of many sheets may leave a corner of one: what may be lost without a break.
    most = (rules.limit(LONGEST_FAILURE) or 0.0) if delivery.outlines else 0.0
    blank = [layer.name for layer in delivery.layers if layer.is_blank]
    if not delivery.is_part and any(sheet.measured_m for sheet in sheets):
        blank += [sheet.name for sheet in sheets if sheet.judged_m > most and not sheet.measured_m]
    left_out, damaged, overlapping = (
        [sheet.name for sheet in delivery.outlines if sheet.state is state]
        for state in (SheetState.LEFT_OUT, SheetState.DAMAGED, SheetState.OVERLAPS)
    )
    yield from _doubts(
        (blank, messages.DOUBT_NOT_MEASURED, messages.WOULD_SEE_SHEETS),
        (left_out, messages.DOUBT_LEFT_OUT, messages.WOULD_SEE_SHEETS),
        (damaged, messages.DOUBT_DAMAGED, messages.WOULD_SEE_SHEETS),
        (overlapping, messages.DOUBT_OVERLAP, messages.WOULD_SEE_SHEETS),
    )


def _doubts(*named: _Named) -> Iterator[Doubt]:
    """A doubt for each reason that names something."""
    for names, reason, advice in named:
        if names:
            yield reason(count=len(names), names=_first_names(names)), advice


def layer_sentences(delivery: Delivery) -> Iterator[Message]:
    """Whether layers are as their scan left them, what they are of, and whether they were measured alike."""
    layers = delivery.layers
    if layers and all(layer.seal is Seal.WHOLE for layer in layers):
        yield messages.LAYERS_SEALED(count=len(layers))
    yield from _files(delivery)
    if names := [layer.name for layer in layers if "unexplained" not in layer.settings]:
        yield messages.SEAMS_ELSEWHERE_UNKNOWN(names=_first_names(names))
    for layer in layers:
        if (looked_at := SeenGround((layer.settings,)).looked_at) < 1:
            yield messages.SCAN_PARTLY(name=layer.name, share=looked_at)
    if names := [layer.name for layer in layers if layer.settings.get("seams") == "found"]:
        yield messages.SEAMS_FOUND(name=_first_names(names))
    if names := [layer.name for layer in layers if layer.settings.get("seams") == "given"]:
        yield messages.SEAMS_GIVEN(name=_first_names(names))
    for name in dict.fromkeys(name for layer in layers for name in layer.settings):
        values = list(dict.fromkeys(layer.settings[name] for layer in layers if name in layer.settings))
        if len(values) > 1 and name in COMPARED_SETTINGS:
            yield messages.SETTINGS_DIFFER(setting=name, values=_first_names(values))


def _files(delivery: Delivery) -> Iterator[Message]:
    files, settings = delivery.files, [layer.settings for layer in delivery.layers]
    if files.mosaics > 1:
        yield messages.OF_MOSAICS(count=files.mosaics)
    alone = [scan for scan in settings if MOSAIC_FILES in scan and NEIGHBOURS not in scan]
    if (apart := len({scan[MOSAIC_FILES] for scan in alone})) > 1:
        yield messages.SCANNED_APART(count=apart)
    if files.gone_sources:
        yield messages.SOURCES_GONE(count=len(files.gone_sources), names=_first_names(files.gone_sources))
    if any(states_in(scan.get(SOURCE_FILES, "")) for scan in settings):
        yield messages.SOURCES_BELIEVED()


def _first_names(names: Sequence[str]) -> str:
    return ", ".join(names[:_NAMED]) + (" ..." if len(names) > _NAMED else "")
