"""The choices of a user for edges of the drawing, as columns that planner and verifier look up.

An option that is a tuple of ``LineTypeChoice`` gets here from its declaration in ``job_options``,
so planning (``Setup.chosen``) and verification (``CheckContext.chosen``) have it without more code.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final, TypeAlias, get_args

import numpy as np

from knifetip.errors import PlanError
from knifetip.geometry.columns import F64, I32, Bool
from knifetip.model.cleaned import Cleaned
from knifetip.model.dieline import Dieline
from knifetip.model.edge_choice import LineTypeChoice, choices_by_edge
from knifetip.model.job_options import VerifiedOptions


@dataclass(frozen=True, eq=False, slots=True)
class ChosenEdges:
    """What is chosen for each of n edges by one option."""

    choices: tuple[LineTypeChoice, ...]  #: choices with different values
    index: I32  #: (n,) index of the choice of each edge; -1 for none

    @property
    def chosen(self) -> Bool:
        """Mask of the edges with a choice, (n,)."""
        result: Bool = self.index >= 0
        return result

    def numbers(self, field: str, usual: float) -> F64:
        """Return a field of the choice of each edge, (n,).

        The value is ``usual`` for an edge without a choice, or whose choice leaves the field open.
        """
        given = [getattr(choice, field) for choice in self.choices]
        values = np.array([usual if one is None else one for one in given] + [usual], np.float64)
        return values[self.index]

    def on_cleaned(self, cleaned: Cleaned) -> ChosenEdges:
        """Convert the choices for drawn edges to choices for the cleaned edges that replace them.

        Raises
        ------
        PlanError
            Cleaning joined drawn edges with different choices to one edge.
        """
        parts = cleaned.stretches
        made = parts.cleaned >= 0
        row, target = parts.row[made], parts.cleaned[made]
        # An edge on which another one lies has the choice of the other, unless it has its own.
        counts = self.chosen[row] | ~parts.by_other_edge[made]
        row, target = row[counts], target[counts]
        count = len(cleaned.dieline)
        low, high = np.full(count, len(self.choices), np.int32), np.full(count, -1, np.int32)
        np.minimum.at(low, target, self.index[row])
        np.maximum.at(high, target, self.index[row])
        for joined in np.flatnonzero((low < len(self.choices)) & (low != high))[:1]:
            rows = np.unique(row[target == joined])
            raise PlanError("edge-choice.joined", edge=rows[0], other=rows[-1], at_edges=rows)
        return ChosenEdges(self.choices, high)


#: What is chosen for edges, by the class of the choices; without options that are not used.
ChosenWork: TypeAlias = Mapping[type[LineTypeChoice], ChosenEdges]
NOTHING_CHOSEN: Final[ChosenWork] = {}


def chosen_work(options: VerifiedOptions, dieline: Dieline) -> ChosenWork:
    """Return what a user has chosen for the edges of a drawing by options of a job.

    Raises
    ------
    PlanError
        The drawing has no such edge.
    """
    result = {}
    for name, field in type(options).model_fields.items():
        for kind in get_args(field.annotation):
            if isinstance(kind, type) and issubclass(kind, LineTypeChoice):
                choices: tuple[LineTypeChoice, ...] = getattr(options, name)
                if choices:
                    result[kind] = _chosen_edges(choices, dieline)
    return result


def work_on_cleaned(work: ChosenWork, cleaned: Cleaned) -> ChosenWork:
    """Convert choices for drawn edges to those for cleaned ones; see ``ChosenEdges.on_cleaned``."""
    return {kind: chosen.on_cleaned(cleaned) for kind, chosen in work.items()}


def _chosen_edges(choices: tuple[LineTypeChoice, ...], dieline: Dieline) -> ChosenEdges:
    """Return what one option chooses for the edges of a drawing."""
    index = np.full(len(dieline), -1, np.int32)
    distinct: dict[str, tuple[int, LineTypeChoice]] = {}
    for row, choice in choices_by_edge(choices, dieline.line_type):
        key = choice.model_dump_json(exclude={"edges", "line_type"}, exclude_defaults=True)
        # A choice that leaves all fields open is none.
        if key != "{}":
            index[row] = distinct.setdefault(key, (len(distinct), choice))[0]
    return ChosenEdges(tuple(choice for _, choice in distinct.values()), index)
