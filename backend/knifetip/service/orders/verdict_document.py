"""The document about a job: the verdict on its program."""

from __future__ import annotations

from knifetip.service.components import Service
from knifetip.service.database.tables import Job
from knifetip.service.documents.responses import LARGE, Document
from knifetip.service.orders.verdict import verdict


def verdict_document(service: Service) -> Document[Job]:
    """Return the document with the verdict on the program of a job (schema ``VerdictOut``)."""
    return Document(
        kind="verdict",
        read=service.store.jobs.get_with,
        columns=("verdict",),
        version=verdict_version,
        is_large=lambda row: row.lines >= LARGE,
        task=verdict,
        arguments=lambda row: (row.verdict,),
    )


def verdict_version(row: Job) -> str:
    """Return the version of a verdict, which changes when a shortfall is accepted."""
    return f"{row.program_sha256}-{(row.verdict_summary or {}).get('exceptions', 0)}"
