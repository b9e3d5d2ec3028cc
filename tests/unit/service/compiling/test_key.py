"""The key of a compile depends on the inputs of the compile, and on nothing else."""

from __future__ import annotations

import inspect
from collections.abc import Iterator
from dataclasses import fields, is_dataclass, replace
from typing import Any

import pytest
from pydantic import BaseModel

from knifetip.library.definition import Definition, Shelf
from knifetip.model.acceptance import Exceptions
from knifetip.model.corners import CornerAt, Corners
from knifetip.model.interpretation import Interpretation
from knifetip.model.job_options import (
    BridgeAt,
    ContourLead,
    ContourStart,
    CreaseDepth,
    CutDepth,
    EdgeCorner,
    EdgeFeed,
    EdgeTool,
    JobOptions,
)
from knifetip.model.sheet import Sheet
from knifetip.model.verdict import Acceptance
from knifetip.service.compiling import key as module
from knifetip.service.compiling.key import compile_key
from knifetip.service.compiling.service import compile_arguments
from knifetip.service.orders.store import JobOrder
from knifetip.service.processes import tasks
from knifetip.service.processes.readings import StoredDrawing
from knifetip.service.processes.rest_record import StoredRest
from knifetip.service.store import Store
from tests.support.job_states import drawing

CHOICES = JobOptions(
    corners=Corners(
        type="D", k=0.25, interference="refuse", at=(CornerAt(x=1.0, y=2.0, type="C", k=0.75),)
    ),
    sheet=Sheet(width=800.0, height=600.0),
    lift="least",
    feed_factor=0.5,
    warp=5.0,
    contour_starts=(ContourStart(edges=(3, 4), at=0.25, direction="reverse"),),
    cut_depths=(CutDepth(edges=(5,), passes=2, depth=1.5), CutDepth(line_type="cut", passes=3)),
    crease_depths=(CreaseDepth(edges=(7,), depth=0.3),),
    edge_corners=(EdgeCorner(edges=(3,), type="D", k=0.25),),
    contour_leads=(ContourLead(edges=(2,), length=2.0, approach=45.0),),
    edge_tools=(EdgeTool(edges=(4,), station=2),),
    edge_feeds=(EdgeFeed(edges=(6,), factor=0.5),),
    bridges=(BridgeAt(edges=(9,), at=0.5, width=1.0),),
    work_order=(8, 7),
    program_note="grain up",
)
FULL: dict[str, Any] = {
    "stored": StoredDrawing(b"dxf", b"edges", Interpretation("mm", "default", "a = 1", b"\x01")),
    "interpretation": Interpretation("in", "trade", "b = 2", b"\x02", CHOICES),
    "machine": Definition(Shelf.MACHINES, "own", 2, "title = 'own'"),
    "board": Definition(Shelf.BOARDS, "own-board", 3, "caliper = 1"),
    "notes": ("knifetip 1", "drawing 2"),
    "exceptions": Exceptions(((7, "deviation"),), Acceptance("Ann", "sample", 5.0)),
    "rest": StoredRest(b"path", ((1, 2),), ((b"G0", ((1, 2),), ((3, 4),)),)),
}


def changed(value: Any) -> Iterator[Any]:
    """Yield copies of a value, in each of which one leaf differs."""
    if is_dataclass(value) and not isinstance(value, type):
        for field in fields(value):
            for other in changed(getattr(value, field.name)):
                copy = replace(value)
                object.__setattr__(copy, field.name, other)
                yield copy
    elif isinstance(value, BaseModel):
        for name in type(value).model_fields:
            for other in changed(getattr(value, name)):
                yield value.model_copy(update={name: other})
    elif isinstance(value, tuple | list):
        for index, item in enumerate(value):
            for other in changed(item):
                yield type(value)([*value[:index], other, *value[index + 1 :]])
        if value:
            yield type(value)(value[:-1])
    elif isinstance(value, Shelf):
        yield Shelf.BOARDS if value is Shelf.MACHINES else Shelf.MACHINES
    elif isinstance(value, bool):
        yield not value
    elif isinstance(value, bytes):
        yield value + b"\x00"
    elif isinstance(value, str):
        yield value + " "
    elif isinstance(value, int | float):
        yield value + 1
    elif value is not None:
        raise AssertionError(f"no change of {value!r}")


def test_every_leaf_of_every_argument_of_a_compile_changes_the_key() -> None:
    names = list(inspect.signature(tasks.compile).parameters)[1:]
    assert names == list(FULL)
    arguments = tuple(FULL.values())
    keys = {compile_key(arguments)}
    others = list(changed(arguments))
    assert len(others) > 30
    for other in others:
        keys.add(compile_key(other))
    for index in range(len(arguments)):
        keys.add(compile_key((*arguments[:index], None, *arguments[index + 1 :])))
    assert len(keys) == 1 + len(others) + len(arguments)
    assert compile_key(arguments) in keys


def test_the_files_of_knifetip_change_the_key(monkeypatch: pytest.MonkeyPatch) -> None:
    before = compile_key(tuple(FULL.values()))
    monkeypatch.setattr(module, "_code_version", lambda: "other code")
    assert compile_key(tuple(FULL.values())) != before


def test_neighbouring_texts_are_kept_apart() -> None:
    assert compile_key((("ab", "c"),)) != compile_key((("a", "bc"),))


def key_of(store: Store, order: JobOrder) -> str:
    job = store.jobs.add(drawing(store), order)
    return compile_key(
        compile_arguments(store, job, store.library.definition(Shelf.MACHINES, job.machine))
    )


ORDER = JobOrder("demo-table", "e-flute", Interpretation("mm"))


@pytest.mark.parametrize(
    "other",
    [replace(ORDER, copies=2), replace(ORDER, priority=2), replace(ORDER, release=True)],
)
def test_what_does_not_change_a_program_does_not_change_the_key(
    store: Store, other: JobOrder
) -> None:
    assert key_of(store, ORDER) == key_of(store, other)


@pytest.mark.parametrize(
    "other",
    [
        replace(ORDER, machine="router-table"),
        replace(ORDER, board="b-flute"),
        replace(ORDER, interpretation=Interpretation("in")),
        replace(ORDER, interpretation=Interpretation("mm", "trade")),
        replace(ORDER, interpretation=Interpretation("mm", rules="x = 1")),
        replace(ORDER, interpretation=Interpretation("mm", overrides=b"\x01")),
        replace(ORDER, interpretation=Interpretation("mm", options=JobOptions(lift="least"))),
        replace(
            ORDER,
            interpretation=Interpretation(
                "mm", options=JobOptions(sheet=Sheet(width=9.0, height=9.0))
            ),
        ),
    ],
)
def test_each_choice_of_an_order_changes_the_key(store: Store, other: JobOrder) -> None:
    assert key_of(store, ORDER) != key_of(store, other)
