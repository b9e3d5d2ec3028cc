"""Write the table of import and classification results of the corpus to backend/docs/import.md.

    .venv/bin/python -m tests.benchmarks.import_table

The page has every file, with its import report and classification; drawings with known line types,
also without layer names, without any style, and in other styles and positions; and cartons in the
conventions of other companies.
"""

from __future__ import annotations

import time
from collections import Counter, defaultdict
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np

from knifetip import pipeline
from knifetip.classification.classify import classify
from knifetip.classification.questions import list_questions
from knifetip.cleaning.clean import clean
from knifetip.errors import KnifetipError
from knifetip.formats import FORMATS
from knifetip.geometry.columns import F64, I64, U8
from knifetip.library import load
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.drawing import Drawing, ImportOutcome
from tests.conftest import CORPUS, ROOT
from tests.support.cartons.companies import COMPANIES, Company
from tests.support.cartons.company_files import company_file, truth
from tests.support.cartons.kinds import KINDS
from tests.support.cartons.rewritings import in_pieces, mirrored, restyled, three_up, turned
from tests.support.truth.known_types import (
    KNOWN,
    classification_fractions,
    replaced_by_cuts,
    without_names,
    without_style,
)

#: Languages of the layer names of companies.
LANGUAGES = 20
PAGE = ROOT / "backend" / "docs" / "import.md"

#: Of each format: by what its lines differ, where its unit is, and what is not read.
FORMAT_NOTES = {
    "dxf": (
        "layer, colour, linetype, line width",
        "header, or asked",
        "texts, dimensions, hatches, solids, paper space",
    ),
    "cf2": ("line type number, auxiliary type, rule thickness, subroutine", "UM or UI", "texts"),
    "svg": (
        "layer, group, class or id, colour, dashes, line width",
        "size of the page, or asked",
        "texts, pictures, filled areas beside lines",
    ),
    "pdf": (
        "layer, spot colour, colour, dashes, line width",
        "1/72 in",
        "texts, pictures, filled areas beside lines, pages that are not chosen",
    ),
    "plt": (
        "pen (its layer), line type, line width, colour of PC",
        "1/40 mm; asked if the scale depends on the paper",
        "labels, filled areas, symbols, further sheets, what follows a label",
    ),
    "lightburn": (
        "layer, its colour, perforation",
        "mm",
        "texts, pictures, layers without output, filled shapes beside lines, polygons",
    ),
    "eps": (
        "spot colour, colour, dashes, line width",
        "1/72 in",
        "as in PDF; needs Ghostscript",
    ),
    "dwg": (
        "layer, colour, linetype",
        "header, or asked",
        "as in DXF; needs LibreDWG",
    ),
}

HEAD = """# Import of drawings from other sources

Made by `python -m tests.benchmarks.import_table`; times are of one run on a shared two-core
machine, the kernels warm.

![The page: one question, and the dropped entities with their positions](import.png)

## Formats

The format of a file is detected from its content. EPS and DWG need
[another program](howto/read-eps-and-dwg.md), which also says which formats are refused and why.

| format | files | lines differ by | unit | left out, with a row in the import report |
|---|---|---|---|---|
{formats}

## Every drawing of the corpus

Entities are those of the file, with INSERTs expanded. *Kept*, *merged* (drawn twice) and
*dropped* (texts, hatches, paper space …) count entities. *Edges* are lines and arcs; *worked* are
the edges that remain after cleaning has removed overlaps and debris and merged collinear edges.
Classified by the profile `default`; *asked* edges have no line type yet.

| file | entities | kept | merged | dropped | edges | worked | unit | classes | questions | s |
|---|--:|--:|--:|--:|--:|--:|---|---|--:|--:|
"""

TRUTH = """
## Drawings whose truth is known

Right, asked about, and silently wrong, in per cent of the edges and of their length, by the profile
`default`. *No names* puts every edge on layer 0; *one style* also removes colours and linetypes,
so that shape is the only evidence.

| file | as | right | asked | wrong | right mm | asked mm | wrong mm | questions |
|---|---|--:|--:|--:|--:|--:|--:|--:|
"""

NOTES = """
Errors with *one style*: the crosses beside the CF2 are not cut, although their line type is cut.
Four creases of the 0200 are drawn on its outline: the cut replaces them in any case, so they are
right as cuts. The box of InkPacking lacks the top edge of a panel: its three creases are asked
about, with crease as the most likely line type. With the colours and linetypes of the files all of
them are right, or asked about.
"""

