"""Hot folder: each drawing is ordered exactly once, also after a kill at any step."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from knifetip.cli.hot_folder.arrivals import Arrivals
from knifetip.cli.hot_folder.client import OrderClient, RetryLater
from knifetip.cli.hot_folder.orders import OrderFolder
from knifetip.cli.watch import visible
from knifetip.service.settings import Settings
from tests.support.command import Command
from tests.support.serving.server import LocalClient, run_server, square
from tests.unit.service.xjdf.test_packages import order_for, zipped

pytestmark = pytest.mark.xdist_group("watch")

DEFAULTS = {"machine": "demo-table", "board": "e-flute"}
NASTY = "\x1b[31mred\nline<b>.dxf"


@pytest.fixture(scope="module")
def shop(tmp_path_factory: pytest.TempPathFactory) -> Iterator[LocalClient]:
    folder = tmp_path_factory.mktemp("watch")
    with run_server(Settings(database=f"sqlite:///{folder}/shop.sqlite", name="test")) as client:
        yield client


@pytest.fixture(autouse=True)
def _closed_clients(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    opened: list[OrderClient] = []
    begin = OrderClient.__init__

    def remember(self: OrderClient, server: str, headers: dict[str, str]) -> None:
        begin(self, server, headers)
        opened.append(self)

    monkeypatch.setattr(OrderClient, "__init__", remember)
    yield
    for client in opened:
        client.close()


def hot_folder(shop: LocalClient, folder: Path) -> OrderFolder:
    return OrderFolder(folder, DEFAULTS, OrderClient(str(shop.base_url), {}))


def drop(folder: Path, name: str, content: bytes, **sidecar: object) -> None:
    if sidecar:
        (folder / f"{name}.json").write_text(json.dumps(sidecar))
    (folder / name).write_bytes(content)


def run(folder: OrderFolder, *names: str) -> None:
    """Process files until none is left."""
    for name in names:
        folder.take(name)
    for _ in range(100_000):
        waiting = folder.in_progress()
        if not waiting:
            return
        for name in waiting:
            folder.advance(name)
    raise AssertionError(waiting)


def result(folder: Path, place: str, name: str) -> dict[str, Any]:
    found: dict[str, Any] = json.loads((folder / place / f"{name}.job.json").read_text())
    return found


def jobs_of(shop: LocalClient, external_id: str) -> list[dict[str, Any]]:
    found: list[dict[str, Any]] = shop.get("/api/jobs", params={"external_id": external_id}).json()
    return found


def test_a_drawing_becomes_a_program_beside_it(shop: LocalClient, tmp_path: Path) -> None:
    drop(tmp_path, "tray.dxf", square(), external_id="PO-1", due="2030-01-02T03:04:05Z", copies=2)
    run(hot_folder(shop, tmp_path), "tray.dxf")
    (job,) = jobs_of(shop, "PO-1")
    assert (job["copies"], job["board"]) == (2, "e-flute")
    found = result(tmp_path, "done", "tray.dxf")
    assert (found["id"], found["state"]) == (job["id"], "ready")
    assert found["verdict"]["accepted"]
    names = ["tray.dxf", "tray.dxf.job.json", "tray.dxf.json", "tray.dxf.ngc"]
    assert sorted(os.listdir(tmp_path / "done")) == [*names, "tray.dxf.picture.svg"]
    program = (tmp_path / "done" / "tray.dxf.ngc").read_bytes()
    assert program == shop.get(f"/api/jobs/{job['id']}/program").content
    assert b"<svg" in (tmp_path / "done" / "tray.dxf.picture.svg").read_bytes()
    assert (tmp_path / "done" / "tray.dxf").read_bytes() == square()
    assert os.listdir(tmp_path / "working") == []


@pytest.mark.parametrize(
    ("name", "content", "sidecar", "words"),
    [
        ("bad.dxf", b"not a drawing", {}, "reason"),
        ("board.dxf", square(), {"board": "no-such"}, "no-such"),
        ("field.dxf", square(), {"bord": "e-flute"}, "bord"),
        ("unit.dxf", square(units=None), {"board": "e-flute"}, "unit"),
    ],
)
def test_what_cannot_be_ordered_is_explained(
    shop: LocalClient,
    tmp_path: Path,
    name: str,
    content: bytes,
    sidecar: dict[str, object],
    words: str,
) -> None:
    drop(tmp_path, name, content, **sidecar)
    run(hot_folder(shop, tmp_path), name)
    assert words in (tmp_path / "failed" / f"{name}.job.json").read_text()
    assert result(tmp_path, "failed", name)["reason"]
    assert (tmp_path / "failed" / name).read_bytes() == content


@pytest.mark.parametrize("text", ["{", "[]", '"x"', "[" * 100_000])
def test_a_sidecar_that_is_no_object_fails(shop: LocalClient, tmp_path: Path, text: str) -> None:
    drop(tmp_path, "tray.dxf", square())
    (tmp_path / "tray.dxf.json").write_text(text)
    run(hot_folder(shop, tmp_path), "tray.dxf")
    assert result(tmp_path, "failed", "tray.dxf")["reason"]
    assert (tmp_path / "failed" / "tray.dxf.json").exists()


def test_the_same_name_again_replaces_nothing(shop: LocalClient, tmp_path: Path) -> None:
    for side in (100.0, 120.0):
        drop(tmp_path, "tray.dxf", square(side=side), external_id="PO-again")
        run(hot_folder(shop, tmp_path), "tray.dxf")
    assert len(jobs_of(shop, "PO-again")) == 2
    assert (tmp_path / "done" / "tray.dxf").read_bytes() == square()
    assert (tmp_path / "done" / "tray-2.dxf").read_bytes() == square(side=120.0)
    assert result(tmp_path, "done", "tray-2.dxf")["state"] == "ready"


def test_an_order_in_xjdf_becomes_a_program_and_a_status(shop: LocalClient, tmp_path: Path) -> None:
    order = order_for("art/tray.dxf", "PO-xjdf").replace(b"e-flute", b"")
    package = zipped({"order.xjdf": order, "art/tray.dxf": square(side=83.0)})
    drop(tmp_path, "order 1.xjdf.zip", package)
    arrivals = Arrivals(tmp_path, 0.0, Seconds())
    assert arrivals.complete() == ["order 1.xjdf.zip"]
    folder = hot_folder(shop, tmp_path)
    run(folder, "order 1.xjdf.zip")
    (job,) = jobs_of(shop, "PO-xjdf")
    assert job["board"] == "e-flute"
    names = [".job.json", ".ngc", ".picture.svg", ".status.xjdf"]
    beside = [f"order 1.xjdf.zip{suffix}" for suffix in ("", *names)]
    assert sorted(os.listdir(tmp_path / "done")) == beside
    status = (tmp_path / "done" / "order 1.xjdf.zip.status.xjdf").read_text()
    assert 'JobID="PO-xjdf"' in status
    assert 'StatusDetails="ready"' in status
    # The drawing that the order names is missing; a sidecar must not contradict the order.
    drop(tmp_path, "alone.xjdf", order_for("tray.dxf"))
    drop(tmp_path, "copies.xjdf.zip", package, copies=2)
    drop(tmp_path, "bomb.xjdf", b"<!DOCTYPE x [<!ENTITY a 'b'>]><x>&a;</x>")
    run(folder, "alone.xjdf", "copies.xjdf.zip", "bomb.xjdf")
    assert "tray.dxf" in result(tmp_path, "failed", "alone.xjdf")["reason"]
    assert "copies" in result(tmp_path, "failed", "copies.xjdf.zip")["reason"]
    assert "not readable" in result(tmp_path, "failed", "bomb.xjdf")["reason"]


class Killed(BaseException):
    """The process ends here."""


def test_a_kill_at_any_step_orders_once_and_loses_nothing(
    shop: LocalClient, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The process is killed before and after each change of a file and each request."""
    steps = 0
    fatal = -1

    def deadly(call: Callable[..., Any]) -> Callable[..., Any]:
        def run_step(*arguments: Any, **named: Any) -> Any:
            nonlocal steps
            steps += 1
            if steps == fatal:
                raise Killed
            found = call(*arguments, **named)
            steps += 1
            if steps == fatal:
                raise Killed
            return found

        return run_step

    monkeypatch.setattr(os, "replace", deadly(os.replace))
    for request in ("upload", "order", "program", "picture"):
        monkeypatch.setattr(OrderClient, request, deadly(getattr(OrderClient, request)))
    for round in range(1, 100):
        folder = tmp_path / str(round)
        folder.mkdir()
        number = f"PO-kill-{round}"
        drop(folder, "tray.dxf", square(side=90.0 + round), external_id=number)
        steps, fatal = 0, round
        try:
            run(hot_folder(shop, folder), "tray.dxf")
            was_killed = False
        except Killed:
            was_killed = True
        fatal = -1
        restarted = hot_folder(shop, folder)
        if (folder / "tray.dxf").exists():
            restarted.take("tray.dxf")
        run(restarted)
        assert len(jobs_of(shop, number)) == 1
        assert (folder / "done" / "tray.dxf").read_bytes() == square(side=90.0 + round)
        assert (folder / "done" / "tray.dxf.ngc").exists()
        assert result(folder, "done", "tray.dxf")["external_id"] == number
        assert not [name for name in os.listdir(folder / "done") if "tray-2" in name]
        if not was_killed:
            break
    assert 15 < round < 99


