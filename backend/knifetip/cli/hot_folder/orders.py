"""Processing of one file of a hot folder: moved, uploaded, ordered, and put beside its results.

A file is first moved to the folder ``working``.  Before the first request, a record with
the order and its keys is written there.  After a kill, each step is repeated with the same keys, so
that nothing is ordered twice, and no file is lost: it is in the folder, in ``working``, ``done`` or
``failed`` at every moment.
"""

from __future__ import annotations

import hashlib
import json
import os
import re
from contextlib import suppress
from dataclasses import asdict, dataclass, field
from pathlib import Path, PurePosixPath
from typing import Any, Final

from knifetip.cli.hot_folder.arrivals import SIDECAR, XJDF, XJDF_DOCUMENT
from knifetip.cli.hot_folder.beside import drawing_beside, find_beside, pack_order
from knifetip.cli.hot_folder.client import OrderClient, OrderRefused
from knifetip.errors import KnifetipError, RequestError
from knifetip.messages import printable

WORKING: Final = "working"
DONE: Final = "done"
FAILED: Final = "failed"
RECORD: Final = ".order.json"  #: suffix of the records in ``working``
DRAWING: Final = ".drawing"  #: suffix of the drawing of an order in XJDF, in ``working``
RESULT: Final = ".job.json"  #: suffix of the results
STATUS: Final = ".status.xjdf"  #: suffix of the job as XJDF, for an order in XJDF

#: Fields of a sidecar that belong to the drawing.
_OF_DRAWING: Final[tuple[str, ...]] = ("unit", "profile")
#: States of a job in which its program is accepted.
_ACCEPTED: Final = ("ready", "queued", "running", "held", "done", "interrupted", "continued")
#: Optional fields of an order in XJDF.
_OF_XJDF: Final = ("machine", "board", "profile", "release")
_UNFINISHED: Final = ("received", "compiling")
_LARGEST_SIDECAR: Final = 1 << 20
_SHOWN: Final = (
    *("id", "state", "drawing", "machine", "board", "copies", "external_id", "customer", "due"),
    *("reason", "hint", "seconds", "program_sha256", "verdict"),
)


@dataclass(slots=True)
class OrderRecord:
    """Stored state of a file that is being processed."""

    name: str
    key: str  #: from path, times and content of the file
    order: dict[str, Any]  #: fields of the job and of the drawing
    drawing: str = ""  #: id of the uploaded drawing; "" before
    job: str = ""  #: id of the job; "" before
    target: str = ""  #: name under which the file is put beside its results; "" before
    fault: dict[str, Any] = field(default_factory=dict)  #: why it failed, as in the results


