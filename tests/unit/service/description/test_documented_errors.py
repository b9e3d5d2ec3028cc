"""Every operation documents its errors, and an example of its request and its answer."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterator
from typing import Any

import pytest
from fastapi.dependencies.models import Dependant
from fastapi.routing import APIRoute, iter_route_contexts
from jsonschema_rs import Draft202012Validator

from knifetip.messages.codes import CODES
from knifetip.server.app import create_app
from knifetip.service.description.documented_errors import declared_errors
from tests.support.raised_codes import raised

#: A damaged file of the library, or row of the store; no request causes them.
DAMAGE = {
    "library.large-integer",
    "library.nested-too-deep",
    "library.not-toml",
    "library.unknown-file",
    "profile.nested-too-deep",
    "profile.not-toml",
    "profile.too-long",
}
APP = create_app()
API: dict[str, Any] = APP.openapi()
OPERATIONS = {
    operation["operationId"]: operation
    for item in API["paths"].values()
    for operation in item.values()
}
ROUTES = {
    context.original_route.name.strip("_"): context.original_route
    for context in iter_route_contexts(list(APP.routes))
    if isinstance(context.original_route, APIRoute) and context.original_route.include_in_schema
}


def functions(route: APIRoute) -> Iterator[Callable[..., Any]]:
    """Yield the endpoint of a route and its dependencies."""

    def dependencies(dependant: Dependant) -> Iterator[Callable[..., Any]]:
        for one in dependant.dependencies:
            if one.call is not None:
                yield inspect.unwrap(one.call)
            yield from dependencies(one)

    yield route.endpoint
    yield from dependencies(route.dependant)


def documented(operation: dict[str, Any]) -> set[tuple[int, str]]:
    return {
        (int(status), code)
        for status, response in operation["responses"].items()
        for code in response.get("content", {})
        .get("application/problem+json", {})
        .get("examples", {})
    }


def faults(examples: list[tuple[str, dict[str, Any], Any]]) -> list[str]:
    """Return the faults of examples, each with a name and its schema; one validator for all."""
    schema = {"prefixItems": [one[1] for one in examples], "components": API["components"]}
    found = Draft202012Validator(schema).iter_errors([one[2] for one in examples])
    return [f"{examples[int(fault.instance_path[0])][0]}: {fault.message}" for fault in found]


@pytest.mark.parametrize("name", ROUTES)
def test_the_errors_that_the_source_raises_are_documented(name: str) -> None:
    found = {error for one in functions(ROUTES[name]) for error in raised(one)}
    missing = {error for error in found if error[1] not in DAMAGE} - documented(OPERATIONS[name])
    assert not missing


def test_the_search_of_the_source_finds_errors_of_routes_stores_and_dependencies() -> None:
    def codes(name: str) -> set[tuple[int, str]]:
        return {error for one in functions(ROUTES[name]) for error in raised(one)}

    assert (404, "drawing.unknown") in codes("get_drawing")  # a method of a repository
    assert (409, "drawing.changing") in codes("change_drawing")  # a function of another module
    assert (412, "drawing.stale") in codes("order_job")  # the constructor of an error
    assert (404, "library.unknown") in codes("order_job")
    assert (409, "job.wrong-state") in codes("scrap_job")  # a method that a method calls


def test_the_declared_errors_are_of_operations_that_exist() -> None:
    assert not set(declared_errors()) - set(OPERATIONS)
    codes = {code for one in declared_errors().values() for group in one.values() for code in group}
    assert not codes - set(CODES)


def test_every_error_has_an_example_that_follows_the_schema() -> None:
    for operation in OPERATIONS.values():
        statuses = {status for status, _ in documented(operation)}
        assert {400, 429, 500, 503} <= statuses
        assert not operation["security"] or {401, 403, 422} <= statuses
        assert "default" not in operation["responses"]
    examples = []
    for name, example in API["components"]["examples"].items():
        code, _, status = name.rpartition("-")
        problem = example["value"]
        assert (problem["code"], problem["status"]) == (code, int(status))
        examples.append((name, {"$ref": "#/components/schemas/Problem"}, problem))
        message = {key: problem[key] for key in ("code", "arguments")}
        examples.append((name, {"$ref": "#/components/schemas/Message"}, message))
    assert not faults(examples)


def test_every_operation_with_an_idempotency_key_documents_that_it_was_reused() -> None:
    keyed = {
        name
        for name, operation in OPERATIONS.items()
        if "Idempotency-Key" in [one["name"] for one in operation.get("parameters", ())]
    }
    assert {"release_job", "upload_drawing", "answer_xjmf"} <= keyed
    missing = {
        name for name in keyed if (422, "request.key-reused") not in documented(OPERATIONS[name])
    }
    assert not missing


def test_documented_examples_of_errors_exist() -> None:
    for name, operation in OPERATIONS.items():
        for status, code in documented(operation):
            assert f"{code}-{status}" in API["components"]["examples"], name


def test_requests_and_answers_have_examples_that_follow_their_schemas() -> None:
    examples = []
    for name, operation in OPERATIONS.items():
        contents = [operation.get("requestBody", {}).get("content", {})]
        contents += [one.get("content", {}) for one in operation["responses"].values()]
        for content in contents:
            media = content.get("application/json")
            if media is not None:
                examples.append((name, media["schema"], media["example"]))
    assert len(examples) > 100
    assert not faults(examples)


def test_bodies_that_are_no_json_have_examples() -> None:
    missing = set()
    for name, operation in OPERATIONS.items():
        contents = [operation.get("requestBody", {}).get("content", {})]
        contents += [one.get("content", {}) for one in operation["responses"].values()]
        for content in contents:
            for media, body in content.items():
                is_binary = body.get("schema", {}).get("format") == "binary"
                if not is_binary and not {"example", "examples"} & set(body):
                    missing.add((name, media))
    # Definitions have an example as JSON; the streams have no end.
    assert missing <= {
        *((name, "application/toml") for name in OPERATIONS if name.startswith("save_")),
        ("keep_profile", "application/toml"),
        ("get_events", "text/event-stream"),
        ("metrics", "text/plain"),
    }


def test_a_wrong_example_is_a_fault() -> None:
    schema = {"$ref": "#/components/schemas/Problem"}
    assert faults([("wrong", schema, {"code": 7})])
