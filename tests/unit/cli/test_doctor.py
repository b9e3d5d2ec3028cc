"""knifetip doctor: each check succeeds on a sound computer and reports the fault on another."""

from __future__ import annotations

import json
import sqlite3
import sys
from collections.abc import Callable, Iterator
from contextlib import closing
from functools import partial
from http.server import BaseHTTPRequestHandler, HTTPServer
from importlib.metadata import version
from pathlib import Path
from threading import Thread
from typing import Any

import pytest
import sqlalchemy as sa

from knifetip.cli.checks import computer, machine, server, storage
from knifetip.cli.checks.check_result import CheckResult, Grade, run
from knifetip.formats.conversion import GHOSTSCRIPT, LIBREDWG
from knifetip.model.interpretation import Interpretation
from knifetip.service.database.account_tables import ApiKey
from knifetip.service.database.key_limits import KeyLimits
from knifetip.service.http.scopes import AccessScope
from knifetip.service.orders.store import JobOrder
from knifetip.service.processes.kernel_groups import Part
from knifetip.service.store import Store
from tests.support.command import Command
from tests.support.converters import install_fake
from tests.support.stored import add_drawing, migrated_store


def grades(findings: Iterator[CheckResult]) -> dict[str, Grade]:
    """Return the worst grade of each subject; whatever is not well has an advice."""
    found: dict[str, Grade] = {}
    for finding in findings:
        assert finding.grade is Grade.OK or finding.advice
        found[finding.subject] = max(finding.grade, found.get(finding.subject, Grade.OK))
    return found


def server_options(
    url: str, store: str = "", host: str = "127.0.0.1", key: bool = False
) -> storage.ServerOptions:
    return storage.ServerOptions(url, url, store, host, key)


# The computer


def test_python() -> None:
    assert grades(computer.check_python()) == {"python": Grade.OK}
    assert grades(computer.check_python((3, 10, 9))) == {"python": Grade.PROBLEM}


def test_packages() -> None:
    assert grades(computer.check_packages()) == {"packages": Grade.OK}


@pytest.mark.parametrize(
    ("requirement", "word"),
    [
        ("no-such-package>=1", "not installed"),
        ("numpy<2,>=1", "is needed"),
        ("numpy>=99.1", "is needed"),
    ],
)
def test_a_missing_package_or_another_version_is_a_problem(requirement: str, word: str) -> None:
    (finding,) = computer.check_packages([requirement, "absent; extra == 's3'"])
    assert finding.grade is Grade.PROBLEM
    assert word in finding.text


def test_a_native_part_that_does_not_load_is_a_problem() -> None:
    def load(name: str) -> None:
        if name == "llvmlite.binding":
            raise OSError("wrong ELF class")

    (finding,) = computer.check_packages([], load)
    assert finding.grade is Grade.PROBLEM
    assert "llvmlite.binding cannot be loaded: wrong ELF class" in finding.text


