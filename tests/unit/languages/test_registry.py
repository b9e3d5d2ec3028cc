"""Controller languages: found by name, here or in another package, and validated with a machine."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

import pytest

from knifetip import pipeline
from knifetip.dxf.samples import samples
from knifetip.errors import ControllerError, LibraryError
from knifetip.languages import registry
from knifetip.languages.registry import find_language, with_language
from knifetip.library import load

PARTS = ("emitter", "reader", "timing")
ROOM = Path(registry.__file__).parent


@pytest.mark.parametrize("name", registry.language_names())
def test_every_component_of_a_language_can_be_imported(name: str) -> None:
    language = find_language(name)
    for part in PARTS:
        assert language.load_part(part) is not None
    if language.driver:
        assert callable(language.load_driver(load.machine("demo-table")))
    else:
        assert language.no_driver


def test_an_unknown_name_is_refused_with_the_known_ones() -> None:
    with pytest.raises(LibraryError) as refusal:
        find_language("GRBL")
    assert "'GRBL'" in refusal.value.text
    assert "grblhal" in refusal.value.hint
    assert "linuxcnc" in refusal.value.hint


def test_a_language_without_a_driver_has_a_hint_instead() -> None:
    language = replace(find_language("hpgl"), driver="")
    with pytest.raises(ControllerError, match=r"HPGL.*Download the program"):
        language.load_driver(load.machine("demo-table"))


def test_a_machine_with_an_unknown_language_is_refused_when_it_is_read(tmp_path: Path) -> None:
    text = (Path(load.__file__).parent / "machines" / "demo-table.toml").read_text("utf-8")
    file = tmp_path / "table.toml"
    file.write_text(text.replace('"grblhal"', '"fanuc"'), "utf-8")
    with pytest.raises(LibraryError, match=r"dialect is fanuc, but must be .*grblhal, .*linuxcnc"):
        load.machine(str(file))


def test_settings_of_a_language_without_settings_are_refused(tmp_path: Path) -> None:
    text = (Path(load.__file__).parent / "machines" / "demo-table.toml").read_text("utf-8")
    file = tmp_path / "table.toml"
    file.write_text(text + "\n[controller]\nbaud = 9600\n", "utf-8")
    with pytest.raises(
        LibraryError, match=r"because grblHAL has no settings.*Remove the section \[contr"
    ):
        load.machine(str(file))


FOREIGN = """
from knifetip.languages.language import Language

LANGUAGE = Language(
    name="{name}",
    title="Elsewhere",
    suffix=".else",
    emitter="elsewhere:emit",
    reader="elsewhere:READER",
    timing="knifetip.sequencing.look_ahead:look_ahead",
)

def emit(toolpath, machine, *, tolerance, notes):
    return machine.dialect
"""


Install = Callable[[str, str], None]


@pytest.fixture
def package(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Install]:
    """Return a function that installs a package which declares a language as an entry point."""

    def install(declared: str, name: str) -> None:
        (tmp_path / "elsewhere.py").write_text(FOREIGN.format(name=name), "utf-8")
        metadata = tmp_path / "elsewhere-1.0.dist-info"
        metadata.mkdir()
        (metadata / "METADATA").write_text("Metadata-Version: 2.1\nName: elsewhere\nVersion: 1.0\n")
        (metadata / "entry_points.txt").write_text(
            f"[{registry.GROUP}]\n{declared} = elsewhere:LANGUAGE\n"
        )
        monkeypatch.syspath_prepend(str(tmp_path))
        registry.find_language.cache_clear()

    yield install
    registry.find_language.cache_clear()
    sys.modules.pop("elsewhere", None)


def test_a_language_of_another_package_is_found_by_its_entry_point(package: Install) -> None:
    package("elsewhere", "elsewhere")
    assert "elsewhere" in registry.language_names()
    machine = with_language(load.machine("demo-table"), "elsewhere")
    emitter = find_language(machine.dialect).load_part("emitter")
    assert emitter(None, machine, tolerance=0.01, notes=()) == "elsewhere"


def test_an_entry_point_with_the_name_of_another_language_is_refused(package: Install) -> None:
    package("elsewhere", "nowhere")
    with pytest.raises(LibraryError, match="but does not provide one"):
        find_language("elsewhere")


def test_the_language_reaches_the_time_estimate() -> None:
    drawing = pipeline.read(samples()["tuck-end-carton.dxf"])
    line = pipeline.classify(drawing, load.profile("default"))
    machine, board = load.machine("demo-table"), load.board("fbb-0.4")
    halting, other = (
        pipeline.compile(drawing, line, machine, board, dialect=name)
        for name in ("linuxcnc", "grblhal")
    )
    own = pipeline.compile(drawing, line, replace(machine, dialect="linuxcnc"), board)
    assert halting.program.text.count(b"G4 P0\n") > other.program.text.count(b"G4 P0\n") + 10
    assert halting.seconds > other.seconds + 0.015 * 10
    assert (halting.seconds, halting.program.text) == (own.seconds, own.program.text)


def test_reading_a_record_does_not_import_its_components() -> None:
    code = (
        "import sys; from knifetip.languages import registry\n"
        f"[registry.find_language(name) for name in {registry.language_names()!r}]\n"
        "rooms = {'knifetip.post', 'knifetip.verification', 'knifetip.gateway', 'numba'}\n"
        "sys.exit(' '.join(rooms & set(sys.modules)) or None)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert (done.returncode, done.stderr) == (0, "")


def test_no_other_package_names_a_language() -> None:
    own = {"languages", "rs274", "hpgl", "grbl", "linuxcnc", "linuxcnc.py"}
    own |= {"mcx314", "mcx314.py"}
    package = ROOM.parent
    for file in package.rglob("*.py"):
        if own & set(file.relative_to(package).parts):
            continue
        text = file.read_text("utf-8")
        for name in registry.language_names():
            assert f'"{name}"' not in text, f"{file} names {name}"
        assert "grbl.driver" not in text, f"{file} names the driver of grblHAL"
