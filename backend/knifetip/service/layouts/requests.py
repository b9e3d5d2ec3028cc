"""Functions that compose, store and return layouts; called by the routes for layouts.

A layout is stored as the drawing of its whole sheet, with the column ``layout``.
"""

from __future__ import annotations

import hashlib
from typing import Any

from knifetip.errors import StaleVersion, UnitUnknown, WrongState
from knifetip.layout.archive import LayoutArchive
from knifetip.messages import Message
from knifetip.model.interpretation import Interpretation
from knifetip.model.layout import Layout
from knifetip.service.components import Service
from knifetip.service.database.request_key import RequestKey
from knifetip.service.database.tables import Drawing
from knifetip.service.drawings.interpretations import drawing_columns
from knifetip.service.drawings.store import NewDrawing, unknown_drawing_error
from knifetip.service.http.times import rfc3339
from knifetip.service.layouts.models import LayoutOut, LayoutSummary
from knifetip.service.order_details.details import Details
from knifetip.service.order_details.models import details_fields
from knifetip.service.processes import layout_tasks
from knifetip.service.processes.readings import Reading


def store_layout(
    service: Service, name: str, layout: Layout, details: Details, key: RequestKey | None
) -> Drawing:
    """Compose and store a layout, or return the one that was stored with the same key.

    Parameters
    ----------
    service
        The server.
    name
        Name of the layout.
    layout
        The sheet and what is placed on it.
    details
        Columns of ``order_details``.
    key
        Key of the request, None if it has none.

    Raises
    ------
    NotFound
        There is no drawing with an id in the layout.
    StaleVersion
        A drawing has a later revision than the layout states.
    WrongState
        A placed drawing is itself a layout.
    UnitUnknown
        The unit of a placed drawing is not decided.
    """
    if key is not None and (earlier := service.store.drawings.find(key)) is not None:
        return earlier
    pinned, content, reading = _compose(service, layout)
    new = NewDrawing(
        name=name,
        content=content,
        sha256=hashlib.sha256(content).hexdigest(),
        interpretation=_interpretation(reading),
        summary=reading.summary,
        edges=reading.edges,
        import_report=reading.import_report,
        details=details,
        layout=pinned.model_dump(mode="json"),
    )
    return service.store.drawings.add(new, key)


def replace_layout(service: Service, row: Drawing, name: str | None, layout: Layout) -> Drawing:
    """Replace a layout by a new revision, and return it; for the errors see ``store_layout``.

    Parameters
    ----------
    service
        The server.
    row
        The layout on which the change is based.
    name
        New name; None to keep the name.
    layout
        The new sheet and what is placed on it.
    """
    pinned, content, reading = _compose(service, layout)
    return service.store.drawings.change(
        row.id,
        row.version,
        Message("layout.changed", count=pinned.count),
        **drawing_columns(_interpretation(reading)),
        name=row.name if name is None else name,
        sha256=hashlib.sha256(content).hexdigest(),
        content=content,
        summary=reading.summary,
        edges=reading.edges,
        import_report=reading.import_report,
        layout=pinned.model_dump(mode="json"),
    )


def _interpretation(reading: Reading) -> Interpretation:
    """Return the interpretation of a sheet, whose line types come from its drawings."""
    return Interpretation(unit="mm", overrides=reading.overrides)


def _compose(service: Service, layout: Layout) -> tuple[Layout, bytes, Reading]:
    """Return a layout with the revisions of its drawings, its file, and the composed sheet."""
    found: dict[str, Drawing] = {}
    for placed in layout.placed:
        if placed.drawing not in found:
            found[placed.drawing] = placed_drawing(service, placed.drawing)
        current = found[placed.drawing].version
        if placed.revision not in (None, current):
            raise StaleVersion(
                "layout.drawing-changed",
                drawing=placed.drawing,
                current=current,
                revision=placed.revision,
            )
    pinned = layout.model_copy(
        update={
            "placed": tuple(
                placed.model_copy(update={"revision": found[placed.drawing].version})
                for placed in layout.placed
            )
        }
    )
    archive = LayoutArchive.from_layout(pinned, [(id, row.edges) for id, row in found.items()])
    content = archive.pack()
    return pinned, content, service.run(layout_tasks.compose_sheet, content)


def placed_drawing(service: Service, id: str) -> Drawing:
    """Return a drawing that is to be placed, with its edges."""
    row = service.store.drawings.get_with(id, "edges")
    if row.layout is not None:
        raise WrongState("layout.of-layout", drawing=row.name)
    if not row.summary["unit"]:
        raise UnitUnknown("layout.no-unit", drawing=row.name)
    return row


def stored_layout(service: Service, id: str) -> Drawing:
    """Return the layout with an id; raise ``NotFound`` if there is none."""
    row = service.store.drawings.get(id)
    if row.layout is None:
        raise unknown_drawing_error(id)
    return row


def summary_out(row: Drawing) -> LayoutSummary:
    """Return the API model that describes a layout in lists of layouts."""
    return LayoutSummary(**_summary(row))


def layout_out(row: Drawing) -> LayoutOut:
    """Return the API model of a layout."""
    composed = row.summary["layout"]
    return LayoutOut(
        **_summary(row),
        placed=list(_layout(row).placed),
        copies=composed["copies"],
        overlaps=composed["overlaps"],
        off_sheet=composed["off_sheet"],
        open_questions=row.summary["questions"],
    )


def _layout(row: Drawing) -> Layout:
    return Layout.model_validate(row.layout)


def _summary(row: Drawing) -> dict[str, Any]:
    layout, composed = _layout(row), row.summary["layout"]
    return {
        **details_fields(row),
        "id": row.id,
        "revision": row.version,
        "name": row.name,
        "created": rfc3339(row.created),
        "updated": rfc3339(row.updated or row.created),
        "owner": row.owner,
        "shared": row.shared,
        "sheet": layout.sheet,
        "count": layout.count,
        "area": composed["area"],
        "use": composed["use"],
        "questions": len(row.summary["questions"]),
    }
