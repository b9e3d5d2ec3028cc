"""account_tables: tables of users, API keys, sessions of browsers and the audit log."""

from __future__ import annotations

import sqlalchemy as sa
from sqlalchemy.orm import Mapped, mapped_column

from knifetip.service.database.tables import SERIAL, Base


class UserAccount(Base):
    """A user who can sign in; never deleted, so that events and the audit log name it."""

    __tablename__ = "user_account"
    __table_args__ = (sa.Index("user_account_by_subject", "subject", unique=True),)

    id: Mapped[str] = mapped_column(sa.String(32), primary_key=True)
    name: Mapped[str] = mapped_column(sa.String(64), unique=True)  #: in small letters
    #: password: signs in with a password; oidc: at a provider of OpenID Connect
    kind: Mapped[str] = mapped_column(sa.String(16), default="password")
    #: hash of issuer and identifier of a user of a provider; None for others
    subject: Mapped[str | None] = mapped_column(sa.String(64), default=None)
    role: Mapped[str] = mapped_column(sa.String(16))  #: see ``http.scopes.ROLES``
    password: Mapped[str] = mapped_column(sa.String(200))  #: Argon2id hash; empty for none
    active: Mapped[bool]
    created: Mapped[float] = mapped_column(sa.Double)
    created_by: Mapped[str] = mapped_column(sa.String(200))
    signed_in: Mapped[float | None] = mapped_column(sa.Double)  #: time of the last sign-in


class UsedSignIn(Base):
    """A sign-in at a provider that was finished, so that it cannot be repeated."""

    __tablename__ = "used_sign_in"

    digest: Mapped[str] = mapped_column(sa.String(64), primary_key=True)
    at: Mapped[float] = mapped_column(sa.Double)


class ApiKey(Base):
    """A key of a program, with its scopes; of its secret only the hash is stored."""

    __tablename__ = "api_key"

    id: Mapped[str] = mapped_column(sa.String(32), primary_key=True)
    title: Mapped[str] = mapped_column(sa.String(100))  #: what uses the key
    digest: Mapped[str] = mapped_column(sa.String(64))  #: SHA-256 of the secret
    scopes: Mapped[list[str]] = mapped_column(sa.JSON)
    customer: Mapped[str] = mapped_column(sa.String(200), default="")  #: only customer; "" for all
    #: only machines; empty for all, and for a gateway that has not used the key yet
    machines: Mapped[list[str]] = mapped_column(sa.JSON, default=list)
    #: a browser that was paired with a machine has it, in a cookie only
    device: Mapped[bool] = mapped_column(default=False)
    #: the key of a gateway is for any machine, because an earlier version has made it
    any_machine: Mapped[bool] = mapped_column(default=False)
    created: Mapped[float] = mapped_column(sa.Double)
    created_by: Mapped[str] = mapped_column(sa.String(200))
    expires: Mapped[float | None] = mapped_column(sa.Double)
    used: Mapped[float | None] = mapped_column(sa.Double)  #: time of the last recorded use
    revoked: Mapped[float | None] = mapped_column(sa.Double)


class PairingCode(Base):
    """A code with which one browser can be paired with a machine; only its hash is stored."""

    __tablename__ = "pairing_code"

    digest: Mapped[str] = mapped_column(sa.String(64), primary_key=True)  #: SHA-256 of the code
    machine: Mapped[str] = mapped_column(sa.String(200))
    created_by: Mapped[str] = mapped_column(sa.String(200))
    expires: Mapped[float] = mapped_column(sa.Double)


class BrowserSession(Base):
    """A session of a user in a browser; of its token only the hash is stored."""

    __tablename__ = "browser_session"

    digest: Mapped[str] = mapped_column(sa.String(64), primary_key=True)  #: SHA-256 of the token
    user: Mapped[str] = mapped_column(sa.ForeignKey("user_account.id"), index=True)
    created: Mapped[float] = mapped_column(sa.Double)
    seen: Mapped[float] = mapped_column(sa.Double)  #: time of the last recorded use
    expires: Mapped[float] = mapped_column(sa.Double)


class AuditEntry(Base):
    """A request that changed something, or was refused; rows are only appended."""

    __tablename__ = "audit"
    __table_args__ = (
        sa.Index("audit_by_time", "at"),
        sa.Index("audit_by_subject", "subject"),
        {"sqlite_autoincrement": True},
    )

    id: Mapped[int] = mapped_column(SERIAL, primary_key=True, autoincrement=True)
    at: Mapped[float] = mapped_column(sa.Double)
    kind: Mapped[str] = mapped_column(sa.String(16))  #: kind of the principal
    principal: Mapped[str] = mapped_column(sa.String(200))  #: its name
    action: Mapped[str] = mapped_column(sa.String(80))  #: name of the operation
    subject_kind: Mapped[str] = mapped_column(sa.String(32))
    subject: Mapped[str] = mapped_column(sa.String(200))  #: id or name of the changed object
    outcome: Mapped[str] = mapped_column(sa.String(8))  #: done, refused or failed
    peer: Mapped[str] = mapped_column(sa.String(80))  #: address of the sender
