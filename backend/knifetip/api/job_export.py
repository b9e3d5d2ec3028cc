"""Export of a job: one zip file with everything that the server has stored about it (ADR 84)."""

from __future__ import annotations

import io
import zipfile
from collections.abc import Sequence
from pathlib import Path
from typing import Any, Final

from fastapi import Request, Response
from pydantic import TypeAdapter

from knifetip.api.job_models import job_events, job_out
from knifetip.api.parameters import JobId
from knifetip.api.routing import ScopedRouter, requires
from knifetip.api.schemas.jobs import JobEvent
from knifetip.api.service import ServiceDep, bytes_response, file_name
from knifetip.api.verdict_model import verdict_out
from knifetip.errors import WrongState
from knifetip.jobs.accounts.scopes import AccessScope
from knifetip.jobs.store import Store

router = ScopedRouter(prefix="/jobs", tags=["jobs"])

_ZIP: Final[dict[str, Any]] = {
    "content": {"application/zip": {"schema": {"type": "string", "format": "binary"}}}
}
# Files of a zip have a time; without one the same job gives the same bytes.
_TIME: Final = (1980, 1, 1, 0, 0, 0)


def job_archive(store: Store, id: str) -> bytes:
    """Return a zip file with a job: its JSON, events, drawing, program and verdict.

    A job that was not compiled has neither program nor verdict.

    Raises
    ------
    NotFound
        There is no job with this id.
    """
    row = store.jobs.get(id)
    events = TypeAdapter(list[JobEvent]).dump_json(job_events(store, id), indent=2)
    files = {
        "job.json": job_out(store, row).model_dump_json(indent=2).encode(),
        "events.json": events,
        f"drawing-{file_name(row.drawing_name)}": store.drawings.column(row.drawing, "content"),
    }
    for column in ("program", "verdict"):
        try:
            content = store.jobs.column(id, column)
        except WrongState:
            continue
        if column == "program":
            files["program.txt"] = content
        else:
            files["verdict.json"] = verdict_out(content).model_dump_json().encode()
    archive = io.BytesIO()
    with zipfile.ZipFile(archive, "w", zipfile.ZIP_DEFLATED) as opened:
        for name, content in files.items():
            opened.writestr(zipfile.ZipInfo(name, _TIME), content, zipfile.ZIP_DEFLATED)
    return archive.getvalue()


def archive_jobs(store: Store, folder: Path, ids: Sequence[str]) -> None:
    """Write the zip files of jobs to a folder, each whole or not at all.

    Raises
    ------
    OSError
        The folder cannot be written.
    """
    folder.mkdir(parents=True, exist_ok=True)
    for id in ids:
        part = folder / f"{id}.part"
        part.write_bytes(job_archive(store, id))
        part.replace(folder / f"{id}.zip")


@router.get("/{id}/export", response_class=Response, responses={200: _ZIP})
@requires(AccessScope.VIEWER)
def export_job(service: ServiceDep, request: Request, id: JobId) -> Response:
    """Download a zip file with the job: JSON, events, drawing, program and verdict."""
    content = job_archive(service.store, id)
    row = service.store.jobs.get(id)
    return bytes_response(
        request, content, f"{row.epoch}-{row.updated}", "application/zip", f"{id}.zip"
    )
