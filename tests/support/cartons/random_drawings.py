"""Random drawings in which the line type of every edge is known.

A carton of a random kind and size, with holes, slits, perforations and half-cuts, is drawn with
layer names in some language, with the colours of some drawing office, or with neither; some
drawings have a frame, a title block, dimensions, dashes and doubled lines.
"""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from knifetip.geometry.columns import F64, U8
from knifetip.model.dieline import LineType
from knifetip.model.drawing import Annotation, Drawing
from tests.support.cartons.kinds import (
    rigid_box,
    rolled_tray,
    sleeve,
    slotted_case,
    tray,
    tuck_end,
)
from tests.support.cartons.plan import Plan
from tests.support.drawings import Header, drawing

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
#: Colours by drawing office: cut, crease, perforation, half-cut, V-groove, dimensions.
COLOURS = {
    "red-cut-blue-crease": (1, 5, 6, 4, 30, 2),
    "pinits": (1, 3, 2, 40, 30, 255),
    "open-dieline": (7, 3, 1, 2, 30, 8),
    "red-crease-black-cut": (7, 1, 3, 4, 30, 8),
    "lightburn": (1, 5, 3, 4, 30, 2),
}
CARTONS = (
    slotted_case, slotted_case, tray, tray, tuck_end, sleeve, rolled_tray, rigid_box,
)  # fmt: skip
_KINDS = (CUT, CREASE, PERFORATION, HALF_CUT, GROOVE, IGNORED)
#: Layer names in which a word for one line type names another.
_MISLEADING = ("NoCut", "Cutout", "SCHNITTKANTEN", "Cut Lazer out line", "GEOMETRY-ENGRAVING")


def _add_holes(plan: Plan, rng: np.random.Generator) -> None:
    """Add up to three holes, slits and half-cuts at random positions inside panels."""
    low, high = _corners(plan)
    for _ in range(int(rng.integers(0, 4))):
        x, y = rng.uniform(low, high)
        size = rng.uniform(4.0, 12.0)
        if not _is_free(plan, x, y, 1.8 * size) or not _is_inside(plan, x, y):
            continue
        shape = rng.choice(["circle", "window", "slit", "half"])
        if shape == "circle":
            plan.circle(x, y, size, "inner")
        elif shape == "window":
            plan.rectangle(x - size, y - size / 2, x + size, y + size / 2, "inner")
        elif shape == "slit":
            plan.line(x - size, y, x + size, y, "inner")
        else:
            plan.circle(x, y, size, "half-cut")


def _corners(plan: Plan) -> tuple[F64, F64]:
    """Return the lower left and upper right corner of the bounding box of all stroke ends, (2,)
    each.
    """
    ends = plan.ends.reshape(-1, 2)
    return ends.min(axis=0), ends.max(axis=0)


def _is_free(plan: Plan, x: float, y: float, room: float) -> bool:
    """Return whether all strokes are farther than ``room`` (mm) from (x, y).

    Arcs are replaced by their chords.
    """
    a = plan.ends[:, 0]
    d = plan.ends[:, 1] - a
    share = ((np.array([x, y]) - a) * d).sum(axis=1) / np.maximum((d * d).sum(axis=1), 1e-12)
    nearest = a + np.clip(share, 0.0, 1.0)[:, None] * d
    sagitta = 0.5 * np.abs(plan.bulge) * np.hypot(*d.T)
    return bool((np.hypot(*(nearest - [x, y]).T) - sagitta).min() > room)


def _is_inside(plan: Plan, x: float, y: float) -> bool:
    """Return whether (x, y) is inside the outline, by the number of cuts that a ray crosses."""
    odd = False
    for s in plan.strokes:
        crosses = (s.y0 > y) != (s.y1 > y) and s.truth == CUT
        if crosses and x < s.x0 + (y - s.y0) * (s.x1 - s.x0) / (s.y1 - s.y0):
            odd = not odd
    return odd


def _add_annotations(plan: Plan, rng: np.random.Generator) -> None:
    """Add dimensions, a title block and a frame, each with some probability."""
    (x0, y0), (x1, y1) = (corner.tolist() for corner in _corners(plan))
    if rng.random() < 0.4:
        for level in (20.0, 35.0):
            y = y0 - level
            plan.line(x0, y, x1, y, "dimension")
            for x, way in ((x0, 1.0), (x1, -1.0)):
                plan.line(x, y, x + way * 4.0, y + 1.0, "dimension")
                plan.line(x, y, x + way * 4.0, y - 1.0, "dimension")
                plan.line(x, y0 - 2.0, x, y - 3.0, "dimension")
            plan.text(f"{x1 - x0:.1f}", (x0 + x1) / 2.0, y + 1.0, 4.0, "dimension")
    if rng.random() < 0.3:
        left, right, low, top = x0 - 60.0, x1 + 60.0, y0 - 120.0, y1 + 60.0
        plan.rectangle(left, low, right, top, "frame")
        for row in range(3):
            y = low + 12.0 * (row + 1)
            plan.line(right - 90.0, y, right, y, "frame")
            plan.text("Kunde", right - 86.0, y - 9.0, 4.0)
        plan.line(right - 90.0, low, right - 90.0, low + 36.0, "frame")