BY_COMPANY = """
## Cartons in the styles of other companies

{kinds} kinds of cartons (slotted cases with slots and with slits, trays, tuck ends, mailers,
displays, pillows, bags, crash locks, folders …), each drawn as a file in the style of each of
{companies} companies (`tests/support/cartons`): layer names of CAD programs and of
{languages} languages, colours, one style for all; with dimensions inside and outside, frames,
legends, crosses, bleeds, texts turned into lines, glue marks; edges split into pieces, with
gaps, with creases that stop short, three and six blanks in one file; and with wrong units in the
header. Classified by the profile `default`.

Right, asked about and silently wrong in per cent of the edges and of their length; questions for
a drawing; and whether the unit was found, asked about, or wrong.

| style | right | asked | wrong | right mm | asked mm | wrong mm | questions | unit |
|---|--:|--:|--:|--:|--:|--:|--:|---|
"""

AFTER_COMPANIES = """
The most frequent questions: which line through the flaps is the slit, if the drawing has one style;
letters, crosses and bleeds on the layer of the cuts, for which the rule and the shape disagree (one
question each); and the unit, if neither the header nor a text states it. With other sizes one kind
of lines was classified wrong: arrowheads whose ends happen to be on another line.
"""

REWRITTEN = """
## The same cartons in other styles and positions

The {cartons} cartons above that have creases, without their texts: {edges} lines and arcs by other
authors, each drawn in other layers and colours, and also turned by 17°, mirrored, three beside each
other 10 mm apart and touching, and with each line in pieces of at most 3 mm
(`tests/support/cartons/rewritings.py`). Right, asked about and silently wrong are in per cent of
the edges; questions are for a file. A question is *of one type* if all its edges have one line
type; *most likely* counts the questions that name a most likely line type, and how many of them
name the one that most of their edges have.

| drawn with | and | right | asked | wrong | questions | of one type | most likely |
|---|---|--:|--:|--:|--:|--:|--:|
"""

AFTER_REWRITTEN = """
The 0200 has creases on its outline. The cut replaces them whatever they are called, so they are
right as cuts too; in a style of their own, a warning names them. With one style the questions are
about slits beside flaps, which look like folds, about the ends of folds beside slots, and about
half-cuts. Slits and folds are asked about separately. Three cartons that touch are examined like
single ones.
"""

#: Name of the layer and colour of each line type, by the name of the scheme; None for the colours
#: of the file on one layer.
STYLES: dict[str, dict[LineType, tuple[str, int]] | None] = {
    "one layer, the colours of the file": None,
    "one layer, one colour": dict.fromkeys(LineType, ("0", 7)),
    "one layer, the cut's colour also for dimensions": {
        kind: ("0", 7 if kind in (LineType.CUT, LineType.IGNORED) else kind) for kind in LineType
    },
    "layers P1, P2 … of one colour": {kind: (f"P{kind.value}", 7) for kind in LineType},
}
REWRITINGS: dict[str, Callable[[Drawing], tuple[Drawing, I64]]] = {
    "nothing else": lambda drawing: (drawing, np.arange(len(drawing))),
    "turned by 17°": lambda drawing: turned(drawing, 17.0),
    "mirrored": mirrored,
    "three-up": lambda drawing: three_up(drawing, 10.0),
    "three-up, touching": lambda drawing: three_up(drawing, 0.0),
    "in pieces of 3 mm": lambda drawing: in_pieces(drawing, 3.0),
}


def formats_table() -> str:
    """Return the rows of the table of formats."""
    return "\n".join(
        f"| {one.title} | {', '.join(one.extensions)} | {' | '.join(FORMAT_NOTES[one.name])} |"
        for one in FORMATS
    )


