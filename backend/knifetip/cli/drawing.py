"""knifetip read, classify, clean and samples: what is in a drawing."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any, Final

import numpy as np
import typer

from knifetip import pipeline
from knifetip.cli.rules import named
from knifetip.cli.terminal import QUESTIONS, read_bytes, report_questions, show, write_bytes
from knifetip.dxf.samples import samples
from knifetip.errors import LibraryError
from knifetip.formats import FORMATS
from knifetip.geometry.columns import I64
from knifetip.messages import with_text
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.drawing import Drawing, Fate
from knifetip.model.interpretation import NO_OVERRIDE
from knifetip.model.machine import Machine
from knifetip.model.question import Question
from knifetip.units.evidence import find_unit

#: What the commands print of a long list, and how many of those alike are named.
_LINES: Final = 40
_NAMED: Final = 3

_NAMES: Final = ", ".join(one.name.upper() for one in FORMATS)
DrawingFile = Annotated[Path, typer.Argument(metavar="FILE", help=f"A drawing: {_NAMES}.")]
Unit = Annotated[
    str | None, typer.Option(help="mm, cm, m, in, ft, pt or px, whatever the file says of it.")
]
Profile = Annotated[str, typer.Option(help="Classification profile, or a TOML file of one.")]
Layers = Annotated[
    list[str] | None,
    typer.Option("--layer", metavar="NAME=TYPE", help="Give a layer a line type; repeatable."),
]
Json = Annotated[bool, typer.Option("--json", help="Print JSON.")]


@dataclass(frozen=True, eq=False, slots=True)
class Read:
    """A drawing from a file, classified as the command line asked."""

    data: bytes
    drawing: Drawing
    dieline: Dieline

    def questions(self, machine: Machine | None = None) -> list[Question]:
        """Return what is open."""
        return pipeline.questions(self.drawing, self.dieline, machine)


def load_drawing(file: Path, unit: str | None, profile: str, layers: list[str] | None) -> Read:
    """Return the classified drawing of a file.

    Raises
    ------
    KnifetipError
        The file, the profile or a layer's line type cannot be used.
    """
    data = read_bytes(file)
    drawing = pipeline.read(data, unit)
    overrides = np.full(len(drawing), NO_OVERRIDE, np.uint8)
    for pair in layers or []:
        name, equals, word = pair.rpartition("=")
        if not equals:
            raise LibraryError("command.bad-layer", pair=pair)
        try:
            kind = LineType.of(word)
        except ValueError as reason:
            raise LibraryError("command.bad-line-type", pair=pair, reason=reason) from reason
        rows = [i for i, layer in enumerate(drawing.layers) if layer.casefold() == name.casefold()]
        if not rows:
            raise LibraryError(
                "command.no-such-layer",
                layer=name,
                file=file.name,
                layers=(repr(layer) for layer in drawing.layers),
            )
        overrides[np.isin(drawing.layer, rows)] = kind
    return Read(data, drawing, pipeline.classify(drawing, named(profile), overrides))


def described(name: str, drawing: Drawing) -> dict[str, Any]:
    """Return a drawing's unit, size and layers as plain data."""
    low_x, low_y, high_x, high_y = (float(value) for value in drawing.bounds)
    found = find_unit(drawing)
    return {
        "name": name,
        "unit": drawing.unit or None,
        "stated": drawing.stated or None,
        "evidence": str(drawing.evidence),
        "unit_evidence": [
            {"unit": one.unit, "text": one.text, "weight": one.weight} for one in found.evidence
        ],
        "unit_ranking": list(found.ranking),
        "warnings": list(found.warnings),
        "size": [high_x - low_x, high_y - low_y],
        "bounds": [low_x, low_y, high_x, high_y],
        "segments": len(drawing),
        "length": float(drawing.lengths.sum()),
        "layers": list(drawing.layers),
    }


def ledger(drawing: Drawing) -> list[dict[str, Any]]:
    """Return what became of every entity as plain data."""
    rows = drawing.ledger
    return [
        {
            "handle": rows.handle[i],
            "kind": rows.kind[i],
            "layer": rows.layer[i],
            "fate": Fate(rows.fate[i]).name.lower(),
            "reason": rows.reason[i],
            "length": float(rows.length[i]),
        }
        for i in range(len(rows))
    ]


def edges(drawing: Drawing, dieline: Dieline) -> list[dict[str, Any]]:
    """Return every edge, and why it is what it is, as plain data."""
    lengths = drawing.lengths
    return [
        {
            "row": row,
            "handle": handle,
            "layer": drawing.layers[drawing.layer[row]],
            "colour": int(drawing.colour[row]),
            "linetype": drawing.linetypes[drawing.linetype[row]],
            "type": LineType(dieline.line_type[row]).word,
            "rule": str(dieline.rules[dieline.rule[row]]) if dieline.rule[row] >= 0 else "",
            "confidence": float(dieline.confidence[row]),
            "length": float(lengths[row]),
            "start": dieline.ends[row, 0].tolist(),
            "end": dieline.ends[row, 1].tolist(),
            "bulge": float(dieline.bulge[row]),
        }
        for row, handle in enumerate(drawing.handles)
    ]


