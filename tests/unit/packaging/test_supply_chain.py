"""The page of licences follows the locks, and an audit without an answer is not clean."""

from __future__ import annotations

import json
import re
import tomllib
from pathlib import Path

import pytest

from tests.support.scripts import BACKEND, load_script

ROW = re.compile(r"^\| (\S+) \| (\S+) \| (.+) \|$", re.M)

licences = load_script("licences")
supply_chain = load_script("supply_chain")
Status = supply_chain.Status


def listed() -> set[tuple[str, str]]:
    """Return names and versions in the page of licences."""
    rows = ROW.findall(licences.PAGE.read_text("utf-8"))
    return {(name, version) for name, version, _ in rows if name != "package"}


def test_the_page_of_licences_lists_every_package_of_the_locks_and_no_other() -> None:
    page = {(one.name, one.version) for one in licences.page_packages()}
    server = set(licences.server_packages())
    assert len(server) > 40
    assert len(page) > 20
    assert listed() == server | set(licences.extra_packages()) | page, "run: make licences"


def test_the_lock_with_the_extras_pins_the_same_server_and_every_extra() -> None:
    server, extras = set(licences.server_packages()), set(licences.extra_packages())
    assert server < set(licences.pinned("requirements-extras.lock"))
    project = tomllib.loads((BACKEND / "pyproject.toml").read_text("utf-8"))["project"]
    for extra, requirements in project["optional-dependencies"].items():
        for requirement in requirements if extra != "dev" else []:
            name = re.split(r"[^a-z0-9._-]", requirement)[0]
            assert name in {name for name, _ in extras}, (extra, requirement)
    # What the extras require is delivered as well.
    assert {"protobuf", "requests"} < {name for name, _ in extras}


def test_another_version_in_a_lock_is_detected(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    name, version = licences.server_packages()[0]
    for lock in ("requirements.lock", "requirements-extras.lock"):
        text = (BACKEND / lock).read_text("utf-8")
        (tmp_path / lock).write_text(text.replace(f"{name}=={version} ", f"{name}==99.9 "))
    monkeypatch.setattr(licences, "BACKEND", tmp_path)
    assert (name, "99.9") in set(licences.server_packages()) - listed()


def test_every_licence_is_stated_and_the_copyleft_one_is_explained() -> None:
    text = licences.PAGE.read_text("utf-8")
    rows = ROW.findall(text)
    assert all(licence.strip() for _, _, licence in rows)
    copyleft = {name for name, _, licence in rows if re.search(r"\bA?L?GPL", licence)}
    assert copyleft == {"fpdf2", "psycopg", "psycopg-binary"}
    assert "**psycopg and fpdf2 are under the LGPL 3.0.**" in text


def python(**package: object) -> str:
    return json.dumps({"dependencies": [{"name": "a", "version": "1", **package}]})


@pytest.mark.parametrize(
    ("output", "status"),
    [
        (python(vulns=[]), Status.CLEAN),
        (python(vulns=[{"id": "PYSEC-1"}]), Status.VULNERABLE),
        (python(skip_reason="Dependency not found on PyPI"), Status.UNREACHED),
        (json.dumps({"dependencies": []}), Status.UNREACHED),
        ("", Status.UNREACHED),
    ],
)
def test_the_server_is_clean_only_if_every_package_was_audited(output: str, status: object) -> None:
    assert supply_chain.python_status(output)[0] is status


@pytest.mark.parametrize(
    ("vulnerabilities", "status"),
    [({}, Status.CLEAN), ({"three": {"severity": "high"}}, Status.VULNERABLE)],
)
def test_the_page_is_clean_only_if_npm_answers(
    vulnerabilities: dict[str, object], status: object
) -> None:
    report = {"vulnerabilities": vulnerabilities, "metadata": {"dependencies": {"prod": 7}}}
    assert supply_chain.page_status(json.dumps(report))[0] is status
    assert supply_chain.page_status('{"error": {"code": "E404"}}')[0] is Status.UNREACHED


@pytest.mark.parametrize(
    ("server", "page", "code"), [(0, 0, 0), (1, 3, 1), (3, 1, 1), (0, 3, 3), (3, 0, 3)]
)
def test_the_exit_code_is_that_of_the_worse_result(
    server: int, page: int, code: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(supply_chain, "audit_server", lambda: (Status(server), ["server"]))
    monkeypatch.setattr(supply_chain, "audit_page", lambda: (Status(page), ["page"]))
    assert supply_chain.audit() == code
