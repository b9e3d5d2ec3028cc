"""Converters of files for tests: the installed Ghostscript, and scripts in place of others."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

from knifetip.formats.conversion import GHOSTSCRIPT, Converter

#: Mark of tests that need Ghostscript.
needs_ghostscript = pytest.mark.skipif(
    GHOSTSCRIPT.find() is None, reason="Ghostscript (gs) is not installed"
)


def install_fake(
    monkeypatch: pytest.MonkeyPatch, folder: Path, converter: Converter, body: str
) -> Path:
    """Write a Python script that knifetip runs in place of a converter; return its path.

    Parameters
    ----------
    folder
        Folder of the script.
    body
        What the script does; ``sys`` and ``os`` are imported.  Before that, it prints the version
        99.1 if that is asked.
    """
    script = folder / converter.program
    script.write_text(
        f"#!{sys.executable} -I\n"
        "import os, sys\n"
        "if '--version' in sys.argv:\n"
        "    print('fake 99.1')\n"
        "    sys.exit(0)\n" + body,
        encoding="utf-8",
    )
    script.chmod(0o755)
    monkeypatch.setenv(converter.variable, str(script))
    return script
