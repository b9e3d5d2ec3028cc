"""/api/v1/testpieces: list, picture, drawing with options of the order, and figures."""

from __future__ import annotations

from typing import Any
from xml.etree import ElementTree

import httpx
import pytest
from jsonschema_rs import Draft202012Validator

from knifetip.testpieces.registry import WIZARDS
from tests.support.serving.server import wait_for_state

pytestmark = pytest.mark.xdist_group("server")

URL = "/api/v1/testpieces"
KNIFE: dict[str, Any] = {"machine": "demo-table", "board": "e-flute", "station": 1}


def figures(client: httpx.Client, bench: dict[str, Any], **measures: Any) -> httpx.Response:
    return client.post(f"{URL}/figures", json={**bench, "measures": measures})


def test_pieces_have_texts_and_schemas_of_their_measures(client: httpx.Client) -> None:
    listed = client.get(URL).json()
    assert [piece["code"] for piece in listed] == list(WIZARDS)
    for piece in listed:
        Draft202012Validator(piece["measures"])
        for text in ("name", "description", "instruction"):
            assert piece[text]["code"].startswith(f"testpiece.{piece['code']}")
            assert piece[text]["text"]


def test_a_picture_has_lines_and_dimensions(client: httpx.Client) -> None:
    answer = client.get(f"{URL}/v-cutter/picture", params={**KNIFE, "station": 3})
    assert (answer.status_code, answer.headers["content-type"]) == (200, "image/svg+xml")
    letters = [text.text for text in ElementTree.fromstring(answer.text).iter() if text.text]
    assert letters == ["b", "M"]


def test_a_piece_is_ordered_like_any_drawing(client: httpx.Client) -> None:
    made = client.post(URL, json={"code": "knife-depth", **KNIFE}).json()
    assert made["drawing"]["name"] == "knife-depth demo-table T1 e-flute.dxf"
    assert len(made["cut_depths"]) == 12
    assert made["crease_depths"] == []
    order = {
        "drawing": made["drawing"]["id"],
        "machine": "demo-table",
        "board": "e-flute",
        "cut_depths": made["cut_depths"],
    }
    job = client.post("/api/v1/jobs", json=order).json()
    assert wait_for_state(client, job["id"], "ready", "refused")["state"] == "ready"


def test_measures_give_old_and_new_values(client: httpx.Client) -> None:
    answer = figures(client, KNIFE, code="knife-depth", first_through=12)
    assert answer.status_code == 200, answer.text
    (found,) = answer.json()
    # The twelfth cut is 0.3 mm deeper than the board is thick, the one before 0.2 mm.
    assert (found["shelf"], found["path"]) == ("machines", ["station", 0, "datum", "z"])
    assert (found["before"], found["after"]) == pytest.approx((0.0, -0.25))
    assert found["uncertainty"] == pytest.approx(0.05)
    assert found["significant"]


@pytest.mark.parametrize(
    ("bench", "measures", "code"),
    [
        ({}, {"code": "knife-depth", "first_through": 1}, "testpiece.all-through"),
        ({}, {"code": "crease-depth"}, "testpiece.other-tool"),
        ({"station": 9}, {"code": "knife-depth", "first_through": 2}, "testpiece.unknown-station"),
        ({"station": 2}, {"code": "crease-depth"}, "testpiece.nothing-measured"),
        (
            {"station": 2},
            {"code": "station-offset", "distance_x": 35.0, "distance_y": 20.0},
            "testpiece.implausible",
        ),
        (
            {},
            {
                "code": "squareness",
                "width": 500.0,
                "height": 400.0,
                "diagonal_up": 640.0,
                "diagonal_down": 645.0,
            },
            "testpiece.no-parallelogram",
        ),
    ],
)
def test_measures_that_cannot_be_are_refused(
    client: httpx.Client, bench: dict[str, Any], measures: dict[str, Any], code: str
) -> None:
    answer = figures(client, {**KNIFE, **bench}, **measures)
    assert answer.status_code == 422, answer.text
    problem = answer.json()
    assert problem["code"] == code
    assert problem["hint"]


def test_pulses_in_the_file_of_a_machine_follow_the_scale(client: httpx.Client) -> None:
    bench = {**KNIFE, "machine": "v-groove-table"}
    sides = {"width": 501.0, "height": 400.0}
    diagonal = (501.0**2 + 400.0**2) ** 0.5
    answer = figures(
        client, bench, code="squareness", **sides, diagonal_up=diagonal, diagonal_down=diagonal
    )
    found = {figure["name"]: figure for figure in answer.json()}
    assert found["angle"]["after"] == pytest.approx(90.0)
    assert found["angle"]["shelf"] is None
    assert found["pulses-x"]["path"] == ["controller", "pulses", "x"]
    assert found["pulses-x"]["after"] == pytest.approx(200.0 * 500.0 / 501.0, abs=1e-5)
    assert not found["pulses-y"]["significant"]


def test_unknown_names_are_not_found(client: httpx.Client) -> None:
    assert client.get(f"{URL}/no-piece/picture", params=KNIFE).status_code == 404
    piece = {"code": "knife-depth", **KNIFE, "board": "no-board"}
    assert client.post(URL, json=piece).status_code == 404
