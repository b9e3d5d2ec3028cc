from __future__ import annotations

import json
import tomllib
from pathlib import Path

import httpx
import pytest

from tests.support.serving.server import order_job, square, upload_drawing, wait_for_state
from tests.support.writers import dxf_text as text
from tests.support.writers.pdf_text import pages

pytestmark = pytest.mark.xdist_group("server")

#: A profile: red lines on a layer without a meaningful name are creases.
OURS = """# What Acme sends.
title = "Acme"
extends = "default"
overrules = true

[[rule]]
type = "crease"
layer = "INNER"
colour = 1
"""
#: A cut square with two lines of two colours on that layer.
INNER = (
    text.line(10.0, 50.0, 90.0, 50.0, (8, "INNER"), (62, 1)),
    text.line(10.0, 60.0, 90.0, 60.0, (8, "INNER"), (62, 30)),
)
TOML = {"Content-Type": "application/toml"}


def keep(client: httpx.Client, name: str, toml: str | bytes = OURS, **more: str) -> httpx.Response:
    content = toml.encode() if isinstance(toml, str) else toml
    return client.put(f"/api/profiles/{name}", content=content, headers={**TOML, **more})


def types(client: httpx.Client, id: str) -> list[str]:
    return [edge["type"] for edge in client.get(f"/api/drawings/{id}/edges").json()["edges"]]


def test_a_profile_is_kept_listed_and_exported_as_it_was_written(client: httpx.Client) -> None:
    answer = keep(client, "acme")
    assert answer.status_code == 201, answer.text
    assert answer.headers["etag"] == '"1"'
    body = answer.json()
    assert (body["name"], body["title"], body["version"]) == ("acme", "Acme", 1)
    assert (body["shipped"], body["extends"], body["overrules"]) == (False, "default", True)
    assert [rule["conditions"]["text"] for rule in body["rules"] if not rule["inherited"]] == [
        'layer "INNER", colour 1'
    ]
    assert client.get("/api/profiles/acme").json() == body
    assert body in client.get("/api/profiles").json()
    exported = client.get("/api/profiles/acme.toml")
    assert exported.text == OURS
    assert exported.headers["content-type"].startswith("application/toml")
    assert 'filename="acme.toml"' in exported.headers["content-disposition"]


def test_a_profile_in_json_becomes_equivalent_toml(client: httpx.Client) -> None:
    rules = [{"type": "cut", "colour": [1, "#00aeef"], "layer": ["Größe*", "刀线"]}]
    body = {"title": 'A "quoted" title', "extends": "german", "overrules": True, "rules": rules}
    response = client.put("/api/profiles/in-json", json=body)
    assert response.status_code == 201, response.text
    assert response.json()["rules"][0]["colour"] == [1, "#00aeef"]
    fields = tomllib.loads(client.get("/api/profiles/in-json.toml").text)
    assert (fields["title"], fields["extends"]) == ('A "quoted" title', "german")
    assert fields["rule"] == [
        {"type": "cut", "layer": ["Größe*", "刀线"], "colour": [1, "#00aeef"]}
    ]


def test_shipped_profiles_are_exported_and_stay_as_they_are(client: httpx.Client) -> None:
    assert tomllib.loads(client.get("/api/profiles/german.toml").text)["extends"] == "default"
    for answer in (keep(client, "german"), client.delete("/api/profiles/german")):
        assert answer.status_code == 409
        assert "cannot be changed" in answer.json()["detail"]


