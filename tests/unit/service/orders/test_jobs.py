from __future__ import annotations

import hashlib
import math
import re
from itertools import pairwise
from typing import Any

import httpx
import numpy as np
import pytest

from knifetip.presentation.columns import unpack_columns
from tests.support.serving.server import order_job, square, upload_drawing, wait_for_state
from tests.support.writers import dxf_text as text

pytestmark = pytest.mark.xdist_group("server")


@pytest.fixture(scope="module")
def ready(client: httpx.Client) -> dict[str, Any]:
    """Return a job in state "ready"."""
    job = order_job(client, upload_drawing(client, square())["id"])
    return wait_for_state(client, job["id"], "ready")


def test_a_square_of_cuts_becomes_ready_with_a_verdict(
    client: httpx.Client, ready: dict[str, Any]
) -> None:
    assert ready["verdict"]["accepted"] is True
    assert ready["verdict"]["deviation"] <= 0.01
    assert ready["seconds"] > 0.0
    assert (ready["stage"], ready["progress"], ready["line"]) == ("", 1.0, 0)
    events = client.get(f"/api/jobs/{ready['id']}/events").json()
    assert [event["state"] for event in events] == ["received", "compiling", "ready"]


def test_the_program_is_served_byte_for_byte_as_it_was_verified(
    client: httpx.Client, ready: dict[str, Any]
) -> None:
    answer = client.get(f"/api/jobs/{ready['id']}/program")
    assert hashlib.sha256(answer.content).hexdigest() == ready["program_sha256"]
    assert answer.content.count(b"\n") == ready["lines"]
    assert answer.headers["content-disposition"] == 'attachment; filename="square-demo-table.ngc"'
    assert answer.headers["etag"] == f'"{ready["program_sha256"]}"'


def test_the_toolpath_has_columns_with_program_lines(
    client: httpx.Client, ready: dict[str, Any]
) -> None:
    columns, meta = unpack_columns(client.get(f"/api/jobs/{ready['id']}/toolpath").content)
    rows = len(columns["bulge"])
    assert columns["pose"].shape == (rows + 1, 4)
    assert all(len(columns[name]) == rows for name in ("motion", "feed", "source", "tool", "line"))
    assert meta["placement"] == [20.0, 20.0]
    assert [station["number"] for station in meta["stations"]] == [1, 2, 3]
    # Each of the four edges is cut, and the program line of each row is a motion.
    assert {0, 1, 2, 3} <= set(columns["source"].tolist())
    lines = client.get(f"/api/jobs/{ready['id']}/program").content.split(b"\n")
    assert all(b"G" in lines[line - 1] for line in columns["line"].tolist() if line > 0)
    assert (columns["line"] > 0).sum() >= 4


def test_the_moves_have_all_lines_of_the_program_that_move_and_the_machine_time(
    client: httpx.Client, ready: dict[str, Any]
) -> None:
    columns, _ = unpack_columns(client.get(f"/api/jobs/{ready['id']}/toolpath").content)
    assert columns["seconds"].sum() == pytest.approx(ready["seconds"], rel=1e-12)
    first, last = columns["first_line"], columns["line"]
    assert ((first < 0) == (last < 0)).all()
    assert (first[first > 0] <= last[first > 0]).all()
    assert (np.diff(last[last > 0]) >= 0).all()
    # Each line with a coordinate belongs to a move, except in the head and the foot.
    text = client.get(f"/api/jobs/{ready['id']}/program").text.split("\n")
    moving = {
        number
        for number, line in enumerate(text, start=1)
        if re.match(r"(N\d+ )?(G[0123] )?[XYZC]-?\d", line)
    }
    covered = {
        number
        for start, end in zip(first.tolist(), last.tolist(), strict=True)
        for number in range(start, end + 1)
    }
    assert len(moving) > 10
    assert not {line for line in moving - covered if min(covered) < line < max(covered)}
    assert columns["made_as"].tolist() == [0, 1, 2, 3]


