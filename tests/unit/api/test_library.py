from __future__ import annotations

import httpx
import pytest

pytestmark = pytest.mark.xdist_group("server")


def test_the_demo_table_shows_its_stations_with_their_dimensions(client: httpx.Client):
    (machine,) = [row for row in client.get("/api/machines").json() if row["name"] == "demo-table"]
    assert (machine["width"], machine["height"]) == (1600.0, 1200.0)
    wheel = machine["stations"][1]
    assert wheel["datum"] == {"x": 60.0, "y": 0.0, "z": -1.5, "c": 0.0}
    assert wheel["tool"]["kind"] == "crease-wheel"
    assert wheel["tool"]["dimensions"]["radius"] == 15.0
    assert client.get("/api/machines/demo-table").json() == machine


def test_boards_and_profiles_are_listed_and_looked_at(client: httpx.Client):
    boards = client.get("/api/boards").json()
    assert {"e-flute", "greyboard-2.0", "fbb-0.4"} <= {board["name"] for board in boards}
    assert client.get("/api/boards/greyboard-2.0").json()["caliper"] == 2.0
    profiles = client.get("/api/profiles").json()
    default = client.get("/api/profiles/default").json()
    assert default in profiles
    assert {"cut", "crease", "v-groove"} <= {rule["type"] for rule in default["rules"]}


def test_tools_say_where_they_are_mounted(client: httpx.Client):
    tools = client.get("/api/tools").json()
    mounted = {(tool["station"], tool["kind"]) for tool in tools if tool["machine"] == "demo-table"}
    assert mounted == {(1, "knife"), (2, "crease-wheel"), (3, "v-cutter")}
