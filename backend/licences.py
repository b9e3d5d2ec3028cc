"""licences: list the packages that knifetip is delivered with, with version and licence.

    python backend/licences.py            writes backend/docs/licences.md
    python backend/licences.py --check    exits with 1 if the page does not match the locks

The packages are those of requirements.lock, those that the optional extras of pyproject.toml add to
them (requirements-extras.lock), and those that the page is made of.  Names and versions come from
the locks, licences from the installed packages and from package-lock.json.
"""

from __future__ import annotations

import json
import re
import sys
from collections.abc import Iterator
from importlib.metadata import PackageNotFoundError, metadata
from pathlib import Path
from typing import NamedTuple

BACKEND = Path(__file__).resolve().parent
PAGE = BACKEND / "docs" / "licences.md"
_PINNED = re.compile(r"^([a-z0-9._-]+)==([^ ;\\]+)", re.M)
#: Licences of packages that are installed on other systems only.
ELSEWHERE = {"colorama": "BSD-3-Clause"}
#: Licences of packages that state them in a file only.
IN_FILE = {"spyrrow": "MIT AND MPL-2.0"}
#: SPDX expressions for the texts of older packages.
SPDX = {
    "3-Clause BSD License": "BSD-3-Clause",
    "BSD": "BSD-3-Clause",
    "BSD License": "BSD-3-Clause",
    "ISC License": "ISC",
    "MIT License": "MIT",
    "PSFL": "PSF-2.0",
}
HEAD = """# Licences of the packages in knifetip

knifetip itself is under the Apache License 2.0. `make licences` writes this page from the locks; a test compares them.

**psycopg and fpdf2 are under the LGPL 3.0.** They are the driver of PostgreSQL and the writer of job tickets, and the only copyleft
libraries of the server. knifetip imports them as unchanged, separate packages, which the LGPL permits for programs under any licence.
What that means:

- Who *uses* knifetip, also inside a company or as a service for others, has no duty.
- Who *passes on* knifetip with them, for example a container image, passes on their licence text and where their source is
  (<https://github.com/psycopg/psycopg>, <https://github.com/py-pdf/fpdf2>), and permits the receiver to replace them by changed
  versions. In an image that is `pip install` over the packages in `/opt/knifetip`.
- Changes of these packages themselves, if passed on, are under the LGPL. The code of knifetip is not affected.

certifi and jagua-rs, a part of spyrrow, are under the MPL 2.0, which requires the same for changes of their files only. The font Inter is
under the OFL 1.1: it must not be sold by itself. The same holds for the fonts DejaVu in job tickets, whose licence is beside them
(`knifetip/handover/fonts`).

The container image contains the packages of the server, of the extras and of the page. Its base image (Debian and
Python) has licences of its own.
"""  # noqa: E501  # paragraphs of Markdown


class Package(NamedTuple):
    """A package with its version and its licence as an SPDX expression."""

    name: str
    version: str
    licence: str


def pinned(lock: str) -> list[tuple[str, str]]:
    """Return names and versions in a lock of the folder backend."""
    return _PINNED.findall((BACKEND / lock).read_text("utf-8"))


def licence_of(name: str) -> str:
    """Return the licence of an installed Python package as an SPDX expression; "" if unknown."""
    try:
        facts = metadata(name)
    except PackageNotFoundError:
        return ELSEWHERE.get(name, "")
    stated = facts.get("License-Expression") or facts.get("License") or ""
    if not stated or "\n" in stated:
        classifiers = facts.get_all("Classifier") or []
        found = [one for one in classifiers if one.startswith("License :: ")]
        stated = found[0].rpartition(" :: ")[2] if found else ""
    return SPDX.get(stated, stated) or IN_FILE.get(name, "")


def server_packages() -> list[tuple[str, str]]:
    """Return names and versions of the packages of the server."""
    return pinned("requirements.lock")


def extra_packages() -> list[tuple[str, str]]:
    """Return names and versions of the packages that the optional extras add to the server."""
    server = set(server_packages())
    return [one for one in pinned("requirements-extras.lock") if one not in server]


def page_packages() -> Iterator[Package]:
    """Yield the packages that the page is made of, without those that only build it."""
    lock = json.loads((BACKEND.parent / "frontend" / "package-lock.json").read_text("utf-8"))
    for place, facts in sorted(lock["packages"].items()):
        if place and not facts.get("dev"):
            name = place.rpartition("node_modules/")[2]
            yield Package(name, facts["version"], facts.get("license", ""))


def _table(title: str, packages: list[Package]) -> str:
    rows = "".join(f"| {one.name} | {one.version} | {one.licence} |\n" for one in packages)
    return f"\n## {title}\n\n| package | version | licence |\n|---|---|---|\n{rows}"


def render() -> str:
    """Return the page.

    Raises
    ------
    SystemExit
        The licence of a package is not known here.
    """
    server = [Package(*one, licence_of(one[0])) for one in server_packages()]
    extras = [Package(*one, licence_of(one[0])) for one in extra_packages()]
    page = list(page_packages())
    if unknown := [one.name for one in (*server, *extras, *page) if not one.licence]:
        sys.exit(f"No licence is stated for {', '.join(unknown)}. Run make dev, or add it here.")
    return (
        HEAD
        + _table("Server", server)
        + _table("Optional extras (oidc, s3, telemetry)", extras)
        + _table("Page", page)
    )


def main() -> int:
    """Write the page, or compare it with the locks; return the exit code."""
    text = render()
    if "--check" not in sys.argv[1:]:
        PAGE.write_text(text, "utf-8")
        return 0
    if PAGE.is_file() and PAGE.read_text("utf-8") == text:
        return 0
    print(f"{PAGE} does not match the locks. Run: make licences", file=sys.stderr)
    return 1


if __name__ == "__main__":
    sys.exit(main())