def test_a_profile_changed_by_another_client_is_not_overwritten(client: httpx.Client) -> None:
    assert keep(client, "shared").status_code == 201
    again = keep(client, "shared")
    assert again.status_code == 409
    assert 'If-Match: "1"' in again.json()["hint"]
    changed = keep(client, "shared", OURS.replace("Acme", "B"), **{"If-Match": '"1"'})
    assert (changed.status_code, changed.json()["version"]) == (200, 2)
    late = keep(client, "shared", OURS.replace("Acme", "C"), **{"If-Match": '"1"'})
    assert late.status_code == 412
    assert "version 2" in late.json()["detail"]
    assert 'If-Match: "2"' in late.json()["hint"]
    assert client.get("/api/profiles/shared").json()["title"] == "B"
    body = {"title": "D", "rules": [], "version": 2}
    assert client.put("/api/profiles/shared", json=body).json()["version"] == 3
    assert keep(client, "shared", **{"If-Match": "*"}).json()["version"] == 4
    assert client.delete("/api/profiles/shared", headers={"If-Match": '"3"'}).status_code == 412
    assert client.delete("/api/profiles/shared", headers={"If-Match": '"4"'}).status_code == 204
    assert client.get("/api/profiles/shared").status_code == 404
    assert keep(client, "shared", **{"If-Match": '"4"'}).status_code == 404


@pytest.mark.parametrize("match", ["", "three", '"-1"', '"99999999999999999999"', "NaN"])
def test_an_invalid_version_is_refused(client: httpx.Client, match: str) -> None:
    answer = keep(client, "versions", **{"If-Match": match})
    assert answer.status_code == 422
    assert "If-Match" in answer.json()["detail"]


@pytest.mark.parametrize(
    ("name", "status"),
    [
        *dict.fromkeys(["..", "a%2F..%2Fb", "%2e%2e%2fsecret"], 404).items(),  # other addresses
        *dict.fromkeys([
            "ACME", "a.toml.txt", "a b", "-a", "_a", "x" * 65, "größe", "a%00b", "%F0%9F%98%80",
            "c:\\x", "con.",
        ], 422).items(),
        *dict.fromkeys(["a.toml.toml", "default.toml"], 405).items(),  # files, which are only read
    ],
)  # fmt: skip
def test_a_name_is_a_name_and_never_a_path(client: httpx.Client, name: str, status: int) -> None:
    answer = keep(client, name)
    assert answer.status_code == status, answer.text
    assert answer.headers["content-type"] == "application/problem+json"


@pytest.mark.parametrize(
    ("toml", "source", "words"),
    [
        ("", [], "title is missing"),
        ("title = 'x'", [], "rule is missing"),
        ("title = ''\nrule = []", [], "title is empty"),
        (f"title = '{'x' * 201}'\nrule = []", [], "title is longer than 200 characters"),
        ("title = 'x'\nrule = 7", [], "rule is 7, but must be a list"),
        ("title = 'x'\nrule = ['cut']", [], "must be a table"),
        ("title = 'x'\nrule = []\nextends = '../../etc/passwd'", [], "must be a profile of"),
        ("title = 'x'\nrule = []\nextends = 'own.toml'", [], "must be a profile of"),
        ("title = 'x'\n[[rule]]\nlayer = 'A'", ["rule 1", "type"], "rule 1 → type is missing"),
        ("title = 'x'\n[[rule]]\ntype = 'glue'", ["rule 1", "type"], "must be a line type"),
        ("title = 'x'\n[[rule]]\ntype = 5", ["rule 1", "type"], "type is 5, but must be text"),
        (
            "title = 'x'\n[[rule]]\ntype = 'cut'\n[[rule]]\ntype = 'cut'\ncolour = nan",
            ["rule 2", "colour"],
            "rule 2 → colour 1 is nan",
        ),
        ("title = 'x'\n[[rule]]\ntype = 'cut'\ncolour = inf", ["rule 1", "colour"], "is inf"),
        ("title = 'x'\n[[rule]]\ntype = 'cut'\ncolour = 256", ["rule 1"], "number from 1 to 255"),
        ("title = 'x'\n[[rule]]\ntype = 'cut'\ncolour = 1e308", ["rule 1", "colour"], "1e+308"),
        ("title = 'x'\n[[rule]]\ntype = 'cut'\nlayer = 3", ["rule 1", "layer"], "must be text"),
        ("title = 'x'\n[[rule]]\ntype = 'cut'\nshape = 'A'", ["rule 1"], "not a known field"),
        (
            f"title = 'x'\n[[rule]]\ntype = 'cut'\nlayer = '{'x' * 256}'",
            ["rule 1", "layer"],
            "longer than 255 characters",
        ),
        (
            f"title = 'x'\n[[rule]]\ntype = 'cut'\nlayer = {['x'] * 501}",
            ["rule 1", "layer"],
            "more than 500 values",
        ),
        ("title = 'x'\n" + "[[rule]]\ntype = 'cut'\n" * 501, [], "more than 500 values"),
        ("title = 'x'\nrule = " + "[" * 50_000 + "]" * 50_000, [], "nested too deeply"),
        ("title = 'x'\nrule = " + "{a=" * 5000 + "1" + "}" * 5000, [], "profile"),
        ("title = 'x'\nrule = []\n" + "#" * 300_000, [], "kB, but the limit"),
        ("title = 'x\nrule = []", [], "is not valid TOML"),
        ("\x00", [], "is not valid TOML"),
        ("title = 'x'\nrule = []\ncut = 1", [], "cut is not a known field"),
    ],
)  # fmt: skip
def test_an_invalid_profile_is_refused_with_rule_and_field(
    client: httpx.Client, toml: str, source: list[str], words: str
) -> None:
    answer = keep(client, "wrong", toml)
    assert answer.status_code == 422, answer.text
    body = answer.json()
    assert words in body["detail"]
    assert body["source"][: len(source)] == source
    assert body["hint"]
    assert client.get("/api/profiles/wrong").status_code == 404


