"""The correct programs that are attacked: every tool and operation in every controller language."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cache, cached_property

from knifetip import compensate, pipeline, plan, process, sequence
from knifetip.library import load
from knifetip.model.board import Board
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.earlier_work import EarlierWork
from knifetip.model.machine import Machine, Zone
from knifetip.model.verdict import Severity
from knifetip.verification.verify import JobDetails, verify
from tests.support.programs import laser
from tests.support.programs.engines import BLANK, DEMO, ENGINES, FOLDS, GREY, MILLED, ROUTER, THICK
from tests.support.programs.mixed_carton import mixed_carton
from tests.support.shapes import closed, dieline, edges, with_dimensions

#: Controller languages that are dialects of RS274/NGC.
DIALECTS = ("linuxcnc", "grblhal")
#: Bulge of a quarter of a circle.
QUARTER = 2.0**0.5 - 1.0


@dataclass(frozen=True)
class Subject:
    """A correct program with the job that it is made from."""

    name: str
    text: bytes
    dieline: Dieline
    placement: tuple[float, float]
    machine: Machine
    board: Board
    earlier: tuple[EarlierWork, ...] = ()  #: the programs whose sheet this one continues

    @property
    def language(self) -> str:
        """Name of the controller language of the program."""
        return self.machine.dialect

    def accepts(self, text: bytes) -> bool:
        """Return whether the verifier finds no fault in a program for the same job.

        The shortfalls of the correct program are accepted, by edge and message code.
        """
        findings = self._refusals(text)
        return all(
            severity is Severity.SHORTFALL and (code, edge) in self._shortfalls
            for severity, code, edge in findings
        )

    def _refusals(self, text: bytes) -> list[tuple[Severity, str, int]]:
        verdict = verify(
            text,
            self.dieline,
            self.placement,
            self.machine,
            self.board,
            job=JobDetails(earlier=self.earlier),
        )
        return [
            (found.severity, found.message.code, found.edge)
            for found in verdict.findings
            if found.refuses
        ]

    @cached_property
    def _shortfalls(self) -> set[tuple[str, int]]:
        return {
            (code, edge)
            for severity, code, edge in self._refusals(self.text)
            if severity is Severity.SHORTFALL
        }


@cache
def subjects() -> tuple[Subject, ...]:
    """Return all subjects, each of which the verifier accepts."""
    found = [
        *_of_engines(),
        *_of_nested(),
        *_of_tables(),
        *_of_bends(),
        *_of_passes(),
        *_of_routers(),
        *_of_lasers(),
        _of_plotter(),
        *_of_segments(),
    ]
    for subject in found:
        assert subject.accepts(subject.text), subject.name
    return tuple(found)


def _made(
    name: str, line: Dieline, machine: Machine, board: Board, corner: str = "B"
) -> list[Subject]:
    result = []
    for dialect in DIALECTS:
        driven = replace(machine, dialect=dialect)
        operations = [replace(each, corner=corner) for each in plan(line, driven, board)]
        path = sequence([compensate(each) for each in operations], driven)
        text = process(path, driven, dialect, notes=["placement X0.0000 Y0.0000"]).text
        result.append(Subject(f"{name}, {dialect}", text, line, (0.0, 0.0), driven, board))
    return result


def _of_engines() -> list[Subject]:
    return [
        subject
        for engine in ENGINES.values()
        for subject in _made(engine.name, engine.line, engine.machine, engine.board, engine.corner)
    ]


def _of_nested() -> list[Subject]:
    """Return programs of a part with a crease in the window of another part."""
    nested = dieline(
        BLANK,
        (LineType.CUT, closed((120, 120), (200, 120), (200, 165), (120, 165))),
        (LineType.CUT, closed((130, 130), (180, 130), (180, 155), (130, 155))),
        (LineType.CREASE, edges(((150, 130), (150, 155)), ((110, 100), (110, 180)))),
    )
    return _made("nested parts", nested, DEMO, GREY)


def _of_tables() -> list[Subject]:
    """Return programs of a table with two carriages, and of one with a clamp beside the sheet."""
    mixed = dieline(
        BLANK,
        (LineType.V_GROOVE, edges(((120, 100), (120, 180)))),
        (LineType.CREASE, edges(((160, 100), (160, 180)))),
        bulge={0: 0.1},
    )
    clamp = Zone("clamp", 245.0, 120.0, 30.0, 30.0, 17.0)
    return [
        *_made("two carriages", mixed, load.machine("two-carriage-table"), GREY),
        *_made("clamp", FOLDS, replace(DEMO, zones=(clamp,)), GREY),
    ]


def _of_bends() -> list[Subject]:
    """Return programs with bends in which the bodies of wheel and blade matter."""
    table, board = load.machine("sample-table"), load.board("e-flute")
    rounded = dieline(
        (LineType.CUT, edges(
            ((102, 100), (220, 100)), ((220, 100), (220, 174)), ((220, 174), (214, 180)),
            ((214, 180), (100.5, 180)), ((100.5, 180), (100, 179.5)), ((100, 179.5), (100, 102)),
            ((100, 102), (102, 100)),
        )),
        (LineType.CREASE, edges(((130, 120), (130, 160)), ((180, 120), (200, 140)))),
        (LineType.HALF_CUT, edges(((150, 120), (150, 160)))),
        bulge={2: QUARTER, 4: QUARTER, 6: QUARTER, 7: 0.3, 8: QUARTER, 9: 0.5},
    )  # fmt: skip
    return _made("bends", rounded, table, board)


def _of_passes() -> list[Subject]:
    """Return programs in which a knife cuts thick board in passes."""
    cut = dieline(
        (LineType.CUT, edges(
            ((100, 100), (220, 100)), ((220, 100), (220, 160)), ((220, 160), (200, 180)),
            ((200, 180), (100, 180)), ((100, 180), (100, 100)), ((130, 120), (130, 160)),
        )),
        bulge={2: QUARTER},
    )  # fmt: skip
    return _made("knife in passes", cut, load.machine("demo-table"), load.board("greyboard-4.0"))


def _of_routers() -> list[Subject]:
    """Return programs of a router that leaves bridges, and of one with shallow leads."""
    bridged = replace(THICK, bridge_width=1.0, bridge_spacing=100.0)
    stations = tuple(
        replace(held, tool=with_dimensions(held.tool, approach=30.0))
        if held.name == "Router"
        else held
        for held in ROUTER.stations
    )
    folded = dieline(BLANK, (LineType.CREASE, edges(((160, 100), (160, 180)))))
    return [
        *_made("router with bridges", dieline(BLANK), ROUTER, bridged),
        *_made("router, shallow leads", MILLED, replace(ROUTER, stations=stations), THICK),
        *_made("router and wheel", folded, ROUTER, THICK, "auto"),
    ]


def _of_lasers() -> list[Subject]:
    return [
        Subject(
            f"laser, {dialect}",
            laser.program(dialect).text,
            laser.LINE,
            (0.0, 0.0),
            replace(laser.LASER, dialect=dialect),
            laser.BOARD,
        )
        for dialect in DIALECTS
    ]


def _of_plotter() -> Subject:
    machine, board = load.machine("flat-cutter-hpgl"), load.board("fbb-0.4")
    drawing = pipeline.read(mixed_carton())
    line = pipeline.classify(drawing, load.profile("default"))
    made = pipeline.compile(drawing, line, machine, board)
    return Subject(
        "flat cutter, hpgl",
        made.program.text,
        line,
        made.placement,
        machine,
        board,
    )


def _of_segments() -> list[Subject]:
    """Return programs of a table with an MCX314."""
    table = load.machine("v-groove-table")
    found = []
    for name in ("V-groove", "crease", "knife", "partial cuts", "drag knife"):
        engine = ENGINES[name]
        machine = replace(table, stations=engine.machine.stations)
        operations = plan(engine.line, machine, engine.board)
        path = sequence([compensate(each) for each in operations], machine)
        text = process(path, machine, notes=["placement X0.0000 Y0.0000"]).text
        subject = Subject(f"{name}, mcx314", text, engine.line, (0.0, 0.0), machine, engine.board)
        found.append(subject)
    return found
