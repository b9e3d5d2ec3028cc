"""Write the table of import and classification results of the corpus to backend/docs/import.md.

    .venv/bin/python -m tests.benchmarks.import_table

The page has every file, with its import report and classification; drawings with known line types,
also without layer names and without any style; cartons in the conventions of other companies; and
generated drawings with known line types, by decile of confidence and by scheme of styles.
"""

from __future__ import annotations

import time
from collections import Counter, defaultdict
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from knifetip import pipeline
from knifetip.classification.classify import classify
from knifetip.classification.questions import list_questions
from knifetip.cleaning.clean import clean
from knifetip.errors import KnifetipError
from knifetip.geometry.columns import F64, I64, U8
from knifetip.library import load
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.drawing import ImportOutcome
from knifetip.model.profile import LineRules
from tests.conftest import CORPUS, ROOT
from tests.support.cartons.companies import COMPANIES, Company
from tests.support.cartons.company_files import company_file, truth
from tests.support.cartons.kinds import KINDS
from tests.support.cartons.random_drawings import misplaced_edge, on_layer, random_drawing
from tests.support.truth.known_types import (
    KNOWN,
    classification_fractions,
    without_names,
    without_style,
)

SEEDS = 3000
#: Languages of the layer names of companies.
LANGUAGES = 20
PAGE = ROOT / "backend" / "docs" / "import.md"

HEAD = """# Import of drawings from other sources

Made by `python -m tests.benchmarks.import_table`; times are of one run on a shared two-core
machine, the kernels warm.

![The page: one question, and the dropped entities with their positions](import.png)

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
Errors with *one style*: four creases of the 0200 are drawn on its outline, where the cut replaces
them in any case; the box of InkPacking lacks the top edge of a panel, so that three creases have a
panel on one side only; the crosses beside the CF2 are not cut, although their line type is cut.
With the colours and linetypes of the files all of them are right, or asked about.
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
question each); and the unit, if neither the header nor a text states it. With other sizes two kinds
of lines were classified wrong: arrowheads whose ends happen to be on another line, and the shared
cuts of several blanks in one style that have too few equal panels to be recognised as several.
"""

DECILES = """
## Generated drawings: {seeds:,} cartons, {edges:,} edges

Slotted cases, trays, tuck-end and sleeve cartons, rolled trays and grooved blanks, with holes,
slits, perforations and half-cuts, drawn with frames, title blocks, dimensions, dashes, doubled
lines and ends 0.02 mm off (`tests/support/cartons/random_drawings.py`). Confidence is the
confidence of the guess, whether it was asked about or not; guesses below 0.8 are asked about.

| confidence | edges | wrong guesses | error rate |
|---|--:|--:|--:|
"""

DRAWN = """
| drawn with | edges | right % | asked % | silently wrong % | questions per drawing |
|---|--:|--:|--:|--:|--:|
"""

MISPLACED = """
## One line on the wrong layer

The cartons above with the layers CUT and CREASE; in each carton one line is moved to the other
layer. A cut on the layer of the creases is recognised on the outline. A crease on the layer of the
cuts may be a slit: it is recognised if its mirror image is a fold, or if it would cut off a panel.

| moved | drawings | asked about | silently wrong |
|---|--:|--:|--:|
"""

SCHEMES = {
    "default": "layer names of the default profile",
    "words": "layer names in ten languages, one colour",
    "company": "one layer, the colours of one company",
    "colours": "one layer, colours by chance",
    "nothing": "one layer, one colour",
    "misleading": "layer names that mislead (NoCut, Faltmarken …)",
    "swapped": "cut and crease exchanged",
}


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
            sums[variant].append((kinds_of, dieline.line_type, drawing.lengths))
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