def test_lines_of_a_program_are_served_by_their_numbers(
    client: httpx.Client, ready: dict[str, Any]
) -> None:
    address = f"/api/jobs/{ready['id']}/program"
    whole = client.get(address).content.split(b"\n")[:-1]
    part = client.get(address, params={"first_line": 3, "lines": 4})
    assert part.content == b"".join(line + b"\n" for line in whole[2:6])
    assert "content-disposition" not in part.headers
    known = {"If-None-Match": part.headers["etag"]}
    again = client.get(address, params={"first_line": 3, "lines": 4}, headers=known)
    assert again.status_code == 304
    last = client.get(address, params={"first_line": len(whole), "lines": 500})
    assert last.content == whole[-1] + b"\n"
    assert client.get(address, params={"first_line": len(whole) + 1, "lines": 5}).content == b""
    for wrong in ({"first_line": 0, "lines": 5}, {"lines": 10_001}, {"line": 3}):
        assert client.get(address, params=wrong).status_code == 422


def test_an_edge_has_the_section_that_the_tools_make(
    client: httpx.Client, ready: dict[str, Any]
) -> None:
    found = client.get(f"/api/jobs/{ready['id']}/section?edge=2").json()
    (tool,) = found["tools"]
    assert (tool["kind"], tool["shape"], tool["cross"]["blade_angle"]) == ("knife", "line", 10.0)
    # The knife of demo-table cuts 0.3 mm into the mat.
    assert (tool["depth"], tool["base"]) == (found["caliper"], 0.0)
    assert tool["beyond"] == pytest.approx(0.3)
    assert found["figures"]["deviation"] == pytest.approx(0.0, abs=0.01)
    missing = client.get(f"/api/jobs/{ready['id']}/section?edge=4")
    assert (missing.status_code, missing.json()["code"]) == (404, "override.no-such-edge")


def test_the_verdict_has_a_row_for_every_edge(client: httpx.Client, ready: dict[str, Any]) -> None:
    verdict = client.get(f"/api/jobs/{ready['id']}/verdict").json()
    assert len(verdict["edge_deviation"]) == len(verdict["edge_uncut"]) == 4
    assert verdict["deviation"] == max(verdict["edge_deviation"])
    for part in ("path_deviation", "blending", "fit_error"):
        assert len(verdict[f"edge_{part}"]) == 4
        assert verdict[part] == max(verdict[f"edge_{part}"])
    assert verdict["findings"] == []


def test_a_drawing_with_open_questions_is_409_with_the_questions(client: httpx.Client) -> None:
    mystery = text.line(10.0, 50.0, 90.0, 50.0, (8, "MYSTERY"), (62, 30))
    drawing = upload_drawing(client, square(units=None, extra=(mystery,)))["id"]
    answer = client.post("/api/jobs", json={"drawing": drawing, "board": "e-flute"})
    assert answer.status_code == 409
    assert answer.headers["content-type"] == "application/problem+json"
    kinds = [question["kind"] for question in answer.json()["questions"]]
    assert kinds == ["unit", "line-type"]
    assert [job for job in client.get("/api/jobs").json() if job["drawing"] == drawing] == []


def test_an_override_in_the_order_applies_to_the_job_only(client: httpx.Client) -> None:
    mystery = text.line(10.0, 50.0, 90.0, 50.0, (8, "MYSTERY"), (62, 30))
    drawing = upload_drawing(client, square(extra=(mystery,)))["id"]
    job = order_job(client, drawing, overrides=[{"type": "crease", "layer": "MYSTERY"}])
    wait_for_state(client, job["id"], "ready")
    assert len(client.get(f"/api/drawings/{drawing}").json()["questions"]) == 1


def test_a_drawing_larger_than_the_table_is_refused_with_its_measure(client: httpx.Client) -> None:
    drawing = upload_drawing(client, square(side=5000.0))["id"]
    job = wait_for_state(client, order_job(client, drawing)["id"], "refused")
    assert "5,000.0 × 5,000.0 mm" in job["reason"]
    assert job["hint"] != ""
    for part in ("program", "toolpath", "verdict"):
        assert client.get(f"/api/jobs/{job['id']}/{part}").status_code == 409


