"""Stored readings replace reading the file if they give the same result."""

from __future__ import annotations

import time
from dataclasses import replace

import numpy as np
import pytest

from knifetip import pipeline
from knifetip.dxf.samples import samples
from knifetip.errors import DrawingTooLarge
from knifetip.formats.cpu_limit import limit_cpu
from knifetip.library import load
from knifetip.library.definition import Definition, Shelf
from knifetip.model.cleaned import Cleaned
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.drawing import NO_LINE_WIDTH, Drawing
from knifetip.model.interpretation import NO_OVERRIDE, Interpretation
from knifetip.model.stage import no_progress
from knifetip.presentation.columns import pack_columns, unpack_columns
from knifetip.presentation.edges import EdgeTable
from knifetip.service.processes import readings, tasks
from knifetip.service.processes.readings import StoredDrawing, restore_or_read

CONTENT = samples()["tuck-end-carton.dxf"]


def stored(interpretation: Interpretation) -> StoredDrawing:
    """Return a sample drawing as the store contains it after its upload."""
    handles = None
    if interpretation.overrides:
        handles = pipeline.read(CONTENT, interpretation.unit or None).handles
    reading = tasks.read(no_progress, CONTENT, interpretation, handles)
    kept = replace(interpretation, overrides=reading.overrides)
    return StoredDrawing(CONTENT, reading.edges, kept)


def overrides(stored_drawing: StoredDrawing, **changes: LineType) -> bytes:
    column = np.frombuffer(stored_drawing.interpretation.overrides, np.uint8).copy()
    for row, kind in changes.items():
        column[int(row.removeprefix("row"))] = kind
    return column.tobytes()


def same(one: tuple[Drawing, Dieline], other: tuple[Drawing, Dieline]) -> None:
    columns = ("ends", "bulge", "layer", "colour", "true_colour", "linetype", "lengths")
    for name in (*columns, "fit_error", "line_width"):
        assert (getattr(one[0], name) == getattr(other[0], name)).all()
    for name in ("layers", "linetypes", "handles", "unit"):
        assert getattr(one[0], name) == getattr(other[0], name)
    columns = ("ends", "bulge", "line_type", "source", "confidence", "face", "part")
    for name in (*columns, "fit_error"):
        assert (getattr(one[1], name) == getattr(other[1], name)).all()
    words = [[line.rules[rule] for rule in line.rule] for _, line in (one, other)]
    assert words[0] == words[1]
    assert one[1].alternatives[: len(other[1].alternatives)] == other[1].alternatives


@pytest.fixture
def unread(monkeypatch: pytest.MonkeyPatch) -> None:
    """Fail if a compilation or its questions read the file."""

    def refuse(*_: object) -> None:
        raise AssertionError("the file was read again")

    # ``tasks`` has imported the function under its own name.
    monkeypatch.setattr(readings, "read_drawing", refuse)


def from_file(target: Interpretation) -> tuple[Drawing, Dieline]:
    drawing = pipeline.read(CONTENT, target.unit or None)
    return drawing, pipeline.interpret(drawing, target)


def test_a_reading_has_what_its_file_has(unread: None) -> None:
    kept = stored(Interpretation())
    same(restore_or_read(kept, kept.interpretation), from_file(Interpretation()))


def test_more_overrides_are_laid_over_a_reading(unread: None) -> None:
    kept = stored(Interpretation())
    target = replace(kept.interpretation, overrides=overrides(kept, row3=LineType.IGNORED))
    same(restore_or_read(kept, target), from_file(target))


@pytest.mark.parametrize(
    "target",
    [
        Interpretation(unit="in"),
        Interpretation(profile="german"),
        Interpretation(rules='title = "Mine"\n[[rule]]\ntype = "half-cut"\ncolour = 1\n'),
    ],
)
def test_another_unit_or_profile_reads_the_file_again(target: Interpretation) -> None:
    kept = stored(Interpretation())
    target = replace(target, overrides=kept.interpretation.overrides)
    same(restore_or_read(kept, target), from_file(target))


def test_an_override_that_is_taken_back_is_classified_anew() -> None:
    count = len(pipeline.read(CONTENT))
    kept = stored(Interpretation(overrides=bytes([LineType.HALF_CUT] * count)))
    target = replace(kept.interpretation, overrides=bytes([NO_OVERRIDE] * count))
    found = restore_or_read(kept, target)
    same(found, from_file(target))
    assert LineType.HALF_CUT not in found[1].line_type


