"""Answers in the drawings of a customer decide in the customer's next drawings."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import httpx
import pytest

from tests.support.serving.server import order_job, square
from tests.support.writers import dxf_text as text

pytestmark = pytest.mark.xdist_group("server")


def lines(side: float, *more: str) -> bytes:
    return square(side=side, extra=(text.line(20.0, 30.0, 60.0, 30.0, (8, "Q7"), (62, 5)), *more))


def upload(client: httpx.Client, content: bytes, name: str, customer: str) -> dict[str, Any]:
    files = {"file": (name, content)}
    answer = client.post("/api/drawings", files=files, data={"customer": customer})
    assert answer.status_code == 201, answer.text
    return dict(answer.json())


def answer_all(client: httpx.Client, drawing: dict[str, Any], type: str) -> dict[str, Any]:
    overrides = [{"type": type, "edges": one["edges"]} for one in drawing["questions"]]
    answer = client.patch(f"/api/drawings/{drawing['id']}/edges", json={"overrides": overrides})
    assert answer.status_code == 200, answer.text
    return dict(answer.json())


def teach(client: httpx.Client, customer: str, type: str = "perforation") -> None:
    for at, side in enumerate((100.0, 110.0)):
        drawing = upload(client, lines(side), f"{customer}-{at}.dxf", customer)
        assert len(drawing["questions"]) == 1
        assert answer_all(client, drawing, type)["questions"] == []


def types(client: httpx.Client, id: str) -> list[str]:
    return [edge["type"] for edge in client.get(f"/api/drawings/{id}/edges").json()["edges"]]


def test_the_third_drawing_asks_nothing_and_names_its_reason(client: httpx.Client) -> None:
    teach(client, "acme")
    third = upload(client, lines(120.0), "third.dxf", "acme")
    assert third["questions"] == []
    (learned,) = third["learned"]
    assert (learned["type"], learned["layer"], learned["edges"]) == ("perforation", "q7", [4])
    assert learned["drawings"] == ["acme-1.dxf", "acme-0.dxf"]
    (edge,) = client.get(f"/api/drawings/{third['id']}/edges").json()["edges"][4:]
    assert edge["type"] == "perforation"
    assert "acme-1.dxf" in edge["rule"]


def test_an_order_without_a_person_uses_what_was_learned(client: httpx.Client) -> None:
    teach(client, "erp", "crease")
    third = upload(client, lines(120.0), "third.dxf", "erp")
    job = order_job(client, third["id"], machine="demo-table")
    assert job["questions"] == []
    stranger = upload(client, lines(130.0), "third.dxf", "")
    body = {"drawing": stranger["id"], "machine": "demo-table", "board": "e-flute"}
    assert client.post("/api/jobs", json=body).status_code == 409


def test_answers_do_not_reach_another_customer(client: httpx.Client) -> None:
    teach(client, "one")
    for customer in ("another", "One", ""):
        drawing = upload(client, lines(120.0), "third.dxf", customer)
        assert len(drawing["questions"]) == 1, customer
        assert drawing["learned"] == []
        assert client.get(f"/api/drawings/{drawing['id']}/customer-answers").json() == []


def test_a_new_customer_of_a_drawing_brings_its_answers(client: httpx.Client) -> None:
    teach(client, "late")
    drawing = upload(client, lines(120.0), "third.dxf", "")
    url = f"/api/drawings/{drawing['id']}"
    changed = client.patch(url, json={"customer": "late"}).json()
    assert (changed["customer"], changed["questions"]) == ("late", [])
    assert len(client.patch(url, json={"customer": "nobody"}).json()["questions"]) == 1


def test_an_answer_is_taken_back_and_used_again(client: httpx.Client) -> None:
    teach(client, "back")
    third = upload(client, lines(120.0), "third.dxf", "back")
    url = f"/api/drawings/{third['id']}/customer-answers"
    # What was decided without a question is in the list, too.
    (known,) = [one for one in client.get(url).json() if one["layer"] == "q7"]
    assert known["used"]
    look = {k: known[k] for k in ("layer", "colour", "true_colour", "linetype", "line_width")}
    without = client.patch(url, json={**look, "used": False}).json()
    assert (len(without["questions"]), without["learned"]) == (1, [])
    assert not next(one for one in client.get(url).json() if one["layer"] == "q7")["used"]
    assert len(upload(client, lines(130.0), "fourth.dxf", "back")["questions"]) == 1
    again = client.patch(url, json={**look, "used": True}).json()
    assert (again["questions"], len(again["learned"])) == ([], 1)


def test_a_drawing_without_a_customer_takes_nothing_back(client: httpx.Client) -> None:
    drawing = upload(client, lines(100.0), "a.dxf", "")
    look = {"layer": "", "colour": 5, "true_colour": -1, "linetype": "", "line_width": -1}
    url = f"/api/drawings/{drawing['id']}/customer-answers"
    answer = client.patch(url, json={**look, "used": False})
    assert (answer.status_code, answer.json()["code"]) == (409, "drawing.no-customer")


def test_a_correction_is_a_contradiction(client: httpx.Client) -> None:
    teach(client, "sorry")
    third = upload(client, lines(120.0), "third.dxf", "sorry")
    override = {"overrides": [{"type": "crease", "edges": [4]}]}
    corrected = client.patch(f"/api/drawings/{third['id']}/edges", json=override).json()
    assert corrected["learned"] == []
    assert types(client, third["id"])[4] == "crease"
    assert len(upload(client, lines(130.0), "fourth.dxf", "sorry")["questions"]) == 1


def test_a_deleted_drawing_teaches_nothing(client: httpx.Client) -> None:
    teach(client, "gone")
    for row in client.get("/api/drawings", params={"customer": "gone"}).json():
        assert client.delete(f"/api/drawings/{row['id']}").status_code == 204
    assert len(upload(client, lines(120.0), "third.dxf", "gone")["questions"]) == 1


def test_the_same_file_again_asks_nothing(client: httpx.Client) -> None:
    first = upload(client, lines(100.0), "a.dxf", "repeat")
    answer_all(client, first, "crease")
    assert upload(client, lines(100.0), "again.dxf", "repeat")["questions"] == []
    assert len(upload(client, lines(110.0), "b.dxf", "repeat")["questions"]) == 1


def without_unit(width: float) -> bytes:
    """Return a blank of ``width`` x 7.31 in a file that states no unit and shows none."""
    corners = ((0.0, 0.0), (width, 0.0), (width, 7.31), (0.0, 7.31), (0.0, 0.0))
    edges = (text.line(*a, *b, (8, "CUT")) for a, b in pairwise(corners))
    return text.dxf(*edges, units=None)


def set_unit(client: httpx.Client, drawing: dict[str, Any], unit: str) -> dict[str, Any]:
    answer = client.patch(f"/api/drawings/{drawing['id']}", json={"unit": unit})
    assert answer.status_code == 200, answer.text
    return dict(answer.json())


def teach_unit(client: httpx.Client, customer: str, *units: str) -> None:
    for at, unit in enumerate(units):
        drawing = upload(client, without_unit(11.17 + at), f"{customer}-{at}.dxf", customer)
        assert drawing["unit"] is None
        set_unit(client, drawing, unit)


def test_the_third_file_without_a_unit_gets_that_of_two_drawings(client: httpx.Client) -> None:
    teach_unit(client, "inch shop", "in", "in")
    third = upload(client, without_unit(13.9), "third.dxf", "inch shop")
    assert (third["unit"], third["unit_given"]) == ("in", "in")
    assert third["width"] == pytest.approx(13.9 * 25.4)
    assert third["unit_learned"] == ["inch shop-1.dxf", "inch shop-0.dxf"]
    assert [one["kind"] for one in third["questions"]] == []


def test_a_learned_unit_is_taken_back_and_teaches_nothing(client: httpx.Client) -> None:
    teach_unit(client, "back", "in", "in")
    third = upload(client, without_unit(13.9), "third.dxf", "back")
    asked = set_unit(client, third, "file")
    assert (asked["unit"], asked["unit_given"], asked["unit_learned"]) == (None, None, [])
    changed = set_unit(client, third, "px-90")
    assert (changed["unit"], changed["unit_learned"]) == ("px-90", [])
    # Now the newest two answers contradict each other.
    assert upload(client, without_unit(14.9), "fourth.dxf", "back")["unit"] is None


def test_units_are_learned_per_customer_and_kind_of_file(client: httpx.Client) -> None:
    teach_unit(client, "metric", "cm", "cm")
    assert upload(client, without_unit(13.9), "third.dxf", "")["unit"] is None
    assert upload(client, without_unit(13.9), "third.dat", "metric")["unit"] is None
    late = upload(client, without_unit(15.9), "late.dxf", "")
    changed = client.patch(f"/api/drawings/{late['id']}", json={"customer": "metric"}).json()
    assert (changed["unit"], changed["unit_learned"]) == ("cm", ["metric-1.dxf", "metric-0.dxf"])
