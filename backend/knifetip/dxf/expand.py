"""expand: every entity of the sheet and, through the INSERTs, of its blocks, where it stands.

    document, census -> Sheet: ledger rows in file order, and what is drawn with its placements

Nothing is expanded before it is counted: a few lines of nested arrays can stand for more lines
than there are atoms.  An entity that an INSERT repeats (rows and columns) has one ledger row and
as many placements.
"""

from __future__ import annotations

import time
from collections import defaultdict, deque
from collections.abc import Iterable
from typing import Any, Final, NamedTuple

import numpy as np
from ezdxf.document import Drawing as Document
from ezdxf.entities.dxfentity import DXFEntity

from knifetip.dxf.attributes import Styles, layers_of
from knifetip.dxf.census import Census, Counted
from knifetip.dxf.entities import READ, REASONS, Shape, Undrawable, drawn, flat, mirrored
from knifetip.dxf.shapes import moved, turning
from knifetip.errors import DrawingTooLarge, GeometryError
from knifetip.geometry.columns import F64, frozen
from knifetip.intake.columns import Style
from knifetip.intake.limits import Limits
from knifetip.intake.sheet import Sheet

#: The linear part of what no INSERT moves: most of a drawing, and nothing to be done.
ON_SHEET: Final[F64] = frozen(np.eye(2)[None], np.float64, 1, 2, 2)


class Placed(NamedTuple):
    """A shape, drawn k times: each point p at ``linear @ p + shift``."""

    row: int  #: of the ledger
    shape: Shape
    linear: F64  #: (k, 2, 2)
    shift: F64  #: (k, 2) file units
    style: Style


#: Why an entity is left out that the plotter sees and the knife does not.
IN_PAPER_SPACE: Final = "it stands in paper space"


def not_read(kind: str) -> str:
    """Return why entities of a kind are left out that is no line."""
    return REASONS.get(kind, f"{kind} is not a kind of line that is read")


def places(name: str) -> str:
    """Return what an INSERT does."""
    return f"places the block {name}"


def idle(name: str, number: int) -> str:
    """Return why a block of so many entities is left out."""
    why = (
        "it pictures a dimension or a hatch"
        if name.startswith("*")
        else "no INSERT places it on the sheet"
    )
    return f"the block {name} of {number} entit{'y' if number == 1 else 'ies'}: {why}"


class _Entry(NamedTuple):
    """An entity as counted, and as ezdxf read it, if it did."""

    counted: Counted
    handle: str
    entity: Any


class _Block(NamedTuple):
    name: str
    base: F64  #: (2,)
    external: bool
    entries: list[_Entry]


def expand(document: Document, census: Census, limits: Limits) -> tuple[Sheet, list[Placed]]:
    """Return the ledger's rows and the placed shapes of a document.

    Raises
    ------
    DrawingTooLarge
        INSERTs are nested deeper, or stand for more entities, than the limits allow.
    """
    walk = _Walk(document, census, limits)
    walk.sheet_entities()
    walk.idle_blocks()
    return walk.sheet, walk.placed


