"""Routes for signing in, users, API keys and the audit log (ADR 83)."""

from __future__ import annotations

from typing import Annotated

from fastapi import Path, Query, Request, Response

from knifetip.errors import RequestError, SignInRefused, WrongState
from knifetip.library.definition import Shelf
from knifetip.service.accounts import sign_in as signin
from knifetip.service.accounts.account_access import Accounts
from knifetip.service.accounts.audit_store import AuditFilter
from knifetip.service.accounts.models import (
    AuditOut,
    AuditQuery,
    KeyIn,
    KeyOut,
    MeOut,
    NewKeyOut,
    PairingCodeOut,
    PasswordIn,
    SignIn,
    UserChangeIn,
    UserIn,
    UserOut,
)
from knifetip.service.accounts.pairing_store import shown_code
from knifetip.service.components import Service, ServiceDep
from knifetip.service.database.account_tables import ApiKey, UserAccount
from knifetip.service.database.acting import credited_name
from knifetip.service.database.key_limits import KeyLimits
from knifetip.service.http.models import ListPage
from knifetip.service.http.pages import page_of, set_next_page
from knifetip.service.http.parameters import MachineName
from knifetip.service.http.principal import Principal, PrincipalDep, PrincipalKind
from knifetip.service.http.routing import ScopedRouter, public, requires, unaudited
from knifetip.service.http.scopes import AccessScope

router = ScopedRouter(tags=["accounts"])

UserName = Annotated[str, Path(max_length=64, description="Name of the user")]
KeyId = Annotated[str, Path(max_length=32, description="Id of the key")]


@router.post("/session")
@public
@unaudited
async def sign_in(service: ServiceDep, request: Request, response: Response, sent: SignIn) -> MeOut:
    """Sign in with name and password; the response sets the cookie of a session.

    The session ends twelve hours after its last request, seven days after the sign-in, at the
    sign-out, and when password, role or state of the user change.  The status is 429 after several
    failed sign-ins; `Retry-After` is then the time to wait.
    """
    accounts = _accounts(request)
    token = await accounts.sign_in(sent.name, sent.password, _address(request))
    signin.set_cookie(request, response, signin.user_cookie(request, token))
    user = await accounts.user_of(token)
    return await service.threads.reports(_me_out, service, user)


@router.delete("/session", status_code=204)
@public
async def sign_out(service: ServiceDep, request: Request, response: Response) -> None:
    """End the session of the request, and delete its cookie."""
    token = request.cookies.get(signin.session_cookie(request))
    if token:
        await _accounts(request).sign_out(token)
    for name in request.cookies:
        if name in (
            signin.session_cookie(request),
            signin.cookie_name(service.access.key),
        ):
            response.delete_cookie(name, path="/", httponly=True, samesite="strict")


@router.get("/me")
@requires(AccessScope.VIEWER, AccessScope.GATEWAY, AccessScope.WEBHOOKS)
def get_me(service: ServiceDep, principal: PrincipalDep) -> MeOut:
    """Get the sender of the request and its scopes."""
    return _me_out(service, principal)


def _me_out(service: Service, principal: Principal) -> MeOut:
    users, is_user = service.store.users, principal.kind == PrincipalKind.USER
    return MeOut.model_validate(
        {
            "kind": principal.kind.value,
            "name": principal.name,
            "account": f"{principal.kind.value}:{principal.id}" if principal.id else "",
            "customer": principal.limits.customer,
            "machines": sorted(principal.limits.machines),
            "sign_in": users.kind_of(principal.name) if is_user else None,
            "scopes": [scope for scope in AccessScope if scope in principal.scopes],
            "has_admin": users.has_admin(),
        }
    )


@router.post("/me/password", status_code=204)
@requires(AccessScope.VIEWER)
async def change_own_password(
    service: ServiceDep,
    request: Request,
    principal: PrincipalDep,
    sent: PasswordIn,
) -> None:
    """Change the password of the user who sends the request; all other sessions of the user end."""
    if principal.kind != PrincipalKind.USER:
        raise WrongState("user.not-signed-in")
    accounts = _accounts(request)
    try:
        present = await accounts.sign_in(principal.name, sent.current, _address(request))
    except SignInRefused as reason:
        # Not 401: the session of the request is valid.
        raise RequestError("user.wrong-password", source=["current"]) from reason
    await accounts.sign_out(present)
    # The page sends other requests meanwhile: if its session ended, they would be refused.
    kept = request.cookies.get(signin.session_cookie(request))
    change = service.store.users.change
    await service.threads.claims(change, principal.name, password=sent.new, kept_session=kept)
    accounts.clear_cache()


@router.get("/users")
@requires(AccessScope.ADMIN)
def list_users(
    service: ServiceDep, request: Request, response: Response, wanted: Annotated[ListPage, Query()]
) -> list[UserOut]:
    """List the users, ordered by name; `Link` contains the URL of the next page."""
    rows = page_of(request, response, service.store.users.all(), wanted)
    return [_user_out(row) for row in rows]


@router.post("/users", status_code=201)
@requires(AccessScope.ADMIN)
def create_user(service: ServiceDep, request: Request, sent: UserIn) -> UserOut:
    """Create a user.

    As soon as the first administrator exists, requests from the server's computer need a key or a
    session too.
    """
    row = service.store.users.add(
        sent.name, sent.password, AccessScope(sent.role), credited_name("")
    )
    _accounts(request).clear_cache()
    return _user_out(row)