def test_a_job_is_released_and_cancelled(client: httpx.Client) -> None:
    drawing = upload_drawing(client, square())["id"]
    job = order_job(client, drawing)["id"]
    wait_for_state(client, job, "ready")
    assert client.post(f"/api/jobs/{job}/release").json()["state"] == "queued"
    assert client.post(f"/api/jobs/{job}/cancel").json()["state"] == "cancelled"
    assert client.post(f"/api/jobs/{job}/cancel").json()["state"] == "cancelled"
    again = client.post(f"/api/jobs/{job}/release")
    assert again.status_code == 409
    assert again.json()["type"] == "urn:knifetip:problem:wrong-state"


def test_a_job_that_has_not_changed_is_answered_with_304(client: httpx.Client) -> None:
    job = order_job(client, upload_drawing(client, square())["id"])
    wait_for_state(client, job["id"], "ready")
    url = f"/api/jobs/{job['id']}"
    first = client.get(url)
    known = {"If-None-Match": first.headers["ETag"]}
    same = client.get(url, headers=known)
    assert (same.status_code, same.content) == (304, b"")
    assert same.headers["ETag"] == first.headers["ETag"]
    client.patch(url, json={"priority": 3}).raise_for_status()
    changed = client.get(url, headers=known)
    assert (changed.status_code, changed.json()["priority"]) == (200, 3)
    assert changed.headers["ETag"] != first.headers["ETag"]


def test_jobs_are_listed_by_state_and_page_by_page(
    client: httpx.Client, ready: dict[str, Any]
) -> None:
    drawing = upload_drawing(client, square())["id"]
    new = [order_job(client, drawing)["id"] for _ in range(3)]
    for id in new:
        wait_for_state(client, id, "ready")
    first = client.get("/api/jobs", params={"state": "ready", "limit": 2})
    assert [job["id"] for job in first.json()] == new[:0:-1]
    path = first.headers["link"].split(">")[0].lstrip("<")
    rest = client.get(path).json()
    assert rest[0]["id"] == new[0]
    assert {job["state"] for job in rest} == {"ready"}
    nothing = client.get("/api/jobs", params={"state": ["running", "held"]})
    assert nothing.json() == []


def test_the_same_key_orders_once(client: httpx.Client) -> None:
    drawing = upload_drawing(client, square())["id"]

    def order(**more: object) -> httpx.Response:
        return client.post(
            "/api/jobs",
            json={"drawing": drawing, "board": "e-flute", **more},
            headers={"Idempotency-Key": "erp-1"},
        )

    first = order()
    assert order().json()["id"] == first.json()["id"]
    assert order(copies=2).status_code == 422
    mine = [job for job in client.get("/api/jobs").json() if job["drawing"] == drawing]
    assert len(mine) == 1


@pytest.mark.parametrize(
    ("field", "value", "words"),
    [
        ("machine", "no-such", "machine 'no-such'"),
        ("machine", "/etc/passwd.toml", "machine"),
        ("board", "../boards/e-flute", "board"),
        ("profile", "no-such", "profile 'no-such'"),
    ],
)
def test_names_missing_in_the_library_are_reported(
    client: httpx.Client, field: str, value: str, words: str
) -> None:
    drawing = upload_drawing(client, square())["id"]
    answer = client.post("/api/jobs", json={"drawing": drawing, "board": "e-flute", field: value})
    assert answer.status_code == 404
    assert words in answer.json()["detail"]
    assert answer.json()["hint"].startswith("Choose one of ")


def milled(client: httpx.Client, **fields: object) -> dict[str, Any]:
    """Order a frame of 200 mm with a window of 50 mm on the router table; return the job."""
    window = [text.line(*a, *b, (8, "CUT")) for a, b in pairwise(WINDOW)]
    drawing = upload_drawing(client, square(side=200.0, extra=tuple(window)))
    answer = client.post("/api/jobs", json={"drawing": drawing["id"], **MILLS, **fields})
    assert answer.status_code == 201, answer.text
    return wait_for_state(client, answer.json()["id"], "ready", "refused")


