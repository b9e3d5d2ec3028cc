"""The list of commands, which is printed without importing their modules."""

from __future__ import annotations

import subprocess
import sys

from knifetip.cli.main import COMMANDS, load_command

_HEAVY = ("ezdxf", "fastapi", "numba", "numpy", "shapely", "sqlalchemy")


def test_the_list_shows_the_first_sentence_of_every_help_text() -> None:
    for name, command in COMMANDS.items():
        text = load_command(name).help.replace("\n", " ")
        assert text.startswith(command.help)
        assert text == command.help or text.startswith(f"{command.help} ")


def test_help_does_not_import_slow_modules() -> None:
    program = (
        "import sys\n"
        "from knifetip.cli.main import app\n"
        "app(['--help'], standalone_mode=False)\n"
        f"print('loaded:', *(name for name in {_HEAVY!r} if name in sys.modules))"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert "classify" in done.stdout
    assert done.stdout.splitlines()[-1].split() == ["loaded:"]
