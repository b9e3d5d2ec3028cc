"""Options of edges in orders: starts and directions of closed cuts, passes and depths."""

from __future__ import annotations

from typing import Any

import httpx
import pytest

from tests.support.serving.server import order_job, square, upload_drawing, wait_for_state

pytestmark = pytest.mark.xdist_group("server")

STARTS = [{"edges": [1], "at": 0.25, "direction": "reverse"}]
DEPTHS = [{"edges": [], "line_type": "cut", "passes": 2, "depth": None}]


def made(client: httpx.Client, **options: object) -> tuple[dict[str, Any], bytes]:
    """Return a job for a square with some options, when it is compiled, and its program."""
    ordered = order_job(client, upload_drawing(client, square())["id"], **options)
    job = wait_for_state(client, ordered["id"], "ready", "refused")
    program = client.get(f"/api/jobs/{job['id']}/program")
    return job, program.content if job["state"] == "ready" else b""


def test_options_of_edges_are_kept_with_the_job_and_change_its_program(
    client: httpx.Client,
) -> None:
    plain, program = made(client)
    assert (plain["contour_starts"], plain["cut_depths"]) == ([], [])
    job, chosen = made(client, contour_starts=STARTS, cut_depths=DEPTHS)
    assert (job["state"], job["contour_starts"], job["cut_depths"]) == ("ready", STARTS, DEPTHS)
    assert job["program_sha256"] != plain["program_sha256"]
    # E-flute is 1.6 mm thick, and cuts are 1.9 mm deep: the first of two passes ends at 0.65 mm.
    assert b"Z0.6500" in chosen
    assert b"Z0.6500" not in program


def test_orders_with_the_same_options_have_the_same_program(client: httpx.Client) -> None:
    one, other = (made(client, contour_starts=STARTS)[0] for _ in range(2))
    assert one["program_sha256"] == other["program_sha256"]


def test_a_start_on_an_edge_that_is_not_drawn_refuses_the_job(client: httpx.Client) -> None:
    job, _ = made(client, contour_starts=[{"edges": [4], "at": 0.5}])
    assert job["state"] == "refused"
    assert job["message"]["code"] == "edge-choice.no-edge"


def test_an_order_of_the_work_is_kept_with_the_job_and_refuses_it_if_it_breaks_a_rule(
    client: httpx.Client,
) -> None:
    plain, program = made(client)
    assert plain["work_order"] == []
    job, same = made(client, work_order=[0, 2])
    assert (job["state"], job["work_order"], same) == ("ready", [0, 2], program)
    job, _ = made(client, work_order=[2, 0])
    assert job["state"] == "refused"
    assert job["message"]["arguments"]["error"]["code"] == "order.one-track"


def test_tools_are_kept_with_the_job_and_refuse_it_if_the_machine_lacks_them(
    client: httpx.Client,
) -> None:
    plain, program = made(client)
    assert plain["edge_tools"] == []
    machine = client.get(f"/api/machines/{plain['machine']}").json()
    makes = {station["number"]: set(station["line_types"]) for station in machine["stations"]}
    assert makes[1] == {"cut", "half-cut", "perforation", "combi"}
    assert makes[2] == {"crease", "combi"}
    chosen = [{"edges": [], "line_type": "cut", "station": 1}]
    job, same = made(client, edge_tools=chosen)
    assert (job["state"], job["edge_tools"], same) == ("ready", chosen, program)
    job, _ = made(client, edge_tools=[{"edges": [2], "station": 2}])
    assert job["state"] == "refused"
    error = job["message"]["arguments"]["error"]
    assert (error["code"], error["arguments"]["edge"]) == ("tool-choice.other-kind", 2)


@pytest.mark.parametrize(
    ("name", "choice", "code"),
    [
        ("edge_corners", {"line_type": "cut", "type": "D", "k": 0.3}, "corner-choice.no-cutter"),
        (
            "contour_leads",
            {"line_type": "cut", "length": 2.0, "approach": 45.0},
            "lead-choice.no-cutter",
        ),
    ],
)
def test_choices_for_cutters_are_kept_with_the_job_and_change_its_program(
    client: httpx.Client, name: str, choice: dict[str, Any], code: str
) -> None:
    chosen = [{"edges": [], **choice}]
    drawing = upload_drawing(client, square())["id"]
    programs = []
    for choices in ([], chosen):
        options: dict[str, Any] = {name: choices}
        ordered = order_job(client, drawing, machine="laser-table", board="e-flute", **options)
        job = wait_for_state(client, ordered["id"], "ready", "refused")
        assert (job["state"], job[name]) == ("ready", choices)
        programs.append(job["program_sha256"])
    assert programs[0] != programs[1]
    job, _ = made(client, **{name: chosen})
    assert job["state"] == "refused"
    assert job["message"]["arguments"]["error"]["code"] == code