class _Walk:
    def __init__(self, document: Document, census: Census, limits: Limits) -> None:
        self.sheet = Sheet()
        self.placed: list[Placed] = []
        self.styles = Styles(layers_of(document))
        self.census = census
        self.limits = limits
        self.until = time.monotonic() + limits.seconds
        self.used: set[str] = set()
        on_sheet: list[DXFEntity] = list(document.modelspace())
        self.entries = _matched(census.entities, on_sheet)
        self.blocks: dict[str, _Block] = {}
        for key, block in census.blocks.items():
            layout = document.blocks.get(block.name) if block.name else None
            if layout is None or layout.block is None:
                continue
            head = layout.block.dxf
            base = head.get("base_point", (0.0, 0.0, 0.0))
            self.blocks[key] = _Block(
                block.name,
                np.array([float(base[0]), float(base[1])]),
                bool(layout.block.is_xref),
                _matched(block.entities, list(layout)),
            )
        self.endless = self._count()

    def _references(self, entries: Iterable[_Entry]) -> list[tuple[str, int]]:
        """Return the blocks that INSERTs refer to, each with how often it repeats them."""
        return [
            (_block_name(entry.entity).lower(), _columns(entry.entity) * _rows(entry.entity))
            for entry in entries
            if entry.counted.kind == "INSERT" and entry.entity is not None
        ]

    def _count(self) -> frozenset[str]:
        """Count what the INSERTs stand for; return the blocks that contain themselves."""
        inside = {name: self._references(block.entries) for name, block in self.blocks.items()}
        children = {
            name: {child for child, _ in found if child in inside} for name, found in inside.items()
        }
        parents: dict[str, set[str]] = {name: set() for name in children}
        for name, below in children.items():
            for child in below:
                parents[child].add(name)
        # What is left after all ends are plucked, from below and from above, goes in circles.
        _, rest = _plucked(children, parents)
        _, circles = _plucked(
            {name: parents[name] & rest for name in rest},
            {name: children[name] & rest for name in rest},
        )
        endless = frozenset(circles)
        straight = {name: children[name] - endless for name in children if name not in endless}
        above: dict[str, set[str]] = {name: set() for name in straight}
        for name, below in straight.items():
            for child in below:
                above[child].add(name)
        order, _ = _plucked(straight, above)
        size: dict[str, int] = {}
        depth: dict[str, int] = {}
        for name in order:
            size[name] = len(self.blocks[name].entries) + sum(
                times * max(size[child], 1) for child, times in inside[name] if child in straight
            )
            depth[name] = 1 + max((depth[child] for child in straight[name]), default=0)
        on_sheet = [(child, n) for child, n in self._references(self.entries) if child in straight]
        deepest = max((depth[child] for child, _ in on_sheet), default=0)
        if deepest > self.limits.insert_depth:
            raise DrawingTooLarge(
                f"Blocks are nested {deepest} deep; the limit is {self.limits.insert_depth}.",
                "Explode the blocks in the CAD program and export again.",
            )
        total = sum(times * max(size[child], 1) for child, times in on_sheet)
        if total > self.limits.expanded:
            # A number of a thousand digits helps nobody.
            many = f"{total:,}" if total < 10**15 else f"more than {10**15:,}"
            raise DrawingTooLarge(
                f"The blocks of the drawing stand for {many} entities; "
                f"the limit is {self.limits.expanded:,}.",
                "Export a single carton, or explode the blocks and delete the copies.",
            )
        return endless

    def sheet_entities(self) -> None:
        here = (ON_SHEET, np.zeros((1, 2)))
        for entry in self.entries:
            self._entry(entry, "", here, None)

    def idle_blocks(self) -> None:
        """Say of the blocks that nothing places that they hold lines and draw none."""
        for key, block in self.census.blocks.items():
            if key in self.used or not block.entities:
                continue
            why = idle(block.name, len(block.entities))
            self.sheet.row(block.handle or block.name, "BLOCK", block.layer, why)

    def _entry(self, entry: _Entry, path: str, here: tuple[F64, F64], around: Style | None) -> None:
        if time.monotonic() > self.until:
            raise DrawingTooLarge(
                f"The drawing takes longer than {self.limits.seconds:g} s to read.",
                "Export a single carton, or explode its blocks.",
            )
        counted = entry.counted
        handle = path + entry.handle
        if counted.paper:
            self.sheet.row(handle, counted.kind, counted.layer, IN_PAPER_SPACE)
            return
        if counted.kind not in READ and counted.kind != "INSERT":
            self.sheet.row(handle, counted.kind, counted.layer, not_read(counted.kind))
            return
        if entry.entity is not None and entry.entity.dxf.get("invisible", 0):
            self.sheet.row(handle, counted.kind, counted.layer, "it is marked as invisible")
            return
        if entry.entity is None:
            self.sheet.row(
                handle, counted.kind, counted.layer, "it is damaged, or only the frame of a text"
            )
            return
        try:
            style = self.styles.of(entry.entity, around)
            if counted.kind == "INSERT":
                self._insert(entry, handle, here, style)
                return
            what = drawn(entry.entity)
        except (Undrawable, GeometryError) as reason:
            text = reason.message if isinstance(reason, GeometryError) else str(reason)
            self.sheet.row(handle, counted.kind, counted.layer, text)
            return
        except (ArithmeticError, ValueError, TypeError, LookupError, AttributeError) as reason:
            # ezdxf's own readers stumble over damaged entities in all of these ways.
            self.sheet.row(handle, counted.kind, counted.layer, f"it is damaged: {reason}")
            return
        notes = [*self.styles.notes(style.layer), *what.notes]
        if len(here[0]) > 1:
            notes.append(f"drawn {len(here[0])} times")
        row = self.sheet.row(handle, counted.kind, style.layer, "", notes)
        self.placed.append(Placed(row, what.shape, *here, style))

    def _insert(self, entry: _Entry, handle: str, here: tuple[F64, F64], style: Style) -> None:
        dxf = entry.entity.dxf
        name = _block_name(entry.entity)
        block = self.blocks.get(name.lower())
        if block is None:
            raise Undrawable(f"its block {name!r} is not in the file")
        if name.lower() in self.endless:
            raise Undrawable(f"its block {name!r} contains itself")
        if block.external:
            raise Undrawable(f"its block {name!r} is in another file: bind it before exporting")
        mirror = mirrored(entry.entity)
        at = dxf.get("insert", (0.0, 0.0, 0.0))
        notes = flat((at[2],))
        scale = np.array([float(dxf.get("xscale", 1.0)), float(dxf.get("yscale", 1.0))])
        rotation = float(dxf.get("rotation", 0.0))
        columns, rows = _columns(entry.entity), _rows(entry.entity)
        spacing = np.array(
            [float(dxf.get("column_spacing", 0.0)), float(dxf.get("row_spacing", 0.0))]
        )
        numbers = np.concatenate([scale, [rotation], spacing, [at[0], at[1]], block.base])
        if not np.isfinite(numbers).all() or np.abs(numbers).max() > 1e100:
            raise Undrawable("its place, scale or rotation is not a number")
        if (scale == 0.0).any():
            raise Undrawable(f"its scale is {scale[0]:g} × {scale[1]:g}: nothing is left of it")
        if _clipped(entry.entity):
            notes.append("the clipping around it is not applied")
        self.used.add(name.lower())
        cells = columns * rows
        if cells > 1:
            notes.append(f"{columns} columns × {rows} rows")
        if len(here[0]) > 1:
            notes.append(f"drawn {len(here[0])} times")
        self.sheet.row(
            handle,
            "INSERT",
            style.layer,
            "",
            [places(block.name), *self.styles.notes(style.layer), *notes],
        )
        cos, sin = turning(rotation)
        turned = np.array([[cos, -sin], [sin, cos]])
        side = np.diag([-1.0 if mirror else 1.0, 1.0])
        linear = side @ turned * scale
        steps = np.stack(
            [np.tile(np.arange(columns), rows), np.repeat(np.arange(rows), columns)], axis=1
        )
        corner = moved(turned, np.array([at[0], at[1]]), steps * spacing) @ side.T
        shift = corner - moved(linear, np.zeros(2), block.base)
        outer_linear, outer_shift = here
        there = (
            np.repeat(_product(outer_linear, linear), cells, axis=0),
            moved(outer_linear[:, None], outer_shift[:, None], shift[None]).reshape(-1, 2),
        )
        for child in block.entries:
            self._entry(child, f"{handle}/", there, style)


