"""Old jobs and drawings are deleted after they were archived; what is needed stays."""

from __future__ import annotations

import io
import json
import zipfile
from pathlib import Path

import httpx
import pytest
import sqlalchemy as sa

from knifetip.service.content.store import address_of
from knifetip.service.database.tables import Content, Drawing, Job
from knifetip.service.history import export as job_export
from knifetip.service.history import retention
from knifetip.service.history.export import archive_jobs
from knifetip.service.settings import Settings
from knifetip.service.store import Store
from tests.support.command import Command
from tests.support.serving.server import (
    order_job,
    run_server,
    service_of,
    square,
    upload_drawing,
    wait_for_state,
)

pytestmark = pytest.mark.xdist_group("retention")
DAY = 86_400.0


def contents(archive: bytes) -> dict[str, bytes]:
    with zipfile.ZipFile(io.BytesIO(archive)) as opened:
        return {name: opened.read(name) for name in opened.namelist()}


def compiled_job(client: httpx.Client) -> tuple[str, str]:
    drawing = upload_drawing(client, square())["id"]
    job = order_job(client, drawing)["id"]
    wait_for_state(client, job, "ready")
    return drawing, job


def make_older(store: Store, days: float) -> None:
    """Move the times of all drawings and jobs into the past."""
    with store.database.writing() as session:
        session.execute(sa.update(Drawing).values(created=Drawing.created - days * DAY))
        session.execute(sa.update(Job).where(Job.ended > 0).values(ended=Job.ended - days * DAY))


def test_a_job_is_exported_with_drawing_program_verdict_and_events(
    client: httpx.Client, knifetip: Command, tmp_path: Path
) -> None:
    drawing, job = compiled_job(client)
    answer = client.get(f"/api/v1/jobs/{job}/export")
    assert answer.status_code == 200
    assert answer.headers["Content-Type"] == "application/zip"
    assert answer.headers["Content-Disposition"] == f'attachment; filename="{job}.zip"'
    files = contents(answer.content)
    assert sorted(files) == [
        "drawing-square.dxf", "events.json", "job.json", "program.txt", "verdict.json",
    ]  # fmt: skip
    assert files["drawing-square.dxf"] == square()
    assert files["program.txt"] == client.get(f"/api/jobs/{job}/program").content
    assert json.loads(files["job.json"])["drawing"] == drawing
    assert json.loads(files["verdict.json"])["accepted"] is True
    states = [event["state"] for event in json.loads(files["events.json"])]
    assert states == [one["state"] for one in client.get(f"/api/jobs/{job}/events").json()]
    assert client.get("/api/jobs/none/export").status_code == 404

    code, out, err = knifetip(
        "export", tmp_path / "out", "--job", job, "--server", str(client.base_url)
    )
    assert code == 0, err
    assert contents((tmp_path / "out" / f"{job}.zip").read_bytes()) == files
    assert out == f"{tmp_path / 'out' / f'{job}.zip'}\n"


