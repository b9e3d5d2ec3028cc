"""Programs that convert files are optional, limited, and their faults are stated."""

from __future__ import annotations

import os
import shutil
import signal
import sys
import tempfile
import time
from contextlib import suppress
from pathlib import Path

import pytest

from knifetip import pipeline
from knifetip.errors import DrawingTooLarge, NotADrawing, ReadError
from knifetip.formats import cpu_limit
from knifetip.formats.conversion import GHOSTSCRIPT, LIBREDWG, Converter
from knifetip.formats.conversion.child_process import Budget, run_limited
from knifetip.messages import Message
from knifetip.presentation.import_warnings import import_warnings
from tests.support.converters import install_fake
from tests.support.writers.dxf_text import dxf, line

DWG = b"AC1032" + bytes(100)
EPS = b"%!PS-Adobe-3.0 EPSF-3.0\nshowpage\n%%EOF\n"
RESULT = dxf(line(0, 0, 30, 40))
#: Writes the result of a conversion.
WRITE = f"open('drawing.dxf', 'wb').write({RESULT!r})\n"


def refusal(data: bytes) -> ReadError:
    """Return the error with which a file is refused."""
    with pytest.raises(ReadError) as caught:
        pipeline.read(data)
    return caught.value


@pytest.mark.parametrize(
    ("data", "converter", "instead"),
    [
        (EPS, GHOSTSCRIPT, "choose File > Save As > PDF"),
        (DWG, LIBREDWG, "choose File > Save As, and DXF"),
    ],
)
def test_without_the_program_a_file_is_refused_with_both_remedies(
    monkeypatch: pytest.MonkeyPatch, data: bytes, converter: Converter, instead: str
) -> None:
    monkeypatch.setenv(converter.variable, "off")
    error = refusal(data)
    assert isinstance(error, NotADrawing)
    assert error.message.code == "conversion.no-program"
    assert f"only if the program {converter.title} is installed" in error.text
    assert instead in error.hint
    assert f"install {converter.title} (command {converter.program})" in error.hint
    assert "DXF, CF2, SVG, PDF, HPGL or LightBurn" in error.hint