def test_a_reading_of_an_older_version_is_made_anew() -> None:
    kept = stored(Interpretation())
    columns, meta = unpack_columns(kept.edges)
    del columns["true_colour"]
    old = replace(kept, edges=pack_columns(columns, meta))
    same(restore_or_read(old, kept.interpretation), from_file(kept.interpretation))


def test_a_reading_of_a_version_without_line_widths_is_restored(unread: None) -> None:
    kept = stored(Interpretation())
    columns, meta = unpack_columns(kept.edges)
    del columns["line_width"]
    old = replace(kept, edges=pack_columns(columns, meta))
    drawing, dieline = restore_or_read(old, kept.interpretation)
    assert (drawing.line_width == NO_LINE_WIDTH).all()
    assert (dieline.line_type == columns["line_type"]).all()
    assert [row["line_width"] for row in EdgeTable.unpack(old.edges).rows(0, 2)] == [None, None]


def test_a_reading_without_fit_errors_is_made_anew_and_keeps_the_overrides() -> None:
    # As if an older version had approximated an entity by one edge less.
    content = samples()["corrugated-tray.dxf"]
    columns, meta = unpack_columns(tasks.read(no_progress, content, Interpretation()).edges)
    handles = meta["handles"]
    row = next(row for row, handle in enumerate(handles) if handles.count(handle) > 1)
    first, fewer = handles[row], handles[:row] + handles[row + 1 :]
    old = {
        name: np.delete(column, row, axis=0)
        for name, column in columns.items()
        if name != "fit_error"
    }
    column = [LineType.HALF_CUT if one == first else NO_OVERRIDE for one in fewer]
    target = Interpretation(overrides=bytes(column))
    edges = pack_columns(old, {**meta, "handles": fewer})
    drawing, dieline = restore_or_read(StoredDrawing(content, edges, target), target)
    assert len(drawing) == len(columns["bulge"])
    chosen = np.array([handle == first for handle in drawing.handles])
    assert (dieline.line_type[chosen] == LineType.HALF_CUT).all()
    assert (dieline.line_type[~chosen] != LineType.HALF_CUT).all()
    assert np.isfinite(dieline.fit_error).all()


def test_the_cleaning_of_a_reading_without_fit_errors_is_reported() -> None:
    kept = stored(Interpretation())
    columns, meta = unpack_columns(kept.edges)
    old = {name: column for name, column in columns.items() if name != "fit_error"}
    assert tasks.cleaning_report(no_progress, pack_columns(old, meta)) == tasks.cleaning_report(
        no_progress, kept.edges
    )


def test_a_program_of_a_reading_is_that_of_its_file(unread: None) -> None:
    kept = stored(Interpretation())
    made = tasks.compile(
        no_progress,
        kept,
        kept.interpretation,
        Definition(Shelf.MACHINES, "demo-table"),
        Definition(Shelf.BOARDS, "fbb-0.4"),
        (),
    )
    drawing, dieline = from_file(Interpretation())
    table, board = load.machine("demo-table"), load.board("fbb-0.4")
    assert made.accepted
    assert made.program == pipeline.compile(drawing, dieline, table, board).program.text


def test_a_drawing_that_cannot_be_cleaned_is_stored(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(_dieline: Dieline) -> Cleaned:
        raise DrawingTooLarge("edge.too-many-overlaps", edges=3, limit=2)

    monkeypatch.setattr(pipeline, "clean", refuse)
    reading = tasks.read(no_progress, CONTENT, Interpretation())
    assert len(unpack_columns(reading.edges)[1]["handles"]) > 0
    with pytest.raises(DrawingTooLarge):
        tasks.cleaning_report(no_progress, reading.edges)


@pytest.mark.parametrize("compiled", [True, False])
def test_a_reading_has_a_limit_of_processor_time_once_its_functions_are_compiled(
    monkeypatch: pytest.MonkeyPatch, compiled: bool
) -> None:
    def work(*_: object) -> None:
        end = time.process_time() + 0.5
        while time.process_time() < end:
            pass

    monkeypatch.setattr(tasks, "_read", work)
    monkeypatch.setattr(tasks, "is_compiled", lambda _group: compiled)
    monkeypatch.setattr(tasks, "limit_cpu", lambda: limit_cpu(0.1))
    if compiled:
        with pytest.raises(DrawingTooLarge):
            tasks.read(no_progress, CONTENT, Interpretation())
    else:
        tasks.read(no_progress, CONTENT, Interpretation())
