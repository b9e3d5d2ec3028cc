"""The list of commands, which is printed without importing their modules."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from knifetip.cli.main import COMMANDS, load_command
from knifetip.dxf.samples import samples

_SERVICE = ("alembic", "dbos", "fastapi", "httpx", "psycopg", "sqlalchemy", "uvicorn")
_READERS = ("cssselect2", "ezdxf", "pypdf", "tinycss2")
#: Implementations that numba imports when it prepares to compile.
_COMPILER = ("numba.cpython.printimpl", "numba.misc.cffiimpl", "numba.np.arrayobj")


def _loaded(*arguments: object, modules: tuple[str, ...]) -> tuple[str, list[str]]:
    """Run a command in its own process; return its output and those of ``modules`` that it
    imports.
    """
    program = (
        "import sys\n"
        "from knifetip.cli.main import app\n"
        "code = app(sys.argv[1:], standalone_mode=False)\n"
        "assert not code, code\n"
        f"print('loaded:', *(name for name in {modules!r} if name in sys.modules))"
    )
    done = subprocess.run(
        [sys.executable, "-c", program, *map(str, arguments)], capture_output=True, text=True
    )
    assert done.returncode == 0, done.stderr
    text, _, loaded = done.stdout.rpartition("loaded:")
    return text, loaded.split()


def test_the_list_shows_the_first_sentence_of_every_help_text() -> None:
    for name, command in COMMANDS.items():
        text = load_command(name).help.replace("\n", " ")
        assert text.startswith(command.help)
        assert text == command.help or text.startswith(f"{command.help} ")


def test_help_does_not_import_slow_modules() -> None:
    text, loaded = _loaded("--help", modules=(*_SERVICE, *_READERS, "numba", "numpy", "rich"))
    assert "classify" in text
    assert loaded == []


@pytest.mark.parametrize("command", ["classify", "program"])
def test_commands_on_a_drawing_import_no_other_reader_and_no_compiler(
    command: str, tmp_path: Path
) -> None:
    drawing = tmp_path / "carton.dxf"
    drawing.write_bytes(samples()["tuck-end-carton.dxf"])
    arguments: list[object] = [command, drawing]
    if command == "program":
        arguments += ["--machine", "demo-table", "--board", "fbb-0.4", "-o", tmp_path / "o.ngc"]
    never = (*_SERVICE, *_READERS, "rich", "shapely")
    _loaded(*arguments, modules=never)  # compiles kernels that are not in the cache
    _, loaded = _loaded(*arguments, modules=(*never, *_COMPILER))
    assert loaded == []


@pytest.mark.parametrize("command", [name for name, one in COMMANDS.items() if one.reads_file])
def test_a_missing_file_is_reported_before_the_stages_are_imported(
    command: str, tmp_path: Path
) -> None:
    program = (
        "import sys\n"
        "from knifetip.cli.main import main\n"
        "try:\n"
        "    main()\n"
        "except SystemExit as left:\n"
        "    print(left.code, 'numba' in sys.modules)"
    )
    words = [command, str(tmp_path / "nothing.dxf")]
    done = subprocess.run(
        [sys.executable, "-c", program, *words], capture_output=True, text=True, check=True
    )
    assert done.stdout.split() == ["3", "False"]
    assert "nothing.dxf cannot be read: No such file" in done.stderr
