"""A drawing has the same JSON in REST and on the command line."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import httpx
import pytest

from knifetip.dxf.samples import samples
from tests.support.command import Command
from tests.support.serving.server import upload_drawing
from tests.support.writers import dxf_text as text

pytestmark = pytest.mark.xdist_group("server")

#: Fields of REST that belong to the stored drawing, not to its content.
STORED = {
    *("updated", "owner", "shared", "is_layout", "edits"),
    *("id", "revision", "created", "sha256"),
    *("unit_given", "unit_learned", "profile", "profile_state", "rules"),
    *("external_id", "customer", "due", "notes", "metadata", "learned"),
}
#: Fields of the command line that repeat fields of REST.
SHORTCUTS = {"size"}
#: Cut and crease, a duplicate and an overlap, a layer without a rule, and a text.
MIXED = (
    text.line(0, 0, 100, 0, (8, "CUT")),
    text.line(0, 0, 100, 0, (8, "CUT")),
    text.line(40, 0, 60, 0, (8, "CUT")),
    text.line(100, 0, 100, 80, (8, "CREASE")),
    text.line(10, 10, 20, 30, (8, "?")),
    text.entity("TEXT", (8, "NOTES"), (10, 5.0), (20, 6.0), (40, 3), (1, "Rev. B")),
)
DRAWINGS = {
    "mixed": text.dxf(*MIXED),
    "unknown unit": text.dxf(*MIXED, units=None),
    "sample": samples()["rigid-box-blank.dxf"],
}


@pytest.mark.parametrize("name", DRAWINGS)
def test_a_drawing_has_the_same_json_in_rest_and_on_the_command_line(
    knifetip: Command, client: httpx.Client, tmp_path: Path, name: str
) -> None:
    content = DRAWINGS[name]
    file = tmp_path / "square.dxf"
    file.write_bytes(content)
    id = upload_drawing(client, content)["id"]
    rest = client.get(f"/api/drawings/{id}").json()
    _, out, _ = knifetip("classify", file, "--json")
    printed = json.loads(out)
    drawing = printed["drawing"]
    assert drawing.keys() - SHORTCUTS == rest.keys() - STORED
    for field in drawing.keys() - SHORTCUTS:
        assert with_defaults(drawing[field]) == rest[field], field
    assert drawing["size"] == [rest["width"], rest["height"]]
    assert printed["questions"] == rest["questions"]
    assert printed["edges"] == client.get(f"/api/drawings/{id}/edges").json()["edges"]
    _, out, _ = knifetip("read", file, "--json")
    read = json.loads(out)["drawing"]
    for field in read.keys() - SHORTCUTS:
        assert with_defaults(read[field]) == rest[field], field


def with_defaults(printed: Any) -> Any:
    """Return printed JSON with default values for the import report fields that only REST
    includes.
    """
    if not (isinstance(printed, dict) and "rows" in printed):
        return printed
    absent = {"text": "", "place": None, "box": None}
    return {**printed, "rows": [{**absent, **row} for row in printed["rows"]]}
