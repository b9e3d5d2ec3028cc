"""reader: read a DXF file that uses only supported features.

The drawing equals the drawing that the ezdxf reader returns, bit by bit, and is read in about a
hundredth of the time.  Compiled kernels process most entities together, in arrays: entities in
model space, and blocks that INSERTs move, rotate and scale equally in x and y.  The other entities
are expanded one by one by ``BlockExpansion``: curves that must be approximated, blocks that are
nested, repeated or unequally scaled, and entities that the scan does not support, which are read
with ezdxf.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from knifetip.drawing_builder.assemble import assemble
from knifetip.drawing_builder.columns import Columns, Style
from knifetip.drawing_builder.report import ReportRows, ReportWriter
from knifetip.dxf.annotations import WORDS
from knifetip.dxf.ezdxf_reader.block_expansion import BlockExpansion, unused_block_reason
from knifetip.dxf.ezdxf_reader.place import columns, refuse_beyond, renumber_styles
from knifetip.dxf.fast_reader import fields as f
from knifetip.dxf.fast_reader.columns import (
    EntitySegments,
    PlacedBlocks,
    SheetRows,
    SheetSegments,
    inserts,
    is_too_far,
    place,
)
from knifetip.dxf.fast_reader.import_report_writer import (
    Inserts,
    Order,
    read_annotations,
    report_rows,
)
from knifetip.dxf.fast_reader.placeable_inserts import find_placeable_inserts
from knifetip.dxf.fast_reader.polyline_widths import set_polyline_widths
from knifetip.dxf.fast_reader.scan import scan
from knifetip.dxf.fast_reader.segments import segments_of
from knifetip.dxf.fast_reader.source_entities import SourceEntities
from knifetip.dxf.fast_reader.style_numbers import StyleNumbering
from knifetip.dxf.fast_reader.tables import Tables, Unsupported
from knifetip.dxf.units import known_unit
from knifetip.formats.limits import REACH, Limits
from knifetip.geometry.columns import I32, I64, Bool
from knifetip.geometry.parallel import parallel_pair
from knifetip.model.drawing import Annotation, Drawing


class FastReading(NamedTuple):
    """Rows of the import report, segments and annotations that were read from a DXF file."""

    sheet: ReportRows
    columns: Columns  #: file units
    styles: list[Style]  #: styles to which the column ``style`` refers
    annotations: tuple[Annotation, ...]


class FastReader:
    """Reads one DXF file.

    Raises
    ------
    Unsupported
        The file uses features that only the ezdxf reader supports.
    """

    def __init__(self, data: bytes, limits: Limits) -> None:
        scanned = scan(data)
        if scanned is None or len(scanned.entity) > limits.entities:
            raise Unsupported
        self.scan = scanned
        self.limits = limits
        self.entity = scanned.entity
        self.segments, self.tables = parallel_pair(
            lambda: segments_of(scanned), lambda: Tables(scanned)
        )
        # First entity and number of entities of each block.
        spans = [self.tables.span.get(number, (0, 0)) for number in range(len(scanned.block))]
        self._low, self._size = np.array(spans, np.int64).reshape(-1, 2).T
        is_word = np.isin(
            np.arange(len(self.tables.names)),
            [number for number, word in self.tables.words.items() if word in WORDS],
        )
        self._is_annotation: Bool = is_word[self.entity[:, f.WORD]]
        self._is_unsupported: Bool = (self.entity[:, f.UNSUPPORTED] != 0) & ~self._is_annotation
        self._source = SourceEntities(
            scanned, self.tables, self.segments, self._is_unsupported, limits
        )
        self._styles = StyleNumbering(scanned, self.tables, self.segments.number)

    def read(self, scale: float) -> FastReading:
        """Return the rows of the import report and the segments of the file, in file order.

        Parameters
        ----------
        scale
            Millimetres per file unit, 0 while the unit is unknown.

        Raises
        ------
        DrawingTooLarge
            A limit is exceeded.
        Unsupported
            A coordinate of an entity that an INSERT places is too large.
        """
        rows = np.flatnonzero(self.entity[:, f.BLOCK] < 0)
        reach = REACH / (scale or 1.0)
        hidden = self._mask_of_hidden(rows)
        one_by_one = self._one_by_one(rows, hidden, reach)
        widths = set_polyline_widths(self.scan, scale)
        self._source.polyline_width = widths
        position, block, placement = find_placeable_inserts(
            self.scan, self.tables, self.segments, rows, one_by_one, widths
        )
        expansion = BlockExpansion(
            self._source.blocks(),
            self._references(rows, one_by_one, block),
            self.tables.styles,
            self.limits,
            scale,
        )
        shown = np.where(one_by_one | hidden, 0, self.segments.number[rows])
        refuse_beyond(int(shown.sum()), self.limits)

        children = np.zeros(len(rows), np.int64)
        children[position] = self._size[block]
        segments = shown.copy()
        variant, variants = self._styles.of_variants(rows[position], block)
        visible = np.array([one.segments for one in variants], np.int64)
        segments[position] = visible[variant]
        # First report row of each expanded entity.
        expanded = np.flatnonzero(one_by_one)
        begin = np.zeros(len(expanded), np.int64)
        for number, one in enumerate(expanded.tolist()):
            begin[number] = len(expansion.sheet.handle)
            expansion.sheet_entity(self._source.entry(int(rows[one])))
        children[expanded] = np.diff(begin, append=len(expansion.sheet.handle)) - 1
        refuse_beyond(int(segments.sum()), self.limits)

        report_row = np.cumsum(children + 1) - children - 1
        segments_before = np.cumsum(segments) - segments
        whole_row = np.arange(len(expansion.sheet.handle)) + np.repeat(
            report_row[expanded] - begin, children[expanded] + 1
        )
        move = np.empty((len(placement), 2, 3))
        inserts(placement, self.scan.base[block], move)
        placed = Inserts(position, block, variant, variants, move)
        texts = rows[self._is_annotation[rows]]
        styles = self._styles.of_entities(rows[shown > 0])
        sheet = SheetRows(rows, report_row, segments_before, shown)
        segments_read, words = parallel_pair(
            lambda: self._column_segments(sheet, styles, int(segments.sum()), placed),
            lambda: read_annotations(self.tables, texts),
        )
        # An arc lies within half a chord length of its chord.
        farthest = np.maximum(
            segments_read.ends.max(initial=0.0), -segments_read.ends.min(initial=0.0)
        )
        if not 3.0 * float(farthest) <= reach:
            raise Unsupported
        if len(expanded):
            segments_read = self._with_expanded(
                segments_read, expansion, segments_before[expanded], begin, whole_row, scale
            )
        self._report_unused_blocks(
            expansion.sheet, {*expansion.used, *map(self._key, np.unique(block).tolist())}
        )
        last = len(rows) + int(children.sum())
        unused_rows = np.arange(last, last + len(expansion.sheet.handle) - len(whole_row))
        order = Order(rows, report_row, shown > 0, np.concatenate([whole_row, unused_rows]))
        segments_read, used_styles = renumber_styles(segments_read, self._styles.all())
        return FastReading(
            report_rows(self.tables, order, placed, expansion.sheet),
            segments_read,
            used_styles,
            words,
        )

    def _mask_of_hidden(self, rows: I64) -> Bool:
        """Return the mask of the entities in ``rows`` that have segments and lie on hidden layers.

        ``rows`` are the rows in ``Scan.entity`` of the entities of model space.
        """
        layer = self.entity[rows, f.LAYER]
        mask: Bool = (self.tables.hidden[layer] > 0) & (self.segments.number[rows] > 0)
        return mask

    def _one_by_one(self, rows: I64, hidden: Bool, reach: float) -> Bool:
        """Return the mask of the entities in ``rows`` that ``BlockExpansion`` expands one by one.

        They are the entities that the scan does not support, except texts, dimensions and entities
        in paper space; the INSERTs on frozen layers; and the visible entities with a coordinate
        that may be too large.  Only the ends of
        the segments are examined, and an arc may extend beyond its ends: a coordinate of an end is
        therefore limited to a third of ``reach``.

        ``rows``: rows in ``Scan.entity`` of the entities that are not in a block.
        ``hidden``: mask of the entities in ``rows`` with segments that lie on hidden layers.
        ``reach``: largest permitted absolute value of a coordinate (file units).
        """
        kind, layer, paper = (self.entity[rows, column] for column in (f.KIND, f.LAYER, f.PAPER))
        one_by_one: Bool = self._is_unsupported[rows]
        one_by_one |= (kind == f.INSERT) & (self.tables.hidden_inserts[layer] > 0)
        one_by_one &= paper == 0
        far = is_too_far(self.segments.ends, self.segments.first, reach / 3.0)[rows]
        one_by_one |= far & ~hidden
        return one_by_one

    def _references(self, rows: I64, one_by_one: Bool, block: I64) -> list[tuple[str, int]]:
        """Return the lower-case names of the blocks that INSERTs place, with the numbers of copies.

        The INSERTs are those in model space.  A block may occur more than once in the list.

        ``rows``: rows in ``Scan.entity`` of the entities of model space.
        ``one_by_one``: mask of the entities in ``rows`` that ``BlockExpansion`` expands.
        ``block``: row in ``Scan.block`` of the block of each INSERT that array operations place.
        """
        numbers, times = np.unique(block, return_counts=True)
        references = list(zip(map(self._key, numbers.tolist()), times.tolist(), strict=True))
        other_inserts = rows[one_by_one]
        other_inserts = other_inserts[self.entity[other_inserts, f.KIND] == f.INSERT]
        return references + [self._source.repeats(row) for row in other_inserts.tolist()]

    def _column_segments(
        self, sheet: SheetRows, styles: I32, total: int, placed: Inserts
    ) -> Columns:
        """Return the segments of all entities that are not expanded by ``BlockExpansion``.

        Array operations compute these segments for all entities together.

        ``styles`` (e,): style index of each entity of the file; -1 if the entity is not in model
        space or has no segments.
        ``placed``: the INSERTs whose blocks are placed by array operations.
        """
        segments = Columns(
            np.empty((total, 2, 2)),
            np.empty(total),
            np.empty(total, np.int32),
            np.empty(total, np.int32),
        )
        # For each INSERT: first entity and segment of its block, and first style.
        own, low = self.segments, self._low[placed.block]
        begin = np.array([one.first for one in placed.variants], np.int64)[placed.variant]
        place(
            sheet,
            EntitySegments(own.ends, own.bulge, own.first, styles),
            PlacedBlocks(
                placed.position,
                np.column_stack([low, own.first[low], begin]),
                self._size[placed.block],
                placed.move,
                self._styles.of_blocks(),
            ),
            SheetSegments(segments.ends, segments.bulge, segments.row, segments.style),
        )
        return segments

    def _with_expanded(
        self,
        segments: Columns,
        expansion: BlockExpansion,
        segments_before: I64,
        first_row: I64,
        whole_row: I64,
        scale: float,
    ) -> Columns:
        """Return ``segments`` and the segments of the expanded entities together, in file order.

        ``segments``: segments of the entities that array operations process.
        ``expansion``: import report and shapes of the entities that were expanded one by one.
        ``segments_before``: for each expanded entity, the number of ``segments`` that precede it in
        file order.
        ``first_row``: for each expanded entity, its first row in the import report of
        ``expansion``.
        ``whole_row``: for each row of the import report of ``expansion``, its row in the import
        report of the whole file.
        ``scale``: millimetres per file unit, 0 while the unit is unknown.
        """
        expanded_segments = columns(
            expansion.sheet, expansion.placed, scale, self.limits, segments.ends
        )
        insert_at = segments_before[
            np.searchsorted(first_row, expanded_segments.row, side="right") - 1
        ]
        styles = np.array([self._styles.number_of(one.style) for one in expansion.placed], np.int32)
        return Columns(
            np.insert(segments.ends, insert_at, expanded_segments.ends, axis=0),
            np.insert(segments.bulge, insert_at, expanded_segments.bulge),
            np.insert(segments.row, insert_at, whole_row[expanded_segments.row]),
            np.insert(segments.style, insert_at, styles[expanded_segments.style]),
            np.insert(segments.fit_error, insert_at, expanded_segments.fit_error),
        )

    def _key(self, block: int) -> str:
        return self.tables.block_name(block).lower()

    def _report_unused_blocks(self, sheet: ReportWriter, used: set[str]) -> None:
        """Add a row to the import report ``sheet`` for each block that no INSERT places.

        ``used`` contains the names, in lower case, of the blocks that INSERTs place.
        """
        for key, number in self.tables.blocks.items():
            if key in used or number not in self.tables.span:
                continue
            line = self.scan.block[number].tolist()
            low, size = line[f.BLOCK_HANDLE], line[f.BLOCK_HANDLE_SIZE]
            name = self.tables.block_name(number)
            layer = self.tables.names[line[f.BLOCK_LAYER]] if line[f.BLOCK_LAYER] >= 0 else "0"
            handle = self.scan.data[low : low + size].decode("ascii", "replace").strip().upper()
            sheet.row(
                handle or name,
                "BLOCK",
                layer,
                unused_block_reason(name, self.tables.span[number][1]),
            )


def read_fast(data: bytes, unit: str, limits: Limits) -> Drawing | None:
    """Return the drawing in a DXF file; None if the file uses features that are not supported.

    ``unit`` replaces the unit of the file if it is not empty.
    """
    try:
        reader = FastReader(data, limits)
        known = known_unit(unit, data, reader.tables.variables)
        reading = reader.read(known.scale)
    except Unsupported:
        return None
    # The scan takes more memory than the drawing: free it before the drawing is assembled.
    del reader
    return assemble(reading.sheet, reading.columns, reading.styles, reading.annotations, known)
