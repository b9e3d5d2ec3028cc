"""/api/v1/testpieces: list, picture, drawing with options of the order, and figures."""

from __future__ import annotations

import math
import re
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
    assert (found["angle"]["shelf"], found["angle"]["path"]) == ("machines", ["squareness"])
    assert found["pulses-x"]["path"] == ["controller", "pulses", "x"]
    assert found["pulses-x"]["after"] == pytest.approx(200.0 * 500.0 / 501.0, abs=1e-5)
    assert not found["pulses-y"]["significant"]


def test_unknown_names_are_not_found(client: httpx.Client) -> None:
    assert client.get(f"{URL}/no-piece/picture", params=KNIFE).status_code == 404
    piece = {"code": "knife-depth", **KNIFE, "board": "no-board"}
    assert client.post(URL, json=piece).status_code == 404


def test_a_measured_angle_is_stored_and_corrected_by_programs_and_marks(
    client: httpx.Client,
) -> None:
    demo = client.get("/api/machines/demo-table/definition").json()["fields"]
    leaning = {**demo, "squareness": 89.5}
    assert client.put("/api/machines/leaning", json=leaning).status_code == 201
    bench = {**KNIFE, "machine": "leaning"}
    diagonal = (500.0**2 + 400.0**2) ** 0.5
    measures = {"width": 500.0, "height": 400.0, "diagonal_up": diagonal + 0.8}
    answer = figures(client, bench, code="squareness", **measures, diagonal_down=diagonal - 0.8)
    angle = next(figure for figure in answer.json() if figure["name"] == "angle")
    assert (angle["before"], angle["significant"]) == (89.5, True)
    # The rest of cos γ: (p² - q²) / (4 w' h') = 4 · 0.8 · 640.3 / 800000, 0.1467°.
    assert angle["after"] == pytest.approx(89.5 - 0.1467, abs=1e-3)
    changed = {**leaning, "squareness": angle["after"]}
    stored = client.put("/api/machines/leaning", json=changed, headers={"If-Match": '"1"'})
    assert stored.status_code == 200, stored.text
    assert client.get("/api/machines/leaning").json()["squareness"] == angle["after"]
    piece = client.post(URL, json={"code": "squareness", **bench}).json()
    order = {
        "drawing": piece["drawing"]["id"],
        "machine": "leaning",
        "board": "e-flute",
        "registration": {"marks": [[0.0, 0.0], [500.0, 0.0], [0.0, 400.0]], "scale": "keep"},
    }
    job = client.post("/api/v1/jobs", json=order).json()
    assert wait_for_state(client, job["id"], "ready", "refused")["state"] == "ready"
    program = client.get(f"/api/v1/jobs/{job['id']}/program").text
    # The upper left corner, at 20, 420: X is 420 cot γ to the left of the lower left one.
    x = 20.0 - 420.0 / math.tan(math.radians(angle["after"]))
    y = 420.0 / math.sin(math.radians(angle["after"]))
    words = [float(word) for word in re.findall(r"Y([\d.]+)", program)]
    assert min(abs(word - y) for word in words) < 0.06
    # Marks are measured at positions of the axes, and lie exactly where they are expected.
    places = [[20.0, 20.0], [520.0, 20.0], [x, y]]
    low = 20.0 / math.tan(math.radians(angle["after"]))
    places[:2] = [[u - low, v / math.sin(math.radians(angle["after"]))] for u, v in places[:2]]
    fit = client.post(
        f"/api/v1/jobs/{job['id']}/registration/fit", json={"positions": places}
    ).json()
    assert fit["largest_error"] < 1e-3
    assert fit["turn"] == pytest.approx(0.0, abs=1e-4)
    for mark in fit["marks"]:
        assert mark["measured"] == pytest.approx(mark["expected"], abs=1e-3)