MILLS = {"machine": "router-table", "board": "greyboard-3.0"}
WINDOW = ((50.0, 50.0), (100.0, 50.0), (100.0, 100.0), (50.0, 100.0), (50.0, 50.0))
#: Area that a disc of radius 3 mm leaves in four right-angled corners: 4 r² (1 - π/4).
LEFT = 4 * 9 * (1 - math.pi / 4)


@pytest.fixture(scope="module")
def window(client: httpx.Client) -> dict[str, Any]:
    """Return a milled job in state "ready"."""
    return milled(client)


def test_an_order_without_corners_leaves_them_to_the_machine(window: dict[str, Any]) -> None:
    assert window["state"] == "ready"
    assert window["corners"] is None


def test_corners_are_kept_with_the_job_and_change_its_program(
    client: httpx.Client, window: dict[str, Any]
) -> None:
    at = [{"x": 0.0, "y": 200.1, "type": "C", "k": None}]
    chosen = {"type": "D", "k": 0.4, "interference": "trim", "at": at}
    job = milled(client, corners=chosen)
    assert (job["state"], job["corners"]) == ("ready", chosen)
    assert job["program_sha256"] != window["program_sha256"]
    # D goes l = k r = 1.2 mm straight and along an arc of r' = 1.8, C 3 mm straight to a bend;
    # 3.3 mm take two passes; the corners of the window have no transitions.
    program = client.get(f"/api/jobs/{job['id']}/program").text
    arcs = re.findall(r"^G2 .*$", program, re.MULTILINE)
    assert len(arcs) == 2 * 3
    assert all(re.search(r"[IJ]-?1\.8000", arc) for arc in arcs)
    assert program.count("Y223.0000\nG1 X") == 2, program


def test_a_corner_that_is_not_there_refuses_the_job_with_its_place(client: httpx.Client) -> None:
    job = milled(client, corners={"at": [{"x": 3.0, "y": 0.0, "type": "C"}]})
    assert job["state"] == "refused"
    assert job["reason"].startswith(
        "No corner of a milled contour lies within 0.5 mm of X 3 mm, Y 0 mm"
    )
    assert "3.00 mm away" in job["reason"]
    assert "(0.00, 0.00)" in job["hint"]


def test_corners_for_a_table_with_a_knife_are_refused_on_order(client: httpx.Client) -> None:
    drawing = upload_drawing(client, square())["id"]
    order = {"drawing": drawing, "board": "e-flute", "corners": {"type": "D"}}
    answer = client.post("/api/jobs", json=order)
    assert answer.status_code == 422
    assert answer.headers["content-type"] == "application/problem+json"
    assert "has no rotating cutter" in answer.json()["detail"]
    assert (
        answer.json()["hint"]
        == "Remove the corner types from the request, or choose a machine with a rotating cutter."
    )


@pytest.mark.parametrize(
    ("corners", "place"),
    [
        ('{"type": "E"}', "body.corners.type"),
        ('{"k": 0}', "body.corners.k"),
        ('{"k": 1}', "body.corners.k"),
        ('{"k": NaN}', "body.corners.k"),
        ('{"interference": "ignore"}', "body.corners.interference"),
        ('{"at": [{"x": 1e999, "y": 0, "type": "C"}]}', "body.corners.at.0.x"),
        ('{"at": [{"x": 0, "y": 0, "type": "C", "k": 1.5}]}', "body.corners.at.0.k"),
        ('{"at": [{"x": 0, "y": 0}]}', "body.corners.at.0.type"),
        ('{"radius": 3}', "body.corners.radius"),
    ],
)
def test_invalid_corners_are_reported(client: httpx.Client, corners: str, place: str) -> None:
    body = f'{{"drawing": "a", "board": "e-flute", "corners": {corners}}}'
    answer = client.post("/api/jobs", content=body, headers={"Content-Type": "application/json"})
    assert answer.status_code == 422
    assert place in answer.json()["source"]


