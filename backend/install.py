"""install: `pip install`, carried out by uv where it can be had, in a fraction of the time.

    python backend/install.py --require-hashes -r backend/requirements.lock

Installs into the environment of the Python that runs it. uv itself is fetched by pip, pinned by
hash. uv does not read the configuration of pip, so its indexes, links, certificates and proxy are
handed on; variables ``UV_*`` that are set already take precedence. Where uv cannot be fetched, or
fails, pip installs.
"""

from __future__ import annotations

import ast
import importlib.util
import os
import re
import subprocess
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path

UV_LOCK = Path(__file__).with_name("requirements-uv.lock")
PIP = (sys.executable, "-m", "pip")
INSTALL = ("install", "--disable-pip-version-check", "--quiet")
#: Sections of pip's configuration; the later one takes precedence.
SECTIONS = ("global", "install", ":env:")
#: Option of pip: variable of uv, and what separates several values there.
VARIABLES: Mapping[str, tuple[str, str]] = {
    "index-url": ("UV_DEFAULT_INDEX", " "),
    "extra-index-url": ("UV_INDEX", " "),
    "find-links": ("UV_FIND_LINKS", ","),
    "trusted-host": ("UV_INSECURE_HOST", " "),
    "cert": ("SSL_CERT_FILE", " "),
    "client-cert": ("SSL_CLIENT_CERT", " "),
    "proxy": ("ALL_PROXY", " "),
    "timeout": ("UV_HTTP_TIMEOUT", " "),
    "default-timeout": ("UV_HTTP_TIMEOUT", " "),
}


def pip_options(listing: str) -> dict[str, str]:
    """Return the options that hold for `pip install`, from the output of `pip config list`."""
    found: dict[tuple[str, str], str] = {}
    for line in listing.splitlines():
        match = re.fullmatch(r"(global|install|:env:)\.([a-z-]+)=(.*)", line.strip())
        if match is not None:
            found[match[1], match[2]] = str(ast.literal_eval(match[3]))
    return {key: found[section, key] for section in SECTIONS for at, key in found if at == section}


def uv_environment(options: Mapping[str, str], environment: Mapping[str, str]) -> dict[str, str]:
    """Return the environment in which uv uses the same sources as pip with these options."""
    handed_on = {
        variable: separator.join(options[option].split())
        for option, (variable, separator) in VARIABLES.items()
        if option in options
    }
    # pip takes a package from whichever index has it. The hashes are the safeguard.
    # uv, unlike pip, compiles bytecode only on request; otherwise the first start does it.
    defaults = {"UV_INDEX_STRATEGY": "unsafe-best-match", "UV_COMPILE_BYTECODE": "1"}
    return {**defaults, **handed_on, **environment}


def fetch_uv() -> bool:
    """Return whether uv is installed, after an attempt to install it."""
    if importlib.util.find_spec("uv") is not None:
        return True
    fetch = [*PIP, *INSTALL, "--require-hashes", "-r", str(UV_LOCK)]
    return subprocess.run(fetch, check=False).returncode == 0


def install_with_uv(arguments: Sequence[str]) -> bool:
    """Return whether uv has installed what the arguments of `pip install` name."""
    if not fetch_uv():
        return False
    listing = subprocess.run([*PIP, "config", "list"], capture_output=True, text=True, check=False)
    options = pip_options(listing.stdout)
    # The one option that uv takes from no variable.
    offline = ["--no-index"] if options.get("no-index", "").lower() in ("1", "true", "yes") else []
    uv = [sys.executable, "-m", "uv", "pip", "install", "--quiet", "--python", sys.executable]
    environment = uv_environment(options, os.environ)
    return subprocess.run([*uv, *offline, *arguments], env=environment, check=False).returncode == 0


def main() -> int:
    """Install what the command line names; return the exit code."""
    arguments = sys.argv[1:]
    if install_with_uv(arguments):
        return 0
    print("uv did not install it; pip does.", file=sys.stderr, flush=True)
    return subprocess.run([*PIP, *INSTALL, *arguments], check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
