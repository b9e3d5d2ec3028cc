"""The list of commands, which is printed without loading what they need."""

from __future__ import annotations

import subprocess
import sys

from knifetip.cli.main import COMMANDS, loaded

_HEAVY = ("ezdxf", "fastapi", "numba", "numpy", "shapely", "sqlalchemy")


def test_the_help_of_every_command_is_the_one_that_the_list_shows() -> None:
    for name, command in COMMANDS.items():
        text = loaded(name).help.replace("\n", " ")
        assert text.startswith(command.help)
        assert text == command.help or text.startswith(f"{command.help} ")


def test_help_imports_nothing_that_takes_long() -> None:
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