def test_a_server_that_is_down_keeps_the_files(shop: LocalClient, tmp_path: Path) -> None:
    drop(tmp_path, "tray.dxf", square(), external_id="PO-down")
    down = OrderFolder(tmp_path, DEFAULTS, OrderClient("http://127.0.0.1:9", {}))
    down.take("tray.dxf")
    with pytest.raises(RetryLater):
        down.advance("tray.dxf")
    run(hot_folder(shop, tmp_path))
    assert len(jobs_of(shop, "PO-down")) == 1


def test_a_wrong_key_keeps_the_files(shop: LocalClient, tmp_path: Path) -> None:
    drop(tmp_path, "tray.dxf", square())
    client = OrderClient(str(shop.base_url), {"Authorization": "Bearer nonsense"})
    locked_out = OrderFolder(tmp_path, DEFAULTS, client)
    locked_out.take("tray.dxf")
    with pytest.raises(RetryLater):
        locked_out.advance("tray.dxf")
    assert (tmp_path / "working" / "tray.dxf").exists()


def test_names_with_control_characters_are_ordered_and_harmless(
    shop: LocalClient, tmp_path: Path, knifetip: Command
) -> None:
    undecodable = os.fsdecode(b"\xff\xfe.dxf")
    drop(tmp_path, NASTY, square(), external_id="PO-nasty")
    drop(tmp_path, undecodable, square(side=70.0), external_id="PO-bytes")
    code, out, err = knifetip(
        *("watch", tmp_path, "--server", str(shop.base_url), "--board", "e-flute"),
        *("--settle", 0, "--interval", 0.1, "--once"),
    )
    assert (code, out) == (0, "")
    assert "\x1b" not in err
    assert "red\ufffdline" in err
    for number in ("PO-nasty", "PO-bytes"):
        assert len(jobs_of(shop, number)) == 1
    assert (tmp_path / "done" / NASTY).exists()
    assert (tmp_path / "done" / undecodable).exists()


