"""Export of jobs and drawings: one zip file with everything that is stored about each (ADR 84)."""

from __future__ import annotations

import io
import logging
import secrets
import zipfile
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, Final

from fastapi import Response
from pydantic import TypeAdapter

from knifetip.errors import ContentLost, NotFound, WrongState
from knifetip.service.components import ServiceDep
from knifetip.service.database.disk_sync import sync
from knifetip.service.drawings.requests import summary_out
from knifetip.service.http.conditional import NOT_MODIFIED
from knifetip.service.http.downloads import bytes_response, file_name
from knifetip.service.http.parameters import JobId
from knifetip.service.http.routing import ScopedRouter, requires
from knifetip.service.http.scopes import AccessScope
from knifetip.service.orders.job_answers import job_events, job_out
from knifetip.service.orders.models import JobEvent
from knifetip.service.orders.verdict import verdict_out
from knifetip.service.store import Store

router = ScopedRouter(prefix="/jobs", tags=["jobs"])

_ZIP: Final[dict[str, Any]] = {
    "content": {"application/zip": {"schema": {"type": "string", "format": "binary"}}}
}
# Files of a zip have a time; without one the same job gives the same bytes.
_TIME: Final = (1980, 1, 1, 0, 0, 0)
_log = logging.getLogger("knifetip.api")


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
    return _zip(files)


def _zip(files: Mapping[str, bytes]) -> bytes:
    archive = io.BytesIO()
    with zipfile.ZipFile(archive, "w", zipfile.ZIP_DEFLATED) as opened:
        for name, content in files.items():
            opened.writestr(zipfile.ZipInfo(name, _TIME), content, zipfile.ZIP_DEFLATED)
    return archive.getvalue()


def archive_jobs(store: Store, folder: Path, ids: Sequence[str]) -> list[str]:
    """Write the zip files of jobs to a folder, each whole or not at all; wait for the disk.

    Several servers may archive the same jobs into one folder at a time.

    Returns
    -------
    list of str
        The ids of the archived jobs.  Another server may have deleted a job meanwhile, and a job
        whose program or drawing is lost is not archived.

    Raises
    ------
    OSError
        The folder cannot be written.
    StoreError
        The folder or the bucket with large values cannot be read.
    """
    folder.mkdir(parents=True, exist_ok=True)
    archived = []
    for id in ids:
        try:
            content = job_archive(store, id)
        except NotFound:
            continue
        except ContentLost as reason:
            _log.error("job %s is neither archived nor deleted: %s", id, reason)
            continue
        _write(folder / f"{id}.zip", content)
        archived.append(id)
    sync(folder)
    return archived


def archive_drawing(store: Store, folder: Path, id: str) -> None:
    """Write the file drawing-ID.zip, with a drawing and its JSON, to a folder; wait for the disk.

    Raises
    ------
    NotFound
        There is no drawing with this id.
    OSError
        The folder cannot be written.
    StoreError
        The file of the drawing is lost, or cannot be read at present.
    """
    row = store.drawings.get_with(id, "content")
    files = {
        "drawing.json": summary_out(row).model_dump_json(indent=2).encode(),
        f"drawing-{file_name(row.name)}": row.content,
    }
    folder.mkdir(parents=True, exist_ok=True)
    _write(folder / f"drawing-{id}.zip", _zip(files))
    sync(folder)


def _write(file: Path, content: bytes) -> None:
    """Write a file whole or not at all; another server may write it at the same time."""
    part = file.with_name(f"{file.name}.{secrets.token_hex(4)}.part")
    try:
        part.write_bytes(content)
        sync(part)
        part.replace(file)
    except OSError:
        part.unlink(missing_ok=True)
        raise


@router.get("/{id}/export", response_class=Response, responses={200: _ZIP, **NOT_MODIFIED})
@requires(AccessScope.VIEWER)
def export_job(service: ServiceDep, id: JobId) -> Response:
    """Download a zip file with the job: JSON, events, drawing, program and verdict."""
    content = job_archive(service.store, id)
    row = service.store.jobs.get(id)
    return bytes_response(content, f"{row.epoch}-{row.updated}", "application/zip", f"{id}.zip")
