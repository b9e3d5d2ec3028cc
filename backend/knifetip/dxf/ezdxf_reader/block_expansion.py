"""block_expansion: replace each INSERT of a drawing by the entities of the block that it places.

The result is the import report, with its rows in file order, and the shapes of the entities with
their placements.  The fast reader and the ezdxf reader use this module; each of them implements
``SourceEntity``.  The entities are counted before any block is expanded, because a few nested
arrays of blocks can expand to billions of lines.  If an INSERT repeats its block in a grid, each
entity of the block has one row in the import report and one placement per repetition.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Final, NamedTuple, Protocol

import numpy as np

from knifetip.drawing_builder.columns import Style
from knifetip.drawing_builder.line_widths import hundredths
from knifetip.drawing_builder.report import ReportWriter
from knifetip.drawing_builder.visibility import INVISIBLE
from knifetip.dxf.attributes import Styles
from knifetip.dxf.ezdxf_reader.entities import (
    NEVER_CUT,
    READ,
    REASONS,
    EntityShape,
    Shape,
    Undrawable,
    height_notes,
)
from knifetip.dxf.ezdxf_reader.prescan import PrescannedEntity
from knifetip.dxf.location_boxes import transformed_box
from knifetip.dxf.shapes import cos_sin, map_points
from knifetip.errors import DrawingTooLarge, GeometryError
from knifetip.formats.limits import Limits
from knifetip.geometry.columns import F64, freeze
from knifetip.messages import Message

#: Linear map of entities outside of blocks: the identity.
ON_SHEET: Final[F64] = freeze(np.eye(2)[None], np.float64, 1, 2, 2)

_IN_PAPER_SPACE: Final = Message("import.paper-space")
_ANNOTATION_IN_PAPER_SPACE: Final = Message("import.paper-space-annotation")


class PlacedShape(NamedTuple):
    """The shape of an entity with its k placements in model space.

    Placement i moves each point p of the shape to ``linear[i] @ p + shift[i]``.
    """

    row: int  #: row of the shape in the import report
    shape: Shape
    linear: F64  #: (k, 2, 2) linear maps
    shift: F64  #: (k, 2) translations (file units)
    style: Style


class Reference(NamedTuple):
    """Placement of a block by an INSERT: block name, position, scale, rotation and repetition."""

    block: str
    mirror: bool
    position: tuple[float, float, float]
    scale: tuple[float, float]
    rotation: float  #: degrees
    cells: tuple[int, int]  #: numbers of columns and rows in which the block is repeated
    spacing: tuple[float, float]
    clipped: bool


class SourceEntity(Protocol):
    """Interface of a DXF entity, implemented by the fast reader and by the ezdxf reader."""

    @property
    def hidden(self) -> bool:
        """Whether the entity is marked as invisible."""
        ...

    def style(self, styles: Styles, insert_style: Style | None) -> Style:
        """Return the style of the entity.

        ``insert_style`` is the style of the INSERT that places the entity, None in model space.
        """
        ...

    def shape(self) -> EntityShape:
        """Return the shape of the entity.

        Raises
        ------
        Undrawable
            The entity has no geometry to cut.
        Exception
            The entity is damaged; ezdxf may raise any exception.
        """
        ...

    def reference(self) -> Reference:
        """Return the block placement of an INSERT entity.

        Raises
        ------
        Undrawable
            The INSERT cannot be placed.
        """
        ...

    def repeats(self) -> tuple[str, int]:
        """Return the lower-case name of this INSERT's block, and the number of its copies."""
        ...


class Entry(NamedTuple):
    """An entity of model space or of a block, to be added to the import report.

    ``counted`` is the entity as ``prescan`` counted it in the bytes of the file, and ``handle`` is
    its handle in the import report.  ``source`` is the entity as the fast reader or ezdxf read it;
    None if ezdxf skipped it.
    """

    counted: PrescannedEntity
    handle: str
    source: SourceEntity | None


