from __future__ import annotations

import hashlib
from typing import Any

import httpx
import numpy as np
import pytest

from knifetip.presentation.columns import unpack_columns
from knifetip.service.drawings.models import UnitFindingOut
from knifetip.service.drawings.requests import drawing_name
from tests.support.serving.server import square, upload_drawing
from tests.support.writers import dxf_text as text
from tests.support.writers.pdf_text import pages

pytestmark = pytest.mark.xdist_group("server")

#: A line on a layer whose name has no meaning.
MYSTERY = text.line(10.0, 50.0, 90.0, 50.0, (8, "MYSTERY"), (62, 30))


def edges(client: httpx.Client, id: str) -> list[dict[str, Any]]:
    found: list[dict[str, Any]] = client.get(f"/api/drawings/{id}/edges").json()["edges"]
    return found


def override(client: httpx.Client, id: str, *overrides: dict[str, Any]) -> httpx.Response:
    return client.patch(f"/api/drawings/{id}/edges", json={"overrides": list(overrides)})


def test_an_upload_answers_with_unit_counts_and_import_report(client: httpx.Client) -> None:
    answer = client.post("/api/drawings", files={"file": ("square.dxf", square())})
    assert answer.status_code == 201
    body = answer.json()
    assert answer.headers["location"] == f"/api/drawings/{body['id']}"
    assert (body["name"], body["unit"], body["segments"]) == ("square.dxf", "mm", 4)
    assert (body["width"], body["height"]) == (100.0, 100.0)
    assert body["counts"] == [{"type": "cut", "edges": 4, "length": 400.0}]
    assert body["questions"] == []
    assert body["sha256"] == hashlib.sha256(square()).hexdigest()
    assert (body["import_report"]["kept"], len(body["import_report"]["rows"])) == (4, 4)
    assert client.get(f"/api/drawings/{body['id']}").json() == body
    assert client.get(f"/api/drawings/{body['id']}/import-report").json() == body["import_report"]


def test_the_import_report_is_filtered_by_outcome_and_has_positions_of_texts(
    client: httpx.Client,
) -> None:
    note = text.entity("TEXT", (8, "NOTES"), (10, 12), (20, 34), (40, 5), (1, "Rev. B"))
    id = upload_drawing(client, square(extra=(note,)))["id"]
    (row,) = client.get(f"/api/drawings/{id}/import-report?outcome=dropped").json()["rows"]
    assert (row["kind"], row["text"], row["place"]) == ("TEXT", "Rev. B", [12.0, 34.0, 5.0])
    assert len(client.get(f"/api/drawings/{id}/import-report?outcome=kept").json()["rows"]) == 4
    assert client.get(f"/api/drawings/{id}/import-report?outcome=lost").status_code == 422


def test_the_file_comes_back_byte_for_byte(client: httpx.Client) -> None:
    id = upload_drawing(client, square())["id"]
    assert client.get(f"/api/drawings/{id}/file").content == square()


def test_drawings_are_listed_newest_first_and_page_by_page(client: httpx.Client) -> None:
    ids = [upload_drawing(client, square(side=side))["id"] for side in (10.0, 20.0, 30.0)]
    first = client.get("/api/drawings", params={"limit": 2})
    assert [drawing["id"] for drawing in first.json()] == ids[:0:-1]
    assert first.json()[0]["width"] == 30.0
    path = first.headers["link"].split(">")[0].lstrip("<")
    assert client.get(path).json()[0]["id"] == ids[0]


def test_a_drawing_without_a_unit_has_a_question_that_can_be_answered(client: httpx.Client) -> None:
    body = upload_drawing(client, square(units=None, side=4.0))
    assert body["unit"] is None
    assert "unit" in [question["kind"] for question in body["questions"]]
    updated = client.patch(f"/api/drawings/{body['id']}", json={"unit": "in"}).json()
    assert (updated["unit"], updated["questions"]) == ("in", [])
    assert updated["width"] == pytest.approx(101.6)


