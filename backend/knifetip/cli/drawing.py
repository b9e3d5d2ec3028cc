"""knifetip read, classify, clean and samples: commands on a single drawing."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any, Final

import numpy as np
import typer

from knifetip import line_types
from knifetip.cli.line_types import Edges, Layers, overrides
from knifetip.cli.options import expand
from knifetip.cli.rules import find_profile
from knifetip.cli.terminal import (
    QUESTIONS,
    in_words,
    print_json,
    print_line,
    print_message,
    read_bytes,
    report_questions,
    report_warnings,
    write_bytes,
)
from knifetip.errors import KnifetipError
from knifetip.formats import FORMATS
from knifetip.geometry.columns import I64, U8
from knifetip.messages import Message
from knifetip.model.cleaned import Cleaned
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.drawing import Drawing, ImportOutcome
from knifetip.model.machine import Machine
from knifetip.model.question import Question
from knifetip.presentation.drawing import classified_json, drawing_json
from knifetip.presentation.edges import EdgeTable
from knifetip.presentation.import_report import import_report_rows
from knifetip.presentation.import_warnings import import_warnings
from knifetip.presentation.outcomes import edge_outcomes
from knifetip.presentation.replaced_folds import replaced_fold_warnings
from knifetip.presentation.texts import with_texts

#: Maximum number of printed lines of a list, and of handles named in one line.
_MAX_LINES: Final = 40
_MAX_HANDLES: Final = 3

_NAMES: Final = ", ".join(one.name.upper() for one in FORMATS)
DrawingFile = Annotated[
    Path, typer.Argument(metavar="FILE", help=f"File with the drawing ({_NAMES}).")
]
Unit = Annotated[
    str | None,
    typer.Option(
        help="Unit of the drawing: mm, cm, m, in, ft, pt, px or px-90 (pixels of 1/90 in). "
        "Default: the unit that the file states or the drawing shows."
    ),
]
Profile = Annotated[str, typer.Option(help="Name of a classification profile, or its TOML file.")]
Json = Annotated[bool, typer.Option("--json", help="Print the result as JSON.")]


@dataclass(frozen=True, slots=True)
class ReadingOptions:
    """Command-line options: unit, classification profile and line types of a drawing."""

    profile: Profile = "default"
    layer: Layers = None
    edge: Edges = None
    unit: Unit = None

    def load(self, file: Path) -> LoadedDrawing:
        """Return the drawing in a file, read and classified with these options.

        Raises
        ------
        KnifetipError
            The file or an option cannot be used.
        """
        data = read_bytes(file)
        drawing = line_types.read(data, self.unit)
        set_by_user = overrides(drawing, file.name, self.layer, self.edge)
        dieline = line_types.classify(drawing, find_profile(self.profile), set_by_user)
        return LoadedDrawing(data, drawing, dieline, set_by_user)


@dataclass(frozen=True, eq=False, slots=True)
class LoadedDrawing:
    """The drawing in a file, read and classified, with its edges and their line types."""

    data: bytes
    drawing: Drawing
    dieline: Dieline
    overrides: U8  #: (n,) ``NO_OVERRIDE`` or the LineType set by an option, for each edge

    def questions(self, machine: Machine | None = None) -> list[Question]:
        """Return the questions about the drawing that the user must answer before a compile.

        Parameters
        ----------
        machine
            Machine for which the drawing is to be compiled.  If it is None, there are no questions
            about line types that the tools of the machine cannot process.
        """
        return line_types.questions(self.drawing, self.dieline, machine)

    def as_json(self, name: str) -> dict[str, Any]:
        """Return the drawing and its edges as JSON data, with the field names of the REST API.

        If the drawing cannot be cleaned, all its edges have the outcome *kept*.

        Parameters
        ----------
        name
            Name of the file, which becomes the name of the drawing.
        """
        outcomes = edge_outcomes(self.drawing, self.dieline, self._cleaned())
        data = classified_json(
            self.drawing, self.dieline, outcomes, self.questions(), self.overrides
        )
        return {
            "drawing": _with_report(name, self.drawing, data),
            "edges": EdgeTable.from_drawing(self.drawing, self.dieline, outcomes).rows(),
        }

    def warnings(self) -> list[Message]:
        """Return the warnings about what import left out, and about folds that cuts replace."""
        cleaned = self._cleaned()
        warnings = import_warnings(self.drawing)
        if cleaned is None:
            return warnings
        return [
            *warnings,
            *replaced_fold_warnings(self.dieline, cleaned, self.drawing.lengths),
        ]

    def _cleaned(self) -> Cleaned | None:
        """Return the result of cleaning the drawing; None if it cannot be cleaned.

        A drawing without a unit cannot be cleaned.
        """
        if not self.drawing.unit:
            return None
        try:
            return _clean(self.dieline)
        except KnifetipError as error:
            print_message(Message("output.not-cleaned", reason=error.message), "yellow")
            return None


def report_json(name: str, drawing: Drawing) -> dict[str, Any]:
    """Return name, unit, size and import report of a drawing as JSON data.

    The fields are those of a drawing in the REST interface, and messages contain their English
    text.  In addition, ``size`` is the list of width and height.
    """
    return _with_report(name, drawing, drawing_json(drawing))


def _with_report(name: str, drawing: Drawing, data: dict[str, Any]) -> dict[str, Any]:
    report = {**data["import_report"], "rows": import_report_rows(drawing)}
    plain: dict[str, Any] = with_texts(
        {
            "name": name,
            **data,
            "size": [data["width"], data["height"]],
            "import_report": report,
        }
    )
    return plain


def register(app: typer.Typer) -> None:
    """Add the commands ``read``, ``classify``, ``clean`` and ``samples`` to a Typer application."""

    @app.command()
    def read(file: DrawingFile, unit: Unit = None, json: Json = False) -> None:
        """Show unit, size and import report of a drawing."""
        drawing = line_types.read(read_bytes(file), unit)
        about = report_json(file.name, drawing)
        if json:
            print_json({"drawing": about})
            return
        count, evidence = len(drawing), drawing.evidence
        size = {"file": file.name, "size": _size(drawing)}
        print_line(in_words(Message("output.read", **size, count=count, evidence=evidence)))
        for warning in about["warnings"]:
            print_line(f"  ! {warning['text']}")
        for text in _evidence_lines(about["unit_finding"]):
            print_line(f"  {text}")
        _print_lines(_report_lines(about["import_report"]["rows"]))

    @app.command()
    @expand
    def classify(file: DrawingFile, reading: ReadingOptions, json: Json = False) -> None:
        """Show the line type of each edge and the rule that decided it.

        Exits with 2 if the user must decide the unit of the drawing or the line types of some
        edges. Use --unit, --layer, --edge or a profile for these decisions; no program can be made
        without them.
        """
        result = reading.load(file)
        open_questions = result.questions()
        if json:
            data = result.as_json(file.name)
            print_json({**data, "questions": data["drawing"]["questions"]})
        else:
            print_line(f"{file.name}: {_size(result.drawing)}; {result.drawing.evidence}")
            for kind in LineType:
                selected = result.dieline.line_type == kind
                if selected.any():
                    length = float(result.drawing.lengths[selected].sum())
                    figures = {"count": f"{int(selected.sum()):6}", "length": f"{length:12.1f}"}
                    row = Message("output.line-type", type=f"{kind.word:12}", **figures)
                    print_line(f"  {in_words(row)}")
                    _print_lines(_rule_lines(result, np.flatnonzero(selected)), indent=4)
            report_warnings(import_warnings(result.drawing))
            report_questions(open_questions)
        if open_questions:
            raise typer.Exit(QUESTIONS)

    @app.command()
    @expand
    def clean(file: DrawingFile, reading: ReadingOptions, json: Json = False) -> None:
        """Show which edges cleaning merges, shortens, joins or drops.

        Every drawing is cleaned before a program is made from it.
        """
        result = reading.load(file)
        if not result.drawing.unit:
            report_warnings(import_warnings(result.drawing))
            report_questions(result.questions())
            raise typer.Exit(QUESTIONS)
        cleaned = _clean(result.dieline)
        if json:
            about = report_json(file.name, result.drawing)
            print_json({"drawing": about, "cleaning": cleaned.as_json(result.drawing.handles)})
            return
        lengths = cleaned.lengths
        size, count = _size(result.drawing), len(result.drawing)
        print_line(
            in_words(Message("output.size-and-edges", file=file.name, size=size, count=count))
        )
        drawn = {name: lengths[name] for name in ("drawn", "kept", "merged", "dropped")}
        worked = {name: lengths[name] for name in ("worked", "kept", "added")}
        print_line(f"  {in_words(Message('output.drawn', **drawn))}")
        print_line(f"  {in_words(Message('output.worked', **worked))}")
        handles = result.drawing.handles
        changed = np.flatnonzero(cleaned.changed).tolist()
        edges = [
            Message(
                "output.cleaned-edge",
                handle=f"{handles[row]:>8}",
                edge=row,
                outcome=cleaned.describe(row),
            )
            for row in changed
        ]
        _print_lines([in_words(edge) for edge in edges])

    @app.command("samples")
    def write_samples(
        folder: Annotated[Path, typer.Argument(metavar="DIR", help="Folder to write to.")],
    ) -> None:
        """Write the sample cartons as DXF files."""
        # The samples import ezdxf, which is slow; no other command needs it when it starts.
        from knifetip.dxf.samples import samples

        for name, data in samples().items():
            write_bytes(folder / name, data)
            print_line(str(folder / name))


def _clean(dieline: Dieline) -> Cleaned:
    """Return the cleaned dieline; see ``pipeline.clean``."""
    # The pipeline imports all engines, which takes longer than classifying a small drawing.
    from knifetip import pipeline

    return pipeline.clean(dieline)


def _print_lines(lines: list[str], indent: int = 2) -> None:
    """Print text lines, indented by ``indent`` blanks.

    After ``_MAX_LINES`` lines, only the number of further lines is printed.
    """
    for line in lines[:_MAX_LINES]:
        print_line(" " * indent + line)
    if len(lines) > _MAX_LINES:
        more = Message("output.more-lines", count=len(lines) - _MAX_LINES)
        print_line(" " * indent + in_words(more))


def _report_lines(rows: list[dict[str, Any]]) -> list[str]:
    """Return the text lines that show an import report on the terminal.

    Entities with equal outcome, kind, layer and reason are combined in one text line; the lines of
    kept entities come last.

    ``rows``: rows of the import report as JSON data, one per entity.
    """
    groups: dict[tuple[str, str, str, str], list[str]] = {}
    for row in rows:
        key = row["outcome"], row["kind"], row["layer"], row["reason"]["text"]
        groups.setdefault(key, []).append(row["handle"])
    lines = []
    for (outcome, kind, layer, reason), handles in groups.items():
        shown = ", ".join(handles[:_MAX_HANDLES]) + (" …" if len(handles) > _MAX_HANDLES else "")
        text = f"{outcome:8} {len(handles):6} × {kind} on {layer!r}: {reason} ({shown})"
        lines.append((outcome == ImportOutcome.KEPT.name.lower(), text))
    return [text for _, text in sorted(lines, key=lambda line: line[0])]


def _rule_lines(result: LoadedDrawing, rows: I64) -> list[str]:
    """Return text lines about the rules that classified some edges, one text line per rule.

    Each text line contains the number of edges, the confidence of their line types (percent) and
    the conditions of the rule.

    ``result``: the classified drawing.
    ``rows`` (m,): rows in the drawing of the m edges to describe.
    """
    dieline = result.dieline
    rule, confidence = dieline.rule[rows], dieline.confidence[rows]
    lines = []
    for number in np.unique(rule).tolist():
        matches = rule == number
        low, high = confidence[matches].min() * 100.0, confidence[matches].max() * 100.0
        percent = f"{low:.0f} %" if round(low) == round(high) else f"{low:.0f} … {high:.0f} %"
        words = str(dieline.rules[number]) if number >= 0 else "no rule and no evidence"
        lines.append(f"{int(matches.sum()):6} × {percent}: {words}")
    return lines


def _evidence_lines(finding: dict[str, Any]) -> list[str]:
    """Return text lines with the evidence for the two likeliest units of a drawing.

    ``finding``: field ``unit_finding`` of a drawing in JSON data.
    """
    return [
        f"{one['unit']:3} {one['weight']:5.1f}  {one['text']}"
        for unit in finding["ranking"][:2]
        for one in finding["evidence"]
        if one["unit"] == unit
    ]


def _size(drawing: Drawing) -> str:
    """Return a text with the width and the height of a drawing and the unit of both."""
    min_x, min_y, max_x, max_y = drawing.bounds
    unit = "mm" if drawing.unit else "units (unit unknown)"
    return f"{max_x - min_x:.2f} × {max_y - min_y:.2f} {unit}"