@dataclass(eq=False)
class Block:
    """A block definition with its entities.

    The list ``entries`` is created when the block is expanded for the first time.
    """

    name: str
    base: F64  #: (2,) base point
    external: bool
    size: int  #: number of entities
    references: list[
        tuple[str, int]
    ]  #: blocks that it places, by name in lower case, and how often
    make: Callable[[], list[Entry]]

    @cached_property
    def entries(self) -> list[Entry]:
        return self.make()


def no_geometry_reason(kind: str) -> Message:
    """Return the reason for dropping an entity of kind ``kind``, which has no geometry to cut."""
    return REASONS.get(kind) or Message("import.not-a-line", kind=kind)


def paper_space_reason(kind: str) -> Message:
    """Return the reason for dropping an entity of kind ``kind`` in paper space."""
    return _ANNOTATION_IN_PAPER_SPACE if kind in NEVER_CUT else _IN_PAPER_SPACE


def insert_note(name: str) -> Message:
    """Return the note in the import report for an INSERT that places the block named ``name``."""
    return Message("import.places-block", block=name)


def unused_block_reason(name: str, number: int) -> Message:
    """Return the reason for dropping a block that no INSERT places.

    ``name`` is the name of the block, and ``number`` the number of its entities.
    """
    code = "import.picture-block" if name.startswith("*") else "import.unused-block"
    return Message(code, block=name, entities=number)