def test_a_unit_sent_with_the_file_is_used(client: httpx.Client) -> None:
    assert upload_drawing(client, square(units=None, side=4.0), unit="cm")[
        "width"
    ] == pytest.approx(40.0)


def test_setting_the_unit_reads_the_file_again_and_refits_curves(
    client: httpx.Client,
) -> None:
    # Half axes of 4 and 2: an ellipse in inches needs more arcs than one in millimetres.
    ellipse = text.entity(
        "ELLIPSE", (8, "CUT"), (10, 0), (20, 0), (11, 4), (21, 0), (40, 0.5), (41, 0), (42, 6.28)
    )
    data = text.dxf(ellipse, units=None, version="AC1015")
    without_unit, with_unit = upload_drawing(client, data), upload_drawing(client, data, unit="in")
    assert without_unit["unit"] is None
    coarse = client.patch(f"/api/drawings/{without_unit['id']}", json={"unit": "mm"}).json()
    updated = client.patch(f"/api/drawings/{without_unit['id']}", json={"unit": "in"}).json()
    assert updated["segments"] == with_unit["segments"] > coarse["segments"]
    fine = edges(client, with_unit["id"])
    assert [edge["start"] for edge in edges(client, updated["id"])] == [
        edge["start"] for edge in fine
    ]


def test_a_drawing_has_the_evidence_for_its_unit_and_contradictions(
    client: httpx.Client,
) -> None:
    finding = upload_drawing(client, square())["unit_finding"]
    assert (finding["stated"], finding["ranking"][0], finding["warnings"]) == ("mm", "mm", [])
    first = finding["evidence"][0]
    assert set(first) == {"unit", "code", "arguments", "text", "hint", "weight"}
    assert first["arguments"]["unit"] == first["unit"]
    assert finding["evidence"][0]["weight"] > 1.0
    id = upload_drawing(client, square())["id"]
    updated = client.patch(f"/api/drawings/{id}", json={"unit": "in"}).json()
    assert (updated["unit"], updated["width"]) == ("in", 2540.0)
    warning = updated["unit_finding"]["warnings"][0]
    assert warning["code"] == "unit.read-against-header"
    assert (warning["arguments"]["stated"], warning["arguments"]["unit"]) == ("mm", "in")


def test_unit_evidence_that_was_stored_as_sentences_stays_readable() -> None:
    stored = {
        "stated": "mm",
        "ranking": ["mm", "in"],
        "evidence": [{"unit": "mm", "text": "in mm it is large", "weight": 2.0}],
        "warnings": ["The header is wrong."],
    }
    finding = UnitFindingOut.model_validate(stored)
    assert finding.evidence[0].text == "in mm it is large"
    assert finding.warnings[0].code == "stored.text"
    assert finding.warnings[0].text == "The header is wrong."


@pytest.mark.parametrize(
    "who",
    [{"edges": [4]}, {"layer": "MYSTERY"}, {"colour": 30}, {"layer": "MYSTERY", "colour": 30}],
)
def test_an_override_answers_the_question_and_can_be_taken_back(
    client: httpx.Client, who: dict[str, Any]
) -> None:
    id = upload_drawing(client, square(extra=(MYSTERY,)))["id"]
    (question,) = client.get(f"/api/drawings/{id}").json()["questions"]
    assert (question["kind"], question["edges"]) == ("line-type", [4])
    body = override(client, id, {"type": "crease", **who}).json()
    assert (body["questions"], body["overrides"]) == ([], 1)
    edge = edges(client, id)[4]
    assert (edge["type"], edge["rule"], edge["length"]) == (
        "crease",
        "the user set the line type of the edge",
        80.0,
    )
    taken = override(client, id, {"type": None, **who}).json()
    assert (len(taken["questions"]), taken["overrides"]) == (1, 0)


def test_an_override_by_handle_and_a_later_one_on_top(client: httpx.Client) -> None:
    id = upload_drawing(client, square())["id"]
    handles = [edge["handle"] for edge in edges(client, id)]
    override(
        client, id, {"type": "crease", "layer": "CUT"}, {"type": "ignored", "handles": handles[:1]}
    )
    assert [edge["type"] for edge in edges(client, id)] == ["ignored", *["crease"] * 3]


