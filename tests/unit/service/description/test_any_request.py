"""schemathesis sends requests that follow the REST description to a server.

Every answer must be one that the description documents: its status, its media type and its schema.
The requests are the same in each run.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, cast

import pytest
import schemathesis
from hypothesis import HealthCheck, Phase, given, settings
from schemathesis.checks import not_a_server_error
from schemathesis.specs.openapi.checks import (
    content_type_conformance,
    response_schema_conformance,
    status_code_conformance,
)

from knifetip.server.app import create_app
from knifetip.service.http.scopes import AccessScope
from knifetip.service.settings import Settings
from tests.support.examples import is_quick
from tests.support.serving.server import (
    LocalClient,
    order_job,
    run_server,
    square,
    upload_drawing,
    wait_for_state,
)

pytestmark = pytest.mark.xdist_group("any-request")

CHECKS = [
    not_a_server_error,
    status_code_conformance,
    content_type_conformance,
    response_schema_conformance,
]
#: They wait for work or for events as long as the caller likes.
LEFT_OUT = {"claim", "get_events"}
#: Random requests to each operation; one in `make test`.
_EXAMPLES = {"admin": 1 if is_quick() else 3, "viewer": 1}
OPERATIONS = sorted(
    operation["operationId"]
    for item in create_app().openapi()["paths"].values()
    for operation in item.values()
)


class Shop:
    """A server with drawings and jobs, and keys of several roles."""

    def __init__(self, client: LocalClient) -> None:
        drawings = [upload_drawing(client, square(side=side))["id"] for side in (80.0, 120.0)]
        jobs = [order_job(client, drawings[0])["id"] for _ in range(2)]
        for job in jobs:
            wait_for_state(client, job, "ready")
        client.post(f"/api/jobs/{jobs[0]}/release").raise_for_status()
        self.url = str(client.base_url).rstrip("/")
        described = client.get("/api/openapi.json").json()
        _seed(described, {"/api/jobs/": jobs, "/api/drawings/": drawings})
        schema = schemathesis.openapi.from_dict(described)
        schema.config.update(base_url=self.url)
        self.operations: dict[str, Any] = {}
        for result in schema.get_all_operations():
            operation = cast("Any", result).ok()
            self.operations[operation.definition.raw["operationId"]] = operation
        users, keys = client.service.store.users, client.service.store.keys
        users.add("ada", "four words are long", AccessScope.ADMIN)
        self.keys = {role: keys.add(role, [AccessScope(role)], None)[1] for role in _EXAMPLES}


def _seed(described: dict[str, Any], ids: dict[str, list[str]]) -> None:
    """Let {id} in a path be one of the ids of stored objects."""
    for path, item in described["paths"].items():
        known = next((some for start, some in ids.items() if path.startswith(start)), None)
        for operation in item.values() if known else ():
            for parameter in operation.get("parameters", ()):
                if (parameter["in"], parameter["name"]) == ("path", "id"):
                    parameter["schema"] = {"type": "string", "enum": known}


@pytest.fixture(scope="module")
def shop(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Shop]:
    folder = tmp_path_factory.mktemp("shop")
    with run_server(Settings(database=f"sqlite:///{folder}/shop.sqlite", name="any")) as client:
        yield Shop(client)


@pytest.mark.parametrize("role", _EXAMPLES)
@pytest.mark.parametrize("name", [name for name in OPERATIONS if name not in LEFT_OUT])
def test_every_answer_is_documented(shop: Shop, name: str, role: str) -> None:
    operation = shop.operations[name]
    headers = {"Authorization": f"Bearer {shop.keys[role]}"}

    @settings(
        max_examples=_EXAMPLES[role],
        derandomize=True,
        database=None,
        deadline=None,
        phases=[Phase.generate],
        suppress_health_check=list(HealthCheck),
    )
    @given(case=operation.as_strategy())
    def send(case: Any) -> None:
        response = case.call(headers=headers)
        case.validate_response(response, checks=CHECKS, headers=headers)

    send()
