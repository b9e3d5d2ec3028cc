"""Scopes: what roles contain, what routes declare, and how a missing scope is refused."""

from __future__ import annotations

import pytest
from fastapi import APIRouter

from knifetip.errors import AccessDenied
from knifetip.server import app as application
from knifetip.service.http.principal import (
    LOCAL,
    SERVER_KEY,
    Principal,
    PrincipalKind,
    demand,
    missing_scope,
)
from knifetip.service.http.routing import ScopedRouter, public, requires
from knifetip.service.http.scopes import AccessScope, least_role, scopes_of, scopes_of_role

VIEWER, DESIGNER, OPERATOR, ADMIN, GATEWAY, READ, ORDER, WEBHOOKS, STATION = AccessScope


def principal(*scopes: AccessScope) -> Principal:
    return Principal(PrincipalKind.KEY, "ERP", scopes=scopes_of(scopes))


def test_a_role_contains_the_lesser_ones_and_never_the_gateway() -> None:
    assert scopes_of([VIEWER]) == {VIEWER}
    assert scopes_of([OPERATOR]) == {VIEWER, DESIGNER, OPERATOR}
    assert scopes_of([ADMIN]) == {VIEWER, DESIGNER, OPERATOR, ADMIN}
    assert scopes_of([GATEWAY]) == {GATEWAY}
    assert scopes_of([GATEWAY, DESIGNER]) == {GATEWAY, VIEWER, DESIGNER}
    assert scopes_of([]) == set()


def test_a_person_who_operates_may_start_machines_and_a_key_only_if_it_is_named() -> None:
    assert scopes_of_role(DESIGNER) == {VIEWER, DESIGNER}
    assert scopes_of_role(OPERATOR) == {VIEWER, DESIGNER, OPERATOR, STATION}
    assert scopes_of_role(ADMIN) == {VIEWER, DESIGNER, OPERATOR, ADMIN, STATION}
    assert scopes_of([ADMIN]) == {VIEWER, DESIGNER, OPERATOR, ADMIN}
    assert scopes_of([STATION]) == {VIEWER, STATION}
    assert scopes_of([READ]) == {VIEWER, READ}
    assert scopes_of([ORDER, WEBHOOKS]) == {VIEWER, ORDER, WEBHOOKS}
    assert [least_role(scope) for scope in (VIEWER, STATION, GATEWAY)] == [VIEWER, OPERATOR, None]
    assert missing_scope(principal(ADMIN), [STATION]) == STATION
    assert missing_scope(SERVER_KEY, [STATION]) is None


def test_the_least_scope_that_is_missing_is_named() -> None:
    assert missing_scope(principal(VIEWER), [DESIGNER]) == DESIGNER
    assert missing_scope(principal(ADMIN), [GATEWAY]) == GATEWAY
    assert missing_scope(principal(GATEWAY), [VIEWER, GATEWAY]) is None
    assert missing_scope(principal(), [GATEWAY, VIEWER]) == VIEWER
    assert missing_scope(principal(), []) is None
    with pytest.raises(AccessDenied, match="operator"):
        demand(principal(DESIGNER), OPERATOR)
    demand(LOCAL, ADMIN)


def test_a_route_without_a_declaration_makes_the_application_fail(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def endpoint() -> None:
        """Do nothing."""

    class Module:
        router: APIRouter = ScopedRouter()

    Module.router.get("/extra")(endpoint)
    monkeypatch.setattr(application, "_ROUTES", (*application._ROUTES, Module))
    with pytest.raises(TypeError, match="endpoint declares no scope"):
        application.create_app()
    requires(VIEWER)(endpoint)
    application.create_app()
    Module.router = APIRouter()
    Module.router.get("/other")(public(endpoint))
    with pytest.raises(TypeError, match="/api/other is not in a ScopedRouter"):
        application.create_app()
    with pytest.raises(TypeError, match="@public"):
        requires()


def test_the_schema_names_the_scope_of_each_operation() -> None:
    described = application.create_app().openapi()
    paths = described["paths"]
    assert set(described["components"]["securitySchemes"]) == {"key", "session"}
    release = paths["/api/v1/jobs/{id}/release"]["post"]
    assert release["security"] == [
        {"key": ["operator"]},
        {"session": ["operator"]},
        {"key": ["order"]},
        {"session": ["order"]},
    ]
    assert "Needs the scope `operator` or `order`." in release["description"]
    assert paths["/healthz"]["get"]["security"] == []