def test_overrides_remain_on_their_edges_when_the_unit_is_set(client: httpx.Client) -> None:
    id = upload_drawing(client, square(units=None))["id"]
    override(client, id, {"type": "crease", "edges": [2]})
    client.patch(f"/api/drawings/{id}", json={"unit": "mm"})
    assert [edge["type"] for edge in edges(client, id)] == ["cut", "cut", "crease", "cut"]


@pytest.mark.parametrize(
    ("who", "words"),
    [
        ({"edges": [4]}, "Edge 4 does not"),
        ({"edges": [-1]}, "Edge -1 does not"),
        ({"edges": [10**30]}, "Edge 1000000000"),
        ({"handles": ["FFFF"]}, "handle 'FFFF'"),
        ({"layer": "NOWHERE"}, "layer 'NOWHERE'"),
        ({"colour": 10**30}, "colour 1000"),
        ({}, "in exactly one way"),
        ({"edges": [0], "layer": "CUT"}, "in exactly one way"),
    ],
)
def test_an_override_of_unknown_or_ambiguous_edges_is_refused(
    client: httpx.Client, who: dict[str, Any], words: str
) -> None:
    id = upload_drawing(client, square())["id"]
    answer = override(client, id, {"type": "crease", **who})
    assert answer.status_code == 422
    assert words in answer.json()["detail"]
    assert [edge["type"] for edge in edges(client, id)] == ["cut"] * 4


def test_a_picture_of_many_edges_needs_a_part_of_the_columns(
    client: httpx.Client, monkeypatch: pytest.MonkeyPatch
) -> None:
    id = upload_drawing(client, square(extra=(MYSTERY,)))["id"]
    url = f"/api/drawings/{id}/edges"
    whole = client.get(url, params={"format": "columns"})
    assert client.get(url, params={"format": "drawn"}).content == whole.content
    monkeypatch.setattr("knifetip.service.drawings.routes.MANY_EDGES", 5)
    answer = client.get(url, params={"format": "drawn"})
    drawn, meta = unpack_columns(answer.content)
    columns, _ = unpack_columns(whole.content)
    assert drawn["ends"].dtype == np.float32
    np.testing.assert_allclose(
        drawn["ends"] + np.array(meta["origin"]), columns["ends"], rtol=0.0, atol=1e-5
    )
    assert meta["origin"] == [50.0, 50.0]
    np.testing.assert_array_equal(drawn["bulge"], columns["bulge"])
    for name in ("line_type", "outcome"):
        np.testing.assert_array_equal(drawn[name], columns[name])
    known = {"If-None-Match": answer.headers["etag"]}
    assert client.get(url, params={"format": "drawn"}, headers=known).status_code == 304
    override(client, id, {"type": "crease", "edges": [4]})
    changed = client.get(url, params={"format": "drawn"}, headers=known)
    assert changed.status_code == 200
    assert unpack_columns(changed.content)[0]["line_type"][4] == 2


def test_columns_have_the_same_values_as_json(client: httpx.Client) -> None:
    id = upload_drawing(client, square(extra=(MYSTERY,)))["id"]
    answer = client.get(f"/api/drawings/{id}/edges", params={"format": "columns"})
    columns, meta = unpack_columns(answer.content)
    listed = edges(client, id)
    np.testing.assert_array_equal(
        columns["ends"], [[edge["start"], edge["end"]] for edge in listed]
    )
    for row, edge in enumerate(listed):
        assert meta["handles"][row] == edge["handle"]
        assert meta["layers"][columns["layer"][row]] == edge["layer"]
        assert meta["rules"][columns["rule"][row]] == edge["rule"]
        assert meta["types"][columns["line_type"][row]] == edge["type"]
        assert columns["colour"][row] == edge["colour"]
    again = client.get(
        f"/api/drawings/{id}/edges",
        params={"format": "columns"},
        headers={"If-None-Match": answer.headers["etag"]},
    )
    assert (again.status_code, again.content) == (304, b"")
    override(client, id, {"type": "cut", "edges": [4]})
    changed = client.get(
        f"/api/drawings/{id}/edges",
        params={"format": "columns"},
        headers={"If-None-Match": answer.headers["etag"]},
    )
    assert changed.status_code == 200


