"""The shop of docker-compose.yml: its settings, and a job in it through kills and restarts."""

from __future__ import annotations

import hashlib
import re
import stat
import subprocess
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
import yaml

from knifetip.service.store import Store
from tests.container.shop import (
    ROOT,
    Shop,
    compose_command,
    engine_runs,
    has_image,
    run_job_through_restarts,
    start,
)
from tests.support.command import Command

POSTGRES = "docker.io/library/postgres:15-bookworm"
SERVICES: dict[str, Any] = yaml.safe_load((ROOT / "docker-compose.yml").read_text())["services"]
SHOP = {name: one for name, one in SERVICES.items() if one["profiles"] == ["shop"]}
#: Prints a hash of the modules of the package that is installed in an image.
HASH = (
    "import hashlib, pathlib, knifetip; root = pathlib.Path(knifetip.__file__).parent\n"
    "print(hashlib.sha256(b''.join(f.relative_to(root).as_posix().encode() + f.read_bytes() "
    "for f in sorted(root.rglob('*.py')))).hexdigest())"
)

#: Prints the packages that are installed in an image, with normalised names.
PACKAGES = (
    "import re; from importlib.metadata import distributions\n"
    "for one in distributions():\n"
    "    print(re.sub('[-_.]+', '-', one.name).lower() + '==' + one.version)"
)
EXTRAS = (
    "import obstore.store, knifetip.service.accounts.oidc.sign_in, knifetip.telemetry\n"
    "print('loaded')"
)
LICENCES = ROOT / "backend" / "docs" / "licences.md"


def hash_of_sources() -> str:
    root = ROOT / "backend" / "knifetip"
    parts = (
        file.relative_to(root).as_posix().encode() + file.read_bytes()
        for file in sorted(root.rglob("*.py"))
    )
    return hashlib.sha256(b"".join(parts)).hexdigest()


def output_in_image(code: str) -> str:
    """Return what a Python program prints in a container that can write no file."""
    words = ["docker", "run", "--rm", "--read-only", "--network", "none", "--entrypoint", "python"]
    done = subprocess.run(
        [*words, "knifetip", "-c", code], capture_output=True, text=True, check=True
    )
    return done.stdout.strip()


@pytest.fixture
def image() -> None:
    """Skip the test where no engine is, or no image that was built from these sources."""
    if not engine_runs():
        pytest.skip("no container engine runs here")
    if not has_image("knifetip"):
        pytest.skip("the engine has no image knifetip (make image)")
    if output_in_image(HASH) != hash_of_sources():
        pytest.skip("the image knifetip was built from other sources (make image)")


@pytest.fixture
def shop(image: None, tmp_path: Path) -> Iterator[Shop]:
    """Start the shop; skip the test where Compose or the image of the database is missing."""
    compose = compose_command()
    if compose is None:
        pytest.skip("Compose is not installed")
    if not has_image(POSTGRES):
        pytest.skip(f"the engine has no image {POSTGRES} (docker pull {POSTGRES})")
    one = Shop(compose, tmp_path, speed=0.5)
    try:
        yield one
    finally:
        one.remove()


@pytest.mark.timeout(900)
def test_a_job_is_cut_once_while_workers_are_killed_and_the_api_restarts(shop: Shop) -> None:
    start(shop, print)
    ended = run_job_through_restarts(shop, print)
    assert (ended["state"], ended["copies_done"]) == ("done", 1)
    events = shop.service.call(f"/api/jobs/{ended['id']}/events")
    assert [event["state"] for event in events].count("done") == 1


@pytest.mark.usefixtures("image")
def test_the_image_contains_the_packages_of_the_page_of_licences_and_the_extras_work() -> None:
    installed = set(output_in_image(PACKAGES).split())
    listed = re.findall(r"^\| (\S+) \| (\S+) \|", LICENCES.read_text("utf-8"), re.M)
    others = installed - {f"{name}=={version}" for name, version in listed}
    assert [one.split("==")[0] for one in others] == ["knifetip"]
    assert output_in_image(EXTRAS) == "loaded"


