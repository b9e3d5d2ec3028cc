"""JSON bodies are not converted: a value has the type that the description states."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest
from pydantic import ValidationError

from knifetip.server.app import create_app
from knifetip.service.accounts import models as accounts
from knifetip.service.gateways import models as gateway
from knifetip.service.http.models import JsonBody, Parameters
from knifetip.service.machines import station_models as stations

#: Values that resemble one of a type, which pydantic would convert.
_SIMILAR: dict[str, tuple[Any, ...]] = {
    "boolean": (0, 1, "true", "yes", 1.0),
    "integer": ("1", True, 1.5),
    "number": ("1.5", True),
    "string": (1, True, 1.5),
}
_SAME: dict[str, Any] = {"boolean": True, "integer": 1.0, "number": 1, "string": "a"}


#: Errors for values of another type whose names do not contain ``_type``.
_OTHERS = ("int_from_float", "field.not-one-of", "field.not-a-time", "literal_error", "enum")


def models() -> dict[str, type[JsonBody]]:
    found = [JsonBody]
    for model in found:
        found += model.__subclasses__()
    return {model.__name__: model for model in found if model is not JsonBody}


def scalars() -> Iterator[tuple[str, str, str]]:
    """Yield each field of a body that has one simple type: model, field and type."""
    for name, model in sorted(models().items()):
        for field, schema in model.model_json_schema(mode="validation")["properties"].items():
            kinds = {part.get("type", "?") for part in schema.get("anyOf", [schema])} - {"null"}
            if len(kinds) == 1 and (kind := kinds.pop()) in _SIMILAR:
                yield name, field, kind


def types_refused(model: type[JsonBody], field: str, value: Any) -> bool:
    """Return whether a model refuses the type of a value, not its size or its spelling."""
    try:
        model.model_validate({field: value})
    except ValidationError as reason:
        faults = [fault for fault in reason.errors() if fault["loc"][:1] == (field,)]
        return any("_type" in fault["type"] or fault["type"] in _OTHERS for fault in faults)
    return False


FIELDS = list(scalars())


def test_all_types_of_fields_are_tried() -> None:
    assert {kind for _, _, kind in FIELDS} == set(_SIMILAR)
    assert len(FIELDS) > 80


@pytest.mark.parametrize(("name", "field", "kind"), FIELDS)
def test_similar_values_of_other_types_are_refused(name: str, field: str, kind: str) -> None:
    model = models()[name]
    for value in _SIMILAR[kind]:
        assert types_refused(model, field, value), (name, field, value)


@pytest.mark.parametrize(
    ("name", "field", "kind"), [entry for entry in FIELDS if entry[2] != "string"]
)
def test_a_number_without_fraction_is_an_integer_and_an_integer_a_number(
    name: str, field: str, kind: str
) -> None:
    assert not types_refused(models()[name], field, _SAME[kind]), (name, field)


@pytest.mark.parametrize(
    ("name", "field"), [entry[:2] for entry in FIELDS if entry[2] == "integer"]
)
def test_the_limits_of_integers_are_described(name: str, field: str) -> None:
    model = models()[name]
    schema = model.model_json_schema(mode="validation")["properties"][field]
    (number,) = (one for one in schema.get("anyOf", [schema]) if one.get("type") == "integer")
    for limit, beyond in (("minimum", -(10**12)), ("maximum", 10**12)):
        try:
            model.model_validate({field: beyond})
            kinds = set()
        except ValidationError as reason:
            kinds = {fault["type"] for fault in reason.errors() if fault["loc"][:1] == (field,)}
        assert (limit in number) == bool(kinds), (name, field, limit, kinds)


def test_all_bodies_of_the_api_are_strict() -> None:
    described = create_app().openapi()
    bodies = {
        content["schema"]["$ref"].rpartition("/")[2]
        for path in described["paths"].values()
        for operation in path.values()
        for media, content in operation.get("requestBody", {}).get("content", {}).items()
        if media == "application/json" and "$ref" in content["schema"]
    }
    assert len(bodies) > 20
    # The library checks these, as it checks its files.
    files = {"MachineDefinition", "BoardDefinition", "ToolDefinition"}
    assert bodies - set(models()) == files


def test_points_and_poses_are_lists_in_json() -> None:
    sent = {"operation": "tool_check", "station": 1, "point": [10, 20.5]}
    assert stations.OperationIn.model_validate(sent).point == (10.0, 20.5)
    beat = {"job": "a", "epoch": 1, "line": 2.0, "position": [1, 2, 3, 4]}
    assert gateway.HeartbeatIn.model_validate(beat).position == (1.0, 2.0, 3.0, 4.0)
    with pytest.raises(ValidationError):
        gateway.HeartbeatIn.model_validate({**beat, "position": ["1", 2, 3, 4]})


def test_query_parameters_are_texts_and_are_converted() -> None:
    assert not issubclass(accounts.AuditQuery, JsonBody)
    assert issubclass(accounts.AuditQuery, Parameters)
    assert accounts.AuditQuery.model_validate({"limit": "5"}).limit == 5