def test_a_program_is_found_on_the_path_and_by_its_variable(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    script = install_fake(monkeypatch, tmp_path, LIBREDWG, "")
    found = LIBREDWG.find()
    assert found is not None
    assert (found.path, found.version) == (str(script), "99.1")
    monkeypatch.delenv(LIBREDWG.variable)
    monkeypatch.setenv("PATH", str(tmp_path))
    assert LIBREDWG.find() == found
    monkeypatch.setenv("PATH", os.devnull)
    assert LIBREDWG.find() is None


def test_an_old_version_whose_sandbox_is_weak_is_not_used(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    script = install_fake(monkeypatch, tmp_path, GHOSTSCRIPT, "")
    script.write_text(script.read_text(encoding="utf-8").replace("99.1", "9.53.3"))
    assert GHOSTSCRIPT.find() is None
    newer = install_fake(monkeypatch, tmp_path / "..", GHOSTSCRIPT, "")
    newer.write_text(newer.read_text(encoding="utf-8").replace("99.1", "9.54.0"))
    assert GHOSTSCRIPT.find() is not None


def test_a_converted_file_is_read_and_the_report_names_the_program(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    check = "assert open('drawing.dwg', 'rb').read()[:6] == b'AC1032'\n"
    install_fake(monkeypatch, tmp_path, LIBREDWG, check + WRITE)
    drawing = pipeline.read(DWG, "mm")
    assert drawing.lengths.tolist() == [50.0]
    assert list(drawing.import_report.kind) == ["LINE", "file"]
    assert drawing.import_report.reason[1] == Message("import.converted", program="LibreDWG 99.1")
    assert drawing.handles == [drawing.import_report.handle[0]]
    assert import_warnings(drawing) == []


def test_what_the_program_could_not_convert_is_a_warning(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    log = (
        "Warning: Unstable Class entity 504 HELIX (0x481) 42/0\n"
        "Warning: Unhandled Class entity 518 ACAD_TABLE (0x401) 259/0\n"
        "Warning: Unstable Class object 505 MATERIAL (0x481) 45/0\n"
        "ERROR: Invalid REGION.wires x\n"
    )
    install_fake(monkeypatch, tmp_path, LIBREDWG, f"sys.stderr.write({log!r})\n" + WRITE)
    (warning,) = import_warnings(pipeline.read(DWG, "mm"))
    assert warning.code == "import.conversion-doubtful"
    assert warning.arguments["count"] == 3
    assert warning.arguments["losses"] == ("HELIX", "ACAD_TABLE", "Invalid REGION.wires x")


@pytest.mark.parametrize(
    ("body", "code", "words"),
    [
        ("print('ERROR: Invalid CRC'); sys.exit(1)", "conversion.failed", "'Invalid CRC'"),
        ("sys.exit(3)", "conversion.failed", "'3'"),
        ("os.kill(os.getpid(), 11)", "conversion.failed", "'SIGSEGV'"),
        ("pass", "conversion.no-result", "found no drawing"),
        ("open('drawing.dxf', 'w').close()", "conversion.no-result", "found no drawing"),
        ("open('drawing.dxf', 'wb').write(b'999')", "conversion.result-unreadable", "DXF"),
        ("print('Out of memory'); sys.exit(1)", "conversion.too-much-memory", "954 MB"),
    ],
)
def test_a_fault_of_the_program_is_a_refusal_that_says_what_to_export(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, body: str, code: str, words: str
) -> None:
    install_fake(monkeypatch, tmp_path, LIBREDWG, body)
    error = refusal(DWG)
    assert error.message.code == code
    assert "a DWG drawing" in error.text
    assert words in error.text
    assert "choose File > Save As, and DXF" in error.hint


def test_a_result_without_any_object_is_refused(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    body = f"open('drawing.dxf', 'wb').write({dxf()!r})"
    install_fake(monkeypatch, tmp_path, LIBREDWG, body)
    assert refusal(DWG).message.code == "conversion.no-result"


def run(
    folder: Path, body: str, *, seconds: float = 30.0, cpu: float = 20.0
) -> tuple[int, str, str, float]:
    """Run Python code within small limits; return status, limit, log and processor time."""
    script = folder / "program"
    script.write_text(f"#!{sys.executable} -I\nimport os, sys\n{body}\n", encoding="utf-8")
    script.chmod(0o755)
    budget = Budget(cpu, seconds, memory=256 << 20, file_size=1 << 20, disk=3 << 20)
    finished = run_limited([str(script)], folder, budget)
    return finished.status, finished.exceeded, finished.log, finished.cpu


def test_processor_time_is_limited(tmp_path: Path) -> None:
    status, _, _, cpu = run(tmp_path, "while True: pass", cpu=1.0)
    assert status == -signal.SIGXCPU
    assert 0.5 < cpu < 2.5


def test_time_on_the_clock_is_limited(tmp_path: Path) -> None:
    status, exceeded, _, cpu = run(tmp_path, "import time; time.sleep(60)", seconds=0.3)
    assert (status, exceeded) == (-signal.SIGKILL, "time")
    assert cpu < 0.3


def test_children_of_the_program_are_ended_with_it(tmp_path: Path) -> None:
    body = (
        "import time\nif os.fork() == 0: time.sleep(60)\nopen('pid', 'w').write(str(os.getpid()))"
    )
    run(tmp_path, body)
    group = int((tmp_path / "pid").read_text())
    # They end a moment after the signal, and then wait for init to reap them.
    until = time.monotonic() + 60.0
    while _states(group) - {"Z", "X"}:
        assert time.monotonic() < until
        time.sleep(0.01)


def _states(group: int) -> set[str]:
    """Return the states of the processes of a group."""
    found = set()
    for file in Path("/proc").glob("[0-9]*/stat"):
        with suppress(OSError):
            state, _, its_group, *_ = file.read_text().rpartition(")")[2].split()
            if its_group == str(group):
                found.add(state)
    return found


def test_memory_is_limited(tmp_path: Path) -> None:
    status, _, log, _ = run(tmp_path, "bytearray(512 << 20)")
    assert status == 1
    assert "MemoryError" in log


def test_the_size_of_a_file_and_of_all_files_is_limited(tmp_path: Path) -> None:
    endless = "import signal; signal.signal(signal.SIGXFSZ, signal.SIG_DFL)\n"
    status, *_ = run(tmp_path, endless + "print('x' * (2 << 20), flush=True)")
    assert status == -signal.SIGXFSZ
    many = "import itertools\nfor k in itertools.count(): open(f'f{k}', 'wb').write(bytes(1 << 19))"
    status, exceeded, *_ = run(tmp_path, many)
    assert (status, exceeded) == (-signal.SIGKILL, "disk")


def test_the_program_has_no_input_and_few_variables(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setenv("GS_OPTIONS", "-dNOSAFER")
    body = "print(repr(sys.stdin.read()), *sorted(os.environ), os.environ['TMPDIR'], os.getcwd())"
    _, _, log, _ = run(tmp_path, body)
    words = log.split()
    assert words[0] == "''"
    assert words[-2:] == [str(tmp_path), str(tmp_path)]
    known = {"HOME", "LC_ALL", "PATH", "TEMP", "TMP", "TMPDIR", "LD_LIBRARY_PATH"}
    assert set(words[1:-2]) - known - {"LC_CTYPE"} == set()


def test_the_folder_of_a_conversion_is_removed(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    programs = tmp_path / "bin"
    programs.mkdir()
    for body in (WRITE, "sys.exit(1)"):
        install_fake(monkeypatch, programs, LIBREDWG, body)
        if body == WRITE:
            pipeline.read(DWG, "mm")
        else:
            refusal(DWG)
        assert list(tmp_path.iterdir()) == [programs]


def test_the_folder_is_removed_although_the_time_of_the_reading_ends_meanwhile(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    folders = tmp_path / "folders"
    folders.mkdir()
    monkeypatch.setattr(tempfile, "tempdir", str(folders))
    install_fake(monkeypatch, tmp_path, LIBREDWG, WRITE)
    pipeline.read(DWG, "mm")  # modules are imported
    remove = shutil.rmtree

    def remove_slowly(folder: Path, *, ignore_errors: bool) -> None:
        end = time.process_time() + 4.0
        while time.process_time() < end:
            pass
        remove(folder, ignore_errors=ignore_errors)

    monkeypatch.setattr(shutil, "rmtree", remove_slowly)
    with cpu_limit.limit_cpu(2.0):
        pipeline.read(DWG, "mm")
    assert list(folders.iterdir()) == []


def test_processor_time_of_a_conversion_counts_as_time_of_the_reading(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    burn = "import time\nwhile time.process_time() < 0.5: pass\n"
    install_fake(monkeypatch, tmp_path, LIBREDWG, burn + WRITE)
    assert cpu_limit.remaining() == cpu_limit.READING
    with cpu_limit.limit_cpu(10.0):
        pipeline.read(DWG, "mm")
        assert cpu_limit.remaining() < 9.7
    install_fake(monkeypatch, tmp_path, LIBREDWG, "while True: pass")
    with cpu_limit.limit_cpu(1.0), pytest.raises(DrawingTooLarge) as caught:
        pipeline.read(DWG, "mm")
    assert caught.value.message.code in ("conversion.too-slow", "reading.too-slow")


def test_a_file_is_converted_once_although_its_unit_is_chosen(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    count = tmp_path / "count"
    install_fake(monkeypatch, tmp_path, LIBREDWG, f"open({str(count)!r}, 'a').write('x')\n" + WRITE)
    pipeline.read(DWG)
    assert count.read_text() == "x"