def test_more_than_a_thousand_corners_are_refused(client: httpx.Client) -> None:
    at = [{"x": 0.0, "y": 0.0, "type": "C"}] * 1001
    order = {"drawing": "a", "board": "e-flute", "corners": {"at": at}}
    answer = client.post("/api/jobs", json=order)
    assert (answer.status_code, answer.json()["source"]) == (422, ["body.corners.at"])


def test_interference_refuse_refuses_what_trim_leaves_uncut(client: httpx.Client) -> None:
    # A slot of 4 mm that starts at the edge, and a cutter of 6 mm.
    notch = ((0.0, 0.0), (98.0, 0.0), (98.0, 60.0), (102.0, 60.0), (102.0, 0.0), (200.0, 0.0),
             (200.0, 200.0), (0.0, 200.0), (0.0, 0.0))  # fmt: skip
    lines = [text.line(*a, *b, (8, "CUT")) for a, b in pairwise(notch)]
    drawing = upload_drawing(client, text.dxf(*lines, units=4))["id"]
    states = {}
    for word in ("trim", "refuse"):
        order = {"drawing": drawing, **MILLS, "corners": {"interference": word}}
        job = client.post("/api/jobs", json=order).json()
        states[word] = wait_for_state(client, job["id"], "ready", "refused")
    # The program leaves the slot out, which is a shortfall.
    assert states["trim"]["state"] == "refused"
    assert "cannot reach" in states["trim"]["reason"]
    # 4 × 60 less the segment of the disc that enters the mouth.
    half = math.asin(2 / 3)
    segment = 9 * (half - math.sin(half) * math.cos(half))
    assert states["trim"]["verdict"]["unreached"] == pytest.approx(240 - segment, rel=2e-3)
    assert states["trim"]["verdict"]["unreached_places"] == 1
    assert states["refuse"]["state"] == "refused"
    assert "mm" in states["refuse"]["reason"]


def test_unreached_areas_are_reported_with_their_positions(
    client: httpx.Client, window: dict[str, Any]
) -> None:
    assert window["verdict"]["unreached"] == pytest.approx(LEFT, abs=0.05)
    assert window["verdict"]["unreached_places"] == 4
    verdict = client.get(f"/api/jobs/{window['id']}/verdict").json()
    places = {(round(area["x"]), round(area["y"])) for area in verdict["areas"]}
    assert places == {(51, 51), (99, 51), (99, 99), (51, 99)}
    assert sum(area["area"] for area in verdict["areas"]) == pytest.approx(LEFT, abs=0.05)
    assert [(finding["kind"], finding["severity"]) for finding in verdict["findings"]] == [
        ("unreached", "note")
    ] * 4
    assert verdict["unreached_length"] == pytest.approx(24.0, abs=0.2)
    # 3 mm remain at both ends of each side of the window.
    assert sorted(verdict["edge_unreached"])[4:] == pytest.approx([6.0] * 4, abs=0.05)


def test_the_verdict_as_columns_has_the_map_and_the_outlines(
    client: httpx.Client, window: dict[str, Any]
) -> None:
    answer = client.get(f"/api/jobs/{window['id']}/verdict", params={"format": "columns"})
    columns, meta = unpack_columns(answer.content)
    assert meta["accepted"] is True
    assert set(columns["sample_edge"].tolist()) == set(range(8))
    assert np.abs(columns["sample_deviation"]).max() <= 0.01
    assert (columns["sample_place"] >= 0.0).all()
    assert (columns["sample_place"] <= 1.0).all()
    assert columns["area_first"].tolist() == [0, 3, 6, 9, 12]
    assert columns["area_ends"].shape == (12, 2, 2)
    # In drawing coordinates (mm): inside the window.
    assert columns["area_ends"].min() == pytest.approx(50.0)
    assert columns["area_ends"].max() == pytest.approx(100.0)