def test_visible() -> None:
    assert visible("a\x1b[2Jb\r\nc\u202ed\udcff") == "a\ufffd[2Jb\ufffd\ufffdc\ufffdd\ufffd"


class Seconds:
    now = 0.0

    def __call__(self) -> float:
        return self.now


def test_a_file_is_complete_when_it_has_settled(tmp_path: Path) -> None:
    clock = Seconds()
    arrivals = Arrivals(tmp_path, 2.0, clock)
    drawing = tmp_path / "tray.DXF"
    drawing.write_bytes(b"")
    for name in ("notes.txt", ".hidden.dxf", "~lock.dxf", "tray.dxf.part"):
        (tmp_path / name).write_bytes(b"x")
    (tmp_path / "folder.dxf").mkdir()
    (tmp_path / "link.dxf").symlink_to("/etc/passwd")
    os.mkfifo(tmp_path / "pipe.dxf")
    for second in range(5):
        clock.now = float(second)
        assert arrivals.complete() == []
    # It grows, then rests, then its sidecar comes.
    drawing.write_bytes(b"half")
    assert arrivals.complete() == []
    clock.now = 5.9
    drawing.write_bytes(b"the whole")
    assert arrivals.complete() == []
    clock.now = 7.0
    assert arrivals.complete() == []
    (tmp_path / "tray.DXF.json").write_text("{}")
    assert arrivals.complete() == []
    clock.now = 8.5
    assert arrivals.complete() == []
    clock.now = 9.0
    assert arrivals.complete() == ["tray.DXF"]


