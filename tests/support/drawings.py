"""Drawings from edges and their styles, as a reader of files returns them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from knifetip.messages import render
from knifetip.messages.message import Message
from knifetip.model.drawing import KEPT, Annotation, Drawing, ImportReport

#: Layer, AutoCAD colour index and linetype of an edge.
Style: TypeAlias = tuple[str, int, str]


@dataclass(frozen=True)
class Header:
    """What a file contains beside its entities."""

    unit: str = "mm"  #: of the coordinates; empty where it is still to be found
    stated: str = ""  #: the unit that the file's header names
    texts: tuple[Annotation, ...] = ()
    layers: tuple[str, ...] = ()  #: of the table, with those that no edge uses
    linetypes: tuple[str, ...] = ()  #: likewise


def drawing(
    ends: ArrayLike,
    styles: Sequence[Style],
    *,
    bulge: ArrayLike | None = None,
    true_colour: ArrayLike | None = None,
    kinds: Sequence[str] | None = None,
    header: Header | None = None,
) -> Drawing:
    """Return a drawing in which every edge is an entity of its own.

    Parameters
    ----------
    ends : (n, 2, 2)
        In mm, or in file units where the header has no unit.
    styles : (n,)
        Layers and linetypes that the header does not list follow in order of appearance.
    bulge : (n,), optional
        All edges are straight without it.
    true_colour : (n,), optional
        0xRRGGBB, -1 for none.
    kinds : (n,), optional
        Entity types; LINE and ARC by the bulge without it.
    """
    header = header or Header()
    count = len(styles)
    bend = np.zeros(count) if bulge is None else np.asarray(bulge, np.float64)
    names = [style[0] for style in styles]
    layers = {name: number for number, name in enumerate(dict.fromkeys([*header.layers, *names]))}
    types = [style[2] for style in styles]
    linetypes = {
        name: number for number, name in enumerate(dict.fromkeys([*header.linetypes, *types]))
    }
    import_report = ImportReport(
        tuple(f"{row:X}" for row in range(count)),
        tuple(kinds or ("ARC" if each else "LINE" for each in bend.tolist())),
        tuple(names),
        np.zeros(count, np.uint8),
        (KEPT,) * count,
        np.ones(count),
    )
    return Drawing(
        np.asarray(ends, np.float64).reshape(-1, 2, 2),
        bend,
        np.arange(count, dtype=np.int32),
        np.array([layers[name] for name in names], np.int32),
        np.array([style[1] for style in styles], np.int32),
        np.full(count, -1, np.int32) if true_colour is None else np.asarray(true_colour, np.int32),
        np.array([linetypes[name] for name in types], np.int32),
        tuple(layers),
        tuple(linetypes),
        import_report,
        header.unit,
        Message("unit.given" if header.unit else "unit.header-missing"),
        header.stated,
        header.texts,
    )


def report_reasons(drawing: Drawing) -> tuple[str, ...]:
    """The reason of each row of the import report, in English."""
    return tuple(map(render, drawing.import_report.reason))
