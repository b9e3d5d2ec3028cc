"""Models for users, API keys, sessions and the audit log."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import BaseModel, Field

from knifetip.service.http.models import JsonBody, PageQuery, Parameters
from knifetip.service.http.scopes import AccessScope
from knifetip.service.http.times import Moment, MomentIn, in_order

UserRole = Literal["viewer", "designer", "operator", "admin"]
_NAME = Field(min_length=1, max_length=64, description="Name of the user")
#: The store refuses other names with a message of its own.
_NEW_NAME = Field(
    min_length=1,
    max_length=64,
    description="Name of the user; capital letters become small ones",
    json_schema_extra={"pattern": "^[A-Za-z0-9][A-Za-z0-9._@+-]{0,63}$"},
)
_PASSWORD = Field(
    min_length=1, max_length=1000, description="Password of at least ten characters", repr=False
)
#: The store refuses a shorter one with a message of its own.
_NEW_PASSWORD = Field(
    min_length=1,
    max_length=1000,
    description="Password of at least ten characters",
    repr=False,
    json_schema_extra={"minLength": 10},
)
_ROLE = Field(description="What the user may do; each role contains those before it")


class SignIn(JsonBody):
    """Name and password of a user."""

    name: Annotated[str, _NAME]
    password: Annotated[str, _PASSWORD]


class MeOut(BaseModel):
    """The sender of the request, and what it may do."""

    kind: Literal["user", "key", "device", "local", "server-key"] = Field(
        description="user: a user who has signed in; key: an API key; device: a browser "
        "that was paired with a machine; local: this computer, while "
        "there is no administrator; server-key: the key with which the server was started"
    )
    name: str = Field(description="Name of the user or of the key")
    sign_in: Literal["password", "oidc"] | None = Field(
        description="How the user signs in, as `kind` in `GET /api/users`; null if the sender is "
        "no user"
    )
    scopes: list[AccessScope] = Field(description="All scopes of the sender")
    account: str = Field(
        description="Identifies the user or the key, as in `owner` of a drawing; empty for others"
    )
    customer: str = Field(description="Only customer of the key; empty for all")
    machines: list[str] = Field(description="Only machines of the key; empty for all")
    has_admin: bool = Field(
        description="Whether there is an administrator; before, every program on the server's "
        "computer may do everything"
    )


class PasswordIn(JsonBody):
    """The present and the new password of the user who sends the request."""

    current: Annotated[str, _PASSWORD]
    new: Annotated[str, _NEW_PASSWORD]


class UserOut(BaseModel):
    """A user."""

    name: str = Field(description="Name of the user, in small letters")
    kind: Literal["password", "oidc"] = Field(
        description="How the user signs in: with a password, or at a provider of OpenID Connect, "
        "which also determines the role"
    )
    role: UserRole = _ROLE
    active: bool = Field(description="Whether the user can sign in")
    created: Moment = Field(description="Time of the creation")
    created_by: str = Field(description="Who created the user; empty if it is not known")
    signed_in: Moment | None = Field(description="Time of the last sign-in; null for none")


class UserIn(JsonBody):
    """A new user."""

    name: Annotated[str, _NEW_NAME]
    password: Annotated[str, _NEW_PASSWORD]
    role: UserRole = _ROLE


class UserChangeIn(JsonBody):
    """Changes of a user; they end the sessions of the user."""

    role: UserRole | None = Field(default=None, description="New role; null for no change")
    active: bool | None = Field(default=None, description="Whether the user can sign in")
    password: Annotated[str | None, _NEW_PASSWORD] = None


class KeyOut(BaseModel):
    """An API key without its secret."""

    id: str = Field(description="Id of the key, which is a part of its secret")
    title: str = Field(description="What uses the key")
    scopes: list[AccessScope] = Field(description="Scopes that were given to the key")
    customer: str = Field(
        description="Customer whose jobs and drawings the key sees and orders; empty for all"
    )
    machines: list[str] = Field(
        description="Machines whose jobs the key sees and for which it orders; empty for all. The "
        "key of a gateway gets the first machine for which it is used"
    )
    any_machine: bool = Field(
        description="Whether the key of a gateway is for all machines, because an earlier version "
        "made it; create a new key instead"
    )
    device: bool = Field(
        description="Whether it is no key of a program, but that of a browser which was paired "
        "with a machine"
    )
    created: Moment = Field(description="Time of the creation")
    created_by: str = Field(description="Who created the key; empty if it is not known")
    expires: Moment | None = Field(description="Time of its end; null for never")
    used: Moment | None = Field(
        description="Time of the last use, recorded once a minute; null for never"
    )
    revoked: Moment | None = Field(description="Time of its revocation; null if valid")


class PairingCodeOut(BaseModel):
    """A code with which one browser can be paired with a machine."""

    code: str = Field(description="The code: two groups of four letters and digits")
    machine: str = Field(description="Name of the machine")
    expires: Moment = Field(description="Time of its end")


class KeyIn(JsonBody):
    """A new API key."""

    title: str = Field(min_length=1, max_length=100, description="What uses the key")
    # Not strict: JSON has texts, not members of an enumeration.
    scopes: list[Annotated[AccessScope, Field(strict=False)]] = Field(
        min_length=1,
        max_length=10,
        description="What the key permits. read: see everything. order: also upload drawings, "
        "order jobs, and release, change and cancel those. webhooks: manage webhooks of its own. "
        "station: start and move machines. gateway: control a machine. The roles of users are "
        "possible too, but none of them lets a key start or move a machine",
    )
    customer: str = Field(
        default="",
        max_length=200,
        description="Only customer whose jobs and drawings the key sees and orders; empty for "
        "all. With the scopes viewer, read, order and webhooks",
    )
    machines: list[Annotated[str, Field(min_length=1, max_length=200)]] = Field(
        default=[],
        max_length=50,
        description="Only machines of the key; empty for all, for a gateway the first one for "
        "which it is used. With the scopes viewer, read, order, webhooks, station and gateway",
    )
    expires: MomentIn | None = Field(
        default=None, description="Time at which the key becomes invalid; null for never"
    )


class NewKeyOut(KeyOut):
    """A new API key with its secret, which is not stored and cannot be read again."""

    secret: str = Field(description="Secret for the header `Authorization: Bearer`")


class AuditOut(BaseModel):
    """An entry of the audit log: a request or command that changed something or was refused."""

    id: int = Field(description="Number of the entry")
    at: Moment = Field(description="Time")
    kind: str = Field(
        description="Kind of the sender, as in `GET /api/me`; command for the commands "
        "`knifetip user` and `knifetip key`"
    )
    principal: str = Field(description="Name of the user or of the key")
    action: str = Field(description="Operation, as `operationId` in the OpenAPI description")
    subject_kind: str = Field(description="Kind of the object, such as job; empty for none")
    subject: str = Field(description="Id or name of the object; empty for none")
    outcome: Literal["done", "refused", "failed"] = Field(
        description="done; refused: by the access control or the state of the object; failed: by "
        "an error of the server"
    )
    peer: str = Field(description="Address of the sender")


class AuditQuery(PageQuery, Parameters):
    """Conditions on entries of the audit log, and the page of the list."""

    principal: str = Field(default="", max_length=200, description="Name of the sender")
    action: str = Field(default="", max_length=80, description="Operation")
    subject: str = Field(default="", max_length=200, description="Id or name of the object")
    outcome: Literal["done", "refused", "failed"] | None = Field(
        default=None, description="Outcome; all if it is missing"
    )
    since: MomentIn | None = Field(default=None, description="Only entries since then")
    until: MomentIn | None = Field(default=None, description="Only entries before then")

    _ordered = in_order(("since", "until"))
