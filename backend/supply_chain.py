"""supply_chain: list the components of knifetip, and request their known vulnerabilities.

    python backend/supply_chain.py sbom     build/sbom/server.cdx.json and page.cdx.json (CycloneDX)
    python backend/supply_chain.py audit    exits with 0: none known; 1: found; 3: not all answered

The audit queries the advisory services of PyPI and npm, which a closed network may not reach.  No
answer of a service, or no data about a package, is not a clean result.
"""

from __future__ import annotations

import json
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from enum import IntEnum
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[1]
LOCK = ROOT / "backend" / "requirements-extras.lock"
SBOM = ROOT / "build" / "sbom"
_NPM = (sys.executable, str(ROOT / "frontend" / "build.py"), "npm")
#: A package that every advisory service must contain.
_PROBE = "pip==26.0"


class Status(IntEnum):
    """Result of an audit, which is also the exit code."""

    CLEAN = 0
    VULNERABLE = 1
    UNREACHED = 3


def _run(words: Sequence[str]) -> subprocess.CompletedProcess[str]:
    return subprocess.run(words, cwd=ROOT, capture_output=True, text=True, check=False)


def _tool(name: str) -> str:
    return str(Path(sys.executable).with_name(name))


def write_sbom() -> int:
    """Write the lists of components of the server and of the page; return the exit code."""
    SBOM.mkdir(parents=True, exist_ok=True)
    server = [
        *(_tool("cyclonedx-py"), "requirements", str(LOCK), "--pyproject"),
        *(str(ROOT / "backend" / "pyproject.toml"), "--output-reproducible"),
        *("--output-format", "JSON", "--output-file", str(SBOM / "server.cdx.json")),
    ]
    page = [*_NPM, "sbom", "--sbom-format", "cyclonedx", "--package-lock-only", "--omit", "dev"]
    done = _run(server)
    if done.returncode:
        print(done.stderr, file=sys.stderr)
        return done.returncode
    done = _run(page)
    if done.returncode:
        print(done.stderr, file=sys.stderr)
        return done.returncode
    (SBOM / "page.cdx.json").write_text(done.stdout, "utf-8")
    for file in sorted(SBOM.glob("*.cdx.json")):
        count = len(json.loads(file.read_text("utf-8"))["components"])
        print(f"{file.relative_to(ROOT)}: {count} components")
    return 0


def python_status(output: str) -> tuple[Status, list[str]]:
    """Return the result that the JSON output of pip-audit states, and lines about it."""
    try:
        packages = json.loads(output)["dependencies"]
    except (ValueError, KeyError, TypeError):
        return Status.UNREACHED, ["pip-audit gave no result"]
    found = [
        f"{one['name']} {one['version']}: {', '.join(known['id'] for known in one['vulns'])}"
        for one in packages
        if one.get("vulns")
    ]
    skipped = [f"{one['name']}: {one['skip_reason']}" for one in packages if "skip_reason" in one]
    if found:
        return Status.VULNERABLE, found
    if skipped or not packages:
        return Status.UNREACHED, skipped or ["pip-audit looked at no package"]
    return Status.CLEAN, [f"{len(packages)} packages, no known vulnerability"]


def page_status(output: str) -> tuple[Status, list[str]]:
    """Return the result that the JSON output of npm audit states, and lines about it."""
    try:
        report: dict[str, Any] = json.loads(output)
        known = report["vulnerabilities"]
        total = report["metadata"]["dependencies"]["prod"]
    except (ValueError, KeyError, TypeError):
        return Status.UNREACHED, ["npm audit gave no result"]
    if known:
        return Status.VULNERABLE, [f"{name}: {one['severity']}" for name, one in known.items()]
    return Status.CLEAN, [f"{total} packages, no known vulnerability"]


def _audit_python(lock: Path) -> tuple[Status, list[str]]:
    words = [_tool("pip-audit"), "--requirement", str(lock), "--disable-pip", "--no-deps"]
    done = _run([*words, "--format", "json", "--progress-spinner", "off"])
    status, lines = python_status(done.stdout)
    if not done.stdout.strip():
        lines += done.stderr.strip().splitlines()[-1:]
    return status, lines


def audit_server() -> tuple[Status, list[str]]:
    """Request the vulnerabilities of the packages of the server, after a check with one package."""
    with tempfile.TemporaryDirectory() as folder:
        probe = Path(folder) / "probe.txt"
        probe.write_text(_PROBE + "\n")
        status, lines = _audit_python(probe)
    return (status, lines) if status is Status.UNREACHED else _audit_python(LOCK)


def audit_page() -> tuple[Status, list[str]]:
    """Request the vulnerabilities of the packages of the page."""
    done = _run([*_NPM, "audit", "--json", "--package-lock-only", "--omit", "dev"])
    status, lines = page_status(done.stdout)
    if status is Status.UNREACHED:
        lines += [line for line in done.stderr.splitlines() if line.startswith("npm error")][:2]
    return status, lines


def audit() -> int:
    """Request the vulnerabilities and print the results; return the exit code."""
    results = {"server": audit_server(), "page": audit_page()}
    for part, (status, lines) in results.items():
        if status is Status.UNREACHED:
            print(f"{part}: NOT AUDITED, the advisory data could not be reached")
        for line in lines:
            print(f"{part}: {line[:300]}")
    found = [status for status, _ in results.values()]
    return Status.VULNERABLE if Status.VULNERABLE in found else max(found)


def main() -> int:
    """Execute the command of the command line; return the exit code."""
    commands = {"sbom": write_sbom, "audit": audit}
    if len(sys.argv) != 2 or sys.argv[1] not in commands:
        print((__doc__ or "").strip(), file=sys.stderr)
        return 2
    return int(commands[sys.argv[1]]())


if __name__ == "__main__":
    sys.exit(main())