def test_text_that_is_not_utf8_is_refused(client: httpx.Client) -> None:
    answer = keep(client, "latin", b'title = "M\xfcller"\nrule = []')
    assert answer.status_code == 422
    assert "not UTF-8 text: byte 10" in answer.json()["detail"]


@pytest.mark.parametrize(
    ("body", "source", "words"),
    [
        ("[]", ["body"], "must be a table"),
        ("{", ["body"], "JSON"),
        ('{"title": "x"}', ["rules"], "rules is missing"),
        ('{"title": "x", "rules": [{"type": "cut"}, {}]}', ["rule 2", "type"], "is missing"),
        ('{"title": "x", "rules": [{"type": "cut", "colour": [NaN]}]}', ["rule 1", "colour"], ""),
        ('{"title": "x", "rules": [{"type": "cut", "colour": [true]}]}', ["rule 1", "colour"], ""),
        ('{"title": "x", "rules": [{"type": "cut", "colour": ["red"]}]}', ["rule 1", "colour"], ""),
        ('{"title": "x", "rules": [{"type": "cut", "layer": ["\\ud800"]}]}', [], ""),
        ('{"title": "x", "rules": [], "path": "/etc/passwd"}', ["path"], ""),
        ('{"title": "x", "rules": [], "version": -1}', ["version"], ""),
        ('{"title": "x", "rules": ' + "[" * 100_000 + "]" * 100_000 + "}", [], ""),
    ],
)
def test_an_invalid_profile_in_json_is_refused_with_rule_and_field(
    client: httpx.Client, body: str, source: list[str], words: str
) -> None:
    answer = client.put(
        "/api/profiles/wrong", content=body, headers={"Content-Type": "application/json"}
    )
    assert answer.status_code == 422, answer.text
    assert words in answer.json()["detail"]
    assert answer.json()["source"][: len(source)] == source


