"""client: generate the typed Python client of the REST API and pack it as a wheel.

    python backend/client.py          build/client/knifetip_client-VERSION-py3-none-any.whl

The generator openapi-python-client and the server need different versions of typer, so it runs in
an environment of its own, build/client/env, which `requirements-client.lock` pins by hash.  The
environment is made once for each lock.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
LOCK = ROOT / "backend" / "requirements-client.lock"
BUILD = ROOT / "build" / "client"
_UV = str(Path(sys.executable).with_name("uv"))
_SETTINGS = {
    "project_name_override": "knifetip-client",
    "package_name_override": "knifetip_client",
    # The generator supports neither format; both are text.
    "content_type_overrides": {"application/toml": "text/plain", "image/svg+xml": "text/plain"},
}


def environment(build: Path = BUILD) -> Path:
    """Return the Python of the environment of the generator, which is made if it is not current.

    Parameters
    ----------
    build
        Folder in which the environment is.

    Raises
    ------
    subprocess.CalledProcessError
        The packages cannot be installed, as without a network.
    """
    python = build / "env" / "bin" / "python"
    stamp = build / "env" / "lock"
    if not stamp.exists() or stamp.read_bytes() != LOCK.read_bytes():
        _run(_UV, "venv", "--quiet", "--clear", "--python", sys.executable, build / "env")
        install = (_UV, "pip", "install", "--quiet", "--python", python, "--require-hashes")
        _run(*install, "-r", LOCK)
        stamp.write_bytes(LOCK.read_bytes())
    return python


def generate(python: Path, build: Path = BUILD) -> Path:
    """Generate the package of the client, and return its folder, which contains ``setup.py``.

    Parameters
    ----------
    python
        Python of the environment of the generator.
    build
        Folder for the package.
    """
    from knifetip.server.app import create_app  # imported here: takes a second

    build.mkdir(parents=True, exist_ok=True)
    description, settings = build / "openapi.json", build / "settings.json"
    described = create_app().openapi()
    description.write_text(json.dumps(described))
    settings.write_text(json.dumps(_SETTINGS))
    package = build / "package"
    _run(
        *(python, "-m", "openapi_python_client", "generate", "--overwrite", "--meta", "setup"),
        *("--path", description, "--config", settings, "--output-path", package),
    )
    return package


def build_wheel(python: Path, package: Path, build: Path = BUILD) -> Path:
    """Pack the client as a wheel and return the path of the wheel."""
    for old in build.glob("*.whl"):
        old.unlink()
    options = ("--quiet", "--wheel", "--no-build-isolation", "--python", python)
    _run(_UV, "build", *options, "--out-dir", build, package)
    (wheel,) = build.glob("*.whl")
    return wheel


def _run(*words: object) -> None:
    # The generator formats its output with ruff, which is in its environment.
    path = os.pathsep.join((str(Path(str(words[0])).parent), os.environ.get("PATH", os.defpath)))
    subprocess.run(
        [str(word) for word in words],
        check=True,
        stdout=subprocess.DEVNULL,
        env={**os.environ, "PATH": path},
    )


def main() -> None:
    """Build the wheel and print its path."""
    python = environment()
    print(build_wheel(python, generate(python)).relative_to(ROOT))


if __name__ == "__main__":
    main()
