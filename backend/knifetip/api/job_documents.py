"""The document about a job: the verdict on its program."""

from __future__ import annotations

from knifetip.api import document_tasks
from knifetip.api.documents import LARGE, Document
from knifetip.api.service import Service
from knifetip.jobs.tables import Job


def verdict_document(service: Service) -> Document[Job]:
    """Return the document with the verdict on the program of a job (schema ``VerdictOut``)."""
    return Document(
        kind="verdict",
        read=service.store.jobs.get_with,
        columns=("verdict",),
        version=verdict_version,
        is_large=lambda row: row.lines >= LARGE,
        task=document_tasks.verdict,
        arguments=lambda row: (row.verdict,),
    )


def verdict_version(row: Job) -> str:
    """Return the version of a verdict, which changes when a shortfall is accepted."""
    return f"{row.program_sha256}-{(row.verdict_summary or {}).get('exceptions', 0)}"
