"""The documents about drawings: JSON, edges, reports, blanks, picture, pages."""

from __future__ import annotations

from collections.abc import Callable

from knifetip.service.components import Service
from knifetip.service.database.tables import Drawing
from knifetip.service.documents.responses import LARGE, Document
from knifetip.service.drawings import document_tasks, first_picture
from knifetip.service.drawings.requests import drawing_fields, profile_state
from knifetip.service.http.revisions import revision_tag


def drawing_document(service: Service) -> Document[Drawing]:
    """Return the document with a drawing (schema ``DrawingOut``)."""

    def version(row: Drawing) -> str:
        return revision_tag(row.version, profile_state(service, row))

    def arguments(row: Drawing) -> tuple[object, ...]:
        return drawing_fields(row, profile_state(service, row)), row.import_report

    return Document(
        kind="drawing",
        read=service.store.drawings.get_with,
        columns=("import_report",),
        version=version,
        is_large=_is_large,
        task=document_tasks.drawing,
        arguments=arguments,
    )


def edges_document(service: Service) -> Document[Drawing]:
    """Return the document with the edges of a drawing (schema ``EdgesOut``)."""
    return Document(
        kind="edges",
        read=service.store.drawings.get_with,
        columns=("edges",),
        version=_version,
        is_large=_is_large,
        task=document_tasks.edges,
        arguments=_edges,
    )


def drawn_edges_document(service: Service) -> Document[Drawing]:
    """Return the document with the columns that a picture of the edges needs."""
    return Document(
        kind=first_picture.KIND,
        read=service.store.drawings.get_with,
        columns=("edges",),
        version=first_picture.document_version,
        is_large=_is_large,
        task=document_tasks.drawn_edges,
        arguments=_edges,
        media="application/octet-stream",
    )


def import_report_document(service: Service, outcome: str | None) -> Document[Drawing]:
    """Return the document with an import report (schema ``ImportReportOut``).

    Parameters
    ----------
    outcome
        Outcome of the rows in the document; None for all rows.
    """
    return Document(
        kind=f"import-report-{outcome or 'all'}",
        read=service.store.drawings.get_with,
        columns=("import_report",),
        version=_version,
        is_large=_is_large,
        task=document_tasks.import_report,
        arguments=lambda row: (row.summary["import_report"], row.import_report, outcome),
    )


def cleaning_document(service: Service) -> Document[Drawing]:
    """Return the document with the cleaning report of a drawing (schema ``CleaningOut``)."""
    return _cleaned_document(service, "cleaning", document_tasks.cleaning_json)


def blanks_document(service: Service) -> Document[Drawing]:
    """Return the document with the blanks of a drawing (schema ``BlanksOut``)."""
    return _cleaned_document(service, "blanks", document_tasks.blanks)


def _cleaned_document(service: Service, kind: str, task: Callable[..., bytes]) -> Document[Drawing]:
    """Return a document for which a worker process cleans the edges of a drawing."""
    return Document(
        kind=kind,
        read=service.store.drawings.get_with,
        columns=("edges",),
        version=_version,
        is_large=_is_large,
        task=task,
        arguments=_edges,
        calculates=True,
    )


def picture_document(service: Service) -> Document[Drawing]:
    """Return the document with a small picture of a drawing, as SVG."""
    return Document(
        kind="picture",
        read=service.store.drawings.get_with,
        columns=("edges",),
        version=lambda row: f"{row.version}-picture",
        is_large=_is_large,
        task=document_tasks.picture,
        arguments=_edges,
        media="image/svg+xml",
    )


def pages_document(service: Service) -> Document[Drawing]:
    """Return the document with the pages of the file of a drawing (a list of ``PageOut``).

    It is made once, since the file of a drawing never changes.
    """
    return Document(
        kind="pages",
        read=service.store.drawings.get_with,
        columns=("content",),
        version=lambda row: f"{row.sha256}-pages",
        # Reading all pages takes long, however few edges the drawing has.
        is_large=lambda _: True,
        task=document_tasks.pages,
        arguments=lambda row: (row.content,),
    )


def _edges(row: Drawing) -> tuple[object, ...]:
    return (row.edges,)


def _version(row: Drawing) -> str:
    return str(row.version)


def _is_large(row: Drawing) -> bool:
    entities = sum(map(int, row.summary["import_report"].values()))
    return max(int(row.summary["segments"]), entities) >= LARGE
