"""What the desk does with suggestions: it takes them as long as the operator leaves the choice to it."""
from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from qgis.core import QgsProject
from qgis.PyQt.QtCore import QObject

from .likely_layers import with_likely_mosaic, with_likely_vectors
from .project_inputs import Inputs, load_inputs
from .source_suggestions import Sources, SourceSuggestions

if TYPE_CHECKING:
    from ..session import Session


class Suggesting(QObject):
    """Sets mosaic, sources and seamlines that the operator has not chosen."""

    def __init__(self, session: Session, parent: QObject) -> None:
        super().__init__(parent)
        self._session = session
        self.sources = SourceSuggestions(self)
        """Which rasters are suggested, and why the others are not."""
        self.sources.changed.connect(self.follow)
        self._suggested: Sources = ()  # when it was looked last
        self._mosaic = ""  # for which
        self._set: Sources | None = None  # the very tuple that was set here: what others set is theirs, and stays
        self.forget_choices()

    def forget_choices(self) -> None:
        """Another project, in which the operator has chosen nothing."""
        self._is_mosaic_chosen = self._are_seamlines_chosen = False

    def follow(self) -> None:
        """Inputs, layers or suggestions may be others: sources that were set here become what is suggested now."""
        inputs, project = self._session.inputs, QgsProject.instance()
        is_same = inputs.mosaic == self._mosaic
        self._note(inputs.mosaic)
        if project.mapLayer(inputs.mosaic) is None or not is_same or not self._is_ours(inputs):
            return
        missing = tuple(source for source in inputs.sources if project.mapLayer(source) is None)
        is_index_enough = not inputs.sources and bool(inputs.source_index)
        if not is_index_enough and set(inputs.sources).difference(missing) != set(self._suggested):
            self._set_inputs(replace(inputs, sources=(*missing, *self._suggested)))

    def choose_mosaic(self, layer_id: str) -> None:
        """The operator's choice. Another mosaic of the same block keeps its sources, a new block gets the suggested."""
        inputs = self._session.inputs
        if layer_id == inputs.mosaic:
            return
        self._is_mosaic_chosen = True
        self._note(layer_id)
        kept = tuple(source for source in inputs.sources if source != layer_id)
        is_kept = not layer_id or bool(set(kept) & set(self._suggested))
        chosen = replace(inputs, mosaic=layer_id, sources=kept if is_kept else self._suggested)
        if is_kept and not self._is_ours(inputs):
            self._session.set_inputs(chosen)
        else:
            self._set_inputs(chosen)
        self.suggest_layers()

    def choose_seamlines(self, layer_id: str) -> None:
        """The operator's choice."""
        self._are_seamlines_chosen = True
        self._session.set_inputs(replace(self._session.inputs, seamlines=layer_id))

    def take_suggested(self) -> None:
        """The operator wants the suggested sources."""
        self._note(self._session.inputs.mosaic)
        self._set_inputs(replace(self._session.inputs, sources=self._suggested))

    def suggest_layers(self) -> None:
        """Mosaic and seamlines where the project has one candidate each, and the operator has said nothing of them."""
        inputs = self._session.inputs
        if load_inputs(QgsProject.instance()) != inputs:  # a project is just being read
            return
        found = inputs if self._is_mosaic_chosen else with_likely_mosaic(inputs)
        if found.mosaic != inputs.mosaic:
            self._note(found.mosaic)
            found = replace(found, sources=self._suggested)
            self._set = found.sources
        if not self._are_seamlines_chosen:
            found = with_likely_vectors(found)
        if found != inputs:
            self._session.set_inputs(found)

    def _is_ours(self, inputs: Inputs) -> bool:
        """By identity: the same sources set by the operator, the project or a script are theirs."""
        return inputs.sources is self._set

    def _set_inputs(self, inputs: Inputs) -> None:
        self._set = inputs.sources
        self._session.set_inputs(inputs)

    def _note(self, mosaic_id: str) -> None:
        self.sources.follow(mosaic_id)
        self._suggested, self._mosaic = self.sources.suggested(), mosaic_id