class OrderFolder:
    """The orders of a hot folder, in its subfolders ``working``, ``done`` and ``failed``.

    Parameters
    ----------
    folder
        The folder into which users put drawings.
    defaults
        Fields of all orders, such as ``machine``; those of a sidecar replace them.
    client
        Client of the server.
    """

    def __init__(self, folder: Path, defaults: dict[str, Any], client: OrderClient) -> None:
        self._folder = folder
        self._defaults = defaults
        self._client = client
        for name in (WORKING, DONE, FAILED):
            (folder / name).mkdir(exist_ok=True)

    @property
    def _working(self) -> Path:
        return self._folder / WORKING

    def take(self, name: str) -> bool:
        """Move a complete file with its sidecar to ``working``; return whether that was possible.

        It is not possible while a file of the same name is being processed, or while another
        program has locked the file.
        """
        if os.path.lexists(self._working / name):
            return False
        sidecar = name + SIDECAR
        moved = False
        try:
            # A process that was killed may have left the record of a file that is done.
            (self._working / (name + RECORD)).unlink(missing_ok=True)
            # The sidecar first: without the drawing it orders nothing.
            if (self._folder / sidecar).exists():
                os.replace(self._folder / sidecar, self._working / sidecar)
                moved = True
            if drawing := self._drawing_of(self._folder / name):
                beside = find_beside(self._folder, drawing)
                # A process that was killed may have moved the drawing already.
                if beside is not None:
                    os.replace(beside, self._working / (name + DRAWING))
            os.replace(self._folder / name, self._working / name)
        except OSError:
            if moved:
                self._give_back(sidecar)
            return False
        return True

    def _give_back(self, sidecar: str) -> None:
        """Move a sidecar back to the folder, so that it belongs to no later drawing."""
        with suppress(OSError):
            if not os.path.lexists(self._folder / sidecar):
                os.replace(self._working / sidecar, self._folder / sidecar)

    @staticmethod
    def _drawing_of(path: Path) -> str:
        """Return the path in the folder of the drawing that an order in XJDF names; "" for none."""
        is_document = path.name.lower().endswith(XJDF_DOCUMENT)
        return drawing_beside(path.read_bytes()) if is_document else ""

    def in_progress(self) -> list[str]:
        """Return the names of the files in ``working``, also those of an earlier process."""
        return sorted(
            name
            for name in os.listdir(self._working)
            if not name.startswith(".")
            and not name.endswith((SIDECAR, DRAWING, ".new"))
            and (self._working / name).is_file()
        )

    def advance(self, name: str) -> str:
        """Do the next steps for a file in ``working``; return what was done, "" while it waits.

        Raises
        ------
        RetryLater
            The server does not answer; the step is repeated later.
        OSError
            A file cannot be read or written now.
        """
        record = self._load(name)
        try:
            if record is None:
                record = self._begin(name)
            if record.fault:
                self._put(record, FAILED, {RESULT: _json(record.fault)})
                return f"failed: {record.fault['reason']}"
            if not record.job:
                self._order(record)
                return f"ordered as job {record.job}"
            job = self._client.job(record.job)
            if job["state"] in _UNFINISHED:
                return ""
            self._finish(record, job)
        except KnifetipError as reason:
            record = record or OrderRecord(name, "", {})
            self._fail(record, reason)
            return f"failed: {reason.text}"
        accepted = job["state"] in _ACCEPTED
        return f"{job['state']}: {DONE}" if accepted else f"{job['state']}: {job['reason']}"

    def _begin(self, name: str) -> OrderRecord:
        path = self._working / name
        content = path.read_bytes()
        digest = hashlib.sha256(content).hexdigest()
        sidecar = self._working / (name + SIDECAR)
        fields = sidecar.read_bytes() if sidecar.exists() else b""
        drawing = self._working / (name + DRAWING)
        if drawing.exists():
            digest += hashlib.sha256(drawing.read_bytes()).hexdigest()
        # The time of the move to this folder is a part of the key: a drawing that is put into the
        # folder again, with the time of its last change, is another order.
        times = path.stat()
        stamp = "\0".join(
            (
                *(str(self._folder.resolve()), name),
                *(str(times.st_mtime_ns), str(times.st_ctime_ns), digest, ""),
            )
        )
        key = hashlib.sha256(os.fsencode(stamp) + fields).hexdigest()
        record = OrderRecord(name, f"watch-{key}", self._defaults | _sidecar_fields(fields))
        self._save(record)
        return record

    def _order(self, record: OrderRecord) -> None:
        if _is_xjdf(record.name):
            self._order_xjdf(record)
            return
        order = dict(record.order)
        if "drawing" in order:
            raise RequestError("watch.other-drawing")
        of_drawing = {name: str(order.pop(name)) for name in _OF_DRAWING if name in order}
        if not record.drawing:
            content = (self._working / record.name).read_bytes()
            record.drawing = self._client.upload(
                printable(record.name)[-200:], content, of_drawing, f"{record.key}-drawing"
            )
            self._save(record)
        record.job = self._client.order({"drawing": record.drawing, **order}, f"{record.key}-job")
        self._save(record)

    def _order_xjdf(self, record: OrderRecord) -> None:
        unknown = [name for name in record.order if name not in _OF_XJDF]
        if unknown:
            raise RequestError("watch.xjdf-fields", names=unknown, permitted=_OF_XJDF)
        path = self._working / record.name
        content = path.read_bytes()
        if name := self._drawing_of(path):
            drawing = self._working / (record.name + DRAWING)
            if not drawing.exists():
                raise RequestError("watch.no-drawing", name=name)
            content = pack_order(content, name, drawing.read_bytes())
        record.job, record.drawing = self._client.order_xjdf(
            content, record.order, f"{record.key}-job"
        )
        self._save(record)

    def _finish(self, record: OrderRecord, job: dict[str, Any]) -> None:
        result = {name: job.get(name) for name in _SHOWN}
        results = {RESULT: _json(result)}
        accepted = job["state"] in _ACCEPTED
        if accepted:
            program, disposition = self._client.program(record.job)
            suffix = re.search(r"(\.[A-Za-z0-9]{1,10})\"?$", disposition)
            results[suffix[1] if suffix else ".nc"] = program
        if _is_xjdf(record.name):
            results[STATUS] = self._client.job_as_xjdf(record.job)
        results[".picture.svg"] = self._client.picture(record.drawing)
        self._put(record, DONE if accepted else FAILED, results)

    def _fail(self, record: OrderRecord, reason: KnifetipError) -> None:
        record.fault = {
            "id": record.job or None,
            "state": "refused",
            "drawing": record.drawing or None,
            "reason": reason.text,
            "hint": reason.hint,
            "questions": list(reason.questions) if isinstance(reason, OrderRefused) else [],
        }
        self._put(record, FAILED, {RESULT: _json(record.fault)})

    def _put(self, record: OrderRecord, place: str, results: dict[str, bytes]) -> None:
        """Write the results, then move the drawing beside them, then delete the record."""
        folder = self._folder / place
        if not record.target:
            record.target = _free_name(folder, record.name)
            self._save(record)
        for suffix, content in results.items():
            _write(folder / (record.target + suffix), content)
        working = self._working / record.name
        sidecar = self._working / (record.name + SIDECAR)
        if sidecar.exists():
            os.replace(sidecar, folder / (record.target + SIDECAR))
        drawing = self._working / (record.name + DRAWING)
        if drawing.exists():
            name = PurePosixPath(self._drawing_of(working)).name
            os.replace(drawing, folder / f"{record.target}.{name}")
        # A record without a drawing is harmless; a drawing without a record would begin again.
        os.replace(working, folder / record.target)
        (self._working / (record.name + RECORD)).unlink(missing_ok=True)

    def _load(self, name: str) -> OrderRecord | None:
        path = self._working / (name + RECORD)
        return OrderRecord(**json.loads(path.read_bytes())) if path.exists() else None

    def _save(self, record: OrderRecord) -> None:
        _write(self._working / (record.name + RECORD), _json(asdict(record)))


