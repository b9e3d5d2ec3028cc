"""Routes for classification profiles of the library and of customers.

A profile is sent as TOML or JSON.  A change must name the version on which it is based.  Drawings
and jobs keep the rules of the profile version with which they were made.
"""

from __future__ import annotations

from typing import Annotated, Any

from fastapi import Query, Request, Response
from pydantic import ValidationError
from starlette.convertors import StringConvertor, register_url_convertor

from knifetip.errors import ProfileError
from knifetip.fields import field_message
from knifetip.library import custom_profiles, load
from knifetip.library.definition import check_texts
from knifetip.service.components import Service, ServiceDep
from knifetip.service.database.tables import Profile
from knifetip.service.drawings.customer_profiles import require_customer_profile
from knifetip.service.drawings.interpretations import interpretation_of
from knifetip.service.http.conditional import NOT_MODIFIED
from knifetip.service.http.downloads import bytes_response
from knifetip.service.http.models import ListPage
from knifetip.service.http.pages import page_of
from knifetip.service.http.parameters import DrawingId, NewProfileName, ProfileName
from knifetip.service.http.principal import Principal, PrincipalDep
from knifetip.service.http.routing import ScopedRouter, requires
from knifetip.service.http.scopes import AccessScope
from knifetip.service.http.times import rfc3339
from knifetip.service.http.versions import TOML, TOML_RESPONSE, Body, VersionMatch, version_of
from knifetip.service.library.names import check_library_name
from knifetip.service.limits.work_queue import queued
from knifetip.service.profiles import tasks as profiling
from knifetip.service.profiles.models import PreviewOut, ProfileIn, ProfileOut, ProposalOut

router = ScopedRouter(tags=["profiles"])


class _NameConvertor(StringConvertor):
    """Part of a URL that is the name of a profile, not that of its file ``NAME.toml``."""

    regex = r"[^/]+(?<!\.toml)"


register_url_convertor("profile", _NameConvertor())

_FORMS: dict[str, Any] = {
    "requestBody": {
        "required": True,
        "content": {
            "application/json": {"schema": {"$ref": "#/components/schemas/ProfileIn"}},
            TOML: {"schema": {"type": "string"}},
        },
    }
}


@router.get("/profiles", responses=NOT_MODIFIED)
@requires(AccessScope.VIEWER)
def list_profiles(
    service: ServiceDep,
    principal: PrincipalDep,
    request: Request,
    response: Response,
    wanted: Annotated[ListPage, Query()],
) -> list[ProfileOut]:
    """List the classification profiles: first those of customers, then those of the library.

    A key that is limited to a customer gets those of the library only.  The header `Link` contains
    the URL of the next page.
    """
    stored = [] if principal.limits.customer else service.store.profiles.all()
    names = {row.name for row in stored}
    shipped = [name for name in load.names("profiles") if name not in names]
    found: list[Profile | str] = [*stored, *shipped]
    return [
        _shipped_out(one) if isinstance(one, str) else _stored_out(one)
        for one in page_of(request, response, found, wanted)
    ]


@router.get("/profiles/{name}.toml", response_class=Response, responses=TOML_RESPONSE)
@requires(AccessScope.VIEWER)
def export_profile(service: ServiceDep, principal: PrincipalDep, name: ProfileName) -> Response:
    """Download a profile as TOML."""
    row = _stored_profile(service, principal, name)
    text = (
        load.library_text("profiles", check_library_name("profiles", name))
        if row is None
        else row.text
    )
    tag = str(row.version if row is not None else 0)
    return bytes_response(text.encode(), tag, f"{TOML}; charset=utf-8", f"{name}.toml")


@router.get("/profiles/{name:profile}")
@requires(AccessScope.VIEWER)
def get_profile(
    service: ServiceDep, principal: PrincipalDep, response: Response, name: ProfileName
) -> ProfileOut:
    """Get a classification profile; the first rule that matches an edge is used."""
    row = _stored_profile(service, principal, name)
    profile = (
        _shipped_out(check_library_name("profiles", name)) if row is None else _stored_out(row)
    )
    response.headers["ETag"] = f'"{profile.version}"'
    return profile


@router.put(
    "/profiles/{name:profile}",
    openapi_extra=_FORMS,
    responses={201: {"model": ProfileOut, "description": "The profile is new"}},
)
@requires(AccessScope.DESIGNER)
def keep_profile(
    service: ServiceDep,
    request: Request,
    response: Response,
    name: NewProfileName,
    body: Body,
    match: VersionMatch = None,
) -> ProfileOut:
    """Create or replace the profile of a customer; the request body is the profile as TOML or JSON.

    To replace a profile, send the version on which the change is based in the header ``If-Match``.
    """
    custom_profiles.check_name(name)
    require_customer_profile(service, name)
    version, any_version = version_of(match)
    if "json" in request.headers.get("content-type", "").lower():
        sent = _profile_in(body)
        if match is None:
            version = sent.version
        text = custom_profiles.profile_text(name, fields_of(sent))
    else:
        text = _text(name, body)
    title = custom_profiles.parse_text(name, text).title
    # Patterns may have any character, like the layers that they match.
    check_texts("profile", name, {"title": title})
    row = service.store.profiles.save(name, title, text, version, replace_any=any_version)
    response.status_code = 201 if row.version == 1 else 200
    response.headers["ETag"] = f'"{row.version}"'
    return _stored_out(row)


