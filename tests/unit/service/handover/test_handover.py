"""Tickets and exports of a server: of a compiled job, of a layout, and with limited rights."""

from __future__ import annotations

import io
from typing import Any

import httpx
import pypdf
import pytest

from knifetip import pipeline
from tests.support.serving.server import order_job, square, upload_drawing, wait_for_state

pytestmark = pytest.mark.xdist_group("server")


@pytest.fixture(scope="module")
def job(client: httpx.Client) -> dict[str, Any]:
    drawing = upload_drawing(client, square())["id"]
    ordered = order_job(client, drawing, customer="Müller", external_id="PO 1/2", copies=2)
    return wait_for_state(client, ordered["id"], "ready")


def text_of(answer: httpx.Response) -> str:
    assert answer.status_code == 200, answer.text
    return " ".join(pypdf.PdfReader(io.BytesIO(answer.content)).pages[0].extract_text().split())


def test_the_ticket_of_a_job_is_in_the_language_of_the_request(
    client: httpx.Client, job: dict[str, Any]
) -> None:
    address = f"/api/v1/jobs/{job['id']}/ticket.pdf"
    german = client.get(address, headers={"Accept-Language": "de-AT,en;q=0.5"})
    assert german.headers["Content-Type"] == "application/pdf"
    assert german.headers["Content-Language"] == "de"
    assert german.headers["Content-Disposition"] == 'inline; filename="ticket-PO-1-2.pdf"'
    found = text_of(german)
    for part in ("Kunde Müller", "Schneiden: 0,40 m", "Das Programm macht die Zeichnung auf"):
        assert part in found, part
    english = text_of(client.get(address, params={"language": "en"}))
    assert "lower left corner of the drawing at X 20.0, Y 20.0 mm" in english
    assert "T1 " in english
    (link,) = pypdf.PdfReader(io.BytesIO(german.content)).pages[0].annotations or []
    assert link.get_object()["/A"]["/URI"] == f"{client.base_url}/#/station/demo-table".replace(
        "//#", "/#"
    )


def test_a_job_that_was_refused_has_a_ticket_with_a_warning(client: httpx.Client) -> None:
    drawing = upload_drawing(client, square(side=5000.0))["id"]
    refused = wait_for_state(client, order_job(client, drawing)["id"], "refused")
    text = text_of(client.get(f"/api/v1/jobs/{refused['id']}/ticket.pdf"))
    assert "There is no program yet (state: refused)" in text
    answer = client.get(f"/api/v1/jobs/{refused['id']}/toolpath/export", params={"format": "svg"})
    assert (answer.status_code, answer.json()["code"]) == (409, "store.no-column")


@pytest.mark.parametrize(
    ("form", "media", "begin"),
    [
        ("svg", "image/svg+xml", b"<?xml"),
        ("png", "image/png", b"\x89PNG"),
        ("dxf", "image/vnd.dxf", b"999\nDXF by knifetip"),
        ("pdf", "application/pdf", b"%PDF-"),
    ],
)
def test_drawing_and_path_are_exported(
    client: httpx.Client, job: dict[str, Any], form: str, media: str, begin: bytes
) -> None:
    for address, name in (
        (f"/api/v1/drawings/{job['drawing']}/export", f"square.{form}"),
        (f"/api/v1/jobs/{job['id']}/toolpath/export", f"square-path.{form}"),
    ):
        answer = client.get(address, params={"format": form})
        assert answer.status_code == 200, answer.text
        assert answer.headers["Content-Type"] == media
        assert answer.headers["Content-Disposition"] == f'attachment; filename="{name}"'
        assert answer.content.startswith(begin)
        known = {"If-None-Match": answer.headers["ETag"]}
        assert client.get(address, params={"format": form}, headers=known).status_code == 304


def test_the_sheet_of_a_layout_is_exported_with_all_copies(
    client: httpx.Client, job: dict[str, Any]
) -> None:
    placed = [{"drawing": job["drawing"], "x": 20.0, "y": 30.0, "columns": 3, "gap_x": 5.0}]
    body = {"name": "sheet 1", "sheet": {"width": 500.0, "height": 300.0}, "placed": placed}
    layout = client.post("/api/v1/layouts", json=body).json()["id"]
    answer = client.get(f"/api/v1/drawings/{layout}/export", params={"format": "dxf"})
    assert len(pipeline.read(answer.content)) == 12


@pytest.mark.parametrize(
    "query",
    [{}, {"format": "stl"}, {"format": "png", "width": 5000}, {"format": "png", "width": 1}],
)
def test_unknown_formats_and_widths_are_refused(
    client: httpx.Client, job: dict[str, Any], query: dict[str, Any]
) -> None:
    for address in (f"drawings/{job['drawing']}/export", f"jobs/{job['id']}/toolpath/export"):
        assert client.get(f"/api/v1/{address}", params=query).status_code == 422


def test_unknown_jobs_and_drawings_are_not_found(client: httpx.Client) -> None:
    for address in ("jobs/x/ticket.pdf", "jobs/x/toolpath/export", "drawings/x/export"):
        query = {} if address.endswith("pdf") else {"format": "svg"}
        assert client.get(f"/api/v1/{address}", params=query).status_code == 404