def test_a_drawing_classified_by_a_profile_reports_that_the_profile_changed(
    client: httpx.Client,
) -> None:
    keep(client, "changing")
    drawing = upload_drawing(client, square(extra=INNER), profile="changing")
    id = drawing["id"]
    assert (drawing["profile"], drawing["profile_state"]) == ("changing", "current")
    assert types(client, id)[4] == "crease"

    keep(client, "changing", OURS.replace("crease", "perforation"), **{"If-Match": '"1"'})
    assert client.get(f"/api/drawings/{id}").json()["profile_state"] == "changed"
    assert types(client, id)[4] == "crease"
    again = client.patch(f"/api/drawings/{id}", json={"profile": "changing"}).json()
    assert again["profile_state"] == "current"
    assert types(client, id)[4] == "perforation"

    # Undo the reclassification.
    before = client.patch(
        f"/api/drawings/{id}", json={"profile": "changing", "rules": drawing["rules"]}
    ).json()
    assert (before["profile_state"], before["rules"]) == ("changed", drawing["rules"])
    assert types(client, id)[4] == "crease"
    client.patch(f"/api/drawings/{id}", json={"rules": again["rules"]})
    assert types(client, id)[4] == "perforation"

    client.delete("/api/profiles/changing")
    assert client.get(f"/api/drawings/{id}").json()["profile_state"] == "deleted"
    client.patch(f"/api/drawings/{id}/edges", json={"overrides": [{"type": "cut", "edges": [5]}]})
    assert types(client, id)[4:] == ["perforation", "cut"]
    gone = client.patch(f"/api/drawings/{id}", json={"profile": "changing"})
    assert gone.status_code == 404
    assert "The profile 'changing' does not exist" in gone.json()["detail"]
    # The drawing can still be classified with the former text of the profile.
    kept = {"profile": "changing", "rules": drawing["rules"]}
    assert client.patch(f"/api/drawings/{id}", json=kept).json()["profile_state"] == "deleted"
    assert types(client, id)[4:] == ["crease", "cut"]


@pytest.mark.parametrize(
    ("patch", "status", "words"),
    [
        ({"profile": "default", "rules": OURS}, 409, "is part of knifetip"),
        ({"rules": OURS}, 409, "is part of knifetip"),
        ({"profile": "acme", "rules": "title ="}, 422, "is not valid TOML"),
        ({"profile": "acme", "rules": 'title = "x"\n[[rule]]\ntype = "glue"'}, 422, "glue"),
        ({"profile": "../acme", "rules": OURS}, 422, "name"),
        ({"profile": "acme", "rules": "#" * (257 << 10)}, 422, "262144"),
        ({"profile": "acme", "rules": 7}, 422, "body.rules is 7, but must be text"),
    ],
)
def test_invalid_rules_change_nothing(
    client: httpx.Client, patch: dict[str, object], status: int, words: str
) -> None:
    drawing = upload_drawing(client, square(extra=INNER))
    answer = client.patch(f"/api/drawings/{drawing['id']}", json=patch)
    assert (answer.status_code, words in answer.json()["detail"]) == (status, True), answer.text
    assert client.get(f"/api/drawings/{drawing['id']}").json()["rules"] == ""


def test_a_job_uses_the_rules_with_which_it_was_ordered(client: httpx.Client) -> None:
    keep(client, "ordering", OURS + '\n[[rule]]\ntype = "ignored"\nlayer = "INNER"\n')
    id = upload_drawing(client, square(extra=INNER), profile="ordering")["id"]
    # The changed profile leaves edges unclassified; the job uses the rules of the drawing.
    keep(client, "ordering", OURS.replace("crease", "unclassified"), **{"If-Match": '"1"'})
    job = order_job(client, id)
    assert wait_for_state(client, job["id"], "ready")["state"] == "ready"
    verdict = client.get(f"/api/jobs/{job['id']}/verdict").json()
    # Only a wheel has a setback from the ends of its line.
    assert [setback > 1.0 for setback in verdict["edge_setback"]] == [False] * 4 + [True, False]
    answer = client.post(
        "/api/jobs", json={"drawing": id, "board": "e-flute", "profile": "ordering"}
    )
    assert answer.status_code == 409
    assert answer.json()["questions"]


def test_a_file_beside_the_library_is_no_profile(client: httpx.Client, tmp_path: Path) -> None:
    path = tmp_path / "mine.toml"
    path.write_text(OURS)
    id = upload_drawing(client, square())["id"]
    for name in (str(path), "../profiles/german", "german.toml"):
        answer = client.patch(f"/api/drawings/{id}", json={"profile": name})
        assert answer.status_code == 404, name
        assert "does not exist" in answer.json()["detail"]