def test_converters_are_optional(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv(GHOSTSCRIPT.variable, "off")
    script = install_fake(monkeypatch, tmp_path, LIBREDWG, "")
    findings = list(computer.check_converters())
    assert [finding.grade for finding in findings] == [Grade.OK, Grade.OK]
    assert [finding.text for finding in findings] == [
        "Ghostscript is not installed, so EPS files are refused",
        f"LibreDWG 99.1 ({script}) converts DWG files",
    ]


def test_kernels_without_machine_code_are_a_warning(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("knifetip.service.processes.kernel_groups.missing_parts", list)
    assert grades(computer.check_kernels()) == {"kernels": Grade.OK}
    monkeypatch.setattr(
        "knifetip.service.processes.kernel_groups.missing_parts",
        lambda: [Part("jobs", "knifetip.post", 3)],
    )
    (finding,) = computer.check_kernels()
    assert (finding.grade, finding.text[:11]) == (Grade.WARNING, "3 functions")


@pytest.mark.parametrize(
    ("free", "grade"),
    [(1 << 40, Grade.OK), (1 << 30, Grade.WARNING), (1 << 20, Grade.PROBLEM)],
)
def test_free_space(tmp_path: Path, free: int, grade: Grade) -> None:
    assert grades(computer.check_disks([tmp_path], lambda _: free)) == {"disk": grade}


def test_a_folder_that_cannot_be_written_is_a_problem(tmp_path: Path) -> None:
    found = list(computer.check_disks([tmp_path / "missing"], lambda _: 1 << 40))
    assert [finding.grade for finding in found] == [Grade.PROBLEM, Grade.OK]


# The database


def test_a_sound_database(database_url: str) -> None:
    with migrated_store(database_url) as store:
        store.users.add("anna", "correct horse battery", AccessScope.ADMIN)
    found = grades(storage.check_database(server_options(database_url)))
    subjects = ("database", "writing", "clock", "store", "accounts", "gateways")
    assert found == dict.fromkeys(subjects, Grade.OK)


def test_a_database_that_is_missing_empty_or_unreachable(tmp_path: Path) -> None:
    url = f"sqlite:///{tmp_path}/none.sqlite"
    assert grades(storage.check_database(server_options(url))) == {"database": Grade.WARNING}
    assert not (tmp_path / "none.sqlite").exists()
    (tmp_path / "none.sqlite").write_bytes(b"")
    assert grades(storage.check_database(server_options(url))) == {"database": Grade.WARNING}
    (tmp_path / "none.sqlite").write_bytes(b"no database at all" * 100)
    assert grades(storage.check_database(server_options(url))) == {"database": Grade.PROBLEM}
    url = "postgresql://nobody@127.0.0.1:1/none?connect_timeout=2"
    assert grades(storage.check_database(server_options(url))) == {"database": Grade.PROBLEM}
    assert grades(storage.check_database(server_options("mysql://h/d"))) == {
        "database": Grade.PROBLEM
    }


def test_tables_that_a_start_of_the_server_migrates_are_a_warning(
    tmp_path: Path, later_version: Callable[[], None]
) -> None:
    url = f"sqlite:///{tmp_path}/shop.sqlite"
    with migrated_store(url):
        pass
    later_version()
    assert grades(storage.check_database(server_options(url))) == {"database": Grade.WARNING}


@pytest.mark.parametrize("revision", ["0089", "9999"])
def test_tables_of_an_unknown_revision_are_a_problem(tmp_path: Path, revision: str) -> None:
    file = tmp_path / "shop.sqlite"
    with migrated_store(f"sqlite:///{file}"):
        pass
    with closing(sqlite3.connect(file)) as database:
        database.execute("UPDATE alembic_version SET version_num = ?", (revision,))
        database.commit()
    assert grades(storage.check_database(server_options(f"sqlite:///{file}"))) == {
        "database": Grade.PROBLEM
    }


def test_a_database_that_stores_nothing_is_a_problem(tmp_path: Path) -> None:
    url = f"sqlite:///{tmp_path}/shop.sqlite"
    with migrated_store(url):
        pass
    with closing(sqlite3.connect(tmp_path / "shop.sqlite")) as database:
        database.execute(
            "CREATE TRIGGER full BEFORE UPDATE ON write_probe "
            "BEGIN SELECT RAISE(ABORT, 'no room'); END"
        )
    assert grades(storage.check_database(server_options(url)))["writing"] is Grade.PROBLEM


def test_the_clock_of_the_database_server(database_url: str) -> None:
    with migrated_store(database_url) as store:
        is_file = database_url.startswith("sqlite")
        now = store.database.clock()
        for difference, grade in ((0.0, Grade.OK), (5.0, Grade.WARNING), (60.0, Grade.PROBLEM)):
            late = partial(float, now - difference)
            found = grades(storage.check_database(server_options(database_url), late))
            assert found["clock"] is (Grade.OK if is_file else grade)


def test_the_folder_for_large_values(tmp_path: Path) -> None:
    url = f"sqlite:///{tmp_path}/shop.sqlite"
    folder = tmp_path / "contents"
    with closing(Store(url, objects=folder.as_uri())) as store:
        store.migrate()
        assert (
            grades(storage.check_database(server_options(url, folder.as_uri())))["store"]
            is Grade.OK
        )
        store.contents.stage(content=b"x" * 5000)
    assert grades(storage.check_database(server_options(url)))["store"] is Grade.PROBLEM
    for path in sorted(folder.rglob("*"), reverse=True):
        path.rmdir() if path.is_dir() else path.unlink()
    folder.rmdir()
    folder.write_bytes(b"")
    found = grades(storage.check_database(server_options(url, folder.as_uri())))
    assert Grade.PROBLEM in found.values()


@pytest.mark.parametrize(
    ("host", "key", "grade"),
    [
        ("127.0.0.1", False, Grade.WARNING),
        ("0.0.0.0", True, Grade.WARNING),
        ("0.0.0.0", False, Grade.PROBLEM),
    ],
)
def test_without_an_administrator(tmp_path: Path, host: str, key: bool, grade: Grade) -> None:
    url = f"sqlite:///{tmp_path}/shop.sqlite"
    with migrated_store(url):
        pass
    assert (
        grades(storage.check_database(server_options(url, host=host, key=key)))["accounts"] is grade
    )


def test_keys_of_gateways_that_are_for_any_machine(database_url: str) -> None:
    with migrated_store(database_url) as store:
        gateway = [AccessScope.GATEWAY]
        bound, _ = store.keys.add("bound", gateway, limits=KeyLimits(machines=frozenset({"a"})))
        new, _ = store.keys.add("new", gateway)
        old, _ = store.keys.add("old table", gateway)
        gone, _ = store.keys.add("gone", gateway)
        store.keys.revoke(gone.id)
        reader, _ = store.keys.add("reader", [AccessScope.READ])
        with store.database.writing() as session:
            for row in (old, gone, reader):
                session.execute(
                    sa.update(ApiKey).where(ApiKey.id == row.id).values(any_machine=True)
                )
    found = [
        one for one in storage.check_database(server_options(database_url)) if one.subject == "keys"
    ]
    assert [one.grade for one in found] == [Grade.WARNING]
    (shown,) = found
    assert "old table" in shown.text
    assert f"knifetip key revoke {old.id}" in shown.advice
    assert all(row.id not in f"{shown.text} {shown.advice}" for row in (bound, new, gone, reader))


def test_jobs_that_wait_for_a_gateway_that_is_not_connected(tmp_path: Path) -> None:
    url = f"sqlite:///{tmp_path}/shop.sqlite"
    with migrated_store(url) as store:
        order = JobOrder("demo-table", "e-flute", Interpretation("mm"))
        job = store.jobs.add(add_drawing(store), order)
        with store.database.writing() as session:
            session.connection().exec_driver_sql(
                f"UPDATE job SET state='queued' WHERE id='{job.id}'"
            )
        assert grades(storage.check_database(server_options(url)))["gateways"] is Grade.WARNING
        store.machines.record_contact("demo-table", "gateway")
        assert grades(storage.check_database(server_options(url)))["gateways"] is Grade.OK


# The computer beside a machine


def test_serial_ports() -> None:
    assert grades(machine.check_ports(list)) == {"serial ports": Grade.OK}
    ports = ["/dev/ttyUSB0", "/dev/ttyUSB1"]
    assert grades(machine.check_ports(lambda: ports, lambda _: True)) == {"serial ports": Grade.OK}
    found = list(machine.check_ports(lambda: ports, lambda name: name.endswith("0")))
    assert [finding.grade for finding in found] == [Grade.OK, Grade.PROBLEM]


def test_the_machine_and_its_controller(tmp_path: Path) -> None:
    assert grades(machine.check_machine("demo-table", "")) == {"machine": Grade.OK}
    assert grades(machine.check_machine("nowhere", "")) == {"machine": Grade.PROBLEM}
    (tmp_path / "mine.toml").write_text("title = ")
    found = grades(machine.check_machine(str(tmp_path / "mine.toml"), ""))
    assert found == {"machine": Grade.PROBLEM}
    address = "serial:///dev/ttyUSB0?baud=115200"
    for ports, grade in (([], Grade.PROBLEM), (["/dev/ttyUSB0"], Grade.OK)):
        found = grades(machine.check_machine("demo-table", address, partial(list, ports)))
        assert found["controller"] is grade


# The server


@pytest.fixture
def answers() -> Iterator[tuple[str, dict[str, tuple[int, Any]]]]:
    """Yield the URL of a server, and its answers (status and JSON) by path."""
    answers: dict[str, tuple[int, Any]] = {
        "/healthz": (200, {"version": version("knifetip")}),
        "/readyz": (200, {"checks": {}}),
        "/api/v1/service": (200, {}),
    }

    class Handler(BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            status, body = answers[self.path]
            text = json.dumps(body).encode()
            self.send_response(status)
            self.send_header("Content-Length", str(len(text)))
            self.end_headers()
            self.wfile.write(text)

        def log_message(self, *_: object) -> None:
            """Print nothing."""

    with HTTPServer(("127.0.0.1", 0), Handler) as listening:
        thread = Thread(target=listening.serve_forever, kwargs={"poll_interval": 0.01})
        thread.start()
        yield f"http://127.0.0.1:{listening.server_port}", answers
        listening.shutdown()
        thread.join()


@pytest.mark.parametrize(
    ("path", "answer", "subject", "grade"),
    [
        ("/healthz", (502, {}), "server", Grade.PROBLEM),
        ("/healthz", (200, {"version": "0.0.0"}), "version", Grade.WARNING),
        ("/readyz", (503, {"checks": {"disk": "full"}}), "readiness", Grade.PROBLEM),
        ("/api/v1/service", (401, {}), "key", Grade.PROBLEM),
        ("/api/v1/service", (500, {}), "key", Grade.PROBLEM),
    ],
)
def test_a_server(
    answers: tuple[str, dict[str, tuple[int, Any]]],
    path: str,
    answer: tuple[int, Any],
    subject: str,
    grade: Grade,
) -> None:
    url, by_path = answers
    found = grades(server.check_server(url, {}))
    assert found == dict.fromkeys(("server", "version", "readiness", "key"), Grade.OK)
    by_path[path] = answer
    assert grades(server.check_server(url, {}))[subject] is grade


def test_the_advice_about_a_key_is_a_command_that_exists(
    answers: tuple[str, dict[str, tuple[int, Any]]], knifetip: Command, tmp_path: Path
) -> None:
    url, by_path = answers
    by_path["/api/v1/service"] = (401, {})
    *_, finding = server.check_server(url, {})
    words = finding.advice.partition("knifetip ")[2].partition(";")[0].split()
    database = f"sqlite:///{tmp_path}/shop.sqlite"
    named = [{"FILE": str(tmp_path / "key"), "TITLE": "office"}.get(word, word) for word in words]
    code, _, err = knifetip(*named, "--database", database)
    assert code == 0, err
    assert (tmp_path / "key").read_text()


@pytest.mark.parametrize("url", ["http://127.0.0.1:1", "not a URL"])
def test_a_server_that_cannot_be_reached(url: str) -> None:
    assert grades(server.check_server(url, {})) == {"server": Grade.PROBLEM}


# The command


def fail(text: str) -> CheckResult:
    raise RuntimeError(text)


def test_an_error_of_a_check_is_a_problem_and_no_traceback() -> None:
    (finding,) = run("disk", lambda: map(fail, ["unforeseen"]))
    assert (finding.grade, finding.subject) == (Grade.PROBLEM, "disk")
    assert "unforeseen" in finding.text


def test_the_exit_code_is_that_of_the_worst_finding(
    knifetip: Command, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("knifetip.service.processes.kernel_groups.missing_parts", list)
    monkeypatch.setattr(computer, "_free_bytes", lambda _: 1 << 40)
    monkeypatch.setattr("knifetip.gateway.transports.serial.port_names", list)
    url = f"sqlite:///{tmp_path}/shop.sqlite"
    with migrated_store(url) as store:
        assert knifetip("doctor", "--database", url)[0] == 1
        store.users.add("anna", "correct horse battery", AccessScope.ADMIN)
        code, out, _ = knifetip("doctor", "--database", url)
        assert (code, "warning" in out, "problem" in out) == (0, False, False)
        words = ("doctor", "--database", url, "--server", "http://127.0.0.1:1", "--json")
        code, out, _ = knifetip(*words)
    assert code == 2
    report = json.loads(out)
    assert report["result"] == "problem"
    assert {one["grade"] for one in report["findings"]} == {"ok", "problem"}
    assert report["findings"][0]["subject"] == "python"
    assert f"{sys.version_info.major}.{sys.version_info.minor}" in report["findings"][0]["text"]


def test_texts_are_in_the_language_of_the_user(
    knifetip: Command, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("LC_ALL", "de_DE.UTF-8")
    code, out, _ = knifetip("doctor", "--database", f"sqlite:///{tmp_path}/none.sqlite")
    assert code == 1
    assert "Warnung database: die Datei" in " ".join(out.split())
    assert "knifetip serve starten, das die Datei anlegt" in out
