"""backend/install.py: uv gets the configuration of pip, and pip installs if uv fails."""

from __future__ import annotations

import importlib.util
import subprocess
import sys
from pathlib import Path
from types import ModuleType

import pytest

ROOT = Path(__file__).resolve().parents[3]


#: The commands that were run, and words in commands that must fail.
Commands = tuple[list[list[str]], set[str]]


@pytest.fixture
def install() -> ModuleType:
    spec = importlib.util.spec_from_file_location("install", ROOT / "backend" / "install.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture
def commands(install: ModuleType, monkeypatch: pytest.MonkeyPatch) -> Commands:
    """Record the commands; those that contain a word in ``failing`` exit with 1."""
    failing: set[str] = set()
    calls: list[list[str]] = []

    def run(command: list[str], **_options: object) -> subprocess.CompletedProcess[str]:
        calls.append([str(word) for word in command])
        return subprocess.CompletedProcess(command, int(not failing.isdisjoint(command)), "", "")

    monkeypatch.setattr(install.subprocess, "run", run)
    monkeypatch.setattr(sys, "argv", ["install.py", "-r", "some.lock"])
    return calls, failing


def test_the_environment_overrides_the_section_install_overrides_the_section_global(
    install: ModuleType,
) -> None:
    listing = (
        ":env:.find-links='/env'\n"
        "install.index-url='https://install/simple'\n"
        "global.find-links='/file'\n"
        "global.index-url='https://global/simple'\n"
        "freeze.timeout='10'\n"
    )
    assert install.pip_options(listing) == {
        "find-links": "/env",
        "index-url": "https://install/simple",
    }


def test_every_index_of_pip_is_handed_on_in_the_separator_of_its_variable(
    install: ModuleType,
) -> None:
    options = {
        "index-url": "https://a/simple",
        "extra-index-url": "https://b/simple\nfile:///c/simple",
        "find-links": "/wheels /more",
        "cert": "/ca.pem",
        "no-color": "true",
    }
    assert install.uv_environment(options, {}) == {
        "UV_INDEX_STRATEGY": "unsafe-best-match",
        "UV_COMPILE_BYTECODE": "1",
        "UV_DEFAULT_INDEX": "https://a/simple",
        "UV_INDEX": "https://b/simple file:///c/simple",
        "UV_FIND_LINKS": "/wheels,/more",
        "SSL_CERT_FILE": "/ca.pem",
    }


def test_a_variable_that_is_set_stays(install: ModuleType) -> None:
    found = install.uv_environment({"index-url": "https://a"}, {"UV_DEFAULT_INDEX": "https://mine"})
    assert found["UV_DEFAULT_INDEX"] == "https://mine"


def test_pip_is_not_asked_where_uv_installs(install: ModuleType, commands: Commands) -> None:
    calls, _ = commands
    assert install.main() == 0
    assert calls[-1][1:5] == ["-m", "uv", "pip", "install"]
    assert calls[-1][-2:] == ["-r", "some.lock"]


def test_pip_installs_where_uv_fails(install: ModuleType, commands: Commands) -> None:
    calls, failing = commands
    failing.add("uv")
    assert install.main() == 0
    assert calls[-1][1:4] == ["-m", "pip", "install"]
    assert calls[-1][-2:] == ["-r", "some.lock"]


def test_pip_installs_where_uv_cannot_be_fetched(
    install: ModuleType, commands: Commands, monkeypatch: pytest.MonkeyPatch
) -> None:
    calls, failing = commands
    monkeypatch.setattr(install.importlib.util, "find_spec", lambda _name: None)
    failing.add(str(install.UV_LOCK))
    assert install.main() == 0
    assert not any("uv" in call for call in calls)
    assert calls[-1][-2:] == ["-r", "some.lock"]


def test_the_exit_code_is_that_of_pip_where_both_fail(
    install: ModuleType, commands: Commands
) -> None:
    _, failing = commands
    failing.add("some.lock")
    assert install.main() == 1


def test_the_lock_of_uv_pins_the_uv_of_the_development_lock(install: ModuleType) -> None:
    first = install.UV_LOCK.read_text().split(" ")[0]
    assert first.startswith("uv==")
    assert f"\n{first} " in (ROOT / "backend" / "requirements-dev.lock").read_text()
