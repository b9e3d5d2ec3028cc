"""Functions that read, store, change and return drawings; called by the routes for drawings."""

from __future__ import annotations

import hashlib
import json
import unicodedata
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, Final

from fastapi import Response

from knifetip.classification.customer_agreement import learn_answers
from knifetip.errors import (
    DrawingTooLarge,
    KnifetipError,
    NotADrawing,
    StaleRevision,
    WrongState,
)
from knifetip.messages import Message
from knifetip.model.customer_answers import LearnedUnit, learned_text
from knifetip.model.interpretation import Interpretation
from knifetip.presentation.columns import unpack_columns
from knifetip.service.components import Service
from knifetip.service.database.acting import acting_limits
from knifetip.service.database.request_key import RequestKey, fingerprint
from knifetip.service.database.tables import Drawing
from knifetip.service.drawings.customer_profiles import customer_rules
from knifetip.service.drawings.document_tasks import drawing_model
from knifetip.service.drawings.first_picture import keep_first_picture
from knifetip.service.drawings.interpretations import drawing_columns
from knifetip.service.drawings.models import DrawingOut, DrawingSummary
from knifetip.service.drawings.store import NewDrawing
from knifetip.service.http.revisions import check_match, etag
from knifetip.service.http.times import rfc3339
from knifetip.service.limits.work_queue import RequestIdentity
from knifetip.service.order_details.details import Details
from knifetip.service.order_details.models import details_fields
from knifetip.service.processes import tasks
from knifetip.service.processes.pool import TaskFailed
from knifetip.service.processes.readings import Reading
from knifetip.units.customer_unit import learn_unit

#: Number of attempts to change a drawing that other requests change at the same time.
_ATTEMPTS: Final = 3
#: Unicode categories of characters that names do not keep: control, format, line separators.
_ACTING: Final = ("Cc", "Cf", "Cn", "Co", "Cs", "Zl", "Zp")


@dataclass(frozen=True, slots=True)
class Upload:
    """A drawing that a client has sent, and what it stated about it."""

    name: str  #: file name
    content: bytes
    unit: str = ""  #: unit given by the user; "" for the unit of the file
    profile: str = "default"  #: name of the classification profile
    rules: str | None = None  #: TOML text of the profile; None for the stored one with its name
    details: Details = field(default_factory=dict)  #: columns of ``order_details``

    def fingerprint(self, sha256: str) -> str:
        """Return a hash of the upload, whose content has the hash ``sha256``."""
        details = json.dumps(self.details, sort_keys=True)
        return fingerprint(self.name, sha256, self.unit, self.profile, details)

    def identity(self, key: str | None) -> RequestIdentity:
        """Return what the upload has in common with its repetitions.

        Parameters
        ----------
        key
            Idempotency-Key of the request, None if it has none.
        """
        sha256 = hashlib.sha256(self.content).hexdigest()
        return RequestIdentity.from_content("upload", key, self.fingerprint(sha256).encode())


def add_drawing(
    service: Service, response: Response, upload: Upload, key: str | None = None
) -> DrawingOut:
    """Read, classify and store a drawing, and return its API model.

    Parameters
    ----------
    service
        The server.
    response
        Gets the headers ``Location`` and ``ETag``.
    upload
        The drawing.
    key
        Idempotency-Key of the request, or None.  If the key was used before, the drawing that was
        stored with it is returned.

    Raises
    ------
    DrawingTooLarge
        The file exceeds the limit for uploads.
    LibraryError
        There is no profile with the name.
    ReadError
        The file cannot be read.
    """
    row = store_upload(service, upload, key)
    drawing = drawing_out(service, row)
    response.headers["Location"] = f"/api/drawings/{row.id}"
    response.headers["ETag"] = drawing_etag(drawing)
    return drawing


def store_upload(service: Service, upload: Upload, key: str | None = None) -> Drawing:
    """Read, classify and store a drawing, and return it; see ``add_drawing``."""
    if len(upload.content) > service.settings.upload_bytes:
        raise DrawingTooLarge(
            "drawing.upload-too-large", name=upload.name, limit=service.settings.max_upload
        )
    rules = upload.rules
    if rules is None:
        rules = customer_rules(service, upload.profile)
    sha256 = hashlib.sha256(upload.content).hexdigest()
    request = RequestKey(key, upload.fingerprint(sha256)) if key else None
    row = service.store.drawings.find(request) if request else None
    if row is not None:
        return row
    details = acting_limits().ordered_details(upload.details)
    learned = learned_for(service, details.get("customer", ""), sha256)
    interpretation = Interpretation(upload.unit, upload.profile, rules, learned=learned)
    reading = read_drawing(service, upload.name, upload.content, interpretation)
    unit = None
    if reading.summary["unit"] is None:
        unit = learned_unit(service, details.get("customer", ""), upload.name, sha256)
    if unit is not None:
        interpretation = replace(interpretation, unit=unit.unit)
        reading = read_drawing(service, upload.name, upload.content, interpretation)
    new = NewDrawing(
        name=upload.name,
        content=upload.content,
        sha256=sha256,
        interpretation=replace(interpretation, overrides=reading.overrides),
        summary=reading.summary,
        edges=reading.edges,
        import_report=reading.import_report,
        details=upload.details,
        unit_learned=() if unit is None else unit.drawings,
    )
    row = service.store.drawings.add(new, request)
    keep_first_picture(service, row, reading)
    record_uses(service, row, reading)
    return row