class BlockExpansion:
    """Expands the blocks of one file, and collects rows of the import report and placed shapes.

    Parameters
    ----------
    blocks
        Block definitions by their names in lower case.
    on_sheet
        For each INSERT in model space: name in lower case of the block that it places, and how
        many times it places the block.
    styles
        Finds the style of each entity.
    limits
        Limits of the size of the drawing and of the reading time.
    scale
        Millimetres per file unit, 0 while the unit is unknown.

    Raises
    ------
    DrawingTooLarge
        INSERTs are nested deeper, or expand to more entities, than the limits allow.
    """

    def __init__(
        self,
        blocks: dict[str, Block],
        on_sheet: Iterable[tuple[str, int]],
        styles: Styles,
        limits: Limits,
        scale: float,
    ) -> None:
        self.sheet = ReportWriter()
        self.placed: list[PlacedShape] = []
        self.used: set[str] = set()
        self._blocks = blocks
        self._styles = styles
        self._limits = limits
        self._scale = scale or 1.0
        self._until = time.monotonic() + limits.seconds
        self._recursive = self._count(on_sheet)

    def _count(self, references: Iterable[tuple[str, int]]) -> frozenset[str]:
        """Count the entities that all INSERTs place, and return the names of recursive blocks.

        No block is expanded for this.  A recursive block contains itself, directly or through other
        blocks; it is not counted.

        ``references``: for each INSERT in model space: name in lower case of the block that it
        places, and how many times it places the block.
        Raises ``DrawingTooLarge``: the depth of INSERTs or the number of entities exceeds a limit.
        """
        block_references = {name: block.references for name, block in self._blocks.items()}
        children = {
            name: {child for child, _ in references_of_block if child in block_references}
            for name, references_of_block in block_references.items()
        }
        parents: dict[str, set[str]] = {name: set() for name in children}
        for name, child_names in children.items():
            for child in child_names:
                parents[child].add(name)
        # Blocks that place no other block are removed repeatedly, and then blocks that no other
        # block places.  The blocks that remain are in cycles, or between two cycles.
        _, rest = _topological_order(children, parents)
        _, cyclic = _topological_order(
            {name: parents[name] & rest for name in rest},
            {name: children[name] & rest for name in rest},
        )
        recursive = frozenset(cyclic)
        straight = {name: children[name] - recursive for name in children if name not in recursive}
        straight_parents: dict[str, set[str]] = {name: set() for name in straight}
        for name, child_names in straight.items():
            for child in child_names:
                straight_parents[child].add(name)
        order, _ = _topological_order(straight, straight_parents)
        size: dict[str, int] = {}
        depth: dict[str, int] = {}
        for name in order:
            size[name] = self._blocks[name].size + sum(
                times * max(size[child], 1)
                for child, times in block_references[name]
                if child in straight
            )
            depth[name] = 1 + max((depth[child] for child in straight[name]), default=0)
        on_sheet = [(child, n) for child, n in references if child in straight]
        deepest = max((depth[child] for child, _ in on_sheet), default=0)
        if deepest > self._limits.insert_depth:
            raise DrawingTooLarge(
                "dxf.blocks-too-deep", depth=deepest, limit=self._limits.insert_depth
            )
        total = sum(times * max(size[child], 1) for child, times in on_sheet)
        if total > self._limits.expanded:
            # Very long numbers are shortened in the message.
            shown_total = f"{total:,}" if total < 10**15 else f"more than {10**15:,}"
            raise DrawingTooLarge(
                "dxf.blocks-expand-too-far", count=shown_total, limit=self._limits.expanded
            )
        return recursive

    def sheet_entity(self, entry: Entry) -> None:
        """Add ``entry``, an entity of model space, to the import report and to the placed shapes.

        If the entity is an INSERT, the entities of its block are also added, after the INSERT.
        """
        self._entry(entry, "", (ON_SHEET, np.zeros((1, 2))), None)

    def _entry(
        self, entry: Entry, path: str, placements: tuple[F64, F64], insert_style: Style | None
    ) -> None:
        if time.monotonic() > self._until:
            raise DrawingTooLarge(
                "reading.too-slow", seconds=self._limits.seconds, format="drawing"
            )
        counted, source = entry.counted, entry.source
        if insert_style is not None and counted.layer == "0":
            counted = replace(counted, layer=insert_style.layer)
        handle = path + entry.handle
        if counted.in_paper_space:
            in_layout = paper_space_reason(counted.kind)
            self.sheet.row(handle, counted.kind, counted.layer, in_layout)
            return
        if counted.kind not in READ and counted.kind != "INSERT":
            self._add_dropped(counted, handle, placements, no_geometry_reason(counted.kind))
            return
        if source is None:
            self._add_dropped(counted, handle, placements, Message("import.damaged-or-frame"))
            return
        try:
            style = source.style(self._styles, insert_style)
            if reason := self._hidden_reason(source, counted.kind, style.layer):
                self._add_dropped(counted, handle, placements, reason)
                if counted.kind == "INSERT":
                    self._mark_used(source.repeats()[0])
                return
            if counted.kind == "INSERT":
                self._insert(source.reference(), handle, placements, style)
                return
            drawn = source.shape()
        except (Undrawable, GeometryError) as error:
            self._add_dropped(counted, handle, placements, error.message)
            return
        except (ArithmeticError, ValueError, TypeError, LookupError, AttributeError) as error:
            # Damaged entities raise any of these in ezdxf.
            self._add_dropped(counted, handle, placements, Message("import.damaged", reason=error))
            return
        notes = list(drawn.notes)
        if len(placements[0]) > 1:
            notes.append(Message("import.repeated", times=len(placements[0])))
        row = self.sheet.row(handle, counted.kind, style.layer, None, notes)
        if drawn.line_width > 0.0:
            width = drawn.line_width * self._scale * _enlargement(placements[0])
            style = style._replace(line_width=int(hundredths(np.array([width]))[0]))
        self.placed.append(PlacedShape(row, drawn.shape, *placements, style))

    def _hidden_reason(self, source: SourceEntity, kind: str, layer: str) -> Message | None:
        """Return the reason for leaving out an entity that is hidden, None if it is visible.

        ``kind`` is the kind of the entity.  ``layer`` is the name of its layer, which for an entity
        on layer 0 of a block is the layer of the INSERT.
        """
        if source.hidden:
            return INVISIBLE
        return self._styles.hidden_insert(layer) if kind == "INSERT" else self._styles.hidden(layer)

    def _mark_used(self, name: str) -> None:
        """Mark a block that a hidden INSERT places, and all blocks that it contains, as used.

        ``name`` is the name of the block in lower case.
        """
        names = [name]
        while names:
            block = self._blocks.get(name := names.pop())
            if block is not None and name not in self.used:
                self.used.add(name)
                names.extend(child for child, _ in block.references)

    def _add_dropped(
        self, counted: PrescannedEntity, handle: str, placements: tuple[F64, F64], reason: Message
    ) -> None:
        """Add a row to the import report for an entity that is dropped, with its bounding box.

        ``counted``, ``handle``: the entity as written in the file, and its handle in the import
        report.
        ``placements``: linear maps (k, 2, 2) and translations (k, 2) of the k placements of the
        entity.
        """
        row = self.sheet.row(handle, counted.kind, counted.layer, reason)
        if counted.box is not None:
            box = counted.box
            self.sheet.set_location(
                row, box if placements[0] is ON_SHEET else transformed_box(box, *placements)
            )

    def _insert(
        self, insert: Reference, handle: str, placements: tuple[F64, F64], style: Style
    ) -> None:
        name = insert.block
        block = self._blocks.get(name.lower())
        if block is None:
            raise Undrawable(Message("import.block-missing", block=name))
        if name.lower() in self._recursive:
            raise Undrawable(Message("import.block-in-itself", block=name))
        if block.external:
            raise Undrawable(Message("import.block-external", block=name))
        notes = height_notes((insert.position[2],))
        position, scale = np.array(insert.position[:2]), np.array(insert.scale)
        spacing = np.array(insert.spacing)
        numbers = np.concatenate([scale, [insert.rotation], spacing, position, block.base])
        if not np.isfinite(numbers).all() or np.abs(numbers).max() > 1e100:
            raise Undrawable(Message("import.placement-not-a-number"))
        if (scale == 0.0).any():
            raise Undrawable(Message("import.no-scale", x=scale[0], y=scale[1]))
        if insert.clipped:
            notes.append(Message("import.not-clipped"))
        self.used.add(name.lower())
        columns, rows = insert.cells
        cells = columns * rows
        if cells > 1:
            notes.append(Message("import.array", columns=columns, rows=rows))
        if len(placements[0]) > 1:
            notes.append(Message("import.repeated", times=len(placements[0])))
        self.sheet.row(
            handle,
            "INSERT",
            style.layer,
            None,
            [insert_note(block.name), *notes],
        )
        cos, sin = cos_sin(insert.rotation)
        turned = np.array([[cos, -sin], [sin, cos]])
        side = np.diag([-1.0 if insert.mirror else 1.0, 1.0])
        linear = side @ turned * scale
        steps = np.stack(
            [np.tile(np.arange(columns), rows), np.repeat(np.arange(rows), columns)], axis=1
        )
        corner = map_points(turned, position, steps * spacing) @ side.T
        shift = corner - map_points(linear, np.zeros(2), block.base)
        outer_linear, outer_shift = placements
        inner_placements = (
            np.repeat(_product(outer_linear, linear), cells, axis=0),
            map_points(outer_linear[:, None], outer_shift[:, None], shift[None]).reshape(-1, 2),
        )
        for child in block.entries:
            self._entry(child, f"{handle}/", inner_placements, style)