def test_a_preview_counts_the_edges_of_each_rule_and_stores_nothing(client: httpx.Client) -> None:
    id = upload_drawing(client, square(extra=INNER))["id"]
    override = {"overrides": [{"type": "cut", "edges": [4]}]}
    before = client.patch(f"/api/drawings/{id}/edges", json=override).json()
    rules = [
        {"type": "perforation", "layer": ["INNER"]},
        {"type": "cut", "layer": ["CUT"]},
        {"type": "cut", "layer": ["NOWHERE"]},
    ]
    body = {"title": "Try", "extends": "default", "overrules": True, "rules": rules}
    preview = client.post(f"/api/drawings/{id}/preview", json=body).json()
    mine = [rule for rule in preview["rules"] if not rule["inherited"]]
    assert [(rule["edges"], rule["length"]) for rule in mine] == [(2, 160.0), (4, 400.0), (0, 0.0)]
    assert preview["open"] == 0
    # The override of edge 4 has priority over any profile.
    assert [(one["after"], one["edges"]) for one in preview["changes"]] == [("perforation", [5])]
    assert client.get(f"/api/drawings/{id}").json() == before


def test_a_preview_of_an_invalid_profile_is_refused(client: httpx.Client) -> None:
    id = upload_drawing(client, square())["id"]
    body = {"title": "x", "rules": [{"type": "cut", "colour": [0]}]}
    answer = client.post(f"/api/drawings/{id}/preview", json=body)
    assert answer.status_code == 422
    assert answer.json()["source"] == ["rule 1", "colour"]


def test_corrections_propose_a_rule_that_makes_them_unnecessary(client: httpx.Client) -> None:
    drawing = square(extra=INNER)
    id = upload_drawing(client, drawing)["id"]
    assert client.post(f"/api/drawings/{id}/learned").json() == []
    override = {"overrides": [{"type": "perforation", "edges": [4]}]}
    client.patch(f"/api/drawings/{id}/edges", json=override)
    proposals = client.post(f"/api/drawings/{id}/learned").json()
    first = proposals[0]
    assert (first["rule"]["type"], first["explains"]) == ("perforation", [4])
    assert all(4 not in one["edges"] for one in first["changes"])

    rule = {key: first["rule"][key] for key in ("type", "layer", "colour", "linetype")}
    body = {"title": "Learned", "extends": "default", "rules": [rule]}
    assert client.put("/api/profiles/learned", json=body).status_code == 201
    other = upload_drawing(client, drawing, profile="learned")
    assert types(client, other["id"])[4] == "perforation"


def test_a_correction_against_the_profile_lists_other_changed_edges(
    client: httpx.Client,
) -> None:
    folds = [text.line(10.0, y, 90.0, y, (8, "CREASE")) for y in (30.0, 50.0, 70.0)]
    id = upload_drawing(client, square(extra=tuple(folds)))["id"]
    override = {"overrides": [{"type": "perforation", "edges": [4]}]}
    client.patch(f"/api/drawings/{id}/edges", json=override)
    # One correction does not outweigh two decided edges.
    assert client.post(f"/api/drawings/{id}/learned").json() == []
    override = {"overrides": [{"type": "perforation", "edges": [4, 5]}]}
    client.patch(f"/api/drawings/{id}/edges", json=override)
    (proposal,) = client.post(f"/api/drawings/{id}/learned").json()
    assert (proposal["sure"], proposal["explains"]) == (False, [4, 5])
    assert proposal["changes"] == [{"before": "crease", "after": "perforation", "edges": [6]}]