def learned_for(service: Service, customer: str, sha256: str, drawing: str = "") -> str:
    """Return what the drawings of a customer teach about a file, for its ``Interpretation``.

    Parameters
    ----------
    service
        The server.
    customer
        Customer of the drawing; nothing is learned for a drawing without one.
    sha256
        SHA-256 of the file.
    drawing
        Id of the drawing, which does not teach itself; "" for a new one.
    """
    if not customer:
        return ""
    answers = service.store.customer_answers
    taught, refused = answers.taught(customer, drawing), answers.refused(customer)
    return learned_text(learn_answers(taught, sha256, refused))


def learned_unit(
    service: Service, customer: str, name: str, sha256: str, drawing: str = ""
) -> LearnedUnit | None:
    """Return the unit that the drawings of a customer give to a file that states none.

    ``name`` and ``sha256`` are those of the file; for the others see ``learned_for``.
    """
    if not customer:
        return None
    return learn_unit(service.store.customer_answers.taught(customer, drawing), name, sha256)


def record_uses(service: Service, row: Drawing, reading: Reading) -> None:
    """Store which answers about a drawing apply to later drawings of its customer."""
    given = "" if row.unit_learned else row.unit_given
    service.store.customer_answers.record(
        row.id, row.customer, row.name, row.sha256, reading.uses, given
    )


def read_drawing(
    service: Service,
    name: str,
    content: bytes,
    interpretation: Interpretation,
    handles: Sequence[str] | None = None,
) -> Reading:
    """Read and classify a drawing in a worker process; return the data that are to be stored.

    Parameters
    ----------
    name, content
        Name and bytes of the file.
    interpretation
        Unit, profile and overrides with which the file is read and classified.  An override is a
        line type that the user has set for one edge.
    handles : (n,)
        Handles of the n edges to which the overrides belong, one per edge.  A handle is the
        identifier of an entity in the file.  None for a new drawing, which has no overrides.

    Raises
    ------
    ReadError
        The drawing cannot be read; the message starts with the name of the file.
    """
    try:
        return service.run(tasks.read, content, interpretation, handles)
    except TaskFailed as reason:
        raise NotADrawing("reading.crashed", name=name, incident=reason.incident) from reason
    except KnifetipError as reason:
        if reason.message.arguments.get("name") != name:
            reason.message = Message("error.in-file", name=name, error=reason.message)
        raise


@dataclass(frozen=True, slots=True)
class Change:
    """New interpretation of a drawing (unit, profile, line types), and the log message about it."""

    interpretation: Interpretation
    event: Message
    details: Details = field(default_factory=dict)  #: new details of the order, by column


def apply_change(
    service: Service,
    response: Response,
    id: str,
    match: str | None,
    decide: Callable[[Drawing], Change],
) -> DrawingOut:
    """Change the interpretation of a drawing, classify it again, and return its API model.

    The interpretation consists of unit, profile and line types set by the user.

    Parameters
    ----------
    service
        The server.
    response
        Gets the header ``ETag``.
    id
        Id of the drawing.
    match
        If-Match header of the request.  If it is None or ``*``, the change applies to the newest
        revision, and is repeated if another request changes the drawing meanwhile.
    decide
        Called with the newest revision of the drawing; returns the change.

    Raises
    ------
    StaleRevision
        The drawing has another revision than ``match``.
    WrongState
        Other requests changed the drawing during each of several attempts.
    """

    def change_once() -> Drawing:
        row = service.store.drawings.get_with(id, "content", "overrides", "edges")
        check_match(match, row)
        if row.layout is not None:
            raise WrongState("layout.read-only", layout=row.name)
        change = decide(row)
        handles = unpack_columns(row.edges)[1]["handles"]
        reading = read_drawing(service, row.name, row.content, change.interpretation, handles)
        final = replace(change.interpretation, overrides=reading.overrides)
        changed = service.store.drawings.change(
            row.id,
            row.version,
            change.event,
            **drawing_columns(final),
            summary=reading.summary,
            edges=reading.edges,
            import_report=reading.import_report,
            **change.details,
        )
        keep_first_picture(service, changed, reading)
        record_uses(service, changed, reading)
        return changed

    return _change_newest(service, response, id, match, change_once)


