"""The columns of the edges that the first picture of a drawing needs, stored with the drawing.

A worker process makes them when it reads a drawing with many edges.  They are a document, which is
made again for a request if it is missing.
"""

from __future__ import annotations

import logging
from typing import Final

from sqlalchemy.exc import SQLAlchemyError

from knifetip.service.components import Service
from knifetip.service.database.tables import Drawing
from knifetip.service.processes.readings import Reading

KIND: Final = "drawn-edges"  #: kind of the document

_log = logging.getLogger("knifetip.api")


def document_version(row: Drawing) -> str:
    """Return the version of the document of a drawing."""
    return f"{row.version}-drawn"


def keep_first_picture(service: Service, row: Drawing, reading: Reading) -> None:
    """Store the columns of a drawing that has just been read and stored.

    If they cannot be stored, the drawing is complete without them.
    """
    if not reading.drawn_edges:
        return
    try:
        service.store.documents.keep(row, KIND, document_version(row), reading.drawn_edges)
    except SQLAlchemyError as error:
        _log.warning("the columns of a first picture were not stored: %s", error)
