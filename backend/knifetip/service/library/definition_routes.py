"""Routes for machines, boards and tools that users make: read, save, delete, and their versions.

A definition is sent as TOML or JSON with the fields of the TOML files of knifetip's library, and is
checked like them.  Each change stores a new version and must name the version on which it is based.
Entries of knifetip's library are read-only, and their version is 0.
"""

from __future__ import annotations

from typing import Annotated, Any

from fastapi import Path, Query, Request, Response

from knifetip.errors import LibraryError, WrongState
from knifetip.harmless import harmless
from knifetip.library import load
from knifetip.library.definition import (
    Definition,
    Shelf,
    check_definition,
    check_texts,
    decode,
    is_name,
    parse_toml,
    toml_from_json,
)
from knifetip.library.schema import json_schema
from knifetip.service.components import ServiceDep
from knifetip.service.database.acting import credited_name
from knifetip.service.database.tables import LibraryVersion
from knifetip.service.http.downloads import bytes_response
from knifetip.service.http.models import ListPage
from knifetip.service.http.pages import page_of
from knifetip.service.http.parameters import NAME_SCHEMA
from knifetip.service.http.routing import ScopedRouter, requires
from knifetip.service.http.scopes import AccessScope
from knifetip.service.http.versions import TOML, TOML_RESPONSE, Body, VersionMatch, version_of
from knifetip.service.library.definition_files import JSON_SCHEMA, definition_ref
from knifetip.service.library.definition_models import DefinitionOut, EntryOut, VersionOut
from knifetip.service.library.store import VersionNote

router = ScopedRouter(tags=["library"])

EntryName = Annotated[str, Path(description="Name of the machine, board or tool")]
NewEntryName = Annotated[
    str,
    Path(description="Name of the machine, board or tool", json_schema_extra=NAME_SCHEMA),
]
Version = Annotated[
    int | None,
    Query(ge=0, le=2**31 - 1, description="Number of the version; the newest if it is missing"),
]
By = Annotated[str, Query(max_length=100, description="Who saves the version")]
Note = Annotated[str, Query(max_length=200, description="What is changed, and why")]


@router.get("/library")
@requires(AccessScope.VIEWER)
def list_library(
    service: ServiceDep, request: Request, response: Response, wanted: Annotated[ListPage, Query()]
) -> list[EntryOut]:
    """List the machines, boards and tools: those of users and those of knifetip's library.

    The header `Link` contains the URL of the next page.
    """
    own = [_entry_out(row) for row in service.store.library.all(*Shelf)]
    shipped = [_shipped_out(shelf, name) for shelf in Shelf for name in load.names(shelf)]
    return list(page_of(request, response, own + shipped, wanted))


def _entry_out(row: LibraryVersion) -> EntryOut:
    fault = ""
    try:
        check_definition(Shelf(row.shelf), row.name, row.text)
    except LibraryError as reason:
        # An invalid definition, stored by an older version, must not make the list fail.
        fault = reason.text
    fields = {name: getattr(row, name) for name in VersionOut.model_fields}
    return EntryOut(shelf=Shelf(row.shelf), name=row.name, shipped=False, fault=fault, **fields)


def _shipped_out(shelf: Shelf, name: str) -> EntryOut:
    definition = Definition(shelf, name)
    title = check_definition(shelf, name, definition.toml)
    return EntryOut(shelf=shelf, name=name, title=title, shipped=True)


@router.get("/schemas/{kind}", responses={200: JSON_SCHEMA})
@requires(AccessScope.VIEWER)
def get_schema(
    kind: Annotated[Shelf, Path(description="machines, boards or tools")],
) -> dict[str, Any]:
    """Get the JSON Schema of the definitions of machines, boards or tools."""
    return json_schema(kind.word)


def _definition_out(service: ServiceDep, definition: Definition) -> DefinitionOut:
    """Return the API model of a definition.

    ``definition``: a definition of a user or of knifetip's library.
    """
    shelf, name = definition.shelf, definition.name
    row = service.store.library.get(shelf, name, definition.version) if definition.version else None
    entry = _shipped_out(shelf, name) if row is None else _entry_out(row)
    return DefinitionOut(**entry.model_dump(), fields=parse_toml(shelf, name, definition.toml))


def _toml_of_request(request: Request, shelf: Shelf, name: str, body: bytes) -> str:
    """Return the TOML text of the definition in a request, which contains TOML or JSON."""
    text = decode(shelf, name, body)
    if "json" in request.headers.get("content-type", "").lower():
        return toml_from_json(shelf, name, text)
    return text


