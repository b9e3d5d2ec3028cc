"""Options ``--layer`` and ``--edge``, with which a user sets the line types of edges."""

from __future__ import annotations

import re
from typing import Annotated, Final

import numpy as np
import typer

from knifetip.errors import LibraryError
from knifetip.geometry.columns import U8
from knifetip.model.dieline import LineType
from knifetip.model.drawing import Drawing
from knifetip.model.interpretation import NO_OVERRIDE

Layers = Annotated[
    list[str] | None,
    typer.Option(
        "--layer",
        metavar="NAME=TYPE",
        help="Give all edges on a layer a line type, such as FOLD=crease; may be repeated.",
    ),
]
Edges = Annotated[
    list[str] | None,
    typer.Option(
        "--edge",
        metavar="EDGE=TYPE",
        help="Give an edge (row of the drawing, as in the finding) a line type, such as "
        "12=ignored; several edges are separated by commas. May be repeated. Overrides --layer.",
    ),
]

_ROWS: Final = re.compile(r"\d{1,9}(?:,\d{1,9})*", re.ASCII)


def overrides(drawing: Drawing, file: str, layers: list[str] | None, edges: list[str] | None) -> U8:
    """Return ``NO_OVERRIDE`` or the line type that an option sets, for each edge of a drawing.

    Parameters
    ----------
    drawing
        Drawing with n edges.
    file
        Name of its file, for errors.
    layers
        Line types of layers, each as ``NAME=TYPE``; None for none.
    edges
        Line types of edges, each as ``ROW,ROW=TYPE``; None for none.

    Returns
    -------
    (n,) uint8

    Raises
    ------
    LibraryError
        An option has another form, or there is no such layer, edge or line type.
    """
    set_by_user = np.full(len(drawing), NO_OVERRIDE, np.uint8)
    for pair in layers or []:
        name, kind = _split(pair, "command.bad-layer")
        rows = [i for i, layer in enumerate(drawing.layers) if layer.casefold() == name.casefold()]
        if not rows:
            raise LibraryError(
                "command.no-such-layer",
                layer=name,
                file=file,
                layers=(repr(layer) for layer in drawing.layers),
            )
        set_by_user[np.isin(drawing.layer, rows)] = kind
    for pair in edges or []:
        listed, kind = _split(pair, "command.bad-edge")
        if not _ROWS.fullmatch(listed):
            raise LibraryError("command.bad-edge", pair=pair)
        for row in map(int, listed.split(",")):
            if row >= len(drawing):
                raise LibraryError("override.no-such-edge", edge=str(row), count=len(drawing))
            set_by_user[row] = kind
    return set_by_user


def _split(pair: str, malformed: str) -> tuple[str, LineType]:
    """Return the two sides of ``NAME=TYPE``; ``malformed`` is the error code for another form."""
    name, equals, word = pair.rpartition("=")
    if not equals:
        raise LibraryError(malformed, pair=pair)
    try:
        return name, LineType.from_word(word)
    except ValueError as reason:
        raise LibraryError(
            "command.bad-line-type", pair=pair, known=[kind.word for kind in LineType]
        ) from reason