@router.patch("/users/{name}")
@requires(AccessScope.ADMIN)
def change_user(
    service: ServiceDep, request: Request, name: UserName, sent: UserChangeIn
) -> UserOut:
    """Change role, state or password of a user; the sessions of the user end.

    The status is 409 if there would be no active administrator.
    """
    row = service.store.users.change(
        name,
        role=None if sent.role is None else AccessScope(sent.role),
        active=sent.active,
        password=sent.password,
    )
    _accounts(request).clear_cache()
    return _user_out(row)


@router.get("/keys")
@requires(AccessScope.ADMIN)
def list_keys(
    service: ServiceDep, request: Request, response: Response, wanted: Annotated[ListPage, Query()]
) -> list[KeyOut]:
    """List the API keys without their secrets, the newest first.

    The header `Link` contains the URL of the next page.
    """
    rows = page_of(request, response, service.store.keys.all(), wanted)
    return [_key_out(row) for row in rows]


@router.post("/keys", status_code=201)
@requires(AccessScope.ADMIN)
def create_key(service: ServiceDep, response: Response, sent: KeyIn) -> NewKeyOut:
    """Create an API key; only this response contains its secret."""
    for machine in sent.machines:
        service.store.library.definition(Shelf.MACHINES, machine)
    limits = KeyLimits(sent.customer, frozenset(sent.machines))
    row, secret = service.store.keys.add(
        sent.title, sent.scopes, sent.expires, credited_name(""), limits
    )
    return _with_secret(response, row, secret)


@router.post("/keys/{id}/rotate-secret")
@requires(AccessScope.ADMIN)
def rotate_key_secret(
    service: ServiceDep, request: Request, response: Response, id: KeyId
) -> NewKeyOut:
    """Give an API key a new secret; the former one becomes invalid.

    Only this answer contains the new secret.  Jobs, drawings and webhooks of the key stay its own.
    """
    row, secret = service.store.keys.rotate(id)
    _accounts(request).clear_cache()
    return _with_secret(response, row, secret)


def _with_secret(response: Response, row: ApiKey, secret: str) -> NewKeyOut:
    response.headers["Cache-Control"] = "no-store"
    response.headers["Location"] = f"/api/keys/{row.id}"
    return NewKeyOut(**_key_out(row).model_dump(), secret=secret)


@router.delete("/keys/{id}", status_code=204)
@requires(AccessScope.ADMIN)
def revoke_key(service: ServiceDep, request: Request, id: KeyId) -> None:
    """Revoke an API key: it becomes invalid, and stays in the list."""
    service.store.keys.revoke(id)
    _accounts(request).clear_cache()


@router.post("/machines/{name}/pairing-codes", status_code=201)
@requires(AccessScope.ADMIN)
def create_pairing_code(
    service: ServiceDep, response: Response, name: MachineName
) -> PairingCodeOut:
    """Create a code with which one browser can be paired with a machine, for ten minutes.

    Who enters it on the page `/pair` of the server may start, continue and move this machine with
    that browser, and sees only its jobs, until the device is revoked or unpaired.
    """
    service.store.library.definition(Shelf.MACHINES, name)
    code, expires = service.store.pairing.new_code(name, credited_name(""))
    response.headers["Cache-Control"] = "no-store"
    fields = {"code": shown_code(code), "machine": name, "expires": expires}
    return PairingCodeOut.model_validate(fields)


@router.get("/machines/{name}/devices")
@requires(AccessScope.ADMIN)
def list_devices(
    service: ServiceDep,
    request: Request,
    response: Response,
    name: MachineName,
    wanted: Annotated[ListPage, Query()],
) -> list[KeyOut]:
    """List the browsers that are paired with a machine, the newest first.

    `DELETE /api/keys/{id}` revokes one.  `Link` contains the URL of the next page.
    """
    service.store.library.definition(Shelf.MACHINES, name)
    rows = page_of(request, response, service.store.pairing.devices(name), wanted)
    return [_key_out(row) for row in rows]


@router.get("/audit")
@requires(AccessScope.ADMIN)
def list_audit(
    service: ServiceDep,
    request: Request,
    response: Response,
    wanted: Annotated[AuditQuery, Query()],
) -> list[AuditOut]:
    """List the audit log, the newest entries first; `Link` contains the URL of the next page.

    It has an entry for each request that is not GET: also for a refused one; and for each change by
    the commands `knifetip user` and `knifetip key`.  The reports of gateways are left out; what
    they change is among the events of jobs.
    """
    conditions = AuditFilter(
        wanted.principal,
        wanted.action,
        wanted.subject,
        wanted.outcome or "",
        wanted.since,
        wanted.until,
    )
    rows = service.store.audit.search(conditions, wanted.cursor, wanted.limit)
    last = rows[-1].id if len(rows) == wanted.limit else None
    set_next_page(request, response, last, wanted.limit)
    return [AuditOut.model_validate(row, from_attributes=True) for row in rows]


def _accounts(request: Request) -> Accounts:
    accounts: Accounts = request.app.state.accounts
    return accounts


def _address(request: Request) -> str:
    return "" if request.client is None else request.client.host


def _user_out(row: UserAccount) -> UserOut:
    return UserOut.model_validate(row, from_attributes=True)


def _key_out(row: ApiKey) -> KeyOut:
    return KeyOut.model_validate(row, from_attributes=True)
