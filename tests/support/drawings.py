"""Build drawings from edges and styles, like those that a reader of files returns."""

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
    """Properties of a file other than its entities."""

    unit: str = "mm"  #: unit of the coordinates, "" if it is not determined yet
    stated: str = ""  #: the unit that the file's header names
    texts: tuple[Annotation, ...] = ()
    layers: tuple[str, ...] = ()  #: names in the layer table, including unused ones
    linetypes: tuple[str, ...] = ()  #: names in the linetype table, including unused ones


def drawing(
    ends: ArrayLike,
    styles: Sequence[Style],
    *,
    bulge: ArrayLike | None = None,
    true_colour: ArrayLike | None = None,
    kinds: Sequence[str] | None = None,
    header: Header | None = None,
    line_width: ArrayLike | None = None,
) -> Drawing:
    """Return a drawing in which every edge is an entity of its own.

    Parameters
    ----------
    ends : (n, 2, 2)
        In mm, or in file units if the header has no unit.
    styles : n styles
        Layer, colour and linetype of each edge.  Layers and linetypes that the header does not list
        are appended in order of appearance.
    bulge : (n,), optional
        Zero by default.
    true_colour : (n,), optional
        0xRRGGBB, -1 for none.
    kinds : n names, optional
        Entity types; by default LINE or ARC, depending on the bulge.
    line_width : (n,), optional
        1/100 mm; by default the file states none.
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
        line_width=np.asarray([] if line_width is None else line_width, np.int32),
    )


def report_reasons(drawing: Drawing) -> tuple[str, ...]:
    """Return the reason of each row of the import report as English text."""
    return tuple(map(render, drawing.import_report.reason))
