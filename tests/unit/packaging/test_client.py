"""The generated Python client, used by the example of an ERP against a real server."""

from __future__ import annotations

import hashlib
import importlib.util
import json
import subprocess
import sys
import zipfile
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType

import pytest

from knifetip.service.settings import Settings
from tests.support.serving.server import LocalClient, run_server, square

pytestmark = pytest.mark.xdist_group("client")

ROOT = Path(__file__).resolve().parents[3]
EXAMPLE = ROOT / "backend" / "docs" / "howto" / "erp_example.py"


def load() -> ModuleType:
    spec = importlib.util.spec_from_file_location("client_build", ROOT / "backend" / "client.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path]:
    """The Python of the generator's environment, and the wheel of the client."""
    build = load()
    try:
        python: Path = build.environment()
    except (OSError, subprocess.CalledProcessError):
        pytest.skip("the generator of the client cannot be installed (make client)")
    folder = tmp_path_factory.mktemp("client")
    return python, build.build_wheel(python, build.generate(python, folder), folder)


@pytest.fixture(scope="module")
def shop(tmp_path_factory: pytest.TempPathFactory) -> Iterator[LocalClient]:
    folder = tmp_path_factory.mktemp("shop")
    with run_server(Settings(database=f"sqlite:///{folder}/shop.sqlite", name="test")) as client:
        yield client


def run_example(
    wheel: tuple[Path, Path], shop: LocalClient, drawing: Path, *more: str
) -> subprocess.CompletedProcess[str]:
    python, client = wheel
    words = [str(python), str(EXAMPLE), str(shop.base_url).rstrip("/"), str(drawing)]
    return subprocess.run(
        [*words, "--number", "PO-4711", "--out", str(drawing.parent), *more],
        capture_output=True,
        text=True,
        timeout=120,
        env={"PYTHONPATH": str(client), "PATH": str(Path(sys.executable).parent)},
    )


def test_an_erp_orders_once_and_gets_the_program(
    wheel: tuple[Path, Path], shop: LocalClient, tmp_path: Path
) -> None:
    drawing = tmp_path / "tray.dxf"
    drawing.write_bytes(square())
    for _ in range(2):
        ran = run_example(wheel, shop, drawing, "--due", "2030-01-02T12:00:00+01:00")
        assert ran.returncode == 0, ran.stdout + ran.stderr
    (job,) = shop.get("/api/v1/jobs", params={"external_id": "PO-4711"}).json()
    assert job["due"] == "2030-01-02T11:00:00.000Z"
    program = (tmp_path / "PO-4711.program").read_bytes()
    assert hashlib.sha256(program).hexdigest() == job["program_sha256"]
    assert job["id"] in ran.stdout


@pytest.mark.parametrize(
    ("content", "more", "words"),
    [
        (b"no drawing", (), "refused:"),
        (square(units=None), (), "question:"),
        (square(), ("--board", "no-such", "--number", "PO-4712"), "no-such"),
    ],
)
def test_an_erp_gets_the_reason_of_a_refusal(
    wheel: tuple[Path, Path],
    shop: LocalClient,
    tmp_path: Path,
    content: bytes,
    more: tuple[str, ...],
    words: str,
) -> None:
    drawing = tmp_path / "tray.dxf"
    drawing.write_bytes(content)
    ran = run_example(wheel, shop, drawing, *more)
    assert (ran.returncode, ran.stderr) == (1, "")
    assert words in ran.stdout


def test_the_wheel_is_typed(wheel: tuple[Path, Path]) -> None:
    names = zipfile.ZipFile(wheel[1]).namelist()
    assert "knifetip_client/py.typed" in names
    assert "knifetip_client/api/webhooks/add_webhook.py" in names


def test_the_client_reads_errors_with_codes_of_newer_servers(
    wheel: tuple[Path, Path], tmp_path: Path
) -> None:
    python, client = wheel
    problem = {
        "code": "drawing.of-next-year",
        "arguments": {},
        "text": "New.",
        "hint": "",
        "title": "New",
        "status": 409,
        "detail": "New.",
    }
    file = tmp_path / "problem.json"
    file.write_text(json.dumps(problem))
    words = (
        "import json, sys; from knifetip_client.models import Problem; "
        "print(Problem.from_dict(json.load(open(sys.argv[1]))).code)"
    )
    ran = subprocess.run(
        [str(python), "-c", words, str(file)],
        capture_output=True,
        text=True,
        env={"PYTHONPATH": str(client)},
    )
    assert (ran.stderr, ran.stdout.strip()) == ("", "drawing.of-next-year")
