"""The documents about drawings: their JSON, edges, import report, cleaning report and picture."""

from __future__ import annotations

from knifetip.api import document_tasks
from knifetip.api.documents import LARGE, Document
from knifetip.api.drawing_requests import drawing_fields, profile_state
from knifetip.api.revisions import revision_tag
from knifetip.api.service import Service
from knifetip.jobs.tables import Drawing


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
    return Document(
        kind="cleaning",
        read=service.store.drawings.get_with,
        columns=("edges",),
        version=_version,
        is_large=_is_large,
        task=document_tasks.cleaning,
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


def _edges(row: Drawing) -> tuple[object, ...]:
    return (row.edges,)


def _version(row: Drawing) -> str:
    return str(row.version)


def _is_large(row: Drawing) -> bool:
    entities = sum(map(int, row.summary["import_report"].values()))
    return max(int(row.summary["segments"]), entities) >= LARGE
