"""An installed wheel is the whole service: page, migrations, library, samples, version."""

from __future__ import annotations

import re
import signal
import subprocess
import sys
import sysconfig
import tarfile
import time
import venv
import zipfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import httpx
import pytest

from knifetip.library import load

ROOT = Path(__file__).resolve().parents[3]
BACKEND = ROOT / "backend"

pytestmark = pytest.mark.xdist_group("wheel")


def run(*words: object) -> subprocess.CompletedProcess[str]:
    """Run a program away from the sources, and return its output."""
    return subprocess.run(
        [str(word) for word in words],
        cwd="/",
        capture_output=True,
        text=True,
        check=False,
    )


def build(target: Path, source: Path = BACKEND) -> Path:
    """Return a wheel of a source folder or a source distribution."""
    pip = [sys.executable, "-m", "pip", "wheel", "--quiet", "--no-deps", "--wheel-dir", target]
    done = run(*pip, source)
    if "hatchling" in done.stderr and "No matching distribution" in done.stderr:
        pytest.skip("the build backend hatchling can be fetched from no package index")
    assert done.returncode == 0, done.stderr
    (wheel,) = target.glob("*.whl")
    return wheel


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    if not (BACKEND / "knifetip" / "service" / "page" / "index.html").is_file():
        pytest.skip("the page is not built (make page)")
    return build(tmp_path_factory.mktemp("wheel"))


@pytest.fixture(scope="module")
def scripts(wheel: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the folder of programs of a new environment into which the wheel is installed.

    Its dependencies are those of this environment, without the clone that is installed in it.
    """
    folder = tmp_path_factory.mktemp("environment")
    venv.create(folder)
    bin = folder / "bin"
    pip = (sys.executable, "-m", "pip", "--python", bin / "python", "install", "--quiet")
    done = run(*pip, "--no-deps", "--no-index", wheel)
    assert done.returncode == 0, done.stderr
    (packages,) = folder.glob("lib/python3*/site-packages")
    (packages / "dependencies.pth").write_text(sysconfig.get_path("purelib") + "\n")
    return bin


@contextmanager
def serving(command: Path, folder: Path) -> Iterator[httpx.Client]:
    """Run the installed command ``serve`` in an empty folder; yield a client of the server."""
    with (folder / "log").open("w+") as log:
        process = subprocess.Popen(
            [command, "serve", "--port", "0"], cwd=folder, stderr=log, stdout=log
        )
        try:
            url = _wait_for_url(process, folder / "log")
            with httpx.Client(base_url=url, timeout=30.0, trust_env=False) as client:
                yield client
        finally:
            process.send_signal(signal.SIGTERM)
            process.wait(30.0)


def _wait_for_url(process: subprocess.Popen[bytes], log: Path) -> str:
    while process.poll() is None:
        if found := re.search(r"http://\S+", log.read_text()):
            return found[0]
        time.sleep(0.05)
    raise AssertionError(log.read_text())


def test_the_wheel_contains_what_the_package_reads_at_run_time(wheel: Path) -> None:
    with zipfile.ZipFile(wheel) as archive:
        names = set(archive.namelist())
    files = {
        file.relative_to(BACKEND).as_posix()
        for file in (BACKEND / "knifetip").rglob("*")
        if file.is_file() and file.suffix not in (".pyc", ".nbi", ".nbc")
    }
    assert files <= names
    assert "knifetip/LICENSE" in names
    assert not {name for name in names if name.endswith((".pyc", ".nbi", ".nbc"))}


def test_an_installed_wheel_serves_page_samples_and_tables(scripts: Path, tmp_path: Path) -> None:
    version = run(scripts / "knifetip", "--version").stdout
    assert re.fullmatch(r"knifetip \d+\.\d+\.\d+\n", version)
    origin = run(scripts / "python", "-c", "import knifetip; print(knifetip.__file__)").stdout
    assert origin.startswith(str(scripts.parent))
    with serving(scripts / "knifetip", tmp_path) as client:
        page = client.get("/")
        assert page.status_code == 200
        for asset in re.findall(r'(?:src|href)="(/[^"]+)"', page.text):
            assert client.get(asset).status_code == 200, asset
        assert client.get("/readyz").status_code == 200
        service = client.get("/api/service").json()
        assert service["version"] == version.split()[1]
        # A new installation has no machine code: the page shows that it is compiled.
        while service["preparing"] and not service["parts"]:
            service = client.get("/api/service").json()
        assert service["parts"] > 100
        machines = {row["name"] for row in client.get("/api/machines").json()}
        assert machines >= set(load.names("machines"))
    assert (tmp_path / "knifetip.sqlite").is_file()
    done = run(
        scripts / "knifetip", "db", "check", "--database", f"sqlite:///{tmp_path}/knifetip.sqlite"
    )
    assert done.returncode == 0, done.stderr
    cartons = run(scripts / "knifetip", "samples", tmp_path / "samples")
    assert cartons.returncode == 0, cartons.stderr
    assert len(list((tmp_path / "samples").glob("*.dxf"))) > 2


def test_a_package_without_the_page_is_not_built(tmp_path: Path) -> None:
    source = tmp_path / "backend"
    source.mkdir()
    (source / "knifetip").mkdir()
    (source / "knifetip" / "__init__.py").touch()
    for name in ("pyproject.toml", "hatch_build.py"):
        (source / name).write_bytes((BACKEND / name).read_bytes())
    done = run(sys.executable, "-m", "pip", "wheel", "--quiet", "--no-deps", "-w", tmp_path, source)
    assert done.returncode != 0
    if "No matching distribution" in done.stderr:
        pytest.skip("the build backend hatchling can be fetched from no package index")
    assert "make page" in done.stderr


def test_a_wheel_made_from_the_source_distribution_is_the_same(wheel: Path, tmp_path: Path) -> None:
    uv = Path(sys.executable).with_name("uv")
    if not uv.exists():
        pytest.skip("uv, which builds the source distribution here, is not installed")
    done = run(uv, "build", "--quiet", "--sdist", "--out-dir", tmp_path, BACKEND)
    if done.returncode != 0 and "hatchling" in done.stderr:
        pytest.skip(f"uv cannot build: {done.stderr[-300:]}")
    (archive,) = tmp_path.glob("*.tar.gz")
    with tarfile.open(archive) as packed:
        packed.extractall(tmp_path / "source", filter="data")
    (source,) = (tmp_path / "source").iterdir()
    again = build(tmp_path / "again", source)
    with zipfile.ZipFile(wheel) as first, zipfile.ZipFile(again) as second:
        assert sorted(first.namelist()) == sorted(second.namelist())
        for name in first.namelist():
            if not name.endswith("RECORD"):
                assert first.read(name) == second.read(name), name
