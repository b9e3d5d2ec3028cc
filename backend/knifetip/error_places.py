"""error_places: let errors of a compile name the edges of the drawing that they concern.

Planning and compensation know the cleaned edges at their position on the table, writing a program
the rows of the toolpath.  Users, the page and programs select edges by their rows in the drawing,
which may be parts of one object of the file.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Final

from knifetip.cleaning.map_back import DrawnRows
from knifetip.errors import MOST_EDGES, CompensationError, PlanError, ProgramError
from knifetip.messages import Message
from knifetip.model.cleaned import Cleaned
from knifetip.model.drawing import Drawing

#: Greatest number of edges that the text of an error lists.
_SHOWN: Final = 10


@contextmanager
def located_errors(
    drawing: Drawing, cleaned: Cleaned | None = None, offset: tuple[float, float] = (0.0, 0.0)
) -> Iterator[None]:
    """Return a context that adds to errors the drawn edges that they concern and positions on them.

    The rows of edges in ``error.edges`` and in the message become rows of the drawing, and
    ``error.source`` the handles of their entities.

    Parameters
    ----------
    cleaned
        The cleaned edges to which the rows in errors refer; None if they are rows of the drawing.
    offset
        Shift (x, y) in mm by which places in errors are away from those in the drawing.
    """
    try:
        yield
    except (PlanError, CompensationError, ProgramError) as error:
        message, rows = error.message, error.edges
        if cleaned is not None:
            drawn = DrawnRows(cleaned)
            message = message.located(drawn.first, (-offset[0], -offset[1]))
            rows = tuple(
                dict.fromkeys(row for one in error.edges for row in drawn.replaced_by(one))
            )
        error.message, error.edges = message, rows[:MOST_EDGES]
        if rows:
            handles, more = drawing.handles, len(rows) - _SHOWN
            error.source = tuple(dict.fromkeys(handles[row] for row in error.edges))
            error.message = Message(
                "error.at-edge",
                error=message,
                count=len(rows),
                edges=rows[:_SHOWN],
                more=Message("error.more-edges", count=more) if more > 0 else None,
                edge=rows[0],
                handle=handles[rows[0]],
                layer=drawing.layers[drawing.layer[rows[0]]],
            )
        raise
