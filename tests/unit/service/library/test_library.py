from __future__ import annotations

from pathlib import Path
from typing import Any

import httpx
import pytest

from knifetip.formats import FORMATS
from knifetip.formats.conversion import GHOSTSCRIPT, LIBREDWG
from tests.support.converters import install_fake

pytestmark = pytest.mark.xdist_group("server")


def test_the_demo_table_shows_its_stations_with_their_dimensions(client: httpx.Client) -> None:
    (machine,) = [row for row in client.get("/api/machines").json() if row["name"] == "demo-table"]
    assert (machine["width"], machine["height"]) == (1600.0, 1200.0)
    assert machine["feed"] == "manual"
    wheel = machine["stations"][1]
    assert wheel["datum"] == {"x": 60.0, "y": 0.0, "z": -1.5, "c": 0.0}
    assert wheel["tool"]["kind"] == "crease-wheel"
    assert wheel["tool"]["dimensions"]["radius"] == 15.0
    assert client.get("/api/machines/demo-table").json() == machine


def test_a_table_with_two_carriages_shows_all_its_axes(client: httpx.Client) -> None:
    machine = client.get("/api/machines/two-carriage-table").json()
    assert set(machine["axes"]) == set("xyzcva")
    assert machine["axes"]["v"]["velocity"] == 1200.0
    assert [row["letters"] for row in machine["carriages"]] == ["XYZC", "XVZA"]
    assert [row["carriage"] for row in machine["stations"]] == [1, 2, 2]
    assert machine["min_distance"] == 200.0


def test_boards_and_profiles_are_listed_and_returned(client: httpx.Client) -> None:
    boards = client.get("/api/boards").json()
    assert {"e-flute", "greyboard-2.0", "fbb-0.4"} <= {board["name"] for board in boards}
    assert client.get("/api/boards/greyboard-2.0").json()["caliper"] == 2.0
    profiles = client.get("/api/profiles").json()
    default = client.get("/api/profiles/default").json()
    assert default in profiles
    assert {"cut", "crease", "v-groove"} <= {rule["type"] for rule in default["rules"]}


def test_tools_have_the_stations_of_their_machines(client: httpx.Client) -> None:
    tools = client.get("/api/tools").json()
    mounted = {(tool["station"], tool["kind"]) for tool in tools if tool["machine"] == "demo-table"}
    assert mounted == {(1, "knife"), (2, "crease-wheel"), (3, "v-cutter")}


POINTS = [
    {"azimuth": 0.0, "dx": 0.0, "dy": 0.05},
    {"azimuth": 90.0, "dx": -0.08, "dy": 0.0},
]
MEASURED = {"machine": "router-table", "tool": "Router", "points": POINTS}


def test_a_cutter_is_calibrated_from_measured_points(client: httpx.Client) -> None:
    answer = client.post("/api/boards/greyboard-3.0/deflection", json=MEASURED)
    assert answer.status_code == 200, answer.text
    made = answer.json()
    # σ = 1: ΔX = -δx sin a, ΔY = δy cos a.
    assert (made["x"], made["y"]) == pytest.approx((0.08, 0.05))
    assert made["residual"] == pytest.approx(0.0, abs=1e-12)
    assert made["toml"] == "[deflection.Router]\nx = 0.0800\ny = 0.0500\n"


def test_insufficient_directions_are_refused_with_directions_to_measure(
    client: httpx.Client,
) -> None:
    order = {**MEASURED, "points": POINTS[:1]}
    answer = client.post("/api/boards/greyboard-3.0/deflection", json=order)
    assert answer.status_code == 422
    assert answer.headers["content-type"] == "application/problem+json"
    assert "At every measured point the contour runs nearly along X" in answer.json()["detail"]
    assert answer.json()["hint"].startswith("Measure one more point where the contour runs along Y")


def test_points_on_the_wrong_side_are_refused(client: httpx.Client) -> None:
    order = {**MEASURED, "side": "right"}
    answer = client.post("/api/boards/greyboard-3.0/deflection", json=order)
    assert answer.status_code == 422
    assert "a sign or the side is probably wrong" in answer.json()["detail"]


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"tool": "V-cutter"}, "has no cutter with the name 'V-cutter'"),
        ({"machine": "demo-table"}, "has no cutter with the name 'Router'"),
        ({"machine": "no-table"}, "The machine 'no-table' does not exist"),
        ({"points": []}, "body.points"),
        ({"points": [{"azimuth": 0, "dx": "far", "dy": 0}]}, "body.points.0.dx"),
    ],
)
def test_an_invalid_calibration_is_refused(
    client: httpx.Client, change: dict[str, Any], words: str
) -> None:
    answer = client.post("/api/boards/greyboard-3.0/deflection", json={**MEASURED, **change})
    assert answer.status_code == (404 if "does not exist" in words else 422)
    assert words in answer.json()["detail"]


def test_the_formats_are_those_of_the_registry(client: httpx.Client) -> None:
    listed = client.get("/api/formats").json()
    assert [one["name"] for one in listed] == [one.name for one in FORMATS]
    assert {".dxf", ".svgz", ".ai", ".cf2"} < {end for one in listed for end in one["extensions"]}


def test_formats_state_the_program_that_they_need_and_whether_it_is_installed(
    client: httpx.Client, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setenv(GHOSTSCRIPT.variable, "off")
    install_fake(monkeypatch, tmp_path, LIBREDWG, "")
    listed = {one["name"]: one for one in client.get("/api/formats").json()}
    programs = {name: (one["converter"], one["available"]) for name, one in listed.items()}
    assert programs["dxf"] == (None, True)
    assert programs["eps"] == ("Ghostscript", False)
    assert programs["dwg"] == ("LibreDWG", True)