def register(app: typer.Typer) -> None:
    """Add the commands of this module."""

    @app.command()
    def read(file: DrawingFile, unit: Unit = None, json: Json = False) -> None:
        """Say what is in a drawing, and what became of every entity."""
        drawing = pipeline.read(read_bytes(file), unit)
        about = described(file.name, drawing)
        rows = ledger(drawing)
        if json:
            show({"drawing": about, "ledger": rows})
            return
        typer.echo(f"{file.name}: {_size(about)}, {len(drawing)} segments; {drawing.evidence}")
        for text in about["warnings"]:
            typer.echo(f"  ! {text}")
        for text in _spoken(about):
            typer.echo(f"  {text}")
        _say(_alike(rows))

    @app.command()
    def classify(
        file: DrawingFile,
        profile: Profile = "default",
        layer: Layers = None,
        unit: Unit = None,
        json: Json = False,
    ) -> None:
        """Show the line type of every edge and the rule that gave it; exits with 2 if any is open.

        Open means that a question must be answered before a program can be made: the drawing's
        unit, or the line type of some edges.  Answer with --unit, --layer or a profile.
        """
        result = load_drawing(file, unit, profile, layer)
        listed = edges(result.drawing, result.dieline)
        asked = result.questions()
        about = described(file.name, result.drawing)
        if json:
            show(
                {
                    "drawing": about,
                    "edges": listed,
                    "questions": [with_text(question.as_json()) for question in asked],
                    "ledger": ledger(result.drawing),
                }
            )
        else:
            typer.echo(f"{file.name}: {_size(about)}; {result.drawing.evidence}")
            for kind in LineType:
                chosen = result.dieline.line_type == kind
                if chosen.any():
                    length = float(result.drawing.lengths[chosen].sum())
                    typer.echo(f"  {kind.word:12} {int(chosen.sum()):6} edges {length:12.1f} mm")
                    _say(_why(result, np.flatnonzero(chosen)), indent=4)
            report_questions(asked)
        if asked:
            raise typer.Exit(QUESTIONS)

    @app.command()
    def clean(
        file: DrawingFile,
        profile: Profile = "default",
        layer: Layers = None,
        unit: Unit = None,
        json: Json = False,
    ) -> None:
        """Say what is put in order before a drawing is made: of each edge, what became of it."""
        result = load_drawing(file, unit, profile, layer)
        if not result.drawing.unit:
            report_questions(result.questions())
            raise typer.Exit(QUESTIONS)
        tidy = pipeline.clean(result.dieline)
        about = described(file.name, result.drawing)
        if json:
            show({"drawing": about, "cleaning": tidy.as_json(result.drawing.handles)})
            return
        lengths = tidy.lengths
        typer.echo(f"{file.name}: {_size(about)}, {len(result.drawing)} edges")
        typer.echo(
            f"  drawn {lengths['drawn']:.3f} mm = kept {lengths['kept']:.3f} "
            f"+ merged {lengths['merged']:.3f} + dropped {lengths['dropped']:.3f}"
        )
        typer.echo(
            f"  worked {lengths['worked']:.3f} mm = kept {lengths['kept']:.3f} "
            f"+ added by closing gaps {lengths['added']:.3f}"
        )
        handles = result.drawing.handles
        changed = np.flatnonzero(tidy.changed).tolist()
        _say([f"{handles[row]:>8} edge {row}: {tidy.words(row)}" for row in changed])

    @app.command("samples")
    def write_samples(
        folder: Annotated[Path, typer.Argument(metavar="DIR", help="Where to write them.")],
    ) -> None:
        """Draw the sample cartons that come with knifetip."""
        for name, data in samples().items():
            write_bytes(folder / name, data)
            typer.echo(str(folder / name))


def _say(lines: list[str], indent: int = 2) -> None:
    """Print some lines; more than a screen takes are only counted."""
    for line in lines[:_LINES]:
        typer.echo(" " * indent + line)
    if len(lines) > _LINES:
        typer.echo(" " * indent + f"… and {len(lines) - _LINES} more: --json lists them all")


def _alike(rows: list[dict[str, Any]]) -> list[str]:
    """Return what became of the entities, those of one fate in one line, what is kept last."""
    groups: dict[tuple[str, str, str, str], list[str]] = {}
    for row in rows:
        key = row["fate"], row["kind"], row["layer"], row["reason"]
        groups.setdefault(key, []).append(row["handle"])
    said = []
    for (fate, kind, layer, reason), handles in groups.items():
        which = ", ".join(handles[:_NAMED]) + (" …" if len(handles) > _NAMED else "")
        text = f"{fate:8} {len(handles):6} × {kind} on {layer!r}: {reason} ({which})"
        said.append((fate == Fate.KEPT.name.lower(), text))
    return [text for _, text in sorted(said, key=lambda one: one[0])]


def _why(result: Read, rows: I64) -> list[str]:
    """Return by what the rows have their line type, and how sure that is."""
    dieline = result.dieline
    rule, confidence = dieline.rule[rows], dieline.confidence[rows]
    said = []
    for number in np.unique(rule).tolist():
        here = rule == number
        low, high = confidence[here].min() * 100.0, confidence[here].max() * 100.0
        sure = f"{low:.0f} %" if round(low) == round(high) else f"{low:.0f} … {high:.0f} %"
        words = str(dieline.rules[number]) if number >= 0 else "no rule and no evidence"
        said.append(f"{int(here.sum()):6} × {sure}: {words}")
    return said


def _spoken(about: dict[str, Any]) -> list[str]:
    """Return the evidence for the two likeliest units, the heaviest first."""
    return [
        f"{one['unit']:3} {one['weight']:5.1f}  {one['text']}"
        for unit in about["unit_ranking"][:2]
        for one in about["unit_evidence"]
        if one["unit"] == unit
    ]


def _size(about: dict[str, Any]) -> str:
    width, height = about["size"]
    unit = "mm" if about["unit"] else "units (the unit is not known)"
    return f"{width:.2f} × {height:.2f} {unit}"
