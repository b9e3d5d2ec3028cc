"""Drawings in formats other than DXF, over REST and on the command line."""

from __future__ import annotations

import gzip
import json
import sys
from pathlib import Path

import httpx
import pytest

from knifetip.cli import main
from knifetip.formats.conversion import LIBREDWG
from tests.support.converters import needs_ghostscript
from tests.support.writers import (
    cf2_text,
    eps_text,
    hpgl_text,
    lightburn_text,
    pdf_text,
    svg_text,
)

pytestmark = pytest.mark.xdist_group("server")

FILES = {
    "carton.svg": (svg_text.carton(), "application/octet-stream"),
    "carton.svgz": (gzip.compress(svg_text.carton(), mtime=0), "application/octet-stream"),
    "carton.cf2": (cf2_text.carton(), "text/plain; charset=utf-8"),
    "carton.ai": (pdf_text.carton(), "application/octet-stream"),
    "carton.plt": (hpgl_text.carton(), "application/octet-stream"),
    "carton.lbrn2": (lightburn_text.carton(), "application/octet-stream"),
    # The file name does not determine the format.
    "carton.dxf": (cf2_text.carton(), "text/plain; charset=utf-8"),
}


def upload(client: httpx.Client, name: str, content: bytes, **fields: str) -> httpx.Response:
    return client.post("/api/drawings", files={"file": (name, content)}, data=fields)


@pytest.mark.parametrize("name", FILES)
def test_a_file_is_read_by_its_content(client: httpx.Client, name: str) -> None:
    content, media_type = FILES[name]
    body = upload(client, name, content).json()
    unit = "pt" if name == "carton.ai" else "mm"
    assert (body["name"], body["unit"], body["questions"]) == (name, unit, [])
    assert {count["type"] for count in body["counts"]} >= {"cut", "crease"}
    back = client.get(f"/api/drawings/{body['id']}/file")
    assert back.content == content
    assert back.headers["content-type"] == media_type
    assert back.headers["content-disposition"].startswith("attachment")


def test_a_page_in_pixels_has_a_question_that_can_be_answered(client: httpx.Client) -> None:
    size = b'width="220mm" height="100mm"'
    content = svg_text.carton().replace(size, b'width="220" height="100"')
    body = upload(client, "carton.svg", content).json()
    (question,) = (one for one in body["questions"] if one["kind"] == "unit")
    assert {"mm", "pt", "px"} <= set(question["choices"])
    updated = client.patch(f"/api/drawings/{body['id']}", json={"unit": "px"}).json()
    assert (updated["unit"], updated["questions"]) == ("px", [])
    assert updated["width"] == pytest.approx(200 * 25.4 / 96)


def test_a_profile_determines_the_line_types_of_cf2_numbers(client: httpx.Client) -> None:
    fold = cf2_text.line(50, 0, 50, 80, 3)
    content = cf2_text.carton().replace(cf2_text.line(50, 0, 50, 80, 2).encode(), fold.encode())
    asked = upload(client, "a.cf2", content).json()["questions"]
    assert [question["kind"] for question in asked] == ["line-type"]
    assert "CF2 3 2pt" in asked[0]["text"]
    body = upload(client, "a.cf2", content, profile="cf2-plmpack").json()
    assert body["questions"] == []
    assert "combi" in {count["type"] for count in body["counts"]}


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"%PDF-1.7\n", "The PDF file is incomplete"),
        (b"<html></html>", "The file is an HTML page"),
        (
            b'<!DOCTYPE svg [<!ENTITY a SYSTEM "file:///etc/passwd">]><svg>&a;</svg>',
            "is not loaded",
        ),
        (cf2_text.carton()[:400], "incomplete"),
        (svg_text.carton()[:400], "incomplete"),
    ],
)
def test_an_unreadable_file_is_a_clear_problem(
    client: httpx.Client, content: bytes, words: str
) -> None:
    answer = upload(client, "carton.svg", content)
    assert answer.status_code == 422
    assert words in answer.json()["detail"]
    assert "passwd" not in answer.text
    assert "root:" not in answer.text


def test_the_command_line_reads_all_formats(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    for name, (content, _) in FILES.items():
        file = tmp_path / name
        file.write_bytes(content)
        monkeypatch.setattr(sys, "argv", ["knifetip", "classify", str(file), "--json"])
        with pytest.raises(SystemExit) as left:
            main()
        out, _ = capfd.readouterr()
        assert left.value.code == 0
        assert {edge["type"] for edge in json.loads(out)["edges"]} == {"cut", "crease"}


@needs_ghostscript
def test_an_eps_file_is_converted_and_kept_as_it_was_sent(client: httpx.Client) -> None:
    content = eps_text.carton()
    body = upload(client, "carton.eps", content).json()
    assert (body["name"], body["unit"], body["questions"]) == ("carton.eps", "pt", [])
    assert {count["type"] for count in body["counts"]} == {"cut", "crease"}
    assert body["import_report"]["rows"][-1]["reason"]["code"] == "import.converted"
    assert client.get(f"/api/drawings/{body['id']}/file").content == content
    changed = client.patch(f"/api/drawings/{body['id']}", json={"unit": "mm"}).json()
    assert changed["width"] == pytest.approx(200.0 * 72.0 / 25.4, abs=0.01)


@needs_ghostscript
def test_a_page_of_a_postscript_file_is_chosen_from_pictures(client: httpx.Client) -> None:
    data = eps_text.pages("0 0 moveto 90 0 lineto stroke", "0 0 moveto 0 20 lineto stroke")
    first = upload(client, "carton.ps", data).json()
    listed = client.get(f"/api/drawings/{first['id']}/pages").json()
    assert [(one["page"], one["edges"]) for one in listed] == [(1, 1), (2, 1)]
    second = client.post(f"/api/drawings/{first['id']}/pages/2").json()
    assert second["height"] == pytest.approx(20.0 * 25.4 / 72.0, abs=0.001)


def test_a_dwg_file_without_its_program_is_a_problem_with_the_remedies(
    client: httpx.Client,
) -> None:
    if LIBREDWG.find() is not None:
        pytest.skip("dwg2dxf of LibreDWG is installed")
    answer = upload(client, "carton.dwg", b"AC1032" + bytes(100))
    assert answer.status_code == 422
    problem = answer.json()
    assert "only if the program LibreDWG is installed" in problem["detail"]
    assert "command dwg2dxf" in problem["hint"]