def test_lengths_in_the_report_add_up_and_every_edge_has_an_outcome(client: httpx.Client) -> None:
    twice = text.line(20.0, 0.0, 80.0, 0.0, (8, "CUT"))
    note = "0\nTEXT\n8\nNOTES\n10\n0\n20\n0\n40\n5\n1\nhello\n"
    body = upload_drawing(client, square(extra=(twice, note)))
    report = body["report"]
    assert report["drawn"] == pytest.approx(460.0)
    assert report["kept"] + report["merged"] + report["dropped"] == pytest.approx(report["drawn"])
    assert report["merged"] == pytest.approx(60.0)
    words = {(group["outcome"], group["what"]): group for group in report["groups"]}
    assert words["dropped", "entities"]["kinds"] == ["TEXT"]
    edges = client.get(f"/api/drawings/{body['id']}/edges").json()["edges"]
    (gone,) = [edge for edge in edges if edge["outcome"] == "merged"]
    assert (gone["length"], gone["reason"] != "") == (60.0, True)


def test_a_given_unit_can_be_removed(client: httpx.Client) -> None:
    body = upload_drawing(client, square())
    assert (body["unit"], body["unit_given"]) == ("mm", None)
    inches = client.patch(f"/api/drawings/{body['id']}", json={"unit": "in"}).json()
    assert (inches["unit_given"], inches["width"]) == ("in", pytest.approx(2540.0))
    back = client.patch(f"/api/drawings/{body['id']}", json={"unit": "file"}).json()
    assert (back["unit_given"], back["width"]) == (None, 100.0)
    assert body["unit_finding"]["stated"] == "mm"
    assert {one["unit"] for one in body["unit_finding"]["evidence"]} >= {"mm"}
    assert json.dumps(body, allow_nan=False)


@pytest.mark.parametrize("method", ["PUT", "DELETE"])
def test_the_file_of_a_profile_is_only_read(client: httpx.Client, method: str) -> None:
    answer = client.request(method, "/api/profiles/default.toml", content=OURS, headers=TOML)
    assert answer.status_code == 405
    assert answer.headers["Allow"] == "GET, HEAD"


def test_few_corrections_propose_no_rule_for_many_open_edges(client: httpx.Client) -> None:
    free = [text.line(20.0, y, 60.0, y, (8, "Q7"), (62, 5)) for y in range(20, 80, 10)]
    id = upload_drawing(client, square(extra=tuple(free)))["id"]
    url = f"/api/drawings/{id}"
    some = {"overrides": [{"type": "ignored", "edges": [4, 5]}]}
    client.patch(f"{url}/edges", json=some)
    assert client.post(f"{url}/learned").json() == []
    half = {"overrides": [{"type": "ignored", "edges": [4, 5, 6]}]}
    client.patch(f"{url}/edges", json=half)
    (proposal,) = client.post(f"{url}/learned").json()
    assert proposal["explains"] == [4, 5, 6]


def test_another_page_keeps_the_rules_of_the_drawing(client: httpx.Client) -> None:
    red = "1 0 0 RG 0 0 m 90 0 l S"
    rules = 'title = "Acme"\n[[rule]]\ntype = "half-cut"\ncolour = "#ff0000"\n'
    assert keep(client, "acme-pages", rules).status_code in (200, 201)
    first = upload_drawing(client, pages(red, f"{red} 0 0 m 0 20 l S"), profile="acme-pages")
    # The drawing keeps the rules that it was classified with, also after the profile is changed.
    newer = keep(client, "acme-pages", rules.replace("half-cut", "crease"), **{"If-Match": "*"})
    assert newer.status_code == 200
    second = client.post(f"/api/drawings/{first['id']}/pages/2").json()
    assert (second["profile"], second["rules"]) == ("acme-pages", first["rules"])
    assert "half-cut" in second["rules"]
    assert second["profile_state"] == "changed"
    assert types(client, second["id"])[0] == types(client, first["id"])[0] == "half-cut"
    # A profile of the library has no rules of its own.
    third = upload_drawing(client, pages(red, red), profile="german")
    fourth = client.post(f"/api/drawings/{third['id']}/pages/2").json()
    assert (fourth["profile"], fourth["rules"]) == ("german", "")