def _product(outer: F64, inner: F64) -> F64:
    """Return the linear maps (k, 2, 2) that do the inner one first."""
    columns = moved(outer[:, None], np.zeros(2), inner.T[None])
    return columns.transpose(0, 2, 1)


def _block_name(insert: Any) -> str:
    return str(insert.dxf.get("name", ""))


def _columns(insert: Any) -> int:
    return max(int(insert.dxf.get("column_count", 1)), 1)


def _rows(insert: Any) -> int:
    return max(int(insert.dxf.get("row_count", 1)), 1)


def _clipped(insert: Any) -> bool:
    return bool(insert.has_extension_dict) and "ACAD_FILTER" in insert.get_extension_dict()


def _plucked(below: dict[str, set[str]], above: dict[str, set[str]]) -> tuple[list[str], set[str]]:
    """Return the names in an order in which each comes after all below it, and those without."""
    waiting = {name: len(found) for name, found in below.items()}
    ready = [name for name, number in waiting.items() if number == 0]
    for name in ready:
        for upper in above[name]:
            waiting[upper] -= 1
            if waiting[upper] == 0:
                ready.append(upper)
    return ready, set(waiting) - set(ready)


def _matched(counted: list[Counted], entities: list[DXFEntity]) -> list[_Entry]:
    """Pair what the file has with what ezdxf read: by handle, else in order of their kind."""
    by_handle: dict[tuple[str, str], deque[DXFEntity]] = defaultdict(deque)
    for entity in entities:
        by_handle[entity.dxftype(), str(entity.dxf.get("handle", "")).upper()].append(entity)
    found: dict[int, DXFEntity] = {}
    for number, one in enumerate(counted):
        if one.handle and (same := by_handle.get((one.kind, one.handle))):
            found[number] = same.popleft()
    taken = {id(entity) for entity in found.values()}
    by_kind: dict[str, deque[DXFEntity]] = defaultdict(deque)
    for entity in entities:
        if id(entity) not in taken:
            by_kind[entity.dxftype()].append(entity)
    entries: list[_Entry] = []
    for number, one in enumerate(counted):
        partner = found.get(number)
        if partner is None and not one.paper and (same := by_kind.get(one.kind)):
            partner = same.popleft()
        entries.append(_Entry(one, one.handle or f"#{number + 1}", partner))
    # What ezdxf found where the count saw nothing is not lost either.
    for entity in (entity for left in by_kind.values() for entity in left):
        dxf = entity.dxf
        extra = Counted(entity.dxftype(), "", str(dxf.get("layer", "0")), paper=False)
        entries.append(_Entry(extra, str(dxf.get("handle", "")) or f"#{len(entries) + 1}", entity))
    return entries