def test_all_jobs_are_exported(
    knifetip: Command, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("knifetip.cli.job_client._PAGE", 1)
    with run_server(Settings(database=f"sqlite:///{tmp_path}/a.sqlite", name="test")) as client:
        drawing = upload_drawing(client, square())["id"]
        jobs = {order_job(client, drawing)["id"] for _ in range(2)}
        code, _out, err = knifetip("export", tmp_path, "--server", str(client.base_url))
    assert code == 0, err
    assert {file.stem for file in tmp_path.glob("*.zip")} == jobs


def test_old_jobs_are_archived_and_deleted_and_the_others_kept(tmp_path: Path) -> None:
    with run_server(Settings(database=f"sqlite:///{tmp_path}/a.sqlite", name="test")) as client:
        store = service_of(client.app).store
        old_drawing, old = compiled_job(client)
        used, ready = compiled_job(client)
        unused = upload_drawing(client, square())["id"]
        client.post(f"/api/jobs/{old}/cancel")
        events = store.events.of_job(old)
        make_older(store, 30.0)
        exported = contents(client.get(f"/api/jobs/{old}/export").content)
        young = upload_drawing(client, square())["id"]

        assert retention.purge(store, 31, 31, tmp_path / "archive") == (0, 0)
        assert not list(tmp_path.glob("archive/*"))
        assert retention.purge(store, 29, 29, tmp_path / "archive") == (1, 2)

        files = {file.name: contents(file.read_bytes()) for file in tmp_path.glob("archive/*")}
        assert set(files) == {f"{old}.zip", f"drawing-{old_drawing}.zip", f"drawing-{unused}.zip"}
        assert files[f"{old}.zip"] == exported
        archived = files[f"drawing-{unused}.zip"]
        assert set(archived) == {"drawing.json", "drawing-square.dxf"}
        assert archived["drawing-square.dxf"] == square()
        assert json.loads(archived["drawing.json"])["id"] == unused
        assert client.get(f"/api/jobs/{old}").status_code == 404
        assert client.get(f"/api/jobs/{ready}").json()["state"] == "ready"
        gone = {one: client.get(f"/api/drawings/{one}").status_code for one in (
            old_drawing, unused, used, young,
        )}  # fmt: skip
        assert gone == {old_drawing: 404, unused: 404, used: 200, young: 200}
        kept = [(event.id, event.state) for event in store.events.of_job(old)]
        assert kept == [(event.id, event.state) for event in events]
        assert len(kept) > 2
        assert client.get("/api/history").status_code == 200


def test_what_cannot_be_archived_is_kept(tmp_path: Path) -> None:
    with run_server(Settings(database=f"sqlite:///{tmp_path}/a.sqlite", name="test")) as client:
        store = service_of(client.app).store
        _, job = compiled_job(client)
        unused = upload_drawing(client, square())["id"]
        client.post(f"/api/jobs/{job}/cancel")
        make_older(store, 30.0)
        (tmp_path / "archive").write_text("a file, not a folder")
        with pytest.raises(OSError, match="archive"):
            retention.purge(store, 1, 0, tmp_path / "archive")
        with pytest.raises(OSError, match="archive"):
            retention.purge(store, 0, 1, tmp_path / "archive")
        assert client.get(f"/api/jobs/{job}").json()["state"] == "cancelled"
        assert client.get(f"/api/drawings/{unused}").status_code == 200


def test_a_job_whose_program_is_lost_is_kept_and_the_others_are_deleted(tmp_path: Path) -> None:
    with run_server(Settings(database=f"sqlite:///{tmp_path}/a.sqlite", name="test")) as client:
        store = service_of(client.app).store
        lost, other = (compiled_job(client)[1] for _ in range(2))
        for job in (lost, other):
            client.post(f"/api/jobs/{job}/cancel")
        address = address_of(b"the program of this job")
        with store.database.writing() as session:
            session.execute(sa.insert(Content).values(address=address, data=b"other bytes"))
            session.execute(sa.update(Job).where(Job.id == lost).values(program_address=address))
        make_older(store, 30.0)
        assert retention.purge(store, 1, 0, tmp_path / "archive") == (1, 0)
        assert [file.name for file in (tmp_path / "archive").iterdir()] == [f"{other}.zip"]
        assert client.get(f"/api/jobs/{lost}").status_code == 200
        assert client.get(f"/api/jobs/{other}").status_code == 404


def test_two_servers_archive_into_one_folder(tmp_path: Path) -> None:
    with run_server(Settings(database=f"sqlite:///{tmp_path}/a.sqlite", name="test")) as client:
        store = service_of(client.app).store
        _, job = compiled_job(client)
        # The other server has deleted a job meanwhile.
        assert archive_jobs(store, tmp_path / "archive", ["gone", job]) == [job]
        assert [file.name for file in (tmp_path / "archive").iterdir()] == [f"{job}.zip"]


def test_an_archive_is_on_the_disk_before_its_job_is_deleted(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    with run_server(Settings(database=f"sqlite:///{tmp_path}/a.sqlite", name="test")) as client:
        store = service_of(client.app).store
        _, job = compiled_job(client)
        synced: list[str] = []
        monkeypatch.setattr(job_export, "sync", lambda path: synced.append(path.name))
        archive_jobs(store, tmp_path / "archive", [job])
        assert [name.partition(".")[0] for name in synced] == [job, "archive"]
