"""The whole way through REST: upload, order, and the simulated table runs it to its end."""

from __future__ import annotations

import time
from collections.abc import Iterator
from pathlib import Path

import httpx
import pytest

from named import NAMED, SAMPLES, Named
from serving import Running, ordered, square, until, uploaded

pytestmark = pytest.mark.xdist_group("server")


@pytest.fixture(scope="module")
def shop(tmp_path_factory: pytest.TempPathFactory) -> Iterator[httpx.Client]:
    """A server with a table that is fifty times as fast as a real one."""
    with Running(tmp_path_factory.mktemp("shop") / "shop.sqlite", speed=50.0) as client:
        yield client


def runs_to_its_end(shop: httpx.Client, named: Named, corpus: Path | None) -> None:
    asked = {"profile": named.profile} | ({"unit": named.unit} if named.unit else {})
    drawing = uploaded(shop, named.data(corpus), **asked)
    assert drawing["questions"] == []
    job = ordered(shop, drawing["id"], board=named.board, release=True)["id"]
    done = until(shop, job, "done")
    assert done["verdict"]["accepted"]
    assert (done["line"], done["progress"]) == (done["lines"], 1.0)


@pytest.mark.parametrize("named", SAMPLES, ids=str)
def test_a_sample_runs_to_its_end(shop: httpx.Client, named: Named):
    runs_to_its_end(shop, named, None)


@pytest.mark.corpus
@pytest.mark.parametrize("named", NAMED, ids=str)
def test_a_drawing_by_other_hands_runs_to_its_end(shop: httpx.Client, named: Named, corpus: Path):
    runs_to_its_end(shop, named, corpus)


def test_three_copies_stop_for_a_new_sheet_between_them(shop: httpx.Client):
    drawing = uploaded(shop, square())["id"]
    job = ordered(shop, drawing, copies=3, release=True)["id"]
    for copy in (1, 2):
        while until(shop, job, "held", "running")["copies_done"] < copy:
            time.sleep(0.02)
        shop.post(f"/api/jobs/{job}/resume")
    done = until(shop, job, "done")
    assert done["copies_done"] == 3
    whys = [event["why"] for event in shop.get(f"/api/jobs/{job}/events").json()]
    assert "copy 1 of 3 is done: put a new sheet on the table" in whys
    assert "copy 2 of 3 is done: put a new sheet on the table" in whys


def test_hold_resume_and_cancel_reach_the_machine(shop: httpx.Client):
    drawing = uploaded(shop, square(side=1000.0))["id"]
    job = ordered(shop, drawing, copies=2, release=True)["id"]
    until(shop, job, "held")
    shop.post(f"/api/jobs/{job}/cancel")
    cancelled = until(shop, job, "cancelled")
    assert cancelled["copies_done"] == 1
    assert shop.get("/api/machines/demo-table").json()["job"] is None