def _random_plan(rng: np.random.Generator) -> tuple[Plan, str, str]:
    """Return a random plan, the name of its carton kind, and the name of a scheme of styles."""
    make = CARTONS[int(rng.integers(len(CARTONS)))]
    plan = make(rng)
    if rng.random() < 0.3:
        creases = [row for row, s in enumerate(plan.strokes) if s.part == "crease"]
        if creases:
            row = creases[int(rng.integers(len(creases)))]
            plan.strokes[row] = replace(plan.strokes[row], part="perforation")
    if rng.random() < 0.6:
        _add_holes(plan, rng)
    scheme = str(
        rng.choice(
            ["default", "words", "company", "colours", "nothing", "misleading", "swapped"],
            p=[0.2, 0.2, 0.2, 0.12, 0.15, 0.06, 0.07],
        )
    )
    _add_annotations(plan, rng)
    return plan, make.__name__, scheme


def random_drawing(seed: int) -> tuple[Drawing, U8, str]:
    """Return a random drawing.

    Returns
    -------
    drawing : Drawing
    truth : (n,) LineType
        The correct line type of each edge.
    name : str
        "kind of carton / scheme of styles".
    """
    rng = np.random.default_rng(seed)
    plan, kind, scheme = _random_plan(rng)
    ends, bulge, truth = plan.ends, plan.bulge, plan.truth
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
        # If all lines have one style, a perforation cannot be distinguished from a crease.
        truth[truth == PERFORATION] = CREASE
        truth[truth == HALF_CUT] = CUT
    names, colours, dashed = _scheme(scheme, rng)
    style_of = {
        int(kind): (name, colour, "DASHED" if dashed and kind == CREASE else "CONTINUOUS")
        for kind, name, colour in zip(_KINDS, names, colours, strict=True)
    }
    styles = [style_of[kind] for kind in truth.tolist()]
    header = Header("mm", "mm", _annotations(plan), tuple(names), ("CONTINUOUS", "DASHED"))
    return drawing(ends, styles, bulge=bulge, header=header), truth, f"{kind} / {scheme}"


def _annotations(plan: Plan) -> tuple[Annotation, ...]:
    return tuple(
        Annotation(
            text, x, y, height, math.nan, "DIMENSION" if part == "dimension" else "TEXT", "TEXT"
        )
        for text, x, y, height, part in plan.texts
    )


def _dashes(ends: F64, bulge: F64, truth: U8) -> tuple[F64, F64, U8]:
    """Return ends, bulges and line types with each straight crease replaced by a row of dashes.

    Dashes are 6 mm long with gaps of 3 mm.
    """
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
        np.array([kind for _, _, kind in out], np.uint8),
    )


def _scheme(scheme: str, rng: np.random.Generator) -> tuple[list[str], list[int], bool]:
    """Return the styles of a scheme.

    Returns
    -------
    layers, colours : list
        Layer name and colour of each part.
    dashed : bool
        Whether creases have a dashed linetype.
    """
    dashed = bool(rng.random() < 0.3)
    colours = COLOURS[str(rng.choice(list(COLOURS)))]
    layer = str(rng.choice(["0", "Layer 1", "Default", "Ebene 3"]))
    if scheme == "default":
        return list(LANGUAGES["default"]), list(colours), dashed
    if scheme == "words":
        return list(LANGUAGES[str(rng.choice(list(LANGUAGES)[1:]))]), [7] * 6, dashed
    if scheme == "company":
        return [layer] * 6, list(colours), dashed
    if scheme == "colours":
        return [layer] * 6, rng.permutation([1, 2, 3, 4, 5, 6, 30, 40])[:6].tolist(), False
    if scheme == "nothing":
        return [layer] * 6, [7] * 6, False
    if scheme == "misleading":
        names = [str(rng.choice(_MISLEADING)), *["Faltmarken"] * 4, "INFO"]
        return names, list(colours), False
    swapped = list(LANGUAGES["default"])
    swapped[0], swapped[1] = swapped[1], swapped[0]
    return swapped, list(colours), False