def generated() -> Iterator[str]:
    """Yield the lines of the tables of generated cartons."""
    rules, conventions = load.profile("default"), load.conventions()
    decile = np.zeros((10, 2), int)
    variants: dict[str, I64] = defaultdict(lambda: np.zeros(6, int))
    wrong: Counter[str] = Counter()
    for seed in range(SEEDS):
        drawing, kinds_of, how = random_drawing(seed)
        dieline = classify(drawing, rules, conventions)
        best = np.array([one[0] if one else 0 for one in dieline.alternatives], np.uint8)
        asked = dieline.line_type == LineType.UNCLASSIFIED
        guess = np.where(asked, best[dieline.rule], dieline.line_type)
        line_type = guess != LineType.UNCLASSIFIED
        step = np.minimum((dieline.confidence[line_type] * 10.0 + 1e-9).astype(int), 9)
        np.add.at(decile, (step, 0), 1)
        np.add.at(decile, (step, 1), guess[line_type] != kinds_of[line_type])
        silent = ~asked & (guess != kinds_of)
        variants[how.split(" / ")[1]] += (
            len(kinds_of),
            int((~asked & ~silent).sum()),
            int(asked.sum()),
            int(silent.sum()),
            len(list_questions(drawing, dieline)),
            1,
        )
        for row in np.flatnonzero(silent).tolist():
            kinds = LineType(int(kinds_of[row])).word, LineType(int(guess[row])).word
            wrong[f"{how}: {kinds[0]} taken for {kinds[1]}"] += 1
    edges = int(sum(row[0] for row in variants.values()))
    yield DECILES.format(seeds=SEEDS, edges=edges).rstrip("\n")
    for step, (count, off) in enumerate(decile.tolist()):
        if count:
            between = f"{step / 10:.1f} … {(step + 1) / 10:.1f}"
            yield f"| {between} | {count:,} | {off:,} | {off / count:.3%} |"
    yield DRAWN.rstrip("\n")
    total = np.zeros(6, int)
    for variant, label in SCHEMES.items():
        total += variants[variant]
        yield _scheme_row(label, variants[variant])
    yield _scheme_row("**all**", total)
    yield from _misplaced_rows(rules, conventions)
    yield (
        "\nSilently wrong in the drawings without such a mistake: "
        + ("; ".join(f"{count} × {what}" for what, count in wrong.most_common()) or "none")
        + "."
    )


def _misplaced_rows(rules: LineRules, conventions: tuple[LineRules, ...]) -> Iterator[str]:
    yield MISPLACED.rstrip("\n")
    for kind, layer in ((LineType.CUT, "CREASE"), (LineType.CREASE, "CUT")):
        drawings = caught = 0
        for seed in range(SEEDS):
            drawing, kinds_of, how = random_drawing(seed)
            row = misplaced_edge(drawing, kinds_of, kind, seed) if how.endswith("default") else None
            if row is None or layer not in drawing.layers:
                continue
            line_type = classify(on_layer(drawing, row, layer), rules, conventions).line_type[row]
            drawings += 1
            caught += line_type == LineType.UNCLASSIFIED
        share = 100.0 * caught / max(drawings, 1)
        yield (
            f"| a {kind.word} to layer {layer} | {drawings} | {caught} ({share:.0f} %) "
            f"| {drawings - caught} |"
        )


def _scheme_row(label: str, row: I64) -> str:
    count, right, asked, silent, put, drawings = row.tolist()
    return (
        f"| {label} | {count:,} | {100 * right / count:.2f} | {100 * asked / count:.2f} "
        f"| {100 * silent / count:.4f} | {put / drawings:.1f} |"
    )


def _cell(text: str) -> str:
    return text.replace("|", "/").replace("\n", " ")


def main() -> None:
    """Write backend/docs/import.md."""
    parts = [HEAD.rstrip("\n"), *files(), TRUTH.rstrip("\n"), *known(), NOTES.rstrip("\n")]
    parts += [*companies(), *generated()]
    PAGE.write_text("\n".join(parts) + "\n", "utf-8")


if __name__ == "__main__":
    main()