def test_a_drawing_is_deleted(client: httpx.Client) -> None:
    id = upload_drawing(client, square())["id"]
    assert client.delete(f"/api/drawings/{id}").status_code == 204
    assert client.get(f"/api/drawings/{id}").status_code == 404


def test_the_same_key_gives_the_same_drawing_and_another_request_is_refused(
    client: httpx.Client,
) -> None:
    def send(content: bytes) -> httpx.Response:
        return client.post(
            "/api/drawings",
            files={"file": ("square.dxf", content)},
            headers={"Idempotency-Key": "order-4711"},
        )

    first = send(square())
    assert send(square()).json()["id"] == first.json()["id"]
    other = send(square(side=50.0))
    assert other.status_code == 422
    assert "order-4711" in other.json()["detail"]


@pytest.mark.parametrize(
    ("sent", "kept"),
    [
        ("tray.dxf", "tray.dxf"),
        ("../../etc/passwd", "passwd"),
        ("C:\\drawings\\tray.dxf", "tray.dxf"),
        ("a\x00b\r\nc\u202e.dxf", "abc.dxf"),
        ("", "drawing.dxf"),
        ("///", "drawing.dxf"),
        ("Größe 1.dxf", "Größe 1.dxf"),
    ],
)
def test_a_name_keeps_its_last_part_and_printable_characters(sent: str, kept: str) -> None:
    assert drawing_name(sent) == kept


def test_a_very_long_name_keeps_its_suffix() -> None:
    name = drawing_name("x" * 5000 + ".dxf")
    assert len(name) <= 120
    assert name.endswith(".dxf")


def test_the_media_type_of_a_downloaded_file_is_described(client: httpx.Client) -> None:
    described = client.get("/api/v1/openapi.json").json()
    answers = described["paths"]["/api/v1/drawings/{id}/file"]["get"]["responses"]
    id = upload_drawing(client, square())["id"]
    sent = client.get(f"/api/v1/drawings/{id}/file").headers["content-type"]
    assert sent.partition(";")[0] in answers["200"]["content"]


def test_a_page_of_a_pdf_is_chosen_from_pictures(client: httpx.Client) -> None:
    data = pages("0 0 m 90 0 l S", "0 0 m 0 20 l S 0 20 m 9 20 l S", "(never closed")
    first = upload_drawing(client, data, customer="ACME", unit="in")
    answer = client.get(f"/api/drawings/{first['id']}/pages")
    assert answer.status_code == 200
    listed = answer.json()
    assert [(one["page"], one["edges"]) for one in listed] == [(1, 1), (2, 2), (3, 0)]
    assert listed[0]["width"] == pytest.approx(90.0 * 25.4 / 72.0)
    assert listed[1]["picture"].startswith("<svg")
    assert listed[2]["picture"] == ""
    assert listed[2]["problem"]["code"]

    chosen = client.post(f"/api/drawings/{first['id']}/pages/2")
    assert chosen.status_code == 201
    second = chosen.json()
    assert second["id"] != first["id"]
    assert (second["segments"], second["customer"], second["unit"]) == (2, "ACME", "in")
    assert client.get(f"/api/drawings/{first['id']}").json()["segments"] == 1
    # The chosen page is still the one that is read when the drawing is read again.
    again = client.patch(f"/api/drawings/{second['id']}", json={"unit": "file"})
    assert again.json()["segments"] == 2


def test_other_files_have_no_pages(client: httpx.Client) -> None:
    drawing = upload_drawing(client, square())
    assert client.get(f"/api/drawings/{drawing['id']}/pages").json() == []
    answer = client.post(f"/api/drawings/{drawing['id']}/pages/2")
    assert answer.status_code == 422
    assert "has no pages" in answer.text
    assert client.post(f"/api/drawings/{drawing['id']}/pages/0").status_code == 422
