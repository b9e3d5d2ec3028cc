"""style_numbers: number the styles that the segments of a scanned file have.

The segments of a block have other styles for each style of its INSERTs, because entities may have
attributes BYBLOCK.
"""

from __future__ import annotations

import numpy as np

from knifetip.drawing_builder.columns import Style
from knifetip.dxf.fast_reader import fields as f
from knifetip.dxf.fast_reader.columns import HIDDEN_STYLE, style_keys
from knifetip.dxf.fast_reader.import_report_writer import Variant, drop_reason
from knifetip.dxf.fast_reader.scan import Scan
from knifetip.dxf.fast_reader.tables import Tables
from knifetip.geometry.columns import I32, I64
from knifetip.geometry.unique_rows import unique_rows
from knifetip.messages import Message

#: Columns of an entity's style.
_STYLE = [f.LAYER, f.LINETYPE, f.COLOUR, f.TRUE_COLOUR, f.LINE_WIDTH]


class StyleNumbering:
    """The styles of one scanned file in the order in which they are first used.

    Parameters
    ----------
    count : (e,)
        Number of segments of each entity of the file.
    """

    def __init__(self, scanned: Scan, tables: Tables, count: I64) -> None:
        self._scan = scanned
        self._tables = tables
        self._count = count
        self._numbers: dict[Style, int] = {}
        self._variant_styles: list[I32] = []

    def all(self) -> list[Style]:
        """Return the styles, each at the index that is its number."""
        return list(self._numbers)

    def number_of(self, style: Style) -> int:
        """Return the number of a style; a style without a number gets the next one."""
        return self._numbers.setdefault(style, len(self._numbers))

    def of_blocks(self) -> I32:
        """Return the style numbers of the segments of all variants of blocks.

        The number is ``HIDDEN_STYLE`` for the segments of entities that are left out.
        """
        return np.concatenate([np.zeros(0, np.int32), *self._variant_styles])

    def of_entities(self, rows: I64) -> I32:
        """Return the style index of each of the e entities of the file, (e,).

        The index is -1 for an entity that has no segments or is not in ``rows``, the rows in
        ``Scan.entity`` of the entities of model space.
        """
        with_segments, key, line_width = style_keys(self._scan.entity, rows, self._count)
        many = bool((line_width[1:] != line_width[:1]).any())
        first, kind = unique_rows(key, line_width) if many else unique_rows(key)
        numbers = [self.number_of(self._tables.style(row)) for row in with_segments[first].tolist()]
        styles = np.full(len(self._scan.entity), -1, np.int32)
        styles[with_segments] = np.array(numbers, np.int32)[kind]
        return styles

    def of_variants(self, rows: I64, block: I64) -> tuple[I64, list[Variant]]:
        """Return for each of k INSERTs the index of its variant, (k,), and the list of variants.

        A variant is a block with the style of its INSERT.  ``rows``, (k,), are the rows of the
        INSERTs in ``Scan.entity``, and ``block``, (k,), the rows of their blocks in ``Scan.block``.
        """
        first, kind = unique_rows(*(self._scan.entity[rows, column] for column in _STYLE), block)
        return kind, [
            self._variant(int(block[one]), self._tables.style(int(rows[one]))) for one in first
        ]

    def _variant(self, block: int, insert_style: Style) -> Variant:
        low, size = self._tables.span.get(block, (0, 0))
        layers: list[str] = []
        dropped: dict[int, Message] = {}
        styles = np.full(size, HIDDEN_STYLE, np.int32)
        for number, row in enumerate(range(low, low + size)):
            style = self._tables.style(row, insert_style)
            layers.append(style.layer)
            if reason := drop_reason(self._tables, row, style.layer):
                dropped[number] = reason
            else:
                styles[number] = self.number_of(style)
        segments = np.repeat(styles, self._count[low : low + size])
        variant = Variant(
            layers,
            dropped,
            sum(map(len, self._variant_styles)),
            int(np.count_nonzero(segments != HIDDEN_STYLE)),
        )
        self._variant_styles.append(segments)
        return variant