def _enlargement(linear: F64) -> float:
    """Return the factor by which the first of k linear maps, (k, 2, 2), enlarges a line width."""
    (a, b), (c, d) = linear[0].tolist()
    return math.sqrt(abs(a * d - b * c))


def _product(outer: F64, inner: F64) -> F64:
    """Return k linear maps; map i applies first the map ``inner`` and then the map ``outer[i]``.

    The maps are matrices: ``outer`` and the returned array have the shape (k, 2, 2), ``inner`` has
    the shape (2, 2).
    """
    columns = map_points(outer[:, None], np.zeros(2), inner.T[None])
    return columns.transpose(0, 2, 1)


def _topological_order(
    children: dict[str, set[str]], parents: dict[str, set[str]]
) -> tuple[list[str], set[str]]:
    """Sort blocks so that each block follows all blocks that it places.

    Returns the sorted block names, and the names of the blocks that cannot be sorted: blocks that
    place themselves, directly or through other blocks, and blocks that place a block of this kind.

    ``children``: for each block name: names of the blocks that this block places.
    ``parents``: for each block name: names of the blocks that place this block.
    """
    waiting = {name: len(found) for name, found in children.items()}
    ready = [name for name, number in waiting.items() if number == 0]
    for name in ready:
        for upper in parents[name]:
            waiting[upper] -= 1
            if waiting[upper] == 0:
                ready.append(upper)
    return ready, set(waiting) - set(ready)
