"""Deletion of old jobs and drawings, after an archive of them was written (ADR 84)."""

from __future__ import annotations

import asyncio
import logging
from functools import partial
from pathlib import Path
from typing import Final

from knifetip.service.components import Service
from knifetip.service.content.store import ContentStore
from knifetip.service.history.export import archive_drawing, archive_jobs
from knifetip.service.store import Store

_DAY: Final = 86_400.0
_PAUSE: Final = 3600.0  # seconds between two deletions
_log = logging.getLogger("knifetip.api")


async def run_retention(service: Service) -> None:
    """Delete old jobs and drawings once an hour; runs until its asyncio task is cancelled."""
    settings = service.settings
    while settings.keep_jobs > 0 or settings.keep_drawings > 0:
        try:
            await asyncio.to_thread(
                purge,
                service.store,
                settings.keep_jobs,
                settings.keep_drawings,
                settings.archive,
            )
        except Exception:
            _log.exception("old jobs and drawings were not deleted")
        await asyncio.sleep(_PAUSE)


async def run_content_sweep(contents: ContentStore) -> None:
    """Delete unused contents once a day; runs until its asyncio task is cancelled."""
    while True:
        try:
            deleted = await asyncio.to_thread(contents.sweep)
            if deleted:
                _log.info("deleted %d unused contents", deleted)
        except Exception:
            _log.exception("unused contents were not deleted")
        await asyncio.sleep(_DAY)


def purge(
    store: Store, keep_jobs: int, keep_drawings: int, archive: Path | None
) -> tuple[int, int]:
    """Delete old jobs and drawings; return their numbers.

    Interrupted jobs, jobs that have not ended, and drawings of stored jobs are kept.  Events,
    statistics and the audit log are kept too.

    Parameters
    ----------
    store
        The store.
    keep_jobs, keep_drawings
        Days after their end, or after their upload, for which they are kept; 0 for ever.
    archive
        Folder for a zip file of each job and each drawing before it is deleted; None for none.

    Raises
    ------
    OSError
        The archive cannot be written; the jobs and drawings that it lacks were not deleted.
    """
    now = store.database.clock()
    jobs = drawings = 0
    if keep_jobs > 0:
        save = None if archive is None else partial(archive_jobs, store, archive)
        jobs = store.history.delete_before(now - keep_jobs * _DAY, save)
    if keep_drawings > 0:
        keep = None if archive is None else partial(archive_drawing, store, archive)
        drawings = store.drawings.delete_unused_before(now - keep_drawings * _DAY, keep)
    if jobs or drawings:
        _log.info("deleted %d jobs and %d drawings", jobs, drawings)
    return jobs, drawings