def test_one_profile_starts_no_service_of_the_other() -> None:
    assert {tuple(one["profiles"]) for one in SERVICES.values()} == {("small",), ("shop",)}
    settings = (ROOT / ".env").read_text().splitlines()
    assert "COMPOSE_PROFILES=small" in settings
    assert {"api", "worker-1", "worker-2", "gateway", "table", "postgres"} < set(SHOP)


@pytest.mark.parametrize("name", SHOP)
def test_a_part_of_the_shop_is_confined(name: str) -> None:
    part = SHOP[name]
    assert part["read_only"] is True
    assert part["cap_drop"] == ["ALL"]
    assert part["security_opt"] == ["no-new-privileges:true"]
    assert part["mem_limit"]
    assert part["pids_limit"]
    assert "privileged" not in part
    assert all(port.startswith("127.0.0.1:") for port in part.get("ports", []))
    # A secret is a file: its text is in no variable, which every process inherits.
    for variable, value in part.get("environment", {}).items():
        assert "PASSWORD" not in variable or variable.endswith("_FILE"), value
        assert "KEY" not in variable or variable.endswith("_FILE"), value


def test_parts_start_when_what_they_need_is_ready() -> None:
    for name in ("api", "worker-1", "worker-2"):
        needs = SHOP[name]["depends_on"]
        assert needs["migrate"]["condition"] == "service_completed_successfully"
    assert SHOP["migrate"]["depends_on"]["postgres"]["condition"] == "service_healthy"
    assert SHOP["gateway"]["depends_on"]["api"]["condition"] == "service_healthy"
    assert "database" not in SHOP["gateway"]["networks"]


def test_the_gateway_has_a_key_of_its_own_and_not_that_of_the_server() -> None:
    gateway, creator = SHOP["gateway"], SHOP["gateway-key"]
    assert "secrets" not in gateway
    assert gateway["environment"] == {"KNIFETIP_KEY_FILE": "/keys/gateway"}
    assert "gateway-key:/keys:ro" in gateway["volumes"]
    assert creator["volumes"] == ["gateway-key:/data"]
    assert gateway["depends_on"]["gateway-key"]["condition"] == "service_completed_successfully"
    assert creator["depends_on"]["migrate"]["condition"] == "service_completed_successfully"


def test_the_command_that_creates_the_key_of_the_gateway(
    knifetip: Command, tmp_path: Path, postgresql_url: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("KNIFETIP_DATABASE", postgresql_url)
    assert knifetip(*SHOP["migrate"]["command"])[0] == 0
    words = [word.replace("/data/", f"{tmp_path}/") for word in SHOP["gateway-key"]["command"]]
    # Each start of the shop runs the service again.
    for _ in range(2):
        code, out, err = knifetip(*words)
        assert (code, out) == (0, ""), err
    file = tmp_path / "gateway"
    assert stat.S_IMODE(file.stat().st_mode) == 0o600
    store = Store(postgresql_url)
    (key,) = store.keys.all()
    found = store.keys.find(file.read_text().strip())
    store.close()
    assert found is not None
    assert (found.id, found.scopes) == (key.id, ["gateway"])


def test_only_one_shot_services_have_no_health_check() -> None:
    # The image has a check of the API, which the other parts replace.
    without = {name for name, one in SHOP.items() if "healthcheck" not in one}
    assert without == {"api"}
    for name in ("migrate", "gateway-key"):
        assert SHOP[name]["healthcheck"] == {"disable": True}
        assert SHOP[name]["restart"] == "no"


def test_workers_have_names_of_their_own_that_stay_the_same() -> None:
    names = [SHOP[worker]["command"][-1] for worker in ("worker-1", "worker-2")]
    assert names == ["worker-1", "worker-2"]