def test_a_locked_file_waits(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    clock = Seconds()
    arrivals = Arrivals(tmp_path, 0.0, clock)
    (tmp_path / "tray.dxf").write_bytes(b"x")
    real = Path.open

    def locked(self: Path, *arguments: Any, **named: Any) -> Any:
        if self.name == "tray.dxf":
            raise PermissionError(13, "The process cannot access the file")
        return real(self, *arguments, **named)

    with monkeypatch.context() as patched:
        patched.setattr(Path, "open", locked)
        assert arrivals.complete() == []
        assert arrivals.is_waiting
    assert arrivals.complete() == ["tray.dxf"]


def test_a_folder_that_does_not_exist(tmp_path: Path, knifetip: Command) -> None:
    code, _, err = knifetip("watch", tmp_path / "none", "--once")
    assert code
    assert "none" in err


@pytest.mark.parametrize(
    ("url", "path"), [("tray.dxf", "tray.dxf"), ("./art/my%20tray.dxf", "art/my tray.dxf")]
)
def test_an_order_in_xjdf_takes_the_drawing_beside_it(
    shop: LocalClient, tmp_path: Path, url: str, path: str
) -> None:
    (tmp_path / path).parent.mkdir(exist_ok=True)
    (tmp_path / path).write_bytes(square(side=31.0))
    id = f"PO-beside-{len(url)}"
    drop(tmp_path, "order.xjdf", order_for(url, id))
    run(hot_folder(shop, tmp_path), "order.xjdf")
    (job,) = jobs_of(shop, id)
    assert shop.get(f"/api/drawings/{job['drawing']}").json()["width"] == 31.0
    assert result(tmp_path, "done", "order.xjdf")["state"] == "ready"
    name = Path(path).name
    assert (tmp_path / "done" / f"order.xjdf.{name}").read_bytes() == square(side=31.0)
    assert not (tmp_path / path).exists()
    assert os.listdir(tmp_path / "working") == []


def test_a_kill_between_the_drawing_and_its_order_loses_nothing(
    shop: LocalClient, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    drop(tmp_path, "tray.dxf", square(side=32.0))
    drop(tmp_path, "order.xjdf", order_for("tray.dxf", "PO-killed"))
    replace = os.replace

    def killed(source: Path, target: Path) -> None:
        if Path(source).name == "order.xjdf":
            raise KeyboardInterrupt
        replace(source, target)

    monkeypatch.setattr(os, "replace", killed)
    with pytest.raises(KeyboardInterrupt):
        hot_folder(shop, tmp_path).take("order.xjdf")
    monkeypatch.setattr(os, "replace", replace)
    run(hot_folder(shop, tmp_path), "order.xjdf")
    assert len(jobs_of(shop, "PO-killed")) == 1
    assert (tmp_path / "done" / "order.xjdf.tray.dxf").exists()


def test_an_order_whose_drawing_does_not_come_is_explained(
    shop: LocalClient, tmp_path: Path
) -> None:
    drop(tmp_path, "order.xjdf", order_for("missing.dxf", "PO-alone"))
    run(hot_folder(shop, tmp_path), "order.xjdf")
    found = result(tmp_path, "failed", "order.xjdf")
    assert "missing.dxf" in found["reason"]
    assert "*.xjdf.zip" in found["hint"]
    assert jobs_of(shop, "PO-alone") == []


@pytest.mark.parametrize("url", ["../secret.dxf", "%2e%2e/secret.dxf", "link.dxf", "away/a.dxf"])
def test_an_order_takes_nothing_from_outside_its_folder(
    shop: LocalClient, tmp_path: Path, url: str
) -> None:
    folder, outside = tmp_path / "in", tmp_path / "out"
    folder.mkdir()
    outside.mkdir()
    for path in (tmp_path / "secret.dxf", outside / "a.dxf"):
        path.write_bytes(square())
    (folder / "link.dxf").symlink_to(tmp_path / "secret.dxf")
    (folder / "away").symlink_to(outside)
    drop(folder, "order.xjdf", order_for(url, "PO-outside"))
    run(hot_folder(shop, folder), "order.xjdf")
    assert result(folder, "failed", "order.xjdf")["state"] == "refused"
    assert jobs_of(shop, "PO-outside") == []
    assert (tmp_path / "secret.dxf").exists()
    assert (outside / "a.dxf").exists()


def test_an_order_and_its_drawing_are_complete_together(tmp_path: Path) -> None:
    now = 0.0
    arrivals = Arrivals(tmp_path, 2.0, lambda: now, 10.0)
    drop(tmp_path, "order.xjdf", order_for("tray.dxf", "PO-1"))
    assert arrivals.complete() == []
    now = 5.0
    assert arrivals.complete() == []
    # The drawing belongs to the order as soon as it comes, and must settle too.
    drop(tmp_path, "tray.dxf", square())
    drop(tmp_path, "other.dxf", square())
    assert arrivals.complete() == []
    now = 6.0
    assert arrivals.complete() == []
    now = 7.0
    assert sorted(arrivals.complete()) == ["order.xjdf", "other.dxf"]


def test_an_order_waits_for_its_drawing_for_a_limited_time(tmp_path: Path) -> None:
    now = 0.0
    arrivals = Arrivals(tmp_path, 2.0, lambda: now, 10.0)
    drop(tmp_path, "order.xjdf", order_for("tray.dxf", "PO-1"))
    assert arrivals.complete() == []
    now = 11.9
    assert arrivals.complete() == []
    now = 12.0
    assert arrivals.complete() == ["order.xjdf"]