def test_bridges_are_kept_with_the_job_and_stay_in_the_board(client: httpx.Client) -> None:
    _, program = made(client)
    bridges = [{"edges": [1], "at": 0.5, "width": 2.0}]
    job, held = made(client, bridges=bridges)
    assert (job["state"], job["bridges"]) == ("ready", bridges)
    # The knife is lifted once more, at the bridge.
    assert held.count(b"G1 Z-") == program.count(b"G1 Z-") + 1


def test_the_newest_order_of_a_customer_on_a_board_and_a_machine_is_found(
    client: httpx.Client,
) -> None:
    drawing = upload_drawing(client, square())["id"]
    orders = [
        order_job(client, drawing, customer=customer, board=board, feed_factor=factor)["id"]
        for customer, board, factor in (
            ("Last Time Ltd", "e-flute", 0.5),
            ("Last Time Ltd", "e-flute", 0.6),
            ("Last Time Ltd", "b-flute", 0.7),
            ("Other Ltd", "e-flute", 0.8),
        )
    ]
    machine = client.get(f"/api/jobs/{orders[0]}").json()["machine"]

    def newest(**wanted: str) -> list[tuple[str, float]]:
        found = client.get("/api/jobs", params={"limit": 1, "machine": machine, **wanted}).json()
        return [(job["id"], job["feed_factor"]) for job in found]

    assert newest(customer="Last Time Ltd", board="e-flute") == [(orders[1], 0.6)]
    assert newest(customer="Last Time Ltd", board="b-flute") == [(orders[2], 0.7)]
    assert newest(customer="Last Time Ltd", board="c-flute") == []
    assert client.get("/api/jobs", params={"board": "b" * 201}).status_code == 422


@pytest.mark.parametrize(
    ("fields", "path"),
    [
        ({"contour_starts": [{"edges": [0], "at": 1.5}]}, "contour_starts"),
        ({"contour_starts": [{"edges": [], "at": 0.5}]}, "contour_starts"),
        ({"contour_starts": [{"edges": [0], "direction": "left"}]}, "contour_starts"),
        ({"cut_depths": [{"edges": [0], "passes": 11}]}, "cut_depths"),
        ({"cut_depths": [{"edges": [0], "line_type": "cut", "passes": 2}]}, "cut_depths"),
        ({"cut_depths": [{"edges": [0], "depth": -1.0}]}, "cut_depths"),
        ({"edge_tools": [{"edges": [0], "station": 0}]}, "edge_tools"),
        ({"edge_tools": [{"edges": [0], "station": 256}]}, "edge_tools"),
        ({"edge_corners": [{"edges": [0], "type": "A"}]}, "edge_corners"),
        ({"edge_corners": [{"edges": [0], "type": "D", "k": 1.0}]}, "edge_corners"),
        ({"contour_leads": [{"edges": [0], "length": 0.0}]}, "contour_leads"),
        ({"contour_leads": [{"edges": [0], "approach": 91.0}]}, "contour_leads"),
        ({"work_order": [-1]}, "work_order"),
        ({"bridges": [{"edges": [0], "at": 0.5, "width": 0.0}]}, "bridges"),
        ({"bridges": [{"edges": [0], "at": 1.5}]}, "bridges"),
        ({"work_order": ["first"]}, "work_order"),
        ({"work_order": list(range(5001))}, "work_order"),
    ],
)
def test_invalid_options_of_edges_are_refused_on_order(
    client: httpx.Client, fields: dict[str, Any], path: str
) -> None:
    drawing = upload_drawing(client, square())["id"]
    answer = client.post("/api/jobs", json={"drawing": drawing, "board": "e-flute", **fields})
    assert answer.status_code == 422
    assert path in answer.text