def _is_xjdf(name: str) -> bool:
    return name.lower().endswith(XJDF)


def _sidecar_fields(content: bytes) -> dict[str, Any]:
    """Return the fields of an order in a sidecar; the server checks them."""
    if not content:
        return {}
    if len(content) > _LARGEST_SIDECAR:
        raise RequestError("watch.large-sidecar", limit=_LARGEST_SIDECAR >> 20)
    try:
        fields = json.loads(content)
    except (ValueError, RecursionError) as reason:
        raise RequestError("watch.bad-sidecar", reason=str(reason)) from reason
    if not isinstance(fields, dict):
        raise RequestError("watch.no-object")
    return fields


def _free_name(folder: Path, name: str) -> str:
    """Return a name that no file in a folder has, nor any result: NAME, or with a number."""
    stem, suffix = os.path.splitext(name)
    number = 1
    free = name
    while any(os.path.lexists(folder / (free + end)) for end in ("", RESULT)):
        number += 1
        free = f"{stem}-{number}{suffix}"
    return free


def _json(data: Any) -> bytes:
    # ASCII: names of files may contain surrogates, which UTF-8 does not have.
    return (json.dumps(data, indent=2) + "\n").encode("ascii")


def _write(path: Path, content: bytes) -> None:
    """Write a file so that it is whole or absent after a power failure."""
    new = path.with_name(path.name + ".new")
    with new.open("wb") as file:
        file.write(content)
        file.flush()
        os.fsync(file.fileno())
    os.replace(new, path)