def _check_own(shelf: Shelf, name: str) -> None:
    """Raise ``WrongState`` if a name belongs to knifetip's library, whose entries are read-only."""
    if name in load.names(shelf):
        raise WrongState("library.shipped", shelf=shelf.word, name=name)


def _add_routes(shelf: Shelf) -> None:
    """Add the routes for the definitions of one kind to the router."""
    word = shelf.word
    path = f"/{shelf.value}/{{name}}"
    body = {
        "requestBody": {
            "required": True,
            "content": {
                "application/json": {"schema": {"$ref": definition_ref(shelf)}},
                TOML: {"schema": {"type": "string"}},
            },
        }
    }

    @router.get(f"{path}/definition", name=f"get_{word}_definition")
    @requires(AccessScope.VIEWER, AccessScope.GATEWAY)
    def get_definition(
        service: ServiceDep, response: Response, name: EntryName, version: Version = None
    ) -> DefinitionOut:
        """Get a definition with all its fields, as the TOML files of knifetip's library have them.

        The ETag is the version, for ``If-Match``.
        """
        definition = service.store.library.definition(shelf, name, version)
        response.headers["ETag"] = f'"{definition.version}"'
        return _definition_out(service, definition)

    @router.get(
        f"{path}/toml",
        name=f"export_{word}",
        response_class=Response,
        responses=TOML_RESPONSE,
    )
    @requires(AccessScope.VIEWER, AccessScope.GATEWAY)
    def export(service: ServiceDep, name: EntryName, version: Version = None) -> Response:
        """Download a definition as TOML, as it was sent."""
        definition = service.store.library.definition(shelf, name, version)
        media = f"{TOML}; charset=utf-8"
        content = definition.toml.encode()
        return bytes_response(content, str(definition.version), media, f"{name}.toml")

    @router.get(f"{path}/versions", name=f"list_{word}_versions")
    @requires(AccessScope.VIEWER)
    def list_versions(
        service: ServiceDep,
        request: Request,
        response: Response,
        name: EntryName,
        wanted: Annotated[ListPage, Query()],
    ) -> list[VersionOut]:
        """List the versions of a definition, newest first; one of knifetip's library has none.

        The header `Link` contains the URL of the next page.
        """
        service.store.library.definition(shelf, name)
        versions = service.store.library.versions(shelf, name)
        rows = page_of(request, response, versions, wanted)
        return [VersionOut.model_validate(row) for row in rows]

    @router.put(
        path,
        name=f"save_{word}",
        openapi_extra=body,
        responses={201: {"model": DefinitionOut, "description": "The definition is new"}},
    )
    @requires(AccessScope.ADMIN)
    def save(
        service: ServiceDep,
        request: Request,
        response: Response,
        name: NewEntryName,
        body: Body,
        match: VersionMatch = None,
        by: By = "",
        note: Note = "",
    ) -> DefinitionOut:
        """Create a definition, or replace it by a new version; the request body is TOML or JSON.

        To replace a definition, send the version on which the change is based in the header
        ``If-Match``.  Jobs keep the version for which they were compiled.
        """
        _check_own(shelf, name)
        if not is_name(name):
            raise LibraryError("library.bad-name", shelf=word, name=name[:80], source=("name",))
        version, replace_any = version_of(match)
        text = _toml_of_request(request, shelf, name, body)
        title = check_definition(shelf, name, text)
        check_texts(word, name, parse_toml(shelf, name, text))
        definition = Definition(shelf, name, version or 0, text)
        row = service.store.library.save(
            definition,
            title,
            VersionNote(credited_name(by)[:100], harmless(note)[:200]),
            replace_any=replace_any,
        )
        response.status_code = 201 if row.version == 1 else 200
        response.headers["ETag"] = f'"{row.version}"'
        return _definition_out(service, Definition(shelf, name, row.version, row.text))

    @router.delete(path, name=f"delete_{word}", status_code=204)
    @requires(AccessScope.ADMIN)
    def delete(service: ServiceDep, name: EntryName, match: VersionMatch = None) -> None:
        """Delete a definition; the status is 409 if a job that has not ended uses it."""
        _check_own(shelf, name)
        service.store.library.delete(shelf, name, version_of(match)[0])


for _shelf in Shelf:
    _add_routes(_shelf)