def change_details(
    service: Service, response: Response, id: str, match: str | None, details: Details
) -> DrawingOut:
    """Change details of the order of a drawing, and return its API model; see ``apply_change``."""

    def change_once() -> Drawing:
        row = service.store.drawings.get(id)
        check_match(match, row)
        event = Message("drawing.details-changed")
        return service.store.drawings.change(row.id, row.version, event, **details)

    return _change_newest(service, response, id, match, change_once)


def _change_newest(
    service: Service,
    response: Response,
    id: str,
    match: str | None,
    change_once: Callable[[], Drawing],
) -> DrawingOut:
    """Change the newest revision of a drawing, and return its API model; see ``apply_change``.

    ``change_once`` reads the drawing and stores the change; it raises ``StaleRevision`` if another
    request has changed the drawing in between.
    """
    for _ in range(_ATTEMPTS):
        try:
            changed = change_once()
        except StaleRevision:
            # A request without a revision applies to the newest one: try again.
            if match is not None and match.strip() != "*":
                raise
            continue
        drawing = drawing_out(service, changed)
        response.headers["ETag"] = drawing_etag(drawing)
        return drawing
    raise WrongState("drawing.changing", drawing=id)


def drawing_etag(drawing: DrawingOut) -> str:
    """Return the ETag of a drawing, made from its revision and the state of its profile.

    The state is "current", or "changed" or "deleted" if the profile was changed or deleted since
    the drawing was classified.
    """
    return etag(drawing.revision, drawing.profile_state)


def drawing_name(name: str) -> str:
    """Return a file name without folders and control characters, at most 120 characters long.

    Parameters
    ----------
    name
        File name that the client has sent.
    """
    base = name.replace("\\", "/").rsplit("/", 1)[-1]
    kept = (char for char in base if unicodedata.category(char) not in _ACTING)
    shown_name = "".join(kept).strip()
    if len(shown_name) > 120:
        stem, dot, suffix = shown_name.rpartition(".")
        shown_name = stem[:110] + dot + suffix[:9] if dot and stem else shown_name[:120]
    return shown_name or "drawing.dxf"


def drawing_out(service: Service, row: Drawing) -> DrawingOut:
    """Return the API model of a stored drawing.

    Parameters
    ----------
    service
        The server.
    row
        The drawing; its column ``import_report`` must be loaded.
    """
    fields = drawing_fields(row, profile_state(service, row))
    return drawing_model(fields, row.import_report)


def drawing_fields(row: Drawing, state: str) -> dict[str, Any]:
    """Return the fields of the API model of a stored drawing, without rows of the import report.

    Parameters
    ----------
    row
        The drawing.
    state
        State of its profile, from ``profile_state``.
    """
    return {
        **row.summary,
        "unit": row.summary["unit"] or None,
        "id": row.id,
        "revision": row.version,
        "name": row.name,
        **details_fields(row),
        "created": row.created,
        "updated": row.updated or row.created,
        "owner": row.owner,
        "shared": row.shared,
        "is_layout": row.layout is not None,
        "sha256": row.sha256,
        "profile": row.profile,
        "profile_state": state,
        "rules": row.rules,
        "unit_given": row.unit_given or None,
        "unit_learned": row.unit_learned,
        "edits": row.edits,
    }


def profile_state(service: Service, row: Drawing) -> str:
    """Return how the profile of a drawing has changed since the drawing was classified.

    The result is "current" (not changed), "changed" or "deleted".
    """
    stored = service.store.profiles.get(row.profile)
    if stored is None:
        return "deleted" if row.rules else "current"
    return "current" if stored.text == row.rules else "changed"


def summary_out(row: Drawing) -> DrawingSummary:
    """Return the API model that describes a stored drawing in lists of drawings."""
    return DrawingSummary(
        **details_fields(row),
        id=row.id,
        revision=row.version,
        name=row.name,
        created=rfc3339(row.created),
        updated=rfc3339(row.updated or row.created),
        owner=row.owner,
        shared=row.shared,
        is_layout=row.layout is not None,
        unit=row.summary["unit"] or None,
        width=row.summary["width"],
        height=row.summary["height"],
        segments=row.summary["segments"],
        questions=len(row.summary["questions"]),
    )
