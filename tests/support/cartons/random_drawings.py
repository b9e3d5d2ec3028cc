"""drawings of which the truth is known, as strangers might have drawn them.

A carton of a random kind and size, with holes, slits, perforations and half-cuts, is drawn by
somebody with layer names of some language, colours of some house, or neither; with a frame, a title
block, dimensions, dashes and doubled lines.  Every edge knows what it is.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace

import numpy as np

from knifetip.dxf import samples
from knifetip.geometry.columns import F64, U8
from knifetip.model.dieline import LineType
from knifetip.model.drawing import Drawing, Inscription, Ledger

CUT, CREASE, GROOVE = LineType.CUT, LineType.CREASE, LineType.V_GROOVE
PERFORATION, HALF_CUT, IGNORED = LineType.PERFORATION, LineType.HALF_CUT, LineType.IGNORED

#: Layer names by language: cut, crease, perforation, half-cut, V-groove, dimensions.
LANGUAGES = {
    "default": ("CUT", "CREASE", "PERF", "HALFCUT", "V-GROOVE", "DIMENSION"),
    "de": ("Schneidlinien", "Falzlinie", "Perforierung", "Anritzen", "V-Nut 45", "Maße"),
    "fr": ("Découpe", "Pli", "Perfo 3x3", "Coupe mi-chair", "Groove", "Cotes"),
    "it": ("Tagli", "Cordone 2pt", "Strappo", "Mezzo taglio", "V groove", "Quote"),
    "es": ("Línea de corte", "Pliegue", "Perforado", "Medio corte", "VCUT", "Cotas"),
    "nl": ("Snijden", "Vouwlijn", "Perforatie", "Kiss", "V-cut", "Maten"),
    "pl": ("Cięcie", "Bigi", "Perforacja", "Nadcięcie", "V-groove", "Wymiary"),
    "tr": ("Kesim", "Katlama", "Perfore", "Yarım kesim", "V-cut", "Ölçüler"),
    "ru": ("Вырубка", "Сгиб", "Перфорация 2х1", "Надсечка", "V-groove", "Размеры"),
    "zh": ("刀线层", "压痕线1", "齿刀", "半刀线", "V槽2", "尺寸标注"),
    "pt": ("Faca", "Vinco", "Picote", "Meio-corte", "V-cut", "Cotas"),
    "cs": ("Výsek", "Ohyb", "Perforace", "Nářez", "V-groove", "Kóty"),
}
#: Colours by house: cut, crease, perforation, half-cut, V-groove, dimensions.
HOUSES = {
    "red-cut-blue-crease": (1, 5, 6, 4, 30, 2),
    "pinits": (1, 3, 2, 40, 30, 255),
    "open-dieline": (7, 3, 1, 2, 30, 8),
    "red-crease-black-cut": (7, 1, 3, 4, 30, 8),
    "lightburn": (1, 5, 3, 4, 30, 2),
}
_KINDS = (CUT, CREASE, PERFORATION, HALF_CUT, GROOVE, IGNORED)
_FRIENDS = ("NoCut", "Cutout", "SCHNITTKANTEN", "Cut Lazer out line", "GEOMETRY-ENGRAVING")


@dataclass
class Sheet:
    """Edges with what they are, before somebody gives them layers and colours."""

    ends: list[tuple[float, float, float, float]] = field(default_factory=list)
    bulge: list[float] = field(default_factory=list)
    truth: list[LineType] = field(default_factory=list)
    dashed: list[bool] = field(default_factory=list)
    texts: list[Inscription] = field(default_factory=list)

    def line(
        self, x0: float, y0: float, x1: float, y1: float, truth: LineType, bulge: float = 0.0
    ) -> None:
        """Draw one edge."""
        self.ends.append((x0, y0, x1, y1))
        self.bulge.append(bulge)
        self.truth.append(truth)

    def ring(self, points: list[tuple[float, float]], truth: LineType) -> None:
        """Draw a closed polygon."""
        for (x0, y0), (x1, y1) in zip(points, points[1:] + points[:1], strict=True):
            self.line(x0, y0, x1, y1, truth)

    def circle(self, x: float, y: float, radius: float, truth: LineType) -> None:
        """Draw a circle as two half turns."""
        self.line(x - radius, y, x + radius, y, truth, 1.0)
        self.line(x + radius, y, x - radius, y, truth, 1.0)

    def rectangle(self, x0: float, y0: float, x1: float, y1: float, truth: LineType) -> None:
        """Draw a rectangle."""
        self.ring([(x0, y0), (x1, y0), (x1, y1), (x0, y1)], truth)

    def text(self, text: str, x: float, y: float, height: float, kind: str = "TEXT") -> None:
        """Write a text."""
        self.texts.append(Inscription(text, x, y, height, math.nan, kind, "TEXT"))


def slotted_case(rng: np.random.Generator) -> Sheet:
    """FEFCO 0201, with slots or with bare slits between the flaps."""
    sheet = Sheet()
    long, wide, high = rng.uniform(120, 500), rng.uniform(80, 300), rng.uniform(60, 400)
    slot = float(rng.choice([0.0, 6.0, 8.0]))
    glue, flap = 30.0, wide / 2.0
    x = np.cumsum([glue, long, wide, long, wide]).tolist()
    low, top, end = flap, flap + high, 2.0 * flap + high
    outline = [(glue, low), (0.0, low + 10.0), (0.0, top - 10.0), (glue, top)]
    for y, tip, order in ((top, end, range(4)), (low, 0.0, range(3, -1, -1))):
        for panel in order:
            left = x[panel] + (slot / 2.0 if panel else 0.0)
            right = x[panel + 1] - (slot / 2.0 if panel < 3 else 0.0)
            way = [(left, y), (left, tip), (right, tip), (right, y)]
            outline += way if y == top else way[::-1]
    if slot:
        sheet.ring([point for i, point in enumerate(outline) if point != outline[i - 1]], CUT)
    else:
        ring = [(glue, low), (0.0, low + 10.0), (0.0, top - 10.0), (glue, top), (glue, end)]
        sheet.ring([*ring, (x[4], end), (x[4], 0.0), (glue, 0.0)], CUT)
        for at in x[1:4]:
            sheet.line(at, 0.0, at, low, CUT)
            sheet.line(at, top, at, end, CUT)
    for at in x[:4]:
        sheet.line(at, low, at, top, CREASE)
    inset = slot / 2.0
    for y in (low, top):
        for panel in range(4):
            left = x[panel] + (inset if panel else 0.0)
            right = x[panel + 1] - (inset if panel < 3 else 0.0)
            sheet.line(left, y, right, y, CREASE)
    if slot:
        # The creases of the body end in the middle of a slot: it is open, so they stop at its end.
        pass
    return sheet


def tray(rng: np.random.Generator) -> Sheet:
    """A tray with glued corners: slits, or notches, beside the corner flaps."""
    sheet = Sheet()
    long, wide, high = rng.uniform(80, 400), rng.uniform(60, 300), rng.uniform(25, 90)
    notch = float(rng.choice([0.0, 2.0]))
    for side in (0.0, wide):
        sheet.line(0.0, side, long, side, CREASE)
    for side in (0.0, long):
        sheet.line(side, 0.0, side, wide, CREASE)
        sheet.line(side, 0.0, side, -high, CREASE)
        sheet.line(side, wide, side, wide + high, CREASE)
    if notch:
        ring = [(-high, -high), (long + high, -high)]
        ring += [(long + high, -notch), (long, -notch), (long, 0.0), (long + high, notch)]
        ring += [(long + high, wide - notch), (long, wide), (long, wide + notch)]
        ring += [(long + high, wide + notch), (long + high, wide + high), (-high, wide + high)]
        ring += [(-high, wide + notch), (0.0, wide + notch), (0.0, wide), (-high, wide - notch)]
        ring += [(-high, notch), (0.0, 0.0), (0.0, -notch), (-high, -notch)]
        sheet.ring(ring, CUT)
    else:
        sheet.rectangle(-high, -high, long + high, wide + high, CUT)
        for y in (0.0, wide):
            sheet.line(-high, y, 0.0, y, CUT)
            sheet.line(long, y, long + high, y, CUT)
    return sheet


def _sampled(parts: list[tuple[samples.Layer, samples.Paths]]) -> Sheet:
    kinds = {"CUT": CUT, "CREASE": CREASE, "V-GROOVE": GROOVE}
    sheet = Sheet()
    for layer, paths in parts:
        for start, end, bulge in zip(paths.start, paths.end, paths.bulge, strict=True):
            sheet.line(*start.tolist(), *end.tolist(), kinds[layer.name], float(bulge))
    return sheet


def tuck_end(rng: np.random.Generator) -> Sheet:
    """A reverse tuck-end carton."""
    return _sampled(
        samples.tuck_end_carton(rng.uniform(60, 160), rng.uniform(35, 70), rng.uniform(80, 220))
    )


def rolled_tray(_rng: np.random.Generator) -> Sheet:
    """A tray with rolled-over ends: double creases, and slots on them."""
    return _sampled(samples.corrugated_tray())


def rigid_box(_rng: np.random.Generator) -> Sheet:
    """A grooved blank, in which nothing is creased."""
    return _sampled(samples.rigid_box_blank())


def sleeve(rng: np.random.Generator) -> Sheet:
    """Four panels and a glue flap, with a perforation across that tears open."""
    sheet = Sheet()
    x = np.cumsum([0.0, 15.0, *rng.uniform(40, 160, 2)]).tolist()
    x += [x[-1] + x[2] - x[1], x[-1] + x[3] - x[1]]
    high = rng.uniform(60, 250)
    x = sorted(set(x))
    sheet.rectangle(0.0, 0.0, x[-1], high, CUT)
    for at in x[1:-1]:
        sheet.line(at, 0.0, at, high, CREASE)
    if rng.random() < 0.5:
        sheet.line(0.0, high * 0.3, x[-1], high * 0.3, PERFORATION)
    return sheet


CARTONS = (slotted_case, slotted_case, tray, tray, tuck_end, sleeve, rolled_tray, rigid_box)


def _furnished(sheet: Sheet, rng: np.random.Generator) -> None:
    """Add holes, slits and half-cuts inside the largest panel that is left free by guesswork."""
    ends = np.array(sheet.ends).reshape(-1, 2)
    low, high = ends.min(axis=0), ends.max(axis=0)
    for _ in range(int(rng.integers(0, 4))):
        x, y = rng.uniform(low, high)
        size = rng.uniform(4.0, 12.0)
        if not _free(sheet, x, y, 1.8 * size) or not _within(sheet, x, y):
            continue
        what = rng.choice(["circle", "window", "slit", "half"])
        if what == "circle":
            sheet.circle(x, y, size, CUT)
        elif what == "window":
            sheet.rectangle(x - size, y - size / 2, x + size, y + size / 2, CUT)
        elif what == "slit":
            sheet.line(x - size, y, x + size, y, CUT)
        else:
            sheet.circle(x, y, size, HALF_CUT)


def _free(sheet: Sheet, x: float, y: float, room: float) -> bool:
    """Return whether no edge comes near a point, arcs taken as their chords."""
    ends = np.array(sheet.ends)
    a, d = ends[:, :2], ends[:, 2:] - ends[:, :2]
    share = ((np.array([x, y]) - a) * d).sum(axis=1) / np.maximum((d * d).sum(axis=1), 1e-12)
    near = a + np.clip(share, 0.0, 1.0)[:, None] * d
    sagitta = 0.5 * np.abs(sheet.bulge) * np.hypot(*d.T)
    return bool((np.hypot(*(near - [x, y]).T) - sagitta).min() > room)


def _within(sheet: Sheet, x: float, y: float) -> bool:
    """Return whether a point lies inside the cuts that were drawn first, by crossing them."""
    odd = False
    for (x0, y0, x1, y1), kind in zip(sheet.ends, sheet.truth, strict=True):
        if kind == CUT and (y0 > y) != (y1 > y) and x < x0 + (y - y0) * (x1 - x0) / (y1 - y0):
            odd = not odd
    return odd


def _decorated(sheet: Sheet, rng: np.random.Generator) -> None:
    """Add dimensions, a title block and a frame."""
    ends = np.array(sheet.ends).reshape(-1, 2)
    (x0, y0), (x1, y1) = ends.min(axis=0).tolist(), ends.max(axis=0).tolist()
    if rng.random() < 0.4:
        for level in (20.0, 35.0):
            y = y0 - level
            sheet.line(x0, y, x1, y, IGNORED)
            for x, way in ((x0, 1.0), (x1, -1.0)):
                sheet.line(x, y, x + way * 4.0, y + 1.0, IGNORED)
                sheet.line(x, y, x + way * 4.0, y - 1.0, IGNORED)
                sheet.line(x, y0 - 2.0, x, y - 3.0, IGNORED)
            sheet.text(f"{x1 - x0:.1f}", (x0 + x1) / 2.0, y + 1.0, 4.0, "DIMENSION")
    if rng.random() < 0.3:
        left, right, low, top = x0 - 60.0, x1 + 60.0, y0 - 120.0, y1 + 60.0
        sheet.rectangle(left, low, right, top, IGNORED)
        for row in range(3):
            y = low + 12.0 * (row + 1)
            sheet.line(right - 90.0, y, right, y, IGNORED)
            sheet.text("Kunde", right - 86.0, y - 9.0, 4.0)
        sheet.line(right - 90.0, low, right - 90.0, low + 36.0, IGNORED)


def drawing(seed: int) -> tuple[Drawing, U8, str]:
    """Return a drawing, what each of its edges is, (n,) LineType, and how it was drawn."""
    rng = np.random.default_rng(seed)
    make = CARTONS[int(rng.integers(len(CARTONS)))]
    sheet = make(rng)
    if rng.random() < 0.3:
        folds = [row for row, kind in enumerate(sheet.truth) if kind == CREASE]
        if folds:
            sheet.truth[folds[int(rng.integers(len(folds)))]] = PERFORATION
    if rng.random() < 0.6:
        _furnished(sheet, rng)
    scheme = str(
        rng.choice(
            ["default", "words", "house", "colours", "nothing", "friends", "swapped"],
            p=[0.2, 0.2, 0.2, 0.12, 0.15, 0.06, 0.07],
        )
    )
    _decorated(sheet, rng)
    ends, bulge = np.array(sheet.ends).reshape(-1, 2, 2), np.array(sheet.bulge)
    truth = np.array([int(kind) for kind in sheet.truth])
    if rng.random() < 0.25:
        ends, bulge, truth = _dashes(ends, bulge, truth)
    if rng.random() < 0.3:
        twice = rng.random(len(truth)) < 0.1
        ends = np.concatenate([ends, ends[twice][:, ::-1]])
        bulge = np.concatenate([bulge, -bulge[twice]])
        truth = np.concatenate([truth, truth[twice]])
    if rng.random() < 0.5:
        ends = ends + rng.uniform(-0.02, 0.02, ends.shape)
    order = rng.permutation(len(truth))
    ends, bulge, truth = ends[order], bulge[order], truth[order]
    if scheme == "nothing":
        # Who has one style draws no perforation and no half-cut in it: nobody could know.
        truth[truth == PERFORATION] = CREASE
        truth[truth == HALF_CUT] = CUT
    names, colours, dashed = _scheme(scheme, rng)
    kinds = [int(kind) for kind in _KINDS]
    which = np.array([kinds.index(value) for value in truth.tolist()])
    layers = tuple(dict.fromkeys(names))
    layer = np.array([layers.index(name) for name in names])[which]
    style = np.array([1 if dashed and kind == CREASE else 0 for kind in _KINDS])[which]
    count = len(truth)
    ledger = Ledger(
        tuple(f"{row:X}" for row in range(count)),
        tuple("LINE" if not bend else "ARC" for bend in bulge.tolist()),
        tuple(layers[row] for row in layer.tolist()),
        np.zeros(count, np.uint8),
        ("kept",) * count,
        np.ones(count),
    )
    made = Drawing(
        ends, bulge, np.arange(count), layer, np.array(colours)[which], np.full(count, -1), style,
        layers, ("CONTINUOUS", "DASHED"), ledger, "mm", "given", "mm", tuple(sheet.texts),
    )  # fmt: skip
    return made, truth.astype(np.uint8), f"{make.__name__} / {scheme}"


def mislaid(drawing: Drawing, truth: U8, kind: LineType, seed: int) -> int | None:
    """Return a row of this kind to be moved to a wrong layer, None where there is none."""
    rows = np.flatnonzero((truth == kind) & (drawing.lengths > 10.0))
    return int(np.random.default_rng(seed).choice(rows)) if len(rows) else None


def relayered(drawing: Drawing, row: int, layer: str) -> Drawing:
    """Return the drawing with one edge on another of its layers."""
    moved = np.array(drawing.layer)
    moved[row] = drawing.layers.index(layer)
    return replace(drawing, layer=moved)


def _dashes(ends: F64, bulge: F64, truth: U8) -> tuple[F64, F64, U8]:
    """Draw the straight creases as rows of dashes, 6 mm and 3 mm apart."""
    out: list[tuple[F64, float, int]] = []
    for edge, bend, kind in zip(ends, bulge.tolist(), truth.tolist(), strict=True):
        long = float(np.hypot(*(edge[1] - edge[0])))
        if kind != CREASE or bend or long < 40.0:
            out.append((edge, bend, kind))
            continue
        step = (edge[1] - edge[0]) / long
        count = round((long + 3.0) / 9.0)
        dash = (long - 3.0 * (count - 1)) / count
        for k in range(count):
            at = edge[0] + step * k * (dash + 3.0)
            out.append((np.array([at, at + step * dash]), 0.0, kind))
    return (
        np.array([edge for edge, _, _ in out]),
        np.array([bend for _, bend, _ in out]),
        np.array([kind for _, _, kind in out]),
    )


def _scheme(scheme: str, rng: np.random.Generator) -> tuple[list[str], list[int], bool]:
    """Return layer name and colour of each kind, and whether creases have a dashed linetype."""
    dashed = bool(rng.random() < 0.3)
    house = HOUSES[str(rng.choice(list(HOUSES)))]
    plain = str(rng.choice(["0", "Layer 1", "Default", "Ebene 3"]))
    if scheme == "default":
        return list(LANGUAGES["default"]), list(house), dashed
    if scheme == "words":
        return list(LANGUAGES[str(rng.choice(list(LANGUAGES)[1:]))]), [7] * 6, dashed
    if scheme == "house":
        return [plain] * 6, list(house), dashed
    if scheme == "colours":
        return [plain] * 6, rng.permutation([1, 2, 3, 4, 5, 6, 30, 40])[:6].tolist(), False
    if scheme == "nothing":
        return [plain] * 6, [7] * 6, False
    if scheme == "friends":
        names = [str(rng.choice(_FRIENDS)), *["Faltmarken"] * 4, "INFO"]
        return names, list(house), False
    swapped = list(LANGUAGES["default"])
    swapped[0], swapped[1] = swapped[1], swapped[0]
    return swapped, list(house), False
