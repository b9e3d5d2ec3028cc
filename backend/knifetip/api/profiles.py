"""profiles: the rules that tell cuts from creases; those that are shipped, and the customers' own.

A profile travels as TOML or as JSON.  Whoever changes one says which version they saw; drawings and
jobs keep the rules that they were made with.
"""

from __future__ import annotations

import re
from typing import Annotated, Any

from fastapi import APIRouter, Depends, Header, Request, Response
from pydantic import ValidationError

from knifetip.api.queue import queued
from knifetip.api.schemas.profiles import PreviewOut, ProfileIn, ProfileOut, ProposalOut
from knifetip.api.service import Here, bytes_answer, not_shipped, on_shelf
from knifetip.errors import ProfileError, RequestError
from knifetip.jobs import profiling
from knifetip.jobs.interpretations import interpretation_of
from knifetip.jobs.tables import Profile
from knifetip.library import custom_profiles, load

router = APIRouter(tags=["profiles"])

TOML = "application/toml"
_FORMS: dict[str, Any] = {
    "requestBody": {
        "required": True,
        "content": {
            "application/json": {"schema": {"$ref": "#/components/schemas/ProfileIn"}},
            TOML: {"schema": {"type": "string"}},
        },
    }
}
_TEXT: dict[int | str, dict[str, Any]] = {200: {"content": {TOML: {"schema": {"type": "string"}}}}}
IfMatch = Annotated[
    str | None,
    Header(
        alias="If-Match",
        max_length=40,
        description="The version that was looked at, as its ETag; * for whatever there is",
    ),
]


async def _body(request: Request) -> bytes:
    return await request.body()


Body = Annotated[bytes, Depends(_body)]


@router.get("/profiles")
def list_profiles(here: Here) -> list[ProfileOut]:
    """List the classification profiles: the customers' own, then those that are shipped."""
    kept = here.store.profiles.all()
    names = {row.name for row in kept}
    shipped = [name for name in load.names("profiles") if name not in names]
    return [_kept_out(row) for row in kept] + [_shipped_out(name) for name in shipped]


@router.get("/profiles/{name}.toml", response_class=Response, responses=_TEXT)
def export_profile(here: Here, request: Request, name: str) -> Response:
    """Return a profile as TOML, to be kept, edited and sent back."""
    row = here.store.profiles.get(name)
    text = custom_profiles.library_text(on_shelf("profiles", name)) if row is None else row.text
    tag = str(row.version if row is not None else 0)
    return bytes_answer(request, text.encode(), tag, f"{TOML}; charset=utf-8", f"{name}.toml")


@router.get("/profiles/{name}")
def get_profile(here: Here, response: Response, name: str) -> ProfileOut:
    """Look at a classification profile: its rules, of which the first that matches decides."""
    row = here.store.profiles.get(name)
    profile = _shipped_out(on_shelf("profiles", name)) if row is None else _kept_out(row)
    response.headers["ETag"] = f'"{profile.version}"'
    return profile


@router.put("/profiles/{name}", openapi_extra=_FORMS)
def keep_profile(
    here: Here, request: Request, response: Response, name: str, body: Body, match: IfMatch = None
) -> ProfileOut:
    """Keep a customer's profile, as TOML or as JSON.

    A new one needs no If-Match; to change one, say which version it was made from.
    """
    custom_profiles.check_name(name)
    not_shipped(here, name)
    version, anyway = _version(match)
    if "json" in request.headers.get("content-type", "").lower():
        given = _profile_in(body)
        if match is None:
            version = given.version
        text = custom_profiles.profile_text(name, fields_of(given))
    else:
        text = _text(name, body)
    title = custom_profiles.parse_text(name, text).title
    row = here.store.profiles.save(name, title, text, version, anyway=anyway)
    response.status_code = 201 if row.version == 1 else 200
    response.headers["ETag"] = f'"{row.version}"'
    return _kept_out(row)


@router.delete("/profiles/{name}", status_code=204)
def delete_profile(here: Here, name: str, match: IfMatch = None) -> None:
    """Forget a customer's profile; drawings and jobs keep the rules that they were made with."""
    not_shipped(here, name)
    here.store.profiles.delete(name, _version(match)[0])


@router.post("/drawings/{id}/preview")
@queued
def preview_profile(here: Here, id: str, profile: ProfileIn) -> PreviewOut:
    """Say what a profile would do to a drawing; nothing is kept."""
    row = here.store.drawings.get_with(id, "content", "overrides")
    found = here.run(
        profiling.preview,
        row.content,
        interpretation_of(row, row.overrides),
        custom_profiles.profile_text(profile.title[:80], fields_of(profile)),
    )
    return PreviewOut.model_validate(found)


@router.post("/drawings/{id}/learned")
@queued
def learn_from_corrections(here: Here, id: str) -> list[ProposalOut]:
    """Propose rules that would have said what somebody corrected by hand; nothing is kept."""
    row = here.store.drawings.get_with(id, "content", "overrides")
    found = here.run(
        profiling.learn,
        row.content,
        interpretation_of(row, row.overrides),
    )
    return [ProposalOut.model_validate(one) for one in found]


def fields_of(profile: ProfileIn) -> dict[str, Any]:
    """Return a profile of a request as the library takes it."""
    rules = [
        {key: value for key, value in rule.model_dump().items() if value} for rule in profile.rules
    ]
    fields: dict[str, Any] = {"title": profile.title, "rule": rules}
    if profile.extends is not None:
        fields |= {"extends": profile.extends, "overrules": profile.overrules}
    return fields


def _version(match: str | None) -> tuple[int | None, bool]:
    """Return the version that an If-Match names, and whether any will do."""
    if match is None:
        return None, False
    if match.strip() == "*":
        return None, True
    found = re.fullmatch(r'\s*(?:W/)?"?(\d{1,9})"?\s*', match)
    if found is None:
        raise RequestError("profile.bad-if-match", match=match)
    return int(found[1]), False


def _profile_in(body: bytes) -> ProfileIn:
    try:
        return ProfileIn.model_validate_json(body)
    except ValidationError as reason:
        fault = reason.errors(include_url=False, include_context=False, include_input=False)[0]
        place = _place(fault["loc"])
        raise ProfileError(
            "profile.invalid-field", place=" ".join(place), fault=fault["msg"], source=place
        ) from reason


def _place(loc: tuple[int | str, ...]) -> tuple[str, ...]:
    """Return where in a profile something is, rules counted from 1 as people do."""
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
        raise ProfileError("profile.not-utf8-byte", name=name, byte=reason.start) from reason


def _shipped_out(name: str) -> ProfileOut:
    return _out(name, custom_profiles.library_text(name), shipped=True)


def _kept_out(row: Profile) -> ProfileOut:
    try:
        return _out(row.name, row.text, version=row.version, updated=row.updated)
    except ProfileError as reason:
        # One that an older knifetip took must not hide all the others.
        return ProfileOut(
            name=row.name,
            title=row.title,
            version=row.version,
            updated=row.updated,
            rules=[],
            fault=reason.text,
        )


def _out(name: str, text: str, *, shipped: bool = False, **more: Any) -> ProfileOut:
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
                {**profiling.plain(rule), "inherited": theirs}
                for rule, theirs in zip(rules.rules, inherited, strict=True)
            ],
            **more,
        }
    )