def test_the_verdict_has_the_figures_of_grooves_and_knives(client: httpx.Client) -> None:
    lines = (text.line(0.0, 50.0, 100.0, 50.0, (8, "V-GROOVE")),)
    drawing = upload_drawing(client, square(extra=lines))["id"]
    job = wait_for_state(
        client, order_job(client, drawing, board="greyboard-2.0")["id"], "ready", "refused"
    )
    verdict = client.get(f"/api/jobs/{job['id']}/verdict").json()
    # A groove 1.3 mm deep at 45° in 2.0 mm: 2.6 mm wide, with a web of 0.7 mm.
    assert verdict["edge_width"] == pytest.approx([0, 0, 0, 0, 2.6], abs=1e-3)
    assert verdict["edge_web"] == pytest.approx([0, 0, 0, 0, 0.7], abs=1e-3)
    assert len(verdict["edge_flank"]) == len(verdict["edge_bottom_uncut"]) == 5
    assert max(verdict["edge_top_overcut"]) > 0.0


def test_the_time_saved_by_least_lifts_is_reported(
    ready: dict[str, Any], window: dict[str, Any]
) -> None:
    for job in (ready, window):
        assert job["verdict"]["seconds"] < job["verdict"]["seconds_retracted"]


@pytest.mark.parametrize(
    ("sheet", "state"),
    [
        ({"width": 120.0, "height": 110.0, "margin": 4.0}, "ready"),
        ({"width": 120.0, "height": 110.0, "margin": 4.0, "margin_below": 9.0}, "ready"),
        ({"width": 120.0, "height": 110.0, "margin": 4.0, "margin_below": 11.0}, "refused"),
        ({"width": None, "height": None, "margin": 0.0}, "ready"),
        ({"width": 50.0, "height": 110.0, "margin": 0.0}, "refused"),
    ],
)
def test_a_sheet_is_kept_with_the_job_and_must_hold_the_drawing(
    client: httpx.Client, sheet: dict[str, float | None], state: str
) -> None:
    drawing = upload_drawing(client, square())["id"]
    order = {"drawing": drawing, "board": "greyboard-2.0", "sheet": sheet}
    answer = client.post("/api/jobs", json=order)
    assert answer.status_code == 201, answer.text
    job = wait_for_state(client, answer.json()["id"], "ready", "refused")
    assert (job["state"], job["sheet"]) == (state, {"margin_below": None, **sheet})
    if state == "refused":
        assert job["message"]["code"] == "sheet.smaller-than-drawing"


@pytest.mark.parametrize(
    "sheet", [{"width": 100.0}, {"height": 100.0}, {"margin": 3.0}, {"width": 0.0, "height": 9.0}]
)
def test_half_a_sheet_is_refused_on_order(client: httpx.Client, sheet: dict[str, float]) -> None:
    drawing = upload_drawing(client, square())["id"]
    order = {"drawing": drawing, "board": "greyboard-2.0", "sheet": sheet}
    answer = client.post("/api/jobs", json=order)
    assert answer.status_code == 422
    assert answer.headers["content-type"] == "application/problem+json"
    assert "sheet" in answer.json()["detail"]


def test_the_least_lift_is_kept_with_the_job_and_saves_time(
    client: httpx.Client, ready: dict[str, Any]
) -> None:
    assert ready["lift"] == "clearance"
    drawing = upload_drawing(client, square())["id"]
    order = {"drawing": drawing, "board": ready["board"], "lift": "least"}
    answer = client.post("/api/jobs", json=order)
    assert answer.status_code == 201, answer.text
    job = wait_for_state(client, answer.json()["id"], "ready", "refused")
    assert (job["state"], job["lift"]) == ("ready", "least")
    assert job["seconds"] < ready["seconds"]


def test_the_least_lift_is_refused_on_order_for_a_machine_without_one(client: httpx.Client) -> None:
    drawing = upload_drawing(client, square())["id"]
    answer = client.post("/api/jobs", json={"drawing": drawing, **MILLS, "lift": "least"})
    assert answer.status_code == 422
    assert answer.json()["code"] == "lift.not-stated"
