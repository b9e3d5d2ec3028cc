"""The preparation of a machine: in its file, in the answer, and as a check before each start."""

from __future__ import annotations

import httpx
import pytest

from knifetip.library import load
from tests.support.serving.server import order_job, square, upload_drawing, wait_for_state

pytestmark = pytest.mark.xdist_group("server")

NOTE = "open vacuum zones 2 and 3"


def test_the_preparation_is_checked_before_a_start(client: httpx.Client) -> None:
    text = f'setup_note = "{NOTE}"\n' + load.library_text("machines", "demo-table")
    saved = client.put(
        "/api/machines/prepared-table",
        content=text.encode(),
        headers={"Content-Type": "application/toml"},
    )
    assert saved.status_code == 201, saved.text
    shown = {one["name"]: one["setup_note"] for one in client.get("/api/machines").json()}
    assert (shown["prepared-table"], shown["demo-table"]) == (NOTE, "")
    texts = {}
    for machine in ("prepared-table", "demo-table"):
        drawing = upload_drawing(client, square())["id"]
        job = order_job(client, drawing, machine=machine)
        wait_for_state(client, job["id"], "ready")
        checks = client.get(f"/api/jobs/{job['id']}/confirmation").json()["checks"]
        texts[machine] = {check["id"]: check["text"] for check in checks}
    assert texts["prepared-table"].pop("setup") == f"Prepared: {NOTE}"
    assert texts["prepared-table"].keys() == texts["demo-table"].keys()