def files() -> Iterator[str]:
    """Yield the lines of the table of all files in the corpus."""
    rules = load.profile("default")
    for path in sorted(CORPUS.rglob("*")):
        if path.suffix.lower() not in (".dxf", ".cf2", ".svg"):
            continue
        name = path.relative_to(CORPUS).as_posix()
        start = time.perf_counter()
        try:
            drawing = pipeline.read(path.read_bytes())
        except KnifetipError as reason:
            yield f"| {name} | refused: {_cell(reason.text)} | | | | | | | | | |"
            continue
        dieline = pipeline.classify(drawing, rules)
        seconds = time.perf_counter() - start
        asked = pipeline.questions(drawing, dieline)
        outcomes = Counter(drawing.import_report.outcome.tolist())
        counts = " | ".join(str(outcomes[outcome]) for outcome in ImportOutcome)
        try:
            kinds = clean(dieline).dieline.line_type
            idle = (LineType.IGNORED, LineType.UNCLASSIFIED)
            machined = str(int((~np.isin(kinds, idle)).sum()))
        except KnifetipError as reason:
            machined = _cell(reason.text)
        yield (
            f"| {name} | {len(drawing.import_report)} | {counts} "
            f"| {len(drawing)} | {machined} | {drawing.unit or 'asked'} "
            f"| {count_by_type(dieline)} | {len(asked)} | {seconds:.3f} |"
        )


def count_by_type(dieline: Dieline) -> str:
    """Return the number of edges of each line type as text: ``cut 12, crease 4, asked 3``."""
    count = np.bincount(dieline.line_type, minlength=len(LineType))
    counts = [f"{kind.word} {count[kind]}" for kind in LineType if kind and count[kind]]
    return ", ".join([*counts, *([f"asked {count[0]}"] if count[0] else [])])


def known() -> Iterator[str]:
    """Yield the lines of the table of drawings whose line types are known, and of its totals."""
    rules, conventions = load.profile("default"), load.conventions()
    sums: dict[str, list[tuple[U8, U8, F64]]] = defaultdict(list)
    for one in KNOWN:
        complete = pipeline.read((CORPUS / one.path).read_bytes())
        kinds_of = one.truth(complete)
        variants = {
            "is": complete,
            "no names": without_names(complete),
            "one style": without_style(complete),
        }
        for variant, drawing in variants.items():
            dieline = classify(drawing, rules, conventions)
            asked = len(list_questions(drawing, dieline))
            replaced = replaced_by_cuts(drawing, kinds_of) & (dieline.line_type == LineType.CUT)
            correct = np.where(replaced, dieline.line_type, kinds_of)
            sums[variant].append((correct, dieline.line_type, drawing.lengths))
            yield _truth_row(Path(one.path).name, variant, *sums[variant][-1], asked)
    for variant, parts in sums.items():
        columns = [np.concatenate(column) for column in zip(*parts, strict=True)]
        truth_of, line_type, length = columns
        yield _truth_row("**all**", variant, truth_of, line_type, length, "")


def _truth_row(
    name: str, variant: str, truth: U8, line_type: U8, length: F64, asked: int | str
) -> str:
    fractions = (
        *classification_fractions(truth, line_type, np.ones(len(line_type))),
        *classification_fractions(truth, line_type, length),
    )
    return f"| {name} | {variant} | {' | '.join(f'{100 * x:.1f}' for x in fractions)} | {asked} |"


def companies() -> Iterator[str]:
    """Yield the lines of the table of cartons in the conventions of other companies."""
    yield BY_COMPANY.format(kinds=len(KINDS), companies=len(COMPANIES), languages=LANGUAGES).rstrip(
        "\n"
    )
    sums = []
    for company in COMPANIES:
        edges, lengths, asked, units = _company_figures(company)
        sums.append((edges, lengths, asked, units))
        yield _company_row(company.name, edges, lengths, asked / len(KINDS), units)
    units = sum((one[3] for one in sums), Counter())
    questions_ = sum(one[2] for one in sums) / len(KINDS) / len(COMPANIES)
    edges = np.sum([one[0] for one in sums], axis=0)
    lengths = np.sum([one[1] for one in sums], axis=0)
    yield _company_row("**all**", edges, lengths, questions_, units)
    yield AFTER_COMPANIES.rstrip("\n")


