"""acting: the principal on whose behalf the current request changes the database.

The API sets the acting principal for the time of a request.  Events then name it, and the first
transaction of the request writes the entry of the audit log, so that both are stored or neither.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass

from sqlalchemy.orm import Session

from knifetip.contract.job import Actor, ActorKind
from knifetip.harmless import harmless
from knifetip.service.database.account_tables import AuditEntry
from knifetip.service.database.key_limits import UNLIMITED, KeyLimits

#: Outcomes of a request in the audit log.
DONE, REFUSED, FAILED = "done", "refused", "failed"


@dataclass(slots=True)
class ActingPrincipal:
    """A principal and the request that it has sent."""

    kind: str  #: kind of the principal
    name: str
    id: str  #: id of a user or of an API key; "" for other principals
    action: str  #: name of the operation
    subject_kind: str = ""  #: kind of the object that is changed
    subject: str = ""  #: its id or name
    peer: str = ""  #: address of the sender
    audited: bool = True  #: whether the audit log gets an entry
    written: bool = False  #: whether it has the entry
    limits: KeyLimits = UNLIMITED  #: of its API key
    outcome: str = ""  #: outcome of a request whose status does not show it; "" for others

    @property
    def account(self) -> str:
        """Name of the user or of the API key; "" for principals without an account."""
        return self.name if self.id else ""

    @property
    def owner(self) -> str:
        """Text that identifies the account in columns; "" for principals without an account."""
        return f"{self.kind}:{self.id}" if self.id else ""

    def entry(self, at: float, outcome: str) -> AuditEntry:
        """Return the entry of the audit log, with the time ``at`` in seconds since 1970."""
        return AuditEntry(
            at=at,
            kind=self.kind,
            principal=harmless(self.name)[:200],
            action=self.action[:80],
            subject_kind=self.subject_kind[:32],
            # The path of a refused request may contain text that the database cannot store.
            subject=harmless(self.subject)[:200],
            outcome=outcome,
            # Behind a proxy, the address is the text of a header.
            peer=harmless(self.peer)[:80],
        )


_acting: ContextVar[ActingPrincipal | None] = ContextVar("acting", default=None)


@contextmanager
def acting_as(acting: ActingPrincipal) -> Iterator[None]:
    """Return a context in which changes are made on behalf of a principal."""
    token = _acting.set(acting)
    try:
        yield
    finally:
        _acting.reset(token)


def credited_name(name: str) -> str:
    """Return the name under which a change is recorded.

    It is the name of the account.  A name that the sender claims, such as that of the operator at a
    shared terminal, is kept as an addition.

    Parameters
    ----------
    name
        The claimed name; "" for none.
    """
    name = harmless(name)
    acting = _acting.get()
    account = "" if acting is None else acting.account
    if not account or name == account:
        return name
    return f"{account} ({name})" if name else account


def signature(actor: Actor) -> str:
    """Return the text that an event has for the person or process that caused it."""
    if actor.kind != ActorKind.OPERATOR:
        return str(actor)
    return str(Actor(actor.kind, credited_name(actor.name)))


def acting_owner() -> str:
    """Return the text that identifies the account of the present request; "" for none."""
    acting = _acting.get()
    return "" if acting is None else acting.owner


def acting_principal() -> str:
    """Return a text that identifies the principal of the present request; "" outside requests.

    In contrast to ``acting_owner`` it is not empty for principals without an account.
    """
    acting = _acting.get()
    return "" if acting is None else f"{acting.kind}:{acting.id}"


def acting_limits() -> KeyLimits:
    """Return the limits of the API key of the present request; no limits outside requests."""
    acting = _acting.get()
    return UNLIMITED if acting is None else acting.limits


def note_refusal() -> None:
    """Note that the present request, or a part of it, is refused although its status will be 200.

    If it changes nothing else, the audit log gets an entry with this outcome.
    """
    acting = _acting.get()
    if acting is not None:
        acting.outcome = REFUSED


def set_subject(session: Session, kind: str, subject: str) -> None:
    """Set the object that the audit log names for a transaction, unless it is set already."""
    session.info.setdefault("subject", (kind, subject))


def add_audit_entry(session: Session, at: float) -> ActingPrincipal | None:
    """Add the entry of the audit log for the present request to its first transaction.

    Parameters
    ----------
    session
        Session with the transaction, before its commit.
    at
        Present time (seconds since 1970).

    Returns
    -------
    The principal whose entry was added, to be marked as written after the commit; None if the
    request needs no entry or has one.
    """
    acting = _acting.get()
    if acting is None or acting.written or not acting.audited:
        return None
    kind, subject = session.info.get("subject", ("", ""))
    acting.subject_kind = acting.subject_kind if acting.subject else kind or acting.subject_kind
    acting.subject = acting.subject or subject
    session.add(acting.entry(at, DONE))
    return acting