@router.delete("/profiles/{name:profile}", status_code=204)
@requires(AccessScope.DESIGNER)
def delete_profile(service: ServiceDep, name: ProfileName, match: VersionMatch = None) -> None:
    """Delete a customer's profile; drawings and jobs keep the rules with which they were made."""
    require_customer_profile(service, name)
    service.store.profiles.delete(name, version_of(match)[0])


@router.post("/drawings/{id}/preview")
@requires(AccessScope.DESIGNER)
@queued
def preview_profile(service: ServiceDep, id: DrawingId, profile: ProfileIn) -> PreviewOut:
    """Get the effect that a profile would have on the edges of a drawing; nothing is stored."""
    row = service.store.drawings.get_with(id, "content", "overrides")
    effect = service.run(
        profiling.preview,
        row.content,
        interpretation_of(row, row.overrides),
        custom_profiles.profile_text(profile.title[:80], fields_of(profile)),
    )
    return PreviewOut.model_validate(effect)


@router.post("/drawings/{id}/learned")
@requires(AccessScope.DESIGNER)
@queued
def learn_from_corrections(service: ServiceDep, id: DrawingId) -> list[ProposalOut]:
    """Propose classification rules from the line types that the user has set in a drawing.

    A proposed rule gives the edges these line types.  Nothing is stored.
    """
    row = service.store.drawings.get_with(id, "content", "overrides")
    proposals = service.run(
        profiling.learn,
        row.content,
        interpretation_of(row, row.overrides),
    )
    return [ProposalOut.model_validate(proposal) for proposal in proposals]


def _stored_profile(service: Service, principal: Principal, name: str) -> Profile | None:
    """Return a profile of a customer, which a key for one customer may not read; None for none."""
    return None if principal.limits.customer else service.store.profiles.get(name)


def fields_of(profile: ProfileIn) -> dict[str, Any]:
    """Return the profile in a request as a dict with the fields of a profile file."""
    rules = [
        {key: value for key, value in rule.model_dump().items() if value} for rule in profile.rules
    ]
    fields: dict[str, Any] = {"title": profile.title, "rule": rules}
    if profile.extends is not None:
        fields |= {"extends": profile.extends, "overrules": profile.overrules}
    return fields


def _profile_in(body: bytes) -> ProfileIn:
    try:
        return ProfileIn.model_validate_json(body)
    except ValidationError as reason:
        fault = reason.errors(include_url=False)[0]
        place = _place_of_fault(fault["loc"])
        raise ProfileError(
            "profile.invalid-field", fault=field_message(ProfileIn, fault), source=place
        ) from reason


def _place_of_fault(loc: tuple[int | str, ...]) -> tuple[str, ...]:
    """Return the names of the rule and the field that contain a fault in a profile.

    The result is, for example, ``("rule 1", "type")`` for a field of the first rule, ``("title",)``
    for a field outside the rules, or ``("body",)`` if the fault concerns no field.

    ``loc``: location of the fault in the JSON data, as pydantic reports it.
    """
    match loc:
        case ("rules", int(number), field, *_):
            return (f"rule {number + 1}", str(field)[:80])
        case ("rules", int(number)):
            return (f"rule {number + 1}",)
        case (field, *_):
            return (str(field)[:80],)
    return ("body",)


def _text(name: str, body: bytes) -> str:
    if len(body) > custom_profiles.MAX_BYTES:
        raise ProfileError(
            "profile.too-long",
            name=name,
            size=len(body) >> 10,
            limit=custom_profiles.MAX_BYTES >> 10,
        )
    try:
        return body.decode("utf-8-sig")
    except UnicodeDecodeError as reason:
        raise ProfileError(
            "library.not-utf8", shelf="profile", name=name, byte=reason.start
        ) from reason


def _shipped_out(name: str) -> ProfileOut:
    return _profile_out(name, load.library_text("profiles", name), shipped=True)


def _stored_out(row: Profile) -> ProfileOut:
    try:
        return _profile_out(row.name, row.text, version=row.version, updated=row.updated)
    except ProfileError as reason:
        # An invalid profile, stored by an older version, must not make the list fail.
        return ProfileOut(
            name=row.name,
            title=row.title,
            version=row.version,
            updated=rfc3339(row.updated),
            rules=[],
            fault=reason.text,
        )


def _profile_out(name: str, text: str, *, shipped: bool = False, **more: Any) -> ProfileOut:
    rules = load.profile(name, files=False) if shipped else custom_profiles.parse_text(name, text)
    fields = custom_profiles.parse_fields(text)
    inherited = custom_profiles.inherited_rules(fields, rules)
    return ProfileOut.model_validate(
        {
            "name": name,
            "title": rules.title,
            "shipped": shipped,
            "extends": fields.get("extends"),
            "overrules": fields.get("overrules", False),
            "rules": [
                {**profiling.rule_json(rule), "inherited": theirs}
                for rule, theirs in zip(rules.rules, inherited, strict=True)
            ],
            **more,
        }
    )