def _company_figures(company: Company) -> tuple[F64, F64, int, Counter[str]]:
    """Classify one carton of each kind in the conventions of a company.

    Returns
    -------
    edges, lengths : (3,)
        Number and length (mm) of the edges that are right, unclassified and wrong.
    questions : int
        Number of questions.
    units : Counter
        Number of drawings by result for the unit: "found", "asked" or "wrong".
    """
    rules = load.profile("default")
    edges, lengths, asked = np.zeros(3), np.zeros(3), 0
    units: Counter[str] = Counter()
    for seed in range(len(KINDS)):
        data, strokes, _ = company_file(company, seed)
        drawing = pipeline.read(data)
        kinds, _ = truth(drawing, strokes)
        dieline = pipeline.classify(drawing, rules)
        asked += len(pipeline.questions(drawing, dieline))
        corners = np.array([(s.x0, s.y0, s.x1, s.y1) for s in strokes]).reshape(-1, 2)
        times = np.ptp(drawing.ends.reshape(-1, 2), axis=0).max() / np.ptp(corners, axis=0).max()
        found = "found" if abs(times - 1.0) < 0.02 else "wrong"
        units[found if drawing.unit else "asked"] += 1
        unclassified = dieline.line_type == LineType.UNCLASSIFIED
        right = dieline.line_type == kinds
        for column, rows in enumerate((right, unclassified, ~right & ~unclassified)):
            edges[column] += rows.sum()
            lengths[column] += drawing.lengths[rows].sum() / times
    return edges, lengths, asked, units


def _company_row(name: str, edges: F64, lengths: F64, asked: float, units: Counter[str]) -> str:
    fractions = (
        f"{100 * fractions[0]:.1f} | {100 * fractions[1]:.1f} | {100 * fractions[2]:.3f}"
        for fractions in (edges / edges.sum(), lengths / lengths.sum())
    )
    counts = ", ".join(f"{what} {count}" for what, count in units.most_common())
    return f"| {name} | {' | '.join(fractions)} | {asked:.1f} | {counts} |"


def rewritten() -> Iterator[str]:
    """Yield the lines of the table of known cartons in other styles and positions."""
    cartons = []
    for one in KNOWN:
        drawing = pipeline.read((CORPUS / one.path).read_bytes())
        kinds = one.truth(drawing)
        if LineType.CREASE in kinds:
            cartons.append((replace(drawing, annotations=()), kinds))
    edges = sum(len(kinds) for _, kinds in cartons)
    yield REWRITTEN.format(cartons=len(cartons), edges=edges).rstrip("\n")
    for scheme, styles in STYLES.items():
        for name, rewrite in REWRITINGS.items():
            figures = np.zeros(8, np.int64)
            for drawing, kinds in cartons:
                styled = (
                    without_names(drawing) if styles is None else restyled(drawing, kinds, styles)
                )
                again, row = rewrite(styled)
                figures += _rewritten_figures(again, kinds[row])
            yield _rewritten_row(scheme, name, figures, len(cartons))
    yield AFTER_REWRITTEN.rstrip("\n")


def _rewritten_figures(drawing: Drawing, kinds: U8) -> I64:
    """Return the numbers of edges and of questions of a drawing with known line types, (8,).

    These are all edges, those that are right, asked about and silently wrong, and all questions,
    those of one type, those that name a most likely line type, and those that name the right one.
    """
    dieline = classify(drawing, load.profile("default"), load.conventions())
    asked = dieline.line_type == LineType.UNCLASSIFIED
    is_cut = dieline.line_type == LineType.CUT
    right = (dieline.line_type == kinds) | (is_cut & replaced_by_cuts(drawing, kinds))
    counts = [len(kinds), right.sum(), asked.sum(), (~asked & ~right).sum(), 0, 0, 0, 0]
    for question in list_questions(drawing, dieline):
        of_type = np.bincount(kinds[list(question.edges)])
        guess = question.message.arguments["guess"]
        named = guess is not None and guess.code == "question.guess"
        most = LineType(int(of_type.argmax())).word
        counts[4] += 1
        counts[5] += np.count_nonzero(of_type) == 1
        counts[6] += named
        counts[7] += named and guess.arguments["type"] == most
    return np.array(counts, np.int64)


def _rewritten_row(scheme: str, name: str, figures: I64, files: int) -> str:
    count, right, asked, silent, put, pure, named, likely = figures.tolist()
    return (
        f"| {scheme} | {name} | {100 * right / count:.1f} | {100 * asked / count:.1f} "
        f"| {100 * silent / count:.2f} | {put / files:.1f} | {pure} of {put} "
        f"| {likely} of {named} |"
    )


def _cell(text: str) -> str:
    return text.replace("|", "/").replace("\n", " ")


def main() -> None:
    """Write backend/docs/import.md."""
    head = HEAD.format(formats=formats_table())
    parts = [head.rstrip("\n"), *files(), TRUTH.rstrip("\n"), *known(), NOTES.rstrip("\n")]
    parts += [*rewritten(), *companies()]
    PAGE.write_text("\n".join(parts) + "\n", "utf-8")


if __name__ == "__main__":
    main()
